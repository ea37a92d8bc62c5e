# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What vtkGatunRayCaster cannot draw is an error with a reason and an empty image; a good picture
afterwards is right."""

import numpy as np
from vtkmodules.vtkCommonDataModel import VTK_TRIANGLE, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkCommonCore import vtkPoints

import gatunMeshes as gm
import gatunVolumes as gv

grid = gv.box(4)
good = gv.draw(grid)


def expect_error(caster, reason):
    messages = []
    caster.RemoveAllObservers()
    for teller in (caster, caster.GetExecutive()):
        teller.AddObserver("ErrorEvent", lambda source, event: messages.append(event))
    caster.Update()
    assert messages, reason
    assert caster.GetErrorCode() != 0, reason
    assert caster.GetOutput().GetNumberOfPoints() == 0, reason


def expect_good(caster):
    np.testing.assert_allclose(gv.picture_of(caster)[0], good[0], atol=1 / 255)


# Ranges are clamped.
caster = gv.make_caster(grid)
for size, clamped in ((0, 10), (1, 10)), ((-3, 10), (1, 10)), ((10, 40000), (10, 32000)):
    caster.SetSize(size)
    assert caster.GetSize() == clamped, size
caster.SetOpacityLimit(-1)
assert caster.GetOpacityLimit() == 0
caster.SetOpacityLimit(1e9)
assert caster.GetOpacityLimit() == 1

NAN = float("nan")
for name, bad, right in (
        ("OpacityLimit", NAN, 0.001), ("TimeBudget", NAN, 0),
        ("SimplificationRatio", NAN, 0), ("Camera", None, gv.box_camera()),
        ("Property", None, gv.box_property()), ("ArrayName", "nothing", None),
        ("ArrayComponent", 5, -1), ("ArrayAssociation", 1, -1)):
    caster = gv.make_caster(grid)
    if name == "ArrayAssociation":
        caster.SetArrayName("wave")
    gv.gm.set_options(caster, **{name: bad})
    expect_error(caster, name)
    gv.gm.set_options(caster, **{name: right})
    expect_good(caster)

camera = gv.box_camera()
camera.SetPosition(camera.GetFocalPoint())
caster = gv.make_caster(grid)
caster.SetCamera(camera)
caster.Update()  # VTK moves such a focal point away; whatever is seen, nothing breaks

# Cells of an unknown type.
triangles = vtkUnstructuredGrid()
triangles.SetPoints(grid.GetPoints())
triangles.GetPointData().ShallowCopy(grid.GetPointData())
triangles.InsertNextCell(VTK_TRIANGLE, 3, [0, 1, 2])
gv.gm.set_cell_type(triangles, 0, 99)
expect_error(gv.make_caster(triangles), "type 99")

# Without scalars.
bare = vtkUnstructuredGrid()
bare.CopyStructure(grid)
expect_error(gv.make_caster(bare), "scalars")


# Nothing, or nothing that can be seen, is a picture without anything.
def expect_nothing(source):
    assert not gv.picture_of(gv.make_caster(source))[0].any()


empty = vtkUnstructuredGrid()
empty.SetPoints(vtkPoints())
gm.add_array(empty.GetPointData(), np.zeros(0, np.float32), "wave")
empty.GetPointData().SetActiveScalars("wave")
expect_nothing(empty)
for values in (np.full(125, np.nan), np.full(125, -7.0)):
    strange = gv.box(4)
    gm.add_array(strange.GetPointData(), values, "strange")
    strange.GetPointData().SetActiveScalars("strange")
    expect_nothing(strange)

# Where the input fails, or there is none any more, the image of before goes.
caster = gv.make_caster(grid)
expect_good(caster)
caster.RemoveAllInputs()
expect_error(caster, "no input")
gv.connect(caster, vtkPolyData())
expect_error(caster, "not a vtkUnstructuredGrid")
gv.connect(caster, grid)
expect_good(caster)

# A damaged file, and the same file repaired.
reader = gv.write(gv.box(8), "damaged.gtn", 500)
expected = gv.draw(gv.box(8))
path = reader.GetFileName()
with open(path, "rb") as file:
    content = file.read()
damaged = bytearray(content)
for at in range(len(content) // 3, len(content) // 3 * 2, 50):
    damaged[at] ^= 255
with open(path, "wb") as file:
    file.write(damaged)
caster = gv.make_caster(reader)
expect_error(caster, "damaged")
with open(path, "wb") as file:
    file.write(content)
caster.Modified()
np.testing.assert_allclose(gv.picture_of(caster)[0], expected[0], atol=1 / 255)

# Stopped in the middle: no picture; then a whole one.
reader.SetMemoryBudget(0)
caster = gv.make_caster(reader)
observer = caster.AddObserver("ProgressEvent", lambda source, event: caster.SetAbortExecute(1))
caster.Update()
assert caster.GetOutput().GetNumberOfPoints() == 0
caster.RemoveObserver(observer)
caster.SetAbortExecute(0)
caster.Modified()
np.testing.assert_allclose(gv.picture_of(caster)[0], expected[0], atol=1 / 255)

print("all good")
