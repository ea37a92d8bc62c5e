# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""One choice makes a colored volume: Gatun Volume selects the first array that is not one of ids, with
its range, and leaves alone what a script has chosen. Panels know what a file cannot do."""

import gatunSample as sample
import gatunVolume as drawing
from gatunParaView import load_plugin, rank_and_ranks

simple = load_plugin()
rank, ranks = rank_and_ranks()

IDS = """
def gatun_add_ids(inputs, output):
    import numpy as np
    from vtkmodules.util.numpy_support import numpy_to_vtk
    grid = inputs[0].VTKObject
    output.VTKObject.ShallowCopy(grid)
    for name, data, count in (
            ("AnID", output.VTKObject.GetPointData(), grid.GetNumberOfPoints()),
            ("GlobalNodeId", output.VTKObject.GetPointData(), grid.GetNumberOfPoints()),
            ("ABlockId", output.VTKObject.GetCellData(), grid.GetNumberOfCells())):
        array = numpy_to_vtk(np.arange(count, dtype=np.int32), deep=1)
        array.SetName(name)
        data.AddArray(array)
gatun_add_ids(inputs, output)
"""
meshes = simple.ProgrammableFilter(Input=sample.make_source(), OutputDataSetType="vtkUnstructuredGrid")
meshes.Script = IDS
path = sample.temporary("coloring.gtn")
simple.SaveData(path, proxy=meshes, ChunkSize=300)
tree = sample.temporary("coloring-tree.gtn")
simple.SaveData(tree, proxy=meshes, ChunkSize=300, Hierarchy=1, WriteBoundary=1)


def open_file(name, **properties):
    reader = simple.GatunReader(FileNames=[name], **properties)
    reader.UpdatePipeline()
    return reader


def array_of(shown):
    """What it is colored by."""
    return list(shown.ColorArrayName)


def range_of(shown):
    """Of both transfer functions."""
    colors, opacities = list(shown.LookupTable.RGBPoints), list(shown.ScalarOpacityFunction.Points)
    return [colors[0], colors[-4]], [opacities[0], opacities[-4]]


# One choice, of a mesh in memory and of files with an outline and with a boundary.
view = drawing.make_view()
background = drawing.draw(view)
readers = {"memory": open_file(path, LargeMesh=-1),
           "outline": open_file(path, LargeMesh=0),
           "boundary": open_file(tree, LargeMesh=0)}
pictures = {}
for name, reader in readers.items():
    shown = simple.Show(reader, view)
    assert shown.Representation == "Surface", (name, shown.Representation)
    assert array_of(shown) == ["POINTS", ""] or not array_of(shown)[1], (name, array_of(shown))
    shown.SetRepresentationType("Gatun Volume")
    # The arrays of ids are before it in the list of names.
    assert array_of(shown) == ["POINTS", "point"], (name, array_of(shown))
    have = range_of(shown)
    assert have == ([0, sample.POINTS - 1],) * 2, (name, have)
    pictures[name] = drawing.draw(view)
    drawing.require_other(pictures[name], background)
    simple.Hide(reader, view)
# The unit distance is that of the mesh, whatever stands for it. Seams of pieces add some cells to
# the mesh in memory of several ranks.
drawing.require_same(pictures["outline"], pictures["boundary"])
if ranks == 1:
    drawing.require_same(pictures["outline"], pictures["memory"])

# Solid colors after that are nobody else's business, and neither is another array.
shown = simple.Show(readers["outline"], view)
simple.ColorBy(shown, None)
assert not array_of(shown)[1], array_of(shown)
drawing.require_same(drawing.draw(view), background)
simple.ColorBy(shown, ("POINTS", "wave"))
shown.Representation = "Surface"
shown.Representation = "Gatun Volume"
assert array_of(shown) == ["POINTS", "wave"]
simple.Delete(view)

# By the property alone, and by ranges that a script has set before.
view = drawing.make_view()
simple.GetColorTransferFunction("point").RescaleTransferFunction(100, 200)
simple.GetOpacityTransferFunction("point").RescaleTransferFunction(100, 150)
shown = simple.Show(readers["outline"], view)
shown.Representation = "Gatun Volume"
assert array_of(shown) == ["POINTS", "point"]
assert range_of(shown) == ([100, 200], [100, 150]), range_of(shown)

# Ids that nobody asked for are not in the lists. The contour takes what a volume takes.
contour = simple.GatunContour(Input=readers["memory"])
assert list(contour.ContourBy) == ["POINTS", "point"], list(contour.ContourBy)
for asked in (0, 1):
    reader = open_file(path, LargeMesh=-1, GenerateGlobalIds=asked)
    there = [array.GetName() for array in reader.PointData]
    assert ("GlobalPointIds" in there) == (asked == 1 or ranks > 1), (asked, there)
    colors = simple.Show(reader, view).SMProxy.GetProperty("ColorArrayName")
    domain = colors.FindDomain("vtkSMArrayListDomain")
    listed = [domain.GetString(i) for i in range(domain.GetNumberOfStrings())]
    assert ("GlobalPointIds" in listed) == (asked == 1), (asked, listed)
    assert "GlobalNodeId" in listed and "wave" in listed, listed
    simple.Hide(reader, view)


# What can be simplified.
def number(proxy, name):
    return proxy.SMProxy.GetProperty(name).GetElement(0)


whole = open_file(tree, LargeMesh=-1)
for reader, has_hierarchy, can_simplify in (
        (readers["memory"], 0, ranks == 1), (readers["outline"], 0, 0), (readers["boundary"], 1, 1),
        (whole, 1, ranks == 1)):
    shown = simple.Show(reader, view)
    simple.Render(view)
    found = number(reader, "HasHierarchy"), number(shown, "CanSimplify")
    assert found == (has_hierarchy, int(can_simplify)), (found, has_hierarchy, can_simplify)
    assert shown.JustInTime == 1 and shown.ViewDependent == 1
    # Without a warning where there are no levels of detail.
    shown.Representation = "Gatun Volume"
    view.SMProxy.InteractiveRender()
    simple.Hide(reader, view)
