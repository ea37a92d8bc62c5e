// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPolygonCell_h
#define gatunPolygonCell_h

#include "gatunCandidate.h"
#include "gatunCellForms.h"
#include "gatunCellRules.h"
#include "gatunError.h"
#include "gatunFillRecord.h"
#include "gatunHexForm.h"
#include "gatunPolygonFront.h"
#include "gatunTopology.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace gatun
{
/** Sets a number of values to one. */
template <typename T>
void ResetValues(std::vector<T>& values, std::size_t number, const T& value)
{
  values.assign(number, value);
}
template <typename T, std::size_t N>
void ResetValues(std::array<T, N>& values, std::size_t, const T& value)
{
  values.fill(value);
}

/**
 * The cell that a walk attaches to the front: corners that are known, and faces that are glued.
 * Form: CellForm, or HexForm if all cells of the walk are hexahedra.
 */
template <typename Builder, typename Form>
class PolygonCell
{
public:
  static constexpr bool IsHexahedron = std::is_same_v<Form, HexForm>;

  PolygonCell(PolygonFront& front, Builder& mesh)
    : Open(front)
    , Mesh(mesh)
    , Stamps(IsHexahedron ? 0 : mesh.GetAllVertices(), 0)
    , CandidateStamps(mesh.GetAllVertices(), 0)
  {
  }

  /** number: of the form. */
  void Begin(const Form& form, std::uint16_t number)
  {
    this->Seen = &form;
    this->FormNumber = number;
    ++this->Stamp;
    this->FirstNew = this->Mesh.GetVertices();
    ResetValues(this->Locals, form.Corners, NoVertex);
    ResetValues(this->FrontSides, form.Corner.size(), PolygonFront::None);
    this->Glued.clear();
    this->GluedMask = 0;
  }

  const Form& GetForm() const { return *this->Seen; }

  //----------------------------------------------------------------------------
  // Corners

  Vertex GetCorner(unsigned corner) const { return this->Locals[corner]; }

  /** The vertex where a side of the form ends. */
  Vertex GetEnd(unsigned side) const
  {
    if constexpr (IsHexahedron)
    {
      return this->Locals[HexForm::GetEnd(side)];
    }
    const unsigned first = this->Seen->GetFirstSide(this->Seen->Face[side]);
    const unsigned degree = this->Seen->GetDegree(this->Seen->Face[side]);
    return this->Locals[this->Seen->Corner[side + 1 - first < degree ? side + 1 : first]];
  }

  /** Whether a vertex was met before the cell. */
  bool IsOld(Vertex vertex) const { return vertex < this->FirstNew; }

  /** Throws Error(Corrupt) if the cell has the vertex already. */
  void SetCorner(unsigned corner, Vertex vertex)
  {
    if (this->Has(vertex))
    {
      ThrowCorrupt("a walk makes a cell with the same vertex twice");
    }
    this->Set(corner, vertex);
  }

  /** The known vertices around a corner. */
  CellRecord MakeRecord(unsigned corner) const
  {
    CellRecord record;
    std::array<CellGraph::Local, 3> near{ CellGraph::None, CellGraph::None, CellGraph::None };
    const auto getVertex = [&](CellGraph::Local local) { return this->Locals[local]; };
    if constexpr (IsHexahedron)
    {
      near = FillHexRecord(record, corner, getVertex);
    }
    else
    {
      near = FillRecord(record, this->Seen->Graph, corner, getVertex);
    }
    if (record.IsSeed())
    {
      // A corner that has no known neighbor.
      for (const auto vertex : this->Locals)
      {
        record.Known[CellRecord::N1] = vertex != NoVertex ? vertex : record.Known[CellRecord::N1];
      }
    }
    for (unsigned k = 0; k < 3 && near[k] != CellGraph::None; ++k)
    {
      record.Known[CellRecord::B1 + k] = this->FindBelow(corner, near[k]);
    }
    return record;
  }

  //----------------------------------------------------------------------------
  // Sides of the front

  std::uint32_t GetNext(std::uint32_t side) const
  {
    if constexpr (IsHexahedron)
    {
      return (side & ~3u) | ((side + 1) & 3); // all faces have four sides
    }
    return this->Open.GetNext(side);
  }

  std::uint32_t GetLast(std::uint32_t side) const
  {
    if constexpr (IsHexahedron)
    {
      return (side & ~3u) | ((side + 3) & 3);
    }
    return this->Open.GetLast(side);
  }

  std::uint32_t GetFaceNumber(std::uint32_t side) const
  {
    return IsHexahedron ? side / 4 : this->Open.GetSide(side).Face;
  }

  /** The place of a side in its face. */
  unsigned GetIndex(std::uint32_t side) const
  {
    return IsHexahedron ? side & 3 : this->Open.GetSide(side).Index;
  }

  /** The side of the front at the first side of a face that is glued. */
  std::uint32_t GetFirstFrontSide(unsigned face) const
  {
    return this->FrontSides[this->Seen->GetFirstSide(face)];
  }

  //----------------------------------------------------------------------------
  // Faces

  bool IsGlued(unsigned face) const
  {
    return IsHexahedron ? (this->GluedMask >> face & 1) != 0
                        : this->GetFirstFrontSide(face) != PolygonFront::None;
  }

  /** Makes an open face the gate of the cell. */
  void GlueGate(std::uint32_t gate)
  {
    const auto& face = this->Open.GetFace(gate);
    for (unsigned i = 0; i < face.Degree; ++i)
    {
      this->FrontSides[i] = face.First + i;
      this->SetCorner(i, this->Open.GetSide(face.First + i).Corner);
    }
    this->Glued.push_back(0);
    this->GluedMask = 1;
  }

  /** Calls use(corner of the form, vertex) for the corners of an open face, whose side runs against
   * a side of the form. */
  template <typename Use>
  void ForEachCorner(unsigned formSide, std::uint32_t side, Use&& use) const
  {
    const unsigned face = this->Seen->Face[formSide];
    const unsigned degree = this->Seen->GetDegree(face);
    const auto* const corners = &this->Seen->Corner[this->Seen->GetFirstSide(face)];
    const auto first = side - this->GetIndex(side);
    const auto* const sides = &this->Open.GetSide(first);
    unsigned at = formSide - this->Seen->GetFirstSide(face);
    auto from = this->GetNext(side) - first;
    for (unsigned i = 0; i < degree; ++i) // it begins where the form's side begins
    {
      use(unsigned{ corners[at] }, sides[from].Corner);
      at = at + 1 < degree ? at + 1 : 0;
      from = from > 0 ? from - 1 : degree - 1;
    }
  }

  /** Whether an open face may be a face of the cell. agree: the number of known corners in common
   * besides the edge. */
  bool CanGlue(unsigned formSide, std::uint32_t side, unsigned& agree) const
  {
    agree = 0;
    if constexpr (IsHexahedron)
    {
      const auto* const sides = &this->Open.GetSide(side & ~3u);
      const unsigned first = formSide & ~3u;
      return this->MayBe(HexForm::Corner[first | ((formSide + 2) & 3)],
               sides[(side + 3) & 3].Corner, agree) &&
        this->MayBe(
          HexForm::Corner[first | ((formSide + 3) & 3)], sides[(side + 2) & 3].Corner, agree);
    }
    else
    {
      const auto& over = this->Open.GetSide(side);
      const unsigned face = this->Seen->Face[formSide];
      const unsigned degree = this->Seen->GetDegree(face);
      if (over.Degree != degree)
      {
        return false;
      }
      const auto* const corners = &this->Seen->Corner[this->Seen->GetFirstSide(face)];
      const auto* const sides = &over - over.Index;
      unsigned at = formSide - this->Seen->GetFirstSide(face);
      at = at + 1 < degree ? at + 1 : 0;
      unsigned from = over.Index;
      for (unsigned i = 2; i < degree; ++i) // the edge's corners are known
      {
        at = at + 1 < degree ? at + 1 : 0;
        from = from > 0 ? from - 1 : degree - 1;
        if (!this->MayBe(corners[at], sides[from].Corner, agree))
        {
          return false;
        }
      }
      return true;
    }
  }

  void Glue(unsigned formSide, std::uint32_t side)
  {
    const unsigned face = this->Seen->Face[formSide];
    const unsigned first = this->Seen->GetFirstSide(face);
    const unsigned degree = this->Seen->GetDegree(face);
    this->ForEachCorner(
      formSide, side, [&](unsigned corner, Vertex vertex) { this->Set(corner, vertex); });
    for (unsigned i = 0, at = formSide; i < degree; ++i)
    {
      this->FrontSides[at] = side;
      at = at + 1 - first < degree ? at + 1 : first;
      side = this->GetLast(side);
    }
    this->Glued.push_back(static_cast<std::uint8_t>(face));
    if constexpr (IsHexahedron)
    {
      this->GluedMask |= 1u << face;
    }
  }

  /** Grades the angle between the faces of two linked sides. */
  GATUN_INLINE unsigned GradeAngle(std::uint32_t side, std::uint32_t over) const
  {
    const auto& corner = this->Open.GetSide(side).Corner;
    const auto next = this->GetNext(this->GetNext(over));
    return gatun::GradeAngle(this->Open.GetFace(this->GetFaceNumber(side)),
      this->Open.GetFace(this->GetFaceNumber(over)), this->Mesh.GetPlace(corner),
      this->Mesh.GetPlace(this->Open.GetSide(next).Corner));
  }

  /** Of a hexahedron: grades the angles between a face and those over its sides, all of which are
   * open. */
  std::array<std::uint8_t, 4> GradeAngles(
    const PolygonFront::Face& face, const std::array<std::uint32_t, 4>& overs) const
  {
    const auto getFace = [&](unsigned i) -> const PolygonFront::Face&
    { return this->Open.GetFace(overs[i] / 4); };
    const auto getBegin = [&](unsigned i) -> const LatticePoint&
    { return this->Mesh.GetPlace(this->Open.GetSide(face.First + i).Corner); };
    const auto getNext = [&](unsigned i) -> const LatticePoint&
    { return this->Mesh.GetPlace(this->Open.GetSide(overs[i] ^ 2).Corner); };
    const auto normals = Gather(getFace(0).Normal.Lanes, getFace(1).Normal.Lanes,
      getFace(2).Normal.Lanes, getFace(3).Normal.Lanes);
    const auto normal = Splat(face.Normal);
    const auto d = Gather(getNext(0), getNext(1), getNext(2), getNext(3)) -
      Gather(getBegin(0), getBegin(1), getBegin(2), getBegin(3));
    const auto turns = GetTurns(Dot(normal, normals), Dot(d, normal));
    std::array<std::uint8_t, 4> angles{};
    for (unsigned i = 0; i < 4; ++i)
    {
      angles[i] = face.HasNormal && getFace(i).HasNormal ? GradeTurn(turns[i]) : 16;
    }
    return angles;
  }

  /** Appends all faces as a polyhedron has them. */
  void AppendFaces(std::vector<Vertex>& faces, bool mirrored) const
  {
    for (unsigned f = 0; f < this->Seen->GetNumberOfFaces(); ++f)
    {
      const unsigned first = this->Seen->GetFirstSide(f);
      const unsigned degree = this->Seen->GetDegree(f);
      const bool backward = mirrored != (f == 0);
      faces.push_back(degree);
      for (unsigned i = 0; i < degree; ++i)
      {
        const unsigned side = first + (backward ? degree - 1 - i : i);
        faces.push_back(this->Locals[this->Seen->Corner[side]]);
      }
    }
  }

  //----------------------------------------------------------------------------
  // Vertices that may be a corner

  /** Finds the place that the first rule for a record predicts. */
  void Predict(const CellRecord& record)
  {
    this->Predicted =
      PredictPlace(record, [&](Vertex v) -> const LatticePoint& { return this->Mesh.GetPlace(v); });
    this->EdgeSquared = this->GetDistance(record.Known[CellRecord::N1]);
  }

  /** Predicts a corner's place and finds the vertices on open faces around its neighbors, nearest
   * first. */
  void FindCandidates(unsigned corner, const CellRecord& record)
  {
    this->Predict(record);
    this->Candidates.clear();
    this->Nearest = { NoVertex, 0 };
    ++this->CandidateStamp;
    for (const auto local : this->Seen->GetNeighbors(corner))
    {
      if (this->Locals[local] != NoVertex)
      {
        this->Open.ForEachAround(this->Locals[local],
          [&](std::uint32_t side)
          {
            this->AddCandidate(this->Open.GetSide(this->GetNext(side)).Corner);
            // Where another face is, it has the side before as well.
            const auto& last = this->Open.GetSide(this->GetLast(side));
            if (last.Over.IsBorder())
            {
              this->AddCandidate(last.Corner);
            }
          });
      }
    }
  }

  const std::vector<Candidate>& SortCandidates()
  {
    std::sort(this->Candidates.begin(), this->Candidates.end());
    return this->Candidates;
  }

  /** Grades how near the nearest candidate is, 0 to 6; 7 if there is none. */
  unsigned GradeNearest() const
  {
    if (this->Nearest.Id == NoVertex)
    {
      return 7;
    }
    static constexpr std::array limits{ 0.01F, 0.04F, 0.1F, 0.25F, 0.6F, 1.2F };
    unsigned grade = 0;
    while (grade < limits.size() && !(this->Nearest.Distance < limits[grade] * this->EdgeSquared))
    {
      ++grade;
    }
    return grade;
  }

  std::uint16_t FormNumber = 0;
  unsigned GluedMask = 0;     // of a hexahedron: bit f is set if face f is glued
  typename Form::Faces Glued; // faces of the form, in the order of gluing
  typename Form::template OfSides<std::uint32_t> FrontSides; // the glued sides of the front
  LatticePoint Predicted;
  float EdgeSquared = 0; // of the edge to the first neighbor of Predicted

private:
  /** Whether a vertex may be at a corner. Counts those that are known to be. */
  GATUN_INLINE bool MayBe(unsigned corner, Vertex vertex, unsigned& known) const
  {
    const auto there = this->Locals[corner];
    known += there == vertex;
    return there == vertex || (there == NoVertex && !this->Has(vertex));
  }

  GATUN_INLINE bool Has(Vertex vertex) const
  {
    if constexpr (IsHexahedron)
    {
      unsigned has = 0;
      for (const auto local : this->Locals)
      {
        has |= unsigned{ local == vertex };
      }
      return has != 0;
    }
    else
    {
      return this->Stamps[vertex] == this->Stamp;
    }
  }

  void Set(unsigned corner, Vertex vertex)
  {
    if constexpr (!IsHexahedron)
    {
      this->Stamps[vertex] = this->Stamp;
    }
    this->Locals[corner] = vertex;
  }

  /** The vertex beyond a neighbor of a corner, over the first glued face with the neighbor and
   * without the corner. */
  Vertex FindBelow(unsigned corner, unsigned neighbor) const
  {
    if constexpr (IsHexahedron)
    {
      const auto& near = HexForm::Neighbors[corner];
      const unsigned k = (neighbor == near[1]) + 2 * (neighbor == near[2]);
      const unsigned side = HexForm::Around[corner].SidesBelow[k];
      return this->FrontSides[side] != PolygonFront::None ? this->GetBelow(side) : NoVertex;
    }
    else
    {
      for (const auto face : this->Glued)
      {
        if ((this->Seen->FaceMasks[face] >> (neighbor % 64) & 1) == 0 ||
          this->FindPlace(face, corner) != CellForm::None)
        {
          continue;
        }
        const auto place = this->FindPlace(face, neighbor);
        if (place != CellForm::None)
        {
          return this->GetBelow(this->Seen->GetFirstSide(face) + place);
        }
      }
      return NoVertex;
    }
  }

  /** The vertex beyond the corner where a side of a glued face begins. */
  Vertex GetBelow(unsigned side) const
  {
    // The gate runs along the open face, other faces against it.
    const auto from = this->FrontSides[side];
    const bool isGate = side < this->Seen->GetDegree(0);
    return this->Open.GetSide(isGate ? from : this->GetNext(from)).Below;
  }

  /** The place of a corner in a face, or CellForm::None. */
  unsigned FindPlace(unsigned face, unsigned corner) const
  {
    if ((this->Seen->FaceMasks[face] >> (corner % 64) & 1) == 0)
    {
      return CellForm::None;
    }
    const auto* const begin = &this->Seen->Corner[this->Seen->GetFirstSide(face)];
    const unsigned degree = this->Seen->GetDegree(face);
    unsigned side = 0;
    while (side < degree && begin[side] != corner)
    {
      ++side;
    }
    return side < degree ? side : unsigned{ CellForm::None };
  }

  /** Squared, to the predicted place. */
  float GetDistance(Vertex vertex) const
  {
    const auto d = ToVector(this->Mesh.GetPlace(vertex)) - ToVector(this->Predicted);
    return Dot(d, d);
  }

  void AddCandidate(Vertex vertex)
  {
    if (!this->Has(vertex) && this->CandidateStamps[vertex] != this->CandidateStamp)
    {
      this->CandidateStamps[vertex] = this->CandidateStamp;
      const Candidate candidate{ vertex, this->GetDistance(vertex) };
      this->Candidates.push_back(candidate);
      if (this->Nearest.Id == NoVertex || candidate < this->Nearest)
      {
        this->Nearest = candidate;
      }
    }
  }

  PolygonFront& Open;
  Builder& Mesh;
  const Form* Seen = nullptr;
  typename Form::template OfCorners<Vertex> Locals; // the vertex at each corner of the form
  std::vector<std::uint32_t> Stamps;                // for each vertex, the last cell that has it
  std::vector<std::uint32_t> CandidateStamps;       // for each vertex, the last list that has it
  std::vector<Candidate> Candidates;
  Candidate Nearest{ NoVertex, 0 };
  std::uint32_t CandidateStamp = 0;
  std::uint32_t Stamp = 0;
  Vertex FirstNew = 0;
};
}

#endif
