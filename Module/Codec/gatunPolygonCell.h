// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPolygonCell_h
#define gatunPolygonCell_h

#include "gatunCellForms.h"
#include "gatunCellRules.h"
#include "gatunError.h"
#include "gatunFillRecord.h"
#include "gatunPolygonFront.h"
#include "gatunTopology.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace gatun
{
/** The cell that a walk attaches to the front: corners that are known, and faces that are glued. */
template <typename Builder>
class PolygonCell
{
public:
  PolygonCell(PolygonFront& front, Builder& mesh)
    : Open(front)
    , Mesh(mesh)
    , Stamps(mesh.GetAllVertices(), 0)
    , CandidateStamps(mesh.GetAllVertices(), 0)
  {
    for (const auto& rule : GetCellRules())
    {
      this->RuleMasks.push_back(GetMask(rule));
    }
  }

  /** number: of the form. */
  void Begin(const CellForm& form, std::uint16_t number)
  {
    this->Form = &form;
    this->FormNumber = number;
    ++this->Stamp;
    this->FirstNew = this->Mesh.GetVertices();
    this->Locals.assign(form.Corners, NoVertex);
    this->FrontSides.assign(form.Corner.size(), PolygonFront::None);
    this->Glued.clear();
  }

  //----------------------------------------------------------------------------
  // Corners

  Vertex GetCorner(unsigned corner) const { return this->Locals[corner]; }

  /** Throws Error(Corrupt) if the cell has the vertex already. */
  void SetCorner(unsigned corner, Vertex vertex)
  {
    if (this->Has(vertex))
    {
      ThrowCorrupt("a walk makes a cell with the same vertex twice");
    }
    this->Stamps[vertex] = this->Stamp;
    this->Locals[corner] = vertex;
  }

  /** The known vertices around a corner. */
  CellRecord MakeRecord(unsigned corner) const
  {
    CellRecord record;
    const auto near = FillRecord(record, this->Form->Graph, corner,
      [&](CellGraph::Local local) { return this->Locals[local]; });
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
  // Faces

  bool IsGlued(unsigned face) const
  {
    return this->FrontSides[this->Form->GetFirstSide(face)] != PolygonFront::None;
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
  }

  /** Calls use(corner of the form, vertex) for the corners of an open face, whose side runs against
   * a side of the form. */
  template <typename Use>
  void ForEachCorner(unsigned formSide, std::uint32_t side, Use&& use) const
  {
    const unsigned face = this->Form->Face[formSide];
    const unsigned degree = this->Form->GetDegree(face);
    const auto* const corners = &this->Form->Corner[this->Form->GetFirstSide(face)];
    const auto* const sides = &this->Open.GetSide(side - this->Open.GetSide(side).Index);
    unsigned at = formSide - this->Form->GetFirstSide(face);
    auto from = this->Open.GetNext(side) - (side - this->Open.GetSide(side).Index);
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
    const auto& over = this->Open.GetSide(side);
    const unsigned face = this->Form->Face[formSide];
    const unsigned degree = this->Form->GetDegree(face);
    if (over.Degree != degree)
    {
      return false;
    }
    const auto* const corners = &this->Form->Corner[this->Form->GetFirstSide(face)];
    const auto* const sides = &over - over.Index;
    unsigned at = formSide - this->Form->GetFirstSide(face);
    at = at + 1 < degree ? at + 1 : 0;
    unsigned from = over.Index;
    agree = 0;
    for (unsigned i = 2; i < degree; ++i) // the edge's corners are known
    {
      at = at + 1 < degree ? at + 1 : 0;
      from = from > 0 ? from - 1 : degree - 1;
      const auto known = this->Locals[corners[at]];
      const auto vertex = sides[from].Corner;
      if (known != vertex && (known != NoVertex || this->Has(vertex)))
      {
        return false;
      }
      agree += known == vertex;
    }
    return true;
  }

  void Glue(unsigned formSide, std::uint32_t side)
  {
    const unsigned face = this->Form->Face[formSide];
    const unsigned first = this->Form->GetFirstSide(face);
    const unsigned degree = this->Form->GetDegree(face);
    this->ForEachCorner(formSide, side,
      [&](unsigned corner, Vertex vertex)
      {
        this->Stamps[vertex] = this->Stamp;
        this->Locals[corner] = vertex;
      });
    for (unsigned i = 0, at = formSide; i < degree; ++i)
    {
      this->FrontSides[at] = side;
      at = at + 1 - first < degree ? at + 1 : first;
      side = this->Open.GetLast(side);
    }
    this->Glued.push_back(static_cast<std::uint8_t>(face));
  }

  /** Grades the angle between the faces of two linked sides. */
  unsigned GradeAngle(std::uint32_t side, std::uint32_t over) const
  {
    const auto& corner = this->Open.GetSide(side).Corner;
    const auto next = this->Open.GetNext(this->Open.GetNext(over));
    return gatun::GradeAngle(this->Open.GetFaceOfSide(side).Normal,
      this->Open.GetFaceOfSide(over).Normal, this->Mesh.GetPlace(corner),
      this->Mesh.GetPlace(this->Open.GetSide(next).Corner));
  }

  /** Appends all faces as a polyhedron has them. */
  void AppendFaces(std::vector<Vertex>& faces, bool mirrored) const
  {
    for (unsigned f = 0; f < this->Form->GetNumberOfFaces(); ++f)
    {
      const unsigned first = this->Form->GetFirstSide(f);
      const unsigned degree = this->Form->GetDegree(f);
      const bool backward = mirrored != (f == 0);
      faces.push_back(degree);
      for (unsigned i = 0; i < degree; ++i)
      {
        const unsigned side = first + (backward ? degree - 1 - i : i);
        faces.push_back(this->Locals[this->Form->Corner[side]]);
      }
    }
  }

  //----------------------------------------------------------------------------
  // Vertices that may be a corner

  struct Candidate
  {
    Vertex Id;
    float Distance; // squared, to the predicted place
    bool operator<(const Candidate& other) const
    {
      return this->Distance != other.Distance ? this->Distance < other.Distance
                                              : this->Id < other.Id;
    }
  };

  /** Predicts a corner's place and finds the vertices on open faces around its neighbors, nearest
   * first. */
  void FindCandidates(unsigned corner, const CellRecord& record)
  {
    this->Predict(record);
    this->Candidates.clear();
    this->Nearest = { NoVertex, 0 };
    ++this->CandidateStamp;
    for (const auto local : this->Form->Graph.GetNeighbors(corner))
    {
      if (this->Locals[local] != NoVertex)
      {
        this->Open.ForEachAround(this->Locals[local],
          [&](std::uint32_t side)
          {
            this->AddCandidate(this->Open.GetSide(this->Open.GetNext(side)).Corner);
            // Where another face is, it has the side before as well.
            const auto& last = this->Open.GetSide(this->Open.GetLast(side));
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

  //----------------------------------------------------------------------------
  // The front

  /** Closes the glued faces and opens the others. getFrame(face) is stored with each one. */
  template <typename GetFrame>
  void Attach(std::uint32_t cell, std::uint8_t type, GetFrame&& getFrame)
  {
    const auto& form = *this->Form;
    this->FindTouched();
    for (const auto face : this->Glued)
    {
      this->Open.Close(this->Open.GetSide(this->FrontSides[form.GetFirstSide(face)]).Face);
    }
    this->NewSides.assign(form.Corner.size(), PolygonFront::None);
    for (unsigned f = 0; f < form.GetNumberOfFaces(); ++f)
    {
      if (!this->IsGlued(f))
      {
        this->OpenFace(f, cell, type, getFrame(f));
      }
    }
    for (const auto& edge : form.Edges)
    {
      this->JoinSides(edge[0], edge[1]);
    }
    for (const auto& touch : this->Touched)
    {
      this->JoinTouched(touch);
    }
  }

  const CellForm* Form = nullptr;
  std::uint16_t FormNumber = 0;
  std::vector<std::uint8_t> Glued;       // faces of the form, in the order of gluing
  std::vector<std::uint32_t> FrontSides; // for each side of the form that of the front
  LatticePoint Predicted;
  float EdgeSquared = 0; // of the edge to the first neighbor of Predicted

private:
  /** An edge of the cell where the front is already. */
  struct Touch
  {
    unsigned FormSide;
    std::uint32_t Side;
  };

  bool Has(Vertex vertex) const { return this->Stamps[vertex] == this->Stamp; }

  /** The vertex beyond a neighbor of a corner, over the first glued face with the neighbor and
   * without the corner. */
  Vertex FindBelow(unsigned corner, unsigned neighbor) const
  {
    for (const auto face : this->Glued)
    {
      if ((this->Form->FaceMasks[face] >> (neighbor % 64) & 1) == 0 ||
        this->FindSide(face, corner) != CellForm::None)
      {
        continue;
      }
      const auto side = this->FindSide(face, neighbor);
      if (side != CellForm::None)
      {
        // The side of the open face that begins there.
        const auto from = this->FrontSides[this->Form->GetFirstSide(face) + side];
        return this->Open.GetSide(face == 0 ? from : this->Open.GetNext(from)).Below;
      }
    }
    return NoVertex;
  }

  /** The place of a corner in a face, or CellForm::None. */
  unsigned FindSide(unsigned face, unsigned corner) const
  {
    if ((this->Form->FaceMasks[face] >> (corner % 64) & 1) == 0)
    {
      return CellForm::None;
    }
    const auto* const begin = &this->Form->Corner[this->Form->GetFirstSide(face)];
    const unsigned degree = this->Form->GetDegree(face);
    unsigned side = 0;
    while (side < degree && begin[side] != corner)
    {
      ++side;
    }
    return side < degree ? side : unsigned{ CellForm::None };
  }

  /** Finds the place that the first rule for a record predicts. */
  void Predict(const CellRecord& record)
  {
    const auto mask = record.GetMask();
    std::size_t rule = 0;
    while (rule + 1 < this->RuleMasks.size() && (this->RuleMasks[rule] & ~mask) != 0)
    {
      ++rule;
    }
    const auto& weights = GetCellRules()[rule];
    LatticePoint sum;
    for (unsigned k = 0; k < CellRecord::Size; ++k)
    {
      if (weights[k] != 0)
      {
        const auto weight = static_cast<float>(weights[k]);
        const auto& place = this->Mesh.GetPlace(record.Known[k]);
        sum.X += weight * place.X;
        sum.Y += weight * place.Y;
        sum.Z += weight * place.Z;
      }
    }
    constexpr float unit = 1.0F / 256.0F;
    this->Predicted = { sum.X * unit, sum.Y * unit, sum.Z * unit, 0 };
    this->EdgeSquared = this->GetDistance(record.Known[CellRecord::N1]);
  }

  /** Squared, to the predicted place. */
  float GetDistance(Vertex vertex) const
  {
    const auto d = this->Mesh.GetPlace(vertex) - this->Predicted;
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

  /** Finds open sides along edges of the cell that are on none of the glued faces. */
  void FindTouched()
  {
    const auto& form = *this->Form;
    this->Touched.clear();
    if (this->Glued.empty())
    {
      return;
    }
    for (const auto& [side, twin] : form.Edges)
    {
      if (this->FrontSides[side] != PolygonFront::None ||
        this->FrontSides[twin] != PolygonFront::None)
      {
        continue;
      }
      const auto one = this->Locals[form.Corner[side]];
      const auto other = this->Locals[form.Corner[twin]];
      if (std::max(one, other) >= this->FirstNew)
      {
        continue;
      }
      auto found = PolygonFront::None;
      this->Open.ForEachAround(one,
        [&](std::uint32_t begin)
        {
          const auto before = this->Open.GetLast(begin);
          const bool ends = this->Open.GetSide(this->Open.GetNext(begin)).Corner == other;
          if ((ends || this->Open.GetSide(before).Corner == other) &&
            !this->IsFaceGlued(this->Open.GetSide(begin).Face))
          {
            found = ends ? begin : before;
          }
        });
      if (found != PolygonFront::None)
      {
        this->Touched.push_back({ side, found });
      }
    }
  }

  bool IsFaceGlued(std::uint32_t id) const
  {
    return std::any_of(this->Glued.begin(), this->Glued.end(),
      [&](std::uint8_t face)
      { return this->Open.GetSide(this->FrontSides[this->Form->GetFirstSide(face)]).Face == id; });
  }

  void OpenFace(unsigned face, std::uint32_t cell, std::uint8_t type, std::uint32_t frame)
  {
    const auto& form = *this->Form;
    const unsigned first = form.GetFirstSide(face);
    const unsigned degree = form.GetDegree(face);
    PolygonFront::Face opened{};
    opened.Degree = static_cast<std::uint16_t>(degree);
    opened.Form = this->FormNumber;
    opened.Cell = cell;
    opened.Frame = static_cast<std::uint16_t>(frame);
    opened.Type = type;
    opened.FormFace = static_cast<std::uint8_t>(face);
    opened.Open = true;
    const auto begin = this->Open.AddFace(opened);
    for (unsigned i = 0; i < degree; ++i)
    {
      // The gate of a seed is opened, too, in the direction of the other faces.
      const unsigned side = first + (face == 0 ? degree - 1 - i : i);
      const auto below = form.Below[side];
      this->Open.SetSide(begin + i, this->Locals[form.Corner[side]],
        below != CellForm::None ? this->Locals[below] : NoVertex);
      const unsigned last = face == 0 ? first + (2 * degree - 2 - i) % degree : side;
      this->NewSides[last] = begin + i;
    }
    this->Open.GetFaceOfSide(begin).Normal = this->GetNormal(&this->Open.GetSide(begin), degree);
  }

  Direction GetNormal(const PolygonFront::Side* sides, unsigned degree) const
  {
    const auto place = [&](unsigned i) -> const LatticePoint&
    { return this->Mesh.GetPlace(sides[i].Corner); };
    Direction sum;
    auto last = place(1) - place(0);
    for (unsigned i = 2; i < degree; ++i)
    {
      const auto next = place(i) - place(0);
      const auto cross = Cross(last, next);
      sum.X += cross.X;
      sum.Y += cross.Y;
      sum.Z += cross.Z;
      last = next;
    }
    const float length = std::sqrt(Dot(sum, sum));
    return length > 0 ? Direction{ sum.X / length, sum.Y / length, sum.Z / length } : Direction{};
  }

  /** Links what is on the two sides of an edge of the cell. */
  void JoinSides(unsigned one, unsigned other)
  {
    if (this->NewSides[one] == PolygonFront::None)
    {
      std::swap(one, other);
    }
    const auto a = this->NewSides[one];
    const auto b = this->NewSides[other];
    if (a != PolygonFront::None && b != PolygonFront::None)
    {
      this->Open.Join(a, b, 1);
      if (std::none_of(this->Touched.begin(), this->Touched.end(),
            [&](const Touch& touch) { return touch.FormSide == std::min(one, other); }))
      {
        this->Mesh.LogEdge(this->Locals[this->Form->Corner[one]], this->GetEnd(one));
      }
      return;
    }
    const auto glued = this->FrontSides[other];
    const auto link = this->Open.GetSide(glued).Over;
    const auto over = this->Open.GetOpen(glued);
    if (a != PolygonFront::None)
    {
      if (over != PolygonFront::None)
      {
        this->Open.Join(a, over, link.GetCells() + 1);
      }
      else
      {
        this->Open.GetSide(a).Over =
          SideLink::ToBorder(link.IsBorder() ? link.GetFar() : NoVertex, link.GetCells() + 1);
      }
      return;
    }
    const auto second = this->FrontSides[one];
    const auto secondLink = this->Open.GetSide(second).Over;
    const auto secondOver = this->Open.GetOpen(second);
    const auto cells = link.GetCells() + secondLink.GetCells() + 1;
    if (over != PolygonFront::None && secondOver != PolygonFront::None)
    {
      this->Open.Join(over, secondOver, cells);
    }
    else if (over != PolygonFront::None || secondOver != PolygonFront::None)
    {
      const auto& end = over != PolygonFront::None ? secondLink : link;
      this->Open.GetSide(over != PolygonFront::None ? over : secondOver).Over =
        SideLink::ToBorder(end.IsBorder() ? end.GetFar() : NoVertex, cells);
    }
  }

  /** The vertex where a side of the form ends. */
  Vertex GetEnd(unsigned side) const
  {
    const unsigned first = this->Form->GetFirstSide(this->Form->Face[side]);
    const unsigned degree = this->Form->GetDegree(this->Form->Face[side]);
    return this->Locals[this->Form->Corner[side + 1 - first < degree ? side + 1 : first]];
  }

  /** Where the front touches itself in an edge, its faces are linked in pairs. */
  void JoinTouched(const Touch& touch)
  {
    const auto side = touch.Side;
    const auto link = this->Open.GetSide(side).Over;
    const auto over = this->Open.GetOpen(side);
    const auto a = this->NewSides[touch.FormSide];
    const auto b = this->NewSides[this->Form->Twin[touch.FormSide]];
    const bool against = this->Open.GetSide(a).Corner != this->Open.GetSide(side).Corner;
    const auto cells = link.GetCells() + 1;
    this->Open.Join(side, against ? a : b, cells);
    const auto rest = against ? b : a;
    if (over != PolygonFront::None)
    {
      this->Open.Join(over, rest, cells);
    }
    else
    {
      this->Open.GetSide(rest).Over =
        SideLink::ToBorder(link.IsBorder() ? link.GetFar() : NoVertex, cells);
    }
  }

  PolygonFront& Open;
  Builder& Mesh;
  std::vector<unsigned> RuleMasks;
  std::vector<Vertex> Locals;          // the vertex at each corner of the form
  std::vector<std::uint32_t> Turns;    // for each corner a side of a glued face that begins there
  std::vector<std::uint32_t> Stamps;   // for each vertex, the last cell that has it
  std::vector<std::uint32_t> NewSides; // for each side of the form one that was opened
  std::vector<Touch> Touched;
  std::vector<std::uint32_t> CandidateStamps; // for each vertex, the last list that has it
  std::vector<Candidate> Candidates;
  Candidate Nearest{ NoVertex, 0 };
  std::uint32_t CandidateStamp = 0;
  std::uint32_t Stamp = 0;
  Vertex FirstNew = 0;
};
}

#endif
