# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Studies that measure the same things of several meshes and write a page of it."""

import json
import os
import pathlib
import tempfile
import time

import benchmarkRunner

ABOUT = {
    "bluntfin": "NASA's blunt fin, the paper's Blunt",
    "comb": "combustion chamber, the paper's Combustion",
    "kiefer_bracket": "bracket, von Mises stress by finite elements",
    "delaunay": "ball meshed by TetGen, smooth field",
    "lattice": "body-centred lattice with jitter",
    "flow": "made: structured grid around a nose, five tetrahedra a hexahedron",
    "big": "made: a cube of hexahedra, five tetrahedra each",
}


def _make_source(runner, name, wanted, delaunay, data):
    """The mesh; None if it cannot be had here."""
    if "tets" not in wanted:
        found = sorted(data.glob(f"{name}_tets*.vtu")) if data else []
        return found[0] if found else None
    made = runner.path("study", f"{name}.vtu")
    kind = {"delaunay": "delaunay" if delaunay else "lattice", "big": "block"}.get(name, "flow1")
    runner.case("make", kind, wanted["tets"], made)
    return made


def _measure(runner, options, modes, results, measure_mesh):
    """All meshes, or those that are asked for, in the place of what there was of them."""
    mode = modes[options.mode]
    if not options.only:
        results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner), "meshes": []}
    data = os.environ.get("GATUN_DATA_DIR")
    data = pathlib.Path(data) if data else None
    for name in options.only or mode["meshes"]:
        wanted = mode["meshes"][name]
        delaunay = results["machine"]["tetgen"]
        source = _make_source(runner, name, wanted, delaunay, data)
        if source is None:
            runner.say(f"{name} is left out: GATUN_DATA_DIR has it not")
            continue
        about = "lattice" if name == "delaunay" and not delaunay else name
        results["meshes"] = [mesh for mesh in results["meshes"] if mesh["name"] != about]
        results["meshes"].append({"name": about, "about": ABOUT[about],
                                  **measure_mesh(runner, name, source, wanted, mode, results)})
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = results.get("seconds", 0) + time.monotonic() - runner.start
    return results


def run(page, description, modes, measure_mesh, write):
    """The program: measure_mesh(runner, name, source, wanted, mode, results) returns what is to be kept of
    a mesh, and write(results, folder) makes the page. Of each mode, "meshes" tells for what is made the
    tetrahedra, and for what is there if GATUN_DATA_DIR is set the array."""
    parser = benchmarkRunner.make_parser(description, page)
    parser.add_argument("--only", nargs="+", choices=modes["full"]["meshes"],
                        help="measure these meshes only, and keep what is there of the others")
    options = parser.parse_args()
    folder = options.out / page
    folder.mkdir(parents=True, exist_ok=True)
    raw = folder / "results.json"
    results = {}
    if options.report or options.only:
        results = json.loads(raw.read_text(encoding="utf-8"))
    if not options.report:
        with tempfile.TemporaryDirectory(prefix=f"gatun-{page}-") as work:
            runner = benchmarkRunner.Runner(options.programs, pathlib.Path(work), folder)
            results = _measure(runner, options, modes, results, measure_mesh)
        raw.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    write(results, options.out)
    print(f"The results are in {options.out / page}.md and {folder}")
