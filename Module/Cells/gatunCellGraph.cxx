// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunCellGraph.h"

#include "gatunCellShapes.h"

#include <algorithm>

namespace gatun
{
namespace
{
using Local = CellGraph::Local;

/** The number of corners of a surface type without its other points, 0 if it has no others. */
std::size_t CountPolygonCorners(int type, std::size_t points)
{
  switch (type)
  {
    case 22: // quadratic triangle
    case 34: // biquadratic triangle
    case 61: // triangles of higher order
    case 69:
    case 76:
      return 3;
    case 23: // quadratic quad
    case 28: // biquadratic quad
    case 30: // quadratic linear quad
    case 62: // quads of higher order
    case 70:
    case 77:
      return 4;
    case 36: // quadratic polygon
      return points / 2;
    default:
      return points;
  }
}
}

//------------------------------------------------------------------------------
CellGraph::CellGraph(std::size_t corners, std::span<const Local> faces)
{
  std::vector<std::pair<Local, Quad>> quads;
  for (std::size_t at = 0; at < faces.size(); at += 1u + faces[at])
  {
    const auto face = faces.subspan(at + 1, faces[at]);
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const auto next = face[(i + 1) % face.size()];
      this->Edges.push_back({ std::min(face[i], next), std::max(face[i], next) });
      if (face.size() == 4)
      {
        quads.push_back({ face[i], { face[(i + 3) % 4], face[(i + 2) % 4], next } });
      }
    }
  }
  this->Finish(corners, std::move(quads));
}

CellGraph CellGraph::OfType(int type, std::size_t points)
{
  const auto kind = GetCellKind(type);
  std::size_t corners = points;
  std::vector<Local> faces;
  if (kind.Shape && kind.Shape->Corners <= points)
  {
    corners = kind.Shape->Corners;
    faces.assign(kind.Shape->Faces.begin(), kind.Shape->Faces.end());
  }
  else if (kind.Dimension == 2 && type != 6 && points > 2)
  {
    corners = std::min(points, CountPolygonCorners(type, points));
    faces.push_back(static_cast<Local>(corners));
    for (std::size_t i = 0; i < corners; ++i)
    {
      // The points of a pixel are in rows.
      const auto corner = type == 8 && i >= 2 && points == 4 ? 5 - i : i;
      faces.push_back(static_cast<Local>(corner));
    }
  }
  else
  {
    corners = 0;
  }
  CellGraph graph(points, faces);
  const auto strip = type == 6 ? std::size_t{ 2 } : std::size_t{ 1 };
  for (std::size_t i = std::max<std::size_t>(corners, 1); i < points; ++i)
  {
    for (std::size_t step = 1; step <= std::min(strip, i); ++step)
    {
      graph.Edges.push_back({ static_cast<Local>(i - step), static_cast<Local>(i) });
    }
  }
  std::vector<std::pair<Local, Quad>> quads;
  for (std::size_t i = 0; i < points; ++i)
  {
    for (const auto& quad : graph.GetQuads(i))
    {
      quads.emplace_back(static_cast<Local>(i), quad);
    }
  }
  graph.Finish(points, std::move(quads));
  return graph;
}

CellGraph::Local CellGraph::FindOpposite(std::size_t corner) const
{
  const auto quads = this->GetQuads(corner);
  const auto neighbors = this->GetNeighbors(corner);
  if (quads.size() != 3 || neighbors.size() != 3)
  {
    return None;
  }
  const auto has = [](std::span<const Local> list, Local local)
  { return std::find(list.begin(), list.end(), local) != list.end(); };
  for (const auto local : this->GetNeighbors(quads[0].Opposite))
  {
    if (!has(neighbors, local) && has(this->GetNeighbors(quads[1].Opposite), local) &&
      has(this->GetNeighbors(quads[2].Opposite), local))
    {
      return local;
    }
  }
  return None;
}

void CellGraph::Finish(std::size_t corners, std::vector<std::pair<Local, Quad>> quads)
{
  std::sort(this->Edges.begin(), this->Edges.end());
  this->Edges.erase(std::unique(this->Edges.begin(), this->Edges.end()), this->Edges.end());
  std::erase_if(this->Edges, [](const auto& edge) { return edge[0] == edge[1]; });

  this->NeighborStarts.assign(corners + 1, 0);
  for (const auto& edge : this->Edges)
  {
    ++this->NeighborStarts[edge[0] + 1u];
    ++this->NeighborStarts[edge[1] + 1u];
  }
  for (std::size_t i = 0; i < corners; ++i)
  {
    this->NeighborStarts[i + 1] += this->NeighborStarts[i];
  }
  this->Neighbors.resize(2 * this->Edges.size());
  auto next = this->NeighborStarts;
  // Smaller neighbors first, then larger ones: both ascend in the sorted edges.
  for (const auto& edge : this->Edges)
  {
    this->Neighbors[next[edge[1]]++] = edge[0];
  }
  for (const auto& edge : this->Edges)
  {
    this->Neighbors[next[edge[0]]++] = edge[1];
  }

  std::stable_sort(
    quads.begin(), quads.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  this->QuadStarts.assign(corners + 1, 0);
  this->Quads.clear();
  for (const auto& [corner, quad] : quads)
  {
    ++this->QuadStarts[corner + 1u];
    this->Quads.push_back(quad);
  }
  for (std::size_t i = 0; i < corners; ++i)
  {
    this->QuadStarts[i + 1] += this->QuadStarts[i];
  }
  this->Opposites.resize(corners);
  for (std::size_t i = 0; i < corners; ++i)
  {
    this->Opposites[i] = this->FindOpposite(i);
  }
}
}
