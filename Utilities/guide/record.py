#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Records the session of Documentation/guide/paraview.md: uses ParaView's window with mouse and keyboard, and
saves screenshots. Utilities/guide.sh calls it.

    record.py [--work FOLDER] [FOLDER]

FOLDER gets the pictures (default: Documentation/images/guide), the folder of --work the meshes, which are made
where they are missing. GATUN_TEST_GTN in the environment names the gtn program. Needs the ParaView build, Xvfb,
openbox, xdotool, ImageMagick, pngquant and python3-pyatspi."""

import argparse
import os
import pathlib
import subprocess
import sys
import tempfile

import pictures
from client import Client, plugin
from desktop import Desktop

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCREEN = (1280, 820)


def gtn(*arguments):
    subprocess.run([os.environ["GATUN_TEST_GTN"], *map(str, arguments)], check=True)


def make_meshes(folder):
    """The part of the demo with levels of detail, and the duct at five times."""
    folder.mkdir(parents=True, exist_ok=True)
    part, run = folder / "part.gtn", folder / "run.gtn"
    if not part.exists():
        sys.path.insert(0, str(ROOT / "Utilities" / "demo"))
        import meshes  # pylint: disable=import-outside-toplevel
        meshes.write(meshes.make_part("full", print), str(folder / "part.vtu"), "ZLib")
        gtn("pack", "-f", "--levels", "8", folder / "part.vtu", part)
    if not run.exists():
        subprocess.run([sys.executable, str(ROOT / "Utilities" / "guide" / "samples.py"), str(folder / "samples"),
                        "20"], check=True)
        gtn("pack", "-f", folder / "samples" / "run.pvd", run)
    return part, run


class Session:
    """The steps, which end in screenshots."""

    def __init__(self, client, out, work):
        self.client = client
        self.out = out
        self.work = work

    def shot(self, name, park=True):
        path = self.out / f"paraview-{name}.png"
        if park:
            self.client.move(SCREEN[0] - 300, SCREEN[1] - 2)
            self.client.settle(1)
        self.client.picture(path)
        pictures.reduce_colors(path, 96)
        print(path, path.stat().st_size, flush=True)

    def open(self, part):
        client = self.client
        client.widen_panel(70)
        client.menu("File", "Open...")
        client.type_file(part.name)
        self.shot("open")
        client.accept_file()
        client.apply()
        self.shot("applied")

    def volume(self):
        self.client.show_as("Gatun Volume")
        self.shot("volume")

    def rotate(self):
        view = self.client.view()
        self.client.drag(view, (0.4, 0.62), (0.55, 0.25), release=False)
        self.shot("rotating", park=False)
        self.client.release()
        self.client.settle(1)
        self.shot("rotated")

    def simplify(self):
        client = self.client
        client.fill(client.field("Simplification Ratio"), "0.95")
        client.keys("Tab")
        client.apply()
        client.show_as("Surface With Edges")
        self.shot("simplified")
        client.fill(client.field("Simplification Ratio"), "0")
        client.keys("Tab")
        client.apply()

    def contour(self):
        client = self.client
        client.menu("Filters", "Gatun", "Gatun Contour")
        client.apply()
        self.shot("contour")

    def slice(self):
        client = self.client
        client.select(1)
        client.click(client.find("push button", "Slice"))
        client.apply()
        self.shot("slice")

    def save(self):
        client = self.client
        client.select(1)
        client.menu("File", "Save Data...")
        client.type_file(self.work / "saved.gtn")
        client.accept_file()
        self.shot("save")
        client.keys("Return")
        client.settle(1)
        if not (self.work / "saved.gtn").exists():
            raise SystemExit("Save Data wrote no file")

    def animate(self, run):
        client = self.client
        client.reset()
        client.open(run)
        client.apply()
        client.show_as("Gatun Volume")
        for _ in range(2):
            client.click(client.find("push button", "Next Frame"))
        self.shot("animate")

    def save_state(self):
        """The state must come back with the same image."""
        client = self.client
        before, after = self.work / "before.png", self.work / "after.png"
        client.picture(before, client.box(client.view()))
        client.menu("File", "Save State...")
        client.type_file(self.work / "session.pvsm")
        client.accept_file()
        client.reset()
        client.menu("File", "Load State...")
        client.type_file(self.work / "session.pvsm")
        client.accept_file()
        client.keys("Return")
        client.settle(2)
        client.picture(after, client.box(client.view()))
        compared = subprocess.run(["compare", "-metric", "RMSE", before, after, "null:"], stderr=subprocess.PIPE,
                                  text=True, check=False).stderr
        print("state, RMSE:", compared, flush=True)
        if float(compared.split("(")[1].rstrip(")")) > 0.02:
            raise SystemExit("the state does not come back with the same image")


def record(folder, work):
    folder.mkdir(parents=True, exist_ok=True)
    part, run = make_meshes(work)
    os.environ["PV_PLUGIN_PATH"] = str(plugin().parent)
    for name in ("saved.gtn", "session.pvsm"):
        (work / name).unlink(missing_ok=True)
    with Desktop(SCREEN) as desktop:
        session = Session(Client(desktop, work / "client.log", work), folder, work)
        try:
            session.open(part)
            session.volume()
            session.rotate()
            session.simplify()
            session.contour()
            session.slice()
            session.save()
            session.animate(run)
            session.save_state()
        except BaseException:
            session.client.picture(work / "failed.png")
            print(f"what was on the screen is in {work / 'failed.png'}")
            raise


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=ROOT / "Documentation" / "images" / "guide")
    options = parser.parse_args()
    if options.work:
        record(options.folder, options.work)
    else:
        with tempfile.TemporaryDirectory(prefix="gatun-guide-") as work:
            record(options.folder, pathlib.Path(work))


if __name__ == "__main__":
    main()
