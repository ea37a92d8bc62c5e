#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Measures the goals of speed and memory: images, loading, packing, isosurfaces, hierarchies and regular
volumes, each beside its peer.

Writes speed.md and the folder speed.
"""

import os
import pathlib
import subprocess
import sys
import time

import benchmarkRunner
import displays
import speedReport

PAGE = "speed"
ARRAY = "Density"

# Tetrahedra, pixels, rounds; "few" rounds are for what takes seconds. The size of a made volume, for lack
# of a real one, and of its blocks.
MODES = {
    "full": {"delaunay": 1000000, "big": 5000000, "sizes": (512, 1024), "rounds": 7, "few": 3,
             "volume": 256, "blocks": (4, 8, 16, 32, 64)},
    "quick": {"delaunay": 100000, "big": 400000, "sizes": (256, 512), "rounds": 3, "few": 2,
              "volume": 64, "blocks": (4, 16)},
    "smoke": {"delaunay": 3000, "big": 5000, "sizes": (64,), "rounds": 1, "few": 1,
              "volume": 24, "blocks": (4,)},
}
VOLUME = "CT_AVM.nii.gz"


def run_process(runner, program, *arguments):
    """Seconds from start to end of a process, and the bytes that it had resident at most."""
    runner.say(" ".join(map(str, (program, *arguments))))
    start = time.monotonic()
    with subprocess.Popen(runner.command(program, *arguments), stdout=subprocess.DEVNULL) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    seconds = time.monotonic() - start
    if process.returncode != 0:
        sys.exit(f"runSpeed: {program} failed")
    return {"seconds": seconds, "processor": usage.ru_utime + usage.ru_stime,
            "peak": 1024 * usage.ru_maxrss}


def make_meshes(runner, mode, delaunay, data):
    """Each mesh with one array, raw, with zlib and as .gtn, all with default settings."""
    sources = {}
    for name in ("bluntfin", "comb") if data else ():
        sources.update({name: (file, ()) for file in sorted(data.glob(f"{name}_tets*.vtu"))[:1]})
    for name, kind, options in (("delaunay", "delaunay" if delaunay else "lattice", ("--morton",)),
                                ("big", "flow1", ())):
        made = runner.path(f"{name}.vtu")
        runner.case("make", kind, mode[name], made)
        sources[name] = (made, options)
    meshes = {}
    for name, (source, options) in sources.items():
        meshes[name] = {}
        for form, ending in ("vtu-raw", "raw.vtu"), ("vtu-zlib", "zlib.vtu"), ("gtn", "packed.gtn"):
            meshes[name][form] = runner.path(name, f"{name}-{ending}")
            runner.case("prepare", source, meshes[name][form], "--array", ARRAY, "--format", form,
                        *options)
    return meshes


def measure_mapper(runner, meshes, mode):
    """Later images by the mappers on one thread, and by each instruction set."""
    found = []
    for name, files in meshes.items():
        for size in mode["sizes"]:
            few = name == "big"
            rounds = mode["few"] if few else mode["rounds"]
            mappers = runner.case("render", files["vtu-raw"], "--size", size, "--mappers", "gatun,bunyk",
                                  "--rounds", rounds, "--first-rounds", 1, "--array", ARRAY, threads=1,
                                  window=True)
            sets = runner.case("instructions", files["vtu-raw"], "--size", size, "--rounds", rounds,
                               "--array", ARRAY, threads=1)
            found.append({"mesh": name, "size": size, "mappers": mappers, "instructions": sets})
    return found


def measure_big(runner, meshes, mode):
    """Later images of the largest mesh by all threads."""
    return runner.case("render", meshes["big"]["vtu-raw"], "--size", mode["sizes"][-1], "--mappers",
                       "gatun,bunyk", "--rounds", mode["few"], "--first-rounds", 1, "--array", ARRAY,
                       threads=runner.threads, window=True)


def measure_processes(runner, meshes, mode):
    """gtn render from start to end, and VTK from file to first image without the start of its process."""
    small, large = mode["sizes"][0], mode["sizes"][-1]
    image = runner.path("image.png")
    result = {"version": [], "gtn": [], "bunyk": [], "big": []}
    for _ in range(mode["few"]):
        result["version"].append(run_process(runner, "gtn", "--version"))
        result["gtn"].append(run_process(runner, "gtn", "render", "-q", "-f", "--size",
                                         f"{small}x{small}", meshes["delaunay"]["gtn"], image))
        result["bunyk"].append(runner.case("picture", meshes["delaunay"]["vtu-zlib"], "--size", small,
                                           "--array", ARRAY, threads=runner.threads, window=True))
        result["big"].append(run_process(runner, "gtn", "render", "-q", "-f", "--size",
                                         f"{large}x{large}", meshes["big"]["gtn"], image))
    return result


def measure_files(runner, meshes, mode):
    """Loading with up to four threads, from the page cache and from the disk; its memory; writing."""
    result = {}
    counts = [threads for threads in (1, 2, 4) if threads <= max(2, runner.threads)]
    for name in "delaunay", "big":
        folder = runner.folder(f"files-{name}")
        source = runner.path(f"{name}-permuted.vtu")
        runner.case("prepare", meshes[name]["vtu-raw"], source, "--permute")
        runner.case("size", source, folder)
        one = result[name] = {"peak": {
            form: runner.case("peak", folder / file, threads=runner.threads)
            for form, file in (("gtn", "gtn.gtn"), ("vtu-zlib", "vtu-zlib.vtu"))}}
        if name == "delaunay":
            for key, options in ("load", ()), ("cold", ("--cold",)):
                one[key] = [runner.case("load", folder, *options, "--rounds", mode["rounds"],
                                        threads=threads) for threads in counts]
            one["write"] = [runner.case("write", source, folder, "--rounds", mode["few"],
                                        threads=threads) for threads in (1, 2)]
    return result


def make_layered(runner, meshes):
    """The Delaunay mesh in a file with layers."""
    layered = runner.path("layered.gtn")
    runner.run("gtn", "pack", "-q", "-f", "--layers", ARRAY, meshes["delaunay"]["vtu-raw"], layered)
    return layered


def measure_layers(runner, plain, layered, mode):
    """Whole reads and first images of a file with layers, and of one without."""
    result = {"load": runner.case("load-files", plain, layered, "--rounds", mode["rounds"],
                                  threads=runner.threads)}
    if displays.prefix() is not None:
        result["image"] = {"plain": [], "layered": []}
        for _ in range(mode["rounds"]):
            for key, file in ("plain", plain), ("layered", layered):
                result["image"][key].append(
                    runner.case("picture", file, "--size", mode["sizes"][0], "--array", ARRAY,
                                threads=runner.threads, window=True))
    return result


def measure_volumes(runner, data, mode):
    """Images of a regular volume at one bit per voxel, drawn from files, by size of blocks, and in one
    block. Errors are those of drawing alone, without any of compression."""
    volume = data / VOLUME if data else None
    if volume is None or not volume.exists():
        volume = f"head:{mode['volume']}"

    def run(blocks, rate, laws, *options):
        return runner.case("volume-times", volume, "--blocks", *blocks, "--rates", rate, "--laws", *laws,
                           "--pixels", mode["sizes"][0], "--rounds", mode["few"], "--folder",
                           runner.folder("volumes"), *options, threads=runner.threads)
    return {"name": getattr(volume, "name", volume),
            "blocks": run(mode["blocks"], 1, ("xray", "exponential"), "--peers"),
            "whole": run((0,), 1, ("xray",), "--peers"),
            "errors": run((8, 0), 0, ("xray",), "--errors")["errors"]}


def measure_surfaces(runner, meshes, layered, mode):
    """An isosurface from a file with layers, and by VTK from the whole mesh, in processes of their own."""
    files = meshes["delaunay"]
    values = runner.case("surface-values", files["vtu-raw"], "--array", ARRAY, "--parts", 0.1, 0.3, 0.5,
                         0.7, 0.9)["values"]
    found = []
    for value in values:
        runs = {"layers": [], "zlib": []}
        for _ in range(mode["few"]):
            for way, file, kind in ("layers", layered, "file"), ("zlib", files["vtu-zlib"], "linear"):
                runs[way].append(runner.case("surface", file, "--array", ARRAY, "--values", value,
                                             "--way", kind, threads=runner.threads))
        found.append({"value": value, **runs})
    return found


def measure(runner, options):
    mode = MODES[options.mode]
    results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner)}
    runner.threads = results["machine"]["processors"]
    data = os.environ.get("GATUN_DATA_DIR")
    data = pathlib.Path(data) if data and options.mode != "smoke" else None
    meshes = make_meshes(runner, mode, results["machine"]["tetgen"], data)
    results["files"] = measure_files(runner, meshes, mode)
    layered = make_layered(runner, meshes)
    results["surfaces"] = measure_surfaces(runner, meshes, layered, mode)
    results["layers"] = measure_layers(runner, meshes["delaunay"]["gtn"], layered, mode)
    results["hierarchy"] = runner.case("simplify-build", meshes["delaunay"]["vtu-raw"], "--array", ARRAY,
                                       "--rounds", mode["few"], "--threads", "1,2")
    results["volumes"] = measure_volumes(runner, data, mode)
    if displays.prefix() is not None:
        results["mapper"] = measure_mapper(runner, meshes, mode)
        results["big"] = measure_big(runner, meshes, mode)
        results["processes"] = measure_processes(runner, meshes, mode)
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = time.monotonic() - runner.start
    return results


def main():
    benchmarkRunner.run_page(benchmarkRunner.make_parser(__doc__, PAGE), PAGE, measure, speedReport.write)


if __name__ == "__main__":
    sys.exit(main())
