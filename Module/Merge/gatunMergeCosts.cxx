// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeCosts.h"

#include "gatunVector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gatun
{
namespace
{
/** For a corner the others, so that the volume with it in front has the sign of the tetrahedron. */
constexpr std::array<std::array<unsigned, 3>, 4> Others{ { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 },
  { 0, 2, 1 } } };

/** How much what is estimated of the fields' curvature counts beside what is known to change. */
constexpr double BendWeight = 10;

/** What is inside the mesh and was not, or the other way round, counts like a field that is wrong
 * by this part of its range, squared. With less, thin parts melt away. */
constexpr double ShapeWeight = 0.7;

/**
 * The mean square of the error of linear interpolation in a tetrahedron, of a field of constant
 * second derivatives, by its bends along the edges: the error is half the sum of bend times both
 * weights over all edges. A, b, c are from one corner to the others, bc, ca, ab opposite to them.
 */
double GetMeanSquare(double a, double b, double c, double bc, double ca, double ab)
{
  const double sum = a + b + c + bc + ca + ab;
  return (sum * sum + a * a + b * b + c * c + bc * bc + ca * ca + ab * ab - a * bc - b * ca -
           c * ab) /
    1680;
}
}

//------------------------------------------------------------------------------
MergeCosts::MergeCosts(MergeMesh& mesh, const MergeInput& input, const MergeSettings& settings)
  : Mesh(mesh)
  , Input(input)
  , Settings(settings)
  , Fields(input.Fields.size())
  , Places(input.Points.size())
{
  this->SetScales();
  this->FindSamples();
}

//------------------------------------------------------------------------------
void MergeCosts::SetScales()
{
  double weights = 0;
  for (const auto& field : this->Input.Fields)
  {
    weights += field.Weight;
  }
  for (const auto& field : this->Input.Fields)
  {
    double low = std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::lowest();
    for (const double value : field.Values)
    {
      low = value < low ? value : low;
      high = value > high ? value : high;
    }
    const double range = high - low;
    this->Scales.push_back(
      range > 0 && weights > 0 ? std::sqrt(field.Weight / weights) / range : 0);
  }
}

//------------------------------------------------------------------------------
/** Gradients at points are the means of those in the tetrahedra around. */
void MergeCosts::FindSamples()
{
  this->Samples.resize(this->Input.Points.size() * this->Fields);
  for (std::size_t point = 0; point < this->Input.Points.size(); ++point)
  {
    for (std::size_t f = 0; f < this->Fields; ++f)
    {
      this->Samples[point * this->Fields + f].Value =
        this->Scales[f] * this->Input.Fields[f].Values[point];
    }
  }
  std::vector<double> volumes(this->Input.Points.size(), 0);
  double whole = 0;
  std::size_t tets = 0;
  for (std::uint32_t tet = 0; tet < this->Mesh.GetNumberOfTets(); ++tet)
  {
    const auto& corners = this->Mesh.GetTet(tet);
    if (corners[0] == MergeMesh::None)
    {
      continue;
    }
    const Vec origin = ToVector(this->Input.Points[corners[0]]);
    const Vec a = ToVector(this->Input.Points[corners[1]]) - origin;
    const Vec b = ToVector(this->Input.Points[corners[2]]) - origin;
    const Vec c = ToVector(this->Input.Points[corners[3]]) - origin;
    const double volume = GetDeterminant(a, b, c);
    if (!std::isfinite(volume))
    {
      continue;
    }
    whole += std::abs(volume) / 6;
    ++tets;
    for (const auto corner : corners)
    {
      volumes[corner] += std::abs(volume);
    }
    for (std::size_t f = 0; f < this->Fields; ++f)
    {
      const auto at = [&](std::size_t i)
      { return this->Samples[corners[i] * this->Fields + f].Value; };
      const Vec sum = (at(1) - at(0)) * glm::cross(b, c) + (at(2) - at(0)) * glm::cross(c, a) +
        (at(3) - at(0)) * glm::cross(a, b);
      // What is not a number is not to reach further than to its neighbors.
      for (std::size_t i = 0; i < 4 && std::isfinite(glm::dot(sum, sum)); ++i)
      {
        this->Samples[corners[i] * this->Fields + f].Gradient += volume < 0 ? -sum : sum;
      }
    }
  }
  for (std::size_t i = 0; i < this->Samples.size(); ++i)
  {
    const double volume = volumes[i / this->Fields];
    this->Samples[i].Gradient *= volume > 0 ? 1 / volume : 0;
  }
  this->PerWhole = whole > 0 ? 1 / whole : 0;
  this->MeanWeight = tets > 0 ? 1 / static_cast<double>(tets) : 0;
}

//------------------------------------------------------------------------------
/** As a part of the mesh, of six times a volume. */
double MergeCosts::GetWeight(double volume) const
{
  return this->Settings.Metric == MergeMetric::Mass ? volume / 6 * this->PerWhole
                                                    : this->MeanWeight;
}

//------------------------------------------------------------------------------
std::uint32_t MergeCosts::GetPlace(std::uint32_t neighbor)
{
  Place& place = this->Places[neighbor];
  if (place.Stamp != this->Stamp)
  {
    place = { this->Stamp, static_cast<std::uint32_t>(this->Neighbors.size()) };
    this->Neighbors.push_back({ neighbor, 0, false, {} });
  }
  return place.At;
}

//------------------------------------------------------------------------------
void MergeCosts::Gather(std::uint32_t point)
{
  ++this->Stamp;
  this->Neighbors.clear();
  this->Tets.clear();
  const auto ring = this->Mesh.GetRing(point);
  for (const auto tet : ring)
  {
    const auto& corners = this->Mesh.GetTet(tet);
    const auto at =
      static_cast<std::size_t>(std::find(corners.begin(), corners.end(), point) - corners.begin());
    StarTet& star = this->Tets.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
    {
      star.Corners[k] = this->GetPlace(corners[Others[at][k]]);
      ++this->Neighbors[star.Corners[k]].Tets;
    }
  }
  const Vec here = ToVector(this->Input.Points[point]);
  for (Neighbor& neighbor : this->Neighbors)
  {
    neighbor.Offset = ToVector(this->Input.Points[neighbor.Point]) - here;
  }
  this->GatherFields(point);
  this->GatherFaces(point);
}

//------------------------------------------------------------------------------
void MergeCosts::GatherFields(std::uint32_t point)
{
  const std::size_t fields = this->Fields;
  const Sample* const here = this->Samples.data() + point * fields;
  this->Around.resize(this->Neighbors.size() * fields);
  this->Spokes.resize(this->Around.size());
  for (std::size_t place = 0; place < this->Neighbors.size(); ++place)
  {
    const Neighbor& neighbor = this->Neighbors[place];
    for (std::size_t f = 0; f < fields; ++f)
    {
      Sample& sample = this->Around[place * fields + f];
      sample = this->Samples[neighbor.Point * fields + f];
      sample.Value -= here[f].Value;
      this->Spokes[place * fields + f] = this->GetBend(sample, here[f], neighbor.Offset);
    }
  }
  this->Slopes.resize(this->Tets.size() * fields);
  this->Bends.resize(this->Tets.size() * fields);
  this->BendBefore = 0;
  for (std::size_t i = 0; i < this->Tets.size(); ++i)
  {
    StarTet& tet = this->Tets[i];
    const auto& c = tet.Corners;
    const Vec& p0 = this->Neighbors[c[0]].Offset;
    const Vec& p1 = this->Neighbors[c[1]].Offset;
    const Vec& p2 = this->Neighbors[c[2]].Offset;
    const std::array<Vec, 3> across{ glm::cross(p1, p2), glm::cross(p2, p0), glm::cross(p0, p1) };
    // Six times the volume with the point at x: (p0 - x) . ((p1 - x) x (p2 - x)).
    const Vec normal = across[0] + across[1] + across[2];
    const double volume = glm::dot(p0, across[0]);
    tet.Normal = volume < 0 ? normal : -normal;
    tet.Volume = std::abs(volume);
    tet.Weight = this->GetWeight(tet.Volume);
    // Not flatter than rounding, nor much flatter than it was.
    const double area = glm::length(normal);
    const double size = area * std::sqrt(area);
    tet.LeastVolume = std::min(1e-3 * tet.Volume, 1e-9 * size);
    if (!(tet.LeastVolume > 0))
    {
      tet.LeastVolume = 1e-12 * size;
    }
    for (std::size_t f = 0; f < fields; ++f)
    {
      const Sample& s0 = this->Around[c[0] * fields + f];
      const Sample& s1 = this->Around[c[1] * fields + f];
      const Sample& s2 = this->Around[c[2] * fields + f];
      const Vec slope = s0.Value * across[0] + s1.Value * across[1] + s2.Value * across[2];
      this->Slopes[i * fields + f] = tet.Volume > 0 ? slope / volume : Vec(0);
      auto& bends = this->Bends[i * fields + f];
      bends = { this->GetBend(s1, s2, p1 - p2), this->GetBend(s2, s0, p2 - p0),
        this->GetBend(s0, s1, p0 - p1) };
      this->BendBefore += tet.Weight *
        GetMeanSquare(this->Spokes[c[0] * fields + f], this->Spokes[c[1] * fields + f],
          this->Spokes[c[2] * fields + f], bends[0], bends[1], bends[2]);
    }
  }
}

//------------------------------------------------------------------------------
void MergeCosts::GatherFaces(std::uint32_t point)
{
  this->Faces.clear();
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
          (isFirst ? face.First : face.Second) = this->Places[corner].At;
          isFirst = false;
        }
      }
      Neighbor& first = this->Neighbors[face.First];
      Neighbor& second = this->Neighbors[face.Second];
      face.Normal = glm::cross(first.Offset, second.Offset);
      first.OnBoundary = second.OnBoundary = true;
      this->Faces.push_back(face);
    }
  }
}

//------------------------------------------------------------------------------
/** By how much the slope of a field along an edge changes from one end to the other, times its
 * length: its second derivative times the square of the length. */
double MergeCosts::GetBend(const Sample& a, const Sample& b, const Vec& edge) const
{
  return glm::dot(edge, a.Gradient - b.Gradient);
}

//------------------------------------------------------------------------------
/** What the fields change by, as the tetrahedra are now: of each that stays, how far the value of
 * the new corner is from where its field leads to. Negative if one would turn over; whatever is
 * more than enough, if that is certain before all have been looked at. */
double MergeCosts::GetFieldChange(std::uint32_t place, double enough) const
{
  const std::size_t fields = this->Fields;
  const Vec& offset = this->Neighbors[place].Offset;
  const Sample* const to = this->Around.data() + place * fields;
  double change = 0;
  for (std::size_t i = 0; i < this->Tets.size(); ++i)
  {
    const StarTet& tet = this->Tets[i];
    if (tet.Corners[0] == place || tet.Corners[1] == place || tet.Corners[2] == place)
    {
      continue; // vanishes
    }
    if (!(glm::dot(tet.Normal, offset) + tet.Volume > tet.LeastVolume))
    {
      return -1;
    }
    for (std::size_t f = 0; f < fields; ++f)
    {
      const double error = to[f].Value - glm::dot(this->Slopes[i * fields + f], offset);
      change += tet.Weight * error * error;
    }
    if (change > enough)
    {
      return change;
    }
  }
  return change;
}

//------------------------------------------------------------------------------
/** How much worse the new tetrahedra are, by their size and shape, at interpolating fields that
 * bend like those of the whole mesh; 0 if they are better. */
double MergeCosts::GetBendChange(std::uint32_t place, double enough)
{
  const std::size_t fields = this->Fields;
  const Neighbor& into = this->Neighbors[place];
  for (std::size_t other = 0; other < this->Neighbors.size(); ++other)
  {
    const Vec edge = this->Neighbors[other].Offset - into.Offset;
    for (std::size_t f = 0; f < fields; ++f)
    {
      this->Spokes[other * fields + f] =
        this->GetBend(this->Around[other * fields + f], this->Around[place * fields + f], edge);
    }
  }
  double change = -this->BendBefore;
  for (std::size_t i = 0; i < this->Tets.size() && !(BendWeight * change > enough); ++i)
  {
    const StarTet& tet = this->Tets[i];
    const auto& c = tet.Corners;
    if (c[0] == place || c[1] == place || c[2] == place)
    {
      continue;
    }
    const double weight = this->GetWeight(glm::dot(tet.Normal, into.Offset) + tet.Volume);
    for (std::size_t f = 0; f < fields; ++f)
    {
      const auto& bends = this->Bends[i * fields + f];
      change += weight *
        GetMeanSquare(this->Spokes[c[0] * fields + f], this->Spokes[c[1] * fields + f],
          this->Spokes[c[2] * fields + f], bends[0], bends[1], bends[2]);
    }
  }
  // Not std::max, which would hide what is not a number.
  return change < 0 ? 0 : BendWeight * change;
}

//------------------------------------------------------------------------------
/** The volume between the boundary as it is and as it would be. Negative if a face would turn over.
 */
double MergeCosts::GetShapeChange(std::uint32_t place) const
{
  const Vec& offset = this->Neighbors[place].Offset;
  double volume = 0;
  for (const Face& face : this->Faces)
  {
    if (face.First == place || face.Second == place)
    {
      continue;
    }
    const Vec moved = glm::cross(
      this->Neighbors[face.First].Offset - offset, this->Neighbors[face.Second].Offset - offset);
    if (!(glm::dot(moved, face.Normal) > 1e-3 * glm::length(moved) * glm::length(face.Normal)))
    {
      return -1;
    }
    volume += std::abs(glm::dot(face.Normal, offset)) / 6;
  }
  return ShapeWeight * volume * this->PerWhole;
}

//------------------------------------------------------------------------------
/** Takes the merge into a neighbor if it is better than the best so far. */
void MergeCosts::Try(
  std::uint32_t point, std::uint32_t place, bool checkTopology, MergeChoice& best)
{
  const Neighbor& into = this->Neighbors[place];
  const bool onBoundary = this->Mesh.IsOnBoundary(point);
  if (onBoundary && !into.OnBoundary)
  {
    return;
  }
  // Twice, so that halves of both are as much as one of them.
  const double fieldWeight = onBoundary ? 2 * (1 - this->Settings.BoundaryWeight) : 1;
  const double enough = best.Into == MergeMesh::None
    ? std::numeric_limits<double>::infinity()
    : best.Cost * static_cast<double>(into.Tets) / std::max(fieldWeight, 1e-300);
  const double now = this->GetFieldChange(place, enough);
  if (!(now >= 0 && now <= enough))
  {
    return;
  }
  const double later = this->GetBendChange(place, enough);
  if (!(now + later <= enough))
  {
    return;
  }
  double change = fieldWeight * (now + later);
  if (onBoundary)
  {
    const double shape = this->GetShapeChange(place);
    if (!(shape >= 0))
    {
      return;
    }
    change += 2 * this->Settings.BoundaryWeight * shape;
  }
  // Where all is alike, short edges first.
  const double length = glm::length(into.Offset);
  change += 1e-12 * length * length * length * this->PerWhole;
  const double cost = change / static_cast<double>(into.Tets);
  const bool isBetter = best.Into == MergeMesh::None || cost < best.Cost ||
    (cost == best.Cost && into.Point < best.Into);
  if (isBetter && std::isfinite(cost) && (!checkTopology || this->Mesh.MayMerge(point, into.Point)))
  {
    best = { into.Point, cost, change };
  }
}

//------------------------------------------------------------------------------
MergeChoice MergeCosts::Choose(std::uint32_t point, std::uint32_t tryFirst, bool checkTopology)
{
  this->Gather(point);
  MergeChoice best;
  const bool isThere = tryFirst != MergeMesh::None && this->Places[tryFirst].Stamp == this->Stamp;
  const std::uint32_t first = isThere ? this->Places[tryFirst].At : MergeMesh::None;
  if (isThere)
  {
    this->Try(point, first, checkTopology, best);
  }
  for (std::uint32_t place = 0; place < this->Neighbors.size(); ++place)
  {
    if (place != first)
    {
      this->Try(point, place, checkTopology, best);
    }
  }
  return best;
}
}
