// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFaceTable_h
#define gatunFaceTable_h

#include "gatunPrefetch.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
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
  struct alignas(32) Row // never in two lines of the cache
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
    const auto start = CountFaces(tets);
    if (start.size() <= std::size_t{ 1 } + std::numeric_limits<std::uint16_t>::max())
    {
      this->FindOver<std::uint32_t>(tets, start);
    }
    else
    {
      this->FindOver<std::uint64_t>(tets, start);
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

  // Larger buckets are sorted, because those that are hashed have numbers below this bit.
  static constexpr std::uint8_t IsJoined = 0x80;
  static constexpr std::size_t SmallBucket = IsJoined - 1;

  static constexpr std::size_t Ahead = 16; // rows are fetched by so many faces

  /** A face in the bucket of its lowest corner. PairT: of the other two corners. */
  template <typename PairT>
  struct Face
  {
    PairT Others;
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

  /** Compares faces with the same lowest corner. start: of the bucket of each. */
  template <typename PairT>
  void FindOver(std::span<const Tet> tets, const std::vector<std::size_t>& start)
  {
    // Numbers of faces begin at 1 in a bucket, so there is one face before the first bucket; and
    // there are some to fetch behind the last one.
    std::vector<Face<PairT>> faces(start.back() + 1 + Ahead);
    auto next = start;
    for (std::size_t t = 0; t < tets.size(); ++t)
    {
      for (std::uint32_t corner = 0; corner < 4 && !IsDegenerate(tets[t]); ++corner)
      {
        const auto [low, middle, high] = GetSorted(tets[t], corner);
        faces[++next[low]] = { static_cast<PairT>(PairT{ middle } << 4 * sizeof(PairT) | high),
          static_cast<std::uint32_t>(4 * t + corner) };
      }
    }
    for (std::size_t v = 0; v + 1 < start.size(); ++v)
    {
      const auto size = start[v + 1] - start[v];
      if (size <= SmallBucket)
      {
        this->HashAndCompare(faces.data() + start[v], size);
      }
      else
      {
        this->SortAndCompare(std::span(faces.data() + start[v] + 1, size));
      }
    }
  }

  /** Notes that a face has the same corners as an earlier one, and as others before if isJoined. */
  void Join(std::uint32_t earlier, std::uint32_t face, bool isJoined)
  {
    const auto over = this->GetOver(earlier);
    if (!isJoined)
    {
      this->GetOver(earlier) = face;
      this->GetOver(face) = earlier;
      return;
    }
    this->Next.resize(4 * this->Rows.size(), None);
    auto group = over;
    if (!IsGroup(over))
    {
      group = static_cast<std::uint32_t>(this->Firsts.size()) | GroupBit;
      this->Firsts.push_back(over);
      this->Next[over] = earlier;
      this->GetOver(over) = group;
      this->GetOver(earlier) = group;
    }
    this->Next[earlier] = face;
    this->GetOver(face) = group;
  }

  static unsigned Hash(std::uint32_t others) { return others * 0x9e3779b1u >> 24; }
  static unsigned Hash(std::uint64_t others)
  {
    return static_cast<unsigned>(others * 0x9e3779b97f4a7c15u >> 56);
  }

  /** bucket: the face before those of a bucket, which are ascending. Hardly any branch is random.
   */
  template <typename PairT>
  void HashAndCompare(const Face<PairT>* bucket, std::size_t size)
  {
    std::array<std::uint8_t, 256> slots{}; // the last face with some corners, or 0
    for (std::size_t i = 1; i <= size; ++i)
    {
      const auto& face = bucket[i];
      Prefetch(&this->Rows[bucket[i + Ahead].Id / 4]);
      unsigned slot = Hash(face.Others);
      const auto find = [&] { return slots[slot] & ~unsigned{ IsJoined }; };
      while (find() != 0 && bucket[find()].Others != face.Others)
      {
        slot = (slot + 1) % slots.size();
      }
      const auto last = find();
      const bool isJoined = (slots[slot] & IsJoined) != 0;
      slots[slot] = static_cast<std::uint8_t>(i | (last != 0 ? IsJoined : 0u));
      if (isJoined)
      {
        this->Join(bucket[last].Id, face.Id, true);
        continue;
      }
      // A face alone is written over itself.
      const auto earlier = bucket[last != 0 ? last : i].Id;
      this->GetOver(earlier) = face.Id;
      this->GetOver(face.Id) = last != 0 ? earlier : None;
    }
  }

  template <typename PairT>
  void SortAndCompare(std::span<Face<PairT>> bucket)
  {
    std::sort(bucket.begin(), bucket.end(),
      [](const auto& l, const auto& r)
      { return l.Others != r.Others ? l.Others < r.Others : l.Id < r.Id; });
    bool isJoined = false;
    for (std::size_t i = 1; i < bucket.size(); ++i)
    {
      const bool isSame = bucket[i].Others == bucket[i - 1].Others;
      if (isSame)
      {
        this->Join(bucket[i - 1].Id, bucket[i].Id, isJoined);
      }
      isJoined = isSame;
    }
  }

  static std::array<std::uint32_t, 3> GetSorted(const Tet& t, std::uint32_t corner)
  {
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
  bool IsVisited(std::uint32_t tet) const { return this->Visited[tet] != 0; }

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
