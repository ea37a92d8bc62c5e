// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceWalk_h
#define gatunSurfaceWalk_h

// The breadth-first walk over polygons that have edges in common. Encoder and decoder use the same
// code. Walks over surfaces from edge to edge: S. Gumhold, W. Strasser, "Real time compression of
// triangle mesh connectivity", SIGGRAPH 1998; M. Isenburg, J. Snoeyink, "Face fixer", SIGGRAPH
// 2000.

#include "gatunAttachedNodes.h"
#include "gatunCellBuilder.h"
#include "gatunCellShapes.h"
#include "gatunEncoderMarks.h"
#include "gatunEncoderSurface.h"
#include "gatunSurfaceCell.h"
#include "gatunSurfaceFront.h"
#include "gatunSurfaceModels.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Attaches a polygon to the oldest open edge, the gate, until there is none. A polygon is coded by
 * its number of corners, by the vertices that it takes from the front on both sides of the gate,
 * and by its other corners. Its type and first corner are coded relative to the polygon behind.
 */
template <typename Coder, typename Side>
class SurfaceWalk
{
public:
  /** uniform: whether all polygons are triangles that are oriented alike. actual: of an encoder,
   * otherwise null. */
  SurfaceWalk(Coder& coder, CellBuilder<Side>& mesh, AttachedNodes<Coder, Side>& nodes,
    bool uniform, EncoderSurface* actual)
    : Symbols(coder)
    , Mesh(mesh)
    , Nodes(nodes)
    , IsUniform(uniform)
    , Actual(actual)
    , Open(mesh.GetAllVertices())
    , Cell(Open, mesh)
  {
  }

  void Run()
  {
    while (!this->Mesh.IsFull())
    {
      const auto gate = this->Open.NextGate();
      if (gate != SurfaceFront::None)
      {
        this->GrowOnGate(gate);
      }
      else if (this->Symbols.Bit(
                 this->Models.MoreSeeds, Coder::Encoding && this->Actual->FindSeed()))
      {
        this->GrowSeed();
      }
      else
      {
        break;
      }
    }
  }

private:
  //----------------------------------------------------------------------------
  // The encoder's input

  bool FindCell(const SurfaceFront::Edge& gate)
  {
    if constexpr (Coder::Encoding)
    {
      const auto& input = this->Mesh.Actual.InputOf;
      return this->Actual->FindCell(input[gate.Begin], input[gate.End], gate.Frame % 2 != 0);
    }
    return false;
  }

  std::uint32_t GetActualDegree() const
  {
    return Coder::Encoding ? static_cast<std::uint32_t>(this->Actual->Corners.size()) : 0;
  }

  /** The input's vertex at a corner. */
  std::uint32_t GetTarget(std::uint32_t corner) const
  {
    return Coder::Encoding ? this->Actual->Corners[corner] : 0;
  }

  Vertex GetKnown(std::uint32_t corner) const
  {
    return Coder::Encoding ? this->Mesh.Actual.GetMet(this->GetTarget(corner)) : NoVertex;
  }

  bool IsShared(std::uint32_t target) const
  {
    return Coder::Encoding && this->Mesh.Actual.IsShared(target);
  }

  //----------------------------------------------------------------------------
  // Steps

  void GrowSeed()
  {
    const GateEnd none;
    this->BeginCell(0, none, none);
    for (std::uint32_t i = 0; i < this->Cell.GetDegree(); ++i)
    {
      this->Cell.SetCorner(i, this->CodeSeedCorner(i));
    }
    this->FinishCell(Topology::NoTet, 0, 0, 0);
  }

  Vertex CodeSeedCorner(std::uint32_t corner)
  {
    const auto known = this->GetKnown(corner);
    if (!this->Symbols.Bit(this->Models.SeedNew, known == NoVertex))
    {
      return CodeIndex(this->Symbols, known, this->Mesh.GetVertices());
    }
    const auto target = this->GetTarget(corner);
    if (this->Symbols.Bit(this->Models.SeedShared, this->IsShared(target)))
    {
      return this->Mesh.MeetShared(
        target, CodeIndex(this->Symbols, target, this->Mesh.GetSharedSearch().GetSize()));
    }
    return this->Mesh.MeetOwn(target, this->Cell.MakeRecord(corner, NoVertex, NoVertex));
  }

  void GrowOnGate(std::uint32_t id)
  {
    const auto gate = this->Open.Get(id);
    const bool border = Coder::Encoding && !this->FindCell(gate);
    auto begin = this->GradeEnd(gate, id, false);
    auto end = this->GradeEnd(gate, id, true);
    const bool isInterface =
      (this->Mesh.GetPlace(gate.Begin).Users & this->Mesh.GetPlace(gate.End).Users) != 0;
    if (this->Symbols.Bit(this->Models.Border(isInterface, gate.Degree, begin, end), border))
    {
      this->Open.CloseAtBorder(id);
      return;
    }
    this->BeginCell(gate.Degree, begin, end);
    this->Cell.SetCorner(0, gate.Begin);
    this->Cell.SetCorner(1, gate.End);
    this->Cell.Glue(0, id);
    this->CodeCorners(begin, end);
    this->FinishCell(gate.Cell, gate.Type, gate.Degree, gate.Frame);
  }

  void BeginCell(std::uint32_t parentDegree, const GateEnd& begin, const GateEnd& end)
  {
    const auto degree = this->IsUniform
      ? 3u
      : this->Models.CodeDegree(this->Symbols, parentDegree, begin, end, this->GetActualDegree());
    if (degree < 3 || degree > MaxWalkedCorners || degree > this->Mesh.GetCornersLeft())
    {
      ThrowCorrupt("a polygon of a chunk has an impossible number of corners");
    }
    this->Cell.Begin(degree);
  }

  /** Grades the end of an edge of the front, or its begin. */
  GateEnd GradeEnd(const SurfaceFront::Edge& gate, std::uint32_t id, bool atEnd) const
  {
    GateEnd end;
    end.Cells = this->Open.GetCells(atEnd ? gate.End : gate.Begin);
    end.Link = atEnd ? this->Open.GetAfter(id) : this->Open.GetBefore(id);
    if (end.Link < SurfaceFront::Border)
    {
      const auto& other = this->Open.Get(end.Link);
      end.Angle = atEnd ? GradeCorner(gate.Along, other.Along, gate.Normal)
                        : GradeCorner(other.Along, gate.Along, gate.Normal);
      end.Degree = other.Degree;
    }
    else if (end.Link == SurfaceFront::Border)
    {
      end.Angle = GateEnd::BorderAngle;
    }
    return end;
  }

  //----------------------------------------------------------------------------
  // Corners

  void CodeCorners(GateEnd& begin, GateEnd& end)
  {
    const auto degree = this->Cell.GetDegree();
    auto low = 1u;      // the corners up to it are known
    auto high = degree; // and those from it on
    while (low + 1 < high && this->CodeNext(low + 1, true, end, begin, low > 1))
    {
      ++low;
    }
    while (low + 1 < high && this->CodeNext(high - 1, false, begin, end, high < degree))
    {
      --high;
    }
    const unsigned ends = (low > 1) + 2 * (high < degree);
    for (auto corner = low + 1; corner < high; ++corner)
    {
      const auto ahead = corner == low + 1 ? this->GetBeyond(end, true) : NoVertex;
      const auto back = corner + 1 == high ? this->GetBeyond(begin, false) : NoVertex;
      this->Cell.SetCorner(corner, this->CodeCorner(corner, ends, ahead, back));
    }
  }

  /** The far vertex of the edge beyond an end, or NoVertex. */
  Vertex GetBeyond(const GateEnd& end, bool atEnd) const
  {
    constexpr unsigned most = 8; // beyond the corner is probably no neighbor of it
    if (end.Angle >= most)
    {
      return NoVertex;
    }
    const auto& edge = this->Open.Get(end.Link);
    const auto vertex = atEnd ? edge.End : edge.Begin;
    return this->Cell.Has(vertex) ? NoVertex : vertex;
  }

  /** Codes whether a corner is the next vertex along the front, and goes there. */
  bool CodeNext(std::uint32_t corner, bool atEnd, GateEnd& ahead, const GateEnd& back, bool further)
  {
    if (ahead.Angle >= GateEnd::NoAngle)
    {
      return false;
    }
    const auto link = ahead.Link;
    const auto& edge = this->Open.Get(link);
    const auto vertex = atEnd ? edge.End : edge.Begin;
    if (this->Cell.Has(vertex) ||
      !this->Symbols.Bit(this->Models.IsNext(this->Cell.GetDegree(), further, ahead, back),
        this->GetKnown(corner) == vertex))
    {
      return false;
    }
    this->Cell.SetCorner(corner, vertex);
    this->Cell.Glue(atEnd ? corner - 1 : corner, link);
    ahead = this->GradeEnd(edge, link, atEnd);
    return true;
  }

  Vertex CodeCorner(std::uint32_t corner, unsigned ends, Vertex ahead, Vertex back)
  {
    const auto record = this->Cell.MakeRecord(corner, ahead, back);
    const auto known = this->GetKnown(corner);
    auto& isNew = this->Models.New(this->Cell.GetDegree(), ends);
    if (!this->Symbols.Bit(isNew, known == NoVertex))
    {
      return this->CodeKnown(record, known);
    }
    const auto target = this->GetTarget(corner);
    const auto count = [&](Vertex a, Vertex b)
    {
      return unsigned{ a != NoVertex && this->Mesh.GetPlace(a).Users != 0 } +
        unsigned{ b != NoVertex && this->Mesh.GetPlace(b).Users != 0 };
    };
    const auto gate = count(this->Cell.GetCorner(0), this->Cell.GetCorner(1));
    if (this->Symbols.Bit(
          this->Models.IsShared[3 * gate + count(ahead, back)], this->IsShared(target)))
    {
      this->Cell.Predict(record);
      return this->Mesh.MeetShared(target,
        this->Models.Shared.Code(this->Symbols, this->Mesh.GetSharedSearch(), this->Cell.Predicted,
          4.0F * this->Cell.EdgeSquared, target));
    }
    return this->Mesh.MeetOwn(target, record);
  }

  Vertex CodeKnown(const CellRecord& record, Vertex known)
  {
    const bool onFront =
      this->Symbols.Bit(this->Models.OnFront, Coder::Encoding && this->Open.IsOnFront(known));
    this->Cell.FindCandidates(record);
    const auto& candidates = this->Cell.SortCandidates(onFront);
    const auto count = static_cast<unsigned>(std::min<std::size_t>(candidates.size(), 15));
    unsigned place = 0;
    while (Coder::Encoding && place < count && candidates[place].Id != known)
    {
      ++place;
    }
    if (!this->Symbols.Bit(this->Models.Listed[onFront], place < count))
    {
      return CodeIndex(this->Symbols, known, this->Mesh.GetVertices());
    }
    for (unsigned i = 0; i < count; ++i)
    {
      auto& model = this->Models.Ranks[onFront * 6 + std::min(i, 5u)];
      if (this->Symbols.Bit(model, i == place))
      {
        return candidates[i].Id;
      }
    }
    ThrowCorrupt("a walk names no vertex of a list");
  }

  //----------------------------------------------------------------------------
  // Types and the order of corners

  void FinishCell(std::uint32_t parent, std::uint8_t parentType, std::uint32_t parentDegree,
    std::uint32_t parentFrame)
  {
    const auto degree = this->Cell.GetDegree();
    SurfaceFront::Edge edge{};
    edge.Before = edge.After = edge.Next = SurfaceFront::None;
    edge.Open = true;
    edge.Cell = this->Mesh.GetCells();
    this->Corners.resize(degree);
    std::uint32_t turn = 0;
    const auto input = this->GetInputCorners();
    if (this->IsUniform)
    {
      edge.Type = TriangleType;
      this->Corners = { this->Cell.GetCorner(0), this->Cell.GetCorner(1), this->Cell.GetCorner(2) };
    }
    else
    {
      edge.Type = this->Models.CodeType(this->Symbols, degree, parentType,
        Coder::Encoding ? this->Actual->Type : std::uint8_t{ 0 });
      turn = this->Models.CodeTurn(this->Symbols, edge.Type, degree,
        parentDegree + 32 * this->Cell.FindLongestSide(), parentFrame,
        Coder::Encoding ? this->Actual->Turn : 0u);
      if (CountMarkCorners(edge.Type, degree) != degree || turn >= 2 * degree)
      {
        ThrowCorrupt("a polygon is a cell of a type that it cannot have");
      }
      for (std::uint32_t i = 0; i < degree; ++i)
      {
        this->Corners[GetMarkCorner(edge.Type, i)] =
          this->Cell.GetCorner(GetMarkPlace(turn, i, degree));
      }
      this->Nodes.CodeOfType(edge.Type, this->Corners, input);
    }
    this->Mesh.AddCell(edge.Type, this->Corners, {}, parent);
    this->Cell.Attach(edge,
      [&](std::uint32_t side)
      {
        const auto start = turn / 2;
        // Below 2 * degree, as start is below degree.
        const auto place = turn % 2 != 0 ? start + degree - side : side + degree - start;
        return 2 * (place < degree ? place : place - degree) + turn % 2;
      });
  }

  /** Encoder: the points of the cell that was begun, which comes next. */
  std::span<const std::uint32_t> GetInputCorners()
  {
    if constexpr (Coder::Encoding)
    {
      this->Mesh.Actual.CellOrder.push_back(this->Actual->Cell);
      return this->Mesh.Actual.Input.GetCorners(this->Actual->Cell);
    }
    return {};
  }

  Coder& Symbols;
  CellBuilder<Side>& Mesh;
  AttachedNodes<Coder, Side>& Nodes;
  const bool IsUniform;
  EncoderSurface* const Actual;
  SurfaceFront Open;
  SurfaceModels Models;
  SurfaceCell<CellBuilder<Side>> Cell;
  std::vector<Vertex> Corners; // of the cell that is finished
};
}

#endif
