# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Studies that measure the same quantities for several meshes and write a page."""

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
    "lattice": "body-centered lattice with jitter",
    "flow": "synthetic: structured grid around a nose, five tetrahedra per hexahedron",
    "big": "synthetic: a cube of hexahedra, five tetrahedra each",
}


def _make_source(runner, name, wanted, delaunay, data):
    """The mesh; None if it is not available."""
    if "tets" not in wanted:
        found = sorted(data.glob(f"{name}_tets*.vtu")) if data else []
        return found[0] if found else None
    made = runner.path("study", f"{name}.vtu")
    kind = {"delaunay": "delaunay" if delaunay else "lattice", "big": "block"}.get(name, "flow1")
    runner.case("make", kind, wanted["tets"], made)
    return made


def _measure(runner, options, modes, results, measure_mesh):
    """Measures all meshes, or those of --only, whose results replace the previous ones."""
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
            runner.say(f"{name} is left out: it is not in GATUN_DATA_DIR")
            continue
        about = "lattice" if name == "delaunay" and not delaunay else name
        results["meshes"] = [mesh for mesh in results["meshes"] if mesh["name"] != about]
        results["meshes"].append({"name": about, "about": ABOUT[about],
                                  **measure_mesh(runner, name, source, wanted, mode, results)})
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = results.get("seconds", 0) + time.monotonic() - runner.start
    return results


def run(page, description, modes, measure_mesh, write):
    """The program. measure_mesh(runner, name, source, wanted, mode, results) returns the results of
    a mesh, and write(results, folder) writes the page. "meshes" of each mode names the number of
    tetrahedra of synthetic meshes and the array of meshes of GATUN_DATA_DIR."""
    parser = benchmarkRunner.make_parser(description, page)
    parser.add_argument("--only", nargs="+", choices=modes["full"]["meshes"],
                        help="measure these meshes only, and keep the results of the others")
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
