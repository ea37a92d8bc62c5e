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

/** The weight of the estimated curvature of the fields beside the change of the current fields,
 * where the mesh is as it was. Where it is coarser, its gradients are those of fewer tetrahedra,
 * while the curvature is still that of the original mesh. The weight thus grows with the power 3/4
 * of the ratio of the volumes of the tetrahedra, up to a limit: beyond it, thin parts melt away, as
 * their shape counts too little. */
constexpr double FirstBendWeight = 2;
constexpr double LargestBendWeight = 10;

/** What is inside the mesh and was not, or the other way round, counts like a field that is wrong
 * by this part of its range, squared. With less, thin parts melt away. */
constexpr double ShapeWeight = 0.7;

constexpr double Never = std::numeric_limits<double>::infinity();

/** The rounding errors of a bound, relative to the sum of the absolute values of its terms. */
constexpr double BoundMargin = 1e-10;

/** By how much the slope of a field along an edge changes from one end to the other, times its
 * length: its second derivative times the square of the length. */
template <typename Sample>
double GetBend(const Sample& a, const Sample& b, const glm::dvec3& edge)
{
  return glm::dot(edge, a.Gradient - b.Gradient);
}
}

//------------------------------------------------------------------------------
void MergeStar::Quadric::Add(double weight, const Vec& slope)
{
  const Vec weighted = weight * slope;
  this->Weight += weight;
  this->Linear += weighted;
  this->Squares += weighted * slope;
  this->Products += weighted * Vec(slope.y, slope.z, slope.x);
}

double MergeStar::Quadric::GetBound(double error, const Vec& offset) const
{
  const double constant = this->Weight * error * error;
  const double square = glm::dot(this->Squares, offset * offset) +
    2 * glm::dot(this->Products, offset * Vec(offset.y, offset.z, offset.x));
  return constant - 2 * error * glm::dot(this->Linear, offset) + square -
    BoundMargin * (constant + std::abs(square));
}

//------------------------------------------------------------------------------
template <std::size_t N>
MergeCosts<N>::MergeCosts(MergeMesh& mesh, const MergeInput& input, const MergeSettings& settings)
  : Mesh(mesh)
  , Input(input)
  , Settings(settings)
  , Fields(input.Fields.size())
{
  this->SetScales();
  this->FindSamples();
}

//------------------------------------------------------------------------------
template <std::size_t N>
void MergeCosts<N>::SetScales()
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
template <std::size_t N>
void MergeCosts<N>::FindSamples()
{
  const std::size_t each = 1 + this->GetFields();
  const std::size_t points = this->Input.Points.size();
  this->Samples.resize(points * each);
  for (std::size_t point = 0; point < points; ++point)
  {
    this->Samples[point * each].Gradient = ToVector(this->Input.Points[point]);
    for (std::size_t f = 0; f < this->GetFields(); ++f)
    {
      this->Samples[point * each + 1 + f].Value =
        this->Scales[f] * this->Input.Fields[f].Values[point];
    }
  }
  double whole = 0;
  std::size_t tets = 0;
  for (std::uint32_t tet = 0; tet < this->Mesh.GetNumberOfTets(); ++tet)
  {
    const auto& corners = this->Mesh.GetTet(tet);
    if (corners[0] == MergeMesh::None)
    {
      continue;
    }
    const Vec& origin = this->GetPoint(corners[0]);
    const double volume = GetDeterminant(this->GetPoint(corners[1]) - origin,
      this->GetPoint(corners[2]) - origin, this->GetPoint(corners[3]) - origin);
    if (std::isfinite(volume))
    {
      whole += std::abs(volume) / 6;
      ++tets;
      this->AddSlopes(corners, volume);
    }
  }
  for (std::size_t point = 0; point < points; ++point)
  {
    const double volume = this->Samples[point * each].Value;
    for (std::size_t f = 0; f < this->GetFields(); ++f)
    {
      this->Samples[point * each + 1 + f].Gradient *= volume > 0 ? 1 / volume : 0;
    }
  }
  this->PerWhole = whole > 0 ? 1 / whole : 0;
  this->MeanWeight = tets > 0 ? 1 / static_cast<double>(tets) : 0;
}

//------------------------------------------------------------------------------
/** Adds the gradients in a tetrahedron to those of its corners, weighted by six times its volume.
 */
template <std::size_t N>
void MergeCosts<N>::AddSlopes(const MergeMesh::Tet& corners, double volume)
{
  const Vec& origin = this->GetPoint(corners[0]);
  const Vec a = this->GetPoint(corners[1]) - origin;
  const Vec b = this->GetPoint(corners[2]) - origin;
  const Vec c = this->GetPoint(corners[3]) - origin;
  const std::size_t each = 1 + this->GetFields();
  for (const auto corner : corners)
  {
    this->Samples[corner * each].Value += std::abs(volume);
  }
  for (std::size_t f = 1; f < each; ++f)
  {
    const auto at = [&](std::size_t i) -> Sample& { return this->Samples[corners[i] * each + f]; };
    const double value = at(0).Value;
    const Vec sum = (at(1).Value - value) * glm::cross(b, c) +
      (at(2).Value - value) * glm::cross(c, a) + (at(3).Value - value) * glm::cross(a, b);
    // What is not a number is not to reach further than to its neighbors.
    for (std::size_t i = 0; i < 4 && std::isfinite(glm::dot(sum, sum)); ++i)
    {
      at(i).Gradient += volume < 0 ? -sum : sum;
    }
  }
}

//------------------------------------------------------------------------------
template <std::size_t N>
inline auto MergeCosts<N>::GetPoint(std::uint32_t point) const -> const Vec&
{
  return this->Samples[point * (1 + this->GetFields())].Gradient;
}

template <std::size_t N>
inline auto MergeCosts<N>::GetSamples(std::uint32_t point) const -> const Sample*
{
  return this->Samples.data() + point * (1 + this->GetFields()) + 1;
}

//------------------------------------------------------------------------------
/** As a part of the mesh, of six times a volume. */
template <std::size_t N>
double MergeCosts<N>::GetWeight(double volume) const
{
  return this->Settings.Metric == MergeMetric::Mass ? volume / 6 * this->PerWhole
                                                    : this->MeanWeight;
}

//------------------------------------------------------------------------------
template <std::size_t N>
std::uint32_t MergeCosts<N>::GetPlace(std::uint32_t neighbor)
{
  std::uint32_t& next = this->Places[neighbor];
  if (next == 0)
  {
    this->Neighbors.push_back({ neighbor, 0, false, {} });
    next = static_cast<std::uint32_t>(this->Neighbors.size());
  }
  return next - 1;
}

//------------------------------------------------------------------------------
template <std::size_t N>
void MergeCosts<N>::Gather(std::uint32_t point)
{
  this->Places.Clear();
  this->Neighbors.clear();
  const auto ring = this->Mesh.GetRing(point);
  this->Tets.resize(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const auto& corners = this->Mesh.GetTet(ring[i]);
    const auto& others = Others[corners[0] == point ? 0
        : corners[1] == point                       ? 1
        : corners[2] == point                       ? 2
                                                    : 3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint32_t place = this->GetPlace(corners[others[k]]);
      this->Tets[i].Corners[k] = place;
      ++this->Neighbors[place].Tets;
    }
  }
  const Vec& here = this->GetPoint(point);
  for (Neighbor& neighbor : this->Neighbors)
  {
    neighbor.Offset = this->GetPoint(neighbor.Point) - here;
  }
  this->GatherFields(point);
  this->GatherFaces(point);
}

//------------------------------------------------------------------------------
template <std::size_t N>
void MergeCosts<N>::GatherFields(std::uint32_t point)
{
  const std::size_t fields = this->GetFields();
  const Sample* const here = this->GetSamples(point);
  this->Around.resize(this->Neighbors.size() * fields);
  for (std::size_t place = 0; place < this->Neighbors.size(); ++place)
  {
    const Sample* const sample = this->GetSamples(this->Neighbors[place].Point);
    for (std::size_t f = 0; f < fields; ++f)
    {
      this->Around[place * fields + f] = { sample[f].Value - here[f].Value, sample[f].Gradient };
    }
  }
  this->HasBends = false;
  double volumes = 0;
  this->Slopes.resize(this->Tets.size() * fields);
  this->Quadrics.assign(fields, {});
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
    volumes += tet.Volume;
    for (std::size_t f = 0; f < fields; ++f)
    {
      const Vec slope = this->Around[c[0] * fields + f].Value * across[0] +
        this->Around[c[1] * fields + f].Value * across[1] +
        this->Around[c[2] * fields + f].Value * across[2];
      this->Slopes[i * fields + f] = tet.Volume > 0 ? slope / volume : Vec(0);
      this->Quadrics[f].Add(
        tet.Volume > 0 ? tet.Weight : 0, this->Slopes[i * fields + f] - here[f].Gradient);
    }
  }
  const double before = here[-1].Value;
  const double coarser = volumes > before && before > 0 ? volumes / before : 1;
  this->BendWeight =
    std::min(FirstBendWeight * std::sqrt(coarser * std::sqrt(coarser)), LargestBendWeight);
}

//------------------------------------------------------------------------------
/** Not before they are needed, as most points have a merge that changes the fields less than others
 * do without their bends. */
template <std::size_t N>
void MergeCosts<N>::GatherBends(std::uint32_t point)
{
  if (this->HasBends)
  {
    return;
  }
  this->HasBends = true;
  const std::size_t fields = this->GetFields();
  const Sample* const here = this->GetSamples(point);
  this->Spokes.resize(this->Around.size());
  for (std::size_t place = 0; place < this->Neighbors.size(); ++place)
  {
    for (std::size_t f = 0; f < fields; ++f)
    {
      this->Spokes[place * fields + f] =
        GetBend(this->Around[place * fields + f], here[f], this->Neighbors[place].Offset);
    }
  }
  this->Bends.resize(this->Tets.size() * fields);
  this->BendBefore = 0;
  for (std::size_t i = 0; i < this->Tets.size(); ++i)
  {
    const StarTet& tet = this->Tets[i];
    const auto& c = tet.Corners;
    const Vec& p0 = this->Neighbors[c[0]].Offset;
    const Vec& p1 = this->Neighbors[c[1]].Offset;
    const Vec& p2 = this->Neighbors[c[2]].Offset;
    for (std::size_t f = 0; f < fields; ++f)
    {
      const Sample& s0 = this->Around[c[0] * fields + f];
      const Sample& s1 = this->Around[c[1] * fields + f];
      const Sample& s2 = this->Around[c[2] * fields + f];
      const double a = GetBend(s1, s2, p1 - p2);
      const double b = GetBend(s2, s0, p2 - p0);
      const double d = GetBend(s0, s1, p0 - p1);
      this->Bends[i * fields + f] = { { a, b, d }, a + b + d, a * a + b * b + d * d };
      this->BendBefore += tet.Weight * this->GetMeanSquare(tet, i, f);
    }
  }
}

//------------------------------------------------------------------------------
template <std::size_t N>
void MergeCosts<N>::GatherFaces(std::uint32_t point)
{
  this->Faces.clear();
  if (!this->Mesh.IsOnBoundary(point))
  {
    return;
  }
  for (const auto id : this->Mesh.GetRing(point))
  {
    const unsigned bits = this->Mesh.GetBoundaryFaces(id);
    if (bits == 0)
    {
      continue;
    }
    const auto& tet = this->Mesh.GetTet(id);
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
          (isFirst ? face.First : face.Second) = this->Places.Get(corner) - 1;
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
/** Lower bounds of the costs of all merges: what they change of the fields as the tetrahedra are
 * now, which is nearly exact. */
template <std::size_t N>
void MergeCosts<N>::FindBounds(std::uint32_t point)
{
  const bool onBoundary = this->Mesh.IsOnBoundary(point);
  const double weight = this->GetFieldWeight(onBoundary);
  const Sample* const here = this->GetSamples(point);
  this->Bounds.resize(this->Neighbors.size());
  for (std::uint32_t place = 0; place < this->Neighbors.size(); ++place)
  {
    const Neighbor& into = this->Neighbors[place];
    this->Bounds[place] = onBoundary && !into.OnBoundary
      ? Never
      : (weight * this->GetLeastFieldChange(here, place) + this->GetLengthCost(into)) /
        static_cast<double>(into.Tets);
  }
}

//------------------------------------------------------------------------------
template <std::size_t N>
double MergeCosts<N>::GetLeastFieldChange(const Sample* here, std::uint32_t place) const
{
  const Vec& offset = this->Neighbors[place].Offset;
  double change = 0;
  for (std::size_t f = 0; f < this->GetFields(); ++f)
  {
    const double error =
      this->Around[place * this->GetFields() + f].Value - glm::dot(here[f].Gradient, offset);
    change += this->Quadrics[f].GetBound(error, offset);
  }
  return change < 0 ? 0 : change;
}

//------------------------------------------------------------------------------
/** Returns the neighbor of the lowest bound that has not been taken yet, or None. */
template <std::size_t N>
std::uint32_t MergeCosts<N>::TakeCandidate(double mostCost)
{
  std::uint32_t best = MergeMesh::None;
  double least = mostCost;
  for (std::uint32_t place = 0; place < this->Bounds.size(); ++place)
  {
    if (this->Bounds[place] <= least && this->Bounds[place] < Never)
    {
      best = place;
      least = this->Bounds[place];
    }
  }
  if (best != MergeMesh::None)
  {
    this->Bounds[best] = Never;
  }
  return best;
}

//------------------------------------------------------------------------------
/** The change of the fields, as the tetrahedra are now: of each that stays, the deviation of the
 * value of the new corner from the extrapolated field. Negative if one would turn over; anything
 * above enough if the change is. */
template <std::size_t N>
double MergeCosts<N>::GetFieldChange(std::uint32_t place, double enough) const
{
  const std::size_t fields = this->GetFields();
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
    if (WouldInvert(tet, glm::dot(tet.Normal, offset) + tet.Volume))
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
/** Whether a volume is turned over, flatter than rounding, or much flatter than it was. */
template <std::size_t N>
bool MergeCosts<N>::WouldInvert(const StarTet& tet, double volume)
{
  if (volume > 1e-3 * tet.Volume && tet.Volume > 0)
  {
    return false;
  }
  const double area = glm::length(tet.Normal);
  const double size = area * std::sqrt(area);
  double least = std::min(1e-3 * tet.Volume, 1e-9 * size);
  if (!(least > 0))
  {
    least = 1e-12 * size;
  }
  return !(volume > least);
}

//------------------------------------------------------------------------------
/**
 * The mean square of the error of linear interpolation in a tetrahedron, of a field of constant
 * second derivatives, by its bends along the edges: the error is half the sum of bend times both
 * weights over all edges.
 */
template <std::size_t N>
double MergeCosts<N>::GetMeanSquare(const StarTet& tet, std::size_t index, std::size_t field) const
{
  const double a = this->Spokes[tet.Corners[0] * this->GetFields() + field];
  const double b = this->Spokes[tet.Corners[1] * this->GetFields() + field];
  const double c = this->Spokes[tet.Corners[2] * this->GetFields() + field];
  const OppositeBends& opposite = this->Bends[index * this->GetFields() + field];
  const auto& edges = opposite.Edges;
  const double sum = a + b + c + opposite.Sum;
  return (sum * sum + a * (a - edges[0]) + b * (b - edges[1]) + c * (c - edges[2]) +
           opposite.Squares) /
    1680;
}

//------------------------------------------------------------------------------
/** How much worse the new tetrahedra are, by their size and shape, at interpolating fields that
 * bend like those of the whole mesh; 0 if they are better. */
template <std::size_t N>
double MergeCosts<N>::GetBendChange(std::uint32_t place, double enough)
{
  const std::size_t fields = this->GetFields();
  const Neighbor& into = this->Neighbors[place];
  for (std::size_t other = 0; other < this->Neighbors.size(); ++other)
  {
    const Vec edge = this->Neighbors[other].Offset - into.Offset;
    for (std::size_t f = 0; f < fields; ++f)
    {
      this->Spokes[other * fields + f] =
        GetBend(this->Around[other * fields + f], this->Around[place * fields + f], edge);
    }
  }
  double change = -this->BendBefore;
  for (std::size_t i = 0; i < this->Tets.size() && !(this->BendWeight * change > enough); ++i)
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
      change += weight * this->GetMeanSquare(tet, i, f);
    }
  }
  // Not std::max, which would hide what is not a number.
  return change < 0 ? 0 : this->BendWeight * change;
}

//------------------------------------------------------------------------------
/** The volume between the boundary as it is and as it would be. Negative if a face would turn over.
 */
template <std::size_t N>
double MergeCosts<N>::GetShapeChange(std::uint32_t place) const
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
/** Twice, so that halves of both are as much as one of them. */
template <std::size_t N>
double MergeCosts<N>::GetFieldWeight(bool onBoundary) const
{
  return onBoundary ? 2 * (1 - this->Settings.BoundaryWeight) : 1;
}

/** Where all is alike, short edges first. */
template <std::size_t N>
double MergeCosts<N>::GetLengthCost(const Neighbor& into) const
{
  const double length = glm::length(into.Offset);
  return 1e-12 * length * length * length * this->PerWhole;
}

//------------------------------------------------------------------------------
/** Takes the merge into a neighbor if it is better than the best so far. */
template <std::size_t N>
void MergeCosts<N>::Try(
  std::uint32_t point, std::uint32_t place, bool checkTopology, MergeChoice& best)
{
  const Neighbor& into = this->Neighbors[place];
  const bool onBoundary = this->Mesh.IsOnBoundary(point);
  const double fieldWeight = this->GetFieldWeight(onBoundary);
  double others = this->GetLengthCost(into);
  if (onBoundary)
  {
    const double shape = this->GetShapeChange(place);
    if (!(shape >= 0))
    {
      return;
    }
    others += 2 * this->Settings.BoundaryWeight * shape;
  }
  const double tets = static_cast<double>(into.Tets);
  const double enough = best.Into == MergeMesh::None
    ? Never
    : (best.Cost * tets * (1 + BoundMargin) - others) / std::max(fieldWeight, 1e-300);
  const double now = this->GetFieldChange(place, enough);
  if (!(now >= 0 && now <= enough))
  {
    return;
  }
  this->GatherBends(point);
  const double later = this->GetBendChange(place, enough - now);
  const double change = fieldWeight * (now + later) + others;
  const double cost = change / tets;
  const bool isBetter = best.Into == MergeMesh::None || cost < best.Cost ||
    (cost == best.Cost && into.Point < best.Into);
  if (isBetter && std::isfinite(cost) && (!checkTopology || this->Mesh.MayMerge(point, into.Point)))
  {
    best = { into.Point, cost, change };
  }
}

//------------------------------------------------------------------------------
template <std::size_t N>
MergeChoice MergeCosts<N>::Choose(std::uint32_t point, std::uint32_t tryFirst, bool checkTopology)
{
  this->Gather(point);
  this->FindBounds(point);
  MergeChoice best;
  // The first guess is often right, and then few others are looked at.
  const std::uint32_t next = this->Places.Get(tryFirst);
  if (next != 0 && this->Bounds[next - 1] < Never)
  {
    this->Bounds[next - 1] = Never;
    this->Try(point, next - 1, checkTopology, best);
  }
  for (;;)
  {
    const auto place = this->TakeCandidate(best.Into == MergeMesh::None ? Never : best.Cost);
    if (place == MergeMesh::None)
    {
      return best;
    }
    this->Try(point, place, checkTopology, best);
  }
}

template class MergeCosts<0>;
template class MergeCosts<1>;
}
