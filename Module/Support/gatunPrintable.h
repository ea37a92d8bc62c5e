// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPrintable_h
#define gatunPrintable_h

#include "gatunExport.h" // For export macro

#include <string>
#include <string_view>

namespace gatun
{
/** Printable text for messages: names in files may have any bytes. Control characters, but for tabs
 * and ends of lines, and bytes that are not UTF-8 become a backslash, an x, and two hexadecimal
 * digits. */
GATUN_EXPORT std::string MakePrintable(std::string_view text);
}

#endif
