#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Writes the type stubs (.pyi) of the wrapped modules and of the package:

    generate_stubs.py OUTPUT HEADERS...

OUTPUT is the folder of the package, which Python has to find as ``gatun``. HEADERS are the folders
of the C++ headers.

Signatures and texts are those of the docstrings, which VTK's wrapping makes of the headers. It gives
the comment of a group of methods, as of a Set and a Get method, to the first one only; the others
get it here, from the header. A method without a comment has that of the class it is inherited from.
"""

import ast
import importlib
import inspect
import pathlib
import re
import sys
import textwrap

import gatun
import gatun.vtk
from gatun._build import modules

HEAD = """\
# Made by generate_stubs.py from the wrapped classes.
# Overloads of VTK differ by types that are unknown where VTK itself has no stubs.
# mypy: disable-error-code="misc"
from typing import Any, Callable, MutableSequence, Sequence, Tuple, Union, overload
"""
PLAIN = {"int", "float", "str", "bool", "bytes", "None", "Any", "object"}
ALIASES = {"Callback": "Union[Callable[..., Any], None]"}
# What VTK's macro for types declares without a comment.
TYPE_TEXTS = {
    "SafeDownCast": "The object if it is one of this class, or else None.",
    "NewInstance": "A new object of the same class.",
}
PROPERTY = re.compile(r"\bvtk(?:Set|Get|Boolean)\w*Macro\((\w+)")
FUNCTION = re.compile(r"\b([A-Z]\w*)\(")


# ------------------------------------------------------------------------------
# Texts


def clean_comment(comment):
    """The text of a Doxygen comment."""
    lines = [re.sub(r"^\s*\* ?", "", line) for line in comment.strip().splitlines()]
    return textwrap.dedent("\n".join(lines)).strip()


def read_groups(header):
    """Texts by the name of the method or property, of the groups in a header."""
    texts = {}
    for group in re.findall(r"///@\{(.*?)///@\}", header, re.DOTALL):
        comment = re.search(r"/\*\*(.*?)\*/(.*)", group, re.DOTALL)
        if comment:
            text = clean_comment(comment[1])
            names = PROPERTY.findall(comment[2]) + FUNCTION.findall(comment[2])
            texts.update((name, text) for name in names)
    return texts


class Texts:
    """Texts of methods beyond those of their docstrings."""

    def __init__(self, folders):
        self._headers = {path.stem: path for folder in folders for path in folder.rglob("vtk*.h")}
        self._groups = {}

    def _find_group(self, cls, method):
        if cls.__name__ not in self._groups:
            header = self._headers.get(cls.__name__)
            self._groups[cls.__name__] = read_groups(header.read_text()) if header else {}
        groups = self._groups[cls.__name__]
        if method in groups:
            return groups[method]
        limit = re.fullmatch(r"Get(\w+)(Min|Max)Value", method)
        if limit:
            return f"{'Smallest' if limit[2] == 'Min' else 'Largest'} value that Set{limit[1]} takes."
        name = re.sub(r"^(Set|Get)|(On|Off)$", "", method)
        return groups.get(name)

    def find(self, cls, method, own):
        """The text of a method: its own, that of its group, or that of a superclass."""
        if own:
            return own
        for base in inspect.getmro(cls):
            inherited = base.__dict__.get(method)
            if inherited is None:
                continue
            text = split_docstring(method, inherited.__doc__ or "")[1]
            text = text or self._find_group(base, method)
            if text:
                return text
        return TYPE_TEXTS.get(method, "")


def split_docstring(name, docstring):
    """The signatures and the text in a docstring of VTK."""
    signatures, text = [], []
    kind = None
    for line in docstring.splitlines():
        if line.startswith(name + "("):
            kind = "signature"
            signatures.append(line)
        elif line.startswith("C++:"):
            kind = "c++"
        elif kind in ("signature", "c++") and line.startswith("    "):
            if kind == "signature":
                signatures[-1] += " " + line.strip()
        else:
            kind = None
            text.append(line)
    return signatures, re.sub(r"\n{3,}", "\n\n", "\n".join(text)).strip()


# ------------------------------------------------------------------------------
# Types


class Types:
    """Names of types in a module of stubs; collects the imports that they need."""

    def __init__(self, module):
        self._module = module
        self.imports = set()

    def name(self, cls):
        """The name of a class as it is written in this module."""
        if cls.__module__ in (self._module.__name__, "builtins"):
            return cls.__name__
        self.imports.add(cls.__module__)
        return f"{cls.__module__}.{cls.__name__}"

    def _find(self, name, scope):
        if name in PLAIN:
            return name
        if name in ALIASES:
            return ALIASES[name]
        nested = getattr(scope, name, None)
        if inspect.isclass(nested):
            return f"{self.name(scope)}.{name}"
        for module in [self._module, *sys.modules.values()]:
            if module.__name__.split(".")[0] in ("gatun", "vtkmodules"):
                found = vars(module).get(name)
                if inspect.isclass(found) and found.__name__ == name:
                    return self.name(found)
        return "Any"

    def translate(self, node, scope, is_result):
        """The annotation for one of VTK's, where (int, int) is a pair and [int, int] is changed."""
        if node is None:
            return "Any"
        if isinstance(node, (ast.Tuple, ast.List)):
            parts = [self.translate(part, scope, is_result) for part in node.elts]
            if isinstance(node, ast.List):
                return f"MutableSequence[{parts[0] if parts else 'Any'}]"
            return f"Tuple[{', '.join(parts)}]" if is_result else f"Sequence[{parts[0]}]"
        if isinstance(node, ast.Constant) and node.value is None:
            return "None"
        if isinstance(node, ast.Name):
            return self._find(node.id, scope)
        if isinstance(node, ast.Attribute):
            return self._find(node.attr, getattr(scope, getattr(node.value, "id", ""), scope))
        return "Any"


# ------------------------------------------------------------------------------
# Stubs


def quote(text):
    """The lines of a docstring."""
    text = text.replace("\\", "\\\\").replace('"""', "'''")
    return ['"""' + text + ('"""' if "\n" not in text else '\n"""')]


def make_signature(signature, scope, types):
    """The line of a function, and whether it is static. None if it cannot be told."""
    try:
        function = ast.parse(f"def {signature}: ...").body[0]
    except SyntaxError:
        return None
    args, defaults = function.args.args, function.args.defaults
    static = not args or args[0].arg != "self"
    parts = [] if static else ["self"]
    first = len(args) - len(defaults)
    for i, arg in enumerate(args):
        if i >= len(parts) or static:
            kind = types.translate(arg.annotation, scope, False)
            # Names of arguments are no part of what VTK promises.
            name = arg.arg if arg.arg.startswith("__") else "__" + arg.arg.lstrip("_")
            parts.append(f"{name}: {kind}" + (" = ..." if i >= first else ""))
    result = types.translate(function.returns, scope, True)
    return f"def {function.name}({', '.join(parts)}) -> {result}:", static


def make_method(cls, name, method, types, texts):
    """The lines of a method, with its overloads."""
    signatures, own = split_docstring(name, method.__doc__ or "")
    made = [make_signature(signature, cls, types) for signature in signatures]
    made = list(dict.fromkeys(filter(None, made))) or [
        (f"def {name}(self, *args: Any) -> Any:", False)
    ]
    text = texts.find(cls, name, own)
    lines = []
    for i, (line, static) in enumerate(made):
        lines += ["@overload"] if len(made) > 1 else []
        lines += ["@staticmethod"] if static else []
        lines.append(line)
        body = quote(text) if text and i == 0 else []
        lines += textwrap.indent("\n".join([*body, "..."]), "    ").splitlines()
    return lines


def make_class(cls, types, texts):
    """The lines of a class."""
    bases = [types.name(base) for base in cls.__bases__ if base is not object]
    body = quote((cls.__doc__ or "").strip()) if cls.__doc__ else []
    members = list(cls.__dict__.items())
    for name, member in members:
        if inspect.isclass(member) and not name.startswith("_"):
            body += [f"class {name}(int): ..."]
    for name, member in members:
        if isinstance(member, int) and not name.startswith("_"):
            kind = type(member).__name__
            body.append(f"{name}: {kind}")
    for name, member in members:
        if inspect.isroutine(member) and not name.startswith("_"):
            body += make_method(cls, name, member, types, texts)
    body = body or ["..."]
    head = f"class {cls.__name__}({', '.join(bases)}):" if bases else f"class {cls.__name__}:"
    return [head, *textwrap.indent("\n".join(body), "    ").splitlines()]


def list_classes(module):
    """The classes of a module, each after its superclasses."""
    classes = [
        item
        for name, item in vars(module).items()
        if inspect.isclass(item) and item.__module__ == module.__name__ and name == item.__name__
    ]
    return sorted(classes, key=lambda cls: (len(inspect.getmro(cls)), cls.__name__))


def make_module(module, texts):
    """The text of the stub of a wrapped module."""
    types = Types(module)
    classes = [make_class(cls, types, texts) for cls in list_classes(module)]
    imports = "".join(f"import {name}\n" for name in sorted(types.imports))
    return "\n".join([HEAD + imports, *("\n".join(lines) + "\n" for lines in classes)])


def make_package():
    """The text of the stub of the package."""
    lines = [HEAD, *quote(gatun.__doc__.strip()), "", "from . import vtk as vtk", "__version__: str"]
    for name, module in sorted(gatun._members.items()):
        lines.append(f"from .{module} import {name} as {name}")
    return "\n".join(lines) + "\n"


def load_module(name):
    return importlib.import_module("gatun.vtk." + name)


def make_classes():
    """The text of the stub of the package of all classes."""
    lines = [HEAD, *quote(gatun.vtk.__doc__.strip()), ""]
    for name in modules:
        for cls in list_classes(load_module(name)):
            lines.append(f"from .{name} import {cls.__name__} as {cls.__name__}")
    return "\n".join(lines) + "\n"


def main():
    output = pathlib.Path(sys.argv[1])
    texts = Texts([pathlib.Path(folder) for folder in sys.argv[2:]])
    for name in modules:
        load_module(name)
    for name in modules:
        (output / "vtk" / f"{name}.pyi").write_text(make_module(load_module(name), texts))
    (output / "vtk" / "__init__.pyi").write_text(make_classes())
    (output / "__init__.pyi").write_text(make_package())


if __name__ == "__main__":
    main()
