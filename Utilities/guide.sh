#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Draws the pictures of the user guide again; setup.sh guide calls it. GATUN_BUILD names the VTK build,
# GATUN_PYTHON the Python that VTK's modules are for.
#
#   guide.sh             all pictures, into Documentation/images/guide
#   guide.sh figures     those of how-it-works.md
#   guide.sh session     the screenshots of paraview.md; needs the ParaView build
#   guide.sh gallery     those of gallery.md
#
# A second argument names another folder for the pictures.

set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${GATUN_BUILD:-$root/build/release}
python=${GATUN_PYTHON:-/usr/bin/python3}
what=${1:-all}
out=${2:-$root/Documentation/images/guide}

modules=$(echo "$build"/lib*/python3*/*-packages)
export PYTHONPATH=$modules${PYTHONPATH:+:$PYTHONPATH}
export PYTHONDONTWRITEBYTECODE=1
export GATUN_TEST_GTN=$build/bin/gtn

case $what in
  all) parts=(figures record gallery) ;;
  figures | gallery) parts=("$what") ;;
  session) parts=(record) ;;
  *)
    sed -n '/^#   guide/,/^# A/p' "${BASH_SOURCE[0]}" | sed 's/^# \{0,1\}//' >&2
    exit 2
    ;;
esac
for part in "${parts[@]}"; do
  "$python" "$root/Utilities/guide/$part.py" "$out"
done
