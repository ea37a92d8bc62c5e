# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Runs a command with a memory limit: in a control group, or else with a limit of the address space.

The group is made below that of this process (version 1) or next to it (version 2, where a group with
processes cannot have groups below), so that other limits stay in force. It is removed when the command
has ended. A group counts resident memory: the heap, and those pages of files that no other group has
loaded before. A limit of the address space (ulimit -v) counts all mapped memory, above all libraries,
and so says much less.
"""

import os
import pathlib
import resource
import subprocess
import tempfile
import time

ROOT = pathlib.Path("/sys/fs/cgroup")


def _own_groups():
    """Controllers, as "memory" or "" for version 2, and the group of this process."""
    groups = {}
    try:
        lines = pathlib.Path("/proc/self/cgroup").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    for line in lines:
        _, controllers, path = line.split(":", 2)
        for controller in controllers.split(","):
            groups[controller] = path.lstrip("/")
    return groups


class _Group:
    """A way to make groups: in a folder, with a file that takes the limit."""

    def __init__(self, name, folder, limit):
        self.name = name
        self.folder = folder
        self.limit = limit

    def works(self):
        """Whether a group can be made, limited and removed."""
        try:
            with self._made(2**30):
                return True
        except OSError:
            return False

    def _made(self, limit):
        return _MadeGroup(self, limit)

    def run(self, command, limit, timeout):
        with self._made(limit) as folder:
            def enter():
                (folder / "cgroup.procs").write_text("0", encoding="utf-8")
            return _run(command, timeout, enter)


class _MadeGroup:
    """A group that is there for a while."""

    def __init__(self, kind, limit):
        self.kind = kind
        self.limit = limit
        self.folder = None

    def __enter__(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="gatun-study-", dir=self.kind.folder))
        try:
            (self.folder / self.kind.limit).write_text(str(self.limit), encoding="utf-8")
        except OSError:
            self.folder.rmdir()
            raise
        return self.folder

    def __exit__(self, *_):
        # The kernel may take a moment to let go of a process that has ended.
        for _ in range(100):
            try:
                self.folder.rmdir()
                return
            except OSError:
                time.sleep(0.05)
        self.folder.rmdir()


class _AddressSpace:
    """The limit that every system has."""

    name = "ulimit -v"

    def run(self, command, limit, timeout):
        def enter():
            resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
        return _run(command, timeout, enter)


def _run(command, timeout, enter=None):
    """Returns the output; None if the command failed, and why."""
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                          preexec_fn=enter) as process:
        try:
            out, _ = process.communicate(timeout=timeout)
        except subprocess.TimeoutExpired:
            return None, f"over {timeout} s"
        finally:
            # Whatever ends the wait: a group with a process in it cannot be removed.
            process.kill()
    return (out, None) if process.returncode == 0 else (None, "fails")


def _candidates():
    groups = _own_groups()
    if "memory" in groups:
        yield _Group("cgroup", ROOT / "memory" / groups["memory"], "memory.limit_in_bytes")
    if (ROOT / "cgroup.controllers").exists() and "" in groups:
        own = ROOT / groups[""]
        yield _Group("cgroup 2", own if own == ROOT else own.parent, "memory.max")


def best():
    """The best way to limit memory here."""
    return next((way for way in _candidates() if way.works()), _AddressSpace())


def address_space():
    return _AddressSpace()


def unlimited(command, timeout):
    return _run(command, timeout)
