# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Save Data of a client: the two processes of a server write the file. The mesh is that of the client alone.
Usage: TestSaveServer.py PVSERVER MPIEXEC
"""

import os
import socket
import subprocess
import sys
import time

import gatunSample as sample
from gatunDealt import describe, expected, make
from gatunParaView import load_plugin
from paraview import simple, servermanager

with socket.socket() as probe:
    probe.bind(("localhost", 0))
    port = probe.getsockname()[1]
path = sample.temporary("server.gtn")
# pvpython is an MPI program by itself; the server must not take it for its parent.
environment = {name: value for name, value in os.environ.items()
               if not name.startswith(("PMIX_", "PRTE_", "ORTE_", "OMPI_", "OPAL_"))
               or name.startswith(("OMPI_ALLOW", "OMPI_MCA_rmaps", "PRTE_MCA_rmaps"))}
command = [sys.argv[2], "-np", "2", sys.argv[1], "--server-port=%d" % port]
# It reports that it is ended by a signal, which is no error here.
with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                      env=environment) as server:
    try:
        # It says so when it waits.
        for line in server.stdout:
            if "Accepting connection" in line:
                break
        else:
            sys.exit("the server does not start")
        simple.Connect("localhost", port)
        assert servermanager.ActiveConnection.IsRemote()
        simple.LoadPlugin(os.environ["GATUN_PLUGIN"], remote=True)
        simple.LoadPlugin(os.environ["GATUN_PLUGIN"], remote=False, ns=vars(simple))
        assert servermanager.ActiveConnection.GetNumberOfDataPartitions() == 2
        simple.SaveData(path, proxy=make("mixed", 0, True), WriteAllTimeSteps=1, ChunkTets=200)
        # The file appears when it is complete.
        begin = time.monotonic()
        while not os.path.exists(path) and time.monotonic() < begin + 60:
            time.sleep(0.05)
        simple.Disconnect()
    finally:
        server.terminate()

simple.Connect()
load_plugin()
reader = simple.GatunReader(FileNames=[path])
for value in (4, 0.5):
    assert describe(reader, value) == expected("mixed", value), value
os.remove(path)
