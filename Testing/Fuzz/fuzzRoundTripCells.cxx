// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A chunk of cells of any type, encoded and decoded: what comes back must be what went in.

#include "fuzzMeshes.h"
#include "gatunCellCodec.h"

#include <cstdlib>

namespace
{
using namespace gatun;

void Require(bool right)
{
  if (!right)
  {
    std::abort();
  }
}

/** Makes a decoded cell's numbers those of the input. */
void RestoreNumbers(CellList& cells, std::span<const std::uint32_t> inputOf)
{
  for (auto& corner : cells.Corners)
  {
    corner = inputOf[corner];
  }
  for (std::size_t at = 0; at < cells.Faces.size(); at += 1 + cells.Faces[at])
  {
    for (std::size_t i = 1; i <= cells.Faces[at]; ++i)
    {
      cells.Faces[at + i] = inputOf[cells.Faces[at + i]];
    }
  }
}

void RequireCells(const CellList& cells, const CellList& input, const EncodedCells& encoded)
{
  for (std::size_t c = 0; c < input.GetNumber(); ++c)
  {
    const auto other = encoded.CellOrder[c];
    const auto corners = cells.GetCorners(c);
    const auto faces = cells.GetFaces(c);
    const auto right = input.GetCorners(other);
    const auto rightFaces = input.GetFaces(other);
    Require(cells.Types[c] == input.Types[other] &&
      std::equal(corners.begin(), corners.end(), right.begin(), right.end()) &&
      std::equal(faces.begin(), faces.end(), rightFaces.begin(), rightFaces.end()));
  }
}

/** Encodes and decodes a chunk. */
void TryCells(const ChunkFrame& frame, const CellList& cells, const ShapeTable& shapes,
  const std::vector<PointKeys>& own, Profile profile)
{
  const auto shared = frame.SharedKeys.size();
  const auto encoded = EncodeCells(frame, cells, shapes, own, true, profile);
  auto decoded =
    DecodeCells(frame, shapes, fuzz::Copy(encoded.Connectivity), fuzz::Copy(encoded.Geometry));
  fuzz::CheckCells(frame, decoded);
  Require(decoded.Keys == encoded.Mesh.Keys && decoded.Cells == encoded.Mesh.Cells &&
    decoded.Walk.EdgeLog == encoded.Mesh.Walk.EdgeLog);
  RestoreCorners(decoded.Cells, fuzz::Copy(encoded.Corners));
  std::vector<std::uint32_t> inputOf;
  for (Vertex v = 0; v < decoded.Keys.size(); ++v)
  {
    const auto source = decoded.Walk.Sources[v];
    const auto point = decoded.Walk.IsShared(v)
      ? source & ~Topology::SharedFlag
      : static_cast<std::uint32_t>(shared) + encoded.OwnOrder[source];
    Require(decoded.Keys[v] == (point < shared ? frame.SharedKeys[point] : own[point - shared]));
    inputOf.push_back(point);
  }
  RestoreNumbers(decoded.Cells, inputOf);
  RequireCells(decoded.Cells, cells, encoded);
}
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Input in(data, size);
  std::uint32_t points = 0;
  const auto cells = fuzz::TakeCells(in, 60, points);
  auto frame = fuzz::TakeFrame(in, 0);
  const auto shared = std::min<std::size_t>(frame.SharedKeys.size(), points);
  frame.Cells = { static_cast<std::uint32_t>(cells.GetNumber()),
    static_cast<std::uint32_t>(cells.Corners.size()),
    static_cast<std::uint32_t>(cells.Faces.size()) };
  frame.OwnPoints = points - static_cast<std::uint32_t>(shared);
  frame.SharedKeys.resize(shared);
  frame.SharedUsers.resize(shared);
  std::vector<PointKeys> own(frame.OwnPoints);
  for (auto& keys : own)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      keys[axis] = fuzz::TakeKey(in, frame.Domains[axis]);
    }
  }

  ShapeTable table;
  table.Add(cells);
  const auto shapes = ShapeTable::Read(fuzz::Copy(table.Write()));
  for (const auto profile : { Profile::Small, Profile::Fast })
  {
    TryCells(frame, cells, shapes, own, profile);
  }
  return 0;
}
