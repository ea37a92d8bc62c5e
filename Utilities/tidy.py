#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs clang-tidy on sources, many at a time.

Most of the time of clang-tidy goes into headers, which it parses and searches for each source anew.
Here, sources of one folder that are compiled with the same options are included into one file, a
batch, and checked together. Sources that define the same name outside of functions, such as helpers
in anonymous namespaces, go into different batches. If a batch does not compile nevertheless, its
sources are checked one by one.

    tidy.py --build build/release [--jobs N] [--check OPTION]... SOURCE...

Prints the findings. The exit code is 1 if there are any.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys

# Batches are in a build tree, where clang-tidy does not look for it.
CONFIGURATION = os.path.join(os.path.dirname(os.path.dirname(os.path.realpath(__file__))), ".clang-tidy")

# Sources in a batch. With more, the batches are few and of different sizes, and processes wait.
BATCH_SIZE = 12

# Findings in the sources of a batch, which is none of them, and in headers.
HEADER_FILTER = r"(Module|IO|Filters|Rendering|Programs|Benchmarks)/.*\.(h|cxx)$"

# A name that is defined at the beginning of a line: type, function, variable, alias or macro. Layout is
# that of clang-format, and contents of namespaces are not indented.
DEFINITION = re.compile(
    r"^(?:#define\s+(\w+)"
    r"|(?:class|struct|enum|enum class|union)\s+(\w+)"
    r"|using\s+(\w+)"
    r"|[A-Za-z_][\w:<>,&*\s\[\]]*?[\s&*](\w+)\s*(?:\(|=|\{|;|\[))"
)


def read_commands(build):
    """Returns {source: (folder, options)} of a build tree, without the names of source and object."""
    with open(os.path.join(build, "compile_commands.json"), encoding="utf-8") as file:
        entries = json.load(file)
    commands = {}
    for entry in entries:
        words = shlex.split(entry["command"])
        options = words[: words.index("-o")]
        commands[os.path.realpath(entry["file"])] = (entry["directory"], tuple(options))
    return commands


def find_names(source):
    """Returns the names that a source defines, as far as its lines tell."""
    names = set()
    with open(source, encoding="utf-8") as file:
        for line in file:
            match = DEFINITION.match(line)
            if match:
                names.add(next(name for name in match.groups() if name))
    return names


def make_batches(sources, commands):
    """Returns lists of sources that can be included into one file."""
    kinds = collections.defaultdict(list)
    for source in sources:
        kinds[(os.path.dirname(source), commands[source])].append(source)
    batches = []
    for members in kinds.values():
        open_batches = []
        for source in members:
            names = find_names(source)
            for batch, taken in open_batches:
                if len(batch) < BATCH_SIZE and taken.isdisjoint(names):
                    batch.append(source)
                    taken |= names
                    break
            else:
                open_batches.append(([source], names))
        batches += [batch for batch, _ in open_batches]
    return batches


def write_database(folder, files, commands):
    """Writes the batches, and a compile_commands.json of them and of their sources."""
    entries = []
    for name, batch in files.items():
        with open(name, "w", encoding="utf-8") as file:
            file.writelines(f'#include "{source}" // NOLINT(bugprone-suspicious-include)\n' for source in batch)
        for target in {name, *batch}:
            directory, options = commands[batch[0]]
            words = [*options, "-c", target]
            entries.append({"directory": directory, "file": target, "command": shlex.join(words)})
    with open(os.path.join(folder, "compile_commands.json"), "w", encoding="utf-8") as file:
        json.dump(entries, file)


def run_tidy(folder, name, checks):
    """Returns whether clang-tidy is content with a file, and what it says."""
    options = ["--quiet", "-p", folder, f"--config-file={CONFIGURATION}", f"--header-filter={HEADER_FILTER}"]
    command = ["clang-tidy", *options, *checks, name]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
    return done.returncode == 0, done.stdout


def check_batch(folder, name, batch, checks):
    """Checks a batch, or its sources one by one if it does not compile or has findings.

    A finding of a batch is seen again in its source, so that nobody has to know of batches.
    """
    good, text = run_tidy(folder, name, checks)
    if good or len(batch) == 1:
        return good, text
    results = [run_tidy(folder, source, checks) for source in batch]
    if all(result for result, _ in results) and "clang-diagnostic-error" not in text:
        return False, text
    return all(result for result, _ in results), "".join(said for _, said in results)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", required=True, help="build tree with compile_commands.json")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--check", action="append", default=[], help="argument for clang-tidy's --checks")
    parser.add_argument("sources", nargs="+")
    arguments = parser.parse_args()

    # Sources that this build leaves out have no options.
    commands = read_commands(arguments.build)
    sources = [source for source in map(os.path.realpath, arguments.sources) if source in commands]
    folder = os.path.join(os.path.abspath(arguments.build), "tidy")
    os.makedirs(folder, exist_ok=True)
    batches = make_batches(sources, commands)
    batches.sort(key=lambda batch: sum(os.path.getsize(source) for source in batch), reverse=True)
    files = {os.path.join(folder, f"batch{i}.cxx"): batch for i, batch in enumerate(batches)}
    write_database(folder, files, commands)

    checks = [f"--checks={check}" for check in arguments.check]
    failed = False
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        tasks = [pool.submit(check_batch, folder, name, batch, checks) for name, batch in files.items()]
        for task in concurrent.futures.as_completed(tasks):
            good, text = task.result()
            failed |= not good
            sys.stdout.write(text)
            sys.stdout.flush()
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
