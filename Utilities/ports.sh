#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the core and libgatun for other systems, runs them by their emulators and compares what they read and write
# with what this system does: Utilities/setup.sh ports [aarch64|windows|wasm]... calls this with the folder to build
# in and the names of the systems. All bits must be the same; see Testing/Ports/portHashes.cxx and portLibrary.c.

set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$1
shift
jobs=${GATUN_JOBS:-$(nproc)}

say() {
  printf '== %s\n' "$*"
}

# Debian's libraries in sources, for which apt needs a list of its own: most systems have none of sources.
get_sources() {
  [ ! -f "$build/apt/done" ] || return 0
  say "Getting the sources of zstd and jsoncpp"
  local lists=$build/apt options name
  rm -rf "$lists"
  mkdir -p "$lists/state/partial" "$lists/cache"
  echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian" \
    "$(. /etc/os-release && echo "$VERSION_CODENAME") main" >"$lists/sources.list"
  options=(-qq -o "Dir::Etc::sourcelist=$lists/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$lists/state"
    -o "Dir::Cache=$lists/cache" -o "APT::Sandbox::User=$(id -un)")
  apt-get "${options[@]}" update
  (cd "$lists" && apt-get "${options[@]}" source --download-only libzstd libjsoncpp)
  for name in zstd jsoncpp; do
    mkdir -p "$build/$name"
    tar -x -C "$build/$name" --strip-components=1 -f "$(echo "$lists/lib$name"_*.orig.tar.?z)"
  done
  touch "$lists/done"
}

# The headers of this system that are all that is needed of their packages: the other systems must not see the rest.
copy_headers() {
  mkdir -p "$build/root/include" "$build/root/share/cmake"
  cp -rLu /usr/include/glm /usr/include/kissfft /usr/include/xxhash.h "$build/root/include"
  cp -rLu /usr/share/cmake/glm "$build/root/share/cmake"
}

# build_programs <system> <cmake argument>...
build_programs() {
  local system=$1 targets=(portFiles portHashes)
  shift
  [ "$system" = wasm ] || targets+=(portLibrary portSolver)
  say "Building $build/$system"
  # The output of CMake is of interest only if it fails.
  cmake -G Ninja -S "$root" -B "$build/$system" -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON \
    -DBUILD_SHARED_LIBS=OFF -DGATUN_BUILD_VTK=OFF -DGATUN_TEST_PORTS_ONLY=ON "$@" >"$build/$system.log" 2>&1 || {
    cat "$build/$system.log" >&2
    exit 1
  }
  cmake --build "$build/$system" --parallel "$jobs" --target "${targets[@]}"
}

# run <system> <program> <argument>...: in the folder of the system.
run() {
  local program=$build/$1/bin/$2 command
  case $1 in
    native) command=("$program") ;;
    aarch64) command=(qemu-aarch64 -L /usr/aarch64-linux-gnu "$program") ;;
    windows) command=(env "WINEPREFIX=$build/wine" WINEDEBUG=-all wine "$program.exe") ;;
    wasm) command=(node --no-experimental-fetch "$program.js") ;;
  esac
  (cd "$build/$1" && "${command[@]}" "${@:3}" | tr -d '\r')
}

# The numbers are grids that portHashes makes. There is no libgatun for the browser.
run_hashes() {
  local files=("$root"/Testing/Data/Golden/*.g[th]*)
  say "Reading and writing files on $1"
  run "$1" portHashes "${files[@]}" 6 20 >"$build/$1.txt"
  [ "$1" = wasm ] || run "$1" portLibrary "${files[@]}" >"$build/$1-library.txt"
}

# A program whose steps another run of it continues.
run_solver() {
  say "Running a solver on $1"
  rm -f "$build/$1/solver.gtn"
  run "$1" portSolver solver.gtn 3 >"$build/$1-solver.txt"
  run "$1" portSolver solver.gtn 2 >>"$build/$1-solver.txt"
}

# Only functions of gatun.h, and nothing needed but what each Windows has.
check_dll() {
  local dll=$build/windows/bin/gatun.dll needed exported
  needed=$(x86_64-w64-mingw32-objdump -p "$dll" | sed -n 's/.*DLL Name: //p' | sort -f | tr '\n' ' ')
  exported=$(x86_64-w64-mingw32-objdump -p "$dll" | sed -n '/Ordinal\/Name Pointer/,$p' | grep -c '\] ')
  [ "$(x86_64-w64-mingw32-objdump -p "$dll" | sed -n '/Ordinal\/Name Pointer/,$p' | grep '\] ' |
    grep -vc '\] gatun_')" = 0 ]
  say "gatun.dll has $exported functions and needs $needed"
  [ "$needed" = "KERNEL32.dll msvcrt.dll " ]
}

mkdir -p "$build"
get_sources
copy_headers
build_programs native
run_hashes native
run_solver native
for system; do
  arguments=(--toolchain "$root/CMake/Toolchains/$system.cmake" "-DCMAKE_FIND_ROOT_PATH=$build/root"
    "-DGATUN_ZSTD_SOURCE=$build/zstd" "-DGATUN_JSONCPP_SOURCE=$build/jsoncpp")
  if [ "$system" = wasm ]; then
    export NODE_PATH=${NODE_PATH:-/usr/share/nodejs} # for a node that is not Debian's
  elif [ "$system" = windows ]; then
    arguments+=(-DCMAKE_EXE_LINKER_FLAGS=-static -DCMAKE_SHARED_LINKER_FLAGS=-static)
  fi
  build_programs "$system" "${arguments[@]}"
  # Files of Emscripten are those of its own system, which knows no offsets beyond 4 GiB.
  [ "$system" = wasm ] || run "$system" portFiles
  run_hashes "$system"
  diff "$build/native.txt" "$build/$system.txt"
  say "The same on $system: $(wc -l <"$build/$system.txt") files"
  if [ "$system" != wasm ]; then
    run_solver "$system"
    diff "$build/native-library.txt" "$build/$system-library.txt"
    diff "$build/native-solver.txt" "$build/$system-solver.txt"
    say "The same by libgatun on $system: $(wc -l <"$build/$system-library.txt") files"
  fi
  [ "$system" != windows ] || check_dll
done
