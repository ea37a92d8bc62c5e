# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Images that gtn writes."""

import os
import subprocess

import gatunMeshes as gm
import gatunScenes as gs

LOOK = ["--size", f"{gs.SIZE}x{gs.SIZE}"]


def gtn(*arguments):
    subprocess.run([os.environ["GATUN_TEST_GTN"], *map(str, arguments)], check=True, timeout=120)


def render(name, *arguments, **options):
    reader = gs.ball_file(f"gtn-{name}", **options)
    image = gm.temporary(f"images-gtn-{name}.png")
    gtn("render", "-f", "-q", *LOOK, *arguments, reader.GetFileName(), image)
    return gs.read_png(image)[..., :3]


def GtnRender():
    """All defaults."""
    return render("plain")


def GtnRenderShaded():
    return render("shaded", "--shade", "--azimuth", 60, "--elevation", -20, "--background", "white")


def GtnRenderCoarse():
    """Two percent of the points."""
    return render("coarse", "--ratio", 0.98, Hierarchy=True)


def GtnContour():
    """The isosurface that gtn writes as a file of VTK."""
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    reader = gs.ball_file("gtn-contour")
    path = gm.temporary("images-gtn-contour.vtp")
    gtn("contour", "-f", "-q", "--value", 0.6, "--normals", reader.GetFileName(), path)
    surface = vtkXMLPolyDataReader()
    surface.SetFileName(path)
    view = gs.View()
    view.add_surface(surface, array="heat")
    return view.draw()


gs.run(globals())
