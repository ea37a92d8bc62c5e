#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Surfaces of triangles: bits by part and times of decoding, beside Draco, OpenCTM, meshoptimizer with
zstd, and .vtp files, without loss and with rounded coordinates. Frames of a large surface in motion.

Isosurfaces and boundaries are those of the folder GATUN_DATA_DIR, where it exists, and of meshes that it
makes. Peers that are not installed are left out.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import benchmarkRunner
import surfaceMotion
import surfaceReport

BITS = 14
LARGE = 10000000  # triangles of a scan, on request
MODES = {
    "full": {"delaunay": 1000000, "scans": (1000000,), "textured": 500000, "data": True,
             "rounds": 3},
    "quick": {"delaunay": 100000, "scans": (100000,), "textured": 50000, "data": True, "rounds": 3},
    "smoke": {"delaunay": 3000, "scans": (2000,), "textured": 1000, "data": False, "rounds": 1},
}
# Of GATUN_DATA_DIR: files with the options of gtn contour.
ISOSURFACES = {"comb": ("comb_tets.vtu", "--array", "Density", "--number", "5"),
               "brain": ("brain1_mr_int16.vti", "--number", "1")}
BOUNDARIES = {"bracket": "kiefer_bracket_tets.vtu"}


def data_file(mode, name):
    folder = os.environ.get("GATUN_DATA_DIR") if mode["data"] else None
    file = pathlib.Path(folder) / name if folder else None
    return file if file and file.exists() else None


def contour(runner, name, source, *options):
    """An isosurface without arrays, which not all peers can store."""
    whole, file = runner.path("contour.vtp"), runner.path(f"{name}.vtp")
    runner.run("gtn", "contour", "-q", "-f", *options, source, whole)
    runner.case("make-surface", "boundary", file, "--mesh", whole)
    whole.unlink()
    return file


def find_surfaces(runner, mode):
    """Names, files and what they are, one after the other. Each is removed after its use."""
    for name, (source, *options) in ISOSURFACES.items():
        if data_file(mode, source):
            yield name, contour(runner, name, data_file(mode, source), *options), "isosurface"
    for name, source in BOUNDARIES.items():
        if data_file(mode, source):
            file = runner.path(f"{name}.vtp")
            runner.case("make-surface", "boundary", file, "--mesh", data_file(mode, source))
            yield name, file, "boundary of tetrahedra"
    mesh = runner.path("delaunay.vtu")
    runner.case("make", "delaunay", mode["delaunay"], mesh)
    file = contour(runner, "delaunay", mesh, "--number", 3)
    yield "delaunay", file, "isosurface of a Delaunay mesh"
    file = runner.path("delaunay-boundary.vtp")
    runner.case("make-surface", "boundary", file, "--mesh", mesh)
    mesh.unlink()
    yield "delaunay-boundary", file, "boundary of a Delaunay mesh"
    kinds = [("textured", mode["textured"], "normals and texture coordinates"),
             *(("scan", count, "scan with noise") for count in mode["scans"])]
    for kind, count, what in kinds:
        file = runner.path(f"{kind}-{count}.vtp")
        runner.case("make-surface", kind, file, "--triangles", count)
        yield f"{kind}-{count}", file, what


def tool(*command):
    """The output of a peer's program."""
    done = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"runSurfaces: {' '.join(map(str, command))} failed: {done.stdout}")
    return done.stdout


def milliseconds(pattern, text):
    found = re.search(pattern, text)
    if not found:
        sys.exit(f"runSurfaces: no time in {text!r}")
    return float(found.group(1)) / 1000


def run_draco(source, folder, rounds, *options):
    """Bytes, and seconds of decoding as the program tells them."""
    packed, out = folder / "peer.drc", folder / "peer.ply"
    tool("draco_encoder", "-i", source, "-o", packed, "-cl", 10, *options)
    seconds = [milliseconds(r"\((\d+) ms to decode", tool("draco_decoder", "-i", packed, "-o", out))
               for _ in range(rounds)]
    return packed.stat().st_size, seconds


def run_openctm(source, folder, rounds):
    packed, out = folder / "peer.ctm", folder / "peer.ply"
    tool("ctmconv", source, packed, "--method", "MG1", "--level", 9)
    seconds = [milliseconds(r"Loading \S+ *([\d.]+) ms", tool("ctmconv", packed, out))
               for _ in range(rounds)]
    return packed.stat().st_size, seconds


def pack(runner, source, *options):
    packed = runner.path("packed.gtn")
    runner.run("gtn", "pack", "-q", "-f", *options, source, packed)
    info = json.loads(runner.run("gtn", "info", "--json", packed))
    return packed, {part: one["bytes"] for part, one in info["sizes"].items()}


def measure_surface(runner, name, file, what, mode):
    runner.say(f"{name}: {what}")
    packed, kept = pack(runner, file, "--keep-order", "all")
    packed, rounded = pack(runner, file, "--point-error", f"bits:{BITS}")
    packed, parts = pack(runner, file)
    runner.run("gtn", "verify", "-q", packed, file)
    folder = runner.folder("peers")
    result = {"name": name, "what": what, "parts": parts, "kept": kept, "rounded": {"gtn": rounded},
              **runner.case("surface-files", file, packed, folder, "--rounds", mode["rounds"],
                            threads=2)}
    peers = folder / "peers.obj"
    if shutil.which("draco_encoder"):
        exact = ("-qp", 0, "-qt", 0, "-qn", 0)
        result["bytes"]["draco"], result["seconds"]["draco"] = run_draco(
            peers, folder, mode["rounds"], *exact)
        bits = ("-qp", BITS, "-qt", 0, "-qn", 0)
        result["rounded"]["draco"], result["rounded"]["seconds"] = run_draco(
            peers, folder, mode["rounds"], *bits)
    if shutil.which("ctmconv"):
        result["bytes"]["openctm"], result["seconds"]["openctm"] = run_openctm(
            peers, folder, mode["rounds"])
    shutil.rmtree(folder)
    file.unlink()
    return result


def measure_motion(runner, options):
    """Measures images in motion and keeps all other results."""
    known = options.out / surfaceReport.PAGE / "results.json"
    if not known.exists():
        sys.exit(f"runSurfaces: {known} has no results to add to")
    results = json.loads(known.read_text(encoding="utf-8"))
    results["motion"] = surfaceMotion.measure(runner, options.mode)
    return results


def measure(runner, options):
    if options.motion:
        return measure_motion(runner, options)
    mode = dict(MODES[options.mode])
    if options.large:
        mode["scans"] += (LARGE,)
    results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner), "notes": [
        f"{tool_name} is not installed and is left out." for tool_name, program in
        (("Draco", "draco_encoder"), ("OpenCTM", "ctmconv")) if not shutil.which(program)]}
    results["surfaces"] = [measure_surface(runner, *surface, mode)
                           for surface in find_surfaces(runner, mode)]
    results["motion"] = surfaceMotion.measure(runner, options.mode)
    if "meshopt" not in results["surfaces"][0]["bytes"]:
        results["notes"].append("meshoptimizer was not there when the program was built.")
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = time.monotonic() - runner.start
    return results


def main():
    parser = benchmarkRunner.make_parser(__doc__, surfaceReport.PAGE)
    parser.add_argument("--large", action="store_true",
                        help=f"measure a scan of {LARGE:,} triangles, too")
    parser.add_argument("--motion", action="store_true",
                        help="measure only images in motion, and keep all other results")
    benchmarkRunner.run_page(parser, surfaceReport.PAGE, measure, surfaceReport.write)


if __name__ == "__main__":
    main()
