// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunTetGenStream_h
#define gatunTetGenStream_h

// Messages between the library and the program gatun-tetgen. Both are of one build and on one
// machine, so numbers have the layout of memory.
//
// To the program: TetGenTask, switches, points, triangles, holes. From the program: points,
// tetrahedra, regions, or one vector with the number of triangles that intersect others.

#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace gatun
{
using Bytes = std::vector<unsigned char>;

enum class TetGenTask : unsigned char
{
  Mesh = 1,
  CountFaces = 2
};

/** Exit codes of the program. */
enum TetGenExit
{
  TetGenDone = 0,
  TetGenFailed = 1,
  TetGenNoMemory = 2
};

template <typename T>
void Append(Bytes& bytes, const std::vector<T>& values)
{
  const std::size_t count = values.size();
  const auto* size = reinterpret_cast<const unsigned char*>(&count);
  bytes.insert(bytes.end(), size, size + sizeof(count));
  const auto* first = reinterpret_cast<const unsigned char*>(values.data());
  bytes.insert(bytes.end(), first, first + count * sizeof(T));
}

/** Takes the next vector. Throws std::runtime_error if the bytes end before. */
template <typename T>
void Take(const Bytes& bytes, std::size_t& position, std::vector<T>& values)
{
  std::size_t count = 0;
  if (bytes.size() - position < sizeof(count))
  {
    throw std::runtime_error("a stream of TetGen is too short");
  }
  std::memcpy(&count, bytes.data() + position, sizeof(count));
  position += sizeof(count);
  if ((bytes.size() - position) / sizeof(T) < count)
  {
    throw std::runtime_error("a stream of TetGen is too short");
  }
  values.resize(count);
  if (count > 0)
  {
    std::memcpy(values.data(), bytes.data() + position, count * sizeof(T));
  }
  position += count * sizeof(T);
}
}

#endif
