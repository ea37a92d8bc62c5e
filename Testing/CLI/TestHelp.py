# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Every subcommand explains its options and has examples; its manual page has all of it."""

import os
import re
import shutil
import subprocess

from gatunCli import enter_folder, gtn

enter_folder("help")
gtn("--manual", ".")
gtn("--manual", "missing", code=1, says="cannot be written")
commands = ("pack", "unpack", "info", "verify", "mesh", "render", "simplify", "contour")
volume_commands = ("pack", "unpack", "info", "render")
pages = {"gtn.1", "gtn-volume.1"}
for words in [[c] for c in commands] + [["volume", c] for c in volume_commands]:
    text = gtn(*words, "--help")
    assert f"Examples:\n  gtn {' '.join(words)}" in text, words
    page = "gtn-" + "-".join(words) + ".1"
    pages.add(page)
    with open(page, encoding="ascii") as file:
        manual = file.read()
    for option in re.findall(r"--[a-z-]+", text.split("Examples:")[0]):
        assert option.replace("-", "\\-") in manual, option
    for example in re.findall(r"^  (gtn .*)$", text.split("Examples:")[1], re.MULTILINE):
        assert example.replace("-", "\\-") in manual, example
    for line in text.splitlines():
        assert len(line) <= 100, line
for command in volume_commands:
    assert f"  {command} " in gtn("volume", "--help")

assert set(os.listdir(".")) == pages, sorted(os.listdir("."))
for page in pages:
    with open(page, encoding="ascii") as file:
        manual = file.read()
    assert not re.search(r"^\.(?!TH|SH|TP|PP|B |BR |nf|fi)", manual, re.MULTILINE), "unknown request"
    # The name and a summary, for whatis.
    name = page[: -len(".1")]
    escaped = re.escape(name.replace("-", "\\-"))
    assert re.search(rf"^\.SH NAME\n{escaped} \\- \w.*[^.]$", manual, re.MULTILINE), page
    # Pages lead to each other, and to none that is not there.
    for other in re.findall(r"^\.BR (\S+) \(1\)", manual, re.MULTILINE):
        assert other.replace("\\", "") + ".1" in pages, other
    if shutil.which("man"):
        run = subprocess.run(
            ["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            universal_newlines=True,
            env={**os.environ, "LC_ALL": "C.UTF-8", "MANWIDTH": "80"},
            check=False,
        )
        assert run.returncode == 0 and not run.stderr, f"{page}: {run.stderr}"
gtn("--version", says="(format ")
