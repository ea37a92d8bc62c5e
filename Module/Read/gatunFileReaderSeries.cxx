// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// FileReader: the meshes of a series.

#include "gatunError.h"
#include "gatunFileReader.h"
#include "gatunFileReaderInternals.h"
#include "gatunSeriesTable.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
void FileReader::Internals::ReadSeries()
{
  constexpr const char* seriesName = "the table of meshes";
  this->Meshes = this->File.FindSections(SectionGrid);
  this->Masks = this->File.FindSections(SectionLive);
  if (!this->Masks.empty() && (!this->Meta.HasTime || this->Tree || this->Boundary))
  {
    this->File.Fail(ErrorCode::Corrupt,
      "time steps have some cells only, but there is no time, or a hierarchy or a boundary");
  }
  if (this->Meshes.empty() && this->File.FindSections(SectionTime).empty())
  {
    return;
  }
  const auto where = this->File.FindSection(SectionTime, seriesName);
  this->Stored = this->File.Guarded(seriesName, where,
    [&]
    {
      return gatun::ReadSeries(
        this->File.Read(where, seriesName), this->Meshes.size() + 1, this->Masks.size());
    });
  if (!this->Meta.HasTime || !this->HasStepsOf(this->Stored, 0))
  {
    this->File.Fail(ErrorCode::Corrupt, "the time steps of the first mesh are not those listed");
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> numbers;
  for (const StoredStep& step : this->Stored)
  {
    const auto [place, isNew] = numbers.try_emplace(
      std::pair(step.Mesh, step.Mask), static_cast<std::uint32_t>(this->Kinds.size()));
    if (isNew)
    {
      this->Kinds.push_back(step);
    }
    this->Series.push_back({ place->second, step.Time });
  }
}

//------------------------------------------------------------------------------
/** Whether the time steps are those of a mesh in a series. */
bool FileReader::Internals::HasStepsOf(
  const std::vector<StoredStep>& series, std::size_t mesh) const
{
  std::vector<double> times;
  for (const StoredStep& step : series)
  {
    if (step.Mesh == mesh)
    {
      times.push_back(step.Time);
    }
  }
  return times == this->Times;
}

//------------------------------------------------------------------------------
CellMask FileReader::Internals::ReadMask(std::size_t mask) const
{
  constexpr const char* maskName = "the table of remaining cells";
  const auto read = [&](std::size_t number, auto&& use)
  {
    const StreamRef& where = this->Masks.at(number - 1);
    return this->File.Guarded(
      maskName, where, [&] { return use(this->File.Read(where, maskName)); });
  };
  auto first = mask;
  while (first > 1 && read(first, [](const Bytes& bytes) { return CellMask::NeedsBefore(bytes); }))
  {
    --first;
  }
  CellMask result;
  const CellMask::Mesh mesh{ this->GetTables().GetNumberOfCells(), this->Meta.Points,
    this->Cells ? std::span(this->CellTypes) : std::span<const CellTypeCount>() };
  for (auto number = first; number <= mask; ++number)
  {
    read(number,
      [&](const Bytes& bytes)
      {
        result.Read(bytes, mesh);
        return true;
      });
  }
  if (!this->Cells)
  {
    result.Types.assign(result.Cells > 0 ? 1 : 0, { TetraType, result.Cells });
  }
  return result;
}

//------------------------------------------------------------------------------
std::shared_ptr<const CellMask> FileReader::Internals::GetMask(std::size_t mask) const
{
  return this->KeptMasks.FindOrMake(mask, [&] { return this->ReadMask(mask); });
}

//------------------------------------------------------------------------------
std::unique_ptr<FileReader::Internals> FileReader::Internals::MakeMesh(
  const Internals& whole, std::size_t mesh)
{
  std::unique_ptr<Internals> self(
    new Internals(whole, whole.Meshes.at(mesh - 1), "mesh " + std::to_string(mesh + 1)));
  self->RequireMerges();
  const bool fits = self->ListedArrays == whole.ListedArrays && self->Meta.HasTime &&
    self->IsSurface == whole.IsSurface && self->HasStepsOf(whole.Stored, mesh);
  std::size_t masks = 0;
  for (const StoredStep& step : whole.Stored)
  {
    masks = std::max<std::size_t>(masks, step.Mesh == mesh ? step.Mask : 0);
  }
  if (!fits || self->Masks.size() != masks)
  {
    self->File.Fail(ErrorCode::Corrupt, "it cannot be a mesh of the series");
  }
  return self;
}

//------------------------------------------------------------------------------
std::size_t FileReader::GetNumberOfMeshes() const
{
  return this->Remaining ? 1 : std::max<std::size_t>(this->Self->Kinds.size(), 1);
}

//------------------------------------------------------------------------------
std::size_t FileReader::GetParentMesh(std::size_t mesh) const
{
  const auto& kinds = this->Self->Kinds;
  const auto parent = std::find_if(kinds.begin(), kinds.end(),
    [&](const StoredStep& kind) { return kind.Mask == 0 && kind.Mesh == kinds.at(mesh).Mesh; });
  return static_cast<std::size_t>(parent - kinds.begin());
}

//------------------------------------------------------------------------------
const std::vector<SeriesStep>& FileReader::GetSeries() const
{
  static const std::vector<SeriesStep> none;
  return this->Remaining ? none : this->Self->Series;
}

//------------------------------------------------------------------------------
std::vector<double> FileReader::GetSeriesTimes() const
{
  if (this->GetSeries().empty())
  {
    return this->HasTime() ? this->GetTimes() : std::vector<double>();
  }
  std::vector<double> times;
  std::transform(this->GetSeries().begin(), this->GetSeries().end(), std::back_inserter(times),
    [](const SeriesStep& step) { return step.Time; });
  return times;
}

//------------------------------------------------------------------------------
std::shared_ptr<const FileReader> FileReader::OpenMesh(
  std::size_t mesh, const std::shared_ptr<const FileReader>& parent) const
{
  if (mesh == 0 || mesh >= this->GetNumberOfMeshes())
  {
    ThrowInvalid("there is no such mesh in the series", this->GetPath());
  }
  const StoredStep& kind = this->Self->Kinds[mesh];
  std::shared_ptr<const Internals> content = parent ? parent->Self
    : kind.Mesh == 0
    ? this->Self
    : std::shared_ptr<const Internals>(Internals::MakeMesh(*this->Self, kind.Mesh));
  std::shared_ptr<FileReader> opened(new FileReader(std::move(content)));
  if (kind.Mask > 0)
  {
    opened->SetMask(kind.Mask);
  }
  return opened;
}

//------------------------------------------------------------------------------
/** Leaves only some of the cells. */
void FileReader::SetMask(std::uint32_t mask)
{
  const auto cells = this->Self->GetMask(mask);
  this->Mask = mask;
  this->Remaining = std::make_shared<const RemainingCounts>(*cells);
  this->MaskedChunks = this->Self->GetTables().GetChunks();
  this->MaskedTets = 0;
  for (ChunkInfo& chunk : this->MaskedChunks)
  {
    const auto alive = cells->Count(chunk.FirstCell, chunk.Cells);
    // How many tetrahedra other cells consist of is known only when they are decoded.
    chunk.Tets = chunk.Cells == chunk.Tets
      ? alive
      : static_cast<std::uint64_t>(std::ceil(static_cast<double>(chunk.Tets) *
          static_cast<double>(alive) / static_cast<double>(chunk.Cells)));
    chunk.Cells = alive;
    this->MaskedTets += chunk.Tets;
  }
}

//------------------------------------------------------------------------------
bool FileReader::HasAllCells() const
{
  return this->Remaining == nullptr;
}
}
