// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeCosts.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
/** The weight of the estimated curvature of the fields beside the change of the current fields,
 * where the mesh is as it was. Where it is coarser, its gradients are those of fewer tetrahedra,
 * while the curvature is still that of the original mesh. The weight thus grows with the power 3/4
 * of the ratio of the volumes of the tetrahedra, up to a limit: beyond it, thin parts melt away, as
 * their shape counts too little. */
constexpr double FirstBendWeight = 2.5;
constexpr double LargestBendWeight = 12;

/** What is inside the mesh and was not, or the other way round, counts like a field that is wrong
 * by this part of its range, squared, where the boundary is sharp. With less, thin parts melt away.
 */
constexpr double ShapeWeight = 0.7;

/** The sine of the angle between a merged edge and a face from which on the boundary is sharp.
 * Below it, the weight of the shape falls with the square of the sine. */
constexpr double SharpSine = 0.4;

}

//------------------------------------------------------------------------------
template <std::size_t N>
MergeCosts<N>::MergeCosts(
  const MergeMesh& mesh, const MergeFields& fields, const MergeSettings& settings)
  : Settings(settings)
  , Links(mesh)
  , Star(mesh, fields, settings.Metric)
  , Bends(this->Star)
{
}

//------------------------------------------------------------------------------
/** Lower bounds of the costs of all merges: what they change of the fields as the tetrahedra are
 * now, which is nearly exact. */
template <std::size_t N>
void MergeCosts<N>::FindBounds()
{
  const auto& neighbors = this->Star.Neighbors;
  const bool onBoundary = this->Star.Mesh.IsOnBoundary(this->Point);
  this->LengthCosts.resize(neighbors.size());
  this->LeastChanges.resize(neighbors.size());
  this->Bounds.resize(neighbors.size());
  for (std::uint32_t place = 0; place < neighbors.size(); ++place)
  {
    const MergeNeighbor& into = neighbors[place];
    // Where all is alike, short edges first.
    const double square = glm::dot(into.Offset, into.Offset);
    this->LengthCosts[place] = 1e-12 * square * std::sqrt(square) * this->Star.Given.GetPerWhole();
    this->LeastChanges[place] = this->GetLeastFieldChange(place);
    this->Bounds[place] = onBoundary && !into.OnBoundary
      ? MergeChoice::Never
      : (this->FieldWeight * this->LeastChanges[place] + this->LengthCosts[place]) /
        static_cast<double>(into.Tets);
  }
}

//------------------------------------------------------------------------------
template <std::size_t N>
double MergeCosts<N>::GetLeastFieldChange(std::uint32_t place) const
{
  const std::size_t fields = this->Star.GetFields();
  double change = 0;
  for (std::size_t f = 0; f < fields; ++f)
  {
    change += this->Star.Quadrics[f].GetBound(
      this->Star.Around[place * fields + f].Value, this->Star.Neighbors[place].Offset);
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
    if (this->Bounds[place] <= least && this->Bounds[place] < MergeChoice::Never)
    {
      best = place;
      least = this->Bounds[place];
    }
  }
  if (best != MergeMesh::None)
  {
    this->Bounds[best] = MergeChoice::Never;
  }
  return best;
}

//------------------------------------------------------------------------------
/** Finds the volumes after a merge. Returns false if a tetrahedron would turn over. */
template <std::size_t N>
bool MergeCosts<N>::FindVolumes(std::uint32_t place)
{
  const auto& all = this->Star.Tets;
  const auto& offset = this->Star.Neighbors[place].Offset;
  const Triple<Double2> to{ Splat2(offset.x), Splat2(offset.y), Splat2(offset.z) };
  this->Volumes.resize(all.size());
  for (std::size_t block = 0; block < all.size(); ++block)
  {
    const MergeTets& tets = all[block];
    // Which tetrahedra vanish cannot be predicted, so there is no branch on that.
    const auto& c = tets.Corners;
    const auto kept = Split(tets.Present & (c[0] != place) & (c[1] != place) & (c[2] != place));
    std::array<Mask2, 2> doubtful;
    for (std::size_t half = 0; half < 2; ++half)
    {
      const Double2 volume = Dot(tets.Normal[half], to) + tets.Volume[half];
      doubtful[half] = kept[half] & ~(volume > tets.Least[half]);
      this->Volumes[block][half] = Keep(volume, kept[half]);
    }
    if (IsAny(doubtful[0] | doubtful[1]) && this->WouldInvertAny(block, doubtful))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
template <std::size_t N>
bool MergeCosts<N>::WouldInvertAny(std::size_t block, const std::array<Mask2, 2>& doubtful) const
{
  for (std::size_t lane = 0; lane < Lanes; ++lane)
  {
    if (doubtful[lane / 2][lane % 2] != 0 &&
      this->WouldInvert(Lanes * block + lane, this->Volumes[block][lane / 2][lane % 2]))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
/** Whether a volume is turned over, flatter than rounding, or much flatter than it was. */
template <std::size_t N>
bool MergeCosts<N>::WouldInvert(std::size_t tet, double volume) const
{
  const MergeTets& tets = this->Star.Tets[tet / Lanes];
  const std::size_t half = tet % Lanes / 2;
  const std::size_t lane = tet % 2;
  const Triple<Double2>& n = tets.Normal[half];
  const double area = glm::length(glm::dvec3(n.X[lane], n.Y[lane], n.Z[lane]));
  const double size = area * std::sqrt(area);
  double least = std::min(1e-3 * tets.Volume[half][lane], 1e-9 * size);
  if (!(least > 0))
  {
    least = 1e-12 * size;
  }
  return !(volume > least);
}

//------------------------------------------------------------------------------
/** The change of the fields, as the tetrahedra are now: of each that stays, the deviation of the
 * value of the new corner from the extrapolated field. */
template <std::size_t N>
double MergeCosts<N>::GetFieldChange(std::uint32_t place) const
{
  const std::size_t fields = this->Star.GetFields();
  const auto& offset = this->Star.Neighbors[place].Offset;
  const Triple<Double2> to{ Splat2(offset.x), Splat2(offset.y), Splat2(offset.z) };
  Double2 change = Splat2(0);
  for (std::size_t i = 0; i < 2 * this->Star.Tets.size(); ++i)
  {
    const std::size_t half = i % 2;
    const Double2 weight = SelectGreater(
      this->Volumes[i / 2][half], Splat2(0), this->Star.Tets[i / 2].Weight[half], Splat2(0));
    for (std::size_t f = 0; f < fields; ++f)
    {
      const Double2 error = Splat2(this->Star.Around[place * fields + f].Value) -
        Dot(this->Star.Slopes[(i / 2) * fields + f][half], to);
      change = change + weight * error * error;
    }
  }
  return Sum(change);
}

//------------------------------------------------------------------------------
/** How much worse the new tetrahedra are, by their size and shape, at interpolating fields that
 * bend like those of the whole mesh; 0 if they are better. Anything above enough if it is more. */
template <std::size_t N>
double MergeCosts<N>::GetBendChange(std::uint32_t place, double enough)
{
  // Not before they are needed, as some points have a merge that changes the fields less than
  // others do without their bends.
  if (!this->HasBends)
  {
    this->Bends.Gather();
    this->HasBends = true;
    const double coarser = this->Star.Coarser;
    this->BendWeight =
      std::min(FirstBendWeight * std::sqrt(coarser * std::sqrt(coarser)), LargestBendWeight);
  }
  const double change = this->Bends.GetChange(place, this->Volumes, enough / this->BendWeight);
  // Not std::max, which would hide what is not a number.
  return change < 0 ? 0 : this->BendWeight * change;
}

//------------------------------------------------------------------------------
/** The volume between the boundary as it is and as it would be, less where the merged edge is
 * nearly in the plane of the face: a smooth boundary may become coarser, while thin parts and sharp
 * edges stay. Negative if a face would turn over. */
template <std::size_t N>
double MergeCosts<N>::GetShapeChange(std::uint32_t place) const
{
  const auto& neighbors = this->Star.Neighbors;
  const auto& offset = neighbors[place].Offset;
  const double length = glm::length(offset);
  double change = 0;
  for (const MergeFace& face : this->Star.Faces)
  {
    if (face.First == place || face.Second == place)
    {
      continue;
    }
    const auto moved =
      glm::cross(neighbors[face.First].Offset - offset, neighbors[face.Second].Offset - offset);
    const double area = glm::length(face.Normal);
    if (!(glm::dot(moved, face.Normal) > 1e-3 * glm::length(moved) * area))
    {
      return -1;
    }
    const double height = std::abs(glm::dot(face.Normal, offset));
    const double sharp = std::min(1.0, height / (SharpSine * area * length));
    change += height / 6 * sharp * sharp;
  }
  return ShapeWeight * change * this->Star.Given.GetPerWhole();
}

//------------------------------------------------------------------------------
/** Takes the merge into a neighbor if it is better than the best so far. */
template <std::size_t N>
void MergeCosts<N>::Try(std::uint32_t place, bool checkTopology, MergeChoice& best)
{
  const MergeNeighbor& into = this->Star.Neighbors[place];
  double others = this->LengthCosts[place];
  if (this->Star.Mesh.IsOnBoundary(this->Point))
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
    ? MergeChoice::Never
    : (best.Cost * tets * (1 + MergeQuadric::Margin) - others) /
      std::max(this->FieldWeight, 1e-300);
  if (!(this->LeastChanges[place] <= enough) || !this->FindVolumes(place))
  {
    return;
  }
  const double now = this->GetFieldChange(place);
  if (!(now <= enough))
  {
    return;
  }
  const double later = this->GetBendChange(place, enough - now);
  const double change = this->FieldWeight * (now + later) + others;
  const double cost = change / tets;
  const bool isBetter = best.Into == MergeMesh::None || cost < best.Cost ||
    (cost == best.Cost && into.Point < best.Into);
  if (isBetter && std::isfinite(cost) &&
    (!checkTopology || this->Links.MayMerge(this->Point, into.Point)))
  {
    best = { into.Point, cost, change };
  }
}

//------------------------------------------------------------------------------
template <std::size_t N>
MergeChoice MergeCosts<N>::Choose(std::uint32_t point, std::uint32_t tryFirst, bool checkTopology)
{
  this->Point = point;
  this->HasBends = false;
  this->Star.Gather(point);
  // Twice, so that halves of both are as much as one of them.
  this->FieldWeight =
    this->Star.Mesh.IsOnBoundary(point) ? 2 * (1 - this->Settings.BoundaryWeight) : 1;
  this->FindBounds();
  MergeChoice best;
  // The first guess is often right, and then few others are looked at.
  const std::uint32_t next = this->Star.GetPlace(tryFirst);
  if (next != MergeMesh::None && this->Bounds[next] < MergeChoice::Never)
  {
    this->Bounds[next] = MergeChoice::Never;
    this->Try(next, checkTopology, best);
  }
  for (;;)
  {
    const auto place =
      this->TakeCandidate(best.Into == MergeMesh::None ? MergeChoice::Never : best.Cost);
    if (place == MergeMesh::None)
    {
      return best;
    }
    this->Try(place, checkTopology, best);
  }
}

template class MergeCosts<0>;
template class MergeCosts<1>;
}
