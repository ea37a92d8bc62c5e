// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFieldData_h
#define gatunFieldData_h

#include "gatunTypes.h"

#include <vector>

namespace gatun
{
/** An array of numbers or strings that belongs to the whole mesh. */
struct FieldArray
{
  std::string Name;
  std::int32_t VTKType = 0; ///< as in ArrayDescription; VTK_STRING for strings
  std::uint32_t Components = 1;
  std::vector<std::string> ComponentNames;
  std::vector<ArrayKey> Keys;

  bool IsText = false;
  ScalarType Type = ScalarType::Float64; ///< of Values, if not IsText
  std::vector<std::uint8_t> Values;      ///< the bytes of the numbers, little-endian
  std::vector<std::string> Texts;        ///< the strings, if IsText; may contain any bytes

  bool operator==(const FieldArray&) const = default;
};

using FieldData = std::vector<FieldArray>;
}

#endif
