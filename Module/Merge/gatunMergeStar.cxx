// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeStar.h"

#include "gatunMergeChoice.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace gatun
{
namespace
{
/** For a corner the others, so that the volume with it in front has the sign of the tetrahedron. */
constexpr std::array<std::array<unsigned, 3>, 4> Others{ { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 },
  { 0, 2, 1 } } };

GATUN_INLINE Triple<Double2> Pair(const glm::dvec3& a, const glm::dvec3& b)
{
  return { Double2{ a.x, b.x }, Double2{ a.y, b.y }, Double2{ a.z, b.z } };
}
}

//------------------------------------------------------------------------------
MergeQuadric MergeQuadric::Sums::GetSum() const
{
  const auto sum = [](const Triple<Double2>& v) -> glm::dvec3 {
    return { Sum(v.X), Sum(v.Y), Sum(v.Z) };
  };
  return { Sum(this->Weight), sum(this->Linear), sum(this->Squares), sum(this->Products) };
}

double MergeQuadric::GetBound(double error, const glm::dvec3& offset) const
{
  const double constant = this->Weight * error * error;
  const double square = glm::dot(this->Squares, offset * offset) +
    2 * glm::dot(this->Products, offset * glm::dvec3(offset.y, offset.z, offset.x));
  return constant - 2 * error * glm::dot(this->Linear, offset) + square -
    Margin * (constant + std::abs(square));
}

//------------------------------------------------------------------------------
template <std::size_t N>
MergeStar<N>::MergeStar(const MergeMesh& mesh, const MergeFields& fields, MergeMetric metric)
  : Mesh(mesh)
  , Given(fields)
  , Fields(fields.GetNumber())
  , PerVolume(metric == MergeMetric::Mass ? fields.GetPerWhole() / 6 : 0)
  , PerTet(metric == MergeMetric::Mass ? 0 : fields.GetPerTet())
  , Places(mesh.GetNumberOfPoints(), 0)
{
}

//------------------------------------------------------------------------------
template <std::size_t N>
void MergeStar<N>::Gather(std::uint32_t point)
{
  this->GatherCorners(point);
  this->GatherNeighbors(point);
  this->GatherTets();
  this->GatherFaces(point);
}

//------------------------------------------------------------------------------
/** Without branches on what is around the point, as none of them can be predicted. */
template <std::size_t N>
void MergeStar<N>::GatherCorners(std::uint32_t point)
{
  std::uint32_t* const places = this->Places.data();
  for (const MergeNeighbor& neighbor : this->Neighbors)
  {
    places[neighbor.Point] = 0;
  }
  const auto ring = this->Mesh.GetRing(point);
  this->NumberOfTets = ring.size();
  this->Tets.resize((ring.size() + Lanes - 1) / Lanes);
  // One more than the most neighbors there can be, as the place after the last one is written to.
  this->Corners.resize(3 * ring.size() + 1);
  Corner* const found = this->Corners.data();
  MergeTets* const blocks = this->Tets.data();
  const Sample* const samples = this->Given.GetData(0);
  const std::size_t each = 1 + this->GetFields();
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const auto& corners = this->Mesh.GetTet(ring[i]);
    const auto& others = Others[MergeMesh::FindKnownCorner(corners, point)];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint32_t corner = corners[others[k]];
      const std::uint32_t known = places[corner];
      const std::uint32_t isNew = known == 0 ? 1 : 0;
      __builtin_prefetch(samples + corner * each);
      found[number] = { corner, 0 };
      number += isNew;
      const std::uint32_t place = known + isNew * number;
      places[corner] = place;
      blocks[i / Lanes].Corners[k][i % Lanes] = place - 1;
      ++found[place - 1].Tets;
    }
  }
  for (std::size_t block = 0; block < this->Tets.size(); ++block)
  {
    blocks[block].Present = Int4{ -1, -1, -1, -1 };
  }
  for (std::size_t i = ring.size(); i < Lanes * this->Tets.size(); ++i)
  {
    blocks[i / Lanes].Present[i % Lanes] = 0;
    for (auto& corner : blocks[i / Lanes].Corners)
    {
      corner[i % Lanes] = corner[i % Lanes - 1];
    }
  }
  this->Neighbors.clear();
  for (std::uint32_t place = 0; place < number; ++place)
  {
    this->Neighbors.push_back({ found[place].Point, found[place].Tets, false, {} });
  }
}

//------------------------------------------------------------------------------
template <std::size_t N>
void MergeStar<N>::GatherNeighbors(std::uint32_t point)
{
  const std::size_t fields = this->GetFields();
  const Vec& here = this->Given.GetPoint(point);
  this->Before = this->Given.GetVolumeAround(point);
  const Sample* const values = this->Given.GetSamples(point);
  this->Around.resize(this->Neighbors.size() * fields);
  for (std::size_t place = 0; place < this->Neighbors.size(); ++place)
  {
    MergeNeighbor& neighbor = this->Neighbors[place];
    neighbor.Offset = this->Given.GetPoint(neighbor.Point) - here;
    const Sample* const sample = this->Given.GetSamples(neighbor.Point);
    for (std::size_t f = 0; f < fields; ++f)
    {
      this->Around[place * fields + f] = { sample[f].Value - values[f].Value -
          glm::dot(values[f].Gradient, neighbor.Offset),
        sample[f].Gradient - values[f].Gradient };
    }
  }
}

//------------------------------------------------------------------------------
/** Two tetrahedra at a time. */
template <std::size_t N>
void MergeStar<N>::GatherTets()
{
  const std::size_t fields = this->GetFields();
  const Double2 zero = Splat2(0);
  this->Slopes.resize(this->Tets.size() * fields);
  this->Sums.assign(fields, {});
  const MergeNeighbor* const neighbors = this->Neighbors.data();
  const Sample* const around = this->Around.data();
  Double2 volumes = zero;
  for (std::size_t i = 0; i < 2 * this->Tets.size(); ++i)
  {
    MergeTets& block = this->Tets[i / 2];
    const std::size_t half = i % 2;
    const auto place = [&](std::size_t k, std::size_t lane)
    { return block.Corners[k][2 * half + lane]; };
    const auto offsets = [&](std::size_t k)
    { return Pair(neighbors[place(k, 0)].Offset, neighbors[place(k, 1)].Offset); };
    const auto p0 = offsets(0);
    const auto p1 = offsets(1);
    const auto p2 = offsets(2);
    const std::array<Triple<Double2>, 3> across{ Cross(p1, p2), Cross(p2, p0), Cross(p0, p1) };
    // Six times the volume with the point at x: (p0 - x) . ((p1 - x) x (p2 - x)).
    const Double2 oriented = Dot(p0, across[0]);
    const Double2 sign = SelectGreater(zero, oriented, Splat2(1), Splat2(-1));
    const Double2 volume = zero - sign * oriented;
    const Mask2 present = Split(block.Present)[half];
    block.Normal[half] = sign * (across[0] + across[1] + across[2]);
    block.Volume[half] = volume;
    block.Least[half] =
      SelectGreater(Keep(volume, present), zero, Splat2(1e-3) * volume, Splat2(MergeChoice::Never));
    block.Weight[half] = Keep(Splat2(this->PerVolume) * volume + Splat2(this->PerTet), present);
    volumes = volumes + Keep(volume, present);
    const Double2 weight = SelectGreater(volume, zero, block.Weight[half], zero);
    const Double2 inverse = SelectGreater(volume, zero, Splat2(1) / oriented, zero);
    for (std::size_t f = 0; f < fields; ++f)
    {
      const auto values = [&](std::size_t k)
      {
        return Double2{ around[place(k, 0) * fields + f].Value,
          around[place(k, 1) * fields + f].Value };
      };
      const auto slope =
        inverse * (values(0) * across[0] + values(1) * across[1] + values(2) * across[2]);
      this->Slopes[(i / 2) * fields + f][half] = slope;
      this->Sums[f].Add(weight, slope);
    }
  }
  const double now = Sum(volumes);
  this->Coarser = now > this->Before && this->Before > 0 ? now / this->Before : 1;
  this->Quadrics.clear();
  for (const MergeQuadric::Sums& sums : this->Sums)
  {
    this->Quadrics.push_back(sums.GetSum());
  }
}

//------------------------------------------------------------------------------
template <std::size_t N>
void MergeStar<N>::GatherFaces(std::uint32_t point)
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
      MergeFace face{};
      bool isFirst = true;
      for (const auto corner : tet)
      {
        if (corner != point && corner != tet[side])
        {
          (isFirst ? face.First : face.Second) = this->GetPlace(corner);
          isFirst = false;
        }
      }
      MergeNeighbor& first = this->Neighbors[face.First];
      MergeNeighbor& second = this->Neighbors[face.Second];
      face.Normal = glm::cross(first.Offset, second.Offset);
      first.OnBoundary = second.OnBoundary = true;
      this->Faces.push_back(face);
    }
  }
}

template class MergeStar<0>;
template class MergeStar<1>;
}
