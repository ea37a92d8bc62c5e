# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What libgatun writes comes back bit for bit: all golden meshes, steps, appended steps, field data and keys."""

import os
import pathlib
import subprocess
import sys
import unittest

import gatun
import numpy as np
from gatunCube import find, make_cube, require_equal, require_raises
from gatunGrids import golden_files, require_same_fields, require_same_grids, sort_surface

POINTS, TETS = make_cube(5)


def add_mesh(writer, grid):
    writer.add_mesh(
        grid.points,
        connectivity=grid.connectivity,
        offsets=grid.offsets,
        types=grid.types,
        faces=grid.faces,
        face_locations=grid.face_locations,
        surface=grid.is_surface,
    )


def copy(source, target, **options):
    """Writes all that a file holds to another one. Returns its grids."""
    grids = []
    move = source.info["pointsMove"]
    with gatun.Writer(target, overwrite=True, keep_order=True, points_move=move, arrays=source.arrays,
                      point_array=source.point_array, **options) as writer:
        mesh = None
        for number, step in enumerate(source.steps):
            grid = source.read(step=number)
            grids.append(sort_surface(grid) if grid.is_surface else grid)
            if step.mesh != mesh:
                add_mesh(writer, grids[-1])
                mesh = step.mesh
            writer.write_step(
                point_data=grid.point_data,
                cell_data=grids[-1].cell_data,
                field_data=grid.field_data,
                time=grid.time,
                points=grid.points if move else None,
            )
        if not source.steps:
            add_mesh(writer, source.read())
    return grids


class LibraryWriting(unittest.TestCase):
    def test_golden_files(self):
        for path in golden_files(".gtn"):
            for profile in ("fast", "small"):
                with self.subTest(os.path.basename(path), profile=profile), gatun.open(path) as source:
                    grids = copy(source, find("copy.gtn"), profile=profile)
                    with gatun.open(find("copy.gtn")) as target:
                        self.assertEqual(target.times, source.times)
                        self.assertEqual(target.is_surface, source.is_surface)
                        self.assertEqual(target.arrays, source.arrays)
                        self.assertEqual(target.point_array, source.point_array)
                        for number, grid in enumerate(grids):
                            require_same_grids(target.read(step=number), grid)

    def test_volumes(self):
        for path in golden_files(".ghv"):
            with self.subTest(os.path.basename(path)), gatun.open(path) as source:
                values = source.read()
                image = gatun.Image(
                    values, source.spacing, source.origin, source.direction, source.first_index, source.name
                )
                size = gatun.write(image, find("copy.ghv"), overwrite=True, rms_error=0)
                self.assertEqual(size, os.path.getsize(find("copy.ghv")))
                with gatun.Volume(find("copy.ghv")) as target:
                    if values.dtype.kind == "f":  # for which there is no lossless coding
                        error = np.abs(target.read() - values).max()
                        self.assertLessEqual(error, target.info["largestError"])
                    else:
                        require_equal(target.read(), values)
                        self.assertTrue(target.info["lossless"])
                    self.assertEqual(target.range, (values.min(), values.max()))
                    for name in ("name", "origin", "spacing", "first_index"):
                        np.testing.assert_array_equal(getattr(target, name), getattr(source, name))
                    np.testing.assert_array_equal(target.direction, source.direction)

    def test_blocks(self):
        """Blocks of cells of several types, masked and half floats, booleans."""
        cells = [("tetra", TETS[:7]), ("wedge", TETS[:2, [0, 1, 2, 1, 2, 3]]), ("tetra", TETS[7:])]
        flags = np.arange(len(POINTS)) % 2 == 0
        mesh = gatun.Mesh(POINTS, cells, {"flags": flags, "half": flags.astype(np.float16)})
        gatun.write(mesh, find("blocks.gtn"), keep_order=True, overwrite=True)
        with gatun.open(find("blocks.gtn")) as file:
            grid = file.read()
        require_equal(grid.points, POINTS)
        self.assertEqual([name for name, _ in grid.cells], ["tetra", "wedge", "tetra"])
        for (_, one), (_, other) in zip(grid.cells, cells):
            np.testing.assert_array_equal(one, other)
        require_equal(grid.point_data["flags"], flags.astype(np.uint8))
        require_equal(grid.point_data["half"], flags.astype(np.float32))

    def test_steps(self):
        times = [0.5, 1.0, 2.5]
        values = np.random.default_rng(1).normal(size=(3, len(POINTS), 2))
        series = [gatun.Mesh(POINTS, TETS, {"v": v}) for v in values]
        gatun.write(series, find("steps.gtn"), times=times, keep_order=True, overwrite=True)
        with gatun.open(find("steps.gtn")) as file:
            self.assertEqual(file.times, times)
            for number, time in enumerate(times):
                require_equal(file.read(step=number).point_data["v"], values[number])
                require_equal(file.read(time=time + 0.2).point_data["v"], values[number])
            require_equal(file.read(step=-1).point_data["v"], values[-1])
            require_equal(file.read(time=-7).point_data["v"], values[0])

    def test_append(self):
        path = find("append.gtn")
        make = lambda step: {"v": np.arange(len(POINTS)) * 1.5 + step}  # noqa: E731
        with gatun.Writer(path, overwrite=True, keep_order=True) as writer:
            writer.add_mesh(POINTS, TETS)
            writer.write_step(point_data=make(0), time=0, field_data={"title": "first"})
        size = os.path.getsize(path)
        with gatun.Writer(path, append=True) as writer:
            writer.add_mesh(POINTS, TETS)
            writer.write_step(point_data=make(1), time=1, field_data={"title": "second"})
            writer.add_mesh(POINTS * 2, TETS[:9])
            writer.write_step(point_data=make(2), time=2)
        with gatun.open(path) as file:
            self.assertEqual(file.times, [0, 1, 2])
            self.assertEqual([step.mesh for step in file.steps], [0, 1, 2])  # the same one is stored once
            for step in range(3):
                require_equal(file.read(step=step).point_data["v"], make(step)["v"])
            self.assertEqual(file.get_field_data(1), {"title": ["second"]})
            require_equal(file.read(step=2).points, POINTS * 2)
        self.assertGreater(os.path.getsize(path), size)
        before = pathlib.Path(path).read_bytes()
        with self.assertRaises(ZeroDivisionError), gatun.Writer(path, append=True) as writer:
            writer.add_mesh(POINTS, TETS)
            writer.write_step(point_data=make(3), time=3)
            raise ZeroDivisionError
        self.assertEqual(pathlib.Path(path).read_bytes(), before)
        with gatun.Writer(path, append=True) as writer:
            writer.add_mesh(POINTS, TETS)
            require_raises(ValueError, "is missing", writer.write_step, point_data={}, time=9)
            require_raises(ValueError, "is none of", writer.write_step, time=9,
                           point_data={**make(0), "w": POINTS[:, 0]})
            require_raises(ValueError, "is of float32", writer.write_step, time=9,
                           point_data={"v": np.float32(make(0)["v"])})
            writer.discard()
        require_raises(FileNotFoundError, "nowhere", gatun.Writer, find("nowhere.gtn"), append=True)

    def test_deleted_cells_and_moving_points(self):
        path = find("deleted.gtn")
        rest = np.arange(0, len(TETS), 3)
        used = np.unique(TETS[rest])
        with gatun.Writer(path, overwrite=True, keep_order=True, points_move=True) as writer:
            writer.add_mesh(POINTS, TETS)
            writer.write_step(cell_data={"id": np.arange(len(TETS))}, time=0)
            writer.write_step(cell_data={"id": np.arange(len(TETS))}, time=1, points=POINTS * 2)
            writer.write_step(cell_data={"id": rest}, time=2, points=POINTS[used] * 3,
                              remaining_cells=rest, remaining_points=used)
        with gatun.open(path) as file:
            require_equal(file.read(step=1).points, POINTS * 2)
            last = file.read(step=2)
            require_equal(last.points, POINTS[used] * 3)
            require_equal(last.cell_data["id"], rest)
            np.testing.assert_array_equal(used[last.connectivity.reshape(-1, 4)], TETS[rest])

    def test_several_meshes(self):
        path = find("meshes.gtn")
        with gatun.Writer(path, overwrite=True) as writer:
            self.assertEqual(writer.add_mesh(POINTS, TETS), 0)
            writer.write_step(point_data={"v": POINTS}, time=0)
            self.assertEqual(writer.add_mesh(POINTS[:50], TETS[:0]), 1)
            writer.write_step(point_data={"v": POINTS[:50]}, time=1)
            writer.use_mesh(0)
            writer.write_step(point_data={"v": POINTS}, time=2)
            require_raises(ValueError, "no mesh 7", writer.use_mesh, 7)
        with gatun.open(path) as file:
            self.assertEqual([step.mesh for step in file.steps], [0, 1, 0])
            self.assertEqual([step.cells for step in file.steps], [len(TETS), 0, len(TETS)])

    def test_field_data(self):
        fields = {
            "number": np.array([3.5]),
            "matrix": np.arange(6, dtype=np.int16).reshape(3, 2),
            "text": ["a", "", "\u03c6 with \0 zeros\0"],
            "pairs": [["a", "b"], ["c", "d"]],
            "none": np.empty(0, np.float32),
        }
        gatun.write(gatun.Mesh(POINTS, TETS, field_data=fields), find("fields.gtn"), overwrite=True)
        with gatun.open(find("fields.gtn")) as file:
            require_same_fields(file.read().field_data, fields)
            require_same_fields(file.get_field_data(), fields)

    def test_keys(self):
        keys = (
            ("vtkDataArray", "UNITS_LABEL", 5, ("m/s",)),
            ("vtkAbstractArray", "GUI_HIDE", 1, (-3,)),
            ("mine", "doubles", 7, (0.1, -np.inf)),
            ("mine", "texts", 8, ("", "b")),
        )
        array = gatun.File(golden_files("attributes.gtn")[0]).arrays[0]
        array = type(array)("v", "v", False, np.dtype(float), 2, ("x", "y"), 2, 0, keys)
        points = type(array)("Places", "points", False, np.dtype(float), 3, ("a", "b", "c"), 0, 0, keys[:1])
        with gatun.Writer(find("keys.gtn"), arrays=[array], point_array=points, overwrite=True) as writer:
            writer.add_mesh(POINTS, TETS)
            writer.write_step(point_data={"v": POINTS[:, :2]})
        with gatun.open(find("keys.gtn")) as file:
            found = file.arrays[0]
            self.assertEqual(sorted(found.keys), sorted(keys))
            self.assertEqual((found.component_names, found.roles), (("x", "y"), 2))
            self.assertEqual(file.point_array.name, "Places")
            self.assertEqual(file.point_array.component_names, ("a", "b", "c"))
            self.assertEqual(file.point_array.keys, keys[:1])

    def test_options(self):
        """Bounded errors, hierarchies, coarser meshes, layers and boundaries."""
        points, tets = make_cube(20)
        value = np.sin(points @ [3, 4, 5])
        path = find("options.gtn")
        mesh = gatun.Mesh(points, tets, {"v": value})
        common = {"overwrite": True, "keep_order": True}
        gatun.write(mesh, path, tolerances={"v": "abs:0.01"}, **common)
        with gatun.open(path) as file:
            error = np.abs(file.read().point_data["v"] - value).max()
            self.assertTrue(0 < error <= 0.01)
        gatun.write(mesh, path, levels=1, boundary=True, chunk_size=2048, **common)
        with gatun.open(path) as file:
            half = file.read(ratio=0.5)
            left = len(points) - len(points) // 2  # merges of a round are done together
            self.assertTrue(0.9 * left < len(half.points) <= left)
            boundary = file.read(boundary=True)
            self.assertTrue(boundary.is_surface or np.all(boundary.types == 5))
            self.assertEqual(len(boundary.types), 12 * 19 * 19)
        gatun.write(mesh, path, layers=("v", 4), **common)
        with gatun.open(path) as file:
            self.assertTrue(file.info["hasLayers"])
            surface = file.contour("v", 0.2, normals=True)
            self.assertEqual(surface.normals.shape, surface.points.shape)
            np.testing.assert_allclose(np.linalg.norm(surface.normals, axis=1), 1, atol=1e-5)
            np.testing.assert_allclose(surface.point_data["v"], 0.2, atol=1e-6)

    def test_bounds_by_name(self):
        """A bound is for the arrays that it is given for only, whatever their names."""
        points, tets = make_cube(8)
        value = np.sin(points @ [3, 4, 5])
        path = find("bounds.gtn")

        def write(names, bounds, cell_data=None):
            mesh = gatun.Mesh(points, tets, {name: value for name in names}, cell_data or {})
            gatun.write(mesh, path, tolerances=bounds, overwrite=True, keep_order=True)

        for name in ("a=b", "a=abs:1", " ", "v,zeros"):
            write((name, "other"), {name: "abs:0.01"})
            with gatun.open(path) as file:
                found = file.read().point_data
                self.assertTrue(0 < np.abs(found[name] - value).max() <= 0.01)
                require_equal(found["other"], value)
        cells = {"v": value[tets].mean(axis=1)}
        write(("v",), "abs:0.01", cell_data=cells)
        with gatun.open(path) as file:
            grid = file.read()
            self.assertTrue(0 < np.abs(grid.point_data["v"] - value).max() <= 0.01)
            self.assertTrue(0 < np.abs(grid.cell_data["v"] - cells["v"]).max() <= 0.01)
        numbers = {"v": np.arange(len(tets))}
        write(("v",), "abs:0.01", cell_data=numbers)  # numbers of cells are integers, and exact
        with gatun.open(path) as file:
            grid = file.read()
            self.assertTrue(0 < np.abs(grid.point_data["v"] - value).max() <= 0.01)
            require_equal(grid.cell_data["v"], numbers["v"])

    def test_wrong_input(self):
        path = find("wrong.gtn")
        os.path.exists(path) and os.remove(path)

        def make(points=POINTS, cells=TETS, **data):
            return gatun.Mesh(points, cells, data)

        def grid(connectivity, offsets, types):
            return gatun.Grid(POINTS, np.array(connectivity), np.array(offsets), np.array(types))

        for text, mesh, options in [
            ("n x 3", make(points=POINTS[:, :1]), {}),
            ("points from 0", make(cells=TETS + 1000), {}),
            ("values for", make(v=POINTS[:5]), {}),
            ("texts are for field_data", make(v=POINTS[:, 0].astype(str)), {}),
            ("no array 'w'", make(), {"tolerances": {"w": "abs:1"}}),
            ("no array 'w'", make(), {"arrays": ["w"]}),
            ("'rel:x' is none of", make(v=POINTS), {"tolerances": {"v": "rel:x"}}),
            ("keep_order", make(), {"keep_order": "some"}),
            ("profile", make(), {"profile": "tiny"}),
            ("no point array", make(), {"layers": "w"}),
            ("chunk_size", make(), {"chunk_size": 3}),
            ("offsets: has", grid(TETS.ravel(), [0, 4], [10, 10]), {}),
            ("ascend", grid(TETS.ravel(), [0, 8, 4], [10, 10]), {}),
            ("end in the", grid(TETS[0], [0, 4, 8], [10, 10]), {}),
            ("each has to be after", [make(), make()], {"times": [1, 0]}),
        ]:
            with self.subTest(text):
                require_raises(ValueError, text, gatun.write, mesh, path, **options)
        for text, mesh, options in [
            ("uses point 999", grid([0, 1, 2, 999], [0, 4], [10]), {}),
            ("cell 0 (type 12, vtkHexahedron) has 7 points, not 8", grid(range(7), [0, 7], [12]), {}),
            ("has to be", make(v=POINTS), {"tolerances": "pw:2"}),
        ]:
            with self.subTest(text):
                error = require_raises(gatun.InputError, "", gatun.write, mesh, path, **options)
                self.assertEqual(error.name, "InvalidInputError")
        require_raises(ValueError, "are written to", gatun.write, make(), find("a.vtk"))
        self.assertFalse(os.path.exists(path))

    def test_parts(self):
        points, tets = make_cube(12)
        path = find("parts.gtn")
        owner = points[tets].mean(axis=1)[:, 0] > 0.5
        times = [0.0, 1.0]

        class Parts:
            """Two halves that share the points between them."""

            def __iter__(self):
                for half in (False, True):
                    own = tets[owner == half]
                    used, corners = np.unique(own, return_inverse=True)
                    yield gatun.Grid(
                        points[used],
                        corners.ravel(),
                        np.arange(0, corners.size + 1, 4),
                        np.full(len(own), 10, np.uint8),
                        point_data={"v": [points[used] + time for time in times]},
                        cell_data={"id": [np.flatnonzero(owner == half)] * 2},
                        point_ids=used,
                    )

        size = gatun.write_parts(path, Parts(), times=times, field_data={"a": [1, 2]}, overwrite=True)
        self.assertEqual(size, os.path.getsize(path))
        with gatun.open(path) as file:
            self.assertEqual(file.times, times)
            for step in range(2):
                grid = file.read(step=step)
                self.assertEqual(len(grid.points), len(points))
                require_equal(grid.point_data["v"], grid.points + times[step])
                self.assertEqual(sorted(grid.cell_data["id"]), list(range(len(tets))))
                # Each cell has the corners that it had.
                corners = np.sort(grid.points[grid.connectivity.reshape(-1, 4)].view("f8,f8,f8")[..., 0], axis=1)
                expected = np.sort(points[tets[grid.cell_data["id"]]].view("f8,f8,f8")[..., 0], axis=1)
                np.testing.assert_array_equal(corners, expected)
                require_same_fields(grid.field_data, {"a": np.array([1, 2])})
        gatun.write_parts(path, Parts(), times=times, overwrite=True, levels=2, boundary=True)
        with gatun.open(path) as file:
            file.verify()
            boundary = file.read(step=1, boundary=True)
            self.assertEqual(len(boundary.offsets) - 1, 12 * 11 * 11)  # triangles
            require_equal(boundary.point_data["v"], boundary.points + times[1])
            grid = file.read(step=1, ratio=0.9)
            self.assertLess(len(grid.points), len(points) / 8)
            require_equal(grid.point_data["v"], grid.points + times[1])
            # No tetrahedron is turned over, and the cube stays one.
            corners = grid.points[grid.connectivity.reshape(-1, 4)].astype(float)
            before = points[tets[grid.cell_data["id"]]].astype(float)
            volume, expected = (np.linalg.det(c[:, 1:] - c[:, :1]) for c in (corners, before))
            self.assertTrue(np.all(volume * expected > 0))
            self.assertAlmostEqual(np.abs(volume).sum() / 6, np.ptp(points, axis=0).prod(), 6)
        require_raises(TypeError, "twice", gatun.write_parts, path, iter([]), overwrite=True)
        require_raises(ValueError, "none", gatun.write_parts, path, [], overwrite=True)
        require_raises(gatun.InputError, "whole mesh", gatun.write_parts, path, Parts(), times=times, layers="v",
                       overwrite=True)

    def test_without_vtk(self):
        program = """if True:
            import sys
            sys.modules["vtkmodules"] = None  # which then cannot be imported
            import gatun, numpy as np
            points = np.eye(4)[:, :3]
            mesh = gatun.Mesh(points, np.array([[0, 1, 2, 3]]), {"v": points}, field_data={"title": "one"})
            gatun.write([mesh, mesh], sys.argv[1], times=[0, 1], overwrite=True, levels=1)
            gatun.write(np.arange(24).reshape(2, 3, 4), sys.argv[2], overwrite=True, rms_error=0)
            with gatun.open(sys.argv[1]) as file:
                assert file.times == [0, 1] and file.read().field_data == {"title": ["one"]}
                gatun.write(file.read(step=1), sys.argv[1] + ".gtn", overwrite=True)
        """
        subprocess.run([sys.executable, "-c", program, find("plain.gtn"), find("plain.ghv")], check=True)
        with gatun.open(find("plain.gtn.gtn")) as file:
            self.assertEqual(file.times, [1])
        with gatun.open(find("plain.ghv")) as volume:
            np.testing.assert_array_equal(volume.read(), np.arange(24).reshape(2, 3, 4))

    def test_targets(self):
        path = find("target.gtn")
        mesh = gatun.Mesh(POINTS, TETS)
        gatun.write(mesh, path, overwrite=True)
        require_raises(FileExistsError, path, gatun.write, mesh, path)
        missing = find(os.path.join("nowhere", "a.gtn"))
        os.path.isdir(os.path.dirname(missing)) and os.rmdir(os.path.dirname(missing))
        error = require_raises(FileNotFoundError, "nowhere", gatun.write, mesh, missing)
        self.assertIn("nowhere", error.filename)
        require_raises(IsADirectoryError, "", gatun.write, mesh, os.path.dirname(path))
        folder = os.path.dirname(path)
        before = sorted(os.listdir(folder))
        with self.assertRaises(ZeroDivisionError), gatun.Writer(find("given-up.gtn")) as writer:
            writer.add_mesh(POINTS, TETS)
            writer.write_step(point_data={"v": POINTS})
            raise ZeroDivisionError
        self.assertEqual(sorted(os.listdir(folder)), before)
        require_raises(ValueError, "given up", writer.write_step)

    def test_progress(self):
        points, tets = make_cube(25)
        path = find("progress.gtn")
        os.path.exists(path) and os.remove(path)
        seen = []
        mesh = gatun.Mesh(points, tets, {"v": points})
        gatun.write([mesh, mesh], path, progress=seen.append)
        self.assertTrue(seen and all(0 <= fraction <= 1 for fraction in seen))
        self.assertEqual(seen, sorted(seen))
        os.remove(path)
        error = require_raises(gatun.Error, "", gatun.write, mesh, path, progress=lambda _: False)
        self.assertEqual(error.name, "AbortedError")

        def fail(_):
            raise KeyError("mine")

        require_raises(KeyError, "mine", gatun.write, mesh, path, progress=fail)
        self.assertFalse(os.path.exists(path))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
