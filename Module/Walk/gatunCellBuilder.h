// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellBuilder_h
#define gatunCellBuilder_h

// The mesh of a chunk of cells while it is encoded or decoded, cell by cell.

#include "gatunCellGeometry.h"
#include "gatunCellList.h"
#include "gatunCellShapes.h"
#include "gatunChunkCodec.h"
#include "gatunEntropy.h"
#include "gatunMeasure.h"
#include "gatunSharedSearch.h"
#include "gatunTopology.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Provides the vertices of the input to an encoder. */
class CellEncoderSide
{
public:
  CellEncoderSide(const CellList& cells, std::uint32_t shared, std::span<const LatticePoint> own)
    : Input(cells)
    , Shared(shared)
    , OwnPlaces(own)
    , Met(shared + own.size(), NoVertex)
  {
  }

  /** The vertex of one of the input, or NoVertex if it has not been met. */
  Vertex GetMet(std::uint32_t target) const { return this->Met[target]; }
  bool IsShared(std::uint32_t target) const { return target < this->Shared; }

  void MeetShared(std::uint32_t target, std::uint32_t) { this->Meet(target); }
  LatticePoint MeetOwn(std::uint32_t target, const CellRecord&)
  {
    this->Meet(target);
    this->OwnOrder.push_back(target - this->Shared);
    return this->OwnPlaces[target - this->Shared];
  }

  const CellList& Input;
  std::vector<std::uint32_t> InputOf;   // the input's vertex of each one that was met
  std::vector<std::uint32_t> OwnOrder;  // own vertex -> own vertex of the input
  std::vector<std::uint32_t> CellOrder; // cell -> cell of the input

private:
  void Meet(std::uint32_t target)
  {
    this->Met[target] = static_cast<Vertex>(this->InputOf.size());
    this->InputOf.push_back(target);
  }

  const std::uint32_t Shared;
  std::span<const LatticePoint> OwnPlaces;
  std::vector<Vertex> Met;
};

/** Decodes the coordinates of the vertices that are met. */
class CellDecoderSide
{
public:
  CellDecoderSide(const ChunkFrame& frame, const Lattice& lattice, EntropyDecoder& geometry,
    const CellRuleTable& rules, ChunkMesh& mesh)
    : Frame(frame)
    , Map(lattice)
    , Geometry(geometry, frame.Domains, CellScheme<EntropyDecoder>(rules))
    , Mesh(mesh)
  {
    const auto vertices = std::size_t{ frame.OwnPoints } + frame.SharedKeys.size();
    this->Geometry.Reserve(vertices);
    mesh.Keys.reserve(vertices);
    mesh.UsedRules.reserve(frame.OwnPoints);
  }

  static Vertex GetMet(std::uint32_t) { return NoVertex; }
  static bool IsShared(std::uint32_t) { return false; }

  void MeetShared(std::uint32_t, std::uint32_t index)
  {
    this->Mesh.Keys.push_back(this->Frame.SharedKeys[index]);
    this->Geometry.Meet(this->Mesh.Keys.back());
  }

  LatticePoint MeetOwn(std::uint32_t, const CellRecord& record)
  {
    std::uint8_t rule = 0;
    const auto keys = this->Geometry.Code(record, this->Mesh.Keys, {}, rule);
    this->Mesh.Keys.push_back(keys);
    this->Geometry.Meet(keys);
    this->Mesh.UsedRules.push_back(rule);
    const auto place = this->Geometry.GetLastPlace(keys);
    return this->Map.Map(place[0], place[1], place[2]);
  }

private:
  const ChunkFrame& Frame;
  const Lattice& Map;
  CellGeometryCoder<EntropyDecoder> Geometry;
  ChunkMesh& Mesh;
};

/**
 * Collects the cells and vertices of a chunk. Side provides the vertices to an encoder and receives
 * them from a decoder; a target is a vertex of the encoder's input, meaningless to a decoder.
 */
template <typename Side>
class CellBuilder
{
public:
  CellBuilder(
    const ChunkFrame& frame, std::span<const LatticePoint> shared, Side& side, ChunkMesh& out)
    : Actual(side)
    , Counts(frame.Cells)
    , OwnVertices(frame.OwnPoints)
    , Shared(shared)
    , Out(out)
    , Search(shared)
  {
    const auto vertices = frame.OwnPoints + shared.size();
    this->Places.reserve(vertices);
    out.Walk.Sources.reserve(vertices);
    out.Walk.CellRecords.reserve(frame.OwnPoints);
    out.Walk.Parents.reserve(this->Counts.Cells);
    out.Cells.Types.reserve(this->Counts.Cells);
    out.Cells.Starts.reserve(std::size_t{ this->Counts.Cells } + 1);
    out.Cells.Corners.reserve(this->Counts.Corners);
    out.Cells.Faces.reserve(this->Counts.FaceValues);
  }

  //----------------------------------------------------------------------------
  // Vertices

  Vertex MeetShared(std::uint32_t target, std::uint32_t index)
  {
    if (index >= this->Shared.size() || this->Search.IsGone(index))
    {
      ThrowCorrupt("a chunk names a shared vertex that is not there or was met before");
    }
    this->Search.Remove(index);
    const auto id = this->GetVertices();
    this->Places.push_back(this->Shared[index]);
    this->Out.Walk.Sources.push_back(Topology::SharedFlag | index);
    this->Actual.MeetShared(target, index);
    return id;
  }

  Vertex MeetOwn(std::uint32_t target, const CellRecord& record)
  {
    const auto own = this->Out.Walk.CellRecords.size();
    if (own >= this->OwnVertices)
    {
      ThrowCorrupt("the cells of a chunk meet more vertices than it has");
    }
    const auto id = this->GetVertices();
    this->Out.Walk.Sources.push_back(static_cast<std::uint32_t>(own));
    this->Out.Walk.CellRecords.push_back(record);
    this->Places.push_back(this->Actual.MeetOwn(target, record));
    return id;
  }

  /** The number of vertices met so far. */
  Vertex GetVertices() const { return static_cast<Vertex>(this->Places.size()); }

  /** The number of vertices of the chunk. */
  std::size_t GetAllVertices() const { return this->OwnVertices + this->Shared.size(); }
  SharedSearch& GetSharedSearch() { return this->Search; }
  const LatticePoint& GetPlace(Vertex v) const { return this->Places[v]; }

  /** Adds a pair to the edge log. */
  void LogEdge(Vertex a, Vertex b) { this->Out.Walk.EdgeLog.push_back({ a, b }); }

  //----------------------------------------------------------------------------
  // Cells

  std::uint32_t GetCells() const
  {
    return static_cast<std::uint32_t>(this->Out.Cells.Types.size());
  }
  bool IsFull() const { return this->GetCells() == this->Counts.Cells; }

  /** The numbers of corners and face values that are left for further cells. */
  std::size_t GetCornersLeft() const
  {
    return this->Counts.Corners - this->Out.Cells.Corners.size();
  }
  std::size_t GetFaceValuesLeft() const
  {
    return this->Counts.FaceValues - this->Out.Cells.Faces.size();
  }

  /** faces: of a polyhedron, otherwise empty. */
  void AddCell(std::uint8_t type, std::span<const Vertex> corners, std::span<const Vertex> faces,
    std::uint32_t parent)
  {
    auto& cells = this->Out.Cells;
    if (this->IsFull() || corners.size() > this->GetCornersLeft() ||
      faces.size() > this->GetFaceValuesLeft())
    {
      ThrowCorrupt("the cells of a chunk are larger than its directory entry says");
    }
    if (type == PolyhedronType && cells.FaceStarts.empty())
    {
      cells.FaceStarts.reserve(std::size_t{ this->Counts.Cells } + 1);
      cells.FaceStarts.assign(cells.Types.size() + 1, 0);
    }
    cells.Types.push_back(type);
    cells.Corners.insert(cells.Corners.end(), corners.begin(), corners.end());
    cells.Starts.push_back(static_cast<std::uint32_t>(cells.Corners.size()));
    cells.Faces.insert(cells.Faces.end(), faces.begin(), faces.end());
    if (!cells.FaceStarts.empty())
    {
      cells.FaceStarts.push_back(static_cast<std::uint32_t>(cells.Faces.size()));
    }
    this->Out.Walk.Parents.push_back(parent);
  }

  void Finish() const
  {
    if (!this->IsFull() || this->GetCornersLeft() > 0 || this->GetFaceValuesLeft() > 0)
    {
      ThrowCorrupt("the cells of a chunk are smaller than its directory entry says");
    }
    if (this->GetVertices() != this->GetAllVertices())
    {
      ThrowCorrupt("the cells of a chunk do not meet all its vertices");
    }
  }

  Side& Actual;

private:
  const CellCounts Counts;
  const std::uint32_t OwnVertices;
  std::span<const LatticePoint> Shared;
  ChunkMesh& Out;
  SharedSearch Search;
  std::vector<LatticePoint> Places;
};
}

#endif
