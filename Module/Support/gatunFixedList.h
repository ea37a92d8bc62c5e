// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFixedList_h
#define gatunFixedList_h

#include <array>
#include <cstddef>

namespace gatun
{
/** A list of at most N values, which allocates nothing. */
template <typename T, std::size_t N>
class FixedList
{
public:
  void clear() { this->Count = 0; }
  void push_back(const T& value) { this->Values[this->Count++] = value; }
  bool empty() const { return this->Count == 0; }
  std::size_t size() const { return this->Count; }
  const T& operator[](std::size_t i) const { return this->Values[i]; }
  const T* begin() const { return this->Values.data(); }
  const T* end() const { return this->Values.data() + this->Count; }

private:
  std::array<T, N> Values{};
  std::size_t Count = 0;
};
}

#endif
