// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPageArray_h
#define gatunPageArray_h

#include <cstddef>
#include <limits>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace gatun
{
/**
 * Memory for results that stay while much temporary memory is allocated and freed around them. They
 * have pages of their own. On the heap they would lie between the temporary arrays and fragment it,
 * so that the heap would grow.
 */
template <typename T>
class PageAllocator
{
public:
  using value_type = T;

  PageAllocator() = default;
  template <typename Other>
  PageAllocator(const PageAllocator<Other>&)
  {
  }

  T* allocate(std::size_t count)
  {
    if (count > std::numeric_limits<std::size_t>::max() / 2 / sizeof(T))
    {
      throw std::bad_array_new_length();
    }
#if defined(__linux__)
    if (count * sizeof(T) >= Least)
    {
      void* const memory = mmap(
        nullptr, count * sizeof(T), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
      if (memory == MAP_FAILED)
      {
        throw std::bad_alloc();
      }
      return static_cast<T*>(memory);
    }
#endif
    return static_cast<T*>(::operator new(count * sizeof(T)));
  }

  void deallocate(T* memory, [[maybe_unused]] std::size_t count) noexcept
  {
#if defined(__linux__)
    if (count * sizeof(T) >= Least)
    {
      munmap(memory, count * sizeof(T));
      return;
    }
#endif
    ::operator delete(memory);
  }

  bool operator==(const PageAllocator&) const
  {
    return true;
  }

private:
  static constexpr std::size_t Least = std::size_t{ 1 } << 14;
};

template <typename T>
using PageArray = std::vector<T, PageAllocator<T>>;
}

#endif
