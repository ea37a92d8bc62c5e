/* SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors */
/* SPDX-License-Identifier: BSD-3-Clause */

/* What the library of Debian 12's Emscripten (libc++ 13) lacks of C++20. The toolchain file
   includes it in front of every source, so that no other system has to know. Later libraries have
   it. */
#ifdef __cplusplus
#include <memory>
#include <type_traits>
#include <version>

namespace std
{
#ifndef __cpp_lib_bit_cast
template <typename To, typename From>
constexpr To bit_cast(const From& from) noexcept
{
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}
#endif

#if _LIBCPP_VERSION < 16000
template <typename T>
unique_ptr<T> make_unique_for_overwrite(size_t size)
{
  return unique_ptr<T>(new remove_extent_t<T>[size]);
}
#endif
}
#endif
