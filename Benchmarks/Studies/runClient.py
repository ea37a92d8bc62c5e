#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Time from opening a file in ParaView's window to the first image and to the first volume, and the peak memory of
the client: .gtn files beside .vtu files. Needs the ParaView build (Utilities/setup.sh test makes it)."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import benchmarkRunner
import clientReport
import displays

MODES = {
    "full": {"tets": 5000000, "rounds": 5},
    "quick": {"tets": 300000, "rounds": 2},
    "smoke": {"tets": 3000, "rounds": 1},
}
HERE = pathlib.Path(__file__).resolve().parent
PARAVIEW = HERE.parents[1] / "Utilities" / "pv-env.sh"
TIMEOUT = 900
# Case, how the file is packed, representation of the volume.
CASES = (
    ("vtu", None, "Volume"),
    ("gtn", [], "Gatun Volume"),
    ("gtn-boundary", ["--boundary"], "Gatun Volume"),
)


def find_plugin():
    printed = subprocess.run([PARAVIEW], stdout=subprocess.PIPE, text=True, check=True).stdout
    if "GATUN_PLUGIN" not in printed:
        sys.exit("runClient: there is no plugin; Utilities/setup.sh test builds it")
    return printed.split("GATUN_PLUGIN=", 1)[1].split()[0]


def run_client(runner, plugin, file, representation, picture=""):
    """One client, with a home of its own, so that its settings are ParaView's."""
    with tempfile.TemporaryDirectory(prefix="gatun-client-") as home:
        results = pathlib.Path(home) / "results.json"
        wanted = {"file": str(file), "representation": representation, "results": str(results),
                  "picture": str(picture)}
        environment = dict(os.environ, HOME=home, GATUN_MEASURE=json.dumps(wanted),
                           PV_PLUGIN_PATH=str(pathlib.Path(plugin).parent))
        environment.pop("XDG_CONFIG_HOME", None)
        log = runner.path("client.log")
        command = [*displays.prefix(), PARAVIEW, "paraview", "--plugins=Gatun", f"--script={HERE / 'measureClient.py'}"]
        with open(log, "wb") as out:
            subprocess.run([str(part) for part in command], stdout=out, stderr=subprocess.STDOUT, env=environment,
                           timeout=TIMEOUT, check=False)
        if not results.exists():
            sys.exit(f"runClient: the client failed:\n{log.read_text(encoding='utf-8', errors='replace')}")
        return json.loads(results.read_text(encoding="ascii"))


def make_files(runner, mode):
    """The file and its bytes, by case."""
    raw = runner.path("raw.vtu")
    runner.run("gatunBenchmarks", "make", "flow1", mode["tets"], raw)
    files = {"vtu": runner.path("mesh.vtu")}
    runner.run("gatunBenchmarks", "prepare", raw, files["vtu"], "--format", "vtu-zlib")
    for name, options, _ in CASES[1:]:
        files[name] = runner.path(f"{name}.gtn")
        runner.run("gtn", "pack", "-q", "-f", *options, raw, files[name])
    raw.unlink()
    return files


def measure(runner, options):
    mode = MODES[options.mode]
    plugin = find_plugin()
    results = {"mode": options.mode, "machine": benchmarkRunner.machine(runner)}
    files = make_files(runner, mode)
    results["tets"] = json.loads(runner.run("gtn", "info", "--json", files["gtn"]))["tets"]
    results["bytes"] = {name: file.stat().st_size for name, file in files.items()}
    results["rounds"] = []
    for number in range(mode["rounds"]):
        measured = {"idle": run_client(runner, plugin, "", ""), "load": os.getloadavg()[0]}
        for name, _, representation in CASES:
            runner.say(f"{name}, round {number + 1}")
            picture = options.out / clientReport.PAGE / f"{name}-volume.png" if options.pictures else ""
            measured[name] = run_client(runner, plugin, files[name], representation, picture)
        results["rounds"].append(measured)
    results["machine"]["loadAfter"] = os.getloadavg()
    results["seconds"] = time.monotonic() - runner.start
    return results


def main():
    parser = benchmarkRunner.make_parser(__doc__, clientReport.PAGE)
    parser.add_argument("--pictures", action="store_true", help="also save the last image of each case")
    benchmarkRunner.run_page(parser, clientReport.PAGE, measure, clientReport.write)


if __name__ == "__main__":
    sys.exit(main())
