#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Shows what Gatun does; setup.sh demo calls it.
#
#   Utilities/demo.sh [--size small|full] [--output FOLDER] [FILE]
#
# FILE is a mesh that VTK can read; without it the demo makes one. GATUN_BUILD names the build to
# use, GATUN_PYTHON the Python that VTK's modules are for. Pictures and files go to FOLDER, or else
# to the folder demo of the build.

set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${GATUN_BUILD:-$root/build/release}
python=${GATUN_PYTHON:-/usr/bin/python3}

modules=$(echo "$build"/lib*/python3*/*-packages)
export PYTHONPATH=$modules${PYTHONPATH:+:$PYTHONPATH}
export PYTHONDONTWRITEBYTECODE=1
export GATUN_TEST_GTN=$build/bin/gtn

run=("$python" "$root/Utilities/demo/demo.py" --output "$build/demo" "$@")
if [ -z "${DISPLAY:-}" ]; then
  # Without -noreset the server starts anew whenever its last client leaves, and refuses whoever
  # comes in that moment.
  run=(xvfb-run -a -s '-screen 0 1280x1024x24 -noreset' "${run[@]}")
fi
exec "${run[@]}"
