// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceCell_h
#define gatunSurfaceCell_h

#include "gatunCandidate.h"
#include "gatunCellRules.h"
#include "gatunError.h"
#include "gatunPlaceGrid.h"
#include "gatunSurfaceFront.h"
#include "gatunTopology.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace gatun
{
/** The polygon that a walk attaches to the front: corners that are known, and edges that are glued.
 */
template <typename Builder>
class SurfaceCell
{
public:
  SurfaceCell(SurfaceFront& front, Builder& mesh)
    : Open(front)
    , Mesh(mesh)
    , Grid(mesh.GetAllVertices())
    , Stamps(mesh.GetAllVertices(), 0)
    , CandidateStamps(mesh.GetAllVertices(), 0)
    , FirstOwn(mesh.GetVertices())
  {
  }

  void Begin(std::uint32_t degree)
  {
    ++this->Stamp;
    this->FirstNew = this->Mesh.GetVertices();
    this->Corners.assign(degree, NoVertex);
    this->Glued.assign(degree, SurfaceFront::None);
  }

  std::uint32_t GetDegree() const { return static_cast<std::uint32_t>(this->Corners.size()); }

  /** corner: below twice the number of corners. */
  Vertex GetCorner(std::uint32_t corner) const { return this->Corners[this->Wrap(corner)]; }
  bool Has(Vertex vertex) const { return this->Stamps[vertex] == this->Stamp; }

  /** Throws Error(Corrupt) if the cell has the vertex already. */
  void SetCorner(std::uint32_t corner, Vertex vertex)
  {
    if (this->Has(vertex))
    {
      ThrowCorrupt("a walk makes a cell with the same vertex twice");
    }
    this->Stamps[vertex] = this->Stamp;
    this->Corners[corner] = vertex;
  }

  /** The edge of the front that is the side from a corner to the next one. */
  void Glue(std::uint32_t side, std::uint32_t edge) { this->Glued[side] = edge; }

  /** The known vertices around a corner. ahead, back: vertices along the front that may be near it,
   * or NoVertex. */
  CellRecord MakeRecord(std::uint32_t corner, Vertex ahead, Vertex back) const
  {
    CellRecord record;
    auto& known = record.Known;
    const auto degree = this->GetDegree();
    const auto before = corner > 0 ? corner - 1 : degree - 1;
    const auto after = corner + 1 < degree ? corner + 1 : 0;
    unsigned count = 0;
    for (const auto near : { std::min(before, after), std::max(before, after) })
    {
      if (this->Corners[near] != NoVertex)
      {
        known[CellRecord::N1 + count] = this->Corners[near];
        known[CellRecord::B1 + count] = this->FindPast(near, near == before);
        ++count;
      }
    }
    if (degree == 3 && known[CellRecord::B1] == known[CellRecord::B2])
    {
      known[CellRecord::D12] = known[CellRecord::B1]; // behind the gate is a triangle
      known[CellRecord::B1] = known[CellRecord::B2] = NoVertex;
    }
    else if (count == 2 ? degree == 4 : known[CellRecord::B1] != NoVertex)
    {
      known[CellRecord::D12] = this->GetCorner(corner + degree - 2);
    }
    if (this->Glued[0] != SurfaceFront::None)
    {
      known[CellRecord::D13] = back;
      known[CellRecord::D23] = ahead;
      const auto& gate = this->Open.Get(this->Glued[0]);
      if (corner == 2)
      {
        known[CellRecord::O] = gate.FarEnd;
        known[CellRecord::B3] = degree == 3 ? gate.FarBegin : gate.PastBegin;
      }
      else if (corner + 1 == degree)
      {
        known[CellRecord::O] = gate.FarBegin;
        known[CellRecord::B3] = gate.PastEnd;
      }
    }
    return record;
  }

  //----------------------------------------------------------------------------
  // Vertices that may be a corner

  /** Predicts a corner's place and finds the vertices around it, on the front and elsewhere. */
  void FindCandidates(const CellRecord& record)
  {
    this->Predict(record);
    for (auto& list : this->Candidates)
    {
      list.clear();
    }
    ++this->CandidateStamp;
    const float limit = 8.0F * this->EdgeSquared;
    this->Grid.ForEachAround(
      this->Predicted, std::sqrt(limit), this->Mesh.GetVertices(),
      [&](Vertex vertex) -> const LatticePoint& { return this->Mesh.GetPlace(vertex); },
      [&](Vertex vertex)
      {
        const Candidate candidate{ vertex, this->GetDistance(vertex) };
        if (candidate.Distance < limit && !this->Has(vertex) &&
          this->CandidateStamps[vertex] != this->CandidateStamp)
        {
          this->CandidateStamps[vertex] = this->CandidateStamp;
          this->Candidates[this->Open.IsOnFront(vertex) ? 0 : 1].push_back(candidate);
        }
      });
  }

  const std::vector<Candidate>& SortCandidates(bool onFront)
  {
    auto& list = this->Candidates[onFront ? 0 : 1];
    std::sort(list.begin(), list.end());
    return list;
  }

  /** The longest side of a triangle or quadrilateral, the first of equal ones; otherwise 0. */
  std::uint32_t FindLongestSide() const
  {
    std::uint32_t longest = 0;
    float most = -1;
    for (std::uint32_t i = 0; i < this->GetDegree() && this->GetDegree() <= 4; ++i)
    {
      const auto d = this->GetPlace(this->GetCorner(i + 1)) - this->GetPlace(this->Corners[i]);
      const float length = Dot(d, d);
      longest = length > most ? i : longest;
      most = std::max(most, length);
    }
    return longest;
  }

  //----------------------------------------------------------------------------
  // The front

  /** Closes the glued edges and opens the others. edge: the data that they have in common.
   * getFrame(side) is stored with each one. */
  template <typename GetFrame>
  void Attach(SurfaceFront::Edge edge, GetFrame&& getFrame)
  {
    const auto degree = this->GetDegree();
    this->FindGlued();
    for (const auto glued : this->Glued)
    {
      if (glued != SurfaceFront::None)
      {
        this->Open.Close(glued);
      }
    }
    const auto firstEdge = this->Open.GetEnd();
    this->Sides.assign(degree, SurfaceFront::None);
    edge.Normal = this->GetNormal();
    edge.Degree = degree;
    for (std::uint32_t i = 0; i < degree; ++i)
    {
      this->Open.AddCell(this->Corners[i]);
      if (this->Glued[i] != SurfaceFront::None)
      {
        continue;
      }
      edge.Begin = this->GetCorner(i + 1);
      edge.End = this->Corners[i];
      edge.PastBegin = this->GetCorner(i + 2);
      edge.PastEnd = this->GetCorner(i + degree - 1);
      edge.FarBegin = this->FindPast(this->Wrap(i + 2), false);
      edge.FarEnd = this->FindPast(this->Wrap(i + degree - 1), true);
      edge.Along = Normalize(this->GetPlace(edge.End) - this->GetPlace(edge.Begin));
      edge.Frame = getFrame(i);
      this->Sides[i] = this->Open.Add(edge);
      if (std::max(edge.Begin, edge.End) >= this->FirstOwn)
      {
        this->Mesh.LogEdge(edge.End, edge.Begin);
      }
    }
    for (std::uint32_t i = 0; i < degree; ++i)
    {
      this->LinkCorner(i, i + 1 < degree ? i + 1 : 0, firstEdge);
    }
  }

  LatticePoint Predicted;
  float EdgeSquared = 0; // of the edge to the first neighbor of Predicted

  /** Finds the place that the first rule for a record predicts. */
  void Predict(const CellRecord& record)
  {
    this->Predicted =
      PredictPlace(record, [&](Vertex v) -> const LatticePoint& { return this->Mesh.GetPlace(v); });
    this->EdgeSquared = this->GetDistance(record.Known[CellRecord::N1]);
  }

private:
  /** Goes around, without a division. */
  std::uint32_t Wrap(std::uint32_t corner) const
  {
    const auto degree = this->GetDegree();
    return corner < degree ? corner : corner - degree;
  }

  Vec3 GetPlace(Vertex vertex) const { return ToVector(this->Mesh.GetPlace(vertex)); }

  static Vec3 Normalize(const Vec3& d)
  {
    const float length = std::sqrt(Dot(d, d));
    return length > 0 ? Vec3{ d.Lanes / Splat(length) } : Vec3{};
  }

  /** The vertex beyond a corner in the polygon behind the glued side before it, or after it. */
  Vertex FindPast(std::uint32_t corner, bool sideBefore) const
  {
    const auto side = sideBefore ? (corner > 0 ? corner - 1 : this->GetDegree() - 1) : corner;
    const auto edge = this->Glued[side];
    return edge == SurfaceFront::None ? NoVertex
      : sideBefore                    ? this->Open.Get(edge).PastEnd
                                      : this->Open.Get(edge).PastBegin;
  }

  /** Squared, to the predicted place. */
  float GetDistance(Vertex vertex) const
  {
    const auto d = this->GetPlace(vertex) - ToVector(this->Predicted);
    return Dot(d, d);
  }

  /** Finds open edges along sides of the polygon that were not followed. */
  void FindGlued()
  {
    const auto degree = this->GetDegree();
    for (std::uint32_t i = 0; i < degree; ++i)
    {
      const auto begin = this->Corners[i];
      const auto end = this->GetCorner(i + 1);
      if (this->Glued[i] == SurfaceFront::None && std::max(begin, end) < this->FirstNew)
      {
        this->Glued[i] = this->Open.Find(begin, SurfaceFront::None,
          [&](const SurfaceFront::Edge& edge) { return edge.End == end; });
      }
    }
  }

  /** Links the edges that meet at the corner between two sides. */
  void LinkCorner(std::uint32_t side, std::uint32_t next, std::uint32_t firstEdge)
  {
    const auto a = this->Sides[side]; // begins at the corner
    const auto b = this->Sides[next]; // ends there
    const auto gluedSide = this->Glued[side];
    const auto gluedNext = this->Glued[next];
    if (a == SurfaceFront::None && b == SurfaceFront::None)
    {
      const auto after = this->Open.Get(gluedSide).After;
      if (after != gluedNext)
      {
        this->Open.Link(this->CheckLink(this->Open.Get(gluedNext).Before), this->CheckLink(after));
      }
      return;
    }
    if (a == SurfaceFront::None)
    {
      this->Open.Link(b, this->CheckLink(this->Open.Get(gluedSide).After));
      return;
    }
    if (b == SurfaceFront::None)
    {
      this->Open.Link(this->CheckLink(this->Open.Get(gluedNext).Before), a);
      return;
    }
    // Where the front was already, it is divided.
    const auto found = this->Corners[next] < this->FirstNew
      ? this->Open.Find(
          this->Corners[next], firstEdge, [](const SurfaceFront::Edge&) { return true; })
      : SurfaceFront::None;
    if (found == SurfaceFront::None)
    {
      this->Open.Link(b, a);
      return;
    }
    const auto before = this->CheckLink(this->Open.Get(found).Before);
    this->Open.Link(b, found);
    this->Open.Link(before, a);
  }

  std::uint32_t CheckLink(std::uint32_t link) const
  {
    return link == SurfaceFront::Border || this->Open.IsOpen(link) ? link : SurfaceFront::None;
  }

  /** The normal of the polygon. */
  Vec3 GetNormal() const
  {
    const auto first = this->GetPlace(this->Corners[0]);
    Vec3 sum{};
    auto last = this->GetPlace(this->Corners[1]) - first;
    for (std::size_t i = 2; i < this->Corners.size(); ++i)
    {
      const auto next = this->GetPlace(this->Corners[i]) - first;
      sum.Lanes += Cross(last, next).Lanes;
      last = next;
    }
    return Normalize(sum);
  }

  SurfaceFront& Open;
  Builder& Mesh;
  PlaceGrid Grid;
  std::vector<Vertex> Corners;                // around the polygon, from the gate on
  std::vector<std::uint32_t> Glued;           // for each side, the edge of the front
  std::vector<std::uint32_t> Sides;           // for each side, the edge that was opened
  std::vector<std::uint32_t> Stamps;          // for each vertex, the last cell that has it
  std::vector<std::uint32_t> CandidateStamps; // for each vertex, the last list that has it
  std::array<std::vector<Candidate>, 2> Candidates;
  std::uint32_t CandidateStamp = 0;
  std::uint32_t Stamp = 0;
  Vertex FirstNew = 0;
  const Vertex FirstOwn; // the vertices before were met before the walk
};
}

#endif
