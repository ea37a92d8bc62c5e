# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Save Data on any number of ranks writes the same mesh: of cells dealt out at random, of cells of several
types, over time, with a rank without cells, of blocks that the ranks have parts of, and as
extracts."""

import os
import shutil

import gatunSample as sample
import numpy as np
from gatunDealt import POINTS, describe, expected, make, make_blocks
from gatunParaView import load_plugin, rank_and_ranks

simple = load_plugin()
ranks = rank_and_ranks()[1]
folder = os.path.join(os.environ["GATUN_TEST_TEMP"], os.environ["GATUN_TEST_NAME"])
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)


def save_and_open(name, proxy, **options):
    """Saves a proxy and opens the file. Nothing else is left in the folder."""
    path = os.path.join(folder, name)
    simple.SaveData(path, proxy=proxy, ChunkSize=200, **options)
    assert os.listdir(folder) == [name], os.listdir(folder)
    reader = simple.OpenDataFile(path)
    reader.UpdatePipeline()
    return reader


def empty_folder():
    for name in os.listdir(folder):
        os.remove(os.path.join(folder, name))


# Programmable filters import names such as save and split into this module.

# Cells of one type and of several, on all ranks or with one that has none.
for kind in ("tets", "hexes", "mixed"):
    for idle in (0, 1):
        reader = save_and_open("%s%d.gtn" % (kind, idle), make(kind, idle))
        found, whole = describe(reader), expected(kind)
        assert found == whole, [(found[k], whole[k]) for k in whole if found.get(k) != whole[k]][:1]
        assert sample.owned(reader) == (POINTS, len(whole)), sample.owned(reader)
        simple.Delete(reader)
        empty_folder()

# A hierarchy and layers, which need the whole mesh.
for options in ({"Hierarchy": 1}, {"LayerArray": "wave", "KeepOrder": 7}):
    reader = save_and_open("whole.gtn", make("tets", 1, True), WriteAllTimeSteps=1, **options)
    for time in (4, 0.5):
        assert describe(reader, time) == expected("tets", time), (options, time)
    simple.Delete(reader)
    empty_folder()

# Time steps, in one file.
reader = save_and_open("steps.gtn", make("mixed", 1, True), WriteAllTimeSteps=1)
assert list(reader.TimestepValues) == [0.5, 1.5, 4], list(reader.TimestepValues)
for time in (1.5, 4, 0.5):
    assert describe(reader, time) == expected("mixed", time), time
simple.Delete(reader)
empty_folder()

# Ghost cells are left out.
make_ghosts = getattr(simple, "GhostCells", None) or simple.GhostCellsGenerator  # its name before ParaView 6
ghosts = make_ghosts(Input=make("tets"))
reader = save_and_open("ghosts.gtn", ghosts)
assert describe(reader) == expected("tets")
simple.Delete(reader)
empty_folder()

# What a reader deals out, and what a filter redistributes.
simple.SaveData(os.path.join(folder, "first.gtn"), proxy=make("mixed"), ChunkSize=100)
first = simple.OpenDataFile(os.path.join(folder, "first.gtn"))
first.UpdatePipeline()
again = os.path.join(os.environ["GATUN_TEST_TEMP"], os.environ["GATUN_TEST_NAME"] + "-again.gtn")
for source in (first, simple.RedistributeDataSet(Input=first)):
    simple.SaveData(again, proxy=source)
    second = simple.OpenDataFile(again)
    found = describe(second)
    whole = expected("mixed")
    assert found == whole, [(found[k], whole[k]) for k in whole if found.get(k) != whole[k]][:1]
    simple.Delete(second)
os.remove(again)
empty_folder()

# Blocks become one mesh with the numbers and names that they have on one rank.
reader = save_and_open("blocks.gtn", simple.GatunMergeBlocks(Input=make_blocks()))
found = describe(reader)
sizes = [expected("mixed", 0, block) for block in range(3)]
assert len(found) == len(sizes[0]) + len(sizes[1]) + len(sizes[2]), len(found)
for block, cells in enumerate(sizes):
    for key, (kind, corners, _) in cells.items():
        assert found[key][:2] == (kind, corners), key
        values = found[key][2]
        assert values["BlockId"] == block, (key, values)
        assert values["only"] == 3 if block == 2 else np.isnan(values["only"]), (key, values)
names = simple.servermanager.Fetch(reader).GetFieldData().GetAbstractArray("BlockNames")
assert [names.GetValue(i) for i in range(names.GetNumberOfValues())] == \
    ["block 0", "block 1", "block 2"]
blocks = simple.GatunSplitBlocks(Input=reader)
blocks.UpdatePipeline()
assert blocks.GetDataInformation().GetNumberOfDataSets() >= 3
simple.Delete(blocks)
simple.Delete(reader)
empty_folder()

# An extractor, for scripts of Catalyst.
moving = make("tets", 1, True)
moving.UpdatePipeline()
extractor = simple.CreateExtractor("GTN", moving, registrationName="Mesh")
extractor.Writer.FileName = "mesh_{timestep:02d}.gtn"
scene = simple.GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
simple.SaveExtracts(ExtractsOutputDirectory=folder)
assert sorted(os.listdir(folder)) == ["mesh_%02d.gtn" % i for i in range(3)], os.listdir(folder)
for i, time in enumerate((0.5, 1.5, 4)):
    reader = simple.GatunReader(FileNames=[os.path.join(folder, "mesh_%02d.gtn" % i)])
    assert describe(reader) == expected("tets", time), time
    simple.Delete(reader)
shutil.rmtree(folder)
