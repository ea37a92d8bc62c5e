# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A file that is damaged before it is opened, between two pictures or in the middle of one: every
picture is right, or there is none and an error that names the file; never a picture of before. Once
the file is whole again, so is the picture."""

import os

import numpy as np

import gatunVolumes as gv

DAMAGES = 300
SIZE = (48, 36)
VIEWS = ((1.2, 0.7), (-0.4, 0.2))

path = gv.gm.temporary("damaged.gtn")
gv.gm.write(gv.wave(8), path, ChunkSize=256)
with open(path, "rb") as file:
    GOOD = file.read()


def put(content):
    """Into the file as it is: whoever has it open reads the new content."""
    with open(path, "r+b") as file:
        file.write(content)
        file.truncate(len(content))


def put_unseen(content):
    """As put(), but the time at which the file was written stays."""
    before = os.stat(path)
    put(content)
    os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))


def damage(number):
    """The content with a bit, some bytes or its end gone; each time in another place."""
    random = np.random.default_rng(number)
    at = int(random.integers(len(GOOD)))
    content = bytearray(GOOD)
    kind = number % 3
    if kind == 0:
        content[at] ^= 1 << int(random.integers(8))
    elif kind == 1:
        content[at : at + 16] = random.bytes(len(content[at : at + 16]))
    else:
        del content[at:]
    return bytes(content)


class Front:
    """Somebody who draws the file, and what is said about that."""

    def __init__(self, reader, algorithm, scene):
        self.algorithm, self.scene = algorithm, scene
        self.errors, self.reader_errors = gv.gm.Errors(algorithm), gv.gm.Errors(reader)

    def look(self, view):
        self.scene.look(*view)

    def render(self):
        """A picture, or None where there is nothing, and the errors."""
        collected = self.errors, self.reader_errors
        for errors in collected:
            errors.messages.clear()
        picture = self.draw()
        return picture, "\n".join(map(str, collected)).strip()

    def at_progress(self, after, act):
        """Acts once, at a sign of progress of the next picture."""
        seen = [0]

        def note(*_):
            seen[0] += 1
            if seen[0] == after:
                act()
        return self.algorithm.AddObserver("ProgressEvent", note)


class Caster(Front):
    def __init__(self, reader):
        scene = gv.Scene(reader, SIZE)  # for its camera
        caster = gv.make_caster(
            reader, Camera=scene.camera, Property=gv.make_property(), Size=SIZE)
        super().__init__(reader, caster, scene)

    def draw(self):
        self.algorithm.Modified()  # what is in a file is no matter of the pipeline
        self.algorithm.Update()
        if self.algorithm.GetOutput().GetNumberOfPoints() == 0:
            return None
        return gv.over(gv.made_by(self.algorithm)[0])


class Mapper(Front):
    def __init__(self, reader):
        scene = gv.Scene(reader, SIZE)
        super().__init__(reader, scene.mapper, scene)

    def draw(self):
        picture = self.scene.render()[..., :3]
        return None if gv.difference(picture, np.array(gv.BACKGROUND)) < 0.01 else picture


def make_reader(budget=64):
    reader = gv.vtkGatunReader()
    reader.SetFileName(path)
    reader.SetMemoryBudget(budget)
    return reader


def check(front, expected):
    """Whether there is a picture; it must be right then."""
    picture, messages = front.render()
    code = front.algorithm.GetErrorCode()
    if picture is None:
        assert path in messages and code != 0, (code, messages)
        return False
    assert not messages and code == 0, (code, messages)
    gv.require_same(picture, expected)
    return True


for kind in (Caster, Mapper):
    pictures = []
    streaming = kind(make_reader(budget=0))  # reads each chunk for each picture
    signs = []
    streaming.algorithm.AddObserver("ProgressEvent", lambda *_: signs.append(0))
    for view in VIEWS:
        streaming.look(view)
        pictures.append(streaming.render()[0])
    gv.require_same(*pictures, tolerance=1)
    assert gv.difference(*pictures) > 0.1
    signs_of_one = len(signs) // 2
    assert signs_of_one > 4, signs_of_one
    told = np.zeros(4, int)
    for number in range(DAMAGES):
        content = damage(number)
        moment = number // 3 % 4
        if moment == 0:  # before it is opened
            put(content)
            front = kind(make_reader())
            front.look(VIEWS[0])
            told[0] += not check(front, pictures[0])
        elif moment == 1:  # after a picture, when all is known
            front = kind(make_reader())
            front.look(VIEWS[0])
            assert check(front, pictures[0])
            put(content)
            front.look(VIEWS[1])
            told[1] += not check(front, pictures[1])
        else:  # in the middle of one, or unnoticed between two
            front = streaming
            front.look(VIEWS[0])
            assert check(front, pictures[0])
            front.look(VIEWS[1])
            if moment == 2:
                put_unseen(content)
                told[2] += not check(front, pictures[1])
            else:
                after = 1 + number % signs_of_one
                observer = front.at_progress(after, lambda: put_unseen(content))
                told[3] += not check(front, pictures[1])
                front.algorithm.RemoveObserver(observer)
        front.look(VIEWS[1])
        put(GOOD)
        assert check(front, pictures[1]), number
    print(kind.__name__, "found damages in", told, "of", DAMAGES // 4, "each")
    assert (told > DAMAGES // 4 * np.array([0.9, 0.9, 0.5, 0.2])).all(), told
