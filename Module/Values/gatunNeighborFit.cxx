// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunNeighborFit.h"

#include "gatunTopology.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
/** The neighbors of a vertex relative to it, and their weights before they are normalized. */
struct Offsets
{
  void Resize(std::size_t count)
  {
    if (count > this->X.size())
    {
      for (auto* list : { &this->X, &this->Y, &this->Z, &this->Weight })
      {
        list->resize(2 * count);
      }
    }
  }

  std::vector<double> X, Y, Z, Weight;
};

/** Computes the weights of the neighbors of a vertex. */
void FindWeights(const std::array<double, 3>& center, std::span<NeighborFit::Neighbor> neighbors,
  std::span<const std::array<double, 3>> places, Offsets& offsets)
{
  // Weighted least squares of value = c0 + c . (x - center). The result is c0, a weighted sum of
  // the values. With fewer than four neighbors, c is left out.
  const auto count = neighbors.size();
  offsets.Resize(count);
  double mean = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto& p = places[neighbors[i].Id];
    const double x = p[0] - center[0], y = p[1] - center[1], z = p[2] - center[2];
    offsets.X[i] = x;
    offsets.Y[i] = y;
    offsets.Z[i] = z;
    mean += x * x + y * y + z * z;
  }
  mean = mean / static_cast<double>(count);
  const double scale = 1.0 / std::sqrt(mean);
  if (!std::isfinite(scale))
  {
    for (auto& n : neighbors)
    {
      n.Weight = 1.0 / static_cast<double>(count);
    }
    return;
  }
  // A loop of its own, because it can be vectorized. The sums cannot: their order matters.
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = offsets.X[i] * scale, y = offsets.Y[i] * scale, z = offsets.Z[i] * scale;
    offsets.X[i] = x;
    offsets.Y[i] = y;
    offsets.Z[i] = z;
    offsets.Weight[i] = 1.0 / (x * x + y * y + z * z + 1e-6);
  }
  double m = 0, mx = 0, my = 0, mz = 0;
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = offsets.X[i], y = offsets.Y[i], z = offsets.Z[i], w = offsets.Weight[i];
    const double wx = w * x, wy = w * y, wz = w * z;
    m += w;
    mx += wx;
    my += wy;
    mz += wz;
    xx += wx * x;
    xy += wx * y;
    xz += wx * z;
    yy += wy * y;
    yz += wy * z;
    zz += wz * z;
  }
  double bx = 0, by = 0, bz = 0;
  if (count >= 4)
  {
    const double ridge = 1e-4 * (m + xx + yy + zz);
    xx += ridge;
    yy += ridge;
    zz += ridge;
    // b = inverse of the symmetric matrix times (mx, my, mz), by cofactors
    const double axx = yy * zz - yz * yz;
    const double axy = xz * yz - xy * zz;
    const double axz = xy * yz - xz * yy;
    const double ayy = xx * zz - xz * xz;
    const double ayz = xy * xz - xx * yz;
    const double azz = xx * yy - xy * xy;
    const double inverse = 1.0 / (xx * axx + xy * axy + xz * axz);
    bx = (axx * mx + axy * my + axz * mz) * inverse;
    by = (axy * mx + ayy * my + ayz * mz) * inverse;
    bz = (axz * mx + ayz * my + azz * mz) * inverse;
  }
  const double whole = 1.0 / (m - (bx * mx + by * my + bz * mz));
  for (std::size_t i = 0; i < count; ++i)
  {
    const double inside = bx * offsets.X[i] + by * offsets.Y[i] + bz * offsets.Z[i];
    neighbors[i].Weight = offsets.Weight[i] * whole * (1.0 - inside);
  }
}
}

//------------------------------------------------------------------------------
NeighborFit::NeighborFit(const Topology& topology, std::span<const std::array<double, 3>> places)
  : Start(topology.GetOwnVertices() + 2, 0)
{
  // The later end of an edge knows the earlier one, but shared vertices are known from the start.
  // Edges between two shared vertices are appended to all lists, because branches would cost more.
  const auto none = static_cast<std::uint32_t>(topology.GetOwnVertices());
  const auto eachPair = [&](auto&& pair)
  {
    for (const auto& edge : topology.EdgeLog)
    {
      const Vertex low = std::min(edge[0], edge[1]);
      const Vertex high = std::max(edge[0], edge[1]);
      const bool later = !topology.IsShared(high);
      const auto own = topology.Sources[later ? high : low];
      pair((own & Topology::SharedFlag) != 0 ? none : own, later ? low : high);
    }
  };
  eachPair([&](std::uint32_t own, Vertex) { ++this->Start[own + 1]; });
  for (std::size_t i = 1; i < this->Start.size(); ++i)
  {
    this->Start[i] += this->Start[i - 1];
  }
  this->List.resize(this->Start.back());
  auto next = this->Start;
  eachPair([&](std::uint32_t own, Vertex known) { this->List[next[own]++] = { known, 0 }; });

  Offsets offsets;
  for (Vertex v = 0; v < topology.Sources.size(); ++v)
  {
    if (!topology.IsShared(v))
    {
      const auto own = topology.Sources[v];
      FindWeights(places[v],
        { this->List.data() + this->Start[own], this->Start[own + 1] - this->Start[own] }, places,
        offsets);
    }
  }
}
}
