// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// FileReader: the meshes of a series.

#include "gatunError.h"
#include "gatunFileReader.h"
#include "gatunFileReaderInternals.h"
#include "gatunSeriesTable.h"

#include <algorithm>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
void FileReader::Internals::ReadSeries()
{
  constexpr const char* seriesName = "the table of meshes";
  this->Meshes = this->File.FindSections(SectionGrid);
  if (this->Meshes.empty() && this->File.FindSections(SectionTime).empty())
  {
    return;
  }
  const auto where = this->File.FindSection(SectionTime, seriesName);
  this->Series = this->File.Guarded(seriesName, where,
    [&] { return gatun::ReadSeries(this->File.Read(where, seriesName), this->Meshes.size() + 1); });
  if (!this->Meta.HasTime || !this->HasStepsOf(this->Series, 0))
  {
    this->File.Fail(ErrorCode::Corrupt, "the time steps of the first mesh are not those listed");
  }
}

//------------------------------------------------------------------------------
/** Whether the time steps are those of a mesh in a series. */
bool FileReader::Internals::HasStepsOf(
  const std::vector<SeriesStep>& series, std::size_t mesh) const
{
  std::vector<double> times;
  for (const SeriesStep& step : series)
  {
    if (step.Mesh == mesh)
    {
      times.push_back(step.Time);
    }
  }
  return times == this->Times;
}

//------------------------------------------------------------------------------
std::unique_ptr<FileReader::Internals> FileReader::Internals::MakeMesh(
  const Internals& whole, std::size_t mesh)
{
  std::unique_ptr<Internals> self(
    new Internals(whole, whole.Meshes.at(mesh - 1), "mesh " + std::to_string(mesh + 1)));
  const bool fits = self->ListedArrays == whole.ListedArrays && self->Meta.HasTime &&
    self->IsSurface == whole.IsSurface && self->HasStepsOf(whole.Series, mesh);
  if (!fits)
  {
    self->File.Fail(ErrorCode::Corrupt, "it cannot be a mesh of the series");
  }
  return self;
}

//------------------------------------------------------------------------------
std::size_t FileReader::GetNumberOfMeshes() const
{
  return this->Self->Meshes.size() + 1;
}

//------------------------------------------------------------------------------
const std::vector<SeriesStep>& FileReader::GetSeries() const
{
  return this->Self->Series;
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
std::shared_ptr<const FileReader> FileReader::OpenMesh(std::size_t mesh) const
{
  if (mesh == 0 || mesh >= this->GetNumberOfMeshes())
  {
    ThrowInvalid("there is no such mesh in the series", this->GetPath());
  }
  return std::shared_ptr<const FileReader>(new FileReader(Internals::MakeMesh(*this->Self, mesh)));
}
}
