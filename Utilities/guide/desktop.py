# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A screen without a display on which a Qt program is used with mouse and keyboard. What is on it is found
by the names that the program gives its widgets for screen readers (AT-SPI), so that nothing depends on
places in pixels."""

import os
import pathlib
import subprocess
import tempfile
import time


class Desktop:
    """An X server with a window manager and a session bus, as a context."""

    def __init__(self, size=(1600, 1000)):
        self.size = size
        self.children = []
        self.folder = tempfile.TemporaryDirectory(prefix="gatun-guide-")

    def __enter__(self):
        home = pathlib.Path(self.folder.name)
        (home / "run").mkdir(mode=0o700)
        environment = os.environ
        # A home of its own: settings of the user have no influence, and are not changed.
        environment.update(HOME=str(home), XDG_RUNTIME_DIR=str(home / "run"), QT_ACCESSIBILITY="1",
                           QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1", NO_AT_BRIDGE="0")
        environment.pop("XDG_CONFIG_HOME", None)
        screen = "x".join(map(str, (*self.size, 24)))
        readable, writable = os.pipe()
        self._start(["Xvfb", "-displayfd", str(writable), "-screen", "0", screen, "-noreset", "-nolisten", "tcp"],
                    pass_fds=[writable])
        os.close(writable)
        with os.fdopen(readable) as answer:
            environment["DISPLAY"] = ":" + answer.readline().strip()
        bus = self._start(["dbus-daemon", "--session", "--nofork", "--print-address"], stdout=subprocess.PIPE)
        environment["DBUS_SESSION_BUS_ADDRESS"] = bus.stdout.readline().decode().strip()
        self._start(["openbox"])
        return self

    def __exit__(self, *_):
        for child in reversed(self.children):
            child.terminate()
            try:
                child.wait(10)
            except subprocess.TimeoutExpired:
                child.kill()
                child.wait()
        self.folder.cleanup()

    def _start(self, command, **options):
        # The window manager's messages are of no interest.
        options.setdefault("stdout", subprocess.DEVNULL)
        child = subprocess.Popen(command, stderr=subprocess.DEVNULL, **options)
        self.children.append(child)
        return child

    def start(self, command, log, **options):
        """Runs a program whose messages go to the file log."""
        with open(log, "wb") as out:
            child = subprocess.Popen(command, stdout=out, stderr=subprocess.STDOUT, **options)
        self.children.append(child)
        return child


class NotFound(Exception):
    """A widget is not on the screen."""


def role_of(widget):
    """A push button is called a button since AT-SPI 2.54."""
    name = widget.getRoleName()
    return "push button" if name == "button" else name


class Program:
    """A program with windows: finds its widgets and uses them."""

    def __init__(self, process, name, patience=600):
        import pyatspi  # pylint: disable=import-outside-toplevel
        self.atspi = pyatspi
        self.process = process
        self.patience = patience
        self.root = None
        self.wait_for(lambda: self._find_root(name), f"the program {name}")

    def _find_root(self, name):
        self.root = next((one for one in self.atspi.Registry.getDesktop(0) if one and one.name == name), None)
        return self.root

    # Finding.

    def _walk(self, widget):
        """The visible widgets below one, with themselves."""
        try:
            if widget is not self.root and not widget.getState().contains(self.atspi.STATE_SHOWING):
                return
            children = list(widget)
        except Exception:  # pylint: disable=broad-except
            return  # it has just gone
        yield widget
        for child in children:
            if child is not None:
                yield from self._walk(child)

    def all(self, role=None, name=None, within=None):
        """The visible widgets with a role and a name; the name may be a function."""
        found = []
        for widget in self._walk(within or self.root):
            try:
                if role is not None and role_of(widget) != role:
                    continue
                if callable(name) and not name(widget.name) or name is not None and not callable(
                        name) and widget.name != name:
                    continue
                found.append(widget)
            except Exception:  # pylint: disable=broad-except
                pass
        return found

    def find(self, role=None, name=None, within=None, index=0):
        found = []

        def look():
            found[:] = self.all(role, name, within)
            return len(found) > index
        self.wait_for(look, f"{role or 'widget'} {name!r}")
        return found[index]

    def wait_for(self, condition, what):
        end = time.monotonic() + self.patience
        while time.monotonic() < end:
            if self.process.poll() is not None:
                raise NotFound(f"the program has ended with {self.process.returncode} while waiting for {what}")
            try:
                if condition():
                    return
            except Exception:  # pylint: disable=broad-except
                pass  # widgets come and go
            time.sleep(0.2)
        raise NotFound(f"there is no {what} on the screen")

    def box(self, widget):
        extents = widget.queryComponent().getExtents(self.atspi.DESKTOP_COORDS)
        return extents.x, extents.y, extents.width, extents.height

    def place(self, widget, at=(0.5, 0.5)):
        x, y, width, height = self.box(widget)
        return int(x + at[0] * width), int(y + at[1] * height)

    # Using.

    @staticmethod
    def _xdotool(*words):
        subprocess.run(["xdotool", *map(str, words)], check=True)

    def click_screen(self, x, y, button=1, times=1):
        self._xdotool("mousemove", x, y)
        time.sleep(0.15)
        self._xdotool("click", "--repeat", times, "--delay", 80, button)
        self.settle()

    def click(self, widget, at=(0.5, 0.5), button=1, times=1):
        self.click_screen(*self.place(widget, at), button, times)

    def move(self, x, y):
        self._xdotool("mousemove", x, y)

    def drag_screen(self, begin, end, button=1, steps=12, pause=0.05, release=True):
        """Moves the mouse with a button held."""
        self._xdotool("mousemove", *begin, "mousedown", button)
        for step in range(1, steps + 1):
            self._xdotool("mousemove", *(a + (b - a) * step // steps for a, b in zip(begin, end)))
            time.sleep(pause)
        if release:
            self.release(button)

    def drag(self, widget, begin, end, **options):
        """The same over a widget; places are fractions of its size."""
        self.drag_screen(self.place(widget, begin), self.place(widget, end), **options)

    def release(self, button=1):
        self._xdotool("mouseup", button)
        self.settle()

    def keys(self, *names):
        for name in names:
            self._xdotool("key", name)
            time.sleep(0.1)
        self.settle()

    def write(self, text):
        self._xdotool("type", "--delay", 15, text)
        self.settle()

    def fill(self, widget, text):
        """Replaces the text of a field."""
        self.click(widget)
        self._xdotool("key", "ctrl+a")
        self.write(text)

    def menu(self, *names):
        """Chooses from the menu bar, or from a menu that is open."""
        for i, name in enumerate(names):
            item = self.find("menu item", name)
            self.click(item)
            if i + 1 < len(names):
                self.find("menu item", names[i + 1])

    def choose(self, combo, entry):
        """Opens a combo box and chooses an entry by typing its name."""
        self.click(combo)
        self.write(entry)
        self.keys("Return")

    # Waiting.

    def _is_busy(self):
        """Whether a thread runs or would, if there were a processor for it."""
        for stat in pathlib.Path(f"/proc/{self.process.pid}/task").glob("*/stat"):
            try:
                if stat.read_text(encoding="utf-8").rsplit(")", 1)[1].split()[0] in "RD":
                    return True
            except OSError:
                pass  # the thread has just ended
        return False

    def settle(self, quiet=0.5):
        """Waits until the program has had nothing to do for some seconds."""
        end = time.monotonic() + self.patience
        since = time.monotonic()
        while time.monotonic() < min(end, since + quiet):
            if self._is_busy():
                since = time.monotonic()
            time.sleep(0.03)

    def picture(self, path, crop=None):
        """Saves what is on the screen, or a part of it (x, y, width, height)."""
        words = ["import", "-silent", "-window", "root"]
        if crop:
            words += ["-crop", "{2}x{3}+{0}+{1}".format(*crop), "+repage"]
        subprocess.run([*words, str(path)], check=True)
