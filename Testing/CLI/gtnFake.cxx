// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A library that gtn must not load: the program ends as soon as it does.

#include <cstdlib>

namespace
{
struct End
{
  End() { std::_Exit(42); }
};
const End AtLoad;
}
