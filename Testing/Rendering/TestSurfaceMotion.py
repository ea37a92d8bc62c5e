# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Surfaces of files with a hierarchy: coarser ones while somebody interacts, the whole at rest, and
a part of the points in all images, of which only the chunks that change are decoded."""

import numpy as np

import gatunMeshes as gm
import gatunPolyData as pd
from gatunSurfaceScene import Scene, ball, covered, require_equal

path = gm.temporary("motion.gtn")
surface = ball(160)
points = surface.GetNumberOfPoints()
gm.write(surface, path, ChunkSize=2000, Hierarchy=True, Levels=5)


def move(scene, budget, frames=1):
    """Images during an interaction, each after what the one before has asked for is there."""
    scene.window.SetDesiredUpdateRate(100)
    scene.mapper.GetDetailPolicy().SetTimeBudget(budget)
    for _ in range(frames):
        picture = scene.render()
        scene.mapper.WaitForPreparation()
    return picture


def rest(scene):
    scene.window.SetDesiredUpdateRate(0.001)
    return scene.render()


def far(one, other):
    return np.abs(one - other).mean()


# Off: all of it in motion, too.
whole = Scene(pd.read(path), False)
scene = Scene(pd.reader_of(path, LargeMesh=0))
for one in whole, scene:
    one.look(30, 20)
full = require_equal(scene, whole, "at rest")
assert np.array_equal(move(scene, 1e-6, 3), full) and gm.statistic(scene.mapper, "DrawnPoints") == 0

# On: as little as there is, as soon as somebody moves it, without another look at the whole.
scene.mapper.GetDetailPolicy().JustInTimeOn()
assert np.array_equal(rest(scene), full) and gm.statistic(scene.mapper, "DrawnPoints") == 0
decoded = gm.statistic(scene.mapper, "DecodedChunks")
coarse = move(scene, 1e-6)
fewest = gm.statistic(scene.mapper, "DrawnPoints")
assert 0 < fewest < points / 4, fewest
assert gm.statistic(scene.mapper, "DecodedChunks") == decoded
assert covered(coarse) > 0.9 * covered(full) and 0.01 < far(coarse, full) < 15, far(coarse, full)
assert np.array_equal(rest(scene), full) and gm.statistic(scene.mapper, "DrawnPoints") == 0

# Much time: it becomes finer from image to image, until all of it is there.
seen = []
move(scene, 1e-6, 4)
for _ in range(30):
    move(scene, 5)
    seen.append(gm.statistic(scene.mapper, "DrawnPoints"))
    if seen[-1] == 0:
        break
assert seen[-1] == 0, seen
assert np.array_equal(scene.render(), full)

# An interaction is the first thing that is drawn: the whole is never decoded.
scene = Scene(pd.reader_of(path, LargeMesh=0))
scene.mapper.GetDetailPolicy().JustInTimeOn()
scene.look(30, 20)
first = move(scene, 1e-6)
assert 0 < gm.statistic(scene.mapper, "DecodedChunks") < scene.source.GetChunkTable().GetNumberOfRows() / 4
assert covered(first) > 0.9 * covered(full) and gm.statistic(scene.mapper, "DrawnPoints") == fewest
# Translucent, zoomed, and with other colors: still something in each image.
scene.actor.GetProperty().SetOpacity(0.5)
assert covered(move(scene, 1e-6, 2)) > 0.9 * covered(full)
scene.actor.GetProperty().SetOpacity(1)
scene.mapper.ScalarVisibilityOff()
scene.look(30, 20, zoom=3)
assert covered(move(scene, 0.02, 5)) > covered(full)
assert np.array_equal(rest(scene), rest(scene))

# A little memory.
scene.mapper.SetMemoryBudget(1)
scene.look(30, 20)
assert covered(move(scene, 1e-6, 3)) > 0.9 * covered(full)
assert gm.statistic(scene.mapper, "BufferBytes") <= 1 << 20

# Fewer points in all images, as the reader would make them.
scene = Scene(pd.reader_of(path, LargeMesh=0))
scene.look(30, 20)
total = scene.source.GetChunkTable().GetNumberOfRows()
few = 1 - 3000 / points  # so few are merged one by one
for ratio in few, few + 2.0 / points, 0.3, 0.9, 0:
    before = gm.statistic(scene.mapper, "DecodedChunks")
    scene.mapper.GetDetailPolicy().SetSimplificationRatio(ratio)
    theirs = Scene(pd.read(path, SimplificationRatio=ratio), False)
    theirs.look(30, 20, bounds=surface.GetBounds())
    scene.look(30, 20, bounds=surface.GetBounds())
    require_equal(scene, theirs, ratio)
    changed = gm.statistic(scene.mapper, "DecodedChunks") - before
    if ratio == few + 2.0 / points:
        # Two more points are merged.
        assert 0 < changed <= 6 < total / 2, (changed, total)
    assert gm.statistic(scene.mapper, "DrawnPoints") == (points - int(points * ratio) if ratio else 0)

# Without base meshes, levels are made by merges.
gm.write(surface, path, ChunkSize=2000, Hierarchy=True)
scene = Scene(pd.reader_of(path, LargeMesh=0))
scene.mapper.GetDetailPolicy().JustInTimeOn()
scene.look(30, 20)
coarse = move(scene, 1e-6)
assert 0 < gm.statistic(scene.mapper, "DrawnPoints") < points / 4
assert covered(coarse) > 0.9 * covered(full)
assert np.array_equal(rest(scene), full)

# Without a hierarchy, nothing is simplified, and a ratio is an error.
gm.write(surface, path, ChunkSize=2000)
scene = Scene(pd.reader_of(path, LargeMesh=0))
scene.mapper.GetDetailPolicy().JustInTimeOn()
scene.look(30, 20)
assert np.array_equal(move(scene, 1e-6), full) and gm.statistic(scene.mapper, "DrawnPoints") == 0
errors = gm.Errors(scene.mapper)
scene.mapper.GetDetailPolicy().SetSimplificationRatio(0.5)
scene.render()
assert "hierarchy" in str(errors) and scene.mapper.GetErrorCode() != 0, errors
scene.mapper.GetDetailPolicy().SetSimplificationRatio(0)
assert np.array_equal(rest(scene), full) and scene.mapper.GetErrorCode() == 0
