# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The program of Utilities/soak runs, counts what it does, and tells of a program that crashes, says
nothing, asks for too much memory, writes into the file that is there or leaves another one behind."""

import json
import os
import pathlib
import re
import shutil
import stat
import subprocess
import sys

from gatunCli import PROGRAM, enter_folder, skip

try:
    import xxhash  # noqa: F401
    import zstandard  # noqa: F401
except ImportError as error:
    skip(error)

SOAK = pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "soak" / "soak.py"
enter_folder("soak")


def soak(kinds, program=PROGRAM, seconds=1):
    """Exit code, what it says, and the last run of results.json."""
    run = subprocess.run(
        [sys.executable, "-B", SOAK, "--seconds", str(seconds), "--jobs", "1", "--seed", "1", "--kinds",
         kinds, "--gtn", program, "--build", ".", "--out", ".", "--scratch", "."],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, timeout=600)
    print(run.stdout)
    results = json.loads(pathlib.Path("reliability/results.json").read_text(encoding="utf-8"))
    return run.returncode, run.stdout, results["runs"][-1]


def fake(text):
    """A program in place of gtn, which may call it."""
    program = pathlib.Path("fake").resolve()
    program.write_text(f"#!/bin/sh\ngtn={PROGRAM}\n{text}\n", encoding="utf-8")
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    return program


def expect_finding(kind, text, says):
    code, _, run = soak(kind, fake(text), seconds=3)
    found = [finding["what"] for finding in run["findings"]]
    assert code == 1 and any(re.search(says, what) for what in found), (code, found)
    log = pathlib.Path("soak", "findings", f"{kind.replace(' ', '-')}-1", "log.txt")
    assert re.search(says, log.read_text(encoding="utf-8"))
    shutil.rmtree("soak")


# All is well.
code, _, run = soak("mutations,kill,two writers")
assert code == 0 and run["findings"] == []
assert run["kinds"]["mutations"]["all"]["runs of gtn"] >= 2
assert run["kinds"]["mutations"]["all"]["reads in a VTK program"] >= 2
assert run["kinds"]["kill"]["all"]["writers"] >= 1
assert run["kinds"]["two writers"]["all"]["pairs of writers"] >= 1
page = pathlib.Path("reliability.md").read_text(encoding="utf-8")
assert "no findings" in page and "Killed while writing" in page
assert not [name for name in os.listdir(".") if name.startswith("soak-")], os.listdir(".")

# Not well.
expect_finding("mutations", 'kill -SEGV $$', "signal 11")
expect_finding("mutations", 'exit 1', "without a message")
expect_finding("mutations", 'echo "gtn: f: not enough memory" >&2; exit 1', "too much memory")
expect_finding("kill", 'echo > half; exec "$gtn" "$@"', "half is left over")
expect_finding("two writers", 'for last; do :; done; "$gtn" "$@"; date +%N >> "$last"',
               "half file in between|neither of the two files")

# Kinds that do not exist, and programs that are not built.
code, said, _ = soak("nonsense")
assert code == 2 and "no such kind: nonsense" in said
code, said, _ = soak("fuzz")
assert code == 1 and "setup.sh soak builds it" in said
