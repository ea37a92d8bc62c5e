// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunDescriptionText_h
#define gatunDescriptionText_h

// Strings and numbers of descriptions, for people.

#include "gatunExport.h" // For export macro

#include "gatunTypes.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gatun
{
/** Returns one line that is safe to print: see gatun::MakePrintable. */
GATUN_EXPORT std::string MakePrintableLine(std::string_view text);

/** 1234567 as "1,234,567". */
GATUN_EXPORT std::string GroupDigits(std::uint64_t number);

/** 1536 as "1.5 KiB". */
GATUN_EXPORT std::string DescribeByteSize(std::uint64_t bytes);

/** The shortest decimal that gives the same number again. */
GATUN_EXPORT std::string DescribeNumber(double value);

/** With so many digits, as "%.7g" of printf. */
GATUN_EXPORT std::string DescribeNumber(double value, int digits);

/** With so many digits behind the point, as "%.3f" of printf. */
GATUN_EXPORT std::string DescribeFixed(double value, int digits);

/** "a, b, c". */
GATUN_EXPORT std::string Join(
  const std::vector<std::string>& parts, std::string_view separator = ", ");

/** As numpy has it: "float32". */
GATUN_EXPORT const char* NameOfType(ScalarType type);

/** The class of VTK for a cell type, "vtkHexahedron", or "of type 200" if there is none. */
GATUN_EXPORT std::string NameOfCellType(int type);

/** "points, cells, corners" of flags of gatun::KeepOrder, or "none". */
GATUN_EXPORT std::string NameOfKeptOrder(std::uint8_t kept);

/** "fast" or "small". */
GATUN_EXPORT std::string NameOfProfile(Profile profile);
}

#endif
