// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunTetRounds_h
#define gatunTetRounds_h

// The rounds of merges of tetrahedra, which are compiled once.

#include "gatunMergeCosts.h"
#include "gatunMergeMesh.h"
#include "gatunMergeRounds.h"

namespace gatun
{
extern template class MergeRounds<MergeMesh, MergeCosts<0>>;
extern template class MergeRounds<MergeMesh, MergeCosts<1>>;
}

#endif
