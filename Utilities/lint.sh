#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Checks the sources under version control:
#
#   Utilities/lint.sh          layout, as clang-format has it, and characters beyond ASCII
#   Utilities/lint.sh --fix    the same, repairing the layout
#   Utilities/lint.sh --tidy   also clang-tidy, on the sources that build/release compiles (slow)

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mapfile -t sources < <(git ls-files '*.h' '*.cxx' '*.txx')
failed=0

if [ "${1:-}" = --fix ]; then
  clang-format -i "${sources[@]}"
else
  clang-format --dry-run -Werror "${sources[@]}" || failed=1
fi

if git ls-files -z '*.h' '*.cxx' '*.txx' '*.cmake' '*.sh' '*.xml' '*CMakeLists.txt' |
  xargs -0 grep -nP '[^\x00-\x7F]'; then
  echo 'lint.sh: characters beyond ASCII' >&2
  failed=1
fi

if [ "${1:-}" = --tidy ]; then
  git ls-files '*.cxx' | while read -r source; do
    if grep -qF "$PWD/$source\"" build/release/compile_commands.json; then
      echo "$source"
    fi
  done | xargs -P "$(nproc)" -n 1 clang-tidy --quiet -p build/release || failed=1
fi

exit $failed
