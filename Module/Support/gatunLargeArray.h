// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunLargeArray_h
#define gatunLargeArray_h

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace gatun
{
/**
 * Memory for arrays of many megabytes. The kernel is asked for huge pages, where it does not use
 * them anyway: to find and clear pages of the usual 4096 bytes one by one takes as long as decoding
 * what is then stored in them.
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
    const std::size_t rounded = (bytes + Page - 1) / Page * Page;
    void* const memory = ::operator new (rounded, std::align_val_t{ Page });
#if defined(__linux__)
    // Only advice: nothing depends on whether it is followed.
    madvise(memory, rounded, MADV_HUGEPAGE);
#endif
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
      ::operator delete (memory, std::align_val_t{ Page });
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

  bool operator==(const LargeAllocator&) const
  {
    return true;
  }

private:
  static constexpr std::size_t Page = std::size_t{ 1 } << 21;
  static constexpr std::size_t Least = 2 * Page;
};

template <typename T>
using LargeArray = std::vector<T, LargeAllocator<T>>;
}

#endif
