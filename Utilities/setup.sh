#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Sets Gatun up on Debian 12, from a system with nothing installed, and runs it.
#
#   Utilities/setup.sh demo [FILE]   install what is needed, build, show what Gatun does (to FILE,
#                                    a mesh that VTK can read, or to one that the demo makes)
#   Utilities/setup.sh test          build for VTK and for ParaView, run the tests of both
#   Utilities/setup.sh bench [--quick] [FILE...]
#                                    build, measure against VTK's own files (with --quick: less),
#                                    with the meshes it makes and with FILEs; see bench.sh
#
# Packages are installed with apt-get, as root or through sudo. What is done already is not done
# again. From the environment:
#
#   GATUN_BUILD_DIR        where to build                       (build, next to the sources)
#   GATUN_PARAVIEW_PREFIX  where ParaView is unpacked           ($GATUN_BUILD_DIR/paraview-prefix)
#   GATUN_JOBS             how much to do at once               (as many as there are processors)
#   GATUN_NO_INSTALL       if set, packages are never installed (missing ones are an error)
#   GATUN_DATA_DIR         large meshes for tests and benchmarks (none: those tests are skipped)

set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${GATUN_BUILD_DIR:-$root/build}
jobs=${GATUN_JOBS:-$(nproc)}

packages_build=(
  cmake g++ libcli11-dev libfmt-dev libglm-dev libopenimageio-dev libtet1.5-dev
  libvtk9-dev libxxhash-dev libzstd-dev ninja-build pkg-config python3-numpy python3-vtk9)
packages_window=(libgl1-mesa-dri xauth xvfb)
packages_test=(libgtest-dev openimageio-tools python3-h5py python3-xxhash python3-zstandard)
packages_bench=(libzfp-dev python3-matplotlib)
# ParaView itself, its window's libraries, and what its Python side imports.
packages_paraview=(
  libqt5opengl5-dev libqt5svg5-dev libqt5x11extras5-dev mpi-default-bin paraview paraview-dev
  python3-mpi4py qtbase5-dev qtdeclarative5-dev qttools5-dev qtxmlpatterns5-dev-tools)

say() {
  printf '== %s\n' "$*"
}

die() {
  printf 'setup.sh: %s\n' "$*" >&2
  exit 1
}

usage() {
  sed -n '/^#   Utilities/,/^$/p' "${BASH_SOURCE[0]}" | sed 's/^# \{0,1\}//'
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    die "neither root nor sudo here; let somebody run: $*"
  fi
}

# Installs those of the packages named that are missing.
install_packages() {
  local missing=() package
  for package; do
    if [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
      missing+=("$package")
    fi
  done
  if [ ${#missing[@]} -eq 0 ]; then
    return 0
  fi
  if [ -n "${GATUN_NO_INSTALL:-}" ]; then
    die "missing packages: ${missing[*]}"
  fi
  say "Installing ${missing[*]}"
  # A plain `apt-get update` first: package lists may be missing, or too old to be of use.
  as_root apt-get -qq update
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get -qq -y -o Dpkg::Use-Pty=0 install --no-install-recommends "${missing[@]}" \
    </dev/null >"$build/apt.log" 2>&1 || {
    tail -n 30 "$build/apt.log" >&2
    die "apt-get failed; all it said is in $build/apt.log"
  }
}

# Sets $paraview to a folder with a complete ParaView, its CMake package and its Python modules.
#
# Debian's python3-paraview cannot be installed next to python3-vtk9, but ParaView's CMake package
# needs it: without it, the three packages of ParaView are unpacked into a folder of their own.
find_paraview() {
  local version stamp folder
  if [ "$(dpkg-query -W -f '${db:Status-Status}' python3-paraview 2>/dev/null)" = installed ]; then
    paraview=/usr
    return 0
  fi
  folder=${GATUN_PARAVIEW_PREFIX:-$build/paraview-prefix}
  paraview=$folder/usr
  version=$(dpkg-query -W -f '${Version}' paraview)
  stamp=$folder/version
  if [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$version" ]; then
    return 0
  fi
  say "Unpacking ParaView $version into $folder"
  mkdir -p "$folder/packages"
  (
    cd "$folder/packages"
    rm -f -- *.deb
    apt-get -qq -o APT::Sandbox::User="$(id -un)" download \
      "paraview=$version" "paraview-dev=$version" "python3-paraview=$version"
    for package in *.deb; do
      dpkg -x "$package" "$folder"
    done
  )
  rm -rf "$folder/packages"
  printf '%s\n' "$version" >"$stamp"
}

# build_tree <preset> <cmake argument>...
build_tree() {
  local preset=$1
  shift
  say "Building $build/$preset"
  # Configuring says a lot that helps nobody unless it fails.
  (cd "$root" && cmake --preset "$preset" -B "$build/$preset" "$@") >"$build/$preset.log" 2>&1 || {
    cat "$build/$preset.log" >&2
    die "cannot configure $build/$preset"
  }
  grep '^-- Gatun' "$build/$preset.log" || true
  cmake --build "$build/$preset" --parallel "$jobs"
}

build_vtk() {
  build_tree release "$@"
}

build_paraview() {
  local config
  config=$(echo "$paraview"/lib/*/cmake/paraview-*)
  [ -f "$config/paraview-config.cmake" ] || die "no ParaView for developers in $paraview"
  # ParaView's CMake package looks for its Python modules by running Python.
  PYTHONPATH=$paraview/lib/python3/dist-packages build_tree paraview "-DParaView_DIR=$config" "$@"
}

run_demo() {
  install_packages "${packages_build[@]}" "${packages_window[@]}"
  # An existing build keeps its tests; a new one goes without.
  if [ -f "$build/release/CMakeCache.txt" ]; then
    build_vtk
  else
    build_vtk -DGATUN_BUILD_TESTING=OFF
  fi
  GATUN_BUILD=$build/release exec "$root/Utilities/demo.sh" "$@"
}

run_test() {
  install_packages "${packages_build[@]}" "${packages_window[@]}" "${packages_test[@]}" \
    "${packages_paraview[@]}"
  find_paraview
  build_vtk -DGATUN_BUILD_TESTING=ON
  build_paraview -DGATUN_BUILD_TESTING=ON

  # One run of ctest over both trees, so that there is one summary.
  mkdir -p "$build/tests"
  cat >"$build/tests/CTestTestfile.cmake" <<END
subdirs("$build/release" "$build/paraview")
END
  say "Testing $build/release and $build/paraview"
  # Without -noreset the server starts anew whenever its last client leaves, and refuses whoever
  # comes in that moment.
  exec xvfb-run -a -s '-screen 0 1280x1024x24 -noreset' \
    ctest --test-dir "$build/tests" --output-on-failure --no-label-summary --parallel "$jobs"
}

run_bench() {
  install_packages "${packages_build[@]}" "${packages_window[@]}" "${packages_bench[@]}"
  if [ -f "$build/release/CMakeCache.txt" ]; then
    build_vtk -DGATUN_BUILD_BENCHMARKS=ON
  else
    build_vtk -DGATUN_BUILD_BENCHMARKS=ON -DGATUN_BUILD_TESTING=OFF
  fi
  GATUN_BUILD=$build/release exec "$root/Utilities/bench.sh" "$@"
}

command=${1:-}
case $command in
  demo | test | bench)
    shift
    command -v apt-get >/dev/null || die "this needs Debian or a system like it (apt-get)"
    mkdir -p "$build"
    "run_$command" "$@"
    ;;
  -h | --help)
    usage
    ;;
  *)
    usage >&2
    exit 2
    ;;
esac
