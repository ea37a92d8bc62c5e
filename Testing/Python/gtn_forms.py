# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The form of the next cell of a walk: section 4.3 of Documentation/cell-codec.md.

Part of gtn_decoder, which is written from that text alone.
"""

from collections import deque

from gtn_bytes import require
from gtn_records import mix
from gtn_shapes import MAX_CORNERS, MAX_FACES, Form, check_closed, surface_of
from gtn_vertices import clamp

NO_SHAPE = (1 << 32) - 1


def begin(walk, gate):
    """The form of the next cell of a walk, at a gate or, without, as a seed."""
    if walk.only is not None:
        return walk.only
    forms = walk.mesh.shapes.forms
    is_seed = gate is None
    parent = len(forms) if is_seed else gate.face.form.number
    after = int(parent == len(forms))
    if forms and walk.decide("IsListed", after + 2 * is_seed):
        return listed_form(walk, gate, parent)
    k = walk.coded.index(256) if is_seed else gate.k
    require(k >= 3, "sides of a gate")
    faces = InlineForm(walk, gate, k).faces
    check_closed(surface_of(faces))
    return Form(faces, len(forms), NO_SHAPE)


def listed_form(walk, gate, parent):
    coded, forms = walk.coded, walk.mesh.shapes.forms
    k, face, pattern = (0, 0, 0) if gate is None else (gate.k, gate.face.number, gate.pattern)

    def skip(number):
        return gate is not None and len(forms[number].faces[0]) != k

    near = ("Near", mix(12, parent, face, pattern))
    far = ("Far", mix(10, k, pattern, 0))
    number = coded.last(near, skip)
    if number is None:
        number = coded.last(far, skip)
    if number is None:
        number = coded.tree((len(forms) - 1).bit_length(), "FormTree", clamp(k, 3, 6))
        require(number < len(forms) and not skip(number), "form")
    coded.keep(near, number)
    coded.keep(far, number)
    return forms[number]


class InlineForm:
    """Decodes the faces of a form that is not in the table."""

    def __init__(self, walk, gate, k):
        self.walk, self.gate, self.k = walk, gate, k
        self.coded, self.decide = walk.coded, walk.coded.decide
        self.faces = [tuple(range(k))]
        self.corners = k
        self.faces_at = [1] * k  # complete ones at each corner
        self.behind = {}  # corners with a face that has the key behind them, and the other way
        self.ahead = {}
        self._note([(i + 1) % k for i in range(k)], range(k))
        queue = deque((i, (i + 1) % k) for i in range(k))
        while queue:
            a, b = queue.popleft()
            if b in self.ahead.get(a, ()):
                continue
            face = self._face(a, b)
            self.faces.append(tuple(face))
            require(len(self.faces) <= MAX_FACES, "too many faces of a form")
            after = face[1:] + face[:1]
            self._note(face, after)
            for corner in set(face):
                self.faces_at[corner] += 1
            queue.extend(zip(after, face))

    def _note(self, firsts, seconds):
        for a, b in zip(firsts, seconds):
            self.ahead.setdefault(a, set()).add(b)
            self.behind.setdefault(b, set()).add(a)

    def _many(self, corner):
        return min(self.faces_at[corner], 3)

    def _face(self, a, b):
        hint = 0
        if self.gate is not None and a < self.k and b == (a + 1) % self.k:
            hint = self.gate.hint(self.walk.front, a)
        size = 3 + self.coded.tree(4, "Size", min(hint, 9), self._many(a) + self._many(b))
        if size == 18:
            size = self.coded.large("LargeSize")
        require(3 <= size <= MAX_CORNERS, "size of a face")
        face = [a, b]
        for left in range(size - 2, 0, -1):
            face.append(self._corner(a, face[-1], left))
            if face[-1] == self.corners:
                self.corners += 1
                self.faces_at.append(0)
                require(self.corners <= MAX_CORNERS, "too many corners of a form")
        return face

    def _corner(self, a, last, left):
        follow = self.behind.get(last, set()) - self.ahead.get(last, set())
        following = min(follow, default=None)
        before = None
        if left == 1:
            before = min(self.ahead.get(a, set()) - self.behind.get(a, set()), default=None)
        if before is not None and self.decide(
                "IsBefore", self._many(a), self._many(last), int(before == following)):
            return before
        if following not in (None, before) and self.decide(
                "IsNext", self._many(last), min(left, 7)):
            return following
        if self.decide("IsNew", "inline", min(left, 7), int(following is not None)):
            return self.corners
        return self.coded.index(self.corners)
