# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""However little memory there is, gtn does its job or says that memory is missing; the old file
stays, and none is left over. The same where nobody listens to what it says."""

import os
import resource
import subprocess

from gatunCli import PROGRAM, enter_folder, gtn, skip, standard_mesh, write

enter_folder("memory")
write(standard_mesh(30), "mesh.vtu")
gtn("pack", "-q", "mesh.vtu", "mesh.gtn")
gtn("pack", "-q", "mesh.vtu", "out.gtn")

# With stderr closed, a message has nowhere to go; the exit code still tells.
for arguments, code in ((("info", "missing.gtn"), 1), (("nonsense",), 2), (("info", "mesh.gtn"), 0)):
    run = subprocess.run(
        [PROGRAM, *arguments],
        stdout=subprocess.DEVNULL,
        preexec_fn=lambda: os.close(2),
        check=False,
        timeout=60,
    )
    assert run.returncode == code, (arguments, run.returncode)


def run_within(mebibytes, *arguments):
    """Exit code and messages of gtn with a limit on its address space."""
    limit = (mebibytes << 20, mebibytes << 20)
    run = subprocess.run(
        [PROGRAM, *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        universal_newlines=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, limit),
        check=False,
        timeout=60,
    )
    return run.returncode, run.stderr


least = 32
while run_within(least, "info", "mesh.gtn")[0] != 0:
    least += 4
    if least > 1024:
        skip("gtn itself needs more than 1 GiB, as it does with sanitizers")
with open("out.gtn", "rb") as file:
    old = file.read()
for arguments in (
    ("pack", "-q", "-f", "--threads", "2", "mesh.gtn", "out.gtn"),
    ("verify", "-q", "--threads", "2", "mesh.gtn"),
):
    failures = 0
    for limit in range(least, 4096, 2):
        code, messages = run_within(limit, *arguments)
        if code == 0:
            break
        print(limit, messages, end="")
        assert code == 1, (limit, code, messages)
        assert messages.startswith("gtn: ") and messages.count("\n") == 1, messages
        # As Gatun, VTK's arrays and threads say it.
        reasons = ("not enough memory", "Unable to allocate", "Resource temporarily unavailable")
        assert any(reason in messages for reason in reasons), messages
        assert sorted(os.listdir(".")) == ["mesh.gtn", "mesh.vtu", "out.gtn"], os.listdir(".")
        with open("out.gtn", "rb") as file:
            assert file.read() == old
        failures += 1
    assert code == 0 and failures > 0, (arguments, failures)
