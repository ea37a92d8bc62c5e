# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""When one rank cannot write its part in Save Data, no rank waits for it, the file that was there before
stays, and nothing else is left behind. The next one is written."""

import os
import shutil

from gatunDealt import describe, expected, make
from gatunParaView import load_plugin

simple = load_plugin()
folder = os.path.join(os.environ["GATUN_TEST_TEMP"], os.environ["GATUN_TEST_NAME"])
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)
path = os.path.join(folder, "mesh.gtn")

# The last rank may write no more than some bytes into a file.
LIMIT = """
import resource
from paraview.modules.vtkRemotingCore import vtkProcessModule
gatun_module = vtkProcessModule.GetProcessModule()
if gatun_module.GetPartitionId() == gatun_module.GetNumberOfLocalPartitions() - 1:
    resource.setrlimit(resource.RLIMIT_FSIZE, (BYTES, resource.getrlimit(resource.RLIMIT_FSIZE)[1]))
output.ShallowCopy(inputs[0].VTKObject)
"""


def limit(size):
    look = simple.ProgrammableFilter(Input=simple.Sphere())
    look.Script = LIMIT.replace("BYTES", str(size))
    look.UpdatePipeline()


simple.SaveData(path, proxy=make("mixed"))
before = open(path, "rb").read()


def refuse(proxy, **options):
    simple.SaveData(path, proxy=proxy, **options)
    assert os.listdir(folder) == ["mesh.gtn"], os.listdir(folder)
    assert open(path, "rb").read() == before


good = make("tets")
refuse(make("tets", failing="cells"))
refuse(make("tets", failing="array"))
refuse(good, LayerArray="missing")
refuse(make("tets", failing="cells"), Hierarchy=1)
limit(500)
refuse(good)
limit(-1)
simple.SaveData(path, proxy=good)
reader = simple.OpenDataFile(path)
assert describe(reader) == expected("tets")
shutil.rmtree(folder)
