// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFaceTable.h"
#include "gatunNumberStream.h"
#include "gatunTetTree.h"
#include "gatunTreeSymbols.h"

#include <algorithm>
#include <utility>

namespace gatun
{
namespace
{
using namespace TreeSymbols;
using InputTet = std::array<std::uint32_t, 4>;

/** Whether four corners are an odd permutation of four others. */
bool IsMirrored(const InputTet& corners, const InputTet& other)
{
  std::array<unsigned, 4> places{};
  for (unsigned k = 0; k < 4; ++k)
  {
    places[k] =
      static_cast<unsigned>(std::find(other.begin(), other.end(), corners[k]) - other.begin());
  }
  bool isOdd = false;
  for (unsigned k = 0; k < 4; ++k)
  {
    for (unsigned j = 0; j < k; ++j)
    {
      isOdd = isOdd != (places[j] > places[k]);
    }
  }
  return isOdd;
}

class TreeEncoder
{
public:
  TreeEncoder(std::span<const InputTet> tets, std::uint32_t shared, std::uint32_t vertices)
    : Shared(shared)
    , Faces(tets)
    , Visits(Faces)
    , Numbers(vertices, Unmet)
  {
    this->Masks.reserve(tets.size());
    this->Classes.reserve(tets.size());
    this->Result.TetOrder.reserve(tets.size());
    this->Tets.reserve(tets.size());
    this->Result.Tree.Parents.reserve(tets.size());
    this->Result.Tree.Gates.reserve(vertices);
    this->InputOf.reserve(vertices);
  }

  EncodedTree Encode()
  {
    const auto count = this->Faces.Rows.size();
    auto& order = this->Result.TetOrder;
    for (std::uint32_t head = 0; head < count; ++head)
    {
      if (head == order.size())
      {
        this->AddRoot(this->Visits.FindFirst());
      }
      std::uint8_t mask = 0;
      for (unsigned face = 0; face < FaceCount; ++face)
      {
        mask |= this->Attach(head, face) ? static_cast<std::uint8_t>(1u << face) : 0;
      }
      this->Masks.push_back(mask);
    }
    this->NameShared();
    this->FindFlips();
    this->Write();
    return std::move(this->Result);
  }

private:
  static constexpr std::uint32_t Unmet = 0xffffffffu;

  std::uint32_t GetNext() const { return static_cast<std::uint32_t>(this->InputOf.size()); }

  /** Numbers a vertex that was not met before. */
  std::uint32_t Meet(std::uint32_t input, PackedTet gate)
  {
    const auto number = this->GetNext();
    this->Numbers[input] = number;
    this->InputOf.push_back(input);
    this->Result.Tree.Gates.push_back(gate);
    return number;
  }

  void Add(std::uint32_t tet, PackedTet corners, std::uint32_t parent)
  {
    this->Visits.Visit(tet);
    this->Result.TetOrder.push_back(tet);
    this->Tets.push_back(corners);
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
    this->Add(tet, Pack(corners[0], corners[1], corners[2], corners[3]), TetTree::NoTet);
  }

  /** Attaches the tetrahedron over a face, if there is one. */
  bool Attach(std::uint32_t head, unsigned face)
  {
    const auto parent = this->Tets[head];
    const auto& row = this->Faces.Rows[this->Result.TetOrder[head]];
    const auto opposite = this->InputOf[GetCorner(parent, face)];
    const auto corner = std::find(row.Corners.begin(), row.Corners.end(), opposite);
    const auto over =
      this->Visits.Find(row.Over[static_cast<std::size_t>(corner - row.Corners.begin())]);
    if (over == FaceTable::None)
    {
      return false;
    }
    const auto input = this->Faces.Rows[over / 4].Corners[over % 4];
    const auto gate = GetFace(parent, FaceShifts[face]);
    std::uint32_t apex = this->Numbers[input];
    if (apex == Unmet)
    {
      this->Classes.push_back(New);
      apex = this->Meet(input, (gate & LowThree) | PackedTet{ GetCorner(parent, face) } << 48);
    }
    else
    {
      const auto symbol = this->FindSymbol(head, apex);
      this->Classes.push_back(symbol);
      if (symbol == Far)
      {
        this->Fars.Put(this->GetNext() - 1 - apex);
      }
    }
    this->Add(over / 4, (gate & LowThree) | PackedTet{ apex } << 48, head);
    return true;
  }

  /** The first symbol that names a vertex as the fourth corner of a near tetrahedron. */
  std::uint8_t FindSymbol(std::uint32_t parent, std::uint32_t apex) const
  {
    const auto& tets = this->Tets;
    const auto here = tets.size();
    for (unsigned k = 1; k <= Reach && k <= here; ++k)
    {
      if (tets[here - k] >> 48 == apex)
      {
        return static_cast<std::uint8_t>(Before + k - 1);
      }
    }
    for (unsigned k = 1; k <= Reach; ++k)
    {
      if (parent + k < here && tets[parent + k] >> 48 == apex)
      {
        return static_cast<std::uint8_t>(BehindParent + k - 1);
      }
      if (k <= parent && tets[parent - k] >> 48 == apex)
      {
        return static_cast<std::uint8_t>(BeforeParent + k - 1);
      }
    }
    return Far;
  }

  void NameShared()
  {
    auto& tree = this->Result.Tree;
    std::uint32_t after = 0; // the last shared vertex
    std::int64_t place = -1;
    for (std::uint32_t v = 0; v < this->InputOf.size(); ++v)
    {
      const auto input = this->InputOf[v];
      if (input >= this->Shared)
      {
        tree.Sources.push_back(static_cast<std::uint32_t>(this->Result.OwnOrder.size()));
        this->Result.OwnOrder.push_back(input - this->Shared);
        continue;
      }
      this->SharedNames.Put(v - after);
      this->SharedNames.Put(FromSigned(std::int64_t{ input } - place - 1));
      after = v + 1;
      place = input;
      tree.Sources.push_back(input | TetTree::SharedFlag);
    }
  }

  /** Marks the tetrahedra that have another orientation than their neighbors. */
  void FindFlips()
  {
    auto& tree = this->Result.Tree;
    for (std::size_t t = 0; t < this->Tets.size(); ++t)
    {
      InputTet corners{};
      for (unsigned k = 0; k < 4; ++k)
      {
        corners[k] = this->InputOf[GetCorner(this->Tets[t], k)];
      }
      const auto& input = this->Faces.Rows[this->Result.TetOrder[t]].Corners;
      if (tree.Parents[t] != TetTree::NoTet && IsMirrored(corners, input))
      {
        tree.Flips.resize((this->Tets.size() + 7) / 8);
        tree.Flips[t / 8] |= static_cast<std::uint8_t>(1u << t % 8);
      }
    }
  }

  void Write()
  {
    auto& tree = this->Result.Tree;
    ByteWriter out;
    out.Put<std::uint8_t>(tree.Flips.empty() ? 0 : 1);
    out.PutVarint(this->Roots);
    Bytes masks((this->Masks.size() + 1) / 2, 0);
    for (std::size_t t = 0; t < this->Masks.size(); ++t)
    {
      masks[t / 2] |= static_cast<std::uint8_t>(this->Masks[t] << t % 2 * 3);
    }
    PutPacked(out, masks);
    PutPacked(out, this->Classes);
    this->Fars.Finish(out);
    this->RootCorners.Finish(out);
    this->SharedNames.Finish(out);
    if (!tree.Flips.empty())
    {
      PutPacked(out, tree.Flips);
    }
    this->Result.Stream = std::move(out.Data);
    tree.Tets = PaddedTets(this->Tets.size());
    std::copy(this->Tets.begin(), this->Tets.end(), tree.Tets.data());
  }

  const std::uint32_t Shared;
  const FaceTable Faces;
  FaceVisits Visits;
  std::vector<std::uint32_t> Numbers; // of the input's vertices
  std::vector<std::uint32_t> InputOf; // of the numbers
  std::vector<PackedTet> Tets;
  Bytes Masks; // the faces with children of each tetrahedron
  Bytes Classes;
  NumberWriter Fars;
  NumberWriter RootCorners;
  NumberWriter SharedNames;
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
