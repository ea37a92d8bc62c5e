// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunLargeArray_h
#define gatunLargeArray_h

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace gatun
{
constexpr std::size_t HugePage = std::size_t{ 1 } << 21;

/** The size from which memory is allocated in whole huge pages. */
constexpr std::size_t LeastInHugePages = 2 * HugePage;

/** Uninitialized memory for an array, in huge pages if it is large; see LargeAllocator. Free it by
 * std::free. Throws std::bad_alloc. */
inline void* AllocateLarge(std::size_t bytes)
{
  void* memory = nullptr;
#if defined(__linux__)
  if (bytes >= LeastInHugePages && bytes <= std::numeric_limits<std::size_t>::max() / 2)
  {
    const std::size_t rounded = (bytes + HugePage - 1) / HugePage * HugePage;
    memory = std::aligned_alloc(HugePage, rounded);
    if (memory)
    {
      madvise(memory, rounded, MADV_HUGEPAGE); // may fail, as it is only advice
    }
  }
  else
#endif
  {
    memory = std::malloc(bytes);
  }
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
}

/**
 * Memory for arrays of many megabytes, in huge pages: finding and clearing pages of the usual 4096
 * bytes one by one takes as long as decoding their contents.
 *
 * Elements that no value is given for are left uninitialized if their type permits.
 */
template <typename T>
class LargeAllocator
{
public:
  using value_type = T;

  LargeAllocator() = default;
  template <typename Other>
  LargeAllocator(const LargeAllocator<Other>&)
  {
  }

  T* allocate(std::size_t count)
  {
    if (count > std::numeric_limits<std::size_t>::max() / 2 / sizeof(T))
    {
      throw std::bad_array_new_length();
    }
    return static_cast<T*>(AllocateLarge(count * sizeof(T)));
  }

  void deallocate(T* memory, std::size_t) noexcept { std::free(memory); }

  template <typename Element, typename... Arguments>
  void construct(Element* element, Arguments&&... arguments)
  {
    if constexpr (sizeof...(Arguments) == 0)
    {
      ::new (static_cast<void*>(element)) Element; // not Element(), which clears it
    }
    else
    {
      ::new (static_cast<void*>(element)) Element(std::forward<Arguments>(arguments)...);
    }
  }

  bool operator==(const LargeAllocator&) const { return true; }
};

template <typename T>
using LargeArray = std::vector<T, LargeAllocator<T>>;
}

#endif
