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
