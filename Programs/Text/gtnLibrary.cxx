// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnLibrary.h"

#include "gtnFailure.h"
#include "gtnText.h"

#include <dlfcn.h>

namespace gtn
{
const void* LoadLibrary(const char* library, const char* name, const std::string& purpose)
{
  const std::string file = std::string("lib") + library + ".so";
  void* const loaded = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  const void* const found = loaded ? ::dlsym(loaded, name) : nullptr;
  if (!found)
  {
    const char* const error = ::dlerror();
    throw Failure("cannot " + purpose + ": " +
      (error ? Printable(error)
             : std::string("the library ") + library + " is of another version"));
  }
  return found;
}
}
