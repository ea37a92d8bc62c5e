#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Runs the study of scaling on tiny meshes and checks what must hold for any mesh, and the model on numbers
that are known.

Usage: testScaling.py FOLDER_OF_PROGRAMS SCRATCH_FOLDER
"""

import json
import pathlib
import shutil
import subprocess
import sys

import scalingModel as model
import scalingText


def require(condition, what):
    if not condition:
        sys.exit(f"testScaling: {what}")


def run(programs, out, *options):
    script = pathlib.Path(__file__).parent / "runScaling.py"
    done = subprocess.run([sys.executable, script, "--smoke", *options, "--programs", programs, "--out", out],
                          check=False)
    if done.returncode != 0:
        sys.exit(done.returncode)
    return json.loads((out / "scaling" / "results.json").read_text(encoding="utf-8"))


def check_tables(tables):
    sizes = [one["chunks"] for one in tables]
    require(sizes == sorted(sizes, reverse=True) and sizes[0] > 100, "the chunks do not become fewer")
    for one in tables:
        require(model.table_bytes(one) > 0 and one["sections"]["MESH"] > 0, "a section was not found")
        for opened in one["opened"]:
            require(opened["read"] > 0 and opened["kept"] <= opened["peak"], "what opening takes is wrong")


def check_run(run_of):
    """Open MPI has seen the bytes that the writer has counted, but for calls that collect a number of each."""
    ranks = run_of["ranks"]
    rest = set()
    for one, seen in zip(run_of["processes"], run_of["messages"], strict=True):
        require(seen["to"].count(0) == 1, "a rank sends to itself, or not to another one")
        collected = one["sent"] - sum(seen["bytes"]) - seen["broadcastBytes"]
        require(collected % (8 * (ranks - 1)) == 0 and collected > 0, "other bytes than those counted")
        rest.add(collected)
    require(len(rest) == 1, "ranks have different numbers of collective calls")


def check_model(results):
    k = model.constants(results)
    for run_of in k.usual.values():
        require(run_of["chunks"] == model.count_chunks(run_of["tets"], run_of["ranks"]), "other chunks")
    require(k.groups > 0 and k.gathered > 0 and k.tables.disk > 0, "chunks take nothing")
    alone, *others = [model.predict(k, 10**12, ranks) for ranks in model.RANKS]
    require(alone.messages == alone.groups == alone.gathered == 0, "a single rank sends something")
    for fewer, more in zip(others, others[1:]):
        require(more.stages["encoding"] < fewer.stages["encoding"] and more.messages > fewer.messages,
                "more ranks do not share the work, or do not send more messages")
    first = others[0]
    require(first.rounds > 1 and first.messages > 15 * k.pair, "the exchange has one round")
    for one in others:
        require(abs(sum(one.stages.values()) - one.seconds) < 1e-9 * one.seconds, "the stages are not all")


def check_text():
    for value, text in ((0, "0 bytes"), (999, "999 bytes"), (1536, "1.50 KiB"), (3 * 2**40, "3.00 TiB"),
                        (1000 * 2**30, "0.98 TiB")):
        require(scalingText.size(value) == text, f"{value} bytes are {scalingText.size(value)}")
    for value, text in ((0, "0 s"), (2e-6, "2.00 us"), (0.25, "250 ms"), (7200, "120 min"),
                        (864000, "10.0 days")):
        require(scalingText.duration(value) == text, f"{value} s are {scalingText.duration(value)}")
    require(scalingText.amount(1.5e9) == "1.50e9" and scalingText.power(10**12) == "10^12", "numbers")


def main():
    programs, out = map(pathlib.Path, sys.argv[1:])
    shutil.rmtree(out, ignore_errors=True)
    check_text()
    before = run(programs, out, "--before")
    results = run(programs, out)
    require(results["before"]["tables"] == before["tables"], "the tables to compare with were not kept")
    check_tables(results["tables"])
    for run_of in results["ranks"]:
        check_run(run_of)
    check_model(results)
    page = (out / "scaling.md").read_text(encoding="utf-8")
    for part in "Where it stops scaling", "What would be next", "Limits of numbers", "model / measured":
        require(part in page, f"the page says nothing of {part}")


if __name__ == "__main__":
    main()
