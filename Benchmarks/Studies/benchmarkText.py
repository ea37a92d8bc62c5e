# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""How figures, tables and pictures are written in pages."""

import textwrap


def number(value):
    """Three digits that count."""
    if value >= 100:
        return f"{value:,.0f}"
    return f"{value:.1f}" if value >= 10 else f"{value:.2f}"


def paragraph(text):
    """Text with figures in it, in lines of the usual length."""
    return textwrap.fill(" ".join(text.split()), 100, break_long_words=False,
                         break_on_hyphens=False) + "\n"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def picture(pictures, name, text, folder="benchmarks"):
    return f"![{text}]({folder}/{name}.png)\n" if name in pictures else ""


def machine(known):
    """The paragraph that says where something was measured."""
    text = f"""*Machine:* {known["processor"]}, {known["processors"]} processors,
{known["memory"] / 2**30:.1f} GiB; {known["system"]}; {known["compiler"]} ({known["build"]});
VTK {known["vtk"]}, threads by {known["backend"]}; Gatun {known["gatun"]}. Load average before:
{known["loadBefore"][0]:.2f}, after: {known["loadAfter"][0]:.2f}.
"""
    if known["loadBefore"][0] > 0.5:
        text += "\n**The machine was busy with other things: do not trust the times.**\n"
    return text
