// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeCosts.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
using Vec = std::array<double, 3>;

Vec Minus(const Vec& a, const Vec& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Vec Cross(const Vec& a, const Vec& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double Dot(const Vec& a, const Vec& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double Length(const Vec& a)
{
  return std::sqrt(Dot(a, a));
}

/** For a corner the others, so that the volume with it in front has the sign of the tetrahedron. */
constexpr std::array<std::array<unsigned, 3>, 4> Others{ { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 },
  { 0, 2, 1 } } };
}

//------------------------------------------------------------------------------
MergeCosts::MergeCosts(MergeMesh& mesh, const MergeInput& input, const MergeSettings& settings)
  : Mesh(mesh)
  , Input(input)
  , Settings(settings)
  , PlaceOf(input.Points.size())
  , Stamps(input.Points.size(), 0)
  , Before(input.Fields.size())
  , After(input.Fields.size())
{
  double whole = 0;
  for (std::uint32_t tet = 0; tet < mesh.GetNumberOfTets(); ++tet)
  {
    const auto& c = mesh.GetTet(tet);
    if (c[0] != MergeMesh::None)
    {
      const auto& p = input.Points;
      const double six = std::abs(
        Dot(Minus(p[c[1]], p[c[0]]), Cross(Minus(p[c[2]], p[c[0]]), Minus(p[c[3]], p[c[0]]))));
      whole += std::isfinite(six) ? six / 6 : 0;
    }
  }
  this->PerWhole = whole > 0 ? 1 / whole : 0;
  double weights = 0;
  for (const auto& field : input.Fields)
  {
    weights += field.Weight;
  }
  for (const auto& field : input.Fields)
  {
    double low = 1e300;
    double high = -1e300;
    for (const double value : field.Values)
    {
      low = value < low ? value : low;
      high = value > high ? value : high;
    }
    const double range = high - low;
    this->Weights.push_back(range > 0 && weights > 0 ? field.Weight / weights / range : 0);
  }
}

//------------------------------------------------------------------------------
std::uint32_t MergeCosts::GetPlace(std::uint32_t neighbour)
{
  if (this->Stamps[neighbour] != this->Stamp)
  {
    this->Stamps[neighbour] = this->Stamp;
    this->PlaceOf[neighbour] = static_cast<std::uint32_t>(this->Neighbours.size());
    this->Neighbours.push_back(neighbour);
  }
  return this->PlaceOf[neighbour];
}

//------------------------------------------------------------------------------
void MergeCosts::Gather(std::uint32_t point)
{
  ++this->Stamp;
  this->Neighbours.clear();
  this->Offsets.clear();
  const auto ring = this->Mesh.GetRing(point);
  const std::size_t count = ring.size();
  Star& star = this->Tets;
  for (auto* const numbers :
    { &star.NormalX, &star.NormalY, &star.NormalZ, &star.Volume, &star.LeastVolume })
  {
    numbers->resize(count);
  }
  star.Corners.resize(count);
  star.Sums.resize(count * this->Input.Fields.size());
  const Vec& here = this->Input.Points[point];
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto& tet = this->Mesh.GetTet(ring[i]);
    const auto at =
      static_cast<std::size_t>(std::find(tet.begin(), tet.end(), point) - tet.begin());
    std::array<Vec, 3> p;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto corner = tet[Others[at][k]];
      star.Corners[i][k] = this->GetPlace(corner);
      p[k] = Minus(this->Input.Points[corner], here);
    }
    for (std::size_t f = 0; f < this->Input.Fields.size(); ++f)
    {
      const auto& values = this->Input.Fields[f].Values;
      star.Sums[f * count + i] =
        values[tet[Others[at][0]]] + values[tet[Others[at][1]]] + values[tet[Others[at][2]]];
    }
    // Six times the volume with the point at x: (p1 - x) . ((p2 - x) x (p3 - x)).
    const Vec normal = Cross(Minus(p[1], p[0]), Minus(p[2], p[0]));
    const double volume = Dot(p[0], normal);
    const double sign = volume < 0 ? -1 : 1;
    star.NormalX[i] = -sign * normal[0];
    star.NormalY[i] = -sign * normal[1];
    star.NormalZ[i] = -sign * normal[2];
    star.Volume[i] = sign * volume;
    // Not flatter than rounding, nor much flatter than it was.
    const double area = Length(normal);
    star.LeastVolume[i] = std::min(1e-3 * star.Volume[i], 1e-9 * area * std::sqrt(area));
    if (!(star.LeastVolume[i] > 0))
    {
      star.LeastVolume[i] = 1e-12 * area * std::sqrt(area);
    }
  }
  for (const auto neighbour : this->Neighbours)
  {
    this->Offsets.push_back(Minus(this->Input.Points[neighbour], here));
  }
  this->GatherFaces(point);
}

//------------------------------------------------------------------------------
void MergeCosts::GatherFaces(std::uint32_t point)
{
  this->Faces.clear();
  this->OnBoundaryEdge.assign(this->Neighbours.size(), 0);
  if (!this->Mesh.IsOnBoundary(point))
  {
    return;
  }
  for (const auto id : this->Mesh.GetRing(point))
  {
    const auto& tet = this->Mesh.GetTet(id);
    const unsigned bits = this->Mesh.GetBoundaryFaces(id);
    for (std::size_t side = 0; side < 4; ++side)
    {
      if (tet[side] == point || (bits >> side & 1) == 0)
      {
        continue;
      }
      Face face{};
      bool isFirst = true;
      for (const auto corner : tet)
      {
        if (corner != point && corner != tet[side])
        {
          (isFirst ? face.First : face.Second) = this->PlaceOf[corner];
          isFirst = false;
        }
      }
      face.Normal = Cross(this->Offsets[face.First], this->Offsets[face.Second]);
      this->OnBoundaryEdge[face.First] = this->OnBoundaryEdge[face.Second] = 1;
      this->Faces.push_back(face);
    }
  }
}

//------------------------------------------------------------------------------
/** Negative if a tetrahedron would turn over. */
double MergeCosts::GetDataCost(std::uint32_t place, const Vec& offset)
{
  const Star& star = this->Tets;
  const std::size_t count = star.Volume.size();
  const std::size_t fields = this->Input.Fields.size();
  const bool byMass = this->Settings.Metric == MergeMetric::Mass;
  const auto to = this->Neighbours[place];
  std::fill(this->After.begin(), this->After.end(), 0.0);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto& corners = star.Corners[i];
    if (corners[0] == place || corners[1] == place || corners[2] == place)
    {
      continue; // vanishes
    }
    const double volume = star.NormalX[i] * offset[0] + star.NormalY[i] * offset[1] +
      star.NormalZ[i] * offset[2] + star.Volume[i];
    if (!(volume > star.LeastVolume[i]))
    {
      return -1;
    }
    for (std::size_t f = 0; f < fields; ++f)
    {
      const double value = star.Sums[f * count + i] + this->Input.Fields[f].Values[to];
      this->After[f] += byMass ? volume * value : value;
    }
  }
  double cost = 0;
  for (std::size_t f = 0; f < fields; ++f)
  {
    cost += this->Weights[f] * std::abs(this->After[f] - this->Before[f]);
  }
  // 24: of the volumes six times, of the values four at once.
  return byMass ? cost * this->PerWhole / 24 : cost / 4;
}

//------------------------------------------------------------------------------
/** Negative if a face would turn over. */
double MergeCosts::GetGeometryCost(std::uint32_t place, const Vec& offset) const
{
  double area = 0;
  for (const Face& face : this->Faces)
  {
    area += Length(face.Normal);
  }
  double change = 0;
  for (const Face& face : this->Faces)
  {
    if (face.First == place || face.Second == place)
    {
      continue;
    }
    const Vec moved =
      Cross(Minus(this->Offsets[face.First], offset), Minus(this->Offsets[face.Second], offset));
    const double length = Length(moved);
    if (!(Dot(moved, face.Normal) > 1e-3 * length * Length(face.Normal)))
    {
      return -1;
    }
    // The new face has an edge in common with the old one, and with those that vanish next to it.
    for (const Face& old : this->Faces)
    {
      const bool vanishes = old.First == place || old.Second == place;
      const bool hasEdge = &old == &face ||
        (vanishes &&
          (old.First == face.First || old.First == face.Second || old.Second == face.First ||
            old.Second == face.Second));
      const double oldLength = Length(old.Normal);
      if (hasEdge && oldLength > 0)
      {
        // Those that vanish may be seen in the other sense of rotation.
        const double sign = Dot(moved, old.Normal) < 0 ? -1 : 1;
        Vec difference;
        for (std::size_t c = 0; c < 3; ++c)
        {
          difference[c] = moved[c] / length - sign * old.Normal[c] / oldLength;
        }
        change += Length(difference) * oldLength / area;
      }
    }
  }
  // As a part of the mesh: what is swept when so much area moves by its own size.
  area /= 2;
  return change * area * std::sqrt(area) * this->PerWhole;
}

//------------------------------------------------------------------------------
MergeChoice MergeCosts::Choose(std::uint32_t point)
{
  this->Gather(point);
  const Star& star = this->Tets;
  const std::size_t count = star.Volume.size();
  const bool byMass = this->Settings.Metric == MergeMetric::Mass;
  for (std::size_t f = 0; f < this->Input.Fields.size(); ++f)
  {
    const double here = this->Input.Fields[f].Values[point];
    this->Before[f] = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double value = star.Sums[f * count + i] + here;
      this->Before[f] += byMass ? star.Volume[i] * value : value;
    }
  }
  this->Choices.clear();
  const bool onBoundary = this->Mesh.IsOnBoundary(point);
  for (std::uint32_t place = 0; place < this->Neighbours.size(); ++place)
  {
    if (onBoundary && !this->OnBoundaryEdge[place])
    {
      continue;
    }
    const Vec& offset = this->Offsets[place];
    double cost = this->GetDataCost(place, offset);
    const double geometry = onBoundary ? this->GetGeometryCost(place, offset) : 0;
    if (!(cost >= 0) || !(geometry >= 0))
    {
      continue;
    }
    if (onBoundary)
    {
      const double weight = this->Settings.BoundaryWeight;
      cost = weight * geometry + (1 - weight) * cost;
    }
    // Where all is alike, short edges first.
    const double length = Length(offset);
    cost += 1e-6 * length * length * length * this->PerWhole;
    this->Choices.push_back({ this->Neighbours[place], cost });
  }
  std::sort(this->Choices.begin(), this->Choices.end(),
    [](const MergeChoice& a, const MergeChoice& b)
    { return a.Cost != b.Cost ? a.Cost < b.Cost : a.Into < b.Into; });
  for (const MergeChoice& choice : this->Choices)
  {
    if (this->Mesh.MayMerge(point, choice.Into))
    {
      return choice;
    }
  }
  return {};
}
}
