#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What programs write into the documentation: the pages of the studies, the page in front of them, and
the table in README.md. All of it follows from the results.json files.

    generatedParts.py            lists what differs from the results; exit code 1 if anything does
    generatedParts.py --update   writes it again
"""

import importlib
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
STUDIES = ROOT / "Documentation" / "studies"
PAGES = {"summary": "summaryReport", "benchmarks": "benchmarkReport", "speed": "speedReport",
         "cells-study": "cellsReport", "parts-study": "partsReport",
         "parallel-study": "parallelReport", "scaling": "scalingReport",
         "rendering-study": "studyReport", "just-in-time-study": "budgetReport",
         "detail-study": "detailReport",
         "simplification-study": "simplificationReport", "isosurface-study": "isosurfaceReport",
         "surface-study": "surfaceReport", "volume-study": "volumeReport",
         "errors-study": "errorReport", "series-study": "seriesReport",
         "client-study": "clientReport"}
BEGIN, END = "<!-- written by Utilities/bench.sh --readme -->\n", "<!-- end -->\n"


def load(name):
    return json.loads((STUDIES / name / "results.json").read_text(encoding="utf-8"))


def render(name):
    """The text of a page with the plots that exist."""
    plots = {file.stem for file in (STUDIES / name).glob("*.png")}
    return importlib.import_module(PAGES[name]).page(load(name), plots)


def render_readme():
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    before, rest = text.split(BEGIN, 1)
    table = importlib.import_module("summaryReport").readme_table(load("summary"))
    return before + BEGIN + "\n" + table + "\n" + END + rest.split(END, 1)[1]


def all_parts():
    """Each generated file with its text."""
    parts = {STUDIES / f"{name}.md": render(name) for name in PAGES}
    conclusions = importlib.import_module("conclusions")
    parts[STUDIES / "README.md"] = conclusions.page({name: load(name) for name in PAGES})
    parts[ROOT / "README.md"] = render_readme()
    return parts


def find_differing():
    """The generated files whose text does not follow from the results."""
    return [file for file, text in all_parts().items()
            if not file.exists() or file.read_text(encoding="utf-8") != text]


def update():
    for file, text in all_parts().items():
        file.write_text(text, encoding="utf-8")


def main():
    if sys.argv[1:] == ["--update"]:
        update()
        return 0
    differing = find_differing()
    for file in differing:
        print(f"{file.relative_to(ROOT)} does not follow from its results.json")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
