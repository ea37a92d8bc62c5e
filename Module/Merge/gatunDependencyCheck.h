// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunDependencyCheck_h
#define gatunDependencyCheck_h

#include "gatunMergeDependencies.h"

namespace gatun
{
/** Whether two sets of dependencies allow the same merges. They may have more or fewer dependencies
 * that follow from others. Tries 512 random choices of merges, from half of them to all but a few;
 * differences that matter to none of these are not found. */
bool AreEquivalent(const MergeDependencies& a, const MergeDependencies& b);
}

#endif
