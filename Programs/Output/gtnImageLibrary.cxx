// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnImageLibrary.h"

#include "gtnFailure.h"
#include "gtnText.h"

#include <cstdlib>

#include <dlfcn.h>

namespace gtn
{
//------------------------------------------------------------------------------
// Next to the other libraries.
void* FindImageSymbol(const char* name)
{
  // OpenImageIO would start a thread a processor as soon as it is loaded, and end the program where
  // that fails. The pictures are made by threads of VTK; writing them needs one.
  ::setenv("OPENIMAGEIO_THREADS", "1", 0);
  void* const library = ::dlopen("libgtnImages.so", RTLD_NOW | RTLD_LOCAL);
  void* const symbol = library ? ::dlsym(library, name) : nullptr;
  const char* const error = symbol ? nullptr : ::dlerror();
  const std::string reason = error ? Printable(error) : "the library gtnImages is of another gtn";
  if (!symbol)
  {
    throw Failure("cannot read or write images: " + reason);
  }
  return symbol;
}

//------------------------------------------------------------------------------
void FailForImage(
  const std::string& file, const std::string& given, std::string reason, const char* otherwise)
{
  if (const auto place = reason.find(given); place != reason.npos)
  {
    reason.replace(place, given.size(), file);
  }
  throw Failure(file, reason.empty() ? otherwise : Printable(reason));
}
}
