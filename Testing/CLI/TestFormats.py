# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What VTK writes in its many formats is packed and comes back: the very mesh where the format
keeps it, and in any case what VTK reads from the file."""

import json
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkIOExodus import vtkExodusIIWriter
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridWriter
from vtkmodules.vtkIOParallel import vtkEnSightWriter
from vtkmodules.vtkIOParallelXML import vtkXMLPUnstructuredGridWriter
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataWriter, vtkXMLUnstructuredGridWriter

from gatun.vtk import vtkGatunReader
from gatunCli import corners_of, enter_folder, gtn, lattice, make_grid, standard_mesh, write

enter_folder("formats")
grid = standard_mesh(5)
write(grid, "mesh.vtu")
TETS = grid.GetNumberOfCells()


def info(name):
    return json.loads(gtn("info", "--json", name))


def round_trip(name, *originals, says=None):
    """Packs a file and compares with it, and with others that hold the same."""
    gtn("pack", name, name + ".gtn", says=says or "tetrahedra")
    for original in (name, *originals):
        gtn("verify", name + ".gtn", original, says="identical")
    return info(name + ".gtn")


# XML, in all its encodings.
for mode in ("Ascii", "Binary", "Appended"):
    for compressor in ("None", "ZLib", "LZ4", "LZMA"):
        for encoded in (True, False) if mode == "Appended" else (True,):
            name = f"{mode}-{compressor}-{encoded}.vtu"
            writer = vtkXMLUnstructuredGridWriter()
            writer.SetInputData(grid)
            writer.SetFileName(name)
            getattr(writer, "SetDataModeTo" + mode)()
            getattr(writer, "SetCompressorTypeTo" + compressor)()
            writer.SetEncodeAppendedData(encoded)
            writer.SetByteOrder(int(compressor == "LZ4"))
            writer.SetHeaderType(32 if compressor == "ZLib" else 64)
            assert writer.Write()
            # Text does not keep the last bits.
            round_trip(name, *(["mesh.vtu"] if mode != "Ascii" else []))

# Pieces: those of one mesh, each in a file.
points, tets = lattice(5)
for piece in range(3):
    write(make_grid(points, tets[piece::3], {"x": points[:, 0]}), f"piece{piece}.vtu")
writer = vtkXMLPUnstructuredGridWriter()
writer.SetInputData(grid)
writer.SetFileName("one.pvtu")
assert writer.Write()
round_trip("one.pvtu", "mesh.vtu")
with open("three.pvtu", "w") as file:
    file.write(
        '<VTKFile type="PUnstructuredGrid" version="0.1"><PUnstructuredGrid GhostLevel="0">'
        '<PPoints><PDataArray type="Float32" NumberOfComponents="3"/></PPoints>'
        '<PPointData><PDataArray type="Float32" Name="x"/></PPointData>'
    )
    file.writelines(f'<Piece Source="piece{piece}.vtu"/>' for piece in range(3))
    file.write("</PUnstructuredGrid></VTKFile>")
assert round_trip("three.pvtu")["tets"] == TETS

# Legacy.
for version in (42, 51):
    for file_type in ("ASCII", "Binary"):
        name = f"{file_type}-{version}.vtk"
        writer = vtkUnstructuredGridWriter()
        writer.SetInputData(grid)
        writer.SetFileName(name)
        writer.SetFileVersion(version)
        getattr(writer, "SetFileTypeTo" + file_type)()
        assert writer.Write()
        with open(name, "rb") as file:
            assert file.readline().startswith(b"# vtk DataFile Version %.1f" % (version / 10))
        round_trip(name, *(["mesh.vtu"] if file_type == "Binary" and version == 51 else []))

# Blocks.
blocks = vtkMultiBlockDataSet()
blocks.SetBlock(0, standard_mesh(3))
inner = vtkMultiBlockDataSet()
inner.SetBlock(0, standard_mesh(2))
inner.SetBlock(1, standard_mesh(1))
blocks.SetBlock(1, inner)
writer = vtkXMLMultiBlockDataWriter()
writer.SetInputData(blocks)
writer.SetFileName("blocks.vtm")
assert writer.Write()
assert round_trip("blocks.vtm", says="3 blocks were merged")["tets"] == 6 * (27 + 8 + 1)

# Time: a mesh in a series of files, and a reader of all of them.
TIMES = [0.5, 0.75, 4]


def at_time(step):
    values = {"p": np.sin(points[:, 0].astype(np.float64) + step)}
    return make_grid(points, tets, values, {"q": np.arange(len(tets)) * (step + 1.0)})


files = [f"step{step}.vtu" for step in range(len(TIMES))]
for step, name in enumerate(files):
    write(at_time(step), name)
gtn("pack", "-q", "--keep-order", "all", *files, "steps.gtn")

# ParaView's lists of files.
with open("run.pvd", "w") as file:
    file.write('<VTKFile type="Collection" version="0.1"><Collection>')
    file.writelines(
        f'<DataSet timestep="{time}" part="0" file="{name}"/>' for time, name in zip(TIMES, files)
    )
    file.write("</Collection></VTKFile>")
assert round_trip("run.pvd")["times"] == TIMES
gtn("verify", "run.pvd.gtn", "step0.vtu", "step1.vtu", "step2.vtu", code=1, says="at time 0.5, not 0")
for name in files:
    gtn("pack", "-q", name, name[:-4] + ".gtn")


def save_series(name, content):
    with open(name, "w") as file:
        file.write(content if isinstance(content, str) else json.dumps(content))


def series(extension):
    entries = [{"name": f"step{i}{extension}", "time": time} for i, time in enumerate(TIMES)]
    return {"file-series-version": "1.0", "files": entries}


os.makedirs("folder", exist_ok=True)
for extension in (".vtu", ".gtn"):
    save_series("run" + extension + ".series", series(extension))
    assert round_trip("run" + extension + ".series", "run.pvd")["times"] == TIMES
moved = series(".vtu")
for entry in moved["files"]:
    entry["name"] = "../" + entry["name"]
moved["files"].reverse()
save_series("folder/moved.vtu.series", moved)
assert round_trip("folder/moved.vtu.series", "run.pvd")["times"] == TIMES
for content, says in (
    ("", "is empty"),
    ("no json", "is not a .series file"),
    ("[" * 100000, "is not a .series file"),
    ("[1, 2]", "is not a .series file"),
    ({"files": 5}, "is not a .series file"),
    ({"files": []}, "lists no files"),
    ({"files": [{"time": 1}]}, "has an entry without a file"),
    ({"files": [7]}, "has an entry without a file"),
    ({"files": [{"name": "step0.vtu", "time": "now"}]}, "the entry of step0.vtu has no time"),
    ({"files": [{"name": "step0.vtu"}]}, "the entry of step0.vtu has no time"),
    ({"files": [{"name": "missing.vtu", "time": 1}]}, "missing.vtu; gtn pack --skip-missing"),
    ({"files": [{"name": "bad.vtu.series", "time": 1}]}, "cannot be part of another"),
):
    save_series("bad.vtu.series", content)
    gtn("pack", "bad.vtu.series", "new.gtn", code=1, says=says)
assert not os.path.exists("new.gtn")

# Exodus: double values only, and fields for points and cells at all steps.
reader = vtkGatunReader()
reader.SetFileName("steps.gtn")
writer = vtkExodusIIWriter()
writer.SetInputConnection(reader.GetOutputPort())
writer.SetFileName("steps.e")
writer.WriteAllTimeStepsOn()
writer.WriteOutBlockIdArrayOff()
writer.WriteOutGlobalElementIdArrayOff()
writer.WriteOutGlobalNodeIdArrayOff()
assert writer.Write()
del writer
exodus = round_trip("steps.e")
assert exodus["tets"] == TETS and len(exodus["times"]) == len(TIMES), exodus["times"]
assert {"p", "q"} <= {array["name"] for array in exodus["arrays"]}
gtn("unpack", "-f", "--step", 2, "steps.e.gtn", "back.vtu")

# EnSight Gold, which holds float.
flat = at_time(1)
block = numpy_to_vtk(np.ones(TETS, np.int32), deep=True)
block.SetName("BlockId")
flat.GetCellData().AddArray(block)
writer = vtkEnSightWriter()
writer.SetInputData(flat)
writer.SetFileName("gold")
writer.Write()
# VTK's own WriteCaseFile closes the file when the program ends.
with open("gold.case", "w") as file:
    file.write(
        "FORMAT\ntype: ensight gold\n\nGEOMETRY\nmodel: gold.0.00000.geo\n\nVARIABLE\n"
        "scalar per node: p gold.0.00000_n.p\nscalar per element: q gold.0.00000_c.q\n"
    )
ensight = round_trip("gold.case")
assert ensight["tets"] == TETS and {array["name"] for array in ensight["arrays"]} >= {"p", "q"}

# VTKHDF, where there is something to write it with.
try:
    import h5py
except ImportError:
    h5py = None
if h5py:
    with h5py.File("mesh.vtkhdf", "w") as file:
        group = file.create_group("VTKHDF")
        group.attrs["Version"] = [1, 0]
        group.attrs.create("Type", b"UnstructuredGrid", dtype=h5py.string_dtype("ascii", 16))
        corners = corners_of(grid).ravel()
        for name, values in {
            "NumberOfPoints": [grid.GetNumberOfPoints()],
            "NumberOfCells": [TETS],
            "NumberOfConnectivityIds": [len(corners)],
            "Points": vtk_to_numpy(grid.GetPoints().GetData()),
            "Connectivity": corners.astype(np.int64),
            "Offsets": np.arange(TETS + 1, dtype=np.int64) * 4,
            "Types": np.full(TETS, 10, np.uint8),
            "PointData/pressure": vtk_to_numpy(grid.GetPointData().GetArray("pressure")),
        }.items():
            group.create_dataset(name, data=values)
    hdf = round_trip("mesh.vtkhdf")
    assert hdf["tets"] == TETS and [array["name"] for array in hdf["arrays"]] == ["pressure"]
else:
    print("no h5py, so .vtkhdf is not tested")
