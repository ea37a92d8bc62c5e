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
 * corner i. Any number of faces can have the same three corners.
 */
class FaceTable
{
public:
  static constexpr std::uint32_t None = 0xffffffffu;
  using Tet = std::array<std::uint32_t, 4>;

  /** A tetrahedron and, for each of its faces, the only other face with the same corners, or None,
   * or a group of more than two faces. */
  struct Row
  {
    Tet Corners;
    std::array<std::uint32_t, 4> Over;
  };

  static bool IsGroup(std::uint32_t over) { return (over & GroupBit) != 0 && over != None; }
  static std::uint32_t GetGroup(std::uint32_t over) { return over & ~GroupBit; }

  explicit FaceTable(std::span<const Tet> tets)
    : Rows(tets.size())
  {
    for (std::size_t t = 0; t < tets.size(); ++t)
    {
      this->Rows[t] = { tets[t], { None, None, None, None } };
    }
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
    std::vector<std::uint32_t> same;
    for (std::size_t v = 0; v + 1 < start.size(); ++v)
    {
      const std::span bucket(faces.data() + start[v], start[v + 1] - start[v]);
      if (bucket.size() <= SmallBucket)
      {
        this->CompareAll(bucket, same);
      }
      else
      {
        this->SortAndCompare(bucket, same);
      }
    }
  }

  /** Whether a tetrahedron has a vertex twice. Its faces are left out. */
  static bool IsDegenerate(const Tet& t)
  {
    return t[0] == t[1] || t[0] == t[2] || t[0] == t[3] || t[1] == t[2] || t[1] == t[3] ||
      t[2] == t[3];
  }

  std::vector<Row> Rows;
  std::vector<std::uint32_t> Firsts; // the first face of each group
  std::vector<std::uint32_t> Next;   // the next face of the group, or None; empty without groups

private:
  static constexpr std::uint32_t GroupBit = 0x80000000u;

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

  std::uint32_t& GetOver(std::uint32_t face) { return this->Rows[face / 4].Over[face % 4]; }

  /** Notes two or more faces with the same corners, ascending. */
  void Join(std::span<const std::uint32_t> faces)
  {
    if (faces.size() == 2)
    {
      this->GetOver(faces[0]) = faces[1];
      this->GetOver(faces[1]) = faces[0];
      return;
    }
    const auto group = static_cast<std::uint32_t>(this->Firsts.size());
    this->Firsts.push_back(faces[0]);
    this->Next.resize(4 * this->Rows.size(), None);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      this->GetOver(faces[i]) = group | GroupBit;
      this->Next[faces[i]] = i + 1 < faces.size() ? faces[i + 1] : None;
    }
  }

  /** same: scratch. */
  void CompareAll(std::span<const Face> bucket, std::vector<std::uint32_t>& same)
  {
    for (std::size_t i = 0; i + 1 < bucket.size(); ++i)
    {
      if (this->GetOver(bucket[i].Id) != None)
      {
        continue; // equal to an earlier one
      }
      same.assign(1, bucket[i].Id);
      for (auto j = i + 1; j < bucket.size(); ++j)
      {
        if (bucket[j].Others == bucket[i].Others)
        {
          same.push_back(bucket[j].Id);
        }
      }
      if (same.size() > 1)
      {
        this->Join(same);
      }
    }
  }

  void SortAndCompare(std::span<Face> bucket, std::vector<std::uint32_t>& same)
  {
    std::sort(bucket.begin(), bucket.end(),
      [](const Face& l, const Face& r)
      { return l.Others != r.Others ? l.Others < r.Others : l.Id < r.Id; });
    for (std::size_t i = 0; i < bucket.size();)
    {
      const auto others = bucket[i].Others;
      same.clear();
      for (; i < bucket.size() && bucket[i].Others == others; ++i)
      {
        same.push_back(bucket[i].Id);
      }
      if (same.size() > 1)
      {
        this->Join(same);
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

/** Visits tetrahedra one after the other, each once. */
class FaceVisits
{
public:
  explicit FaceVisits(const FaceTable& faces)
    : Faces(faces)
    , Unvisited(faces.Firsts)
    , Visited(faces.Rows.size(), 0)
  {
  }

  void Visit(std::uint32_t tet) { this->Visited[tet] = 1; }

  /** The first tetrahedron that is unvisited. There must be one. */
  std::uint32_t FindFirst()
  {
    while (this->Visited[this->First])
    {
      ++this->First;
    }
    return this->First;
  }

  /** The first unvisited face with the same corners as one of FaceTable::Row, or None. */
  std::uint32_t Find(std::uint32_t over)
  {
    if (!FaceTable::IsGroup(over))
    {
      return over != FaceTable::None && this->Visited[over / 4] ? FaceTable::None : over;
    }
    auto& first = this->Unvisited[FaceTable::GetGroup(over)];
    while (first != FaceTable::None && this->Visited[first / 4])
    {
      first = this->Faces.Next[first];
    }
    return first;
  }

private:
  const FaceTable& Faces;
  std::vector<std::uint32_t> Unvisited; // the first face of each group that may be unvisited
  std::vector<char> Visited;
  std::uint32_t First = 0;
};
}

#endif
