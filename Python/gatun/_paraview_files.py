# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Series of files as ParaView has them: several paths, or a .series file that lists them."""

import bisect
import json
import os
from typing import NamedTuple, Optional

from ._exceptions import Error


class Entry(NamedTuple):
    """A time step of a series: its time (or None), its file, and its number there."""

    time: Optional[float]
    path: str
    step: int


def list_files(paths):
    """The files of a series, and their times (None where the file itself or its place tells it)."""
    if not paths:
        raise Error("no file name was set")
    if not paths[0].lower().endswith(".series"):
        return list(paths), [None] * len(paths)
    folder = os.path.dirname(paths[0])
    try:
        with open(paths[0], encoding="utf-8") as file:
            files = json.load(file)["files"]
        found = [os.path.join(folder, entry["name"]) for entry in files]
        times = [float(entry["time"]) if "time" in entry else None for entry in files]
    except (KeyError, TypeError, ValueError) as error:
        raise Error(f"{paths[0]}: is no list of the files of a series ({error!r})") from None
    if not found:
        raise Error(f"{paths[0]}: lists no files")
    return found, times


def merge_times(paths, times, get_times):
    """The entries of a series by ascending time.

    Steps of a file end where the next file begins. If the first file has no time, files are numbered.

    Args:
        paths, times: as ``list_files`` gives them.
        get_times: a function that returns the times of the steps in a file.
    """
    own = get_times(paths[0])
    if not own:
        if len(paths) == 1 and times[0] is None:
            return [Entry(None, paths[0], 0)]
        return sorted(Entry(float(i) if t is None else t, p, 0) for i, (p, t) in enumerate(zip(paths, times)))
    starts = {}
    for path, time in zip(paths, times):
        steps = own if path == paths[0] else get_times(path)
        if not steps:
            raise Error(f"{path}: has no time, and the first file of the series has")
        entries = [Entry(t, path, step) for step, t in enumerate(steps)]
        if time is not None:
            entries = [Entry(time, path, 0)]
        starts[entries[0].time] = entries
    merged = []
    for start in sorted(starts):
        del merged[bisect.bisect_left([entry.time for entry in merged], start) :]
        merged += starts[start]
    return merged


def find_entry(series, time):
    """The last entry that is not later than a time, or else the first one."""
    if time is None or series[0].time is None:
        return series[0]
    return series[max(bisect.bisect_right([entry.time for entry in series], time) - 1, 0)]
