#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Shows what Gatun does with FILE, a mesh that `gtn pack` takes, or with one that the demo makes:
#
#   Utilities/demo.sh [--size small|full] [--output FOLDER] [FILE]
#
# GATUN_BUILD names the build to use, GATUN_PYTHON the Python that VTK's modules are for. Files go to FOLDER.

set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${GATUN_BUILD:-$root/build/release}
modules=$(echo "$build"/lib*/python3*/*-packages)
export PYTHONPATH=$modules${PYTHONPATH:+:$PYTHONPATH} PYTHONDONTWRITEBYTECODE=1 PYTHONUNBUFFERED=1 GATUN_TEST_GTN=$build/bin/gtn
run=("${GATUN_PYTHON:-/usr/bin/python3}" "$root/Utilities/demo/demo.py" --output "$build/demo" "$@")
# Without -noreset the server restarts when its last client leaves, and refuses clients in that moment.
[ -n "${DISPLAY:-}" ] || run=(xvfb-run -a -s '-screen 0 1280x1024x24 -noreset' "${run[@]}")
exec "${run[@]}"
