// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunInline_h
#define gatunInline_h

// Before functions called for every decision or candidate from many places, where compilers would
// rather not repeat them.
#if defined(__GNUC__)
#define GATUN_INLINE [[gnu::always_inline]] inline
#else
#define GATUN_INLINE inline
#endif

#endif
