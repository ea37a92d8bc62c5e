# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""gatun.write writes what vtkGatunWriter writes of the same data with the same options, byte for byte: all meshes of
golden files, and series that move, lose cells, change their meshes and arrays, or are added to a file."""

import os
import unittest
import unittest.mock
import warnings

import gatun
import gatunGolden  # noqa: F401  (for the folder of the next modules)
import gatunGoldenArrays
import gatunGoldenCells
import gatunGoldenSteps
import gatunGoldenTets
import numpy as np
from gatun._vtk_input import make_face_stream
from gatunCube import find, make_cube
from gatunMeshes import set_options, set_tolerance
from gatunTimeSource import TimeSource, connect
from vtkmodules.util.numpy_support import get_vtk_array_type
from vtkmodules.vtkCommonCore import (
    vtkBitArray,
    vtkDataArray,
    vtkInformationDoubleVectorKey,
    vtkInformationIntegerVectorKey,
    vtkInformationStringVectorKey,
    vtkInformationUnsignedLongKey,
    vtkObject,
    vtkPoints,
    vtkSOADataArrayTemplate,
    vtkStringArray,
)
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkDataObject,
    vtkDataSetAttributes,
    vtkMultiBlockDataSet,
    vtkPolyData,
    vtkQuadratureSchemeDefinition,
)

ALL = [f for module in (gatunGoldenTets, gatunGoldenArrays, gatunGoldenSteps, gatunGoldenCells) for f in module.ALL]
POINTS, TETS = make_cube(6)


def make_array(values, name, keys=False):
    """An array of VTK, with keys on request."""
    values = np.ascontiguousarray(values)
    array = vtkDataArray.CreateDataArray(get_vtk_array_type(values.dtype))
    array.SetNumberOfComponents(values.size // len(values))
    array.SetNumberOfTuples(len(values))
    np.frombuffer(array, values.dtype)[...] = values.ravel()
    array.SetName(name)
    if keys:
        info = array.GetInformation()
        info.Set(vtkDataArray.UNITS_LABEL(), "m/s")
        info.Set(vtkDataArray.GUI_HIDE(), -1)
        vtkInformationUnsignedLongKey.MakeKey("natural", "mine").Set(info, 2**64 - 1)
        vtkInformationDoubleVectorKey.MakeKey("doubles", "mine").Append(info, 0.1)
        vtkInformationIntegerVectorKey.MakeKey("none", "mine").Set(info, [], 0)
        texts = vtkInformationStringVectorKey.MakeKey("texts", "mine")
        texts.Append(info, "a")
        texts.Append(info, "")
        scheme = vtkQuadratureSchemeDefinition()
        scheme.Initialize(10, 4, 2, [0.25] * 4 + [0.1, 0.2, 0.3, 0.4], [0.5, 0.5])
        vtkQuadratureSchemeDefinition.DICTIONARY().Set(info, scheme, 10)
        info.Set(vtkDataObject.DATA_OBJECT(), vtkPolyData())  # which no file holds
    return array


def add_array(attributes, values, name):
    if len(values):
        attributes.AddArray(make_array(values, name))


def make_inputs(function):
    """The data of a golden file, their times or None, and options of the writer."""
    inputs, options = function(np.random.default_rng(list(function.__name__.encode())))
    options = dict(options)
    times = options.pop("times", None)
    if "ChunkSize" in options:
        options["ChunkSize"] = max(options["ChunkSize"], 64)  # as VTK does without a word
    if isinstance(inputs, list):
        return inputs, times or [float(i) for i in range(len(inputs))], options
    return [inputs], times, options


def write_reference(path, inputs, times, options):
    """Writes by the class of VTK. Returns the bytes, or None after an error."""
    options = dict(options)
    writer = gatun.vtk.vtkGatunWriter()
    if times:
        connect(writer, TimeSource(inputs.__getitem__, times, inputs[0].GetClassName()))
        writer.WriteAllTimeStepsOn()
    else:
        writer.SetInputDataObject(inputs[0])
    writer.SetFileName(path)
    writer.SetProfileToSmall()
    for error in options.pop("errors", []):
        set_tolerance(writer, error)
    set_options(writer, **options)
    vtkObject.GlobalWarningDisplayOff()
    is_written = writer.Write()
    vtkObject.GlobalWarningDisplayOn()
    if not is_written:
        return None
    with open(path, "rb") as file:
        return file.read()


def find_parameters(options):
    """Parameters of gatun.write of options of vtkGatunWriter."""
    names = {"ChunkSize": "chunk_size", "KeyStepInterval": "key_step_interval", "Levels": "levels",
             "WriteBoundary": "boundary", "FillMissingArrays": "fill_missing", "Append": "append"}
    found = {"profile": "small"}
    for name, value in options.items():
        if name == "KeepOrder":
            found["keep_order"] = [o for o, flag in (("points", 1), ("cells", 2), ("corners", 4)) if value & flag]
        elif name == "Profile":
            found["profile"] = ("small", "fast")[value]
        elif name == "Hierarchy":
            found["hierarchy"], found["dependencies"] = bool(value), value == 2
        elif name == "errors":
            found["tolerances"] = dict(error.rsplit("=", 1) for error in value)
        elif name == "PointTolerance":
            found["point_tolerance"] = f"{('', 'abs', 'rel', '', 'bits')[value[0]]}:{value[1]}"
        elif name == "Layers":
            found["layers"] = value if isinstance(value, str) else (value[0], *value[2:3])
        else:
            found[names[name]] = value
    return found


def write(path, inputs, times, options):
    """Writes by gatun.write. Returns the bytes, or the exception."""
    os.path.exists(path) and not options.get("Append") and os.remove(path)
    data = iter(inputs) if times else inputs[0]
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            gatun.write(data, path, times=times, **find_parameters(options))
    except ValueError as error:
        return error
    with open(path, "rb") as file:
        return file.read()


class WriteAsVtk(unittest.TestCase):
    def compare(self, inputs, times=None, **options):
        expected = write_reference(find("reference.gtn"), inputs, times, options)
        found = write(find("found.gtn"), inputs, times, options)
        if expected is None:
            self.assertIsInstance(found, ValueError)
            return None
        if isinstance(found, ValueError):
            raise found
        self.assertTrue(found == expected, f"{len(found)} bytes, and {len(expected)} by vtkGatunWriter")
        return found

    def test_golden_data(self):
        for function in ALL:
            for profile in (0, 1):
                with self.subTest(function.__name__, profile=profile):
                    inputs, times, options = make_inputs(function)
                    if options.get("Layers", "")[3:] not in ("", (3,)):
                        continue  # a spacing, which gatun.write has no parameter for
                    self.assertIsNotNone(self.compare(inputs, times, **{**options, "Profile": profile}))

    def test_options(self):
        written = {}
        for function in ALL:
            for more in ({"Hierarchy": True, "Levels": 2}, {"WriteBoundary": True}, {"PointTolerance": (1, 1e-3)},
                         {"PointTolerance": (4, 12)}, {"errors": ["*=rel:1e-3,zeros"]}):
                with self.subTest(function.__name__, **more):
                    inputs, times, _ = make_inputs(function)
                    name = next(iter(more))
                    written[name] = written.get(name, 0) + (self.compare(inputs, times, **more) is not None)
        self.assertGreater(min(written.values()), 20, written)

    def test_surfaces(self):
        """The four lists, with ids of 32 and 64 bits, one list alone and none."""
        lists = {"SetVerts": [[0], [1, 2]], "SetLines": [[0, 1], [2, 3, 4]], "SetPolys": [[0, 1, 2], [1, 2, 3, 4],
                 [0, 1, 2, 3, 4]], "SetStrips": [[0, 1, 2, 3]]}
        for chosen in (list(lists), ["SetPolys"], ["SetLines", "SetStrips"], []):
            for widths in ((8, 8, 8, 8), (4, 4, 4, 4), (4, 8, 4, 4)):
                surface = gatun.from_numpy(POINTS, {}, surface=True, point_data={"v": POINTS[:, 0]})
                for name, width in zip(chosen, widths):
                    cells = vtkCellArray()
                    cells.Use64BitStorage() if width == 8 else cells.Use32BitStorage()
                    for ids in lists[name]:
                        cells.InsertNextCell(len(ids), ids)
                    getattr(surface, name)(cells)
                count = surface.GetNumberOfCells()
                add_array(surface.GetCellData(), np.arange(count), "id")
                with self.subTest(chosen, widths=widths):
                    self.assertIsNotNone(self.compare([surface], KeepOrder=7))

    def test_kinds_of_arrays(self):
        """Arrays of bits, of separate components, without a name, with one name, with keys; texts; integer points."""
        mesh = gatun.from_numpy(POINTS, TETS)
        data = mesh.GetPointData()
        bits = vtkBitArray()
        separate = vtkSOADataArrayTemplate["int64"]()
        separate.SetNumberOfComponents(2)
        separate.SetNumberOfTuples(len(POINTS))
        for i in range(len(POINTS)):
            bits.InsertNextValue(i % 3 == 0)
            separate.SetTypedTuple(i, (2**62 + i, -i))  # which are no doubles
        bits.SetName("bits")
        separate.SetName("separate")
        separate.SetComponentName(1, "second")
        named = make_array(POINTS[:, 1], "twice", keys=True)
        for array in (bits, separate, make_array(POINTS[:, 0], None), make_array(POINTS, "twice"), named):
            name, _ = array.GetName(), array.SetName(None)  # so that none replaces another one
            data.AddArray(array)
            array.SetName(name)
        data.SetActiveAttribute(3, vtkDataSetAttributes.VECTORS)
        texts = vtkStringArray()
        texts.SetName("texts")
        for text in ("a", "", b"\xff", "with \0 zero"):
            texts.InsertNextValue(text)
        mesh.GetFieldData().AddArray(texts)
        mesh.GetFieldData().AddArray(make_array(np.arange(6, dtype=np.int16).reshape(2, 3), "numbers", keys=True))
        mesh.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), 2.5)
        self.assertIsNotNone(self.compare([mesh], KeepOrder=7))
        self.assertEqual(gatun.steps(find("found.gtn")), [2.5])
        places = vtkPoints()
        places.SetData(make_array((POINTS * 10).astype(np.int32), "Places"))
        mesh.SetPoints(places)
        self.assertIsNotNone(self.compare([mesh], PointTolerance=(1, 0.1)))
        places.SetData(make_array((POINTS * 2**60).astype(np.int64), "Places"))
        self.assertIsNone(self.compare([mesh]))

    def test_arrays_that_come_and_go(self):
        v, w = POINTS[:, 0], POINTS[:, 1]
        make = lambda **arrays: gatun.from_numpy(POINTS, TETS, point_data=arrays)  # noqa: E731
        times = [0.0, 1.0, 2.0, 4.0]
        series = [make(v=v), make(v=v, w=w), make(w=w, v=v, i=np.arange(len(v))), make(w=w)]
        self.assertIsNone(self.compare(series, times))
        self.assertIsNotNone(self.compare(series, times, FillMissingArrays=True))
        self.assertIsNone(self.compare([make(v=v), make(v=np.float32(v))], times[:2], FillMissingArrays=True))
        ghosts = np.zeros(len(v), np.uint8)
        self.assertIsNotNone(self.compare([make(v=v), make(v=v, vtkGhostType=ghosts), make(v=v)], times[:3]))
        named = make(v=v)
        named.GetPointData().GetArray("v").SetComponentName(0, "x")
        self.assertIsNotNone(self.compare([make(v=v), named, make(v=v)], times[:3]))
        scalars = [make(v=v), make(v=v, w=w)]
        for mesh, name in zip(scalars, "vw"):
            mesh.GetPointData().SetActiveScalars(name)
        self.assertIsNotNone(self.compare(scalars, times[:2], FillMissingArrays=True))
        empty = gatun.from_numpy(POINTS[:0], {})
        self.assertIsNotNone(self.compare([empty, make(v=v, w=w), empty], times[:3]))

    def test_more_steps(self):
        """Steps that are added to a file; meshes that come back; some of the arrays."""
        make = lambda k: gatun.from_numpy(POINTS * k, TETS[: len(TETS) // k], point_data={"v": POINTS[:, 0] * k})  # noqa: E731
        first, second = [make(1), make(2), make(1), make(2)], [make(1), make(3), make(3)]
        self.assertIsNotNone(self.compare(first, [0.0, 1.0, 2.0, 3.0], KeepOrder=7))
        self.assertIsNotNone(self.compare(second, [4.0, 5.0, 6.0], Append=True))
        self.assertEqual(len(gatun.steps(find("found.gtn"))), 7)
        self.assertIsNone(self.compare(second, [6.0, 7.0, 8.0], Append=True))
        moved = [make(1), gatun.from_numpy(POINTS + 1, TETS, point_data={"v": POINTS[:, 0]})]
        self.assertIsNotNone(self.compare(moved, [10.0, 11.0], Append=True, errors=["v=abs:0.01"], Hierarchy=True))

    def test_memory_that_is_overwritten(self):
        """An algorithm that has each step in the same arrays."""
        mesh = gatun.from_numpy(POINTS, TETS, point_data={"v": POINTS[:, 0]})
        ids = np.frombuffer(mesh.GetCells().GetConnectivityArray(), np.int64)
        places = np.frombuffer(mesh.GetPoints().GetData(), np.float64).reshape(-1, 3)

        def make(step):
            places[...] = POINTS + (step if step > 1 else 0)
            ids[...] = TETS.ravel() if step != 1 else TETS[::-1].ravel()
            return mesh

        times = [0.0, 1.0, 2.0, 3.0]
        source = TimeSource(make, times)
        writer = gatun.vtk.vtkGatunWriter()
        connect(writer, source)
        writer.WriteAllTimeStepsOn()
        writer.SetFileName(find("reference.gtn"))
        self.assertTrue(writer.Write())
        gatun.write(source, find("found.gtn"), times=True, overwrite=True)
        with open(find("reference.gtn"), "rb") as one, open(find("found.gtn"), "rb") as other:
            self.assertTrue(one.read() == other.read())
        with gatun.open(find("found.gtn")) as file:
            self.assertEqual([step.bounds[0] for step in file.steps], [0, 0, 2, 3])

    def test_failing_algorithm(self):
        source = TimeSource(lambda step: None, [0.0, 1.0])
        vtkObject.GlobalWarningDisplayOff()
        with self.assertRaises(gatun.Error):
            gatun.write(source, find("failed.gtn"), times=True, overwrite=True)
        vtkObject.GlobalWarningDisplayOn()
        self.assertFalse(os.path.exists(find("failed.gtn")))

    def test_blocks(self):
        """Without the classes of Gatun, blocks have to be combined first."""
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, gatun.from_numpy(POINTS, TETS))
        blocks.SetBlock(1, gatun.from_numpy(POINTS + 9, TETS))
        gatun.write(blocks, find("blocks.gtn"), overwrite=True)
        self.assertEqual(gatun.read(find("blocks.gtn")).GetNumberOfCells(), 2 * len(TETS))
        with unittest.mock.patch("gatun._classes.get_class", side_effect=ImportError):
            with self.assertRaisesRegex(TypeError, "vtkMultiBlockDataSet is a tree of blocks.*combine the blocks first"):
                gatun.write(blocks, find("blocks.gtn"), overwrite=True)
            grid = blocks.GetBlock(0)
            gatun.write(grid, find("block.gtn"), overwrite=True, levels=1, point_tolerance="bits:8")
        self.assertEqual(gatun.read(find("block.gtn")).GetNumberOfCells(), len(TETS))

    def test_volumes(self):
        for dtype in (np.uint8, np.int16, np.uint32, np.float32, np.float64):
            x = np.linspace(0, 100, 9)
            values = np.add.outer(np.add.outer(x[:5] ** 1.1, x[:7]), x).astype(dtype)
            image = gatun.image_from_numpy(values, spacing=(1, 2, 0.5), origin=(1, 0, -1), name="density")
            image.SetExtent(3, 11, -2, 4, 0, 4)
            image.SetDirectionMatrix(0, 1, 0, 1, 0, 0, 0, 0, -1)
            for mode, (name, value) in enumerate([("Quality", 70), ("RMSError", 0), ("PSNR", 40), ("BitsPerVoxel", 2)]):
                for block in (0, 8, 5):
                    writer = gatun.vtk.vtkGatunHartleyWriter()
                    writer.SetInputData(image)
                    writer.SetFileName(find("reference.ghv"))
                    set_options(writer, RateControl=mode, BlockSize=block, **{name: value})
                    writer.Write()
                    options = {("quality", "rms_error", "psnr", "bits_per_voxel")[mode]: value}
                    gatun.write(image, find("found.ghv"), block_size=block, overwrite=True, **options)
                    with open(find("reference.ghv"), "rb") as one, open(find("found.ghv"), "rb") as other:
                        self.assertTrue(one.read() == other.read(), (dtype, name, block))

    def test_faces(self):
        """Faces as VTK has them since 9.4, and each one by itself."""
        rng = np.random.default_rng(1)
        faces = [list(rng.integers(0, 99, rng.integers(0, 6))) for _ in range(40)]
        lists = [list(rng.integers(0, 40, rng.integers(0, 5))) for _ in range(30)]
        is_polyhedron = rng.integers(0, 2, 30).astype(bool)
        stream, locations = [], []
        for cell, numbers in enumerate(lists):
            locations.append(len(stream) if is_polyhedron[cell] else -1)
            if is_polyhedron[cell]:
                stream.append(len(numbers))
                for number in numbers:
                    stream += [len(faces[number]), *faces[number]]

        def divide(rows):
            ends = np.cumsum([0] + [len(row) for row in rows])
            return ends, np.array([n for row in rows for n in row], np.int64)

        found = make_face_stream(divide(lists), divide(faces), is_polyhedron)
        np.testing.assert_array_equal(found[0], stream)
        np.testing.assert_array_equal(found[1], locations)


if __name__ == "__main__":
    unittest.main()
