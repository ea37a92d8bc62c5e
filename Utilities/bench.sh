#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Measures Gatun and its peers; setup.sh bench calls it. GATUN_BUILD names the build to use, and
# arguments go to the benchmark program, such as --benchmark_filter=load.

set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${GATUN_BUILD:-$root/build/release}

"$build/bin/gatunBenchmarks" \
  --benchmark_out="$build/benchmarks.json" --benchmark_out_format=json "$@"
