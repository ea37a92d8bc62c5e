# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What the demo tells: lines while it works, a table and a sheet of pictures in the end."""

import json
import os
import subprocess
import time

import sheet


class Report:
    def __init__(self, folder):
        self.folder = folder
        self.start = time.monotonic()
        self.rows = []
        self.panels = []

    def path(self, name):
        return os.path.join(self.folder, name)

    def say(self, words):
        print(f"[{time.monotonic() - self.start:6.1f} s] {words}", flush=True)

    def gtn(self, *arguments):
        """Runs gtn; returns what it printed and the seconds it took. What goes wrong it says itself."""
        start = time.monotonic()
        run = subprocess.run([os.environ["GATUN_TEST_GTN"], *map(str, arguments)], check=False,
                             stdout=subprocess.PIPE, universal_newlines=True)
        if run.returncode:
            raise SystemExit(run.returncode)
        return run.stdout, time.monotonic() - start

    def gtn_json(self, *arguments):
        """The same for commands that print JSON."""
        text, seconds = self.gtn(*arguments)
        return json.loads(text), seconds

    def add(self, heading, figures, picture=None):
        """A row of the table and, with a picture, which may be a file, a panel of the sheet."""
        self.rows.append((heading, figures))
        self.say(f"{heading}: {figures}")
        if picture is not None:
            pixels = sheet.read_picture(picture) if isinstance(picture, str) else picture
            self.panels.append((pixels, heading, figures))

    def finish(self, title):
        name = self.path("sheet.png")
        sheet.write_sheet(title, self.panels, name)
        width = max(len(heading) for heading, _ in self.rows)
        print(f"\n{title}\n")
        for heading, figures in self.rows:
            print(f"  {heading:<{width}}  {figures}")
        print(f"\nAll pictures on one sheet:\n  {name}")
