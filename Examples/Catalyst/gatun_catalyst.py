# script-version: 2.0
"""A script for ParaView Catalyst: writes the mesh of a simulation to a .gtn file at each time step, and its
isosurface. All processes of the simulation write together, each one what it has.

ParaView runs it within a simulation: simulation.py here does so by ParaView's Python bridge, and a simulation
in C++, C or Fortran by the Catalyst library. GATUN_PLUGIN names the plugin, if it is not loaded anyway.
"""

import os

from paraview import catalyst
from paraview import simple
from paraview.simple import *  # pylint: disable=wildcard-import,unused-wildcard-import

options = catalyst.Options()
options.ExtractsOutputDirectory = os.environ.get("GATUN_RESULTS", ".")
options.GlobalTrigger = "TimeStep"

if "GATUN_PLUGIN" in os.environ:
    LoadPlugin(os.environ["GATUN_PLUGIN"], remote=False, ns=vars(simple))

# The channel of the simulation. Blocks would be merged by simple.GatunMergeBlocks(Input=mesh).
mesh = TrivialProducer(registrationName="mesh")

files = CreateExtractor("GTN", mesh, registrationName="files")
files.Writer.FileName = "mesh_{timestep:04d}.gtn"

surface = Contour(Input=mesh, ContourBy=["POINTS", "temperature"], Isosurfaces=[0.5])
surfaces = CreateExtractor("VTP", surface, registrationName="surfaces")
surfaces.Writer.FileName = "surface_{timestep:04d}.pvtp"
surfaces.Trigger.Frequency = 2


def catalyst_execute(info):
    """Called at each time step, before the extractors."""
    if servermanager.vtkProcessModule.GetProcessModule().GetPartitionId() == 0:
        print("step %d, time %g" % (info.timestep, info.time))
