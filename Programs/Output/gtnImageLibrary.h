// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnImageLibrary_h
#define gtnImageLibrary_h

// Loads gtnImages, see gtnImageFile.h.

#include <string>

namespace gtn
{
/** A function of the library; throws Failure. */
void* FindImageSymbol(const char* name);

template <typename Function>
Function* FindImageFunction(const char* name)
{
  return reinterpret_cast<Function*>(FindImageSymbol(name));
}

/** Throws Failure for what the library says of a file, whatever name it was given for it. */
[[noreturn]] void FailForImage(
  const std::string& file, const std::string& given, std::string reason, const char* otherwise);
}

#endif
