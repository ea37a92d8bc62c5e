#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Measures Gatun and its peers; setup.sh bench calls it. GATUN_BUILD names the build to use.
#
#   bench.sh [FILE...]           all of it, in about half an hour, into Documentation/studies/: the page
#                                benchmarks.md, its pictures and figures in the folder benchmarks/
#   bench.sh --quick [FILE...]   small meshes, some minutes, into bench-quick/ of the build
#   bench.sh --report            nothing is measured, the page is made anew
#   bench.sh --study             the dissertation's study of rendering, in a quarter of an hour,
#                                into Documentation/studies/rendering-study.md and rendering-study/; may be
#                                followed by --quick or --report
#   bench.sh --simplification    the study of simplification, in half an hour, into
#                                Documentation/studies/simplification-study.md and simplification-study/;
#                                likewise
#   bench.sh --budget            how well just-in-time rendering keeps to a time, in ten minutes, into
#                                Documentation/studies/just-in-time.md and just-in-time/; as --study
#   bench.sh --isosurfaces       the study of isosurfaces, in a quarter of an hour, into
#                                Documentation/studies/isosurface-study.md and isosurface-study/; as --study
#   bench.sh --volumes           the study of regular volumes, in three quarters of an hour, into
#                                Documentation/studies/volume-study.md and volume-study/; as --study
#
# FILEs are meshes to be measured too. GATUN_DATA_DIR names a folder of more of them, if set: sizes
# of every .vtu and Exodus file there are told, and the blunt fin and the combustion chamber are
# rendered. A page that may be quoted wants a machine with nothing else to do.

set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${GATUN_BUILD:-$root/build/release}

script=runBenchmarks.py
if [ "${1:-}" = --study ]; then
  script=runStudy.py
  shift
elif [ "${1:-}" = --simplification ]; then
  script=runSimplification.py
  shift
elif [ "${1:-}" = --budget ]; then
  script=runBudget.py
  shift
elif [ "${1:-}" = --isosurfaces ]; then
  script=runIsosurfaces.py
  shift
elif [ "${1:-}" = --volumes ]; then
  script=runVolumes.py
  shift
fi
out=$root/Documentation/studies
for argument; do
  if [ "$argument" = --quick ]; then
    out=$build/bench-quick
  fi
done

# Debian's Python, which has matplotlib.
PYTHONDONTWRITEBYTECODE=1 exec /usr/bin/python3 "$root/Benchmarks/Studies/$script" \
  --programs "$build/bin" --out "$out" "$@"
