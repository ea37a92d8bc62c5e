// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSanitizer_h
#define gatunSanitizer_h

// GATUN_HAS_SANITIZER: AddressSanitizer or ThreadSanitizer is at work. These need address space of
// their own, so that it cannot be limited, and bring a malloc of their own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GATUN_HAS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define GATUN_HAS_SANITIZER
#endif
#endif

#endif
