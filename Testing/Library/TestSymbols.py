# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
"""The symbols of libgatun are the functions of gatun.h, and those of this version: TestSymbols.py LIBRARY HEADER.

Functions never change and are only added. Who adds some raises GATUN_API_VERSION and adds their names to
symbols.txt, below a line with the new version.
"""

import pathlib
import re
import subprocess
import sys


def main():
    library, header = sys.argv[1:]
    listed = {}
    version = 0
    for line in (pathlib.Path(__file__).parent / "symbols.txt").read_text().split():
        if line.isdigit():
            version = int(line)
        else:
            listed[line] = version
    text = pathlib.Path(header).read_text()
    declared = set(re.findall(r"^ *GATUN_API[^;]*?\b(gatun_\w+)\(", text, re.MULTILINE))
    number = int(re.search(r"#define GATUN_API_VERSION (\d+)", text).group(1))
    output = subprocess.run(["nm", "-D", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    symbols = {line.split()[-1].split("@")[0] for line in output.splitlines()} - {"GATUN_0"}
    problems = []
    for name, one, other in (("library", symbols, set(listed)), ("gatun.h", declared, set(listed))):
        problems += [f"{symbol}: in {name}, not in symbols.txt" for symbol in sorted(one - other)]
        problems += [f"{symbol}: in symbols.txt, not in {name}" for symbol in sorted(other - one)]
    if number != version:
        problems.append(f"GATUN_API_VERSION is {number}; the last version in symbols.txt is {version}")
    print("\n".join(problems) or f"{len(symbols)} symbols")
    sys.exit(bool(problems))


main()
