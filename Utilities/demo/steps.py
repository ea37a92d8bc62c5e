# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The steps of the demo. Each works on files, as a user would, and adds its picture and figures."""

import os
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersCore import vtkProbeFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOXML import (vtkXMLImageDataWriter, vtkXMLPolyDataWriter,
                                 vtkXMLUnstructuredGridReader)

import meshes
import pictures
import sheet
from gatun import vtkGatunReader

MB = 1e6
LOOK = ("--size", f"{2 * sheet.WIDTH}x{2 * sheet.HEIGHT}")


def bytes_in_memory(grid):
    """Of points, connectivity and arrays, without the offsets and types that VTK also keeps."""
    arrays = [grid.GetPoints().GetData(), grid.GetCells().GetConnectivityArray()]
    for data in (grid.GetPointData(), grid.GetCellData()):
        arrays += [data.GetArray(i) for i in range(data.GetNumberOfArrays()) if data.GetArray(i)]
    return sum(vtk_to_numpy(array).nbytes for array in arrays)


def open_file(path):
    reader = vtkGatunReader()
    reader.SetFileName(path)
    return reader


def times_of(reader):
    """The times of the steps in a reader's file; none without time."""
    reader.UpdateInformation()
    info = reader.GetOutputInformation(0)
    key = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
    return [info.Get(key, i) for i in range(info.Length(key))] if info.Has(key) else []


def steps_of(path):
    """The time steps of a file one by one, or its only one."""
    reader = open_file(path)
    for time_value in times_of(reader) or [0.0]:
        reader.UpdateTimeStep(time_value)
        yield reader.GetOutput()


class Demo:
    def __init__(self, report, original, is_part):
        self.report = report
        self.original = original
        self.is_part = is_part
        self.packed = report.path("demo.gtn")
        self.whole = None
        self.field = None
        self.cells = 0
        self.steps = 1

    # Of the array that is drawn.

    def array(self):
        return ["--array", self.field.array] if self.field.array else []

    def step(self):
        return ["--step", self.steps - 1] if self.steps > 1 else []

    def camera(self):
        """As pictures.draw looks, with z upwards."""
        path = self.report.path("camera.json")
        with open(path, "w", encoding="utf-8") as file:
            file.write('{"viewUp": [0, 0, 1]}')
        return ["--camera", path, "--azimuth", 33, "--elevation", 32]

    # The steps.

    def pack(self, chunk):
        gtn = self.report.gtn
        self.report.say("packing")
        _, packing = gtn("pack", "-f", "-q", "--chunk", chunk, self.original, self.packed)
        self.report.say("verifying")
        said, _ = gtn("verify", self.packed, self.original)
        print(said, end="", flush=True)
        reader = open_file(self.packed)
        start = time.monotonic()
        reader.UpdateTimeStep(float("inf"))
        seconds = time.monotonic() - start
        self.whole = pictures.copy_of(reader.GetOutput())
        self.cells = self.whole.GetNumberOfCells()
        if self.cells == 0:
            raise SystemExit("demo: the mesh has no cells to show")
        self.steps = max(1, len(times_of(reader)))
        self.field = pictures.Field(self.whole)
        self.report.add("Packed and read", f"written in {packing:.1f} s, compared with the original, "
                                           f"read in {seconds:.2f} s")

    def compare_sizes(self):
        """What the mesh takes in each form, all time steps together."""
        forms = [(".vtu raw", None), (".vtu zlib", "ZLib"), (".vtu LZMA", "LZMA")]
        sizes = {"in memory": 0, **{title: 0 for title, _ in forms}}
        name = self.report.path("size.vtu")
        for grid in steps_of(self.packed):
            sizes["in memory"] += bytes_in_memory(grid)
            for title, compressor in forms:
                meshes.write(grid, name, compressor)
                sizes[title] += os.path.getsize(name)
        os.remove(name)
        sizes[".gtn"] = smallest = os.path.getsize(self.packed)
        figures = (f"{sizes['.vtu zlib'] / smallest:.1f} times smaller than .vtu with zlib, "
                   f"{8 * smallest / self.cells / self.steps:.1f} bits a cell")
        if self.steps > 1:
            figures += f" and step, {self.steps} steps"
        bars = sheet.draw_bars({title: size / MB for title, size in sizes.items()}, "MB", ".gtn")
        self.report.add("Compression without loss", figures, bars)

    def show_surface(self):
        name = self.report.path("surface.png")
        vectors = "displacement [mm]" if self.is_part else None
        words = pictures.draw_surface(self.whole, self.field, name, vectors)
        self.report.add("The mesh", f"{self.cells:,} cells{words}", name)

    def show_pieces(self):
        """Reads the file a piece at a time; the pieces must make up the whole."""
        reader = open_file(self.packed)
        reader.UpdateInformation()
        count = reader.GetChunkTable().GetNumberOfRows()
        pieces = []
        before = reader.GetBytesRead()
        for index in range(count):
            reader.UpdatePiece(index, count, 0)
            pieces.append(pictures.copy_of(reader.GetOutput()))
            if index == 0:
                first = reader.GetBytesRead() - before
        cells = sum(piece.GetNumberOfCells() for piece in pieces)
        if self.steps == 1 and cells != self.cells:
            raise SystemExit(f"demo: the pieces have {cells} cells, not {self.cells}")
        name = self.report.path("pieces.png")
        pictures.draw_pieces(pieces, name)
        self.report.add("Read piece by piece", f"{count} chunks, each decoded alone; the first took "
                                               f"{first / MB:.2f} MB of the file", name)

    def render_volume(self):
        """Straight from the file, with the default transfer function and camera."""
        if not self.field.array:
            return
        name = self.report.path("volume.png")
        told, _ = self.report.gtn_json("render", "-f", "--json", *LOOK, *self.array(), *self.step(),
                                       *self.camera(), self.packed, name)
        image = told["images"][0]
        self.report.add("Volume, straight from the file",
                        f"drawn while it is decoded, in {image['seconds']:.2f} s and "
                        f"{told['peakMemory'] / MB:.0f} MB of memory", name)

    def contour(self):
        """Surfaces of equal values, straight from the file, in a shadow of the whole."""
        if not self.field.array or not self.field.of_points:
            return
        surface = self.report.path("isosurfaces.vtp")
        count = 5
        low, high = self.field.low, self.field.high
        values = [low + (high - low) * (i + 0.5) / count for i in range(count)]
        _, seconds = self.report.gtn(
            "contour", "-q", "-f", *self.array(), "--value=" + ",".join(map(str, values)),
            *self.step(), "--normals", self.packed, surface)
        name = self.report.path("isosurfaces.png")
        pictures.draw_isosurfaces(surface, self.whole, self.field, name)
        self.report.add("Isosurfaces, straight from the file",
                        f"{count} values in {seconds:.2f} s", name)

    def simplify(self):
        """A tenth of the points, by the order of edge collapses that the file stores."""
        file = self.report.path("hierarchy.gtn")
        coarse = self.report.path("coarse.vtu")
        _, building = self.report.gtn("pack", "-q", "-f", "--hierarchy", self.original, file)
        _, seconds = self.report.gtn("simplify", "-q", "-f", "--ratio", 0.9, *self.step(), file, coarse)
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(coarse)
        reader.Update()
        grid = reader.GetOutput()
        name = self.report.path("simplified.png")
        pictures.draw_cut(grid, self.field, name)
        self.report.add("Simplified, cut open",
                        f"{grid.GetNumberOfCells():,} tetrahedra, in {seconds:.2f} s by the hierarchy "
                        f"({building:.1f} s to make)", name)

    def pack_surface(self):
        """The skin as a file of its own, drawn from it."""
        skin = vtkDataSetSurfaceFilter()
        skin.SetInputData(self.whole)
        skin.Update()
        surface = skin.GetOutput()
        for data in (surface.GetPointData(), surface.GetCellData()):
            for index in reversed(range(data.GetNumberOfArrays())):
                if data.GetArrayName(index) in (None, "vtkOriginalPointIds", "vtkOriginalCellIds"):
                    data.RemoveArray(index)
        original = self.report.path("skin.vtp")
        writer = vtkXMLPolyDataWriter()
        writer.SetInputData(surface)
        writer.SetFileName(original)
        writer.SetDataModeToAppended()
        writer.EncodeAppendedDataOff()
        writer.Write()
        file = self.report.path("skin.gtn")
        self.report.gtn("pack", "-q", "-f", original, file)
        self.report.gtn("verify", "-q", file, original)
        name = self.report.path("skin.png")
        colors = ["--range", f"{self.field.low},{self.field.high}"] if self.field.array else []
        self.report.gtn(
            "render", "-q", "-f", *LOOK, *self.array(), *colors, *self.camera(), file, name)
        times = os.path.getsize(original) / os.path.getsize(file)
        self.report.add("Its surface as a file", f"{surface.GetNumberOfCells():,} cells, {times:.1f} "
                                                 "times smaller than .vtp with zlib", name)

    def bound_error(self):
        """The same mesh with values that may differ by a thousandth of their range."""
        if not self.field.array:
            return
        file = self.report.path("bounded.gtn")
        self.report.gtn("pack", "-q", "-f", "--error", "*=rel:1e-3", self.original, file)
        self.report.gtn("verify", file, self.original)
        name = self.report.path("bounded.png")
        self.report.gtn("render", "-q", "-f", *LOOK, *self.array(), *self.step(), *self.camera(), file,
                        name)
        size, exact = os.path.getsize(file), os.path.getsize(self.packed)
        self.report.add("Values with a bounded error",
                        f"0.1 % of the range at most, checked: {size / MB:.2f} MB, "
                        f"{exact / size:.1f} times smaller again", name)

    def project_scan(self):
        """A regular volume of the array, as if it came from a scanner, drawn from its coefficients."""
        if not self.field.array:
            return
        bounds = np.array(self.whole.GetBounds()).reshape(3, 2)
        size = np.maximum(bounds[:, 1] - bounds[:, 0], 1e-9 * np.ptp(bounds) + 1e-30)
        voxels = 128 if self.is_part else 96
        counts = np.maximum(4, np.round(voxels * size / size.max())).astype(int)
        grid = vtkImageData()
        grid.SetDimensions(*(int(n) for n in counts))
        grid.SetOrigin(*bounds[:, 0])
        grid.SetSpacing(*(size / (counts - 1)))
        probe = vtkProbeFilter()
        probe.SetInputData(grid)
        probe.SetSourceData(self.whole)
        probe.Update()
        values = pictures.values_of(probe.GetOutput().GetPointData().GetArray(self.field.array))
        inside = vtk_to_numpy(probe.GetOutput().GetPointData().GetArray(probe.GetValidPointMaskArrayName()))
        # Around the object there is the least value.
        scan = np.where((inside > 0) & np.isfinite(values), values, self.field.low)
        pictures.set_scalars(grid, scan.astype(np.float32), "scan")
        original = self.report.path("scan.vti")
        writer = vtkXMLImageDataWriter()
        writer.SetInputData(grid)
        writer.SetFileName(original)
        writer.Write()
        if not scan.max() > scan.min():
            return
        file = self.report.path("scan.ghv")
        self.report.gtn("volume", "pack", "-q", "-f", "--psnr", 50, original, file)
        name = self.report.path("scan.png")
        told, _ = self.report.gtn_json("volume", "render", "-f", "--json", *LOOK, *self.camera(), file, name)
        voxel_bits = 8 * os.path.getsize(file) / counts.prod()
        self.report.add("A volume by Hartley projection",
                        f"{' x '.join(map(str, counts))} voxels, {voxel_bits:.2f} bits each at 50 dB, drawn "
                        f"from coefficients in {told['images'][0]['seconds']:.2f} s", name)
