# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What VTK reports, as exceptions and warnings of Python."""

from __future__ import annotations

import contextlib
import re

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from ._classes import get_class
from ._exceptions import Error, InputError
from ._warnings import warn

# "ERROR: In File.cxx, line 12\nvtkClass (0x1234): message"
_ORIGIN = re.compile(r"\A\w+: In [^\n]*, line \d+\n\w+ \((?:0x)?[0-9a-fA-F]+\): ")


def _clean(message):
    return _ORIGIN.sub("", message).strip()


def _observe(observed, event, messages):
    def append(_caller, _event, message):
        messages.append(_clean(message))

    append.CallDataType = "string0"
    return observed, observed.AddObserver(event, append)


def _make_error(algorithm, messages, remarks):
    """The exception for the messages of an algorithm, or else for those of its executive."""
    code = algorithm.GetErrorCode() if hasattr(algorithm, "GetErrorCode") else 0
    # The executive adds that the request has failed.
    messages = messages or remarks
    if code == 0 and not messages:
        return None
    # A message may be repeated by each consumer.
    text = "\n".join(dict.fromkeys(messages))
    try:
        codes = get_class("vtkGatunErrorCode")
    except ImportError:  # a package without the modules of VTK
        return Error(text or f"an error of VTK, {code}", code, "")
    text = text or codes.GetStringFromErrorCode(code)
    kind = InputError if code == codes.InvalidInputError else Error
    return kind(text, code)


@contextlib.contextmanager
def raising(*algorithms):
    """Turns the errors of algorithms and other objects in a block into an exception, and warnings
    into warnings.

    The first one that failed counts; nothing is printed.
    """
    reports = [(algorithm, [], [], []) for algorithm in algorithms]
    observers = []
    for algorithm, errors, remarks, cautions in reports:
        observers.append(_observe(algorithm, "ErrorEvent", errors))
        if isinstance(algorithm, vtkAlgorithm):
            observers.append(_observe(algorithm.GetExecutive(), "ErrorEvent", remarks))
        observers.append(_observe(algorithm, "WarningEvent", cautions))
    try:
        yield
    finally:
        for observed, observer in observers:
            observed.RemoveObserver(observer)
    for _, _, _, cautions in reports:
        for caution in dict.fromkeys(cautions):
            warn(caution)
    for algorithm, errors, remarks, _ in reports:
        error = _make_error(algorithm, errors, remarks)
        if error:
            raise error


def set_property(algorithm, argument, name, value):
    """Sets a property, and raises ValueError where VTK would clamp the value silently.

    Args:
        algorithm: the object.
        argument: what the caller calls the property.
        name: the name of the property, as in ``"SimplificationRatio"``.
        value: a number, a string or a tuple of numbers.
    """
    try:
        getattr(algorithm, "Set" + name)(value)
    except (TypeError, OverflowError) as error:
        raise type(error)(f"{argument}: {value!r} ({error})") from None
    if getattr(algorithm, "Get" + name)() != value:
        limits = ""
        if hasattr(algorithm, f"Get{name}MinValue"):
            least, most = (getattr(algorithm, f"Get{name}{end}Value")() for end in ("Min", "Max"))
            limits = f"; the range is {least:g} to {most:g}"
        raise ValueError(f"{argument}: {value!r} is not allowed{limits}")
