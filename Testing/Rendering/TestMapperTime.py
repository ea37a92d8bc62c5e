# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""While somebody interacts, rays are as far apart as the time allocated to a picture asks for; at
rest there is one for each pixel."""

import gatunVolumes as gv

AT_REST = 0.0001  # pictures a second

mesh = gv.wave(12)
scene = gv.Scene(mesh, (300, 300))
scene.look(0.3, 0.4, distance=2)
mapper = scene.mapper


def distance_at(rate):
    scene.window.SetDesiredUpdateRate(rate)
    picture = scene.render()
    return mapper.GetImageSampleDistance(), picture


assert distance_at(1e6)[0] == 1  # nothing is known yet
sharp = distance_at(AT_REST)[1]
distance, coarse = distance_at(1e6)
assert distance == mapper.GetMaximumImageSampleDistance() == 10
assert gv.difference(coarse, sharp) > 0.02
distance, again = distance_at(AT_REST)
assert distance == 1 and gv.difference(again, sharp) == 0

# A quarter of the time that one takes: about a quarter of the rays.
taken = mapper.GetTimeToDraw()
distance, _ = distance_at(4 / taken)
assert 1.9 < distance < 2.1, distance
assert mapper.GetImageSampleDistance() == distance

# Within its limits.
distance_at(AT_REST)
mapper.SetMaximumImageSampleDistance(3)
assert distance_at(1e6)[0] == 3
mapper.SetMinimumImageSampleDistance(2)
assert distance_at(AT_REST)[0] == 2
mapper.AutoAdjustSampleDistancesOff()
mapper.SetImageSampleDistance(1)
assert distance_at(1e6)[0] == 1
mapper.SetImageSampleDistance(0)
assert mapper.GetImageSampleDistance() == 1
mapper.SetImageSampleDistance(1000)
assert distance_at(1e6)[0] == 100  # more than there are pixels between the borders
mapper.SetImageSampleDistance(1)
assert gv.difference(distance_at(1e6)[1], sharp) == 0

# Setting the same again changes nothing, so that nothing has to be drawn.
time = mapper.GetMTime()
mapper.SetImageSampleDistance(1)
mapper.SetBlendModeToComposite()
mapper.SetNumberOfPieces(1)
assert mapper.GetMTime() == time
mapper.SetBlendModeToXRay()
assert mapper.GetMTime() > time
