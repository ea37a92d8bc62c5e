# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The slider: a file is saved with a hierarchy and base meshes, opened again, and the number of its
tetrahedra follows the ratio, on one rank and on several."""

import gatunSample as sample
from gatunParaView import load_plugin, rank_and_ranks

simple = load_plugin()
rank, ranks = rank_and_ranks()
mesh = sample.make_source()
path = sample.temporary("hierarchy.gtn")
simple.SaveData(path, proxy=mesh, ChunkSize=300, Hierarchy=1, Levels=4)
reader = simple.OpenDataFile(path)
assert sample.owned(reader) == (sample.POINTS, sample.TETS)

last = sample.TETS + 1
for ratio in (0, 0.1, 0.3, 0.5, 0.75, 0.9, 0.99):
    reader.SimplificationRatio = ratio
    points, tets = sample.owned(reader)
    assert points == sample.POINTS - int(sample.POINTS * ratio + 1e-9), (ratio, points)
    assert tets < last, (ratio, tets)
    last = tets
    # A cube remains a cube, to its very corners.
    volume = sample.volume(reader)
    if ratio <= 0.9:
        assert abs(volume - sample.VOLUME) < 1e-5 * sample.VOLUME, (ratio, volume)
reader.SimplificationNumberOfPoints = 300
assert sample.owned(reader)[0] == 300
reader.SimplificationNumberOfPoints = 0
reader.SimplificationRatio = 0
assert sample.owned(reader) == (sample.POINTS, sample.TETS)
