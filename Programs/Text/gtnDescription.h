// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnDescription_h
#define gtnDescription_h

// Descriptions that are printed as text for people and as JSON.

#include "gtnJson.h"

#include "gatunDescription.h"

namespace gtn
{
using gatun::Column;
using gatun::Description;
using gatun::Entry;
using gatun::Table;
}

#endif
