// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunShadowMemory_h
#define gatunShadowMemory_h

// GATUN_HAS_SHADOW_MEMORY: a sanitizer needs address space of its own, so tests cannot limit it.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GATUN_HAS_SHADOW_MEMORY
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define GATUN_HAS_SHADOW_MEMORY
#endif
#endif

#endif
