#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# A compiler launcher (see RunRemote.cmake):
#
#   reuse_object.sh <compiler> <argument>...
#
# Compiles the first source of each folder. Takes the objects of the others from the build tree
# GATUN_BUILD, which has compiled the same sources already, if they are there.
set -eu

output=
depfile=
previous=
for argument; do
  case $previous in
    -o) output=$argument ;;
    -MF) depfile=$argument ;;
  esac
  previous=$argument
done

# Remote/Gatun/Module/CMakeFiles/... is Module/CMakeFiles/... in the build tree.
object=$GATUN_BUILD/${output#Remote/Gatun/}
if [ -n "$output" ] && [ -f "$object" ] && ! mkdir "$(dirname "$output")/compiled" 2>/dev/null; then
  cp "$object" "$output"
  if [ -n "$depfile" ]; then
    echo "$output:" >"$depfile"
  fi
  exit 0
fi
exec "$@"
