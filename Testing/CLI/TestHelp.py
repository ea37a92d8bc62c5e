# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Every subcommand explains its options and has examples; the manual page has all of it."""

import re

from gatunCli import gtn

manual = gtn("--man")
assert manual.startswith(".TH GTN 1 ")
for command in ("pack", "unpack", "info", "verify", "mesh", "render", "simplify", "contour", "bench"):
    text = gtn(command, "--help")
    assert "Examples:\n  gtn " + command in text, command
    for option in re.findall(r"--[a-z-]+", text.split("Examples:")[0]):
        assert option.replace("-", "\\-") in manual, option
    for line in text.splitlines():
        assert len(line) <= 100, line
for command in ("pack", "unpack", "info", "render"):
    text = gtn("volume", command, "--help")
    assert "Examples:\n  gtn volume " + command in text, command
    for option in re.findall(r"--[a-z-]+", text.split("Examples:")[0]):
        assert option.replace("-", "\\-") in manual, option
    assert f".SH gtn volume {command}\n" in manual
    for line in text.splitlines():
        assert len(line) <= 100, line
for command in ("pack", "unpack", "info", "render"):
    assert f"  {command} " in gtn("volume", "--help")
assert not re.search(r"^\.(?!TH|SH|TP|PP|B|nf|fi)", manual, re.MULTILINE), "unknown request"
gtn("--version", says="(format ")
