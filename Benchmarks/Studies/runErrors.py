#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Bits a value of arrays with a bounded error, beside other compressors.

Measures the components of all arrays of floating-point numbers of meshes in the folders GATUN_DATA_DIR and
GATUN_CELLS_DIR, where they exist, and of Delaunay meshes that it makes. zfp is measured if it is installed,
SZ3 if --sz3 names the folder where it is.
"""

import json
import os
import pathlib
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter

import benchmarkRunner
import errorPeers
import errorReport

# Tetrahedra of the meshes that are made, and bounds relative to the range of a component.
MODES = {
    "full": {"tets": (100000, 1000000), "bounds": (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6)},
    "quick": {"tets": (100000,), "bounds": (1e-2, 1e-3, 1e-4)},
    "smoke": {"tets": (3000,), "bounds": (1e-2, 1e-3, 1e-4)},
}
REAL = {
    "GATUN_DATA_DIR": ("post.vtu", "bluntfin_tets.vtu", "comb_tets.vtu", "kiefer_bracket_tets.vtu", "fire_ug.vtu",
                       "can.vtu"),
    "GATUN_CELLS_DIR": ("notch_disp.vtu",),
}
# Layers of a file that could be read with growing precision: a coarse bound, then a fine one.
LAYERS = ((1e-2, 1e-3), (1e-2, 1e-4))


def find_meshes(runner, mode):
    """The names and files of the meshes."""
    meshes = {}
    for variable, names in REAL.items() if mode is not MODES["smoke"] else ():
        folder = os.environ.get(variable)
        for name in names:
            file = pathlib.Path(folder) / name if folder else None
            if file and file.exists():
                meshes[file.stem] = file
    for count in mode["tets"]:
        name = f"delaunay-{count}"
        meshes[name] = runner.path(f"{name}.vtu")
        runner.case("make", "delaunay", count, meshes[name])
    return meshes


def read(file):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(file))
    reader.Update()
    return reader.GetOutput()


def attributes(grid):
    return {"point": grid.GetPointData(), "cell": grid.GetCellData()}


def list_components(grid):
    """Where each component is, its name and values. Those that are constant or repeat another one are left
    out."""
    found, seen = [], set()
    for where, data in attributes(grid).items():
        for i in range(data.GetNumberOfArrays()):
            array = data.GetArray(i)
            if array is None or array.GetDataTypeAsString() not in ("float", "double"):
                continue
            values = vtk_to_numpy(array).reshape(array.GetNumberOfTuples(), -1)
            for c in range(values.shape[1]):
                column = np.ascontiguousarray(values[:, c])
                key = column.tobytes()
                if key in seen or not np.isfinite(column).all() or column.min() == column.max():
                    continue
                seen.add(key)
                suffix = f"[{c}]" if values.shape[1] > 1 else ""
                found.append((where, array.GetName() + suffix, column))
    return found


def write_arrays(grid, components, file):
    """Writes a mesh with an array of each component only."""
    mesh = vtkUnstructuredGrid()
    mesh.CopyStructure(grid)
    for where, name, column in components:
        array = numpy_to_vtk(column, deep=True)
        array.SetName(name)
        attributes(mesh)[where].AddArray(array)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(mesh)
    writer.SetFileName(str(file))
    writer.SetDataModeToAppended()
    writer.Write()


def read_columns(file, components):
    data = attributes(read(file))
    return [vtk_to_numpy(data[where].GetArray(name)) for where, name, _ in components]


def pack(runner, source, *options):
    """The bytes of each array of a packed file, by place and name, and the file."""
    packed = runner.path("packed.gtn")
    runner.run("gtn", "pack", "-q", "-f", *options, source, packed)
    runner.run("gtn", "verify", "-q", packed, source)
    info = json.loads(runner.run("gtn", "info", "--json", packed))
    return {(one["association"], one["name"]): one["bytes"] for one in info["arrays"]}, packed


def unpack(runner, packed, components):
    """The values of the components in the order of the file."""
    unpacked = runner.path("unpacked.vtu")
    runner.run("gtn", "unpack", "-q", "-f", packed, unpacked)
    return read_columns(unpacked, components)


def peer_sizes(peers, column, ours, bound):
    """The bytes of each peer in the order of the original and in that of a .gtn file."""
    sizes = {}
    for name, peer in peers.items():
        for order, values in (("file", column), ("gtn", ours)):
            count, back = peer(values, bound)
            error = np.abs(back.astype(np.longdouble) - values).max() / bound
            sizes[f"{name}, {order}"] = {"bytes": count, "error": float(error)}
    return sizes


def measure_layers(runner, grid, components, direct):
    """The bytes of values of a coarse bound, and of what is left of them with a fine one, beside those of the
    fine bound alone."""
    source = runner.path("layer.vtu")
    results = []
    for coarse, fine in LAYERS:
        first, packed = pack(runner, runner.path("columns.vtu"), "--keep-order", "all",
                             "--error", f"*=rel:{coarse}")
        rest, bounds = [], []
        for (where, name, column), rounded in zip(components, unpack(runner, packed, components)):
            rest.append((where, name, column - rounded))
            bounds += ["--error", f"{name}=abs:{fine * float(np.ptp(column))!r}"]
        write_arrays(grid, rest, source)
        second, _ = pack(runner, source, *bounds)
        results += [{"name": name, "where": where, "coarse": coarse, "fine": fine,
                     "layers": first[where, name] + second[where, name], "direct": direct[fine][where, name]}
                    for where, name, _ in components]
    return results


def measure_mesh(runner, name, file, mode, peers):
    grid = read(file)
    components = list_components(grid)
    source = runner.path("columns.vtu")
    write_arrays(grid, components, source)
    exact, packed = pack(runner, source)
    ordered = unpack(runner, packed, components)
    rows = [{"name": title, "where": where, "values": len(column), "bits": 8 * column.itemsize,
             "exact": exact[where, title], "bounds": []} for where, title, column in components]
    direct = {}
    for relative in mode["bounds"]:
        runner.say(f"{name}, rel:{relative}")
        direct[relative], _ = pack(runner, source, "--error", f"*=rel:{relative}")
        for row, (where, title, column), ours in zip(rows, components, ordered):
            bound = relative * (float(column.max()) - float(column.min()))
            row["bounds"].append({"bound": relative, "gtn": direct[relative][where, title],
                                  "peers": peer_sizes(peers, column, ours, bound)})
    return {"name": name, "points": grid.GetNumberOfPoints(), "cells": grid.GetNumberOfCells(),
            "components": rows, "layers": measure_layers(runner, grid, components, direct)}


def measure(runner, options):
    vtkObject.GlobalWarningDisplayOff()
    mode = MODES[options.mode]
    sz3, zfp = errorPeers.load_sz3(options.sz3), errorPeers.load_zfp()
    peers = {"xz": errorPeers.rounded_xz, "zlib": errorPeers.rounded_zlib}
    notes = []
    for name, peer in (("SZ3", sz3), ("zfp", zfp)):
        if peer:
            peers[name] = peer
        else:
            notes.append(f"{name} was not there and is left out.")
    results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner), "notes": notes,
               "meshes": [measure_mesh(runner, name, file, mode, peers)
                          for name, file in find_meshes(runner, mode).items()]}
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = time.monotonic() - runner.start
    return results


def main():
    parser = benchmarkRunner.make_parser(__doc__, errorReport.PAGE)
    parser.add_argument("--sz3", type=pathlib.Path, metavar="PREFIX",
                        help="the folder where SZ3 is installed (default: SZ3 is left out)")
    benchmarkRunner.run_page(parser, errorReport.PAGE, measure, errorReport.write)


if __name__ == "__main__":
    main()
