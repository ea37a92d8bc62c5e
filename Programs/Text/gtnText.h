// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnText_h
#define gtnText_h

// Strings and numbers for people.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gtn
{
/** Returns one line that is safe to print: see gatun::MakePrintable. */
std::string Printable(std::string_view text);

/** 1234567 as "1,234,567". */
std::string Grouped(std::uint64_t number);

/** 1536 as "1.5 KiB". */
std::string ByteSize(std::uint64_t bytes);

/** The shortest decimal that gives the same number again. */
std::string Number(double value);

/** "a, b, c". */
std::string Joined(const std::vector<std::string>& parts, std::string_view separator = ", ");

/** The part of a path after its last slash. */
std::string FileOf(const std::string& path);

/** A path without its extension. */
std::string StemOf(const std::string& path);

/** The extension of a path in lower case, with its dot, or nothing. */
std::string ExtensionOf(const std::string& path);
}

#endif
