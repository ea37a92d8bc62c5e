# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The demo makes a part, packs it, verifies it and draws it."""

from gatunDemo import run_demo

run_demo("demo", [None])
