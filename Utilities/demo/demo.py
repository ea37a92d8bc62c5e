# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Shows what Gatun does with a mesh, by files as a user would, and draws it on one sheet; see demo.sh."""

import argparse
import json
import os
import pathlib
import subprocess
import time

import numpy as np
import vtkmodules.all as vtk
from vtkmodules.util.numpy_support import vtk_to_numpy

import part
import sheet
from gatun.vtk import vtkGatunReader
from sheet import new, output_of

LOOK = f"--camera up.json --azimuth 33 --elevation 32 --size {sheet.SCALE * sheet.WIDTH}x{sheet.SCALE * sheet.HEIGHT}"
# Even steps for the eye, for color-blind ones too.
COLORS = {0.0: (0.11, 0.165, 0.34), 0.15: (0.126, 0.31, 0.49), 0.35: (0.14, 0.51, 0.545), 0.55: (0.4, 0.69, 0.475),
          0.75: (0.85, 0.79, 0.37), 0.9: (0.94, 0.56, 0.24), 1.0: (0.76, 0.2, 0.17)}


def write(writer, data, file, compressor="ZLib"):
    """As small as VTK can. Returns the number of bytes."""
    writer = new(writer, InputData=data, FileName=file, EncodeAppendedData=False)
    writer.SetDataModeToAppended()
    getattr(writer, f"SetCompressorTypeTo{compressor}")()
    writer.Write()
    return os.path.getsize(file)


def numbers_of(array):
    """Of vectors, their lengths."""
    values = vtk_to_numpy(array).astype(float)
    return np.linalg.norm(values, axis=1) if values.ndim > 1 else values


def gtn(words, *rest):
    """Runs gtn, which itself says what goes wrong. Returns what it printed, and seconds."""
    start = time.monotonic()
    command = [os.environ["GATUN_TEST_GTN"], *words.split(), *rest]
    run = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    if run.returncode:
        raise SystemExit(run.returncode)
    return run.stdout, time.monotonic() - start


def draw(command, file, *options):
    """Lets gtn draw a file. Returns what it tells, and a panel."""
    told, _ = gtn(f"{command} -f --json {LOOK}", *options, file, "image.png")
    return json.loads(told), sheet.make_picture("image.png")


class Demo:
    """Steps, each of which adds a panel."""

    def add(self, heading, figures, panel):
        print(f"{heading}: {figures}")
        self.panels.append((panel, heading, figures))

    def pack(self, original, chunk):
        """Packs and reads the mesh, or its last time step."""
        self.original, self.panels = original, []
        _, seconds = gtn(f"pack -f -q --chunk-size {chunk}", original, "demo.gtn")
        print(f"Packed in {seconds:.1f} s\n{gtn('verify demo.gtn', original)[0]}", end="")
        self.reader, self.whole = new(vtkGatunReader, FileName="demo.gtn"), vtk.vtkUnstructuredGrid()
        self.whole.ShallowCopy(output_of(self.reader))
        self.cells = self.whole.GetNumberOfCells()
        if self.cells == 0:
            raise SystemExit("demo: the mesh has no cells to show")
        steps = self.reader.GetOutputInformation(0).Length(vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS())
        if steps > 1:
            gtn(f"unpack -q -f --step {steps - 1} demo.gtn last.vtu")
            self.pack("last.vtu", chunk)

    def choose_array(self):
        """The active array or the first one that is not the same everywhere, and the range of its colors."""
        self.array, self.option, self.range, self.of_points = None, [], (0, 1), False
        points, cells = self.whole.GetPointData(), self.whole.GetCellData()
        arrays = [data.GetArray(i) for data in (points, cells) for i in range(data.GetNumberOfArrays())]
        for array in filter(None, [points.GetScalars(), *arrays]):
            low, high = np.nanpercentile(numbers_of(array), [0.5, 99.5])  # without a few extreme values
            if low < high and array.GetName() and not self.array:
                self.array, self.option = array.GetName(), ["--array", array.GetName()]
                self.of_points = bool(points.HasArray(self.array))
                self.range = 0 if 0 < low < 0.1 * high else low, high

    def actor(self, mesh, color=None):
        """The surface of a mesh, smooth where it can be, in a color or in those of the array."""
        table = new(vtk.vtkColorTransferFunction, NanColor=(0.7, 0.7, 0.7))
        table.SetVectorModeToMagnitude()
        for place, shade in COLORS.items():
            table.AddRGBPoint(np.interp(place, (0, 1), self.range), *shade)
        skin = output_of(vtk.vtkDataSetSurfaceFilter(), mesh)
        skin = output_of(new(vtk.vtkPolyDataNormals, FeatureAngle=40, Consistency=False), skin)
        mapper = new(vtk.vtkPolyDataMapper, InputData=skin, LookupTable=table, UseLookupTableScalarRange=True,
                     InterpolateScalarsBeforeMapping=True, ScalarVisibility=bool(self.array and not color),
                     ArrayName=self.array, ArrayAccessMode=vtk.VTK_GET_ARRAY_BY_NAME,
                     ScalarMode=vtk.VTK_SCALAR_MODE_USE_POINT_FIELD_DATA + (not self.of_points))
        look = new(vtk.vtkProperty, Color=color or (0.8, 0.82, 0.85), Ambient=0.26, Diffuse=0.8, Specular=0.18)
        return new(vtk.vtkActor, Mapper=mapper, Property=look)

    def compare_sizes(self):
        sizes = {"in memory": 1024 * self.whole.GetActualMemorySize()}
        for name, compressor in (".vtu raw", "None"), (".vtu zlib", "ZLib"), (".vtu LZMA", "LZMA"):
            sizes[name] = write(vtk.vtkXMLUnstructuredGridWriter, self.whole, "size.vtu", compressor)
        sizes[".gtn"] = smallest = os.path.getsize("demo.gtn")
        self.add("Compression without loss", f"{sizes['.vtu zlib'] / smallest:.1f} times smaller than .vtu with zlib, "
                 f"{8 * smallest / self.cells:.1f} bits a cell", sheet.make_bars(sizes))

    def show_mesh(self):
        shown, words = self.whole, ""
        if shown.GetPointData().HasArray(part.DISPLACEMENT):
            factor = 0.04 * shown.GetLength() / shown.GetPointData().GetArray(part.DISPLACEMENT).GetMaxNorm()
            warp, words = new(vtk.vtkWarpVector, ScaleFactor=factor), f", displacement {factor:.0f} times as large"
            warp.SetInputArrayToProcess(0, 0, 0, 0, part.DISPLACEMENT)
            shown = output_of(warp, shown)
        self.add("The mesh", f"{self.cells:,} cells{words}", sheet.make_scene([self.actor(shown)], self.array))

    def show_pieces(self):
        """The chunks, read one by one, each moved away from the middle."""
        bytes_read = lambda: self.reader.GetStatistics().GetColumnByName("BytesRead").GetValue(0)
        count, sizes, actors = self.reader.GetChunkTable().GetNumberOfRows(), [bytes_read()], []
        for index in range(count):
            self.reader.UpdatePiece(index, count, 0)
            sizes.append(bytes_read())
            piece = self.reader.GetOutput()
            # Colors that follow each other are far apart on the wheel.
            wheel = 2 * np.pi * (0.55 + index * 0.61803398875 - np.arange(3) / 3)
            actors.append(self.actor(piece, tuple(0.575 + 0.275 * np.cos(wheel))))
            actors[-1].SetPosition(0.3 * np.subtract(piece.GetCenter(), self.whole.GetCenter()))
        self.add("Read piece by piece", f"{count} chunks, each decoded alone; the first took "
                 f"{(sizes[1] - sizes[0]) / 1e6:.2f} MB of the file", sheet.make_scene(actors))

    def draw_volume(self):
        told, panel = draw("render", "demo.gtn", *self.option)
        self.add("Volume, straight from the file", "drawn while it is decoded, in "
                 f"{told['statistics']['seconds']:.2f} s and {told['peakMemory'] / 1e6:.0f} MB of memory", panel)

    def contour(self):
        """In a shadow of the whole."""
        values = [str(value) for value in np.interp([0.1, 0.3, 0.5, 0.7, 0.9], (0, 1), self.range)]
        _, seconds = gtn(f"contour -q -f --value={','.join(values)} demo.gtn isosurfaces.vtp", *self.option)
        shadow = self.actor(self.whole, (0.45, 0.5, 0.58))
        shadow.GetProperty().SetOpacity(0.12)
        surfaces = self.actor(output_of(new(vtk.vtkXMLPolyDataReader, FileName="isosurfaces.vtp")))
        self.add("Isosurfaces, straight from the file", f"{len(values)} values in {seconds:.2f} s",
                 sheet.make_scene([surfaces, shadow], self.array))

    def simplify(self):
        _, building = gtn("pack -q -f --hierarchy", self.original, "hierarchy.gtn")
        _, seconds = gtn("simplify -q -f --ratio 0.9 hierarchy.gtn coarse.vtu")
        grid = output_of(new(vtk.vtkXMLUnstructuredGridReader, FileName="coarse.vtu"))
        plane = new(vtk.vtkPlane, Origin=grid.GetCenter(), Normal=(0, 1, 0))
        half = output_of(new(vtk.vtkExtractGeometry, ImplicitFunction=plane, ExtractInside=False), grid)
        actor = self.actor(half)
        actor.GetProperty().EdgeVisibilityOn()
        actor.GetProperty().SetInterpolationToFlat()
        self.add("Simplified, cut open", f"{grid.GetNumberOfCells():,} tetrahedra, in {seconds:.2f} s by the hierarchy "
                 f"({building:.1f} s to make)", sheet.make_scene([actor], self.array, (0.35, -1, 0.42)))

    def pack_surface(self):
        skin = output_of(vtk.vtkDataSetSurfaceFilter(), self.whole)
        size = write(vtk.vtkXMLPolyDataWriter, skin, "skin.vtp")
        colors = self.option and [*self.option, "--range={},{}".format(*self.range)]
        gtn("pack -q -f skin.vtp skin.gtn")
        gtn("verify -q skin.gtn skin.vtp")
        self.add("Its surface as a file", f"{skin.GetNumberOfCells():,} cells, "
                 f"{size / os.path.getsize('skin.gtn'):.1f} times smaller than .vtp with zlib",
                 draw("render", "skin.gtn", *colors)[1])

    def bound_errors(self):
        gtn("pack -q -f --tolerance *=rel:1e-3", self.original, "bounded.gtn")
        gtn("verify -q bounded.gtn", self.original)
        size, exact = os.path.getsize("bounded.gtn"), os.path.getsize("demo.gtn")
        self.add("Values with a bounded error", f"0.1 % of the range at most, checked: {size / 1e6:.2f} MB, "
                 f"{exact / size:.1f} times smaller again", draw("render", "bounded.gtn", *self.option)[1])

    def project_scan(self):
        """A regular volume of the array, as if it came from a scanner. Around the mesh is the least value."""
        size = np.diff(np.reshape(self.whole.GetBounds(), (3, 2)))[:, 0]
        voxels = [max(4, round(128 * length / size.max())) for length in size]
        scan = output_of(new(vtk.vtkResampleToImage, SamplingDimensions=voxels), self.whole)
        values = numbers_of(scan.GetPointData().GetArray(self.array))
        values[vtk_to_numpy(scan.GetPointData().GetArray("vtkValidPointMask")) == 0] = self.range[0]
        scan.GetPointData().Initialize()
        part.set_array(scan, values, "scan")
        write(vtk.vtkXMLImageDataWriter, scan, "scan.vti")
        gtn("volume pack -q -f --psnr 50 scan.vti scan.ghv")
        told, panel = draw("volume render", "scan.ghv")
        self.add("A volume by Hartley projection", f"{' x '.join(map(str, voxels))} voxels, "
                 f"{8 * os.path.getsize('scan.ghv') / np.prod(voxels):.2f} bits each at 50 dB, drawn from coefficients "
                 f"in {told['statistics']['seconds']:.2f} s", panel)


def main():
    parser = argparse.ArgumentParser(prog="demo.sh")
    parser.add_argument("--size", choices=part.SIZES, default="full")
    parser.add_argument("--output", required=True)
    parser.add_argument("file", nargs="?", type=os.path.abspath)
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    os.chdir(options.output)
    if not options.file:
        write(vtk.vtkXMLUnstructuredGridWriter, part.make_part(options.size), "part.vtu")
    pathlib.Path("up.json").write_text('{"viewUp": [0, 0, 1]}', encoding="ascii")
    demo = Demo()
    demo.pack(options.file or "part.vtu", 4096 if options.size == "small" else 16384 if options.file else 65536)
    demo.choose_array()
    demo.compare_sizes()
    demo.show_mesh()
    demo.show_pieces()
    if demo.array:
        demo.draw_volume()
    if demo.of_points:
        demo.contour()
    demo.simplify()
    demo.pack_surface()
    if demo.array:
        demo.bound_errors()
        demo.project_scan()
    title = os.path.basename(options.file or "A machine part under load")
    sheet.write_sheet(f"{title}: {demo.cells:,} tetrahedra", demo.panels, "sheet.png")
    print(f"\nAll pictures on one sheet:\n  {os.path.abspath('sheet.png')}")


if __name__ == "__main__":
    main()
