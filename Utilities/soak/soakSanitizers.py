# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The tests of builds with sanitizers, with the environment that CMakePresets.json gives them."""

import json
import os
import re

from soakContext import ROOT, Finding, Task, run_process

# Tests that take longer under load and with a sanitizer than they may are tried again by themselves.
TIMED_OUT = re.compile(r"^\s*\d+ - (\S+) \(Timeout\)", re.MULTILINE)
SUMMARY = re.compile(r"(\d+)% tests passed, (\d+) tests? failed out of (\d+)")


def test_preset(name):
    """Environment and labels left out."""
    text = (ROOT / "CMakePresets.json").read_text(encoding="utf-8")
    presets = {preset["name"]: preset for preset in json.loads(text)["testPresets"]}
    preset = presets[name]
    while "environment" not in preset:
        preset = presets[preset["inherits"]]
    environment = {key: value.replace("${sourceDir}", str(ROOT))
                   for key, value in preset["environment"].items()}
    return environment, preset["filter"]["exclude"]["label"]


class Sanitizer(Task):
    """All tests of a build, once."""

    def __init__(self, context, preset):
        super().__init__(context)
        self.preset = preset
        self.kind = preset
        self.tree = context.build / preset

    def find_missing(self):
        tests = self.tree / "CTestTestfile.cmake"
        return None if tests.exists() else tests

    def test(self, *arguments):
        environment, labels = test_preset(self.preset)
        return run_process(
            ["ctest", "--test-dir", self.tree, "--label-exclude", labels, "--output-on-failure",
             "--parallel", self.context.jobs, "--no-label-summary", *arguments],
            environment={**os.environ, **environment}, timeout=4 * 3600)

    def run(self, _):
        self.is_done = True
        run = self.test()
        summary = SUMMARY.search(run.output)
        if not summary or int(summary[3]) == 0:
            raise Finding(f"{self.preset}: no tests", log=run.output[-20000:])
        failed = int(summary[2])
        self.counts["tests"] = int(summary[3])
        self.counts["skipped"] = run.output.count("(Skipped)")
        late = TIMED_OUT.findall(run.output)
        if late:
            again = self.test("-R", "^(" + "|".join(map(re.escape, late)) + ")$", "--timeout", 3600)
            summary = SUMMARY.search(again.output)
            failed += int(summary[2]) - len(late) if summary else 0
            self.counts["tried again, as they took too long"] = len(late)
        self.counts["failed"] = failed
        if failed:
            raise Finding(f"{self.preset}: {failed} tests fail", log=run.output[-100000:])
