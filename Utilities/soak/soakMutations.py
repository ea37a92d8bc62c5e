# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Damaged files of all kinds, through gtn and the readers: a result or a message, with little memory."""

import re
import shutil
import time

import soakDamage
from soakContext import MIB, PROCESSOR_TIME, ROOT, Finding, Task, describe, run_process

# More than gtn takes for any of these files, which are small, whatever their tables claim.
MOST_RESIDENT = 512 * MIB
ADDRESS_SPACE = 8192 * MIB

COMMANDS = {
    ".gtn": (("info",), ("info", "--json"), ("info", "-v"), ("verify", "-q"),
             ("unpack", "-q", "-f", "IN", "out.vtu"), ("unpack", "-q", "-f", "IN", "out.vtp"),
             ("render", "-q", "-f", "--size", "24x24", "IN", "out.png"),
             ("contour", "-q", "-f", "--number", "2", "IN", "contour.vtp"),
             ("simplify", "-q", "-f", "--ratio", "0.5", "IN", "coarse.gtn"),
             ("pack", "-q", "-f", "IN", "again.gtn")),
    ".ghv": (("volume", "info"), ("volume", "info", "--verify"), ("volume", "info", "--json"),
             ("volume", "unpack", "-q", "-f", "IN", "out.vti"),
             ("volume", "render", "-q", "-f", "--size", "24x24", "IN", "out.png")),
}


def command_of(gtn, path, arguments):
    named = [str(path) if argument == "IN" else argument for argument in arguments]
    return [gtn, *named] if "IN" in arguments else [gtn, *named, path]


def check_run(run, what, path):
    """gtn did its job, or said in lines of its own why it did not."""
    if run.timeout or run.code not in (0, 1):
        raise Finding(f"{what}: {describe(run)}", [path], run.output)
    lines = run.output.splitlines()
    if run.code == 1 and not any(line.startswith("gtn: ") for line in lines):
        raise Finding(f"{what}: exit code 1 without a message", [path], run.output)
    if re.search(r"not enough memory|Unable to allocate|bad_alloc", run.output):
        raise Finding(f"{what}: asks for too much memory", [path], run.output)
    if run.peak > MOST_RESIDENT:
        raise Finding(f"{what}: {run.peak // MIB} MiB resident", [path], run.output)


class Mutations(Task):
    """Rounds of damaged files, all through the readers and some of them through commands."""

    kind = "mutations"

    def prepare(self):
        self.folder = self.context.folder("mutations")
        golden = ROOT / "Testing" / "Data" / "Golden"
        self.seeds = sorted(path for path in golden.glob("*.g?[nv]") if path.suffix in COMMANDS)
        self.damager = next((path for path in (
            self.context.gtn.parent / "damageFile", self.context.program("release", "damageFile"))
            if path.exists()), None)

    def damage(self, number):
        """A damaged file."""
        random = self.random
        seed = random.choice(self.seeds)
        path = self.folder / f"{number}-{seed.stem}{seed.suffix}"
        how = random.choice(("bytes", "sections", "streams"))
        if how == "streams" and self.damager and seed.suffix == ".gtn":
            run = run_process([self.damager, seed, path, random.randrange(1 << 31)])
            if run.code != 0:
                raise Finding(f"damageFile: {describe(run)}", [seed], run.output)
        else:
            data = seed.read_bytes()
            change = soakDamage.change_bytes if how == "bytes" else soakDamage.change_section
            for _ in range(random.choice((1, 1, 2, 3))):
                data = change(data, random) if data else data
            path.write_bytes(data)
        self.counts["files with wrong checksums" if how == "bytes"
                    else "files with right checksums"] += 1
        return path

    def try_commands(self, path):
        for arguments in self.random.sample(COMMANDS[path.suffix], 2):
            run = run_process(command_of(self.context.gtn, path, arguments), folder=self.folder,
                              address_space=ADDRESS_SPACE, processor_time=PROCESSOR_TIME)
            self.counts["runs of gtn"] += 1
            self.counts["refused by gtn"] += run.code == 1
            check_run(run, f"gtn {' '.join(arguments)}", path)

    def try_readers(self, paths):
        """All files in one process. If it ends early, the last one named is to blame."""
        try:
            counts = self.context.python("soakRead.py", str(self.folder / "now"), *paths)
        except Finding as finding:
            now = self.folder / "now"
            finding.files = [now.read_text(encoding="utf-8")] if now.exists() else []
            raise
        for name, count in counts.items():
            self.counts[name] += count

    def run(self, seconds):
        end = time.monotonic() + seconds
        while True:
            for path in self.folder.iterdir():
                shutil.rmtree(path) if path.is_dir() else path.unlink()
            # A process takes as long to start as the readers take for some dozens of files.
            paths = [self.damage(number) for number in range(5 if self.context.is_short else 100)]
            self.try_readers(paths)
            for path in paths[::5]:
                self.try_commands(path)
                if time.monotonic() > end:
                    break
            if time.monotonic() > end:
                return
