#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Checks the sources under version control:
#
#   Utilities/lint.sh          layout (clang-format), characters beyond ASCII, includes between
#                              folders, archives of fuzz inputs
#   Utilities/lint.sh --fix    the same, and repair the layout
#   Utilities/lint.sh --tidy   clang-tidy on the sources of the libraries and programs
#   Utilities/lint.sh --analyze
#                              clang-tidy's analyzer on the sources of the core
#
# clang-tidy takes the compiler's options from the build tree GATUN_BUILD (build/release), which must be
# configured without unity builds, and runs GATUN_JOBS processes (number of processors).

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Arguments: a pattern of folders, options of run-clang-tidy.
run_tidy() {
  local folders=$1
  shift
  run-clang-tidy -quiet -p "${GATUN_BUILD:-build/release}" -j "${GATUN_JOBS:-$(nproc)}" "$@" \
    "^$PWD/$folders/.*[.]cxx\$"
}

case ${1:-} in
  --tidy)
    run_tidy '(Module|IO|Filters|Rendering|Programs)'
    exit
    ;;
  --analyze)
    run_tidy Module "-checks=-*,clang-analyzer-*,-clang-analyzer-cplusplus.NewDeleteLeaks,\
-clang-analyzer-optin.cplusplus.VirtualCall,-clang-analyzer-optin.mpi.*"
    exit
    ;;
esac

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

Utilities/check_includes.py || failed=1
Testing/Fuzz/corpus.py check || failed=1

exit $failed
