# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Meshes in several files are packed file by file, within a limit of memory, or not at all."""

import json
import os
import subprocess

import numpy as np

from gatunCli import PROGRAM, enter_folder, gtn, lattice, make_grid, write

enter_folder("parts")
PARTS = 6


def values_at(points, step=0):
    return {"pressure": np.sin(points[:, 0] + step).astype(np.float32), "place": points * 2}


def write_parallel(name, files):
    pieces = "".join(f'<Piece Source="{file}"/>' for file in files)
    with open(name, "w", encoding="ascii") as file:
        file.write(f"""<VTKFile type="PUnstructuredGrid" version="1.0" byte_order="LittleEndian"
 header_type="UInt32" compressor="vtkZLibDataCompressor"><PUnstructuredGrid GhostLevel="0">
<PPointData><PDataArray type="Float32" Name="pressure"/>
<PDataArray type="Float32" Name="place" NumberOfComponents="3"/></PPointData>
<PPoints><PDataArray type="Float32" Name="Points" NumberOfComponents="3"/></PPoints>
{pieces}</PUnstructuredGrid></VTKFile>""")


# The tetrahedra of a mesh to parts at random: most points are in several of them.
points, tets = lattice(9)
owner = np.random.default_rng(1).integers(0, PARTS, len(tets))
for step in range(2):
    write(make_grid(points, tets, values_at(points, step)), f"whole{step}.vtu")
    for part in range(PARTS):
        ids, local = np.unique(tets[owner == part], return_inverse=True)
        grid = make_grid(points[ids], local.reshape(-1, 4), values_at(points[ids], step))
        write(grid, f"step{step}part{part}.vtu")
    write_parallel(f"step{step}.pvtu", [f"step{step}part{part}.vtu" for part in range(PARTS)])

gtn("pack", "--pieces", PARTS, "step0.pvtu", "parts.gtn", says=f"{len(points):,} points")
gtn("verify", "parts.gtn", "whole0.vtu", says="identical")
gtn("pack", "-q", "--memory", 2000, "step0.pvtu", "memory.gtn")
with open("parts.gtn", "rb") as one, open("memory.gtn", "rb") as other:
    assert one.read() == other.read()

# A list of such files, and one that lists the parts of each step itself.
gtn("pack", "-q", "--memory", 2000, "step0.pvtu", "step1.pvtu", "steps.gtn")
gtn("verify", "steps.gtn", "whole0.vtu", "whole1.vtu", says="identical")
for name, files in (
        ("parallel.pvd", [["step0.pvtu"], ["step1.pvtu"]]),
        ("parts.pvd", [[f"step{s}part{p}.vtu" for p in range(PARTS)] for s in range(2)])):
    with open(name, "w", encoding="ascii") as file:
        sets = "".join(f'<DataSet timestep="{s}" part="{p}" file="{f}"/>'
                       for s, step in enumerate(files) for p, f in enumerate(step))
        file.write(f'<VTKFile type="Collection"><Collection>{sets}</Collection></VTKFile>')
    gtn("pack", "-q", "-f", "--memory", 2000, name, "steps.gtn")
    gtn("verify", "steps.gtn", "whole0.vtu", "whole1.vtu", says="identical")

# A hierarchy and the boundary of the whole, which never is in memory.
gtn("pack", "-q", "--memory", 2000, "--hierarchy", "--boundary", "--weight", "pressure", "step0.pvtu", "step1.pvtu",
    "tree.gtn")
gtn("verify", "tree.gtn", "whole0.vtu", "whole1.vtu", says="identical")
about = json.loads(gtn("info", "--json", "tree.gtn"))
assert about["merges"] > 0.8 * len(points), about["merges"]
gtn("simplify", "-q", "--ratio", 0.9, "tree.gtn", "less.gtn")
assert json.loads(gtn("info", "--json", "less.gtn"))["points"] <= 0.1 * len(points) + 1

# A .gtn file knows pieces itself.
gtn("pack", "-q", "--chunk-size", 300, "whole0.vtu", "whole.gtn")
gtn("pack", "--pieces", 4, "whole.gtn", "again.gtn", says=f"{len(points):,} points")


# What cannot be done leaves nothing behind.
def refuse(*arguments, says, code=1):
    files = sorted(os.listdir("."))
    gtn("pack", *arguments, "never.gtn", code=code, says=says)
    assert sorted(os.listdir(".")) == files


refuse("--memory", 100, "step0.pvtu", says="--memory allows 100")
refuse("--memory", 400, "--hierarchy", "step0.pvtu", says="--memory allows 400")
refuse("--memory", 2000, "--hierarchy", "--weight", "other", "step0.pvtu", says="no point array 'other'")
refuse("--memory", 400, "--levels", 2, "step0.pvtu", says="--memory allows 400")
refuse("--memory", 2000, "--layers", "pressure", "step0.pvtu", says="need the whole mesh")
refuse("--memory", 2000, "--spill", "nowhere", "step0.pvtu", says="nowhere", code=2)
write_parallel("missing.pvtu", ["step0part0.vtu", "lost.vtu"])
refuse("--memory", 2000, "missing.pvtu", says="lost.vtu")
write_parallel("empty.pvtu", [])
refuse("--memory", 2000, "empty.pvtu", says="lists no files")
with open("other.pvtu", "w", encoding="ascii") as file:
    file.write("<VTKFile><Other/></VTKFile>")
refuse("--memory", 2000, "other.pvtu", says="is not a .pvtu file")
with open("uneven.pvd", "w", encoding="ascii") as file:
    file.write('<VTKFile type="Collection"><Collection><DataSet timestep="0" file="step0.pvtu"/>'
               '<DataSet timestep="1" file="whole1.vtu"/></Collection></VTKFile>')
refuse("--memory", 2000, "uneven.pvd", says="different numbers of files")


# Memory: cubes in a row, each a file. The whole mesh needs more than the limit.
def peak(*arguments):
    with subprocess.Popen([PROGRAM, "pack", "-q", "-f", *map(str, arguments)]) as run:
        _, status, usage = os.wait4(run.pid, 0)
        run.returncode = os.waitstatus_to_exitcode(status)
    assert run.returncode == 0
    return usage.ru_maxrss / 1024


N, FILES, LIMIT = 26, 24, 250
places, tets = lattice(N)
places = np.round(places * 1024) / 1024  # so that sums are exact
places[-(N + 1) ** 2:] = places[: (N + 1) ** 2] + np.array([0, 0, N], np.float32)
for part in range(FILES):
    moved = places + np.array([0, 0, part * N], np.float32)
    write(make_grid(moved, tets, values_at(moved)), f"cube{part}.vtu")
write_parallel("cubes.pvtu", [f"cube{part}.vtu" for part in range(FILES)])
whole = peak("cubes.pvtu", "cubes.gtn")
parts = peak("--memory", LIMIT, "cubes.pvtu", "cubes.gtn")
print(f"peak memory: {whole:.0f} MiB as a whole, {parts:.0f} MiB in parts")
assert whole > LIMIT > parts
assert json.loads(gtn("info", "--json", "cubes.gtn"))["points"] == (N * FILES + 1) * (N + 1) ** 2
