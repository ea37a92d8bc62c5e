# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""libgatun by ctypes: declarations as in gatun.h, errors, callbacks, threads and damaged files.

Arguments: the C compiler and gatun.h.
"""

import ctypes
import gc
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import threading
import unittest
import weakref

import gatun
import numpy as np
from gatun import _library
from gatunCube import find, make_cube, require_raises
from gatunGrids import FOLDER, golden_files, require_same_grids

COMPILER, HEADER = sys.argv[1:3]
POINTS, TETS = make_cube(20)
VALUES = np.sin(POINTS @ [3.0, 4.0, 5.0])


def read_header():
    """gatun.h without comments and directives."""
    text = pathlib.Path(HEADER).read_text(encoding="ascii")
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    return re.sub(r"^#(?:.*\\\n)*.*\n", "", text, flags=re.MULTILINE)


def list_structures():
    """The names of the members of each structure."""
    structures = {}
    for body, name in re.findall(r"typedef struct \w+\s*\{(.*?)\}\s*(\w+);", read_header(), flags=re.DOTALL):
        members = []
        for declaration in filter(None, map(str.strip, body.split(";"))):
            pointer = re.search(r"\(\*(\w+)\)", declaration)
            if pointer:
                members.append(pointer[1])
            else:
                names = re.sub(r"\[\d+\]", "", declaration).split(",")
                members += [re.search(r"(\w+)$", name.strip())[1] for name in names]
        structures[name] = members
    return structures


def list_functions():
    """The number of parameters of each function."""
    functions = {}
    for name, parameters in re.findall(r"GATUN_API\s[^(;]*?(\w+)\(([^;]*)\);", read_header()):
        functions[name] = 0 if parameters.strip() == "void" else parameters.count(",") + 1
    return functions


def ask_compiler(structures):
    """The size of each structure, and offset and size of its members."""
    lines = []
    for name, members in structures.items():
        lines.append(f'printf("{name} size %zu 0\\n", sizeof({name}));')
        for member in members:
            place = f"offsetof({name}, {member}), sizeof((({name}*)0)->{member})"
            lines.append(f'printf("{name} .{member} %zu %zu\\n", {place});')
    with tempfile.TemporaryDirectory() as folder:
        source, program = os.path.join(folder, "sizes.c"), os.path.join(folder, "sizes")
        with open(source, "w", encoding="ascii") as file:
            file.write('#include "gatun.h"\n#include <stdio.h>\nint main(void) {\n')
            file.write("\n".join(lines) + "\nreturn 0; }\n")
        subprocess.run([COMPILER, "-I", os.path.dirname(HEADER), "-o", program, source], check=True)
        output = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    return [line.split() for line in output.splitlines()]


class Pieces:
    """A source in memory that fails as told, and notes what is read."""

    def __init__(self, data, name="pieces"):
        self.data = data
        self.size = len(data)
        self.name = name
        self.failure = None
        self.reads = []

    def read(self, offset, length):
        self.reads.append((offset, length))
        if self.failure is not None:
            raise self.failure
        return self.data[offset : offset + length]


class Arriving(Pieces):
    """A source whose bytes come when they are asked for."""

    def __init__(self, data):
        super().__init__(data)
        self.here = bytearray(len(data))

    def read(self, offset, length):
        if not all(self.here[offset : offset + length]):
            raise gatun.NotHere
        return super().read(offset, length)

    def bring(self, ranges):
        for offset, length in ranges:
            self.here[offset : offset + length] = b"\1" * length


def write_file(name="library.gtn", **options):
    path = find(name)
    data = {"v": VALUES, "p": POINTS}
    gatun.write(gatun.Mesh(POINTS, TETS, data), path, overwrite=True, chunk_size=2048, **options)
    return path


class Declarations(unittest.TestCase):
    def test_structures(self):
        structures = list_structures()
        self.assertEqual(set(structures), set(_library.STRUCTURES))
        for name, members in structures.items():
            self.assertEqual([member for member, _ in _library.STRUCTURES[name]._fields_], members, name)
        found = 0
        for name, member, first, second in ask_compiler(structures):
            own = _library.STRUCTURES[name]
            if member == "size":
                self.assertEqual(ctypes.sizeof(own), int(first), name)
            else:
                field = getattr(own, member[1:])
                self.assertEqual((field.offset, field.size), (int(first), int(second)), (name, member))
                found += 1
        self.assertGreater(found, 150)

    def test_functions(self):
        functions = list_functions()
        self.assertGreater(len(functions), 40)
        self.assertEqual({name: len(types) - 1 for name, types in _library.FUNCTIONS.items()}, functions)

    def test_constants(self):
        """Enumerations and flags have the values of the header."""
        text = pathlib.Path(HEADER).read_text(encoding="ascii")
        for name, value in re.findall(r"\bGATUN_(\w+) = (-?\d+)", text):
            for own in (name, f"KIND_{name}"):
                if hasattr(_library, own):
                    self.assertEqual(getattr(_library, own), int(value), name)
        for number, dtype in _library.DTYPES.items():
            self.assertIn(f"GATUN_{dtype.upper()} = {number}", text)

    def test_codes(self):
        """Codes of errors are those of the classes of VTK."""
        for number, name in _library._CODES.values():
            self.assertEqual(gatun.vtkGatunErrorCode.GetStringFromErrorCode(number), name)


class Errors(unittest.TestCase):
    def test_opening(self):
        nowhere = find(os.path.join("nowhere", "a.gtn"))
        for function in (gatun.open, gatun.File, gatun.Volume):
            error = require_raises(FileNotFoundError, nowhere, function, nowhere)
            self.assertEqual(error.filename, nowhere)
            self.assertEqual(str(error).count(nowhere), 1)
            require_raises(IsADirectoryError, FOLDER, function, FOLDER)
            error = require_raises(gatun.Error, __file__, function, __file__)
            self.assertEqual(error.name, "UnrecognizedFileTypeError")
            require_raises(gatun.Error, "", function, b"")
            require_raises(gatun.Error, "", function, b"no such file")
            require_raises(TypeError, "int", function, 3) if function is not gatun.open else None
        require_raises(ValueError, "zero", gatun.File, "a\0b")
        if os.geteuid() != 0:
            path = write_file("secret.gtn")
            os.chmod(path, 0)
            require_raises(PermissionError, path, gatun.File, path)

    def test_parameters(self):
        with gatun.open(write_file()) as file:
            read = file.read
            for text, parameters in [
                ("no step 1", {"step": 1}),
                ("no time steps", {"time": 0.5}),
                ("exclude", {"step": 0, "time": 0.5}),
                ("no array 'w'", {"arrays": "w"}),
                ("no array 9", {"arrays": [9]}),
                ("pieces", {"pieces": 0}),
                ("piece:", {"piece": 2, "pieces": 2}),
                ("ghost_levels", {"ghost_levels": -1}),
                ("box: has to", {"box": (0, 1)}),
                ("box", {"box": (1, 0, 0, 1, 0, 1)}),
                ("exact", {"exact": True}),
                ("ratio", {"ratio": 2}),
                ("level", {"level": -1}),
                ("no array 'w'", {"values": ("w", 0, 1)}),
                ("allocate", {"allocate": lambda name, dtype, shape: np.empty(shape, "U1")}),
            ]:
                with self.subTest(text):
                    require_raises(ValueError, text, read, **parameters)
            for parameters in ({"ratio": 0.5}, {"level": 3}, {"boundary": True}):
                with self.subTest(parameters):
                    error = require_raises(gatun.InputError, "", read, **parameters)
                    self.assertIsInstance(error, ValueError)
            require_raises(TypeError, "unexpected", read, nothing=1)
            require_raises(gatun.InputError, "normal", file.slice, (0, 0, 0), (0, 0, 0))
            require_raises(ValueError, "finite", file.contour, "v", [np.nan])
            require_raises(ValueError, "no component 3", file.contour, "p", 0, component=3)
            require_raises(ValueError, "blend", file.render, blend="none")
            require_raises(ValueError, "size", file.render, size=(0, 1))
        require_raises(ValueError, "closed", file.read)

    def test_offset(self):
        data = bytearray(pathlib.Path(write_file()).read_bytes())
        data[100] ^= 1
        with gatun.File(bytes(data)) as file:
            error = require_raises(gatun.Error, "checksum", file.verify)
            self.assertEqual(error.name, "FileFormatError")
            self.assertLessEqual(error.offset, 100)
        error = require_raises(gatun.Error, "", gatun.File, bytes(data[:50]))
        self.assertIn(error.name, ("PrematureEndOfFileError", "FileFormatError"))

    def test_abort(self):
        with gatun.open(write_file()) as file:
            expected = file.read()
        for name in ("read", "verify"):
            with gatun.open(write_file()) as file:
                error = require_raises(gatun.Error, "", getattr(file, name), progress=lambda _: False)
                self.assertEqual(error.name, "AbortedError")

                def fail(_):
                    raise KeyboardInterrupt

                with self.assertRaises(KeyboardInterrupt):
                    getattr(file, name)(progress=fail)
                require_same_grids(file.read(), expected)
        seen = []
        with gatun.open(write_file()) as file:
            file.read(progress=seen.append)
        self.assertTrue(seen and all(0 <= fraction <= 1 for fraction in seen))

    def test_sources(self):
        data = pathlib.Path(write_file()).read_bytes()
        with gatun.open(data) as file:
            expected = file.read()
            description = {**file.info, "file": ""}
        for source in (Pieces(data), bytearray(data), memoryview(data)):
            with gatun.open(source) as file:
                require_same_grids(file.read(), expected)
                self.assertEqual({**file.info, "file": ""}, description)
        source = Pieces(data)
        for failure in (OSError(28, "full"), KeyError("mine"), KeyboardInterrupt(), MemoryError()):
            source.failure = None
            with gatun.open(source) as file:
                source.failure = failure
                with self.assertRaises(type(failure)) as caught:
                    file.read()
                self.assertIs(caught.exception, failure)
                source.failure = None
                require_same_grids(file.read(), expected)
        source.data = data[:-5]  # shorter than its size
        require_raises(EOFError, "in place of", gatun.File, source)
        error = require_raises(gatun.Error, "my name", gatun.File, Pieces(b"no such file", "my name"))
        self.assertEqual(error.name, "UnrecognizedFileTypeError")

    def test_not_here(self):
        """A source is given only what plans ask for."""
        data = pathlib.Path(write_file()).read_bytes()
        source = Arriving(data)
        source.bring([(0, 4096), (len(data) - 4096, 4096)])
        box = (0.0, 0.1, 0.0, 0.1, 0.0, 0.1)
        with gatun.File(data) as file:
            expected = file.read(box=box)
        rounds = 0
        while True:
            rounds += 1
            self.assertLess(rounds, 20)
            try:
                with gatun.File(source) as file:
                    source.bring(file.plan(box=box))
                    require_same_grids(file.read(box=box), expected)
                    error = require_raises(gatun.NotHere, "", file.read)
                    self.assertGreater(error.length, 0)
                break
            except gatun.NotHere as error:
                self.assertTrue(error.ranges)
                source.bring(error.ranges)
        self.assertLess(sum(source.here), len(data))

    def test_damaged(self):
        """Any damage is an exception, or data as they were not asked for."""
        generator = random.Random(1)
        kinds = {}
        for path in golden_files(".gtn")[::4] + golden_files(".ghv")[::3]:
            original = pathlib.Path(path).read_bytes()
            for number in range(12):
                data = bytearray(original)
                if number % 3 == 0:
                    del data[generator.randrange(len(data)) :]
                for _ in range(number if number % 3 else 0):
                    data[generator.randrange(len(data))] ^= 1 << generator.randrange(8)
                try:
                    with gatun.open(bytes(data)) as file:
                        file.read()
                        kind = "read"
                except (gatun.Error, ValueError, MemoryError) as error:
                    kind = type(error).__name__
                kinds[kind] = kinds.get(kind, 0) + 1
        self.assertGreater(kinds["Error"], 5 * kinds.get("read", 0))
        self.assertLessEqual(set(kinds), {"Error", "read", "InputError", "MemoryError"})


class Use(unittest.TestCase):
    def test_threads(self):
        """Four threads read one file, also from a source, and one that closes it waits for them."""
        path = write_file()
        with gatun.open(path) as file:
            expected = file.read()
        for source in (path, Pieces(pathlib.Path(path).read_bytes())):
            file = gatun.open(source)
            results = []

            def work(file=file, results=results):
                for _ in range(3):
                    results.append(file.read())

            threads = [threading.Thread(target=work) for _ in range(4)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            file.close()
            self.assertEqual(len(results), 12)
            for grid in results:
                require_same_grids(grid, expected)
        default = gatun.get_threads()
        for count in (1, 3, 0):
            gatun.set_threads(count)
            self.assertEqual(gatun.get_threads(), count or default)
            with gatun.open(path) as file:
                require_same_grids(file.read(), expected)
        require_raises(ValueError, "threads", gatun.set_threads, -1)
        file = gatun.open(path)
        started = threading.Event()

        def close(_):
            if not started.is_set():
                started.set()
                file.close()

        require_same_grids(file.read(progress=close), expected)
        require_raises(ValueError, "closed", file.read)

    def test_parts(self):
        """Pieces, boxes, values and levels give what they should."""
        path = write_file(levels=1)
        with gatun.open(path) as file:
            whole = file.read(ids=True, restore_order=False)
            pieces = [file.read(piece=i, pieces=3, ids=True) for i in range(3)]
            self.assertEqual(sum(len(piece.types) for piece in pieces), len(TETS))
            self.assertTrue(all((piece.cell_ghosts == 0).all() for piece in pieces))
            ghosts = file.read(piece=1, pieces=3, ghost_levels=1)
            self.assertEqual((ghosts.cell_ghosts == 0).sum(), len(pieces[1].types))
            self.assertTrue((ghosts.cell_ghosts == 1).any())
            box = (0.1, 0.2, 0.1, 0.2, 0.1, 0.2)
            chunks, exact = file.read(box=box), file.read(box=box, exact=True)
            self.assertTrue(0 < len(exact.types) < len(chunks.types) < len(TETS))
            corners = exact.points[exact.connectivity.reshape(-1, 4)]
            self.assertTrue((corners.min(axis=1) <= 0.2).all() and (corners.max(axis=1) >= 0.1).all())
            exact = file.read(values=("v", 0.9, 1.0), exact=True)
            found = exact.point_data["v"][exact.connectivity.reshape(-1, 4)]
            self.assertTrue((found.max(axis=1) >= 0.9).all() and (found.min(axis=1) <= 1.0).all())
            inside = VALUES[TETS]
            wanted = (inside.max(axis=1) >= 0.9) & (inside.min(axis=1) <= 1.0)
            self.assertEqual(len(exact.types), wanted.sum())
            only = file.read(arrays="v", wide_ids=False)
            self.assertEqual((list(only.point_data), only.connectivity.dtype), (["v"], np.int32))
            self.assertEqual(file.read(arrays=[]).point_data, {})
            self.assertEqual(file.get_range("v"), (VALUES.min(), VALUES.max()))
            self.assertEqual(len(whole.point_ids), len(POINTS))
            section = file.slice((0.5, 0.5, 0.5), (0, 0, 1))
            np.testing.assert_allclose(section.points[:, 2], 0.5, atol=1e-12)
            corners = section.points[section.connectivity.reshape(-1, 3)]
            edges = corners[:, 1:] - corners[:, :1]
            area = np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1).sum() / 2
            self.assertAlmostEqual(area, 1)

    def test_allocate(self):
        """The caller's memory is filled, and nothing else."""
        made = {}

        def allocate(name, dtype, shape):
            made[name] = np.zeros(shape, dtype)
            return made[name]

        with gatun.open(write_file()) as file:
            expected = file.read()
            grid = file.read(allocate=allocate)
            require_same_grids(grid, expected)
        self.assertEqual(
            set(made), {"points", "connectivity", "offsets", "types", "point_data/v", "point_data/p"}
        )
        self.assertIs(grid.points, made["points"])
        self.assertIs(grid.point_data["v"], made["point_data/v"])

    def test_memory(self):
        """Files and writers go without being closed, and so does a source."""
        source = Pieces(pathlib.Path(write_file()).read_bytes())
        reference = weakref.ref(source)
        gatun.File(source).read()
        writer = gatun.Writer(find("lost.gtn"), overwrite=True)
        writer.add_mesh(POINTS, TETS)
        writer.write_step()
        del source, writer
        gc.collect()
        self.assertIsNone(reference())
        self.assertFalse(os.path.exists(find("lost.gtn")))

    def test_images(self):
        path = write_file()
        with gatun.open(path) as file:
            image = file.render(size=(60, 40), background="white")
            self.assertEqual((image.shape, image.dtype), ((40, 60, 4), np.uint8))
            self.assertTrue((image[0, 0] == 255).all() and (image[..., 3] == 255).all())
            self.assertTrue((image[..., :3] < 200).any())
            clear = file.render(size=(60, 40), dtype=np.float32)
            self.assertEqual(clear[0, 0].tolist(), [0, 0, 0, 0])
            # Something at the top of the mesh is at the top of the image.
            view = {"size": (40, 40), "direction": (0, 0, -1), "colors": [(1, 0, 0)] * 2, "array": "p"}
            view.update(component=1, opacity=[(0.69, 0), (0.7, 1), (1, 1)], unit_distance=0.01, dtype=np.float32)
            opacity = file.render(**view)[..., 3]
            self.assertGreater(opacity[:18].sum(), 100)
            self.assertEqual(opacity[22:].sum(), 0)
            turned = file.render(**view, roll=180)[..., 3]
            self.assertEqual(turned[:18].sum(), 0)
            near = file.render(**{**view, "opacity": [1, 1], "range": (0, 1)}, zoom=0.5, parallel=True)
            wide = file.render(**{**view, "opacity": [1, 1], "range": (0, 1)}, parallel=True)
            self.assertAlmostEqual((wide[20, :, 3] > 0).sum() / (near[20, :, 3] > 0).sum(), 2, delta=0.2)

    def test_light_and_factor_of_opacities(self):
        """As the ray caster of VTK draws them."""
        path = write_file("light.gtn")
        common = {"size": (60, 50), "array": "v", "dtype": np.float32, "colors": [(0, 0, 1), (1, 0, 0)]}
        with gatun.open(path) as file:
            plain = file.render(**common)
            for more in ({"shade": True}, {"opacity": 0.3}, {"opacity": 4.0, "shade": True}, {"opacity": 0}):
                with self.subTest(more):
                    image = file.render(**common, **more)
                    np.testing.assert_allclose(image, gatun.render(path, **common, **more), atol=2e-3)
                    self.assertGreater(np.abs(image - plain).max(), 0.02)
            for factor in (-1, np.inf):
                require_raises(ValueError, "opacity", file.render, opacity=factor)

    def test_images_of_series(self):
        """The mesh of each step fills the image."""
        for name in ("series_of_meshes.gtn", "moving_points.gtn", "deleted_cells.gtn"):
            with gatun.open(os.path.join(FOLDER, name)) as file:
                for step in range(len(file.times)):
                    image = file.render(size=(40, 40), step=step, opacity=[1, 1], range=(-1e9, 1e9), dtype=np.float32)
                    self.assertGreater((image[..., 3] > 0).sum(), 300, (name, step))

    def test_same_image_as_vtk(self):
        """Camera, colors and opacities are those of gatun.render."""
        path = write_file()
        parameters = {"size": (64, 48), "array": "v", "azimuth": 70, "elevation": -10, "roll": 20, "zoom": 1.3,
                      "range": (-1, 1), "colors": [(0, 0, 1), (1, 0, 0)], "opacity": [0.1, 0.9],
                      "background": "white"}
        with gatun.open(path) as file:
            one = file.render(**parameters).astype(int)
        other = gatun.render(path, **parameters).astype(int)
        self.assertLessEqual(np.abs(one - other).max(), 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
