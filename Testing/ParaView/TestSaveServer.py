# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Save Data of a client: the two processes of a server write the file. The mesh is that of the client alone.
Usage: TestSaveServer.py PVSERVER MPIEXEC
"""

import os
import sys
import time

import gatunSample as sample
from gatunDealt import describe, expected, make
from gatunParaView import load_plugin
from gatunServer import connected
from paraview import simple

path = sample.temporary("server.gtn")
with connected(sys.argv[1], sys.argv[2], 2):
    simple.SaveData(path, proxy=make("mixed", 0, True), WriteAllTimeSteps=1, ChunkSize=200)
    # The file appears when it is complete.
    begin = time.monotonic()
    while not os.path.exists(path) and time.monotonic() < begin + 60:
        time.sleep(0.05)

simple.Connect()
load_plugin()
reader = simple.GatunReader(FileNames=[path])
for value in (4, 0.5):
    assert describe(reader, value) == expected("mixed", value), value
os.remove(path)
