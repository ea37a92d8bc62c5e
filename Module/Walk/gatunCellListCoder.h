// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellListCoder_h
#define gatunCellListCoder_h

// Cells that no walk takes, one by one, of any type and in any state.

#include "gatunAttachedNodes.h"
#include "gatunCellBuilder.h"
#include "gatunCellGraph.h"
#include "gatunCellShapes.h"
#include "gatunFillRecord.h"
#include "gatunNumberModel.h"
#include "gatunRecentVertices.h"
#include "gatunSharedSequence.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Codes cells by their type, number of corners and corners. A corner is the chunk's next own
 * vertex, a shared vertex that is new, continues the row of the cell before, was used recently, or
 * is named by its number. Encoder and decoder use the same code.
 */
template <typename Coder, typename Side>
class CellListCoder
{
public:
  CellListCoder(Coder& coder, CellBuilder<Side>& mesh, AttachedNodes<Coder, Side>& nodes)
    : Symbols(coder)
    , Mesh(mesh)
    , Types(256)
    , Nodes(nodes)
  {
    for (unsigned type = 0; type < 256; ++type)
    {
      this->Follower[type] = static_cast<std::uint8_t>(type);
    }
  }

  /** Codes one cell. number: the encoder's, in its input. */
  void Code(std::uint32_t number)
  {
    Cell actual;
    if constexpr (Coder::Encoding)
    {
      const auto& input = this->Mesh.Actual.Input;
      actual = { input.Types[number], input.GetCorners(number), input.GetFaces(number) };
      this->Mesh.Actual.CellOrder.push_back(number);
    }
    const auto type = this->CodeType(actual.Type);
    auto& models = this->GetModels(type);
    const auto firstNew = this->Mesh.GetVertices();
    this->Corners.clear();
    this->Faces.clear();
    if (type == PolyhedronType)
    {
      this->CodePolyhedron(models, actual);
      this->LogFaceEdges(firstNew);
    }
    else
    {
      this->CodeCorners(models, type, actual.Corners);
      this->LogEdges(*models.Graph, firstNew);
    }
    this->Mesh.AddCell(type, this->Corners, this->Faces, this->FindParent());
    this->Remember(models);
  }

private:
  static constexpr unsigned MostPositions = 16; // of corners that have models of their own

  /** How a corner is named. */
  enum Way : std::uint8_t
  {
    Own,
    Shared,
    Row,
    Recent,
    Index,
    Ways
  };

  /** A cell of the encoder's input. */
  struct Cell
  {
    std::uint8_t Type = 0;
    std::span<const std::uint32_t> Corners;
    std::span<const std::uint32_t> Faces;
  };

  struct WayModels
  {
    BitModel IsNew, IsShared, IsRow, IsRecent;
  };

  /** Models of the corners at one position. */
  struct PositionModels
  {
    std::array<WayModels, std::size_t{ Ways } * Ways> Way; // the last one here, and before it
    BitTree<RecentVertices::Bits> Place;
    std::uint8_t Last = Own;
  };

  struct TypeModels
  {
    BitModel SameSize;
    NumberModel Size;
    std::size_t LastSize = 0;
    std::vector<PositionModels> Positions;
    std::unique_ptr<CellGraph> Graph; // of the last size
    std::vector<Vertex> Last;         // the corners of the last cell
    std::vector<std::uint32_t> Steps; // and their differences to those of the cell before it
  };

  struct PolyhedronModels
  {
    BitModel SameFaces;
    NumberModel Faces;
    std::size_t LastFaces = 0;
    std::array<BitModel, 16> SameFaceSize; // by the last size
    NumberModel FaceSize;
    std::size_t LastFaceSize = 0;
    BitModel ListsFaces;
    std::vector<PositionModels> Positions = std::vector<PositionModels>(MostPositions);
  };

  //----------------------------------------------------------------------------
  // Types and sizes

  std::uint8_t CodeType(std::uint8_t type)
  {
    const auto expected = this->Follower[this->LastType];
    unsigned coded = expected;
    if (!this->Symbols.Bit(this->TypeFollows[this->LastType], type == expected))
    {
      coded = this->TypeTree.Code(this->Symbols, type);
    }
    this->Follower[this->LastType] = static_cast<std::uint8_t>(coded);
    this->LastType = static_cast<std::uint8_t>(coded);
    return this->LastType;
  }

  TypeModels& GetModels(std::uint8_t type)
  {
    auto& models = this->Types[type];
    if (!models)
    {
      models = std::make_unique<TypeModels>();
      models->LastSize = GetCellKind(type).Points;
      models->Positions.resize(MostPositions);
    }
    return *models;
  }

  /** Codes a size of at most `most`. */
  std::size_t CodeSize(
    BitModel& same, NumberModel& number, std::size_t& last, std::size_t most, std::size_t size)
  {
    auto coded = last;
    if (!this->Symbols.Bit(same, size == last))
    {
      coded = number.Code(this->Symbols, static_cast<std::uint32_t>(size));
    }
    if (coded > most)
    {
      ThrowCorrupt("the cells of a chunk are larger than its directory entry says");
    }
    last = coded;
    return coded;
  }

  //----------------------------------------------------------------------------
  // Corners

  void CodeCorners(TypeModels& models, std::uint8_t type, std::span<const std::uint32_t> actual)
  {
    const auto size = this->CodeSize(
      models.SameSize, models.Size, models.LastSize, this->Mesh.GetCornersLeft(), actual.size());
    if (!models.Graph || models.Graph->GetCorners() != std::min<std::size_t>(size, MaxGraph))
    {
      models.Graph =
        std::make_unique<CellGraph>(CellGraph::OfType(type, std::min<std::size_t>(size, MaxGraph)));
    }
    const auto& nodes = FindCellNodes(type, size);
    const bool hasNodes = nodes.Corners > 0;
    const std::size_t corners = hasNodes ? nodes.Corners : size;
    unsigned before = Own;
    for (std::size_t i = 0; i < corners; ++i)
    {
      const auto row = i < models.Last.size() ? models.Last[i] + models.Steps[i] : NoVertex;
      const auto corner =
        this->CodeCorner(models.Positions[std::min<std::size_t>(i, MostPositions - 1)], before, row,
          Coder::Encoding ? actual[i] : 0, [&] { return this->MakeRecord(models, i); });
      this->Corners.push_back(corner);
    }
    if (hasNodes)
    {
      this->Nodes.Code(nodes, this->Corners, actual);
    }
  }

  /** row: the vertex that continues the row of the cell before. before: the way of the corner
   * before, then of this one. makeRecord() is called for own vertices. */
  template <typename MakeRecord>
  Vertex CodeCorner(PositionModels& models, unsigned& before, Vertex row, std::uint32_t target,
    MakeRecord&& makeRecord)
  {
    const auto vertices = this->Mesh.GetVertices();
    const bool hasRow = row < vertices;
    const Vertex known = Coder::Encoding ? this->Mesh.Actual.GetMet(target) : NoVertex;
    unsigned place = Coder::Encoding ? this->Uses.Find(known) : 0;
    const bool isNew = known == NoVertex;
    const bool isRow = Coder::Encoding && hasRow && row == known &&
      (place == RecentVertices::Most || models.Last != Recent);

    auto& ways = models.Way[models.Last * Ways + before];
    unsigned way = Index;
    Vertex result = NoVertex;
    if (this->Symbols.Bit(ways.IsNew, isNew))
    {
      const bool shared =
        this->Symbols.Bit(ways.IsShared, Coder::Encoding && this->Mesh.Actual.IsShared(target));
      way = shared ? Shared : Own;
      result = shared ? this->Mesh.MeetShared(target, this->SharedNames.Code(this->Symbols, target))
                      : this->Mesh.MeetOwn(target, makeRecord());
      place = RecentVertices::Most;
    }
    else if (hasRow && this->Symbols.Bit(ways.IsRow, isRow))
    {
      way = Row;
      result = row;
      place = this->Uses.Find(row);
    }
    else if (this->Symbols.Bit(ways.IsRecent, place < RecentVertices::Most))
    {
      way = Recent;
      place = models.Place.Code(this->Symbols, place);
      result = this->Uses.Get(place);
      if (result == NoVertex)
      {
        ThrowCorrupt("a chunk names a vertex that is not there");
      }
    }
    else
    {
      result = CodeIndex(this->Symbols, known, vertices);
      place = this->Uses.Find(result);
    }
    this->Uses.Use(result, place);
    models.Last = static_cast<std::uint8_t>(way);
    before = way;
    return result;
  }

  //----------------------------------------------------------------------------
  // Prediction of own vertices

  CellRecord MakeRecord(const TypeModels& models, std::size_t corner) const
  {
    CellRecord record;
    const auto& last = models.Last;
    if (corner >= MaxGraph)
    {
      record.Known[CellRecord::N1] = this->Corners[corner - 1];
      record.Known[CellRecord::B1] = this->Corners[corner - 2];
      return record;
    }
    FillRecord(record, *models.Graph, corner,
      [&](CellGraph::Local local) { return local < corner ? this->Corners[local] : NoVertex; });
    if (record.IsSeed() && corner > 0)
    {
      record.Known[CellRecord::N1] = this->Corners[corner - 1];
    }
    if (corner < last.size() && record.Known[CellRecord::N2] == NoVertex)
    {
      // As the same corner lies in the cell before.
      if (record.IsSeed())
      {
        record.Known[CellRecord::N1] = last[corner];
      }
      else
      {
        const auto near = static_cast<std::size_t>(
          std::find(this->Corners.begin(), this->Corners.end(), record.Known[CellRecord::N1]) -
          this->Corners.begin());
        record.Known[CellRecord::N2] = last[corner];
        record.Known[CellRecord::D12] = last[near];
      }
    }
    return record;
  }

  //----------------------------------------------------------------------------
  // Polyhedra

  void CodePolyhedron(TypeModels& models, const Cell& actual)
  {
    auto& own = this->Polyhedra;
    std::size_t faces = 0;
    for (std::size_t at = 0; at < actual.Faces.size(); at += 1 + actual.Faces[at])
    {
      ++faces;
    }
    const auto left = this->Mesh.GetFaceValuesLeft();
    faces = this->CodeSize(own.SameFaces, own.Faces, own.LastFaces, left, faces);
    for (std::size_t at = 0; faces > 0; --faces)
    {
      const auto size = this->CodeSize(
        own.SameFaceSize[std::min<std::size_t>(own.LastFaceSize, own.SameFaceSize.size() - 1)],
        own.FaceSize, own.LastFaceSize, left - this->Faces.size(),
        Coder::Encoding ? actual.Faces[at] : 0);
      // The sizes of this and the further faces take a value each.
      if (size + faces > left - this->Faces.size())
      {
        ThrowCorrupt("the faces of a polyhedron are larger than its chunk's directory entry says");
      }
      this->CodeFace(size, Coder::Encoding ? actual.Faces.subspan(at + 1, size) : actual.Faces);
      at += 1 + size;
    }
    this->FindFaceCorners();
    if (!this->Symbols.Bit(own.ListsFaces, Coder::Encoding && this->IsPermuted(actual.Corners)))
    {
      this->Corners.clear();
      this->CodeCorners(models, PolyhedronType, actual.Corners);
    }
  }

  void CodeFace(std::size_t size, std::span<const std::uint32_t> actual)
  {
    const auto begin = this->Faces.size() + 1;
    this->Faces.push_back(static_cast<Vertex>(size));
    unsigned before = Own;
    for (std::size_t i = 0; i < size; ++i)
    {
      const auto corner = this->CodeCorner(
        this->Polyhedra.Positions[std::min<std::size_t>(i, MostPositions - 1)], before, NoVertex,
        Coder::Encoding ? actual[i] : 0, [&] { return this->MakeFaceRecord(begin, i, size); });
      this->Faces.push_back(corner);
    }
  }

  /** begin: of the face's corners in Faces. */
  CellRecord MakeFaceRecord(std::size_t begin, std::size_t corner, std::size_t size) const
  {
    CellRecord record;
    const auto at = [&](std::size_t i) { return this->Faces[begin + i]; };
    if (corner > 0)
    {
      record.Known[CellRecord::N1] = at(corner - 1);
      if (corner == 3 && size == 4)
      {
        record.Known[CellRecord::N2] = at(0);
        record.Known[CellRecord::D12] = at(1);
      }
      else if (corner > 1)
      {
        record.Known[CellRecord::B1] = at(corner - 2);
      }
    }
    else if (begin > 1 && this->Faces.size() > 2)
    {
      record.Known[CellRecord::N1] = this->Faces[begin - 2]; // the last one of the face before
    }
    return record;
  }

  /** Makes the list of points: those of the faces in the order in which they appear. */
  void FindFaceCorners()
  {
    this->Seen.resize(this->Mesh.GetVertices(), 0);
    ++this->Mark;
    for (std::size_t at = 0; at < this->Faces.size(); at += 1 + this->Faces[at])
    {
      for (std::size_t i = at + 1; i <= at + this->Faces[at]; ++i)
      {
        if (this->Seen[this->Faces[i]] != this->Mark)
        {
          this->Seen[this->Faces[i]] = this->Mark;
          this->Corners.push_back(this->Faces[i]);
        }
      }
    }
  }

  /** Encoder: whether a list of points has the same ones as that of FindFaceCorners. */
  bool IsPermuted(std::span<const std::uint32_t> actual)
  {
    if (actual.size() != this->Corners.size())
    {
      return false;
    }
    for (const auto target : actual)
    {
      const Vertex v = this->Mesh.Actual.GetMet(target);
      if (v == NoVertex || this->Seen[v] != this->Mark)
      {
        return false;
      }
      this->Seen[v] = 0; // a point that is listed twice is found out
    }
    return true;
  }

  //----------------------------------------------------------------------------
  // What serves the prediction of arrays

  /** Logs the edges of the last cell with a new end. Others have a cell before, most of them. */
  void LogEdges(const CellGraph& graph, Vertex firstNew)
  {
    for (const auto& edge : graph.GetEdges())
    {
      this->LogEdge(this->Corners[edge[0]], this->Corners[edge[1]], firstNew);
    }
    for (std::size_t i = MaxGraph; i < this->Corners.size(); ++i)
    {
      this->LogEdge(this->Corners[i - 1], this->Corners[i], firstNew);
    }
  }

  void LogFaceEdges(Vertex firstNew)
  {
    for (std::size_t at = 0; at < this->Faces.size(); at += 1 + this->Faces[at])
    {
      const auto face = std::span(this->Faces).subspan(at + 1, this->Faces[at]);
      for (std::size_t i = 0; i < face.size(); ++i)
      {
        // The other face at the edge of a closed surface has it in the other direction.
        const auto next = face[(i + 1) % face.size()];
        if (face[i] < next)
        {
          this->LogEdge(face[i], next, firstNew);
        }
      }
    }
  }

  void LogEdge(Vertex a, Vertex b, Vertex firstNew)
  {
    if (a != b && std::max(a, b) >= firstNew)
    {
      this->Mesh.LogEdge(a, b);
    }
  }

  /** The earlier cell that shares most of the first corners with the last one, the latest of equal
   * ones. */
  std::uint32_t FindParent()
  {
    constexpr std::size_t most = 32;
    std::array<std::uint32_t, most> users{};
    std::size_t count = 0;
    this->LastUser.resize(this->Mesh.GetVertices(), Topology::NoTet);
    for (std::size_t i = 0; i < std::min(most, this->Corners.size()); ++i)
    {
      const auto user = this->LastUser[this->Corners[i]];
      if (user != Topology::NoTet)
      {
        users[count++] = user;
      }
    }
    std::sort(users.begin(), users.begin() + count);
    std::uint32_t parent = Topology::NoTet;
    for (std::size_t i = 0, best = 0, run = 0; i < count; ++i)
    {
      run = i > 0 && users[i] == users[i - 1] ? run + 1 : 1;
      if (run >= best)
      {
        best = run;
        parent = users[i];
      }
    }
    for (const auto v : this->Corners)
    {
      this->LastUser[v] = this->Mesh.GetCells();
    }
    return parent;
  }

  void Remember(TypeModels& models)
  {
    models.Steps.resize(this->Corners.size());
    for (std::size_t i = 0; i < this->Corners.size(); ++i)
    {
      models.Steps[i] = i < models.Last.size() ? this->Corners[i] - models.Last[i] : 0;
    }
    models.Last = this->Corners;
  }

  /** Cells with more corners are rows as to what is behind this number. */
  static constexpr std::size_t MaxGraph = 64;

  Coder& Symbols;
  CellBuilder<Side>& Mesh;

  std::array<BitModel, 256> TypeFollows;
  std::array<std::uint8_t, 256> Follower{}; // the type that came after each one last
  BitTree<8> TypeTree;
  std::uint8_t LastType = 0;
  std::vector<std::unique_ptr<TypeModels>> Types;
  PolyhedronModels Polyhedra;

  RecentVertices Uses;
  SharedSequence SharedNames;
  AttachedNodes<Coder, Side>& Nodes;

  std::vector<Vertex> Corners, Faces; // of the cell that is coded
  std::vector<std::uint32_t> Seen;    // for each vertex, the polyhedron that had it last
  std::uint32_t Mark = 0;
  std::vector<std::uint32_t> LastUser; // for each vertex, the last cell that used it
};
}

#endif
