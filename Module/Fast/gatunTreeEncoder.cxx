// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFaceTable.h"
#include "gatunNumberStream.h"
#include "gatunPrefetch.h"
#include "gatunTetTree.h"
#include "gatunTreeSymbols.h"
#include "gatunVertexNames.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
using namespace TreeSymbols;
using InputTet = std::array<std::uint32_t, 4>;

/** The numbers of tetrahedra by which the encoder fetches neighbors and rows ahead. */
constexpr std::size_t NeighborsAhead = 8;
constexpr std::size_t RowsAhead = 16;

/** No apex has this number. */
constexpr std::uint16_t NoApex = 0xffff;
static_assert(TetTree::MaxVertices <= NoApex);

/** The place of a vertex among the corners of a tetrahedron that has it. Without branches. */
unsigned FindPlace(const InputTet& corners, std::uint32_t vertex)
{
  return unsigned{ corners[1] == vertex } | 2 * unsigned{ corners[2] == vertex } |
    3 * unsigned{ corners[3] == vertex };
}

/** The ranks of the places where symbols find a vertex, from the first one to try. */
constexpr auto SymbolsByRank = []
{
  std::array<std::uint8_t, 3 * Reach + 1> symbols{};
  for (unsigned k = 0; k < Reach; ++k)
  {
    symbols[k] = static_cast<std::uint8_t>(Before + k);
    symbols[Reach + 2 * k] = static_cast<std::uint8_t>(BehindParent + k);
    symbols[Reach + 2 * k + 1] = static_cast<std::uint8_t>(BeforeParent + k);
  }
  symbols[std::size_t{ 3 } * Reach] = Far;
  return symbols;
}();

class TreeEncoder
{
public:
  TreeEncoder(std::span<const InputTet> tets, std::uint32_t shared, std::uint32_t vertices)
    : Shared(shared)
    , Faces(tets)
    , Visits(Faces)
    , Numbers(vertices, Unmet)
    , Apexes(tets.size() + 2 * PaddedTets::Padding, NoApex)
    , Masks((tets.size() + 1) / 2, 0)
  {
    this->Classes.reserve(tets.size());
    this->Result.TetOrder.reserve(tets.size());
    this->Result.Turns.reserve(tets.size());
    this->Result.Tree.Tets = PaddedTets(tets.size());
    this->Result.Tree.Parents.reserve(tets.size());
    this->Result.Tree.Gates.reserve(vertices);
    this->InputOf.reserve(vertices);
  }

  EncodedTree Encode()
  {
    const auto count = this->Faces.Rows.size();
    const auto& order = this->Result.TetOrder;
    for (std::uint32_t head = 0; head < count; ++head)
    {
      if (head == order.size())
      {
        this->AddRoot(this->Visits.FindFirst());
      }
      this->FetchAhead(head);
      unsigned mask = 0;
      for (unsigned face = 0; face < FaceCount; ++face)
      {
        mask |= this->Attach(head, face) ? 1u << face : 0;
      }
      this->Masks[head / 2] |= static_cast<std::uint8_t>(mask << head % 2 * 3);
    }
    this->Result.Tree.Sources = MakeSources(this->InputOf, this->Shared);
    this->FindFlips();
    this->Write();
    return std::move(this->Result);
  }

private:
  static constexpr std::uint16_t Unmet = NoApex;

  std::uint32_t GetNext() const { return static_cast<std::uint32_t>(this->InputOf.size()); }

  /** Begins to load what the attachment of children to the next tetrahedra needs. */
  void FetchAhead(std::size_t head) const
  {
    const auto& order = this->Result.TetOrder;
    if (head + RowsAhead < order.size())
    {
      Prefetch(&this->Faces.Rows[order[head + RowsAhead]]);
      const auto tet = order[head + NeighborsAhead];
      for (const auto over : this->Faces.Rows[tet].Over)
      {
        const auto next = over / 4 < this->Faces.Rows.size() ? over / 4 : tet;
        Prefetch(&this->Faces.Rows[this->Visits.IsVisited(next) ? tet : next]);
      }
    }
  }

  /** Numbers a vertex that was not met before. */
  std::uint32_t Meet(std::uint32_t input, PackedTet gate)
  {
    const auto number = this->GetNext();
    this->Numbers[input] = static_cast<std::uint16_t>(number);
    this->InputOf.push_back(input);
    this->Result.Tree.Gates.push_back(gate);
    return number;
  }

  void Add(std::uint32_t tet, unsigned turn, PackedTet corners, std::uint32_t parent)
  {
    const auto place = this->Result.TetOrder.size();
    this->Visits.Visit(tet);
    this->Result.TetOrder.push_back(tet);
    this->Result.Turns.push_back(static_cast<std::uint8_t>(turn));
    this->Result.Tree.Tets[place] = corners;
    this->Apexes[PaddedTets::Padding + place] = static_cast<std::uint16_t>(corners >> 48);
    this->Result.Tree.Parents.push_back(parent);
  }

  void AddRoot(std::uint32_t tet)
  {
    InputTet corners{};
    for (unsigned k = 0; k < 4; ++k)
    {
      const auto input = this->Faces.Rows[tet].Corners[k];
      const auto next = this->GetNext();
      if (this->Numbers[input] == Unmet)
      {
        const auto before = next > 0 ? next - 1 : 0;
        corners[k] = this->Meet(input, Pack(before, before, before, before));
        this->RootCorners.Put(0);
      }
      else
      {
        corners[k] = this->Numbers[input];
        this->RootCorners.Put(next - corners[k]);
      }
    }
    ++this->Roots;
    this->Add(tet, EncodedTree::NoTurn, Pack(corners[0], corners[1], corners[2], corners[3]),
      TetTree::NoTet);
  }

  /** Attaches the tetrahedron over a face, if there is one. */
  bool Attach(std::uint32_t head, unsigned face)
  {
    const auto parentTurn = EncodedTree::GetPlaces(this->Result.Turns[head]);
    const auto& parentRow = this->Faces.Rows[this->Result.TetOrder[head]];
    const auto over = this->Visits.Find(parentRow.Over[parentTurn[face]]);
    if (over == FaceTable::None)
    {
      return false;
    }
    const auto& row = this->Faces.Rows[over / 4];
    const auto place = [&](unsigned corner)
    { return FindPlace(row.Corners, parentRow.Corners[parentTurn[corner]]); };
    constexpr std::array<std::array<unsigned, 3>, FaceCount> corners{ { { 1, 2, 3 }, { 2, 0, 3 },
      { 0, 1, 3 } } };
    const auto turn =
      place(corners[face][0]) | place(corners[face][1]) << 2 | place(corners[face][2]) << 4;
    const auto parent = this->Result.Tree.Tets[head];
    const auto gate = GetFace(parent, FaceShifts[face]);
    const auto input = row.Corners[over % 4];
    std::uint32_t apex = this->Numbers[input];
    if (apex == Unmet)
    {
      this->Classes.push_back(New);
      apex = this->Meet(input, (gate & LowThree) | PackedTet{ GetCorner(parent, face) } << 48);
    }
    else
    {
      const auto symbol = this->FindSymbol(head, static_cast<std::uint16_t>(apex));
      this->Classes.push_back(symbol);
      if (symbol == Far)
      {
        this->Fars.Put(this->GetNext() - 1 - apex);
      }
    }
    this->Add(over / 4, turn, (gate & LowThree) | PackedTet{ apex } << 48, head);
    return true;
  }

  /** The first symbol that names a vertex as the fourth corner of a near tetrahedron. Without
   * branches. */
  std::uint8_t FindSymbol(std::uint32_t parent, std::uint16_t apex) const
  {
    const auto* here = this->Apexes.data() + PaddedTets::Padding + this->Result.TetOrder.size();
    const auto* around = this->Apexes.data() + PaddedTets::Padding + parent;
    constexpr std::int16_t none = 3 * Reach;
    std::int16_t least = none;
    for (std::int16_t k = 0; k < static_cast<std::int16_t>(Reach); ++k)
    {
      // In the order of memory.
      const auto back = static_cast<std::int16_t>(Reach - 1 - k);
      const std::int16_t before = here[k - std::ptrdiff_t{ Reach }] == apex ? back : none;
      const auto behind = static_cast<std::int16_t>(around[k + 1] == apex ? Reach + 2 * k : none);
      const auto ahead = static_cast<std::int16_t>(
        around[k - std::ptrdiff_t{ Reach }] == apex ? Reach + 2 * back + 1 : none);
      least = std::min({ least, before, behind, ahead });
    }
    return SymbolsByRank[static_cast<std::size_t>(least)];
  }

  /** Marks the tetrahedra that have another orientation than their neighbors. */
  void FindFlips()
  {
    auto& flips = this->Result.Tree.Flips;
    const auto& turns = this->Result.Turns;
    for (std::size_t t = 0; t < turns.size(); ++t)
    {
      if (EncodedTree::IsMirrored(turns[t]))
      {
        flips.resize((turns.size() + 7) / 8);
        flips[t / 8] |= static_cast<std::uint8_t>(1u << t % 8);
      }
    }
  }

  void Write()
  {
    auto& tree = this->Result.Tree;
    ByteWriter out;
    out.Put<std::uint8_t>(tree.Flips.empty() ? 0 : 1);
    out.PutVarint(this->Roots);
    PutPacked(out, this->Masks);
    PutPacked(out, this->Classes);
    this->Fars.Finish(out);
    this->RootCorners.Finish(out);
    this->Result.OwnOrder = PutVertexNames(out, this->InputOf, this->Shared);
    if (!tree.Flips.empty())
    {
      PutPacked(out, tree.Flips);
    }
    this->Result.Stream = std::move(out.Data);
  }

  const std::uint32_t Shared;
  const FaceTable Faces;
  FaceVisits Visits;
  std::vector<std::uint16_t> Numbers; // of the input's vertices
  std::vector<std::uint32_t> InputOf; // of the numbers
  std::vector<std::uint16_t> Apexes;  // the fourth corners of tetrahedra, with padding
  Bytes Masks;                        // the faces with children of two tetrahedra each
  Bytes Classes;
  NumberWriter Fars;
  NumberWriter RootCorners;
  std::uint32_t Roots = 0;
  EncodedTree Result;
};
}

//------------------------------------------------------------------------------
EncodedTree EncodeTree(
  std::span<const std::array<std::uint32_t, 4>> tets, std::uint32_t shared, std::uint32_t vertices)
{
  return TreeEncoder(tets, shared, vertices).Encode();
}
}
