// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTreeEncoder.h"

#include "gatunFaceTable.h"
#include "gatunInline.h"
#include "gatunLanes.h"
#include "gatunNumberStream.h"
#include "gatunPrefetch.h"
#include "gatunTreeSymbols.h"
#include "gatunVertexNames.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
using namespace TreeSymbols;
using InputTet = std::array<std::uint32_t, 4>;

/** The number of tetrahedra by which the encoder fetches neighbors ahead. */
constexpr std::size_t NeighborsAhead = 4;

/** No apex has this number. */
constexpr std::uint16_t NoApex = 0xffff;
static_assert(TetTree::MaxVertices <= NoApex);

/** The place of a vertex among the corners of a tetrahedron that has it. Without branches, because
 * it is random. */
unsigned FindPlace(const InputTet& corners, std::uint32_t vertex)
{
  const unsigned isOdd = unsigned{ corners[1] == vertex } | unsigned{ corners[3] == vertex };
  const unsigned isHigh = unsigned{ corners[2] == vertex } | unsigned{ corners[3] == vertex };
  return isOdd | isHigh << 1;
}

/** The symbols in the order in which they are tried, and the ranks that they have in it, for
 * tetrahedra in the order of memory: those before this one, behind the parent, and before it. */
struct SymbolRanks
{
  static constexpr std::int16_t None = 3 * Reach;

  std::array<std::uint8_t, None + 1> Symbols{};
  std::array<std::int16_t, Reach> Near{};
  std::array<std::int16_t, Reach> Behind{};
  std::array<std::int16_t, Reach> Ahead{};
};

constexpr auto Ranks = []
{
  SymbolRanks ranks;
  const auto add = [&ranks](std::int16_t& place, unsigned rank, unsigned symbol)
  {
    place = static_cast<std::int16_t>(rank);
    ranks.Symbols[rank] = static_cast<std::uint8_t>(symbol);
  };
  for (unsigned k = 0; k < Reach; ++k)
  {
    add(ranks.Near[Reach - 1 - k], k, Before + k);
    add(ranks.Behind[k], Reach + 2 * k, BehindParent + k);
    add(ranks.Ahead[Reach - 1 - k], Reach + 2 * k + 1, BeforeParent + k);
  }
  ranks.Symbols[SymbolRanks::None] = Far;
  return ranks;
}();

static_assert(Reach == 8);

template <typename Number>
Short8 Load(const Number* numbers)
{
  static_assert(sizeof(Number) * Reach == sizeof(Short8));
  Short8 lanes;
  std::memcpy(&lanes, numbers, sizeof(lanes));
  return lanes;
}

template <typename Number>
Short8 Splat(Number number)
{
  const auto lane = static_cast<std::int16_t>(number);
  return Short8{ lane, lane, lane, lane, lane, lane, lane, lane };
}

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
    , Classes(tets.size())
  {
    this->Result.TetOrder.resize(tets.size());
    this->Result.Turns.resize(tets.size());
    this->Result.Tree.Tets = PaddedTets(tets.size());
    this->Result.Tree.Parents.resize(tets.size());
    this->Result.Tree.Gates.reserve(vertices);
    this->InputOf.reserve(vertices);
  }

  EncodedTree Encode()
  {
    const auto count = this->Faces.Rows.size();
    for (std::uint32_t head = 0; head < count; ++head)
    {
      if (head == this->Count)
      {
        this->AddRoot(this->Visits.FindFirst());
      }
      this->FetchAhead(head);
      unsigned mask = 0;
      for (unsigned open = this->FindOpen(head); open != 0; open &= open - 1)
      {
        mask |= this->Attach(head, static_cast<unsigned>(std::countr_zero(open)));
      }
      this->Masks[head / 2] |= static_cast<std::uint8_t>(mask << head % 2 * 3);
    }
    this->Result.Tree.Sources = MakeSources(this->InputOf, this->Shared);
    this->FindFlips();
    this->Faces.RestoreInput(this->Result.TetOrder);
    this->Write();
    return std::move(this->Result);
  }

private:
  static constexpr std::uint16_t Unmet = NoApex;

  std::uint32_t GetNext() const { return static_cast<std::uint32_t>(this->InputOf.size()); }

  /** Begins to load what the attachment of children to one of the next tetrahedra needs. */
  void FetchAhead(std::size_t head) const
  {
    if (head + NeighborsAhead < this->Count)
    {
      const auto row = this->Result.TetOrder[head + NeighborsAhead];
      for (const auto over : this->Faces.Rows[row].Over)
      {
        Prefetch(this->Faces.Rows.data() + over / 4);
      }
    }
  }

  /** A turn with the place of the fourth corner, and the place of a corner by it. */
  unsigned GetTurn(std::uint32_t tet) const
  {
    const unsigned turn = this->Result.Turns[tet];
    return turn | ((turn ^ turn >> 2 ^ turn >> 4) & 3) << 6;
  }
  static unsigned GetPlace(unsigned turn, unsigned corner) { return turn >> 2 * corner & 3; }

  /** The bits of faces over which there may be an unvisited tetrahedron. Without branches, because
   * that is random. */
  unsigned FindOpen(std::uint32_t head) const
  {
    const auto places = this->GetTurn(head);
    const auto& over = this->Faces.Rows[this->Result.TetOrder[head]].Over;
    unsigned open = 0;
    for (unsigned face = 0; face < FaceCount; ++face)
    {
      open |= unsigned{ this->Visits.MayBeUnvisited(over[GetPlace(places, face)]) } << face;
    }
    return open;
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

  void Add(std::uint32_t row, unsigned turn, PackedTet corners, std::uint32_t parent)
  {
    const auto place = this->Count++;
    this->Visits.Visit(row);
    this->Result.TetOrder[place] = row;
    this->Result.Turns[place] = static_cast<std::uint8_t>(turn);
    this->Result.Tree.Tets[place] = corners;
    this->Apexes[PaddedTets::Padding + place] = static_cast<std::uint16_t>(corners >> 48);
    this->Result.Tree.Parents[place] = parent;
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

  /** Attaches the tetrahedron over a face, if there is one. Returns the bit of the face. */
  GATUN_INLINE unsigned Attach(std::uint32_t head, unsigned face)
  {
    constexpr std::array<std::array<unsigned, 3>, FaceCount> faceCorners{ { { 1, 2, 3 },
      { 2, 0, 3 }, { 0, 1, 3 } } };
    const auto& corners = faceCorners[face];
    const auto places = this->GetTurn(head);
    const auto& parentRow = this->Faces.Rows[this->Result.TetOrder[head]];
    const auto over = this->Visits.Find(parentRow.Over[GetPlace(places, face)]);
    if (over == FaceTable::None)
    {
      return 0;
    }
    const auto& row = this->Faces.Rows[over / 4];
    const auto place = [&](unsigned corner)
    { return FindPlace(row.Corners, parentRow.Corners[GetPlace(places, corner)]); };
    const auto turn = place(corners[0]) | place(corners[1]) << 2 | place(corners[2]) << 4;
    const auto parent = this->Result.Tree.Tets[head];
    const auto gate = GetFace(parent, FaceShifts[face]) & LowThree;
    const auto apex = this->NameApex(
      row.Corners[over % 4], head, gate | PackedTet{ GetCorner(parent, face) } << 48);
    this->Add(over / 4, turn, gate | PackedTet{ apex } << 48, head);
    return 1u << face;
  }

  /** There is one of each tetrahedron but for roots. */
  void PutClass(std::uint8_t symbol) { this->Classes[this->Count - this->Roots] = symbol; }

  /** Writes the symbol of the next tetrahedron. gate: that of its apex if this is new. */
  std::uint32_t NameApex(std::uint32_t input, std::uint32_t parent, PackedTet gate)
  {
    const auto apex = this->Numbers[input];
    if (apex == Unmet)
    {
      this->PutClass(New);
      return this->Meet(input, gate);
    }
    const auto symbol = this->FindSymbol(parent, apex);
    this->PutClass(symbol);
    if (symbol == Far)
    {
      this->Fars.Put(this->GetNext() - 1 - apex);
    }
    return apex;
  }

  /** The first symbol that names a vertex as the fourth corner of a near tetrahedron. Compares
   * eight at once. */
  std::uint8_t FindSymbol(std::uint32_t parent, std::uint16_t apex) const
  {
    const auto* tets = this->Apexes.data() + PaddedTets::Padding;
    const auto wanted = Splat(apex);
    const auto none = Splat(SymbolRanks::None);
    const auto rank = [&](const std::uint16_t* from, const std::array<std::int16_t, Reach>& ranks)
    { return SelectEqual(Load(from), wanted, Load(ranks.data()), none); };
    const auto near = rank(tets + this->Count - Reach, Ranks.Near);
    const auto behind = rank(tets + parent + 1, Ranks.Behind);
    const auto ahead = rank(tets + parent - Reach, Ranks.Ahead);
    return Ranks.Symbols[static_cast<std::size_t>(Least(Min(near, Min(behind, ahead))))];
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
    PutPacked(out, std::span(this->Classes).first(this->Count - this->Roots));
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
  std::size_t Count = 0; // of tetrahedra so far
  EncodedTree Result;    // its order is one of rows until all are known
};
}

//------------------------------------------------------------------------------
EncodedTree EncodeTree(
  std::span<const std::array<std::uint32_t, 4>> tets, std::uint32_t shared, std::uint32_t vertices)
{
  return TreeEncoder(tets, shared, vertices).Encode();
}
}
