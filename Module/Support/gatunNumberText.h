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

/** How printf writes numbers: "%f", "%e" or "%g". */
enum class NumberForm
{
  Fixed,
  Scientific,
  General
};

/** The shortest text of a form that ParseNumber reads as the same number. */
std::string FormatNumber(double number, NumberForm form);

/** The text of a form with so many digits, as printf has it. */
std::string FormatNumber(double number, NumberForm form, int digits);
}

#endif
