// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunKeepMemory.h"

#include <cstddef>
#include <cstdlib>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace gatun
{
void KeepFreedMemory()
{
#if defined(__GLIBC__)
  // glibc returns free memory beyond a limit, which it raises to twice the size of the largest
  // block that was ever freed, up to blocks of 32 MiB (mallopt(3), M_MMAP_THRESHOLD). One that
  // nobody writes to costs nothing. Unlike mallopt this does not overrule what the program wants.
  static const bool once = []
  {
    constexpr std::size_t size = std::size_t{ 31 } << 20;
    void* volatile block = std::malloc(size); // volatile, so that no compiler leaves it out
    std::free(block);
    return true;
  }();
  static_cast<void>(once);
#endif
}

//------------------------------------------------------------------------------
void ReturnFreedMemory()
{
#if defined(__GLIBC__)
  ::malloc_trim(0);
#endif
}
}
