// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPrefetch_h
#define gatunPrefetch_h

#include "gatunInline.h"

namespace gatun
{
/** Begins to load what is at an address, which need not be valid. */
GATUN_INLINE void Prefetch(const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
#else
  static_cast<void>(address);
#endif
}
}

#endif
