#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds and runs Gatun on Debian 12, 13 or testing, from a system with nothing installed.
#
#   Utilities/setup.sh demo [FILE]   install what is needed, build, show what Gatun does (to FILE,
#                                    a mesh that VTK can read, or to a mesh that the demo makes)
#   Utilities/setup.sh test [--all] [CTEST-ARGUMENT...]
#                                    build for VTK and for ParaView, run the tests of both; with --all
#                                    everything that a release needs: clang-tidy, benchmarks, long tests,
#                                    tests of packages, and all tests with sanitizers
#   Utilities/setup.sh package       make Debian packages of both builds in build/packages, and check them
#                                    with lintian
#   Utilities/setup.sh wheel         make a wheel of the Python package with libgatun, which needs no VTK, in
#                                    build/dist, and test it; see wheel.py
#   Utilities/setup.sh docs          write the pages of the headers, build/release/doxygen/html
#   Utilities/setup.sh lint [--tidy] check layout and includes; with --tidy also run clang-tidy; the
#                                    sources follow clang 14, that of Debian 12
#   Utilities/setup.sh bench [--quick] [--pages]
#                                    build, measure beside VTK and other peers, and write the pages (with
#                                    --quick: tiny meshes, to build/bench-quick; with --pages: measure
#                                    nothing, write the pages again)
#   Utilities/setup.sh ports [SYSTEM...]
#                                    build the core for aarch64, windows and wasm (default: all), run it by
#                                    emulators, and compare what it reads and writes with this system
#   Utilities/setup.sh soak [MINUTES]
#                                    build with sanitizers, fuzz, read damaged files and kill writers
#                                    (default: 120); see soak.py
#
# Packages are installed with apt-get, as root or through sudo. Steps already done are skipped.
# Variables of the environment:
#
#   GATUN_BUILD_DIR        where to build                       (build, next to the sources)
#   GATUN_PARAVIEW_PREFIX  where ParaView is unpacked           ($GATUN_BUILD_DIR/paraview-prefix)
#   GATUN_JOBS             number of parallel jobs              (number of processors)
#   GATUN_NO_INSTALL       if set, packages are never installed (missing ones are an error)
#   GATUN_JSONCPP_SOURCE   where jsoncpp's sources are, for a wheel      (those of Debian, unpacked in build)
#   GATUN_DATA_DIR, GATUN_CELLS_DIR
#                          large meshes for tests and benchmarks (none: those tests are skipped)
#   CI                     true: compiler warnings are errors, and `test` also runs the tests of all that
#                          parses files with AddressSanitizer and UndefinedBehaviorSanitizer

set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${GATUN_BUILD_DIR:-$root/build}
jobs=${GATUN_JOBS:-$(nproc)}
in_ci=OFF
if [ "${CI:-}" = true ]; then
  in_ci=ON
fi
launcher=() # of the compiler

packages_build=(
  cmake g++ libcli11-dev libfmt-dev libglm-dev libjsoncpp-dev libkissfft-dev libopenimageio-dev
  libtet1.5-dev libvtk9-dev libx11-dev libxxhash-dev libzstd-dev ninja-build pkg-config python3-numpy python3-vtk9)
packages_window=(libgl1-mesa-dri xauth xvfb)
packages_test=(
  desktop-file-utils doxygen gfortran git libglib2.0-bin libgtest-dev man-db mypy openimageio-tools openssl python3-h5py
  python3-meshio python3-xxhash python3-zstandard shared-mime-info zsh)
packages_ci=(ccache)
packages_bench=(draco libmeshoptimizer-dev libzfp-dev openctm-tools python3-matplotlib)
packages_soak=(clang libclang-rt-dev libgtest-dev)
packages_package=(dpkg-dev lintian)
packages_ports=(cmake g++ libglm-dev libjsoncpp-dev libkissfft-dev libxxhash-dev libzstd-dev ninja-build)
packages_aarch64=(g++-aarch64-linux-gnu qemu-user)
packages_windows=(g++-mingw-w64-x86-64-posix wine64 wine)
packages_wasm=(emscripten)
packages_wheel=(
  binutils cmake dpkg-dev g++ libglm-dev libkissfft-dev libxxhash-dev libzstd-dev ninja-build python3-numpy python3-venv)
packages_docs=(doxygen)
packages_lint=(clang-format clang-tidy git python3)
# ParaView itself, the imports of its Python modules, and what its plugins need to write their help.
packages_paraview=(mpi-default-bin paraview paraview-dev python3-mpi4py)
if [ "$(. /etc/os-release && echo "${VERSION_CODENAME:-}")" = bookworm ]; then
  packages_paraview+=(qttools5-dev qtxmlpatterns5-dev-tools)
else
  packages_paraview+=(qt6-tools-dev xsltproc)
fi

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
  run_apt install "${missing[@]}"
}

# run_apt install|build-dep <argument>...
run_apt() {
  # A plain `apt-get update` first: package lists may be missing, or too old to be of use.
  as_root apt-get -qq update
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get -qq -y --no-install-recommends -o Dpkg::Use-Pty=0 "$@" </dev/null >"$build/apt.log" 2>&1 || {
    tail -n 30 "$build/apt.log" >&2
    die "apt-get failed; all it said is in $build/apt.log"
  }
}

# Prints the paths of Python modules below a folder that carry the version of Python.
find_versioned_modules() {
  find "$1" -name '*.cpython-*.so' 2>/dev/null || true
}

# Sets $paraview to a folder with a complete ParaView, its CMake package and its Python modules.
#
# In Debian 12 and 13, python3-paraview cannot be installed next to python3-vtk9, but ParaView's CMake
# package needs it. Without it, the three packages of ParaView are unpacked into a separate folder.
#
# From Debian 13 on, ParaView's CMake package names Python modules <module>.so, but the files are called
# <module>.cpython-<version>-<platform>.so. Links in the separate folder make up for that.
find_paraview() {
  local version stamp folder module
  if [ "$(dpkg-query -W -f '${db:Status-Status}' python3-paraview 2>/dev/null)" = installed ] &&
    [ -z "$(find_versioned_modules /usr/lib/python3/dist-packages/paraview)" ]; then
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
  find_versioned_modules "$paraview/lib/python3/dist-packages" | while read -r module; do
    ln -sf "${module##*/}" "${module%%.cpython-*}.so"
  done
  rm -rf "$folder/packages"
  printf '%s\n' "$version" >"$stamp"
}

# configure_tree <preset> <cmake argument>...
#
# The Python is Debian's, which the VTK and ParaView of Debian belong to; the first one in PATH may
# be another.
configure_tree() {
  local preset=$1
  shift
  # The output of CMake is of interest only if it fails.
  (cd "$root" && cmake --preset "$preset" -B "$build/$preset" -DPython3_EXECUTABLE=/usr/bin/python3 \
    -DCMAKE_UNITY_BUILD=ON "-DGATUN_WARNINGS_AS_ERRORS=$in_ci" "${launcher[@]}" "$@") >"$build/$preset.log" 2>&1 || {
    cat "$build/$preset.log" >&2
    die "cannot configure $build/$preset"
  }
  grep '^-- Gatun' "$build/$preset.log" || true
}

# build_tree <preset> <cmake argument>...
build_tree() {
  say "Building $build/$1"
  configure_tree "$@"
  cmake --build "$build/$1" --parallel "$jobs"
}

build_vtk() {
  build_tree release "$@"
}

# Sets $tests to options of CMake for a tree: one that is there keeps its tests; a new one goes without.
keep_tests() {
  tests=()
  [ -f "$build/$1/CMakeCache.txt" ] || tests=(-DGATUN_BUILD_TESTING=OFF)
}

# build_both <cmake argument>...: the trees for VTK and for ParaView, which it adds to $trees. A ParaView that
# uses the VTK of the system shares its tree.
build_both() {
  local config
  config=$(echo "$paraview"/lib/*/cmake/paraview-*)
  [ -f "$config/paraview-config.cmake" ] || die "no ParaView for developers in $paraview"
  trees+=(release)
  if [ -d "$config/vtk" ]; then
    build_vtk "$@"
    trees+=(paraview)
  fi
  # ParaView's CMake package looks for its Python modules by running Python.
  PYTHONPATH=$paraview/lib/python3/dist-packages build_tree "${trees[-1]}" "-DParaView_DIR=$config" \
    -DGATUN_BUILD_PARAVIEW_PLUGIN=ON "$@"
}

run_demo() {
  install_packages "${packages_build[@]}" "${packages_window[@]}"
  keep_tests release
  build_vtk "${tests[@]}"
  GATUN_BUILD=$build/release exec "$root/Utilities/demo.sh" "$@"
}

# The core is the same code for VTK and for ParaView: it is compiled once for both.
use_ccache() {
  install_packages "${packages_ci[@]}"
  export CCACHE_DIR=${CCACHE_DIR:-$build/ccache} CCACHE_BASEDIR=${CCACHE_BASEDIR:-$root} CCACHE_NOHASHDIR=1
  launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
}

run_test() {
  local trees=() all=OFF selection=(-LE '^(long|package)$')
  if [ "${1:-}" = --all ]; then
    shift
    all=ON
    selection=()
    run_lint --tidy
    install_packages "${packages_bench[@]}"
  fi
  install_packages "${packages_build[@]}" "${packages_window[@]}" "${packages_test[@]}" \
    "${packages_paraview[@]}"
  if [ "$in_ci" = ON ]; then
    use_ccache
  fi
  find_paraview
  build_both -DGATUN_BUILD_TESTING=ON "-DGATUN_BUILD_BENCHMARKS=$all"
  if [ "$all" = ON ]; then
    build_tree asan-ubsan
  elif [ "$in_ci" = ON ]; then
    build_tree core-asan-ubsan -DGATUN_TEST_PARSERS_ONLY=ON
    trees+=(core-asan-ubsan)
  fi

  # One run of ctest over all trees, so that there is one summary.
  mkdir -p "$build/tests"
  printf 'subdirs("%s")\n' "${trees[@]/#/$build/}" >"$build/tests/CTestTestfile.cmake"
  say "Testing ${trees[*]} in $build"
  export ASAN_OPTIONS=strict_string_checks=1:detect_stack_use_after_return=1
  export LSAN_OPTIONS=suppressions=$root/Testing/lsan.supp:print_suppressions=0
  export UBSAN_OPTIONS=print_stacktrace=1
  # Without -noreset the server restarts when its last client leaves, and refuses clients that
  # connect in that moment.
  local ctest=(xvfb-run -a -s '-screen 0 1280x1024x24 -noreset'
    ctest --output-on-failure --no-label-summary --parallel "$jobs")
  "${ctest[@]}" --test-dir "$build/tests" "${selection[@]}" "$@"
  if [ "$all" = ON ]; then
    (cd "$root" && "${ctest[@]}" --preset asan-ubsan --test-dir "$build/asan-ubsan" "$@")
  fi
}

# Prints name, version, architecture, size and summary of packages.
list_packages() {
  local file
  for file; do
    printf '%s (%d KiB): %s\n' "${file#"$root"/}" "$(($(stat -c %s "$file") / 1024))" \
      "$(dpkg-deb --showformat '${Description}\n' --show "$file" | head -n 1)"
  done
}

run_package() {
  local folder=$build/packages source=$build/package/gatun missing
  install_packages "${packages_package[@]}"
  if ! missing=$(dpkg-checkbuilddeps "$root/debian/control" 2>&1); then
    [ -z "${GATUN_NO_INSTALL:-}" ] || die "$missing"
    say "Installing build dependencies"
    run_apt build-dep "$root"
  fi
  # In a copy, because dpkg-buildpackage writes into the sources and the folder above them.
  rm -rf "$folder" "$build/package"
  mkdir -p "$folder" "$source"
  tar -C "$root" --exclude=./build --exclude=./.git -c . | tar -C "$source" -x
  # The packages of a later Debian replace those of an earlier one.
  sed -i "1s/)/~deb$(. /etc/os-release && echo "${VERSION_ID:-$VERSION_CODENAME}"))/" "$source/debian/changelog"
  say "Building in $source"
  # Debug information would be stripped, as packages of it are not made.
  (cd "$source" && DEB_BUILD_OPTIONS="parallel=$jobs noautodbgsym" DEB_CXXFLAGS_STRIP=-g \
    dpkg-buildpackage -us -uc -b) >"$build/package.log" 2>&1 || {
    tail -n 50 "$build/package.log" >&2
    die "dpkg-buildpackage failed; all it said is in $build/package.log"
  }
  mv "$build/package"/*.deb "$folder"
  say "Checking with lintian"
  lintian --allow-root --fail-on error,warning "$folder"/*.deb
  say "Packages:"
  list_packages "$folder"/*.deb
  printf 'Install them: apt-get install %s/*.deb\n' "$folder"
}

# Sets $jsoncpp to a folder with the sources of jsoncpp, of which Debian has no static library.
find_jsoncpp() {
  jsoncpp=${GATUN_JSONCPP_SOURCE:-}
  if [ -n "$jsoncpp" ]; then
    return 0
  fi
  local folder=$build/sources file apt=()
  jsoncpp=$folder/jsoncpp
  if [ -f "$jsoncpp/include/json/json.h" ]; then
    return 0
  fi
  say "Unpacking the sources of jsoncpp into $jsoncpp"
  # The same places as for packages, of sources.
  mkdir -p "$folder/parts" "$folder/lists/partial"
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
    if [ -f "$file" ]; then
      sed -E 's/^Types:.*/Types: deb-src/; s/^deb /deb-src /' "$file" >"$folder/parts/${file##*/}"
    fi
  done
  apt=(apt-get -qq -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$folder/parts"
    -o "Dir::State::lists=$folder/lists" -o APT::Sandbox::User="$(id -un)")
  (
    cd "$folder"
    "${apt[@]}" update
    "${apt[@]}" source libjsoncpp
    mv libjsoncpp-*/ jsoncpp
  ) >"$build/apt.log" 2>&1 || {
    tail -n 30 "$build/apt.log" >&2
    die "apt-get failed; all it said is in $build/apt.log"
  }
}

run_wheel() {
  install_packages "${packages_wheel[@]}"
  find_jsoncpp
  say "Building $build/wheel"
  # Nothing but the C library is needed at run time. A static libgcc would need a later one.
  (cd "$root" && cmake -G Ninja -S . -B "$build/wheel" -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON \
    -DGATUN_BUILD_VTK=OFF -DGATUN_BUILD_TESTING=OFF "-Dzstd_DIR=$root/CMake/static" \
    "-DGATUN_JSONCPP_SOURCE=$jsoncpp" "-DCMAKE_SHARED_LINKER_FLAGS=-static-libstdc++ -shared-libgcc") \
    >"$build/wheel.log" 2>&1 || {
    cat "$build/wheel.log" >&2
    die "cannot configure $build/wheel"
  }
  cmake --build "$build/wheel" --parallel "$jobs" --target gatun
  say "Making the wheel"
  rm -rf "$build/dist"
  "$root/Utilities/wheel.py" "$build/wheel/lib/libgatun.so" "$build/dist"
  say "Testing it"
  /usr/bin/python3 -B "$root/Testing/Package/TestWheel.py" "$build/dist"/*.whl
}

run_docs() {
  install_packages "${packages_build[@]}" "${packages_docs[@]}"
  say "Writing pages of the headers"
  configure_tree release
  cmake --build "$build/release" --target doxygen
  printf '%s\n' "$build/release/doxygen/html/index.html"
}

run_lint() {
  install_packages "${packages_lint[@]}" "${packages_build[@]}" "${packages_test[@]}"
  say "Checking layout, includes and archives"
  "$root/Utilities/lint.sh"
  if [ "${1:-}" != --tidy ]; then
    return
  fi
  # clang-tidy needs the compiler's options and the headers that CMake writes, but no build.
  configure_tree dev -DGATUN_BUILD_TESTING=ON -DCMAKE_UNITY_BUILD=OFF
  say "Running clang-tidy"
  GATUN_BUILD=$build/dev GATUN_JOBS=$jobs "$root/Utilities/lint.sh" --tidy
}

run_bench() {
  install_packages "${packages_build[@]}" "${packages_window[@]}" "${packages_bench[@]}"
  # Debian's Python has matplotlib.
  local report=(/usr/bin/python3 -B "$root/Benchmarks/report.py" --programs "$build/release/bin")
  if [[ " $* " == *" --quick "* ]]; then
    report+=(--out "$build/bench-quick")
  fi
  if [[ " $* " != *" --pages "* ]]; then
    keep_tests release
    build_vtk -DGATUN_BUILD_BENCHMARKS=ON "${tests[@]}"
  fi
  exec "${report[@]}" "$@"
}

# build_targets <preset> <target>...
build_targets() {
  local preset=$1
  shift
  say "Building $* in $build/$preset"
  configure_tree "$preset"
  cmake --build "$build/$preset" --parallel "$jobs" --target "$@"
}

run_ports() {
  local system packages=("${packages_ports[@]}")
  if [ $# -eq 0 ]; then
    set -- aarch64 windows wasm
  fi
  for system; do
    case $system in
      aarch64) packages+=("${packages_aarch64[@]}") ;;
      windows) packages+=("${packages_windows[@]}") ;;
      wasm) packages+=("${packages_wasm[@]}") ;;
      *) die "there is no port to $system" ;;
    esac
  done
  install_packages "${packages[@]}"
  exec "$root/Utilities/ports.sh" "$build/ports" "$@"
}

run_soak() {
  install_packages "${packages_build[@]}" "${packages_window[@]}" "${packages_soak[@]}"
  build_targets fuzz fuzzers
  build_targets asan-ubsan gtn damageFile
  exec xvfb-run -a -s '-screen 0 1280x1024x24 -noreset' \
    /usr/bin/python3 -B "$root/Utilities/soak.py" --build "$build" "$@"
}

command=${1:-}
case $command in
  demo | test | package | wheel | docs | lint | bench | ports | soak)
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
