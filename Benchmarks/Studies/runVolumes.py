#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Regular volumes as Hartley coefficients: repeats Tables 1 and 2 of the dissertation, and measures bits
by error compared with zfp, time for a view compared with voxel renderers, and image quality."""

import json
import os
import pathlib
import tempfile
import time

import benchmarkRunner
import volumeReport

PAGE = "volume-study"
ABOUT = {
    "ct": ("CT_AVM.nii.gz", "CT of a head with contrast agent in its vessels"),
    "mr": ("brain1_mr_int16.vti", "MR of a brain"),
    "head": (None, "synthetic: ellipsoids, vessels, noise"),
    "smooth": (None, "synthetic: waves under a bell"),
}

# The scale (pixels per voxel) is such that pixels along an axis fall on different places of a block,
# except for tiny volumes, where interpolation between the points of the images of blocks dominates.
MODES = {
    "full": {
        "volumes": {"ct": {}, "mr": {}, "head": {"size": 128}},
        "blocks": (2, 4, 8, 16, 32, 64, 0), "sampled": 1000, "rays": 100000,
        "opacities": (0.02, 0.1), "scale": 0.47,
        "rate blocks": (2, 4, 8, 16, 32, 64), "weights": (0,),
        "psnr": (25, 30, 35, 40, 45, 50, 55, 0),
        "times": "ct", "pixels": (256, 512, 1024), "time rates": (0.1, 0.5, 1, 2, 0),
        "threads": (1, 2), "rounds": 3, "plate": "ct",
        "qualities": (0, 0.2, 0.1, 0.05, 0.02),
        "plate blocks": (2, 4, 8, 16, 32), "plate scale": 1},
    "quick": {
        "volumes": {"ct": {}, "head": {"size": 64}},
        "blocks": (4, 8, 32), "sampled": 300, "rays": 50000,
        "opacities": (0.1,), "scale": 0.47,
        "rate blocks": (8, 16), "weights": (0,), "psnr": (30, 40, 0),
        "times": "head", "pixels": (128, 256), "time rates": (0.5, 0),
        "threads": (1, 2), "rounds": 2, "plate": "head", "qualities": (0, 0.2),
        "plate blocks": (4, 16), "plate scale": 1},
    "smoke": {
        "volumes": {"head": {"size": 24}, "smooth": {"size": 20}},
        "blocks": (4, 16), "sampled": 20, "rays": 2000,
        "opacities": (0.1,), "scale": 1,
        "rate blocks": (8,), "weights": (0,), "psnr": (30, 40, 0),
        "times": "head", "pixels": (32,), "time rates": (1,),
        "threads": (1,), "rounds": 1, "plate": "head", "qualities": (0, 0.5),
        "plate blocks": (4, 8), "plate scale": 1},
}

# Density, red, green, blue and opacity.
FUNCTIONS = {
    "ct": (0, 0.3, 0.02, 0, 0,  40, 0.5, 0.06, 0.03, 0.01,  110, 0.85, 0.25, 0.12, 0.06,
           170, 1, 0.6, 0.35, 0.15,  255, 1, 1, 0.9, 0.4),
    "head": (0, 0, 0, 0, 0,  60, 0.3, 0.3, 0.4, 0.002,  150, 0.9, 0.8, 0.6, 0.01,
             185, 0.9, 0.8, 0.6, 0.02,  200, 0.9, 0.15, 0.1, 0.2,  255, 1, 0.3, 0.2, 0.4),
}
TURNS = {"ct": (-0.5, 0.1, 0), "head": (-0.5, 0.15, 0)}
# Large blocks are drawn by slices in any case.
FEW_WAYS = ("gatun", "trilinear-1", "trilinear-2")
ALL_WAYS = (*FEW_WAYS, "slice")
LAWS = {"xray": ("--law", "xray"),
        "exponential": ("--law", "exponential", "--opacity", 0.25),
        "function": ("--law", "linear")}


def find(name, wanted, data):
    """The name of the volume for gatunBenchmarks; None if it is not available."""
    if "size" in wanted:
        return f"{name}:{wanted['size']}"
    file = data / ABOUT[name][0] if data else None
    return file if file and file.exists() else None


def measure_blocks(runner, volume, mode):
    """Table 1: all methods for the image of a block, and ours at one bit per voxel."""
    runs = []
    for block in mode["blocks"]:
        for rate, ways in ((0, ALL_WAYS if block and block < 32 else FEW_WAYS), (1, ("gatun",))):
            runs.append(runner.case("volume-blocks", volume, "--block", block, "--rate", rate,
                                    "--blocks", mode["sampled"], "--rays", mode["rays"], "--ways", *ways))
    return runs


def measure_pictures(runner, volume, mode):
    """Table 2; the first opacity also at one bit per voxel."""
    return [runner.case("volume-pictures", volume, "--blocks", *mode["blocks"], "--rates", 0,
                        *((1,) if opacity == mode["opacities"][0] else ()),
                        "--opacity", opacity, "--scale", mode["scale"])
            for opacity in mode["opacities"]]


def measure_rates(runner, volume, mode):
    return runner.case("volume-rates", volume, runner.path("volumes", "rates.ghv"),
                       "--blocks", *mode["rate blocks"], "--psnr", *mode["psnr"],
                       "--weights", *mode["weights"])


def measure_times(runner, _, volume, mode):
    """By size of blocks, quality, size of the image, and number of threads."""
    def run(blocks, rates, pixels, threads=0):
        return runner.case("volume-times", volume, "--blocks", *blocks, "--rates", *rates,
                           "--pixels", pixels, "--rounds", mode["rounds"], "--peers",
                           *(["--window"] if window else []), threads=threads, window=window)
    window = bool(benchmarkRunner.displays.prefix() is not None)
    middle = mode["pixels"][len(mode["pixels"]) // 2]
    return {"blocks": run(mode["blocks"], [1], middle),
            "rates": run([8], mode["time rates"], middle),
            "pixels": [run([8, 16], [1], pixels) for pixels in mode["pixels"]],
            "threads": [run([8, 16], [1], middle, threads) for threads in mode["threads"]]}


def draw_plate(runner, name, volume, mode):
    """A row per opacity model: from voxels first, then at fewer and fewer bits, and with larger blocks."""
    plates = {"qualities": [(4, rate) for rate in mode["qualities"]],
              "sizes": [(block, 0) for block in mode["plate blocks"]]}
    pictures = []
    for law, arguments in LAWS.items():
        if law == "function":
            arguments = (*arguments, "--nodes", *FUNCTIONS[name])
        white = 0

        def draw(plate, block, rate, *more):
            file = runner.path("volumes", f"{law}-{plate}-{block}-{rate}.png")
            run = runner.case("volume-draw", volume, file, runner.path("volumes", "draw.ghv"),
                              "--turns", *TURNS[name], "--scale", mode["plate scale"], "--block",
                              block, "--rate", rate, "--white", white, *arguments, *more)
            pictures.append({"law": law, "plate": plate, "block": block, "rate": rate,
                             "file": str(file), **run})
            return run
        # All images share one white, which the image from voxels determines; it is then drawn again.
        white = 0.6 * draw("voxels", 2, 0, "--voxels")["white"]
        pictures.pop()
        draw("voxels", 2, 0, "--voxels")
        for plate, wanted in plates.items():
            for block, rate in wanted:
                draw(plate, block, rate)
    return pictures


def measure_volume(runner, name, volume, mode):
    return {"name": name, "about": ABOUT[name][1],
            "blocks": measure_blocks(runner, volume, mode),
            "pictures": measure_pictures(runner, volume, mode),
            "rates": measure_rates(runner, volume, mode)}


def measure(runner, options, results, save):
    """Measures everything, or the parts of --only, whose results replace the previous ones. Saves after
    each part."""
    mode = MODES[options.mode]
    if not options.only:
        results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner), "volumes": []}
    data = os.environ.get("GATUN_DATA_DIR")
    data = pathlib.Path(data) if data else None
    parts = options.only or [*mode["volumes"], *PARTS]
    for name in mode["volumes"]:
        volume = find(name, mode["volumes"][name], data)
        if name not in parts:
            continue
        if volume is None:
            runner.say(f"{name} is left out: it is not in GATUN_DATA_DIR")
            continue
        results["volumes"] = [one for one in results["volumes"] if one["name"] != name]
        results["volumes"].append(measure_volume(runner, name, volume, mode))
        save(results)
    for part, make in PARTS.items():
        if part in parts:
            # The real volume if it is available, else the synthetic one.
            name = mode[part]
            volume = find(name, mode["volumes"][name], data)
            if volume is None:
                name, volume = "head", "head:128"
            results[part] = {"name": name, "runs": make(runner, name, volume, mode)}
            save(results)
    order = list(ABOUT)
    results["volumes"].sort(key=lambda one: order.index(one["name"]))
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = results.get("seconds", 0) + time.monotonic() - runner.start
    save(results)
    return results


PARTS = {"times": measure_times, "plate": draw_plate}


def save(results, file):
    """Saves the results without the names of temporary images."""
    kept = {**results}
    if "plate" in kept:
        kept["plate"] = {**kept["plate"], "runs": [
            {key: value for key, value in run.items() if key != "file"}
            for run in kept["plate"]["runs"]]}
    file.write_text(json.dumps(kept, indent=1) + "\n", encoding="utf-8")


def main():
    parser = benchmarkRunner.make_parser(__doc__, PAGE)
    parser.add_argument("--only", nargs="+", choices=[*MODES["full"]["volumes"], *PARTS],
                        help="measure these only, and keep the results of the others")
    options = parser.parse_args()
    folder = options.out / PAGE
    folder.mkdir(parents=True, exist_ok=True)
    raw = folder / "results.json"
    results = {}
    if options.report or options.only:
        results = json.loads(raw.read_text(encoding="utf-8"))
    if options.report:
        volumeReport.write(results, options.out)
    else:
        with tempfile.TemporaryDirectory(prefix=f"gatun-{PAGE}-") as work:
            runner = benchmarkRunner.Runner(options.programs, pathlib.Path(work), folder)
            results = measure(runner, options, results, lambda results: save(results, raw))
            # The plate is assembled while its images exist.
            volumeReport.write(results, options.out)
    print(f"The results are in {options.out / PAGE}.md and {folder}")


if __name__ == "__main__":
    main()
