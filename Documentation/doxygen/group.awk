#!/usr/bin/awk -f
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Puts what a header declares, in the namespace gatun if it has that, into the group of its folder, for
# doxygen. Numbers of lines stay.

{
  line[NR] = $0
}

/^#define [A-Za-z0-9]+_h$/ {
  begin = NR + 1
}

/^namespace gatun$/ {
  begin = NR + 1
  inNamespace = 1
}

inNamespace ? /^}$/ : /^#endif/ {
  end = NR
}

END {
  count = split(FILENAME, folders, "/")
  line[begin] = line[begin] " /** @addtogroup Gatun" folders[count - 1] " */ /** @{ */"
  line[end] = "/** @} */ " (inNamespace ? line[end] : "")
  for (i = 1; i <= NR; ++i) {
    print line[i]
  }
}
