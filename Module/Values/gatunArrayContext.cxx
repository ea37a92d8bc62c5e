// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunArrayContext.h"

#include "gatunFloatEnvironment.h"

#include <span>
#include <vector>

namespace gatun
{
//------------------------------------------------------------------------------
PointContext MakePointContext(const ChunkMesh& mesh)
{
  PointContext context;
  context.Mesh = &mesh.Walk;
  context.OwnIds = mesh.OwnIds;
  context.Rules = &mesh.Rules;
  context.CellRules = mesh.CellRules.empty() ? nullptr : &mesh.CellRules;
  context.UsedRules = mesh.UsedRules;
  return context;
}

//------------------------------------------------------------------------------
QuadraticFit FitCells(const ChunkMesh& mesh)
{
  const bool areTets = mesh.Cells.Types.empty();
  std::vector<std::uint32_t> starts, corners;
  for (const auto& tet : mesh.Walk.CopyTets())
  {
    starts.push_back(static_cast<std::uint32_t>(corners.size()));
    corners.insert(corners.end(), tet.begin(), tet.end());
  }
  starts.push_back(static_cast<std::uint32_t>(corners.size()));
  return FitCells(areTets ? std::span<const std::uint32_t>(starts) : mesh.Cells.Starts,
    areTets ? std::span<const std::uint32_t>(corners) : mesh.Cells.Corners, mesh.GetPlaces());
}

//------------------------------------------------------------------------------
ArrayContext::ArrayContext(const ChunkMesh& mesh, ContextFits fits)
  : Points(MakePointContext(mesh))
{
  if (fits == ContextFits::None)
  {
    return;
  }
  const FloatEnvironment guard;
  const auto places = mesh.GetPlaces();
  this->Points.Fit = &this->Fit.emplace(mesh.Walk, places);
  if (fits == ContextFits::All)
  {
    this->Points.Quadratic = &this->Quadratic.emplace(mesh.Walk, places);
  }
}
}
