# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What the ParaView tests share."""

import os

from paraview import servermanager, simple


def load_plugin():
    """Loads the plugin of this build on every rank and returns paraview.simple, in which its
    proxies then are functions, as in ``load_plugin().GatunReader()``."""
    simple._DisableFirstRenderCameraReset()
    simple.LoadPlugin(os.environ["GATUN_PLUGIN"], remote=False, ns=vars(simple))
    return simple


def rank_and_ranks():
    """Number of this MPI process and how many there are."""
    module = servermanager.vtkProcessModule.GetProcessModule()
    return module.GetPartitionId(), module.GetNumberOfLocalPartitions()


def load_state(path):
    """Loads a state on any number of ranks. simple.LoadState of ParaView 6.1 never ends on several ranks,
    whatever is in the state, since it reads the file through a source that the other ranks do not run."""
    parser = servermanager.vtkPVXMLParser()
    parser.SetFileName(path)
    assert parser.Parse(), path
    servermanager.ProxyManager().SMProxyManager.LoadXMLState(parser.GetRootElement())
