# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What Gatun Volume cannot draw is told, with the file's name, and the session goes on."""

import os

from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

import gatunSample as sample
import gatunVolume as drawing
from gatunParaView import load_plugin

simple = load_plugin()
path = sample.temporary("volume-errors.gtn")
simple.SaveData(path, proxy=sample.make_source(), ChunkSize=300)
with open(path, "rb") as file:
    good = file.read()
view = drawing.make_view()
background = drawing.draw(view)
reader = simple.GatunReader(FileNames=[path], LargeMesh=0)
shown = drawing.show(reader, view)
first = drawing.draw(view)
drawing.require_other(first, background)


def messages(before=None):
    """What is told by a picture, and what comes before it; nothing is drawn."""
    own = vtkOutputWindow.GetInstance()
    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    try:
        if before:
            before()
        picture = drawing.draw(view)
    finally:
        vtkOutputWindow.SetInstance(own)
    drawing.require_same(picture, background)
    return window.GetOutput()


def write(content):
    with open(path, "wb") as file:
        file.write(content)


def read_again():
    simple.ReloadFiles(reader)
    reader.UpdatePipeline()


# Chunks that are damaged behind tables that are not: the outline is right, the picture cannot be.
damaged = bytearray(good)
for place in range(len(good) // 10, len(good) // 2):
    damaged[place] ^= 0x55
write(damaged)
read_again()
assert sample.counts(reader) == (8, 12)
text = messages()
assert "is damaged" in text and os.path.basename(path) in text, text

# Said once, whichever damaged chunk the threads come to first, and forgotten when all is well.
for _ in range(20):
    assert "is damaged" not in messages()
write(good)
read_again()
drawing.require_same(drawing.draw(view), first)

# A file that ends too early, one that is none, and one that has gone.
for content in (good[:len(good) // 2], b"something else, but long enough to be a file" * 100, None):
    if content is None:
        os.remove(path)
    else:
        write(content)
    text = messages(lambda: simple.ReloadFiles(reader))
    assert os.path.basename(path) in text, text
write(good)
read_again()
drawing.require_same(drawing.draw(view), first)

# A unit distance that is none.
shown.ScalarOpacityUnitDistance = -1
text = messages()
assert "unit distance" in text, text
shown.ScalarOpacityUnitDistance = 3
drawing.require_same(drawing.draw(view), first)
