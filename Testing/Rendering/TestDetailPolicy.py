# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""vtkGatunDetailPolicy: defaults, ranges, copies, and policies that several classes share."""

import numpy as np

import gatunMeshes as gm
import gatunVolumes as gv
from gatun.vtk import (
    vtkGatunDetailPolicy, vtkGatunRayCaster, vtkGatunSurfaceMapper, vtkGatunVolumeMapper)

RANGES = {"TimeBudget": (0, 1e6), "PixelError": (0, 1e6), "SimplificationRatio": (0, 1)}

# Defaults and ranges; nothing is modified by the same value.
policy = vtkGatunDetailPolicy()
assert not policy.GetJustInTime() and policy.GetViewDependent()
for name, (low, high) in RANGES.items():
    get, put = getattr(policy, "Get" + name), getattr(policy, "Set" + name)
    assert get() == 0, name
    for value, clamped in ((-1, low), (-np.inf, low), (1e9, high), (np.inf, high), (0.5, 0.5)):
        put(value)
        assert get() == clamped, (name, value)
    time = policy.GetMTime()
    put(0.5)
    assert policy.GetMTime() == time, name
policy.JustInTimeOn()
policy.ViewDependentOff()
policy.SetPixelError(3)

# A copy, which does not follow later.
copy = vtkGatunDetailPolicy()
copy.DeepCopy(policy)
copy.DeepCopy(None)
policy.SetTimeBudget(7)
assert copy.GetJustInTime() and not copy.GetViewDependent()
assert [copy.GetTimeBudget(), copy.GetPixelError(), copy.GetSimplificationRatio()] == [0.5, 3, 0.5]
for text in ("JustInTime: On", "TimeBudget: 0.5", "ViewDependent: Off", "PixelError: 3",
             "SimplificationRatio: 0.5"):
    assert text in str(copy), text

# Each object has one of its own, and never none.
for make in (vtkGatunVolumeMapper, vtkGatunRayCaster, vtkGatunSurfaceMapper):
    one, other = make(), make()
    own = one.GetDetailPolicy()
    assert own and own is not other.GetDetailPolicy() and own is one.GetDetailPolicy()
    one.SetDetailPolicy(copy)
    assert one.GetDetailPolicy() is copy and "PixelError: 3" in str(one)
    one.SetDetailPolicy(None)
    assert one.GetDetailPolicy() not in (None, copy, own)
    assert one.GetDetailPolicy().GetPixelError() == 0

    # Buffers of a surface would be made again if its mapper was modified.
    modifies = make is not vtkGatunSurfaceMapper
    for change in (lambda: one.SetDetailPolicy(policy), lambda: policy.SetPixelError(policy.GetPixelError() + 1)):
        time = one.GetMTime()
        change()
        assert (one.GetMTime() > time) == modifies, make
    time = one.GetMTime()
    one.SetDetailPolicy(policy)
    assert one.GetMTime() == time, make

# One policy for two images, which follow its changes.
shared = vtkGatunDetailPolicy()
mesh = gv.wave(8)
camera = dict(Camera=gv.Scene(mesh).camera, Property=gv.make_property())
casters = [gv.make_caster(mesh, DetailPolicy=shared, **camera) for _ in range(2)]
whole = [gv.picture_of(caster)[0] for caster in casters]
assert gv.difference(*whole) == 0
shared.SetSimplificationRatio(0.8)
coarse = [gv.picture_of(caster)[0] for caster in casters]
assert gv.difference(*coarse) == 0 and gv.difference(whole[0], coarse[0]) > 0.01
for caster in casters:
    assert gm.statistic(caster, "DrawnPoints") == 9 ** 3 - int(0.8 * 9 ** 3)

# A table of statistics does not change after it was given away.
before = casters[0].GetStatistics()
shared.SetSimplificationRatio(0)
gv.picture_of(casters[0])
after = casters[0].GetStatistics()
assert before.GetNumberOfRows() == after.GetNumberOfRows() == 1
assert before.GetValueByName(0, "DrawnPoints").ToDouble() == 9 ** 3 - int(0.8 * 9 ** 3)
assert after.GetValueByName(0, "DrawnPoints").ToDouble() == 0
tets = mesh.GetNumberOfCells()
assert 0 < before.GetValueByName(0, "DrawnTetrahedra").ToDouble() < tets
assert after.GetValueByName(0, "DrawnTetrahedra").ToDouble() == tets
assert after.GetValueByName(0, "DrawSeconds").ToDouble() > 0

# -1, the default, is the value of an array of one component, also below 0, and the length of others.
x = np.linspace(-1, 1, 9 ** 3)
gm.add_array(mesh.GetPointData(), x, "signed")
gm.add_array(mesh.GetPointData(), np.stack([x, 0 * x, 0 * x], 1), "vector")
prop = gv.make_property(((-1, 0.9), (1, 0)), colors=((-1, (1, 0, 0)), (1, (0, 0, 1))))
for source in mesh, gv.write(mesh, "components.gtn", 400):
    def image(**options):
        return gv.draw(source, Camera=camera["Camera"], Property=prop, **options)[0]

    signed = image(ArrayName="signed")
    assert gv.difference(image(ArrayName="signed", ArrayComponent=0), signed) == 0
    assert gv.difference(image(ArrayName="vector", ArrayComponent=0), signed) == 0
    length = image(ArrayName="vector")
    assert gv.difference(image(ArrayName="vector", ArrayComponent=-1), length) == 0
    assert gv.difference(length, signed) > 0.1
