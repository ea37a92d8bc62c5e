# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Order and times of several files, lists of files with odd times, steps whose arrays differ, a choice
of steps, and all steps as files again."""

import json
import os
import shutil

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridWriter

from gatunCli import enter_folder, gtn, lattice, make_grid, read, write

enter_folder("steps")
points, tets = lattice(3)
N = len(points)


def make(value, time=None, **arrays):
    grid = make_grid(points, tets, {"u": np.full(N, float(value)), **arrays})
    if time is not None:
        array = numpy_to_vtk(np.array([time]), deep=True)
        array.SetName("TimeValue")
        grid.GetFieldData().AddArray(array)
    return grid


def times_of(file):
    return json.loads(gtn("info", "--json", file))["times"]


def values_of(file):
    """The value of the array u at each step."""
    values = []
    for step in range(len(times_of(file))):
        gtn("unpack", "-q", "-f", "--step", step, file, "step.vtu")
        values.append(vtk_to_numpy(read("step.vtu").GetPointData().GetArray("u"))[0])
    return values


def pack(*arguments, **keywords):
    return gtn("pack", "-f", *arguments, "out.gtn", **keywords)


def refuse(*arguments, says):
    gtn("pack", *arguments, "never.gtn", code=1, says=says)
    assert not os.path.exists("never.gtn")


# Files in the order of a shell: by the times in them, or else by the numbers in their names.
shell = sorted(range(12), key=str)
for i in shell:
    write(make(i, 0.5 * i), f"timed_{i}.vtu")
    write(make(i), f"plain_{i}.vtu")
timed = [f"timed_{i}.vtu" for i in shell]
plain = [f"plain_{i}.vtu" for i in shell]
assert "order of the numbers" not in pack(*timed)
assert times_of("out.gtn") == [0.5 * i for i in range(12)] and values_of("out.gtn") == list(range(12))
gtn("unpack", "-f", "--step", 10, "out.gtn", "step.vtu")
assert read("step.vtu").GetFieldData().GetArray("TimeValue").GetValue(0) == 5
gtn("verify", "out.gtn", *reversed(timed), says="identical")
pack(*plain, says="in the order of the numbers in the names, up to plain_11.vtu")
assert times_of("out.gtn") == list(range(12)) and values_of("out.gtn") == list(range(12))
os.makedirs("t9")
os.makedirs("t10")
shutil.copy("plain_1.vtu", "t10/m01.vtu")
shutil.copy("plain_0.vtu", "t9/m1.vtu")
pack("t10/m01.vtu", "t9/m1.vtu", says="order of the numbers")
assert values_of("out.gtn") == [0, 1]
# Decimals and whole numbers give two orders; names that differ in letters give none.
for name, value in (("d0.25", 0), ("d0.5", 1), ("b", 2), ("a", 3)):
    shutil.copy(f"plain_{value}.vtu", name + ".vtu")
pack("d0.25.vtu", "d0.5.vtu", says="in the order of the command line")
assert values_of("out.gtn") == [0, 1]
pack("b.vtu", "a.vtu")
assert values_of("out.gtn") == [2, 3]

# Times that do not make a series are named.
write(make(0, np.nan), "nan.vtu")
write(make(7, 0.5), "same.vtu")
refuse(timed[0], plain[3], timed[1], says=f"{plain[3]}: has no time")
refuse(plain[3], timed[1], says=f"{timed[1]} has the time")
refuse("nan.vtu", timed[1], says="nan.vtu: has the time nan")
refuse("timed_1.vtu", "same.vtu", timed[0], says="same.vtu: has the time 0.5 (field array TimeValue), as timed_1.vtu")
pack(timed[0], "timed_1.vtu", "./timed_1.vtu")  # counts once
assert times_of("out.gtn") == [0, 0.5]


# Lists of files.
def collection(name, *rows):
    entries = "".join(
        f"<DataSet {'' if t is None else f'timestep={chr(34)}{t}{chr(34)}'} part=\"0\" file=\"{f}\"/>"
        for t, f in rows)
    with open(name, "w", encoding="ascii") as file:
        file.write(f'<VTKFile type="Collection" version="0.1"><Collection>{entries}</Collection></VTKFile>')


p = [f"plain_{i}.vtu" for i in range(4)]
collection("fortran.pvd", ("0.1D+01", p[0]), (" +0.2d+01 ", p[1]), ("3.", p[2]))
pack("fortran.pvd")
assert times_of("out.gtn") == [1, 2, 3] and values_of("out.gtn") == [0, 1, 2]
for text in "0,5", "nan", "inf", "1 s", " ", "1e999", "0x10", "--1":
    collection("odd.pvd", ("0", p[0]), (text, p[1]))
    refuse("odd.pvd", says=f"odd.pvd: the entry of {p[1]} has the time '{text}'")
collection("half.pvd", (None, p[0]), ("1", p[1]))
refuse("half.pvd", says=f"the entry of {p[0]} has no time, and that of {p[1]} has one")
with open("bad.series", "w", encoding="ascii") as file:
    json.dump({"files": [{"name": p[0], "time": "x"}]}, file)
refuse("bad.series", says=f"the entry of {p[0]} has no time")
collection("again.pvd", ("0", p[0]), ("0", "./" + p[0]), ("-0", p[0]), ("1", p[1]), ("1", p[1]))
assert "merged" not in pack("again.pvd")
assert times_of("out.gtn") == [0, 1] and json.loads(gtn("info", "--json", "out.gtn"))["tets"] == len(tets)
collection("restart.pvd", ("0", p[0]), ("1", p[1]), ("1", p[3]), ("2", p[2]))
refuse("restart.pvd", says="different numbers of files: 2 files at time 1, and 1 at time 0")
refuse("--pieces", 2, "restart.pvd", says="different numbers of files: 2 files at time 1, and 1")


# Steps that differ in nothing that is data are one series.
def series(name, *grids):
    files = [f"{name}_{i}.vtu" for i in range(len(grids))]
    for grid, file in zip(grids, files):
        write(grid, file)
    return files


def arrays(names, active=None, components=None, dtype=np.float64):
    grid = make_grid(points, tets, {n: (np.arange(N) + ord(n)).astype(dtype) for n in names})
    if active:
        grid.GetPointData().SetActiveScalars(active)
    if components:
        grid.GetPointData().GetArray(0).SetComponentName(0, components)
    return grid


def ghosts(value):
    grid = arrays("ab")
    array = numpy_to_vtk(np.full(len(tets), value, np.uint8), deep=True)
    array.SetName("vtkGhostType")
    grid.GetCellData().AddArray(array)
    return grid


def only_points():
    grid = vtkUnstructuredGrid()
    grid.SetPoints(arrays("a").GetPoints())
    grid.GetPointData().ShallowCopy(arrays("ab").GetPointData())
    return grid


def check(files, names=("a", "b"), says=None, options=(), verified="identical"):
    pack("--keep-order", "all", *options, *files, says=says)
    gtn("verify", *options, "out.gtn", *files, says=verified, code=verified.startswith("differs"))
    for step, file in enumerate(files):
        gtn("unpack", "-q", "-f", "--step", step, "out.gtn", "step.vtu")
        back, original = read("step.vtu").GetPointData(), read(file).GetPointData()
        assert [back.GetArrayName(i) for i in range(back.GetNumberOfArrays())] == list(names)
        for name in names:
            if original.HasArray(name):
                assert np.array_equal(vtk_to_numpy(back.GetArray(name)), vtk_to_numpy(original.GetArray(name)))
    return read("step.vtu")


check(series("order", arrays("ab"), arrays("ba"), arrays("ab")))
active = check(series("active", arrays("ab", "a"), arrays("ab", "b")), says="active arrays",
               verified="but for the active arrays")
assert active.GetPointData().GetScalars().GetName() == "a"
named = check(series("names", arrays("ab"), arrays("ab", components="X"), arrays("ab", components="X")))
assert named.GetPointData().GetArray("a").GetComponentName(0) == "X"
check(series("renamed", arrays("ab", components="X"), arrays("ab", components="Y")), says="names of components",
      verified="differs at step 1 (time 1): point array 'a' is double, 1 component(s) (X)")
check(series("ghosts", arrays("ab"), ghosts(32), arrays("ab")))
check(series("nocells", only_points(), arrays("ab"), only_points()))
cells = arrays("ab")
cells.GetCellData().AddArray(vtk_array := numpy_to_vtk(np.arange(len(tets)), deep=True))
vtk_array.SetName("c")
check(series("late", only_points(), cells))

# Arrays that come and go.
come = series("come", arrays("ab"), arrays("abc"), arrays("ab"))
go = series("go", arrays("abc"), arrays("ac"))
types = series("types", arrays("ab"), arrays("ab", dtype=np.float32))
refuse(*come, says="time step 1 (time 1, come_1.vtu) the point array 'c' (double with 1 component) appears")
refuse(*come, says="--fill-missing")
refuse(*go, says="time step 1 (time 1, go_1.vtu) the point array 'b' (double with 1 component) of the steps before is missing")
refuse(*types, says="the point array 'a' is float with 1 component, and in the steps before double")
refuse("--fill-missing", *types, says="is float with 1 component, and in the steps before double")
refuse("--pieces", 2, *come, says="the point array 'c' appears (--fill-missing")
refuse("--pieces", 2, *go, says="the point array 'b' of the first step is missing")
refuse("--pieces", 2, *types, says="the point array 'a' is float")
gtn("pack", "--pieces", 2, "--fill-missing", *come, "never.gtn", code=2, says="whole mesh")
filled = check(come, "abc", options=["--fill-missing"])
assert np.isnan(vtk_to_numpy(filled.GetPointData().GetArray("c"))).all()
gtn("verify", "out.gtn", *come, code=1, says="'c'")
write(arrays("abc"), come[2])
gtn("verify", "--fill-missing", "out.gtn", *come, code=1, says="differs at step 2")
check(series("both", arrays("ab"), arrays("ac"), arrays("cb")), "abc", options=["--fill-missing"])
integers = arrays("a")
integers.GetPointData().AddArray(vtk_array := numpy_to_vtk(np.arange(1, N + 1), deep=True))
vtk_array.SetName("i")
filled = check(series("integers", integers, arrays("a")), "ai", options=["--fill-missing"])
assert not vtk_to_numpy(filled.GetPointData().GetArray("i")).any()

# Some of the steps.
pack("--steps", "1:9:4", *timed)
assert times_of("out.gtn") == [0.5, 2.5, 4.5] and values_of("out.gtn") == [1, 5, 9]
gtn("verify", "--steps", "1:9:4", "out.gtn", *timed, says="identical")
gtn("verify", "--steps", "2:10:4", "out.gtn", *timed, code=1, says="differs: step 0 is at time 0.5, not 1")
gtn("verify", "out.gtn", *timed, code=1, says="3 time steps, not 12")
gtn("pack", "-q", *timed, "all.gtn")
for text, chosen in (("3", [3]), ("10:", [10, 11]), (":1", [0, 1]), ("::5", [0, 5, 10]), ("2:6:3", [2, 5])):
    pack("--steps", text, "all.gtn")
    assert times_of("out.gtn") == [0.5 * i for i in chosen] and values_of("out.gtn") == chosen
    gtn("verify", "--steps", text, "out.gtn", "all.gtn", says="identical")
for text in "x", "", "1:2:3:4", "::0", "4:2", "-1", "1,2":
    gtn("pack", f"--steps={text}", "all.gtn", "never.gtn", code=2, says="--steps")
refuse("--steps", "12", "all.gtn", says="no step 12 as --steps wants; they are numbered 0 to 11")
refuse("--steps", "3:12", *timed, says="no step 12")
refuse("--steps", "0", plain[0], says="has no time steps")

# All steps as files.
gtn("unpack", "--all", "all.gtn", "back.pvd", says="12 time steps, back_00.vtu to back_11.vtu")
assert sorted(f for f in os.listdir(".") if f.startswith("back")) == ["back.pvd"] + [
    f"back_{i:02}.vtu" for i in range(12)]
for i in range(12):
    assert vtk_to_numpy(read(f"back_{i:02}.vtu").GetPointData().GetArray("u"))[0] == i
gtn("verify", "all.gtn", "back.pvd", says="identical")
gtn("unpack", "--all", "all.gtn", "back.pvd", code=1, says="back.pvd: exists; use -f")
os.remove("back.pvd")
before = open("back_05.vtu", "rb").read()
gtn("unpack", "--all", "all.gtn", "back.pvd", code=1, says="exists; use -f")
assert not os.path.exists("back.pvd") and open("back_05.vtu", "rb").read() == before
gtn("unpack", "-q", "-f", "--all", "--steps", "4:", "all.gtn", "some & <more>.pvd")
assert os.path.exists("some & <more>_7.vtu")
gtn("verify", "--steps", ":7", "all.gtn", "some & <more>.pvd", code=1, says="12 time steps, not 8")
gtn("pack", "-q", "some & <more>.pvd", "some.gtn")
assert times_of("some.gtn") == [2 + 0.5 * i for i in range(8)]
gtn("unpack", "--all", "all.gtn", "back.vtu", code=2, says="must end in .pvd")
gtn("unpack", "all.gtn", "back.pvd", code=2, says="--all")
gtn("unpack", "--all", plain[0], "none.pvd", code=1, says="has no time steps")
gtn("unpack", "--steps", "1", "all.gtn", "one.vtu", code=2, says="--all")

# A .vtk file has no time, unless a field array says so.
for name, time in (("none", None), ("half", 0.5)):
    writer = vtkUnstructuredGridWriter()
    writer.SetInputData(make(1, time))
    writer.SetFileName(name + ".vtk")
    assert writer.Write()
gtn("pack", "none.vtk", "legacy.gtn")
assert not times_of("legacy.gtn")
gtn("unpack", "legacy.gtn", "legacy.vtu")
assert not read("legacy.vtu").GetFieldData().HasArray("TimeValue")
gtn("verify", "legacy.gtn", "none.vtk", says="identical")
gtn("pack", "-f", "half.vtk", "legacy.gtn")
gtn("unpack", "-f", "legacy.gtn", "legacy.vtu")
assert read("legacy.vtu").GetFieldData().GetArray("TimeValue").GetValue(0) == 0.5

# Meshes that change have orders of their own, also where their numbers of points and cells are the same.
order = np.random.default_rng(5).permutation(N)
back = np.argsort(order)
for step in range(3):
    shuffled = make_grid(points[order], back[tets], {"u": np.arange(N)[order] + 100. * step}) if step == 1 else \
        make(step)
    write(shuffled, f"shuffled{step}.vtu")
shuffled = [f"shuffled{step}.vtu" for step in range(3)]
pack("-q", *shuffled)
gtn("verify", "out.gtn", *shuffled, says="identical")
gtn("verify", "out.gtn", shuffled[0], shuffled[0], shuffled[2], code=1, says="at step 1")
