#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The tables of a .gtn file, for runScaling.py, as JSON.

    measureTables.py open PROGRAMS FILE     seconds and memory of opening the file by vtkGatunReader
    measureTables.py count FILE             bytes of its sections by name, with their headers
    measureTables.py groups FILE            groups of shared points
    measureTables.py image PROGRAMS FILE OUT VIEW...  seconds and peak memory of gtn render with these options

groups uses the decoder of the tests, which is slow and independent of the library. It prints nothing where
Python has no xxhash or zstandard.
"""

import json
import os
import pathlib
import resource
import struct
import subprocess
import sys
import time

import parallelWrite

TESTS = pathlib.Path(__file__).resolve().parents[2] / "Testing" / "Python"
SECTION_HEADER, ENTRY, TRAILER = 24, 32, 32


def bytes_read():
    """The bytes that this process has read from files."""
    with open("/proc/self/io", encoding="ascii") as counts:
        return int(next(line for line in counts if line.startswith("rchar:")).split()[1])


def open_file(programs, file):
    sys.path[:0] = [str(pathlib.Path(programs).parent / "lib/python3/dist-packages")]
    from gatun import vtkGatunReader
    reader = vtkGatunReader()
    reader.SetFileName(file)
    parallelWrite.reset_peak()
    before, read = parallelWrite.memory("VmRSS"), bytes_read()
    start = time.monotonic()
    reader.UpdateInformation()
    seconds = time.monotonic() - start
    read = bytes_read() - read
    if reader.GetErrorCode() != 0:
        sys.exit(f"measureTables: {file} cannot be opened")
    return {"seconds": seconds, "read": read, "kept": parallelWrite.memory("VmRSS") - before,
            "peak": parallelWrite.memory("VmHWM") - before}


def count_sections(path):
    """The bytes of each kind of section: 2.2 of the specification."""
    with open(path, "rb") as file:
        file.seek(-TRAILER, os.SEEK_END)
        offset, length = struct.unpack("<QQ", file.read(16))
        file.seek(offset)
        directory = file.read(length)
    counts = {"DIRY": SECTION_HEADER + length + TRAILER}
    entries = len(directory) // ENTRY
    for at in range(length - ENTRY * entries, length, ENTRY):
        name, _, _, size = struct.unpack_from("<4sHHQ", directory, at)
        counts[name.decode("ascii")] = counts.get(name.decode("ascii"), 0) + SECTION_HEADER + size
    return counts


def count_groups(file):
    sys.path.insert(0, str(TESTS))
    try:
        import gtn_container
    except ImportError:
        return {}
    table = gtn_container.Container(pathlib.Path(file).read_bytes()).table
    groups = [group for block in table.blocks for group in block.groups]
    return {"blocks": len(table.blocks), "groups": len(groups),
            "members": sum(len(group.chunks) for group in groups)}


def render(programs, file, out, *view):
    start = time.monotonic()
    subprocess.run([str(pathlib.Path(programs) / "gtn"), "render", "-q", "-f", *view, file, out], check=True)
    return {"seconds": time.monotonic() - start,
            "peak": resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024}


if __name__ == "__main__":
    WHAT = {"open": open_file, "count": count_sections, "groups": count_groups,
            "image": render}[sys.argv[1]]
    print(json.dumps(WHAT(*sys.argv[2:])))
