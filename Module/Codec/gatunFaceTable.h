// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFaceTable_h
#define gatunFaceTable_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
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
    // Only faces with the same lowest corner are compared.
    const auto start = CountFaces(tets);
    std::vector<Face> faces(start.back());
    auto next = start;
    for (std::size_t face = 0; face < 4 * tets.size(); ++face)
    {
      if (!IsDegenerate(tets[face / 4]))
      {
        const auto corners = GetSorted(tets, face);
        faces[next[corners[0]]++] = { std::uint64_t{ corners[1] } << 32 | corners[2],
          static_cast<std::uint32_t>(face) };
      }
    }
    this->Firsts.reserve(2 * tets.size() + tets.size() / 2);
    for (std::size_t v = 0; v + 1 < start.size(); ++v)
    {
      const std::span bucket(faces.data() + start[v], start[v + 1] - start[v]);
      if (bucket.size() <= SmallBucket)
      {
        this->CompareAll(bucket);
      }
      else
      {
        this->SortAndCompare(bucket);
      }
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
  // Larger buckets are sorted, so that the time does not grow with the square of their size.
  static constexpr std::size_t SmallBucket = 128;

  /** A face in the bucket of its lowest corner. */
  struct Face
  {
    std::uint64_t Others; // the other two corners
    std::uint32_t Id;
  };

  /** The first face of each bucket, and the end. */
  static std::vector<std::size_t> CountFaces(std::span<const Tet> tets)
  {
    std::uint32_t last = 0;
    for (const auto& t : tets)
    {
      last = std::max({ last, t[0], t[1], t[2], t[3] });
    }
    std::vector<std::size_t> start(std::size_t{ last } + 2, 0);
    for (const auto& t : tets)
    {
      if (!IsDegenerate(t))
      {
        // Three faces have the lowest corner, and the fourth has the second lowest.
        const auto [a, b] = std::minmax(t[0], t[1]);
        const auto [c, d] = std::minmax(t[2], t[3]);
        start[std::min(a, c) + std::size_t{ 1 }] += 3;
        start[std::min({ std::max(a, c), b, d }) + std::size_t{ 1 }] += 1;
      }
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    return start;
  }

  /** Adds a face to the group that ends with another one. */
  void Append(std::uint32_t last, std::uint32_t face)
  {
    this->GroupOf[face] = this->GroupOf[last];
    this->Next[last] = face;
  }

  void BeginGroup(std::uint32_t face)
  {
    this->GroupOf[face] = static_cast<std::uint32_t>(this->Firsts.size());
    this->Firsts.push_back(face);
  }

  void CompareAll(std::span<const Face> bucket)
  {
    for (std::size_t i = 0; i < bucket.size(); ++i)
    {
      auto last = bucket[i].Id;
      if (this->GroupOf[last] != None)
      {
        continue; // equal to an earlier one
      }
      this->BeginGroup(last);
      for (auto j = i + 1; j < bucket.size(); ++j)
      {
        if (bucket[j].Others == bucket[i].Others)
        {
          this->Append(last, bucket[j].Id);
          last = bucket[j].Id;
        }
      }
    }
  }

  void SortAndCompare(std::span<Face> bucket)
  {
    std::sort(bucket.begin(), bucket.end(),
      [](const Face& l, const Face& r)
      { return l.Others != r.Others ? l.Others < r.Others : l.Id < r.Id; });
    for (std::size_t i = 0; i < bucket.size(); ++i)
    {
      if (i > 0 && bucket[i].Others == bucket[i - 1].Others)
      {
        this->Append(bucket[i - 1].Id, bucket[i].Id);
      }
      else
      {
        this->BeginGroup(bucket[i].Id);
      }
    }
  }

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
};
}

#endif
