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
#include <utility>
#include <vector>

namespace gatun
{
/**
 * Finds the tetrahedra that share a face. They have a row each, ordered by their lowest corners, so
 * that neighbors are near if vertices with near numbers are. Face 4 r + i is the face of row r
 * opposite to its corner i. Any number of faces can have the same three corners.
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

  /** All corners must be below 2^30. */
  explicit FaceTable(std::span<const Tet> tets)
    : Rows(tets.size())
    , Inputs(tets.size())
    , Places(tets.size())
  {
    const auto starts = this->SortInputs(tets);
    if (starts.size() <= std::size_t{ 1 } + std::numeric_limits<std::uint16_t>::max())
    {
      this->FindOver<std::uint32_t>(tets, starts);
    }
    else
    {
      this->FindOver<std::uint64_t>(tets, starts);
    }
    this->SortGroups();
  }

  /** Replaces rows by the input's tetrahedra. */
  void RestoreInput(std::vector<std::uint32_t>& rows) const
  {
    std::transform(rows.begin(), rows.end(), rows.begin(),
      [this](std::uint32_t row) { return this->Inputs[row]; });
  }

  std::vector<Row> Rows;
  std::vector<std::uint32_t> Inputs; // the input's tetrahedron of each row
  std::vector<std::uint32_t> Places; // the row of each of the input's tetrahedra
  std::vector<std::uint32_t> Firsts; // the first face of each group, in the order of the input
  std::vector<std::uint32_t> Next;   // the next face of the group, or None; empty without groups

private:
  static constexpr std::uint32_t GroupBit = 0x80000000u;

  // Larger buckets are sorted, because those that are hashed have numbers below this bit.
  static constexpr std::uint8_t IsJoined = 0x80;
  static constexpr std::size_t SmallBucket = IsJoined - 1;

  static constexpr std::size_t Ahead = 16; // tetrahedra are fetched by so many rows

  /** A face in the bucket of its lowest corner. PairT: of the other two corners. */
  template <typename PairT>
  struct Face
  {
    PairT Others;
    std::uint32_t Id;
  };

  std::uint32_t& GetOver(std::uint32_t face) { return this->Rows[face / 4].Over[face % 4]; }

  /** Four times the corners, ascending, plus their places in the row. */
  static std::array<std::uint32_t, 4> GetSorted(const Tet& t)
  {
    const auto sort = [](std::uint32_t& l, std::uint32_t& r)
    {
      const auto low = std::min(l, r);
      r = l ^ r ^ low; // without a branch
      l = low;
    };
    std::array<std::uint32_t, 4> keys{ t[0] << 2, t[1] << 2 | 1, t[2] << 2 | 2, t[3] << 2 | 3 };
    sort(keys[0], keys[1]);
    sort(keys[2], keys[3]);
    sort(keys[0], keys[2]);
    sort(keys[1], keys[3]);
    sort(keys[1], keys[2]);
    return keys;
  }

  /** Returns the first row of which each vertex is the lowest corner, and the end. */
  std::vector<std::uint32_t> SortInputs(std::span<const Tet> tets)
  {
    std::uint32_t last = 0;
    for (const auto& t : tets)
    {
      last = std::max({ last, t[0], t[1], t[2], t[3] });
    }
    const auto lowestOf = [](const Tet& t)
    { return std::min(std::min(t[0], t[1]), std::min(t[2], t[3])); };
    std::vector<std::uint32_t> starts(std::size_t{ last } + 2, 0);
    for (const auto& t : tets)
    {
      ++starts[lowestOf(t) + std::size_t{ 1 }];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    auto next = starts;
    for (std::uint32_t t = 0; t < tets.size(); ++t)
    {
      const auto row = next[lowestOf(tets[t])]++;
      this->Inputs[row] = t;
      this->Places[t] = row;
    }
    return starts;
  }

  /** Makes the rows and compares faces with the same lowest corner. Those of a row with a vertex
   * twice are left out. */
  template <typename PairT>
  void FindOver(std::span<const Tet> tets, std::span<const std::uint32_t> starts)
  {
    // The last face of earlier rows with this lowest corner, or None. Each has the one before.
    std::vector<std::uint32_t> lasts(starts.size(), None);
    std::vector<Face<PairT>> bucket; // numbers of faces in it begin at 1
    for (std::size_t v = 0; v + 1 < starts.size(); ++v)
    {
      std::size_t size = 0;
      const auto put = [&](std::uint32_t middle, std::uint32_t high, std::uint32_t id) {
        bucket[++size] = { static_cast<PairT>(PairT{ middle } << 4 * sizeof(PairT) | high), id };
      };
      bucket.resize(std::max(bucket.size(), 1 + std::size_t{ 3 } * (starts[v + 1] - starts[v])));
      for (auto row = starts[v]; row < starts[v + 1]; ++row)
      {
        if (row + Ahead < tets.size())
        {
          Prefetch(&tets[this->Inputs[row + Ahead]]);
        }
        const auto& tet = tets[this->Inputs[row]];
        this->Rows[row] = { tet, { None, None, None, None } };
        const auto [a, b, c, d] = GetSorted(tet);
        if (a >> 2 == b >> 2 || b >> 2 == c >> 2 || c >> 2 == d >> 2)
        {
          continue;
        }
        put(b >> 2, c >> 2, 4 * row + (d & 3));
        put(b >> 2, d >> 2, 4 * row + (c & 3));
        put(c >> 2, d >> 2, 4 * row + (b & 3));
        this->Rows[row].Over[a & 3] = std::exchange(lasts[b >> 2], 4 * row + (a & 3));
      }
      for (auto face = lasts[v]; face != None;)
      {
        // The corner opposite to the face is lower.
        const auto& [a, b, c, d] = this->Rows[face / 4].Corners;
        const auto low = static_cast<std::uint32_t>(v) ^ this->Rows[face / 4].Corners[face % 4];
        const auto high = std::max({ a, b, c, d });
        if (size + 2 > bucket.size())
        {
          bucket.resize(2 * bucket.size() + 2);
        }
        put(a ^ b ^ c ^ d ^ low ^ high, high, face);
        face = std::exchange(this->GetOver(face), None);
      }
      if (size <= SmallBucket)
      {
        this->HashAndCompare(bucket.data(), size);
      }
      else
      {
        this->SortAndCompare(std::span(bucket).subspan(1, size));
      }
    }
  }

  /** Sorts the faces of groups by their order in the input. */
  void SortGroups()
  {
    std::vector<std::uint32_t> faces;
    for (auto& first : this->Firsts)
    {
      faces.clear();
      for (auto face = first; face != None; face = this->Next[face])
      {
        faces.push_back(face);
      }
      const auto placeOf = [this](std::uint32_t face)
      { return std::uint64_t{ 4 } * this->Inputs[face / 4] + face % 4; };
      std::sort(faces.begin(), faces.end(),
        [placeOf](std::uint32_t l, std::uint32_t r) { return placeOf(l) < placeOf(r); });
      first = faces[0];
      for (std::size_t i = 0; i < faces.size(); ++i)
      {
        this->Next[faces[i]] = i + 1 < faces.size() ? faces[i + 1] : None;
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

  /** bucket: the place before the faces of a bucket, which is written. Hardly any branch is random.
   */
  template <typename PairT>
  void HashAndCompare(Face<PairT>* bucket, std::size_t size)
  {
    std::array<std::uint8_t, 256> slots{}; // the last face with some corners, or 0
    bucket[0].Id = None;
    for (std::size_t i = 1; i <= size; ++i)
    {
      const auto face = bucket[i];
      bucket[0].Others = face.Others; // so that the search ends at a free slot
      unsigned slot = Hash(face.Others);
      const auto find = [&] { return slots[slot] & ~unsigned{ IsJoined }; };
      while (bucket[find()].Others != face.Others)
      {
        slot = (slot + 1) % slots.size();
      }
      const auto last = find();
      const bool isJoined = (slots[slot] & IsJoined) != 0;
      slots[slot] = static_cast<std::uint8_t>(i | unsigned{ last != 0 } * IsJoined);
      if (isJoined)
      {
        this->Join(bucket[last].Id, face.Id, true);
        continue;
      }
      // A face alone is written over itself, and then None.
      const auto earlier = last | (i & (0 - std::size_t{ last == 0 }));
      this->GetOver(bucket[earlier].Id) = face.Id;
      this->GetOver(face.Id) = bucket[last].Id;
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
};

/** Visits the rows of tetrahedra one after the other, each once. */
class FaceVisits
{
public:
  explicit FaceVisits(const FaceTable& faces)
    : Faces(faces)
    , Unvisited(faces.Firsts)
    , Visited(faces.Rows.size(), 0)
  {
  }

  void Visit(std::uint32_t row) { this->Visited[row] = 1; }
  bool IsVisited(std::uint32_t row) const { return this->Visited[row] != 0; }

  /** That of the input's first tetrahedron that is unvisited. There must be one. */
  std::uint32_t FindFirst()
  {
    while (this->Visited[this->Faces.Places[this->First]])
    {
      ++this->First;
    }
    return this->Faces.Places[this->First];
  }

  /** Whether Find may find a face. */
  bool MayBeUnvisited(std::uint32_t over) const
  {
    const auto row = over / 4;
    return row >= this->Visited.size() ? over != FaceTable::None : this->Visited[row] == 0;
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
