// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunInline_h
#define gatunInline_h

// Forces inlining of functions that are called for every decision or candidate. Compilers do not
// inline them on their own, because they have many callers.
#if defined(__GNUC__)
#define GATUN_INLINE [[gnu::always_inline]] inline
#else
#define GATUN_INLINE inline
#endif

#endif
