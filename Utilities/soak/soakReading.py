# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files that change while they are read, and many opens in one process."""

from soakContext import MIB, TIMEOUT, Finding
from soakWriting import Writing

# What may remain of 9,000 opens: the allocator keeps pages of its own, but nothing of each open.
MOST_GROWTH = 16 * MIB


class Changes(Writing):
    """A file is truncated, overwritten, replaced and deleted while it is read."""

    kind = "changed while open"

    def run(self, seconds):
        counts = self.context.python(
            "soakChange.py", self.inputs, self.folder, self.random.randrange(1 << 31), seconds,
            timeout=TIMEOUT + seconds)
        for name, count in counts.items():
            self.counts[name] += count


class Opens(Writing):
    """Many opens in one process."""

    kind = "opens"

    def __init__(self, context):
        super().__init__(context)
        self.largest = {"growth of memory, KiB": 0}

    def run(self, _):
        count = 600 if self.context.is_short else 10000
        found = self.context.python("soakOpen.py", self.inputs, self.folder, count, timeout=2 * TIMEOUT)
        early, late = found["early"], found["late"]
        growth = late["resident"] - early["resident"]
        self.counts["opens"] += found["opens"]
        self.counts["refused"] += found["refused"]
        self.largest["growth of memory, KiB"] = max(
            self.largest["growth of memory, KiB"], growth // 1024)
        if late["descriptors"] != early["descriptors"]:
            raise Finding(f"{early['descriptors']} descriptors become {late['descriptors']}")
        if growth > MOST_GROWTH:
            raise Finding(f"{growth // 1024} KiB more after {count} opens")

    def results(self):
        return {**super().results(), **self.largest}
