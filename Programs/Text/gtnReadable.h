// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnReadable_h
#define gtnReadable_h

#include <string>

namespace gtn
{
/** Throws Failure unless the file is there, not empty and may be read. Only a .foam file may be
 * empty: it marks the folder of a case. */
void CheckReadable(const std::string& file);
}

#endif
