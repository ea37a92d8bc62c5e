# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Writing that is killed, runs out of room, or competes with another writer: there is the old file or a
whole new one, and nothing else."""

import hashlib
import os
import re
import signal
import subprocess
import time

from soakContext import PROCESSOR_TIME, Finding, Task, describe, run_process

# Arguments of gtn without -q and -f, and the file that they write. @ is the folder of the inputs.
CASES = {
    "plain": (("pack", "@a.vtu"), "out.gtn"),
    "other": (("pack", "@b.vtu"), "out.gtn"),
    "levels": (("pack", "--levels", "3", "@a.vtu"), "out.gtn"),
    "boundary and layers": (("pack", "--boundary", "--layers", "wave:4", "@a.vtu"), "out.gtn"),
    "bounded errors": (("pack", "--error", "*=rel:1e-3", "@a.vtu"), "out.gtn"),
    "in pieces": (("pack", "--pieces", "4", "--spill", ".", "@a.vtu"), "out.gtn"),
    "moving points": (("pack", "@step_0.vtu", "@step_1.vtu", "@step_2.vtu"), "out.gtn"),
    "changing meshes": (("pack", "@step_0.vtu", "@a.vtu", "@step_1.vtu"), "out.gtn"),
    "surface": (("pack", "--triangles", "--levels", "2", "@a.vtp"), "out.gtn"),
    "volume": (("volume", "pack", "@a.vti"), "out.ghv"),
    "unpack": (("unpack", "@a.gtn"), "out.vtu"),
}
# Outputs of VTK and of libraries for images are written under such a name first, and then renamed.
TEMPORARY = re.compile(r"out\.[0-9a-f]{8}\.vtu")


def hash_of(path):
    """Of a file's content; None if there is no file."""
    try:
        with open(path, "rb") as file:
            return hashlib.sha256(file.read()).hexdigest()
    except FileNotFoundError:
        return None


class Writing(Task):
    """What tasks that write have in common."""

    OLD = b"what was there before"

    def prepare(self):
        self.inputs = self.context.scratch / "inputs"
        if not self.inputs.exists():
            self.context.folder("inputs")
            self.context.python("soakMake.py", self.inputs, 8 if self.context.is_short else 16)
        self.folder = self.context.folder(self.kind.replace(" ", "-"))
        self.known = self.context.known  # of cases: hash of the right file, size, seconds it takes

    def command(self, case):
        arguments, out = CASES[case]
        first = 2 if arguments[0] == "volume" else 1
        named = [argument.replace("@", f"{self.inputs}/") for argument in arguments]
        return [str(self.context.gtn), *named[:first], "-q", "-f", *named[first:], out]

    def expected(self, case):
        """What the case gives if nothing disturbs it; the second time tells how long it takes."""
        if case not in self.known:
            folder = self.context.folder(f"expected-{self.kind}")
            path = folder / CASES[case][1]
            for _ in range(2):
                start = time.monotonic()
                run = run_process(self.command(case), folder=folder, processor_time=PROCESSOR_TIME)
                if run.code != 0:
                    raise Finding(f"{case}: {describe(run)}", log=run.output)
            self.known[case] = hash_of(path), path.stat().st_size, time.monotonic() - start
        return self.known[case]

    def put_old(self, folder, case):
        """Half of the time there is a file of that name already, and never another one. Returns its hash,
        or None."""
        for file in folder.iterdir():
            file.unlink()
        path = folder / CASES[case][1]
        if self.random.random() < 0.5:
            path.write_bytes(self.OLD)
        return hash_of(path)

    def check(self, what, folder, case, old, is_killed=False):
        """The file is the old or the right one, and there is no other. Returns which."""
        out = CASES[case][1]
        right = self.expected(case)[0]
        found = hash_of(folder / out)
        if found not in (old, right):
            raise Finding(f"{what}: neither the old file nor the new one", [folder / out])
        for name in os.listdir(folder):
            if name == out:
                continue
            # An unnamed file gets a name when it is complete; then it replaces the old one.
            is_whole = name.startswith(out + ".part-") and hash_of(folder / name) == right
            if not is_killed or not (is_whole or TEMPORARY.fullmatch(name)):
                raise Finding(f"{what}: {name} is left over", [folder / name])
            self.counts["complete files left under another name" if is_whole else
                        "temporary files of VTK's writers left"] += 1
            os.remove(folder / name)
        return "new" if found == right else "old"

    def rounds(self, seconds, once):
        end = time.monotonic() + seconds
        while True:
            once(self.random.choice(list(CASES)))
            if time.monotonic() > end:
                return


class Kill(Writing):
    """Writers that are killed at a random time."""

    kind = "kill"

    def once(self, case):
        _, _, usual = self.expected(case)
        old = self.put_old(self.folder, case)
        process = subprocess.Popen(self.command(case), cwd=self.folder, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL,
                                   env={**os.environ, "TMPDIR": str(self.folder)})
        # Most of what can go wrong is at the end.
        time.sleep(usual * (self.random.uniform(0, 1.1) if self.random.random() < 0.5
                            else self.random.uniform(0.8, 1.1)))
        process.send_signal(signal.SIGKILL)
        code = process.wait()
        state = self.check(f"{case}, killed", self.folder, case, old, is_killed=True)
        if code == 0 and state != "new":
            raise Finding(f"{case}: exit code 0, but no new file")
        if code not in (0, -signal.SIGKILL):
            raise Finding(f"{case}: signal or exit code {code} before it was killed")
        self.counts["writers"] += 1
        self.counts["killed"] += code != 0
        self.counts["new file in place" if state == "new" else "as before"] += 1

    def run(self, seconds):
        self.rounds(seconds, self.once)


class FullDisk(Writing):
    """Disks, limits of file sizes, numbers of files and permissions that end a writer."""

    kind = "full disk"

    def prepare(self):
        super().prepare()
        self.can_mount = os.geteuid() == 0 and self.mount(1 << 20)
        if self.can_mount:
            self.unmount()

    def mount(self, size, options=""):
        run = run_process(["mount", "-t", "tmpfs", "-o", f"size={size}{options}", "none", self.folder])
        return run.code == 0

    def unmount(self):
        run = run_process(["umount", self.folder])
        if run.code != 0:
            raise Finding("the small file system is still in use", log=run.output)

    def expect_refusal(self, what, case, run, old):
        """gtn is done, or says why not; run: of gtn."""
        state = self.check(what, self.folder, case, old, is_killed=run.code < 0)
        self.counts["done all the same" if run.code == 0 else "refused"] += 1
        if run.timeout or run.code not in (0, 1, -signal.SIGXFSZ):
            raise Finding(f"{what}: {describe(run)}", log=run.output)
        if run.code == 0 and state != "new" or run.code == 1 and state != "old":
            raise Finding(f"{what}: exit code {run.code} and the {state} file", log=run.output)
        if run.code == 1 and "gtn: " not in run.output:
            raise Finding(f"{what}: no message", log=run.output)

    def once(self, case):
        _, size, _ = self.expected(case)
        room = self.random.randrange(1, int(1.2 * size) + 8192)
        how = self.random.choice(("disk", "disk", "file size", "folder"))
        command = self.command(case)
        if how == "disk" and self.can_mount:
            room = max(room, 8192)
            files = ",nr_inodes=2" if self.random.random() < 0.1 else ""
            if not self.mount(room, files):
                raise Finding("cannot mount a small file system again")
            try:
                old = self.put_old(self.folder, case)
                run = run_process(command, folder=self.folder)
                self.expect_refusal(f"{case}, {room} bytes of disk{files}", case, run, old)
            finally:
                self.unmount()
            self.counts["small disks"] += 1
        elif how == "folder" and os.geteuid() == 0:
            # A folder that another user cannot write to, run as that user.
            old = self.put_old(self.folder, case)
            os.chmod(self.folder, 0o755)
            run = run_process(["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", *command],
                              folder=self.folder)
            self.expect_refusal(f"{case}, without permission", case, run, old)
            if run.code == 0:
                raise Finding(f"{case}: written without permission")
            self.counts["without permission"] += 1
        else:
            old = self.put_old(self.folder, case)
            # With the signal ignored, the write itself fails.
            is_signal = self.random.random() < 0.3
            run = run_process(command, folder=self.folder, file_size=room, restore_signals=is_signal)
            self.expect_refusal(f"{case}, files of {room} bytes", case, run, old)
            self.counts["limits of file size"] += 1

    def run(self, seconds):
        self.rounds(seconds, self.once)


class TwoWriters(Writing):
    """Two writers of one name at the same time, and somebody who reads it."""

    kind = "two writers"

    def once(self, _):
        cases = self.random.sample([case for case, (_, out) in CASES.items() if out == "out.gtn"], 2)
        right = [self.expected(case)[0] for case in cases]
        longest = max(self.expected(case)[2] for case in cases)
        path = self.folder / "out.gtn"
        old = self.put_old(self.folder, cases[0])
        writers = []
        for case in cases:
            writers.append(subprocess.Popen(self.command(case), cwd=self.folder,
                                            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE))
            time.sleep(self.random.uniform(0, 0.5 * longest))
        while any(writer.poll() is None for writer in writers):
            if hash_of(path) not in (old, *right):
                raise Finding(f"{cases}: a half file in between", [path])
            time.sleep(0.005)
        for writer in writers:
            said = writer.stderr.read().decode("utf-8", "replace")
            writer.stderr.close()
            if writer.returncode != 0:
                raise Finding(f"{cases}: exit code {writer.returncode}", log=said)
        if hash_of(path) not in right:
            raise Finding(f"{cases}: neither of the two files", [path])
        if os.listdir(self.folder) != ["out.gtn"]:
            raise Finding(f"{cases}: {os.listdir(self.folder)}")
        self.counts["pairs of writers"] += 1
        self.counts["the later one won" if hash_of(path) == right[1] else "the earlier one won"] += 1

    def run(self, seconds):
        self.rounds(seconds, self.once)
