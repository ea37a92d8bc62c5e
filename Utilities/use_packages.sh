#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs Gatun's Debian packages and uses each of them as a user would:
#
#   Utilities/use_packages.sh FOLDER
#
# FOLDER has the packages that `setup.sh package` made for this Debian. Meant for a system made for the
# purpose (clean_root.sh), because it installs and removes packages. Needs root.

set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
packages=$(realpath "${1:?the folder of the packages}")
export DEBIAN_FRONTEND=noninteractive

say() {
  printf '== %s\n' "$*"
}

die() {
  printf 'use_packages.sh: %s\n' "$*" >&2
  exit 1
}

# expect <text> <program> <argument>...: the program succeeds and prints the text.
expect() {
  local text=$1 printed
  shift
  printed=$("$@" 2>&1) || die "failed: $*: $printed"
  case $printed in
    *"$text"*) printf '%s: %s\n' "$*" "$text" ;;
    *) die "no \"$text\" from $*: $printed" ;;
  esac
}

install() {
  apt-get -qq -y -o Dpkg::Use-Pty=0 install --no-install-recommends "$@" >"$work/apt.log" 2>&1 || {
    tail -n 30 "$work/apt.log" >&2
    die "apt-get install $*"
  }
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -qq update

say "gatun: the program alone"
install man-db bash-completion zsh libglib2.0-bin desktop-file-utils shared-mime-info \
  "$packages"/libgatun0*.deb "$packages"/gatun-data_*.deb "$packages"/gatun_*.deb
if dpkg -s libtet1.5 >/dev/null 2>&1; then
  die "TetGen is there without gatun-tetgen"
fi
cat >surface.obj <<'OBJ'
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 2 3 4
f 3 1 4
OBJ
expect "" gtn pack surface.obj surface.gtn
expect "points           4" gtn info surface.gtn
expect "" gtn verify surface.gtn surface.obj
expect "libgtnTetGen.so" sh -c '! gtn mesh surface.obj mesh.gtn'

say "gatun-tetgen: tetrahedra"
install "$packages"/gatun-tetgen_*.deb
expect "" gtn mesh --max-volume 0.001 surface.obj mesh.vtu
expect "" gtn pack mesh.vtu mesh.gtn
expect "tetrahedra" gtn info mesh.gtn
expect "" gtn verify mesh.gtn mesh.vtu
expect "" gtn unpack mesh.gtn back.vtu
expect "" gtn verify mesh.gtn back.vtu

say "Manual pages and completion"
for page in gtn gtn-pack gtn-volume-render; do
  expect "SYNOPSIS" man -P cat "$page"
done
expect "complete -o default -F _gtn gtn" bash -c \
  '. /usr/share/bash-completion/bash_completion; { _completion_loader gtn || _comp_load gtn; } 2>/dev/null; complete -p gtn'
expect "_gtn" zsh -fc 'autoload -U compinit; compinit -u -D; echo $_comps[gtn]'

say "Types of files"
cp mesh.gtn mesh-without-extension
expect "application/x-gatun-mesh" gio info -a standard::content-type mesh.gtn
expect "application/x-gatun-mesh" gio info -a standard::content-type mesh-without-extension
expect "application-x-gatun-mesh" gio info -a standard::icon mesh.gtn

say "python3-gatun"
install "$packages"/python3-gatun_*.deb "$packages"/python3-gatun-tetgen_*.deb
cat >round_trip.py <<'PYTHON'
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from gatun import vtkGatunReader, vtkGatunTetrahedralize, vtkGatunWriter

source = vtkXMLUnstructuredGridReader()
source.SetFileName("mesh.vtu")
source.Update()
mesh = source.GetOutput()
values = vtkDoubleArray()
values.SetName("height")
for i in range(mesh.GetNumberOfPoints()):
    values.InsertNextValue(mesh.GetPoint(i)[2] / 3)
mesh.GetPointData().AddArray(values)

writer = vtkGatunWriter()
writer.SetFileName("values.gtn")
writer.SetInputData(mesh)
writer.SetKeepOrder(writer.KEEP_ALL)
assert writer.Write() == 1
reader = vtkGatunReader()
reader.SetFileName("values.gtn")
reader.Update()
copy = reader.GetOutput()
for name in ("GetPoints", "GetCells"):
    one, two = getattr(mesh, name)(), getattr(copy, name)()
    get = "GetData" if name == "GetPoints" else "GetConnectivityArray"
    assert numpy.array_equal(vtk_to_numpy(getattr(one, get)()), vtk_to_numpy(getattr(two, get)()))
assert numpy.array_equal(vtk_to_numpy(values), vtk_to_numpy(copy.GetPointData().GetArray("height")))
print("the same:", copy.GetNumberOfCells(), "cells")
PYTHON
expect "the same:" python3 round_trip.py
expect "PNG" sh -c 'gtn render --array height --size 320x240 values.gtn image.png && head -c 4 image.png'

say "libgatun-dev: Examples"
install cmake g++ make "$packages"/libgatun-dev_*.deb
cmake -S "$root/Examples" -B examples -DCMAKE_BUILD_TYPE=Release >cmake.log 2>&1 || {
  cat cmake.log >&2
  die "the examples cannot be configured"
}
cmake --build examples --target WriteArrays ReadMesh >build.log 2>&1 || {
  cat build.log >&2
  die "the examples do not compile"
}
expect "" examples/WriteArrays written.gtn
expect "4913 points, 24576 cells" examples/ReadMesh written.gtn
install "$packages"/gatun-tetgen-dev_*.deb
mkdir tetgen
cat >tetgen/CMakeLists.txt <<'CMAKE'
cmake_minimum_required(VERSION 3.22)
project(UseTetGen LANGUAGES C CXX)
find_package(Gatun REQUIRED COMPONENTS GatunIO GatunTetGen)
CMAKE
expect "" cmake -S tetgen -B tetgen/build

say "paraview-gatun"
# Python's ParaView and Python's VTK exclude each other.
install xvfb xauth libgl1-mesa-dri python3-paraview "$packages"/paraview-gatun_*.deb
expect "gatun-paraview.desktop" gio mime application/x-gatun-mesh
expect "gatun-paraview.desktop" gio mime application/x-gatun-volume
cat >draw.py <<'PYTHON'
from paraview.simple import *

reader = GatunReader(FileNames=["values.gtn"])
reader.UpdatePipeline()
view = CreateView("RenderView")
view.ViewSize = [320, 240]
shown = Show(reader, view)
shown.SetRepresentationType("Gatun Volume")
ColorBy(shown, ("POINTS", "height"))
Render(view)
SaveScreenshot("drawn.png", view)
print("cells:", reader.GetDataInformation().GetNumberOfCells())
PYTHON
plugins=/usr/share/gatun/paraview.plugins.xml
for program in pvpython pvbatch; do
  rm -f drawn.png
  expect "cells: " env PV_PLUGIN_CONFIG_FILE=$plugins xvfb-run -a -s '-screen 0 1280x1024x24 -noreset' \
    "$program" draw.py
  [ -s drawn.png ] || die "$program drew nothing"
done
# The window loads the plugin by itself, and shows what scripts print in a window of its own.
cat >window.py <<'PYTHON'
import os
from paraview import simple

with open("window.txt", "w", encoding="utf-8") as file:
    file.write(f"reader: {hasattr(simple, 'GatunReader')}\n")
os._exit(0)
PYTHON
timeout 300 xvfb-run -a -s '-screen 0 1280x1024x24 -noreset' paraview --script="$work/window.py" >window.log 2>&1 || {
  cat window.log >&2
  die "the window of ParaView ended with an error"
}
expect "reader: True" cat window.txt
say "All packages were used"
