# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The exceptions of the package."""

from __future__ import annotations

from typing import Optional


class Error(Exception):
    """A file, a mesh or an image that cannot be read, written or drawn.

    The text is the message of what failed; it begins with the name of the file if there is one.

    Attributes:
        code: the error code, one of ``vtkErrorCode`` or ``vtkGatunErrorCode``; 0 if there is none.
        name: the name of the code, such as ``"FileFormatError"``; empty if there is none.
        offset: the position in the file in bytes, or None if the message names none.
    """

    code: int
    name: str
    offset: Optional[int]

    def __init__(
        self, message: str, code: int = 0, name: str | None = None, offset: int | None = None
    ) -> None:
        super().__init__(message)
        if name is None:
            name = _find_name(code) if code else ""
        self.code = code
        self.name = name
        self.offset = offset


class InputError(Error, ValueError):
    """Data or a parameter that cannot be used, as an array that is not there."""


class NotHere(Error):
    """Bytes of a file that its source does not have yet.

    A source raises it from ``read``, and so does what needs the bytes. It can be called again when
    they have come.

    Attributes:
        length: the number of the bytes from ``offset``.
        ranges: pairs of offset and length of all that is needed next, as far as it is known.
    """

    length: int
    ranges: list[tuple[int, int]]

    def __init__(
        self, message: str = "the bytes are not here yet", offset: int | None = None, length: int = 0
    ) -> None:
        super().__init__(message, 40009, "NotHereError", offset)
        self.length = length
        self.ranges = [] if offset is None else [(offset, length)]


def _find_name(code):
    from ._classes import get_class

    return get_class("vtkGatunErrorCode").GetStringFromErrorCode(code)
