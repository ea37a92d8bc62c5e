// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFaceTable_h
#define gatunFaceTable_h

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Finds the tetrahedra that share a face. Face 4 t + i is the face of tetrahedron t opposite to its
 * corner i. All faces with the same three corners form a group of any size.
 */
class FaceTable
{
public:
  static constexpr std::uint32_t None = 0xffffffffu;
  using Tet = std::array<std::uint32_t, 4>;

  explicit FaceTable(std::span<const Tet> tets)
    : GroupOf(4 * tets.size(), None)
    , Next(4 * tets.size(), None)
  {
    const auto mask = std::bit_ceil(4 * tets.size() + 1) - 1;
    std::vector<std::uint32_t> slots(mask + 1, None); // a face of the group
    for (std::size_t face = 4 * tets.size(); face-- > 0;)
    {
      if (IsDegenerate(tets[face / 4]))
      {
        continue;
      }
      const auto corners = GetSorted(tets, face);
      auto at = Hash(corners) & mask;
      while (slots[at] != None && GetSorted(tets, slots[at]) != corners)
      {
        at = (at + 1) & mask;
      }
      if (slots[at] == None)
      {
        this->GroupOf[face] = static_cast<std::uint32_t>(this->Firsts.size());
        this->Firsts.push_back(None);
        slots[at] = static_cast<std::uint32_t>(face);
      }
      else
      {
        this->GroupOf[face] = this->GroupOf[slots[at]];
      }
      auto& first = this->Firsts[this->GroupOf[face]];
      this->Next[face] = first;
      first = static_cast<std::uint32_t>(face);
    }
  }

  /** Whether a tetrahedron has a vertex twice. Its faces are left out. */
  static bool IsDegenerate(const Tet& t)
  {
    return t[0] == t[1] || t[0] == t[2] || t[0] == t[3] || t[1] == t[2] || t[1] == t[3] ||
      t[2] == t[3];
  }

  std::vector<std::uint32_t> GroupOf; // the group of each face
  std::vector<std::uint32_t> Next;    // the next face of the group, or None
  std::vector<std::uint32_t> Firsts;  // the first face of each group

private:
  static std::array<std::uint32_t, 3> GetSorted(std::span<const Tet> tets, std::size_t face)
  {
    const auto& t = tets[face / 4];
    const auto corner = face % 4;
    const auto a = t[corner == 0 ? 1 : 0];
    const auto b = t[corner <= 1 ? 2 : 1];
    const auto c = t[corner <= 2 ? 3 : 2];
    const auto low = std::min({ a, b, c });
    const auto high = std::max({ a, b, c });
    return { low, a ^ b ^ c ^ low ^ high, high };
  }

  static std::size_t Hash(const std::array<std::uint32_t, 3>& f)
  {
    auto h = (std::uint64_t{ f[0] } << 32 | f[1]) * 0x9e3779b97f4a7c15u;
    h = ((h ^ h >> 29) + f[2]) * 0xbf58476d1ce4e5b9u;
    return static_cast<std::size_t>(h >> 24);
  }
};
}

#endif
