# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files with wrong boundaries: gtn verify and the decoder written from the specification refuse the
same ones, and a reader on demand fails with a message or gives something, whatever is damaged."""

import os
import subprocess
import sys

import gatunGolden as golden

try:
    import gtn_hostile as hostile
except ImportError as error:
    print(error)
    sys.exit(golden.gm.SKIPPED)

from gatun.vtk import vtkGatunReader
from gatunGoldenCells import boundary as make_tet
from gtn_boundary import check_boundary
from gtn_bytes import FormatError
from gtn_decoder import Decoder
from vtkmodules.vtkCommonCore import vtkObject

folder = os.path.join(os.environ["GATUN_TEST_TEMP"], "hostile-boundaries")
os.makedirs(folder, exist_ok=True)
path = os.path.join(folder, "hostile.gtn")
vtkObject.GlobalWarningDisplayOff()


def gtn_refuses(data):
    """Why gtn verify fails with these bytes, or nothing."""
    with open(path, "wb") as file:
        file.write(data)
    run = subprocess.run([os.environ["GATUN_TEST_GTN"], "verify", path], stdout=subprocess.PIPE,
                         stderr=subprocess.PIPE, universal_newlines=True, check=False, timeout=60)
    assert run.returncode == (1 if run.stderr else 0), (run.returncode, run.stderr)
    return run.stderr


def decoder_refuses(data):
    try:
        decoder = Decoder(data)
        boundary = decoder.boundary()
        if boundary is not None:
            check_boundary(decoder, boundary)
    except FormatError as error:
        return str(error)
    return ""


def read_on_demand(data):
    with open(path, "wb") as file:
        file.write(data)
    reader = vtkGatunReader()
    reader.SetFileName(path)
    reader.SetLargeMesh(0)
    reader.Update()
    return reader


def boundary_of(data):
    return dict(hostile.sections_of(data))[b"BNDY"]


def with_boundary(data, boundary):
    return hostile.build(
        hostile.replace_sections(hostile.sections_of(data), b"BNDY", lambda _: boundary))


tet, steps = golden.bytes_of("boundary.gtn"), golden.bytes_of("boundary_of_cells.gtn")
surface = golden.bytes_of("two_faces.gtn")
other = make_tet(None)[0]
other.GetPoints().SetPoint(3, 0, 0, 2)
golden.gm.write(other, path, WriteBoundary=True)
with open(path, "rb") as file:
    other = file.read()
right = with_boundary(tet, boundary_of(tet))
assert not gtn_refuses(right) and not decoder_refuses(right)

wrong = {
    "other faces": with_boundary(tet, boundary_of(other)),
    "more points": with_boundary(tet, surface),
    "not a file": with_boundary(tet, b"nothing at all"),
    "nothing": with_boundary(tet, b""),
    "a grid": with_boundary(tet, tet),
    "other arrays": with_boundary(tet, boundary_of(steps)),
    "two": hostile.build(hostile.sections_of(right) + [(b"BNDY", boundary_of(tet))]),
    "of a surface": hostile.build(hostile.sections_of(surface) + [(b"BNDY", boundary_of(tet))]),
    "cut short": with_boundary(tet, boundary_of(tet)[:-1]),
}
for name, data in wrong.items():
    assert gtn_refuses(data), name
    assert decoder_refuses(data), name
    reader = read_on_demand(data)
    assert (reader.GetErrorCode() != 0) == (name != "other faces"), name

# The mesh is there for those who do not look at the boundary.
reader = read_on_demand(wrong["not a file"])
reader.SetLargeMesh(-1)
reader.Update()
assert reader.GetErrorCode() == 0 and reader.GetOutput().GetNumberOfCells() == 1

# Any other bytes in the boundary, with right checksums around it.
boundary = boundary_of(tet)
for at in range(len(boundary)):
    data = with_boundary(tet, boundary[:at] + bytes([boundary[at] ^ 1 << at % 8]) + boundary[at + 1 :])
    reader = read_on_demand(data)
    # Not all that gtn verify reads is needed to show it.
    cells = reader.GetOutput().GetNumberOfCells()
    assert cells == (4 if reader.GetErrorCode() == 0 else 0), at
    assert at % 16 != 0 or gtn_refuses(data), at
