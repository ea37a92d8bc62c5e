# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Runs the commands and snippets of the user guide, each page in a folder of its own.

    ```sh       commands of bash, which stops at the first that fails
    ```python   a snippet; those of a page share their variables. If its first line is "# File: NAME", it
                becomes a file instead
    ```cpp      lines of one of the examples, which another test compiles

Snippets that import paraview are for programs of ParaView, all others for Python with VTK.
"""

import pathlib
import re
import subprocess
import traceback

ROOT = pathlib.Path(__file__).resolve().parents[2]
GUIDE = ROOT / "Documentation" / "guide"
SAMPLES = "Testing/CLI/gatunSamples.py"


class Block:
    """A fenced block of a page."""

    def __init__(self, page, line, language, text):
        self.place = f"{page.relative_to(ROOT)}:{line}"
        self.language = language
        self.text = text

    def is_for_paraview(self):
        return self.language == "python" and re.search(r"^(from|import) paraview\b", self.text, re.MULTILINE)


def blocks_of(page):
    found, begin, language, lines = [], 0, None, []
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if language is None and line.startswith("```"):
            begin, language, lines = number, line[3:], []
        elif language is not None and line == "```":
            found.append(Block(page, begin, language, "\n".join(lines) + "\n"))
            language = None
        elif language is not None:
            lines.append(line)
    if language is not None:
        raise SystemExit(f"{page}: a block does not end")
    return found


def pages():
    return sorted(GUIDE.glob("*.md"))


def run_shell(block, folder, environment):
    """What the commands print, or None if they failed."""
    run = subprocess.run(["bash", "-eu", "-o", "pipefail", "-c", block.text], cwd=folder, env=environment, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=250, check=False)
    print(run.stdout)
    if run.returncode:
        print(f"{block.place}: exit code {run.returncode}")
        return None
    return run.stdout


def run_python(block, folder, names):
    """Whether a snippet ran; it shares the names of others."""
    named = re.match(r"# File: (\S+)\n", block.text)
    if named:
        (pathlib.Path(folder) / named[1]).write_text(block.text, encoding="utf-8")
        return True
    try:
        exec(compile(block.text, block.place, "exec"), names)  # pylint: disable=exec-used
    except BaseException:  # pylint: disable=broad-except
        print(f"{block.place}: {traceback.format_exc(limit=-1)}")
        return False
    return True


def is_in_examples(block):
    """Whether the lines are those of an example."""
    def plain(text):
        return [line.strip() for line in text.splitlines() if line.strip()]
    wanted = plain(block.text)
    for source in sorted((ROOT / "Examples").glob("*.cxx")):
        lines = plain(source.read_text(encoding="utf-8"))
        if any(lines[i:i + len(wanted)] == wanted for i in range(len(lines))):
            return True
    print(f"{block.place}: these lines are in no example")
    return False
