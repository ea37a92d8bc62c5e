# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Every class, method, function and parameter is documented, in stubs that mypy understands."""

import ast
import importlib
import importlib.util
import inspect
import os
import subprocess
import sys

import gatun
from gatun._build import modules
from gatunCube import find

FOLDER = os.path.dirname(gatun.__file__)


def parse(name):
    with open(os.path.join(FOLDER, name + ".pyi"), encoding="ascii") as file:
        return ast.parse(file.read())


def load_module(name):
    return importlib.import_module("gatun.vtk." + name)


# The functions of the package: each parameter has its line.
for name in gatun._members:
    member = getattr(gatun, name)
    text = inspect.getdoc(member)
    assert text and text.strip().endswith("."), name
    if inspect.isfunction(member):
        signature = inspect.signature(member)
        assert signature.return_annotation is not inspect.Signature.empty, name
        for parameter in signature.parameters.values():
            assert parameter.annotation is not inspect.Parameter.empty, (name, parameter)
            one = len(signature.parameters) == 1
            assert one or parameter.name in text, (name, parameter.name)

# The wrapped classes: all are in the stubs, with all of their methods, each with a text.
def names_of(stub):
    return {alias.asname for node in parse(stub).body if isinstance(node, ast.ImportFrom) for alias in node.names}


assert set(gatun._members) <= names_of("__init__")
package = names_of("vtk/__init__")
count = 0
for module in modules:
    stubs = {node.name: node for node in parse("vtk/" + module).body if isinstance(node, ast.ClassDef)}
    wrapped = [item for name, item in vars(load_module(module)).items() if name.startswith("vtk")]
    for cls in filter(inspect.isclass, wrapped):
        assert cls.__name__ in package, cls
        stub = stubs[cls.__name__]
        assert ast.get_docstring(stub), cls
        texts = {}
        for node in stub.body:
            if isinstance(node, ast.FunctionDef):
                texts[node.name] = texts.get(node.name) or ast.get_docstring(node)
        for name, item in vars(cls).items():
            if inspect.isroutine(item) and not name.startswith("_"):
                assert texts.get(name), f"{cls.__name__}.{name} has no documentation"
                assert "C++:" not in texts[name], (cls, name)
                count += 1
assert count > 500, count

# What VTK's docstrings leave out: methods of a group other than the first.
box = [node for node in ast.walk(parse("vtk/vtkGatunIO"))
       if isinstance(node, ast.FunctionDef) and node.name == "GetBox"]
assert ast.get_docstring(box[0]).startswith("Region of interest")
assert ast.unparse(box[0].returns) == "Tuple[" + ", ".join(["float"] * 6) + "]"

# mypy takes the right program, and finds what is wrong in the other one.
if not importlib.util.find_spec("mypy"):
    print("mypy is not installed; the stubs have been parsed only")
    sys.exit(0)
RIGHT = """\
import gatun
import numpy as np

mesh = gatun.read("a.gtn", arrays=["p"], step=-1)
size: int = gatun.write(mesh, "b.gtn", tolerances={"p": "rel:1e-3"}, times=[0.5])
image: np.ndarray = gatun.render("a.gtn", size=(3, 4), opacity=[0, 1], background="white")
reader = gatun.vtk.vtkGatunReader()
reader.SetFileName("a.gtn")
reader.SetBox(0, 1, 0, 1, 0, 1)
reader.SetBox((0, 1, 0, 1, 0, 1))
ratio: float = reader.GetSimplificationRatio()
mode: int = gatun.vtk.vtkGatunRayCaster.XRAY_BLEND
points: np.ndarray = gatun.to_numpy(mesh).cells_dict["tetra"]
times: list[float] = gatun.steps("a.gtn")
"""
WRONG = """\
import gatun
gatun.read("a.gtn", step="last")
gatun.read("a.gtn", box=3)
gatun.write(None, "b.gtn", error="rel:1e-3")
text: str = gatun.vtk.vtkGatunReader().GetSimplificationRatio()
gatun.vtk.vtkGatunReader().SetBox("a")
gatun.vtk.vtkGatunWriter().SetKeepOrder("all")
gatun.no_such_function()
"""


def check(program):
    path = find("program.py")
    with open(path, "w", encoding="ascii") as file:
        file.write(program)
    command = [sys.executable, "-m", "mypy", "--ignore-missing-imports", "--no-error-summary"]
    command += ["--cache-dir", find("cache"), path]
    environment = {**os.environ, "MYPYPATH": os.path.dirname(FOLDER)}
    result = subprocess.run(command, env=environment, stdout=subprocess.PIPE, text=True, check=False)
    return [line for line in result.stdout.splitlines() if " error: " in line]


assert check(RIGHT) == [], check(RIGHT)
errors = check(WRONG)
lines = {int(line.split("program.py:")[1].split(":")[0]) for line in errors}
assert lines == set(range(2, 9)), errors
