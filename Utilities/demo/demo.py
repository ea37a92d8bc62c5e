# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Shows what Gatun does with a mesh: sizes, reading by pieces, verification, pictures.

    demo.py [--size small|full] [--output FOLDER] [FILE]

FILE is a mesh that `gtn pack` takes; without it, a machine part is made and put under load.
GATUN_GTN in the environment names the gtn program.
"""

import argparse
import json
import os
import subprocess
import time

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

import meshes
import pictures
from gatun import vtkGatunReader

START = time.monotonic()


def say(words):
    print(f"[{time.monotonic() - START:6.1f} s] {words}", flush=True)


def gtn(*arguments):
    """Runs gtn; what goes wrong it says itself."""
    run = subprocess.run([os.environ["GATUN_GTN"], *arguments], check=False)
    if run.returncode:
        raise SystemExit(run.returncode)


def bytes_in_memory(grid):
    """Of points, connectivity and arrays, without the offsets and types that VTK also keeps."""
    arrays = [grid.GetPoints().GetData(), grid.GetCells().GetConnectivityArray()]
    for data in (grid.GetPointData(), grid.GetCellData()):
        arrays += [data.GetArray(i) for i in range(data.GetNumberOfArrays()) if data.GetArray(i)]
    return sum(vtk_to_numpy(array).nbytes for array in arrays)


def times_of(reader):
    """The times of the steps in a reader's file; none without time."""
    reader.UpdateInformation()
    info = reader.GetOutputInformation(0)
    key = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
    return [info.Get(key, i) for i in range(info.Length(key))] if info.Has(key) else []


def steps_of(packed):
    """The time steps of a file one by one, or its only one."""
    reader = vtkGatunReader()
    reader.SetFileName(packed)
    for time_value in times_of(reader) or [0.0]:
        reader.UpdateTimeStep(time_value)
        yield reader.GetOutput()


def print_sizes(packed, folder):
    """A table of what the mesh takes in each form, all time steps together."""
    forms = [(".vtu raw", None), (".vtu zlib", "ZLib"), (".vtu LZMA", "LZMA")]
    sizes = {"in memory": 0, **{title: 0 for title, _ in forms}}
    steps = tets = 0
    name = os.path.join(folder, "size.vtu")
    for grid in steps_of(packed):
        steps += 1
        tets = max(grid.GetNumberOfCells(), 1)
        sizes["in memory"] += bytes_in_memory(grid)
        for title, compressor in forms:
            meshes.write(grid, name, compressor)
            sizes[title] += os.path.getsize(name)
    os.remove(name)
    sizes[".gtn"] = smallest = os.path.getsize(packed)
    print(f"\n  {'':<12} {'bytes':>14} {'bits/tet':>10} {'times .gtn':>11}")
    for title, size in sizes.items():
        print(f"  {title:<12} {size:>14,} {8 * size / tets:>10.1f} {size / smallest:>11.1f}")
    print(f"  ({steps} time steps)\n" if steps > 1 else "", flush=True)


def read_whole(packed):
    """The mesh, at the last time step if there are several."""
    reader = vtkGatunReader()
    reader.SetFileName(packed)
    start = time.monotonic()
    reader.UpdateTimeStep(float("inf"))
    grid = pictures.copy_of(reader.GetOutput())
    say(f"read {grid.GetNumberOfCells():,} tetrahedra in {time.monotonic() - start:.2f} s")
    return grid


def read_pieces(packed, whole):
    """Reads the file a piece at a time; the pieces must make up the whole."""
    reader = vtkGatunReader()
    reader.SetFileName(packed)
    reader.UpdateInformation()
    count = reader.GetChunkTable().GetNumberOfRows()
    pieces = []
    read_before = reader.GetBytesRead()
    for index in range(count):
        reader.UpdatePiece(index, count, 0)
        pieces.append(pictures.copy_of(reader.GetOutput()))
        if index == 0:
            first = reader.GetBytesRead() - read_before
    cells = sum(piece.GetNumberOfCells() for piece in pieces)
    if cells != whole.GetNumberOfCells():
        raise SystemExit(f"demo: the pieces have {cells} cells, not {whole.GetNumberOfCells()}")
    say(
        f"read {count} pieces one by one; the first one took {first:,} bytes "
        f"of the file's {os.path.getsize(packed):,}"
    )
    return pieces


def render_volume(packed, field, folder, is_part):
    """A picture of what is inside, straight from the file."""
    name = os.path.join(os.path.abspath(folder), "volume.png")
    arguments = ["-q", "-f", "--size", "840x600", "--background", "white", "--opacity", "2"]
    if field.array:
        arguments += ["--array", field.array, "--range", f"{field.low:g},{field.high:g}"]
    if is_part:
        camera = os.path.join(folder, "camera.json")
        with open(camera, "w", encoding="utf-8") as file:
            json.dump({"position": [112, -187, 123], "focalPoint": [0, 0, 27],
                       "viewUp": [0, 0, 1]}, file)
        arguments += ["--camera", camera]
    start = time.monotonic()
    gtn("render", *arguments, packed, name)
    say(f"drew its volume, decoding as it went, in {time.monotonic() - start:.1f} s")
    return name


def draw_isosurfaces(packed, field, whole, folder):
    """A picture of surfaces of equal values, straight from the file, in a shadow of the whole; at the
    last time step, as that is."""
    reader = vtkGatunReader()
    reader.SetFileName(packed)
    last = max(0, len(times_of(reader)) - 1)
    surface = os.path.join(folder, "isosurfaces.vtp")
    steps = 5
    values = [field.low + (field.high - field.low) * (i + 0.5) / steps for i in range(steps)]
    start = time.monotonic()
    gtn("contour", "-q", "-f", "--array", field.array, "--value=" + ",".join(map(str, values)),
        "--step", str(last), "--normals", packed, surface)
    say(f"made isosurfaces, decoding as it went, in {time.monotonic() - start:.1f} s")
    name = os.path.join(os.path.abspath(folder), "isosurfaces.png")
    pictures.draw_isosurfaces(surface, whole, field, f"{steps} isosurfaces, straight from the file", name)
    return name


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--size", choices=sorted(meshes.SIZES), default="full")
    parser.add_argument("--output", default="gatun-demo")
    parser.add_argument("file", nargs="?")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    packed = os.path.join(options.output, "demo.gtn")

    if options.file:
        original = options.file
    else:
        say("making the part")
        original = os.path.join(options.output, "part.vtu")
        meshes.write(meshes.make_part(options.size, say), original, "ZLib")
    # Pieces enough for a picture.
    chunk = "4096" if options.size == "small" else "16384" if options.file else "65536"
    say("packing")
    gtn("pack", "-f", "--chunk", chunk, original, packed)
    say("verifying")
    gtn("verify", packed, original)

    whole = read_whole(packed)
    if whole.GetNumberOfCells() == 0:
        raise SystemExit("demo: the mesh has no cells to show")
    print_sizes(packed, options.output)
    pieces = read_pieces(packed, whole)

    say("drawing")
    field = pictures.Field(whole)
    vectors = None if options.file else "displacement [mm]"
    tets = f"{whole.GetNumberOfCells():,} tetrahedra"
    bits = f"{8 * os.path.getsize(packed) / whole.GetNumberOfCells():.1f} bits each"
    names = {
        kind: os.path.join(os.path.abspath(options.output), f"{kind}.png")
        for kind in ("surface", "cut", "pieces")
    }
    pictures.draw_surface(whole, field, f"{tets}, {bits}", names["surface"], vectors)
    pictures.draw_cut(whole, field, f"{tets}, cut open", names["cut"])
    pictures.draw_pieces(pieces, f"{len(pieces)} pieces, each read by itself", names["pieces"])
    names["volume"] = render_volume(packed, field, options.output, not options.file)
    if field.array and field.of_points:
        names["isosurfaces"] = draw_isosurfaces(packed, field, whole, options.output)
    say("pictures:")
    for name in names.values():
        print("  " + name)


if __name__ == "__main__":
    main()
