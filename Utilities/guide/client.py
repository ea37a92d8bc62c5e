# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""ParaView's window, used with mouse and keyboard (desktop.py)."""

import pathlib
import subprocess

from desktop import NotFound, Program

ROOT = pathlib.Path(__file__).resolve().parents[2]
PARAVIEW = ROOT / "Utilities" / "pv-env.sh"

# What a tool bar may show for the present source.
REPRESENTATIONS = ("Outline", "Surface", "Surface With Edges", "Gatun Volume", "Gatun Surface", "Gatun Hartley")


def plugin():
    """The plugin of the build."""
    printed = subprocess.run([str(PARAVIEW)], stdout=subprocess.PIPE, text=True, check=True).stdout
    if "GATUN_PLUGIN=" not in printed:
        raise SystemExit("there is no plugin; Utilities/setup.sh test builds it")
    return pathlib.Path(printed.split("GATUN_PLUGIN=", 1)[1].split()[0])


class Client(Program):
    """ParaView's client on a desktop, started in a folder. Further arguments are those of paraview."""

    def __init__(self, desktop, log, folder, *arguments):
        self.desktop = desktop
        process = desktop.start([str(PARAVIEW), "paraview", *arguments], log, cwd=folder)
        super().__init__(process, "ParaView")
        self.find("push button", "Apply")
        welcome = self.find("dialog", "Welcome to ParaView")
        self.settle()
        self.click(self.find("push button", "Close", welcome))
        self.maximize()

    def maximize(self):
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "^ParaView"], stdout=subprocess.PIPE,
                               text=True, check=True).stdout.split()
        width, height = self.desktop.size
        subprocess.run(["xdotool", "windowmove", found[-1], "0", "0", "windowsize", found[-1], str(width),
                        str(height - 24)], check=True)
        self.settle(1)

    # Parts of the window.

    def view(self):
        """The render view, the largest widget that has neither name nor children."""
        views = [(self.box(one)[2] * self.box(one)[3], one) for one in self.all("filler")
                 if not list(one) and not one.name]
        return max(views, key=lambda found: found[0])[1]

    def panel(self, name="Properties"):
        """A dock, by its title."""
        return self.find("frame", name)

    def widen_panel(self, pixels):
        """Drags the border between the panels and the view."""
        x, y, width, height = self.box(self.panel())
        self.drag_screen((x + width + 2, y + height // 2), (x + width + 2 + pixels, y + height // 2))

    def field(self, label, role="text"):
        """The widget of a role to the right of a label of the panel."""
        x, y, _, height = self.box(self.find("label", label, self.panel()))
        found = [(self.box(one)[0], one) for one in self.all(role, within=self.panel())
                 if self.box(one)[0] > x and abs(self.box(one)[1] + self.box(one)[3] / 2 - y - height / 2) < 14]
        if not found:
            raise NotFound(f"there is no {role} behind {label}")
        return min(found, key=lambda one: one[0])[1]

    def select(self, row):
        """A row of the pipeline browser, from 1; 0 is the server."""
        x, y, _, _ = self.box(self.panel("Pipeline Browser"))
        self.click_screen(x + 70, y + 32 + 22 * row)

    # Tasks.

    def apply(self):
        self.click(self.find("push button", "Apply"))
        self.settle(1.5)

    def show_as(self, representation):
        def boxes():  # in any tool bar, as Qt 6 gives them no names
            return [box for bar in self.all("tool bar")
                    for box in self.all("combo box", lambda name: name in REPRESENTATIONS, bar)]
        self.wait_for(boxes, "choice of a representation")
        self.choose(boxes()[0], representation)
        self.settle(1.5)

    def type_file(self, path):
        """Into the name of a file dialog, which is open."""
        self.settle()
        self.keys("ctrl+a")
        self.write(str(path))

    def accept_file(self):
        """Takes the name in a file dialog. The first Return may only close the list of completions."""
        for _ in range(2):
            if self.all("push button", "Navigate"):
                self.keys("Return")
        self.settle(1)

    def open(self, path):
        """File > Open, with the name typed."""
        self.menu("File", "Open...")
        self.type_file(path)
        self.accept_file()

    def reset(self):
        """Edit > Reset Session, and yes."""
        self.menu("Edit", "Reset Session")
        self.click(self.find("push button", "Yes"))
        self.settle(1)
