// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFaceMarks_h
#define gatunFaceMarks_h

// Surface cells that are faces of a walk's cells at the border, such as the patches of a boundary.

#include "gatunAttachedNodes.h"
#include "gatunCellBuilder.h"
#include "gatunEncoderMarks.h"
#include "gatunPolygonFront.h"
#include "gatunPolygonModels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Codes for each face at the border whether it is a cell as well. */
template <typename Coder, typename Side>
class FaceMarks
{
public:
  FaceMarks(Coder& coder, CellBuilder<Side>& mesh, AttachedNodes<Coder, Side>& nodes)
    : Symbols(coder)
    , Mesh(mesh)
    , Nodes(nodes)
    , Types(256)
    , Turns(1u << 10)
  {
  }

  /** borders: in the order in which they were closed. actual: of an encoder. */
  void Run(const ClosedFaces& borders, EncoderMarks* actual)
  {
    for (const auto& face : borders.Faces)
    {
      this->Face.clear();
      auto users = ~std::uint32_t{ 0 };
      for (unsigned i = 0; i < face.Degree; ++i)
      {
        this->Face.push_back(borders.Corners[face.First + i]);
        users &= this->Mesh.GetPlace(this->Face.back()).Users;
      }
      const auto direction = GradeDirection(face.Normal);
      auto& last = this->Last[direction];
      auto& model = this->IsMarked[(direction * 4 + last) * 2 + (users != 0)];
      const bool marked = this->Symbols.Bit(model, this->FindCell(actual));
      last = (last * 2 + marked) % 4;
      if (marked)
      {
        this->CodeCell(face, actual);
      }
    }
  }

private:
  /** The axis that a face's normal is nearest to: twice its number, plus 1 if it points down. */
  static unsigned GradeDirection(const Vec3& normal)
  {
    const std::array parts{ normal[0], normal[1], normal[2] };
    unsigned axis = 0;
    for (unsigned i = 1; i < 3; ++i)
    {
      axis = std::abs(parts[i]) > std::abs(parts[axis]) ? i : axis;
    }
    return 2 * axis + (parts[axis] < 0);
  }

  bool FindCell(EncoderMarks* actual)
  {
    if constexpr (Coder::Encoding)
    {
      this->Input.clear();
      for (const auto v : this->Face)
      {
        this->Input.push_back(this->Mesh.Actual.InputOf[v]);
      }
      return actual->FindCell(this->Input);
    }
    return false;
  }

  void CodeCell(const PolygonFront::Face& face, const EncoderMarks* actual)
  {
    const auto degree = static_cast<unsigned>(this->Face.size());
    const auto type = CodeLast(this->Symbols, this->Types[std::min(degree, 255u)], this->TypeTree,
      Coder::Encoding ? actual->Type : std::uint8_t{ 0 });
    const auto turn =
      CodeLast(this->Symbols, this->Turns[MixContext<10>(type, face.Type, face.Frame)],
        this->TurnTree, Coder::Encoding ? actual->Turn : std::uint8_t{ 0 });
    if (CountMarkCorners(type, degree) != degree || turn >= 2 * degree)
    {
      ThrowCorrupt("a face is a cell of a type that it cannot have");
    }
    this->Corners.resize(degree);
    for (unsigned i = 0; i < degree; ++i)
    {
      this->Corners[GetMarkCorner(type, i)] = this->Face[GetMarkPlace(turn, i, degree)];
    }
    this->Nodes.CodeOfType(type, this->Corners, this->GetInputCorners(actual));
    this->Mesh.AddCell(type, this->Corners, {}, face.Cell);
  }

  /** Encoder: the points of the cell that was found, which comes next. */
  std::span<const std::uint32_t> GetInputCorners(const EncoderMarks* actual)
  {
    if constexpr (Coder::Encoding)
    {
      this->Mesh.Actual.CellOrder.push_back(actual->Cell);
      return this->Mesh.Actual.Input.GetCorners(actual->Cell);
    }
    return {};
  }

  Coder& Symbols;
  CellBuilder<Side>& Mesh;
  AttachedNodes<Coder, Side>& Nodes;
  std::array<BitModel, 48> IsMarked; // by direction, the last two there, and other chunks
  std::array<unsigned, 6> Last{};    // the last two decisions of each direction
  std::vector<LastTwo> Types;        // by the number of corners
  BitTree<8> TypeTree;
  std::vector<LastTwo> Turns;
  BitTree<8> TurnTree;
  std::vector<Vertex> Face, Corners;
  std::vector<std::uint32_t> Input;
};
}

#endif
