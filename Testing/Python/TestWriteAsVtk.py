# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""gatun.write writes what vtkGatunWriter writes of the same data with the same options, byte for byte: all meshes of
golden files, and series that move, lose cells, change their meshes and arrays, or are added to a file."""

import os
import sys
import unittest
import warnings

import gatun
import gatunGolden  # for the folder of the next modules
import gatunGoldenArrays
import gatunGoldenCells
import gatunGoldenSteps
import gatunGoldenTets
import numpy as np
from gatunCube import find, make_cube
from gatunMeshes import set_options, set_tolerance
from gatunTimeSource import TimeSource, connect
from vtkmodules.vtkCommonCore import vtkObject, vtkPoints, vtkSOADataArrayTemplate
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersSources import vtkPlaneSource

ALL = [f for module in (gatunGoldenTets, gatunGoldenArrays, gatunGoldenSteps, gatunGoldenCells) for f in module.ALL]
POINTS, TETS = make_cube(6)


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
    writer = gatun.vtkGatunWriter()
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
    names = {"ChunkSize": "chunk_size", "KeyStepInterval": "key_step_interval", "Hierarchy": "hierarchy",
             "Levels": "levels", "WriteBoundary": "boundary", "FillMissingArrays": "fill_missing",
             "Append": "append"}
    found = {"profile": "small"}
    for name, value in options.items():
        if name == "KeepOrder":
            found["keep_order"] = [o for o, flag in (("points", 1), ("cells", 2), ("corners", 4)) if value & flag]
        elif name == "Profile":
            found["profile"] = ("small", "fast")[value]
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


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
