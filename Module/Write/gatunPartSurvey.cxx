// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartSurvey.h"

#include "gatunContainer.h"
#include "gatunParallel.h"
#include "gatunPartBoundary.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace gatun
{
namespace
{
/** The hash of consecutive arrays, where it matters which of them exist and how long they are. */
class ArrayHash
{
public:
  void Add(const void* data, std::uint64_t bytes)
  {
    const std::array<std::uint64_t, 2> size{ bytes, data ? 1u : 0u };
    this->Sum.Add({ reinterpret_cast<const std::uint8_t*>(size.data()), sizeof(size) });
    if (data)
    {
      this->Sum.Add({ static_cast<const std::uint8_t*>(data), static_cast<std::size_t>(bytes) });
    }
  }

  std::uint64_t Get() const { return this->Sum.Get(); }

private:
  RunningChecksum Sum;
};

/** The bits of a coordinate, with 0 for -0. */
std::uint64_t GetKey(const MeshInput& mesh, std::uint32_t point, unsigned axis)
{
  const auto at = std::size_t{ 3 } * point + axis;
  if (mesh.CoordinateType == ScalarType::Float32)
  {
    const float value = static_cast<const float*>(mesh.Coordinates)[at];
    return std::bit_cast<std::uint32_t>(value == 0 ? 0.0f : value);
  }
  const double value = static_cast<const double*>(mesh.Coordinates)[at];
  return std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value);
}

/** Marks the points of a part that are looked for in others. */
std::vector<std::uint8_t> FindCandidates(
  const WriterPart& part, const std::int64_t* globalIds, PartSurvey::Candidates candidates)
{
  if (candidates == PartSurvey::Candidates::Boundary)
  {
    return FindPartBoundary(part.Mesh, part.Layout);
  }
  std::vector<std::uint8_t> marks(static_cast<std::size_t>(part.Mesh.GetMesh().Points), 1);
  if (candidates == PartSurvey::Candidates::WithIds && globalIds)
  {
    std::transform(globalIds, globalIds + marks.size(), marks.begin(),
      [](std::int64_t id) { return static_cast<std::uint8_t>(id >= 0); });
  }
  return marks;
}
}

//------------------------------------------------------------------------------
std::uint64_t HashPart(const MeshInput& mesh, const std::int64_t* globalIds)
{
  const MeshAccess access(mesh);
  const std::uint64_t idSize = mesh.WideIds ? 8 : 4;
  ArrayHash hash;
  hash.Add(mesh.Coordinates, 3 * SizeOf(mesh.CoordinateType) * mesh.Points);
  hash.Add(mesh.Connectivity, mesh.Cells > 0 ? idSize * access.GetBegin(mesh.Cells) : 0);
  hash.Add(mesh.Types, mesh.Cells);
  hash.Add(mesh.Offsets, idSize * (mesh.Cells + 1));
  hash.Add(mesh.FaceLocations, sizeof(std::int64_t) * mesh.Cells);
  hash.Add(mesh.Faces, sizeof(std::int64_t) * mesh.FacesSize);
  hash.Add(globalIds, sizeof(std::int64_t) * mesh.Points);
  return hash.Get();
}

//------------------------------------------------------------------------------
std::uint64_t HashValues(const std::vector<ArrayDescription>& arrays,
  std::span<const void* const> values, std::uint64_t points, std::uint64_t cells)
{
  ArrayHash hash;
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    const auto tuples = arrays[a].Where == Association::Point ? points : cells;
    if (!values[a] && tuples > 0)
    {
      ThrowInvalid("array '" + arrays[a].Name + "' has no values");
    }
    hash.Add(values[a], tuples * arrays[a].Components * SizeOf(arrays[a].Type));
  }
  return hash.Get();
}

//------------------------------------------------------------------------------
PartSurvey::PartSurvey(const WriterPart& part, std::uint32_t number, const std::int64_t* globalIds,
  Candidates candidates)
{
  const auto& mesh = part.Mesh.GetMesh();
  const auto& layout = part.Layout;
  const auto isCandidate = FindCandidates(part, globalIds, candidates);
  const auto box = FindBox(part.Mesh);
  const auto size = 3 * SizeOf(mesh.CoordinateType);
  const auto* coordinates = static_cast<const std::uint8_t*>(mesh.Coordinates);
  const auto add = [&](std::uint32_t point, const auto& chunks)
  {
    bool isPlace = true;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      isPlace = isPlace && std::isfinite(part.Mesh.GetCoordinate(point, axis));
    }
    if (!isCandidate[point] || (!globalIds && !isPlace))
    {
      return;
    }
    BoundaryRecord use;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      use.Key[axis] = globalIds ? (axis == 0 ? static_cast<std::uint64_t>(globalIds[point]) : 0)
                                : GetKey(mesh, point, axis);
    }
    use.Values = Checksum({ coordinates + size * point, size });
    use.Morton = FindMortonCode(part.Mesh, box, point);
    use.Part = number;
    use.Point = point;
    for (const auto chunk : chunks)
    {
      use.Chunk = chunk == BoundaryRecord::NoChunk
        ? chunk
        : static_cast<std::uint32_t>(part.Place.FirstChunk + chunk);
      this->Uses.push_back(use);
    }
  };
  for (std::uint32_t c = 0; c < layout.OwnPoints.size(); ++c)
  {
    for (const auto point : layout.OwnPoints[c])
    {
      add(point, std::array{ c });
    }
  }
  for (const auto& [chunks, points] : layout.SharedPoints)
  {
    for (const auto point : points)
    {
      add(point, chunks);
    }
  }
  for (const auto point : layout.UnusedPoints)
  {
    add(point, std::array{ BoundaryRecord::NoChunk });
  }
}

//------------------------------------------------------------------------------
void PartSurvey::AddValues(
  const std::vector<ArrayDescription>& arrays, std::span<const void* const> values)
{
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    if (arrays[a].Where != Association::Point || this->Uses.empty())
    {
      continue;
    }
    const auto size = arrays[a].Components * SizeOf(arrays[a].Type);
    const auto* all = static_cast<const std::uint8_t*>(values[a]);
    Bytes hashed(sizeof(std::uint64_t) + size);
    for (auto& use : this->Uses)
    {
      std::memcpy(hashed.data(), &use.Values, sizeof(use.Values));
      std::memcpy(hashed.data() + sizeof(use.Values), all + size * use.Point, size);
      use.Values = Checksum(hashed);
    }
  }
}

//------------------------------------------------------------------------------
void PartDomains::AddMesh(const MeshInput& part)
{
  this->Axes.resize(3, DomainSurvey(part.CoordinateType));
  ParallelFor(3,
    [&](std::size_t axis)
    {
      this->Axes[axis].Add(part.Coordinates, static_cast<std::size_t>(part.Points), 3, axis);
      this->Axes[axis].Compress();
    });
}

//------------------------------------------------------------------------------
/** The domain of values that are on the lattice of another file; null if there is none. */
const Domain* PartDomains::FindRounded(
  std::size_t step, std::size_t array, std::size_t component) const
{
  const Domain* const domain =
    this->Rounded ? &(*this->Rounded)[step].Domains[array][component] : nullptr;
  return domain && domain->GetQuantizer() ? domain : nullptr;
}

//------------------------------------------------------------------------------
/** Values of another file are kept as they are. */
RoundingRequest PartDomains::GetRequest(const ArrayDescription& array) const
{
  return this->Rounded ? RoundingRequest() : GetRoundingRequest(this->State.Options, array);
}

//------------------------------------------------------------------------------
void PartDomains::AddStep(
  std::size_t step, std::span<const void* const> values, std::uint64_t points, std::uint64_t cells)
{
  const auto& arrays = this->State.Meta.Arrays;
  this->Steps.resize(std::max(this->Steps.size(), step + 1));
  this->Copies.resize(this->Steps.size());
  this->Copies[step].Add(arrays, values, points, cells);
  auto& builders = this->Steps[step];
  std::size_t next = 0;
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    const auto& array = arrays[a];
    const auto tuples =
      static_cast<std::size_t>(array.Where == Association::Point ? points : cells);
    for (std::uint32_t c = 0; c < array.Components; ++c, ++next)
    {
      if (next == builders.size())
      {
        builders.emplace_back(array.Type, MaxPalette, this->GetRequest(array));
      }
      if (values[a] && !this->FindRounded(step, a, c))
      {
        builders[next].Add(values[a], tuples, array.Components, c);
        builders[next].Compress();
      }
    }
  }
}

//------------------------------------------------------------------------------
void PartDomains::Put(ByteWriter& out)
{
  out.PutVarint(this->Axes.size());
  for (auto& axis : this->Axes)
  {
    axis.Put(out);
  }
  out.PutVarint(this->Steps.size());
  for (auto& step : this->Steps)
  {
    for (auto& component : step)
    {
      component.Put(out);
    }
  }
  for (const auto& copies : this->Copies)
  {
    copies.Put(out);
  }
}

//------------------------------------------------------------------------------
void PartDomains::Add(ByteReader& in)
{
  const auto axes = in.GetCount(1);
  if (axes > 0)
  {
    this->Axes.resize(3, DomainSurvey(this->State.Meta.CoordinateType));
  }
  for (std::size_t axis = 0; axis < axes; ++axis)
  {
    this->Axes[axis].Add(in);
  }
  const auto steps = static_cast<std::size_t>(in.GetVarint());
  this->Steps.resize(std::max(this->Steps.size(), steps));
  for (std::size_t step = 0; step < steps; ++step)
  {
    auto& builders = this->Steps[step];
    const bool isNew = builders.empty();
    std::size_t next = 0;
    for (const auto& array : this->State.Meta.Arrays)
    {
      for (std::uint32_t c = 0; c < array.Components; ++c, ++next)
      {
        if (isNew)
        {
          builders.emplace_back(array.Type, MaxPalette, this->GetRequest(array));
        }
        builders[next].Add(in);
      }
    }
  }
  this->Copies.resize(this->Steps.size());
  for (std::size_t step = 0; step < steps; ++step)
  {
    this->Copies[step].Add(in);
  }
}

//------------------------------------------------------------------------------
PointDomain PartDomains::FinishMesh()
{
  PointDomain domains;
  domains.fill(Domain(this->State.Meta.CoordinateType));
  for (std::size_t axis = 0; axis < this->Axes.size(); ++axis)
  {
    domains[axis] = this->Axes[axis].Finish(this->State.Meta.Points, PaletteUse::Coordinates);
  }
  return domains;
}

//------------------------------------------------------------------------------
StepDomains PartDomains::FinishStep(std::size_t step, const StepScales* before)
{
  const auto& arrays = this->State.Meta.Arrays;
  StepDomains domains{ {}, this->Copies[step].Finish(arrays, this->State.Options.Errors) };
  domains.Components.resize(arrays.size());
  std::size_t next = 0;
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    const auto tuples =
      arrays[a].Where == Association::Point ? this->State.Meta.Points : this->State.NumberOfCells;
    for (std::uint32_t c = 0; c < arrays[a].Components; ++c, ++next)
    {
      const Domain* const rounded = this->FindRounded(step, a, c);
      domains.Components[a].push_back(rounded
          ? *rounded
          : this->Steps[step][next].Finish(tuples, PaletteUse::Array, FindScale(before, a, c)));
    }
  }
  this->Steps[step] = {};
  this->Copies[step] = {};
  return domains;
}
}
