# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Makes the golden files of version 1.11 with streams of the mode corrected quadratic, and adds them to
expected.json:

    export PYTHONPATH=build/release/lib/python3/dist-packages:Testing/IO
    Testing/Python/make_golden_corrected.py FOLDER

Values are those of the input; the decoder written from the specification agrees."""

import sys

import gtn_arrays
import make_golden_bounded
import make_golden_quadratic
from gatunGoldenFiles import make_all
from make_golden_quadratic import Counted


def with_effort(function):
    """The same input, written with effort, under another name."""
    def make(rng):
        *content, options = function(rng)
        return (*content, {**options, "Effort": 1})
    make.__name__ = function.__name__.replace("quadratic", "corrected")
    return make


if __name__ == "__main__":
    gtn_arrays.ArrayStream = Counted
    make_all(sys.argv[1], [with_effort(f) for f in make_golden_quadratic.ALL], adds=True)
    make_golden_bounded.main(sys.argv[1], [with_effort(make_golden_bounded.bounded_quadratic)])
    print("streams by spatial and temporal mode:", Counted.modes)
    assert (5, 0) in Counted.modes and (5, 2) in Counted.modes
