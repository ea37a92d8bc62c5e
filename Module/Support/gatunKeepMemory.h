// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunKeepMemory_h
#define gatunKeepMemory_h

#include "gatunExport.h" // For export macro

namespace gatun
{
/**
 * Makes the C library keep freed memory for further requests where it would give it back to the
 * system at once. To be called before work that takes and frees megabytes again and again: to get
 * them back from the system, page by page, takes a fifth of the time of decoding.
 */
void KeepFreedMemory();

/** Gives freed memory back to the system, after work that takes much more memory than later work.
 * Exported for the gtn program. */
GATUN_EXPORT void ReturnFreedMemory();
}

#endif
