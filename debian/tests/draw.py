"""ParaView with the plugin draws mesh.gtn."""

from paraview.simple import *

import gatun

reader = GatunReader(FileNames=["mesh.gtn"])
reader.UpdatePipeline()
cells = reader.GetDataInformation().GetNumberOfCells()
assert cells == gatun.read("mesh.gtn").GetNumberOfCells()
view = CreateView("RenderView")
view.ViewSize = [320, 240]
shown = Show(reader, view)
shown.SetRepresentationType("Gatun Volume")
ColorBy(shown, ("POINTS", "height"))
Render(view)
SaveScreenshot("drawn.png", view)
