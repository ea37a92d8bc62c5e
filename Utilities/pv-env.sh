#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs a program of the ParaView that setup.sh unpacked:
#
#   Utilities/pv-env.sh pvbatch script.py
#   Utilities/pv-env.sh mpirun --oversubscribe -np 2 pvbatch script.py
#
# GATUN_PLUGIN in its environment is the plugin to load. GATUN_BUILD_DIR and GATUN_PARAVIEW_PREFIX
# are as in setup.sh. Without arguments, the environment is printed for `eval`.

set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${GATUN_BUILD_DIR:-$root/build}
prefix=${GATUN_PARAVIEW_PREFIX:-$build/paraview-prefix}/usr

plugin=$(find "$build/paraview" "$build/release" -name Gatun.so -print -quit 2>/dev/null || true)
modules=${plugin:+${plugin%/lib/*}/lib/python3/dist-packages}

settings=(OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1)
if [ -d "$prefix" ]; then
  libraries=$(dirname "$(echo "$prefix"/lib/*/cmake)")
  modules=$prefix/lib/python3/dist-packages${modules:+:$modules}
  settings+=(
    "PATH=$prefix/bin:$PATH"
    "LD_LIBRARY_PATH=$libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}")
fi
if [ -n "$plugin" ]; then
  settings+=("GATUN_PLUGIN=$plugin")
fi
if [ -n "$modules" ]; then
  settings+=("PYTHONPATH=$modules${PYTHONPATH:+:$PYTHONPATH}")
fi

if [ $# -eq 0 ]; then
  for setting in "${settings[@]}"; do
    printf 'export %s=%q\n' "${setting%%=*}" "${setting#*=}"
  done
else
  exec env "${settings[@]}" "$@"
fi
