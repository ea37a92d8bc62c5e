#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Measures Gatun and its peers. setup.sh bench calls it. GATUN_BUILD names the build to use.
#
#   bench.sh [FILE...]           the benchmarks, about half an hour; writes benchmarks.md
#   bench.sh --readme            the table of README.md, a few minutes; writes summary.md and the table
#   bench.sh --speed             the goals of speed and memory, 15 minutes; writes speed.md
#   bench.sh --cells             cells of all types, 10 minutes; writes cells-study.md
#   bench.sh --parts             meshes larger than memory, 20 minutes; writes parts-study.md
#   bench.sh --parallel          several processes write one file, 5 minutes; writes parallel-study.md
#   bench.sh --scaling           tables and messages, and a model of large runs, 5 minutes; writes scaling.md
#   bench.sh --study             the rendering study, about 40 minutes; writes rendering-study.md
#   bench.sh --budget            the just-in-time study, 6 minutes; writes just-in-time-study.md
#   bench.sh --detail            view-dependent simplification, 10 minutes; writes detail-study.md
#   bench.sh --simplification    the simplification study, 30 minutes; writes simplification-study.md
#   bench.sh --isosurfaces       the isosurface study, 6 minutes; writes isosurface-study.md
#   bench.sh --surfaces          files of surfaces beside peers, and frames, 10 minutes; writes
#                                surface-study.md; with --large also files of 10 million triangles;
#                                with --motion only the frames
#   bench.sh --volumes           the volume study, 45 minutes; writes volume-study.md
#   bench.sh --errors            bits a value of arrays with bounded errors, 5 minutes; writes
#                                errors-study.md; --sz3 PREFIX names the folder where SZ3 is installed
#   bench.sh --series            time series beside a .vtu file for each step, 10 minutes; writes
#                                series-study.md
#   bench.sh --client            ParaView's window beside .vtu files, 15 minutes; needs the ParaView build;
#                                writes client-study.md
#   bench.sh --pages             measures nothing and writes all pages again from their results
#
# Pages are written to Documentation/studies, their plots and results to a folder of the same name.
# Each of these but the last may be followed by
#
#   --quick     small data, some minutes; writes to bench-quick/ of the build instead
#   --report    measures nothing and writes the page and its plots again
#
# FILEs are further meshes to measure. If GATUN_DATA_DIR names a folder, its meshes are measured, too:
# the sizes of every .vtu and Exodus file, and images of the blunt fin and the combustion chamber.
# A page that is to be quoted needs a machine without other load.

set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${GATUN_BUILD:-$root/build/release}

case ${1:-} in
  --readme) script=runSummary.py ;;
  --speed) script=runSpeed.py ;;
  --cells) script=runCells.py ;;
  --parts) script=runParts.py ;;
  --parallel) script=runParallel.py ;;
  --scaling) script=runScaling.py ;;
  --study) script=runStudy.py ;;
  --budget) script=runBudget.py ;;
  --detail) script=runDetail.py ;;
  --simplification) script=runSimplification.py ;;
  --isosurfaces) script=runIsosurfaces.py ;;
  --surfaces) script=runSurfaces.py ;;
  --volumes) script=runVolumes.py ;;
  --errors) script=runErrors.py ;;
  --series) script=runSeries.py ;;
  --client) script=runClient.py ;;
  --pages) script=generatedParts.py ;;
  *) script=runBenchmarks.py ;;
esac
export PYTHONDONTWRITEBYTECODE=1
if [ "$script" = generatedParts.py ]; then
  exec /usr/bin/python3 "$root/Benchmarks/Studies/$script" --update
fi
if [ "$script" != runBenchmarks.py ]; then
  shift
fi
out=$root/Documentation/studies
for argument; do
  if [ "$argument" = --quick ]; then
    out=$build/bench-quick
  fi
done

# Debian's Python, which has matplotlib.
exec /usr/bin/python3 "$root/Benchmarks/Studies/$script" \
  --programs "$build/bin" --out "$out" "$@"
