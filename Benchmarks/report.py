#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Measures Gatun and its peers, and writes Documentation/performance.md, Documentation/dissertation.md and the
table of README.md from the results. GATUN_DATA_DIR and GATUN_CELLS_DIR may name folders of real meshes.
"""

import argparse
import itertools
import json
import os
import pathlib
import re
import shutil
import sys
import tempfile
import time

import dissertationPage
import performancePage
import runner as running

ROOT = pathlib.Path(__file__).resolve().parents[1]
DOCUMENTATION = ROOT / "Documentation"
BEGIN, END = "<!-- written by Utilities/setup.sh bench -->\n", "<!-- end -->\n"
ARRAY = "Density"

# Cells of synthetic meshes, time steps, pixels, voxels along an edge, triangles, rounds for short and long cases.
FULL = {"delaunay": 1000000, "grid": 5000000, "flow": 400000, "hexahedra": 300000, "mixed": 100000,
        "steps": 20, "sizes": (512, 1024), "voxels": 128, "scan": 1000000, "samples": 200000,
        "blocks": (4, 8, 16, 32, 64), "rays": 100000, "rounds": 7, "few": 3, "real": True}
QUICK = {"delaunay": 3000, "grid": 5000, "flow": 4000, "hexahedra": 2000, "mixed": 2000,
         "steps": 3, "sizes": (64,), "voxels": 24, "scan": 2000, "samples": 2000, "blocks": (4, 8), "rays": 2000, "rounds": 1, "few": 1, "real": False}

# Real meshes, those of tetrahedra with the point array that is shown.
TETS = {"bluntfin_tets": "Density", "comb_tets": "Density", "kiefer_bracket_tets": "vonMises_psi_pt"}
CELLS = ("fire_ug", "can", "bunny_hex", "ac_room")
MADE_CELLS = ("hexahedra", "mixed")
PROFILES = {"gtn": "fast", "gtn-small": "small"}
LOADED = (*PROFILES, "vtu-raw", "vtu-lz4", "vtu-zlib", "zstd", "zstd-shuffle")
VOLUMES = {"ct": "CT_AVM.nii.gz", "mr": "brain1_mr_int16.vti"}
RATIOS = "0,0.5,0.75,0.9,0.98"


def real_file(mode, name):
    """A file of one of the folders; None if it is not there."""
    for variable in ("GATUN_DATA_DIR", "GATUN_CELLS_DIR") if mode["real"] else ():
        file = pathlib.Path(os.environ.get(variable, "/nowhere")) / name
        if file.exists():
            return file
    return None


class Meshes:
    """The meshes, each in the files that some cases need; made once."""

    def __init__(self, runner, mode, tetgen):
        self.runner = runner
        self.mode = mode
        self.about = {"delaunay": "Delaunay mesh of a ball by TetGen" if tetgen
                                  else "jittered lattice, as TetGen is missing",
                      "grid": "structured grid around a nose, five tetrahedra per hexahedron",
                      "flow": "the same with four arrays"}
        self.kinds = {"delaunay": "delaunay" if tetgen else "lattice", "grid": "flow1", "flow": "flow",
                      **{name: name for name in MADE_CELLS}}
        self.arrays = {"delaunay": ARRAY, "grid": ARRAY, "flow": ARRAY}
        for name, array in TETS.items():
            if real_file(mode, name + ".vtu"):
                short = name.removesuffix("_tets")
                self.about[short], self.arrays[short] = name + ".vtu", array

    def source(self, name):
        if name not in self.kinds:
            return real_file(self.mode, f"{name}_tets.vtu")
        file = self.runner.path("sources", f"{name}.vtu")
        if not file.exists():
            self.runner.case("make", self.kinds[name], self.mode[name], file)
        return file

    def file(self, name, form):
        """One array: sorted along a curve, but for grids. form: vtu-raw, vtu-zlib, gtn, gtn-small, layers
        or hierarchy."""
        file = self.runner.path("files", f"{name}-{form}.{'vtu' if 'vtu' in form else 'gtn'}")
        if file.exists():
            return file
        if form in ("layers", "hierarchy"):
            options = ("--layers", self.arrays[name]) if form == "layers" else (
                "--hierarchy", "--weight", self.arrays[name])
            self.runner.say(f"gtn pack {' '.join(options)} {name}")
            self.runner.gtn("pack", "-q", "--profile", "fast", *options, self.file(name, "vtu-raw"), file)
        else:
            order = ("--morton",) if name == "delaunay" else ()
            self.runner.case("prepare", self.source(name), file, "--format", form, "--array",
                             self.arrays[name], *order)
        return file

    def shown(self, *names):
        """Those of some meshes that are available with an array."""
        return [name for name in names if self.arrays.get(name)]


def rounds_of(count, ways):
    """ways: functions without arguments that measure once. They take turns."""
    found = {name: [] for name in ways}
    for _ in range(count):
        for name, measure in ways.items():
            found[name].append(measure())
    return found


def extension(form):
    return {"gtn": "gtn", "vtu": "vtu", "zstd": "zst"}[form.split("-")[0]]


def simulate_misses(runner, file, cells):
    """Mispredicted branches per cell of loading a file, as Cachegrind's simple predictor finds them. Of two
    runs, one loads the file once more."""
    log = runner.path("cachegrind.log")

    def count(rounds):
        runner.say(f"load {file} --rounds {rounds} (Cachegrind)")
        runner.run("valgrind", "--tool=cachegrind", "--branch-sim=yes", "--cache-sim=no", f"--log-file={log}",
                   "--cachegrind-out-file=/dev/null", *runner.command(1, "load", file, "--rounds", rounds))
        told = re.search(r"Mispredicts: +([\d,]+)", log.read_text(encoding="utf-8"))
        return int(told[1].replace(",", ""))
    return (count(1) - count(0)) / cells


def measure_files(runner, mode, meshes, processors):
    """Sizes, packing and loading, points and cells in random order but for the grid; then meshes of other
    cells."""
    measured = []
    sources = [(name, meshes.source(name), about) for name, about in meshes.about.items()]
    sources += [(name, meshes.source(name), "") for name in MADE_CELLS]
    sources += [(name, real_file(mode, name + ".vtu"), "") for name in CELLS]
    for name, source, about in sources:
        if source is None:
            continue
        is_large, is_main = name == "grid", name in ("delaunay", "grid")
        if name in meshes.about and not is_large:
            permuted = runner.path("permuted.vtu")
            runner.case("prepare", source, permuted, "--permute")
            source = permuted
        folder = runner.folder("pack")
        entry = {"name": name, "about": about, "pack": runner.case("pack", source, folder, "--rounds", 0)}
        files = {form: folder / f"{form}.{extension(form)}" for form in LOADED}
        entry["loads"] = [
            {**load, **{key: dict(zip(LOADED, load[key])) for key in ("seconds", "branchMisses")}}
            for load in (runner.case("load", *files.values(), "--rounds", mode["few" if is_large else "rounds"],
                                     threads=threads)
                         for threads in (dict.fromkeys((1, processors)) if is_main else (1,)))]
        if is_main or name in MADE_CELLS:
            entry["packing"] = runner.case(
                "pack", source, folder, "--rounds", 1 if is_large else mode["few"], "--formats",
                ",".join((*PROFILES, "vtu-zlib")), threads=1)
        if is_main:
            entry["memory"] = {form: runner.case("load", files[form], "--rounds", 0)
                               for form in (*PROFILES, "vtu-zlib")}
        counted = entry["loads"][0]["branchMisses"]["gtn"] is not None
        if (name in MADE_CELLS or name == "flow") and not counted and shutil.which("valgrind"):
            entry["simulatedMisses"] = simulate_misses(runner, files["gtn"], entry["pack"]["cells"])
        measured.append(entry)
        shutil.rmtree(folder)
    return measured


def measure_steps(runner, mode, meshes):
    """Forward through time steps of a mesh, in one file and in a .vtu file for each."""
    measured = []
    for mesh, moves in itertools.product(("delaunay", "flow"), (False, True)):
        name = f"{mesh}, points {'move' if moves else 'stand still'}"
        folder = runner.folder("steps")
        runner.case("make-steps", meshes.source(mesh), folder, "--steps", mode["steps"],
                    *(("--moves",) if moves else ()))
        files = []
        for form, profile in PROFILES.items():
            files.append(runner.path(f"steps-{form}.gtn"))
            runner.gtn("pack", "-q", "-f", "--profile", profile, *sorted(folder.glob("*.vtu")), files[-1])
        known = runner.case("steps", folder, *files, "--rounds", mode["few"], threads=1)
        forms = ("vtu-zlib", *PROFILES)
        measured.append({"name": name, **known,
                         **{key: dict(zip(forms, known[key])) for key in ("bytes", "seconds")}})
        shutil.rmtree(folder)
    return measured


def measure_images(runner, mode, meshes, threads):
    """From a file to the first image, each a separate process, in turns; then later images."""
    if runner.display is None:
        runner.say("Without a display or xvfb-run, images in windows are not measured.")
        return None
    first = []
    for name, size in (("delaunay", mode["sizes"][0]), ("grid", mode["sizes"][-1])):
        def draw(form, budget, name=name, size=size):
            return lambda: runner.case("image", meshes.file(name, form), "--size", size, "--budget",
                                       budget, threads=threads, window=True)
        ways = {"gtn": draw("gtn", 512), "gtn-0": draw("gtn", 0), "vtu-zlib": draw("vtu-zlib", 0)}
        if name == "grid":
            ways["gtn-small"] = draw("gtn-small", 512)
        first.append({"name": name, "size": size, **rounds_of(mode["few"], ways)})
    later = []
    for name in meshes.shown("delaunay", "grid", "bluntfin"):
        for count in dict.fromkeys((threads, 1)) if name == "delaunay" else (threads,):
            later.append({"name": name, **runner.case(
                "frames", meshes.file(name, "vtu-raw"), "--size", mode["sizes"][-1], "--array",
                meshes.arrays[name], "--rounds", mode["few"], threads=count, window=True)})
    return {"first": first, "later": later}


def measure_contours(runner, mode, meshes):
    """An isosurface at the median, each a separate process, in turns; then in memory."""
    measured = []
    for name in meshes.shown("grid", "delaunay", "bluntfin"):
        array = ("--array", meshes.arrays[name])
        value = runner.case("quantiles", meshes.file(name, "vtu-raw"), *array, "--values", 0.5)
        options = (*array, "--values", value["values"][0])
        files = rounds_of(mode["rounds"], {
            form: lambda form=form: runner.case("contour", meshes.file(name, form), *options)
            for form in ("gtn", *(("gtn-small",) if name == "grid" else ()), "layers", "vtu-zlib")})
        measured.append({"name": name, "tets": value["tets"], "files": files, "memory": runner.case(
            "contour-memory", meshes.file(name, "vtu-raw"), *options, "--rounds", mode["rounds"])})
    return measured


def measure_simplification(runner, mode, meshes):
    return [{"name": name, **runner.case("simplify", meshes.file(name, "vtu-raw"), "--array",
                                         meshes.arrays[name], "--parts", "0.1", "--samples", mode["samples"],
                                         threads=1)}
            for name in meshes.shown("delaunay", "flow", "bluntfin", "comb", "kiefer_bracket")]


def best_settings(points):
    """Those settings of zfp of which no other one has fewer bits and no larger error."""
    points = [point for point in points if point["psnr"] is not None]
    return [point for point in points if not any(
        other["bits"] < point["bits"] and other["psnr"] >= point["psnr"] for other in points)]


def find_volumes(mode):
    found = {name: real_file(mode, file) for name, file in VOLUMES.items()}
    return {"head": f"head:{mode['voxels']}", **{name: file for name, file in found.items() if file}}


def measure_volumes(runner, mode):
    """Gatun's bits at the errors of those settings of zfp that are nearest to 40 and 50 dB, and without
    loss; then views."""
    measured = []
    for name, volume in find_volumes(mode).items():
        scratch = runner.path("volume.ghv")
        first = runner.case("volume", volume, scratch, "--psnr", 0)
        points = best_settings([point for way in ("accuracy", "precision")
                                for point in first.get("zfp", {}).get(way, [])])
        zfp = [min(points, key=lambda point: abs(point["psnr"] - wanted)) for wanted in (40, 50)
               if points]
        own = runner.case("volume", volume, scratch, "--psnr",
                          ",".join(str(point["psnr"]) for point in zfp))["gatun"] if zfp else []
        entry = {"name": name, "voxels": first["voxels"], "vtiBits": first["vtiBits"], "zfp": zfp,
                 "gatun": own, "lossless": first["gatun"][0],
                 "reversible": first.get("zfp", {}).get("reversible", [None])[0]}
        if runner.display is not None:
            entry["views"] = runner.case("volume-views", volume, runner.path("views"), "--blocks", "8,16,32",
                                         "--pixels", mode["sizes"][0], "--rounds", mode["few"], window=True)
        measured.append(entry)
    return measured


def find_surfaces(runner, mode, meshes):
    """Names and .vtp files without arrays, one after the other."""
    file, whole = runner.path("surface.vtp"), runner.path("contour.vtp")
    runner.case("make-surface", file, "--triangles", mode["scan"])
    yield "scan", file
    sources = {"delaunay, isosurface": (meshes.source("delaunay"), 3)}
    for name, real, count in (("mr, isosurface", VOLUMES["mr"], 1),
                              ("kiefer_bracket, boundary", "kiefer_bracket_tets.vtu", 0)):
        if real_file(mode, real):
            sources[name] = (real_file(mode, real), count)
    for name, (source, count) in sources.items():
        if count:
            array = ("--array", ARRAY) if source.suffix == ".vtu" else ()
            runner.gtn("contour", "-q", "-f", "--precision", "single", *array, "--number", count, source, whole)
        runner.case("make-surface", file, "--mesh", whole if count else source)
        yield name, file


def measure_surfaces(runner, mode, meshes):
    """Each round has all ways. Of OpenCTM only the size is of interest."""
    measured = []
    for name, file in find_surfaces(runner, mode, meshes):
        folder = runner.folder("peers")
        packed = {form: folder / f"{form}.gtn" for form in PROFILES}
        for form, profile in PROFILES.items():
            runner.gtn("pack", "-q", "--profile", profile, file, packed[form])
        obj, draco, ctm = folder / "peers.obj", folder / "peer.drc", folder / "peer.ctm"
        entry = {"name": name, "seconds": {}}
        for _ in range(mode["few"]):
            known = runner.case("surface", file, folder, *packed.values(), threads=1)
            for way, seconds in known.pop("seconds").items():
                entry["seconds"].setdefault(way, []).extend(seconds)
            entry.update({**known, "bytes": {**entry.get("bytes", {}), **known["bytes"]}})
            if shutil.which("draco_encoder"):
                if not draco.exists():
                    runner.run("draco_encoder", "-i", obj, "-o", draco, "-qp", 0)
                told = runner.run("draco_decoder", "-i", draco, "-o", folder / "peer.ply")
                seconds = max(1, int(re.search(r"\((\d+) ms to decode", told)[1])) / 1000
                entry["seconds"].setdefault("draco", []).append(seconds)
                entry["bytes"]["draco"] = draco.stat().st_size
        if shutil.which("ctmconv"):
            runner.run("ctmconv", obj, ctm, "--method", "MG1", "--level", 9)
            entry["bytes"]["openctm"] = ctm.stat().st_size
        measured.append(entry)
        shutil.rmtree(folder)
    return measured


def count_faces(runner, source):
    boundary, packed = runner.path("boundary.vtp"), runner.path("boundary.gtn")
    runner.case("make-surface", boundary, "--mesh", source)
    runner.gtn("pack", "-q", "-f", boundary, packed)
    return runner.info(packed)["cells"]


def measure_fly(runner, mode, meshes, name):
    """Figures 13, 14 and 17, and Table 4."""
    large = name == "grid"
    limits = (0, 256, 128) if large else (0, 128) if name == "delaunay" else (0, 64)
    ways = {"gatun": ("gtn", ()), "generic": ("gtn", ("--whole",)), "vtu": ("vtu-zlib", ("--whole",))}
    array = ("--array", meshes.arrays[name])
    cases = []
    for limit in limits if runner.limiter else (0,):
        for size in ((256, 1024) if large else (128, 256, 512, 1024)) if mode["real"] else (32,):
            def draw(form, options, limit=limit, size=size):
                arguments = ("fly", meshes.file(name, form), "--size", size, *array, *options)
                return lambda: (runner.limited(limit, *arguments) if limit else
                                runner.case(*arguments))
            cases.append({"limit": limit, "size": size, "ways": rounds_of(
                1 if limit and large else mode["few"],
                {way: draw(*how) for way, how in ways.items()})})
    ratios = []
    for ratio in RATIOS.split(","):
        def simplify(*options, ratio=ratio):
            return lambda: runner.case("fly", meshes.file(name, "hierarchy"), "--size", 256, "--ratio", ratio,
                                       *array, *options)
        ratios.append({"ratio": float(ratio), **rounds_of(
            mode["few"], {"gatun": simplify(), "generic": simplify("--whole")})})
    return {"cases": cases, "ratios": ratios}


def measure_dissertation(runner, mode, meshes):
    blocks = ",".join(map(str, mode["blocks"]))
    tables = {name: {"table1": runner.case("table1", volume, "--blocks", blocks, "--rays", mode["rays"]),
                     "table2": [runner.case("table2", volume, "--blocks", f"2,{blocks}", "--opacity", opacity)
                                for opacity in (0.02, 0.1)]}
              for name, volume in find_volumes(mode).items() if name != "mr"}
    measured = []
    for name in meshes.shown("bluntfin", "comb", "delaunay", "grid"):
        known = runner.info(meshes.file(name, "gtn"))
        measured.append({
            "name": name, "points": known["points"], "tets": known["tets"],
            "boundary": count_faces(runner, meshes.file(name, "vtu-raw")),
            **measure_fly(runner, mode, meshes, name),
            "simplified": runner.case("simplified", meshes.file(name, "hierarchy"), "--size", 256, "--ratios",
                                      RATIOS, "--array", meshes.arrays[name], "--rounds", mode["few"])})
    return {"tables": tables, "meshes": measured}


def measure(runner, mode):
    results = {"quick": mode is QUICK, "machine": running.machine(runner)}
    threads = results["machine"]["processors"]
    meshes = Meshes(runner, mode, results["machine"]["tetgen"])
    results["files"] = measure_files(runner, mode, meshes, threads)
    results["steps"] = measure_steps(runner, mode, meshes)
    results["images"] = measure_images(runner, mode, meshes, threads)
    results["contours"] = measure_contours(runner, mode, meshes)
    results["simplification"] = measure_simplification(runner, mode, meshes)
    results["volumes"] = measure_volumes(runner, mode)
    results["surfaces"] = measure_surfaces(runner, mode, meshes)
    results["dissertation"] = measure_dissertation(runner, mode, meshes)
    results["machine"]["loadAfter"] = os.getloadavg()[0]
    results["seconds"] = time.monotonic() - runner.start
    return results


def rounded(value):
    """Results with six significant digits, which are many times those of the pages."""
    if isinstance(value, float):
        return float(f"{value:.6g}")
    if isinstance(value, dict):
        return {key: rounded(one) for key, one in value.items()}
    return [rounded(one) for one in value] if isinstance(value, (list, tuple)) else value


def pages(results, out):
    """The text of each page, by its file. out: the folder, with the plots that exist."""
    plots = {file.stem for file in (out / "performance").glob("*.png")}
    return {out / "performance.md": performancePage.page(results),
            out / "dissertation.md": dissertationPage.page(results, plots)}


def readme(results):
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    before, rest = text.split(BEGIN, 1)
    return f"{before}{BEGIN}\n{performancePage.readme_table(results)}\n{END}{rest.split(END, 1)[1]}"


def find_differing():
    """The generated files of the documentation that do not follow from the results."""
    results = json.loads((DOCUMENTATION / "performance" / "results.json").read_text(encoding="utf-8"))
    wanted = {**pages(results, DOCUMENTATION), ROOT / "README.md": readme(results)}
    return [file for file, text in wanted.items()
            if not file.exists() or file.read_text(encoding="utf-8") != text]


def write(results, out):
    dissertationPage.draw(results, out / "performance")
    for file, text in pages(results, out).items():
        file.write_text(text, encoding="utf-8")
    if out.resolve() == DOCUMENTATION:
        text = readme(results)
        (ROOT / "README.md").write_text(text, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build" / "release" / "bin",
                        help="the folder of gatunBenchmarks and gtn")
    parser.add_argument("--out", type=pathlib.Path, default=DOCUMENTATION,
                        help="the folder of the pages, if it is not Documentation")
    parser.add_argument("--quick", action="store_true", help="tiny meshes, one round: a smoke test")
    parser.add_argument("--rounds", type=int, help="as many rounds everywhere")
    parser.add_argument("--pages", action="store_true", help="measure nothing, write the pages again")
    options = parser.parse_args()
    file = options.out / "performance" / "results.json"
    file.parent.mkdir(parents=True, exist_ok=True)
    if not options.pages:
        mode = QUICK if options.quick else FULL
        if options.rounds:
            mode.update(rounds=options.rounds, few=options.rounds)
        with tempfile.TemporaryDirectory(prefix="gatun-bench-") as work:
            results = measure(running.Runner(options.programs, pathlib.Path(work)), mode)
        text = re.sub(r"\[\s+([-\d.,\se+]+?)\s+\]", lambda found: f"[{' '.join(found[1].split())}]",
                      json.dumps(rounded(results), indent=1))
        file.write_text(text + "\n", encoding="utf-8")
    write(json.loads(file.read_text(encoding="utf-8")), options.out)
    print(f"The pages are in {options.out}.")


if __name__ == "__main__":
    sys.exit(main())
