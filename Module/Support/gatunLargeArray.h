// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunLargeArray_h
#define gatunLargeArray_h

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace gatun
{
constexpr std::size_t HugePage = std::size_t{ 1 } << 21;

/** Asks the kernel for huge pages in memory that has not been used yet, where it does not use them
 * anyway. This is only advice. */
inline void AskForHugePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes)
{
#if defined(__linux__)
  void* first = memory;
  if (std::align(HugePage, HugePage, first, bytes))
  {
    madvise(first, bytes / HugePage * HugePage, MADV_HUGEPAGE);
  }
#endif
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
    const std::size_t bytes = count * sizeof(T);
    if (bytes < Least)
    {
      return static_cast<T*>(::operator new(bytes));
    }
    const std::size_t rounded = (bytes + HugePage - 1) / HugePage * HugePage;
    void* const memory = ::operator new (rounded, std::align_val_t{ HugePage });
    AskForHugePages(memory, rounded);
    return static_cast<T*>(memory);
  }

  void deallocate(T* memory, std::size_t count) noexcept
  {
    if (count * sizeof(T) < Least)
    {
      ::operator delete(memory);
    }
    else
    {
      ::operator delete (memory, std::align_val_t{ HugePage });
    }
  }

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

private:
  static constexpr std::size_t Least = 2 * HugePage;
};

template <typename T>
using LargeArray = std::vector<T, LargeAllocator<T>>;
}

#endif
