// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunNumberText_h
#define gatunNumberText_h

#include <string>
#include <string_view>

namespace gatun
{
/** Reads a number of any locale's program in the notation of C. The text has nothing else. */
bool ParseNumber(std::string_view text, double& number);

/** The shortest text that ParseNumber reads as the same number. */
std::string FormatNumber(double number);
}

#endif
