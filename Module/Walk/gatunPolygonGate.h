// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPolygonGate_h
#define gatunPolygonGate_h

#include "gatunHexForm.h"
#include "gatunPolygonCell.h"
#include "gatunPolygonFront.h"
#include "gatunPolygonModels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace gatun
{
/** The surroundings of a gate, before its cell is known. Form: as of PolygonCell. */
template <typename Builder, typename Form>
class PolygonGate
{
public:
  static constexpr bool OfHexahedra = std::is_same_v<Form, HexForm>;

  PolygonGate(
    const PolygonFront& front, const Builder& mesh, const PolygonCell<Builder, Form>& cell)
    : Open(front)
    , Mesh(mesh)
    , Cell(cell)
  {
  }

  /** Sets Grades, Angles and, unless all cells are hexahedra, Degrees. */
  void Grade(const PolygonFront::Face& gate)
  {
    this->Grades = { .Degree = OfHexahedra ? 4u : unsigned{ gate.Degree } };
    ResetValues(this->Overs, this->Grades.Degree, PolygonFront::None);
    ResetValues(this->Angles, this->Grades.Degree, std::uint8_t{ 16 });
    for (unsigned i = 0; i < this->Grades.Degree; ++i)
    {
      const auto side = gate.First + i;
      const auto link = this->Open.GetSide(side).Over;
      this->Overs[i] = this->Open.GetOpen(side);
      this->Grades.MostCells = std::max(this->Grades.MostCells, link.GetCells());
      if (this->Overs[i] == PolygonFront::None)
      {
        ++this->Grades.Borders;
        this->Grades.Coplanar += this->IsCoplanar(gate, side, link.GetFar());
      }
    }
    this->GradeAngles(gate);
    for (const auto angle : this->Angles)
    {
      this->Grades.LeastAngle = std::min(this->Grades.LeastAngle, unsigned{ angle });
    }
    if constexpr (!OfHexahedra)
    {
      this->FindPattern(gate);
    }
  }

  /** The other chunks that use all corners of a gate. */
  std::uint32_t GetUsers(const PolygonFront::Face& gate) const
  {
    auto users = ~std::uint32_t{ 0 };
    for (unsigned i = 0; i < gate.Degree; ++i)
    {
      users &= this->Mesh.GetPlace(this->Open.GetSide(gate.First + i).Corner).Users;
    }
    return users;
  }

  template <typename T>
  using OfSides = std::conditional_t<OfHexahedra, std::array<T, 4>, std::vector<T>>;

  GateGrades Grades;
  OfSides<std::uint8_t> Angles;      // to the faces over the sides, as GradeAngle; 16 at the border
  std::vector<std::uint8_t> Degrees; // of the faces that are probably over the sides, or 0

private:
  /** Grades the angles to the faces that are over the gate's sides. */
  void GradeAngles(const PolygonFront::Face& gate)
  {
    if constexpr (OfHexahedra)
    {
      if (this->Grades.Borders == 0)
      {
        this->Angles = this->Cell.GradeAngles(gate, this->Overs);
        return;
      }
    }
    for (unsigned i = 0; i < this->Grades.Degree; ++i)
    {
      if (this->Overs[i] != PolygonFront::None)
      {
        this->Angles[i] =
          static_cast<std::uint8_t>(this->Cell.GradeAngle(gate.First + i, this->Overs[i]));
      }
    }
  }

  /** Predicts which faces are glued, and their degrees. */
  void FindPattern(const PolygonFront::Face& gate)
  {
    auto& grades = this->Grades;
    this->Degrees.assign(gate.Degree, 0);
    std::array<unsigned, 3> likely{}; // triangles, quads, larger faces
    for (unsigned i = 0; i < gate.Degree; ++i)
    {
      const bool isLikely = this->Angles[i] <= 5;
      const unsigned degree = isLikely ? this->Open.GetSide(this->Overs[i]).Degree : 0u;
      const unsigned kind = isLikely ? std::min(degree, 5u) - 2 : 0;
      this->Degrees[i] = static_cast<std::uint8_t>(degree);
      grades.Pattern = gate.Degree <= 4 ? grades.Pattern * 4 + kind : 0;
      if (kind > 0)
      {
        likely[kind - 1] += likely[kind - 1] < 3;
      }
    }
    if (gate.Degree > 4)
    {
      grades.Pattern = (likely[0] * 4 + likely[1]) * 4 + likely[2];
    }
  }

  bool IsCoplanar(const PolygonFront::Face& gate, std::uint32_t side, Vertex far) const
  {
    if (far >= this->Mesh.GetVertices())
    {
      return false;
    }
    const auto d = ToVector(this->Mesh.GetPlace(far)) -
      ToVector(this->Mesh.GetPlace(this->Open.GetSide(side).Corner));
    const float height = Dot(d, gate.Normal);
    return height * height < 0.01F * Dot(d, d);
  }

  const PolygonFront& Open;
  const Builder& Mesh;
  const PolygonCell<Builder, Form>& Cell; // knows angles
  OfSides<std::uint32_t> Overs;           // the open sides over the sides, or None
};
}

#endif
