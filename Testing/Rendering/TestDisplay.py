# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The display that tests draw on takes every client, also those that come when others leave. An X
server that resets itself when its last client has left refuses some."""

import ctypes
import ctypes.util
import os
import subprocess
import sys

CONNECTIONS = 300


def count_refused():
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    x11.XCloseDisplay.argtypes = [ctypes.c_void_p]
    refused = 0
    for _ in range(CONNECTIONS):
        display = x11.XOpenDisplay(None)
        if display:
            x11.XCloseDisplay(display)
        else:
            refused += 1
    return refused


if sys.argv[1:] == ["client"]:
    print(count_refused())
    sys.exit(0)

if not os.environ.get("DISPLAY") or not ctypes.util.find_library("X11"):
    print("there is no display, or no Xlib")
    sys.exit(125)
clients = [
    subprocess.Popen([sys.executable, __file__, "client"], stdout=subprocess.PIPE) for _ in range(2)
]
refused = sum(int(client.communicate(timeout=120)[0]) for client in clients)
assert refused == 0, (
    f"the display refused {refused} of {2 * CONNECTIONS} connections; start Xvfb with -noreset"
)
