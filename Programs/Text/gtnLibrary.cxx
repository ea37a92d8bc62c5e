// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnLibrary.h"

#include "gtnFailure.h"
#include "gtnText.h"

#include <dlfcn.h>

#include <filesystem>

namespace gtn
{
namespace
{
/** The folder of the libraries, as an absolute path: the loader would look for a bare name in what
 * LD_LIBRARY_PATH names. */
std::filesystem::path FindLibraries()
{
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / GTN_LIBRARY_FOLDER;
}
}

//------------------------------------------------------------------------------
const void* LoadLibrary(const char* library, const char* name, const std::string& purpose)
{
  const auto file = FindLibraries().lexically_normal() / (std::string("lib") + library + ".so");
  void* const loaded = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  const void* const found = loaded ? ::dlsym(loaded, name) : nullptr;
  if (!found)
  {
    const char* const error = ::dlerror();
    throw Failure("cannot " + purpose + ": " +
      (error ? MakePrintableLine(error)
             : std::string("the library ") + library + " is of another version"));
  }
  return found;
}
}
