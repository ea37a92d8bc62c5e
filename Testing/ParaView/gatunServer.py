# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A server of ParaView for a test of a client."""

import contextlib
import os
import socket
import subprocess
import sys

from paraview import servermanager, simple


@contextlib.contextmanager
def connected(pvserver, mpiexec, ranks):
    """While this client is connected to a new server of so many processes, with the plugin loaded in both.
    Its proxies are then functions of paraview.simple."""
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        port = probe.getsockname()[1]
    # pvpython is an MPI program by itself; the server must not take it for its parent.
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("PMIX_", "PRTE_", "ORTE_", "OMPI_", "OPAL_"))
                   or name.startswith(("OMPI_ALLOW", "OMPI_MCA_rmaps", "PRTE_MCA_rmaps"))}
    command = [mpiexec, "-np", str(ranks), pvserver, "--server-port=%d" % port]
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
            assert servermanager.ActiveConnection.GetNumberOfDataPartitions() == ranks
            yield
            simple.Disconnect()
        finally:
            server.terminate()
