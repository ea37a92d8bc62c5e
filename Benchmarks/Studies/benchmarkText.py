# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""How numbers, tables and images are written in pages."""

import importlib
import statistics
import textwrap


def number(value):
    """Three significant digits."""
    if value >= 100:
        return f"{value:,.0f}"
    return f"{value:.1f}" if value >= 10 else f"{value:.2f}"


def ratio(value):
    return f"{value:.2f}"


def span(values, text=number):
    """The range of values: "1.20 to 1.85"."""
    return f"{text(min(values))} to {text(max(values))}"


def spread(values, text=number):
    """The median of rounds, with the range if there is more than one: "1.50 (1.20 to 1.85)"."""
    values = list(values)
    middle = text(statistics.median(values))
    return f"{middle} ({span(values, text)})" if len(values) > 1 else middle


def rounds_of(pairs):
    """The ratio of each pair, as a list."""
    return [a / b for a, b in pairs]


def paragraph(text):
    """Text with numbers in it, in lines of the usual length."""
    return textwrap.fill(" ".join(text.split()), 100, break_long_words=False,
                         break_on_hyphens=False) + "\n"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def verdict(value, goal):
    """goal: what the project wants at least, and what would be better."""
    return "target met" if value >= goal[1] else "met" if value >= goal[0] else "not met"


def image(plots, name, text, folder="benchmarks"):
    return f"![{text}]({folder}/{name}.png)\n" if name in plots else ""


ROUNDS = """Where a table compares times measured in rounds, the methods take turns in each round, so that
    other load on the machine affects all of them alike. In a cell *a (b to c)*, *a* is the median
    over the rounds, *b* the smallest and *c* the largest value; a ratio is computed within each
    round."""


def machine(results, rounds=ROUNDS):
    """Where, when and how the results were measured."""
    known = results["machine"]
    text = f"""*Machine:* {known["processor"]}, {known["processors"]} processors,
        {known["memory"] / 2**30:.1f} GiB; {known["system"]}; {known["compiler"]}
        ({known["build"]}); VTK {known["vtk"]}, threads by {known["backend"]};
        Gatun {known["gatun"]}. *Measured:* {known["date"]}, commit {known["commit"]}. The load
        average was {known["loadBefore"][0]:.2f} at the start and {known["loadAfter"][0]:.2f} at the
        end. {rounds}"""
    text = paragraph(text)
    for note in results.get("notes", []):
        text += "\n" + paragraph("*Note:* " + note)
    if results["mode"] != "full":
        text += f"\n**A {results['mode']} run on small data: not to be quoted.**\n"
    return text


def write_page(results, out, name, make, plots=None):
    """Writes NAME.md, which make(results, plots) returns, and plots into the folder NAME where
    matplotlib is installed; plots names the module that draws them."""
    try:
        drawn = importlib.import_module(plots).draw(results, out / name) if plots else set()
    except ImportError:
        print("Without matplotlib (python3-matplotlib) there are no plots.")
        drawn = set()
    (out / f"{name}.md").write_text(make(results, drawn), encoding="utf-8")
