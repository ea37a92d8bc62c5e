# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""bash and zsh complete command lines of gtn: commands, options, values and files.

The shells run in a terminal and get keys, so that all of their own completion takes part. What a
line becomes is what its program is called with.
"""

import os
import pty
import re
import select
import shutil
import subprocess

from gatunCli import enter_folder, gtn

TAB = "\t"
ALL = "\x1b*"  # bash: insert all possible completions

# In place of the program: the arguments go to a file, one line a call.
FAKE = "gtn() { printf '%s|' \"$@\" >>called; echo >>called; }\n"


def type_lines(shell, lines, environment):
    """Types lines into a shell; returns the lists of arguments that gtn was called with."""
    if os.path.exists("called"):
        os.remove("called")
    terminal, inner = pty.openpty()
    run = subprocess.Popen(
        shell,
        stdin=inner,
        stdout=inner,
        stderr=inner,
        start_new_session=True,
        env={**os.environ, "TERM": "dumb", "PS1": "", "LC_ALL": "C.UTF-8", **environment},
    )
    os.close(inner)
    keys = "".join(line + "\n" for line in [*lines, "exit"]).encode()
    screen = b""
    try:
        while True:
            readable, writable, _ = select.select([terminal], [terminal] if keys else [], [], 120)
            assert readable or writable, f"{shell[0]} hangs: {screen.decode()}"
            if readable:
                part = os.read(terminal, 4096)
                if not part:
                    break
                screen += part
            if writable and keys:
                keys = keys[os.write(terminal, keys[:64]) :]
    except OSError:  # how a terminal says that its shell has ended
        pass
    os.close(terminal)
    run.wait(timeout=120)
    print(screen.decode(errors="replace"))
    with open("called", encoding="utf-8") as file:
        calls = [line[:-2].split("|") for line in file.readlines()]
    assert len(calls) == len(lines), f"{len(calls)} calls of {len(lines)} lines"
    return calls


def options_of(*command):
    """Those that --help of a command lists."""
    names = set()
    for line in gtn(*command, "--help").splitlines():
        match = re.match(r" {2,10}(-[^ ,]+(, *-[^ ,]+)*)", line)  # texts are farther to the right
        names.update(re.findall(r"(?<![\w-])-{1,2}[a-z][a-z-]*", match.group(1)) if match else [])
    return names


def check(shell, cases, environment):
    for (line, expected), called in zip(cases, type_lines(shell, [c[0] for c in cases], environment)):
        if isinstance(expected, set):
            assert set(called) == expected, f"{line!r}: {set(called) ^ expected}"
        else:
            assert called == expected, f"{line!r}: {called}, not {expected}"


enter_folder("completion")
os.makedirs("folder")
os.makedirs("fonts")
for name in ("mesh.gtn", "two words.gtn", "options.json"):
    open(name, "w", encoding="ascii").close()

# What is the same in both shells.
common = [
    ("gtn ver" + TAB, ["verify"]),
    ("gtn vol" + TAB + "ren" + TAB, ["volume", "render"]),
    ("gtn pack --keep-o" + TAB, ["pack", "--keep-order"]),
    ("gtn pack --keep-order p" + TAB, ["pack", "--keep-order", "points"]),
    ("gtn pack --keep-order=p" + TAB, ["pack", "--keep-order=points"]),
    ("gtn pack -q --spill fol" + TAB, ["pack", "-q", "--spill", "folder/"]),
    ("gtn volume pack --block w" + TAB, ["volume", "pack", "--block", "whole"]),
    ("gtn render --mode xr" + TAB, ["render", "--mode", "xray"]),
    ("gtn render --camera opt" + TAB, ["render", "--camera", "options.json"]),
    ("gtn info two" + TAB, ["info", "two words.gtn"]),
    ("gtn info --json mesh" + TAB, ["info", "--json", "mesh.gtn"]),
    # A number is typed.
    ("gtn pack --chunk-size m" + TAB, ["pack", "--chunk-size", "m"]),
    # A file may be called like a command.
    ("gtn pack volume --lev" + TAB, ["pack", "volume", "--levels"]),
]

with open("gtn.bash", "w", encoding="ascii") as file:
    file.write("bind 'set enable-bracketed-paste off'\nbind 'set bell-style none'\n")
    file.write(FAKE + gtn("--completion", "bash"))
commands = {"pack", "unpack", "info", "verify", "mesh", "render", "simplify", "contour", "volume"}
bash = [
    *common,
    ("gtn " + ALL, commands),
    ("gtn volume " + ALL, {"volume", "pack", "unpack", "info", "render"}),
    ("gtn pack --keep-order " + ALL, {"pack", "--keep-order", "none", "points", "cells", "all"}),
    *[
        (f"gtn {' '.join(command)} -" + ALL, {*command, *options_of(*command)})
        for command in [["pack"], ["render"], ["verify"], ["volume", "render"]]
    ],
]
check(["bash", "--noprofile", "--rcfile", "gtn.bash", "-i"], bash, {"INPUTRC": "/dev/null"})

gtn("--completion", "fish", code=2, says="bash or zsh")
if shutil.which("zsh"):
    with open("_gtn", "w", encoding="ascii") as file:
        file.write(gtn("--completion", "zsh"))
    with open(".zshrc", "w", encoding="ascii") as file:
        file.write("unset zle_bracketed_paste HISTFILE\nsetopt no_beep no_auto_remove_slash\n" + FAKE)
        file.write("fpath=($PWD $fpath)\nautoload -U compinit\ncompinit -u -D\n")
    # Help texts stand beside options without breaking zsh's syntax.
    subprocess.run(["zsh", "-fn", "_gtn"], check=True)
    check(["zsh", "-d", "-i"], common, {"ZDOTDIR": os.getcwd(), "SHELL": "zsh"})
