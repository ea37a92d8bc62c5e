// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The loops have no branches that depend on the data. What they must not meet is counted before, or
// noted by them and looked at once in the end.

#include "gatunNumberStream.h"
#include "gatunTetTree.h"
#include "gatunTreeSymbols.h"
#include "gatunVertexNames.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>

namespace gatun
{
namespace
{
using namespace TreeSymbols;

constexpr std::uint32_t All = 0xffffffffu;

/** How to find the tetrahedron whose fourth corner a symbol names: its number is that of the
 * tetrahedron itself, or of the parent where the mask is set, and a difference. Masks in place of
 * conditions, of which compilers make branches, which are unpredictable here. */
struct Reference
{
  std::uint32_t OfParent;
  std::uint32_t Difference;
  std::uint32_t IsNew;
  std::uint32_t IsFar;
};

constexpr auto References = []
{
  std::array<Reference, Count> table{};
  table[New] = { 0, 0 - 1u, All, 0 }; // looked at, but not used
  table[Far] = { 0, 0 - 1u, 0, All };
  for (unsigned k = 0; k < Reach; ++k)
  {
    const unsigned distance = k + 1;
    table[Before + k] = { 0, 0 - distance, 0, 0 };
    table[BehindParent + k] = { All, distance, 0, 0 };
    table[BeforeParent + k] = { All, 0 - distance, 0, 0 };
  }
  return table;
}();

/** The numbers of bits of bytes, as long as processors may lack an instruction for that. */
constexpr auto BitCounts = []
{
  std::array<std::uint8_t, 64> table{};
  for (unsigned mask = 0; mask < table.size(); ++mask)
  {
    table[mask] = static_cast<std::uint8_t>(std::popcount(mask));
  }
  return table;
}();

/** How often a byte occurs. In runs whose counts fit a byte, so that the loop has lanes of bytes.
 */
std::size_t CountOf(std::span<const std::uint8_t> bytes, std::uint8_t value)
{
  constexpr std::size_t run = 192;
  std::size_t count = 0;
  while (!bytes.empty())
  {
    const auto part = bytes.first(std::min(run, bytes.size()));
    std::uint8_t found = 0;
    for (const auto byte : part)
    {
      found = static_cast<std::uint8_t>(found + (byte == value ? 1 : 0));
    }
    count += found;
    bytes = bytes.subspan(part.size());
  }
  return count;
}

/** The shifts of the faces with children of two tetrahedra, one in each byte. */
constexpr auto ShiftsOfMasks = []
{
  std::array<std::uint64_t, 64> table{};
  for (unsigned masks = 0; masks < table.size(); ++masks)
  {
    unsigned place = 0;
    for (unsigned face = 0; face < 2 * FaceCount; ++face)
    {
      if (masks >> face & 1)
      {
        table[masks] |= std::uint64_t{ FaceShifts[face % FaceCount] } << (8 * place++);
      }
    }
  }
  return table;
}();

class TreeDecoder
{
public:
  TreeDecoder(
    ByteReader& in, std::uint32_t tets, std::uint32_t shared, std::uint32_t vertices, TetTree& tree)
    : Tets(tets)
    , Shared(shared)
    , Vertices(vertices)
    , Tree(tree)
    , In(in)
  {
  }

  void Decode()
  {
    this->ReadSymbols();
    this->Flatten();
    this->Walk();
    this->FindGates();
    this->Tree.Sources = GetVertexNames(this->In, this->Vertices, this->Shared);
  }

private:
  static constexpr std::uint32_t NewOfRoot = 0x80000000u; // of Bringers

  /** Reads the symbols and counts what they say. */
  void ReadSymbols()
  {
    const auto roots = this->In.GetVarint();
    if (roots == 0 || roots > this->Tets)
    {
      ThrowCorrupt("a chunk has an impossible number of roots");
    }
    this->Roots.reserve(static_cast<std::size_t>(roots));
    this->RootCount = static_cast<std::uint32_t>(roots);
    this->Masks.resize((std::size_t{ this->Tets } + 1) / 2);
    GetPacked(this->In, this->Masks);
    this->Classes.resize(this->Tets - this->RootCount);
    GetPacked(this->In, this->Classes);
    std::size_t children = 0;
    std::uint8_t unused = 0;
    for (const auto mask : this->Masks)
    {
      children += BitCounts[mask & 0x3f];
      unused |= mask & 0xc0;
    }
    unused |= (this->Tets & 1) != 0 ? this->Masks.back() & 0x38 : 0;
    const std::size_t fars = CountOf(this->Classes, Far);
    std::size_t news = CountOf(this->Classes, New);
    if (children != this->Classes.size() || unused != 0 || FindLargest(this->Classes) >= Count)
    {
      ThrowCorrupt("the tree of a chunk is damaged");
    }
    NumberReader far(this->In, fars, 16);
    this->Fars.resize(fars + 1);
    std::generate_n(
      this->Fars.begin(), fars, [&far] { return static_cast<std::uint16_t>(far.Get()); });
    NumberReader corners(this->In, 4 * std::size_t{ this->RootCount }, 17);
    this->RootCorners.resize(4 * std::size_t{ this->RootCount });
    for (auto& corner : this->RootCorners)
    {
      corner = static_cast<std::uint32_t>(corners.Get());
      news += corner == 0 ? 1 : 0;
    }
    if (news != this->Vertices)
    {
      ThrowCorrupt("a chunk has another number of vertices than its tree");
    }
  }

  /** Finds the parent and the face of each tetrahedron from the masks. */
  void Flatten()
  {
    constexpr std::size_t padding = 8;
    this->Tree.Parents.resize(this->Tets + padding);
    this->Shifts = std::make_unique_for_overwrite<std::uint8_t[]>(this->Tets + padding);
    auto* const parents = this->Tree.Parents.data();
    auto* const shifts = this->Shifts.get();
    const auto* const masks = this->Masks.data();
    std::uint32_t next = 0;
    std::uint32_t head = 0;
    // Stores more than the faces are, which the next ones replace.
    const auto add = [&](unsigned mask)
    {
      for (unsigned k = 0; k < 4; ++k)
      {
        parents[next + k] = head;
      }
      next += BitCounts[mask];
      ++head;
    };
    while (head < this->Tets)
    {
      if (head == next)
      {
        if (this->Roots.size() == this->RootCount)
        {
          ThrowCorrupt("the tree of a chunk ends too early");
        }
        this->Roots.push_back(head);
        parents[next++] = TetTree::NoTet;
      }
      const unsigned pair = masks[head / 2];
      if (head % 2 == 0 && head + 1 < next)
      {
        std::memcpy(shifts + next, &ShiftsOfMasks[pair], sizeof(std::uint64_t));
        add(pair & 7);
        add(pair >> 3);
        continue;
      }
      const unsigned mask = pair >> (head % 2 * 3) & 7;
      std::memcpy(shifts + next, &ShiftsOfMasks[mask], sizeof(std::uint32_t));
      add(mask);
    }
    // There are as many children and roots as tetrahedra.
    this->Tree.Parents.resize(this->Tets);
    this->Roots.push_back(this->Tets);
  }

  void MakeRoot(std::uint32_t root)
  {
    const auto tet = this->Roots[root];
    std::array<std::uint32_t, 4> corners{};
    for (unsigned k = 0; k < 4; ++k)
    {
      const auto number = this->RootCorners[4 * root + k];
      if (number > this->Next)
      {
        ThrowCorrupt("a chunk names a vertex that it does not have");
      }
      corners[k] = number == 0 ? this->Next : this->Next - number;
      if (number == 0)
      {
        this->Bringers[this->Next++] = tet | NewOfRoot;
      }
    }
    this->Tree.Tets[tet] = Pack(corners[0], corners[1], corners[2], corners[3]);
  }

  void Walk()
  {
    this->Tree.Tets = PaddedTets(this->Tets);
    this->Bringers.resize(this->Vertices + 1);
    const auto* symbol = this->Classes.data();
    const auto* far = this->Fars.data();
    auto* const made = this->Tree.Tets.data();
    const auto* const parents = this->Tree.Parents.data();
    const auto* const shifts = this->Shifts.get();
    auto* const bringers = this->Bringers.data();
    std::uint32_t bad = 0;
    for (std::uint32_t root = 0; root < this->RootCount; ++root)
    {
      this->MakeRoot(root);
      const auto end = this->Roots[root + 1];
      auto next = this->Next;
      for (auto i = this->Roots[root] + 1; i < end; ++i)
      {
        const auto parent = parents[i];
        const auto face = GetFace(made[parent], shifts[i]);
        const auto& reference = References[*symbol++];
        const auto other = i + ((parent - i) & reference.OfParent) + reference.Difference;
        auto apex = static_cast<std::uint32_t>(made[static_cast<std::int32_t>(other)] >> 48);
        const std::uint32_t named = (next - 1 - *far) & 0xffff;
        apex ^= (apex ^ next) & reference.IsNew;
        apex ^= (apex ^ named) & reference.IsFar;
        bringers[next] = i;
        next -= reference.IsNew; // which is -1
        far += reference.IsFar & 1;
        // The highest bit is set if a number is negative, or not below the one that it must be.
        bad |= other | (i - 1 - other) | (next - 1 - apex);
        made[i] = face | PackedTet{ apex } << 48;
      }
      this->Next = next;
    }
    if (static_cast<std::int32_t>(bad) < 0)
    {
      ThrowCorrupt("a chunk names a vertex that it does not have");
    }
  }

  void FindGates()
  {
    auto& gates = this->Tree.Gates;
    const auto& tets = this->Tree.Tets;
    gates.resize(this->Vertices);
    for (std::uint32_t v = 0; v < this->Vertices; ++v)
    {
      const auto bringer = this->Bringers[v];
      if ((bringer & NewOfRoot) != 0)
      {
        const auto before = v > 0 ? v - 1 : 0;
        gates[v] = Pack(before, before, before, before);
      }
      else
      {
        const auto parent = tets[this->Tree.Parents[bringer]];
        gates[v] = (tets[bringer] & LowThree) | GetOpposite(parent, this->Shifts[bringer]) << 48;
      }
    }
  }

  const std::uint32_t Tets;
  const std::uint32_t Shared;
  const std::uint32_t Vertices;
  TetTree& Tree;
  ByteReader& In;

  Bytes Masks;
  Bytes Classes;
  std::vector<std::uint16_t> Fars;
  std::uint32_t RootCount = 0;
  std::vector<std::uint32_t> RootCorners; // 0: new; else 1 + the distance from the last vertex
  std::vector<std::uint32_t> Roots;       // their tetrahedra, and the end
  std::unique_ptr<std::uint8_t[]> Shifts;
  std::vector<std::uint32_t> Bringers; // the tetrahedron with which each vertex came
  std::uint32_t Next = 0;              // vertices so far
};
}

//------------------------------------------------------------------------------
TetTree DecodeTree(std::span<const std::uint8_t> stream, std::uint32_t tets, std::uint32_t shared,
  std::uint32_t vertices)
{
  constexpr std::uint32_t hasFlips = 1;
  if (tets == 0 || !FitsTree(vertices) || shared > vertices)
  {
    ThrowCorrupt("a chunk has too many vertices for its coder");
  }
  ByteReader in(stream);
  const auto flags = in.Get<std::uint8_t>();
  if (flags > hasFlips)
  {
    ThrowCorrupt("a tree has unknown flags");
  }
  TetTree tree;
  TreeDecoder(in, tets, shared, vertices, tree).Decode();
  if (flags == hasFlips)
  {
    tree.Flips.resize((std::size_t{ tets } + 7) / 8);
    GetPacked(in, tree.Flips);
  }
  return tree;
}
}
