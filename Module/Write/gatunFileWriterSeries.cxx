// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// FileWriter: the meshes and time steps of a series.

#include "gatunCellSubset.h"
#include "gatunError.h"
#include "gatunFileReader.h"
#include "gatunFileReaderInternals.h"
#include "gatunFileWriterInternals.h"
#include "gatunNumberText.h"

#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
FileWriter::Internals::Internals(const FileReader& file, const WriterOptions& options)
  : State(InternalsOf(file).File, options)
  , Part(MeshInput())
  , Series(InternalsOf(file).Stored)
  , IsAppending(true)
{
  for (const double time : this->Series.empty() ? file.GetTimes() : std::vector<double>())
  {
    this->Series.push_back({ 0, 0, time });
  }
  this->NumberOfMeshes = static_cast<std::uint32_t>(InternalsOf(file).Meshes.size() + 1);
}

//------------------------------------------------------------------------------
/** Adds a mesh to the series, in a file of its own that is embedded behind its last step. */
std::uint32_t FileWriter::Internals::AddMesh(const MeshInput& mesh,
  const std::vector<ArrayDescription>& arrays, const WriterOptions& options,
  const Progress& progress)
{
  if (options.IsSurface != this->State.Options.IsSurface)
  {
    ThrowInvalid("some meshes of the series are surfaces, and some are not");
  }
  this->EndOther();
  this->Other = std::make_unique<Internals>(this->State, mesh, arrays, options);
  this->Other->Begin(progress);
  this->NextMesh = this->NumberOfMeshes;
  return this->NumberOfMeshes++;
}

//------------------------------------------------------------------------------
WriterOptions FileWriter::Internals::FitOptions(WriterOptions options) const
{
  if (this->IsAppending)
  {
    options.Keep = this->State.Options.Keep;
    options.Coding = this->State.Options.Coding;
    options.ChunkSize = this->State.Options.ChunkSize;
    options.KeyStepInterval = this->State.Options.KeyStepInterval;
  }
  return options;
}

//------------------------------------------------------------------------------
void FileWriter::Internals::EndOther()
{
  if (this->Other)
  {
    if (this->Other->Steps.GetCount() == 0)
    {
      ThrowInvalid("a mesh of the series has no time step");
    }
    this->State.Statistics.OtherMeshBytes += this->AddEmbedded(SectionGrid, *this->Other);
    this->Other.reset();
  }
}

//------------------------------------------------------------------------------
void FileWriter::Internals::UseMesh(std::uint32_t mesh)
{
  if ((mesh != 0 || this->IsAppending) && mesh + 1 != this->NumberOfMeshes)
  {
    ThrowInvalid("only the first and the last mesh of a series can have more time steps");
  }
  this->NextMesh = mesh;
}

//------------------------------------------------------------------------------
/** Writes a step of the mesh that is used. */
void FileWriter::Internals::WriteSeriesStep(std::span<const void* const> values,
  const FieldData& field, bool hasTime, double time, const Progress& progress,
  const void* coordinates, const RemainingCells* remaining)
{
  if (!this->Series.empty() && !(hasTime && time > this->Series.back().Time))
  {
    ThrowInvalid("the times of the steps must ascend: " +
      (hasTime ? FormatNumber(time) : "a step without time") + " follows " +
      FormatNumber(this->Series.back().Time));
  }
  if (this->IsAppending && !this->Other)
  {
    ThrowInvalid("the steps that are added need a mesh");
  }
  if (this->NumberOfMeshes > 1 && (this->Series.empty() || !hasTime))
  {
    ThrowInvalid("a mesh that changes needs time, and a step of the first mesh");
  }
  Internals& mesh = this->NextMesh == 0 ? *this : *this->Other;
  if (remaining && remaining->DropsPoints && mesh.State.Options.PointsMove && !coordinates)
  {
    ThrowInvalid("a step with fewer points has no coordinates");
  }
  std::vector<const void*> all(values.begin(), values.end());
  if (mesh.State.Options.PointsMove)
  {
    all.push_back(coordinates ? coordinates : mesh.Part.Mesh.GetMesh().Coordinates);
  }
  StoredStep stored{ this->NextMesh, 0, time };
  if (remaining)
  {
    mesh.WriteRemaining(all, field, time, progress, *remaining, stored);
  }
  else
  {
    mesh.WriteStep(all, field, hasTime, time, progress);
  }
  this->Series.push_back(stored);
}

//------------------------------------------------------------------------------
/** Writes a step of which some cells are not alive. Sets the mask that it has. */
void FileWriter::Internals::WriteRemaining(std::span<const void* const> values,
  const FieldData& field, double time, const Progress& progress, const RemainingCells& remaining,
  StoredStep& stored)
{
  if (this->Steps.GetCount() == 0 || this->Tree || this->Boundary)
  {
    ThrowInvalid(
      "the first step of a mesh must have all of its cells, and cells can be left out only "
      "without hierarchy and boundary");
  }
  const CellSubset subset(this->Part.Mesh, remaining);
  std::vector<Bytes> spread;
  std::vector<const void*> pointers;
  for (std::size_t a = 0; a < values.size(); ++a)
  {
    const auto& array = this->State.Meta.Arrays[a];
    spread.push_back(subset.Spread(values[a], array.Where, array.Components * SizeOf(array.Type),
      this->Steps.GetBefore().at(a)));
    pointers.push_back(spread.back().data());
  }
  stored.Mask = this->WriteMask(subset.MakeMask(this->Part));
  this->WriteStep(pointers, field, true, time, progress, nullptr, &subset);
}

//------------------------------------------------------------------------------
/** Writes a mask unless it is the last one. Returns its number. */
std::uint32_t FileWriter::Internals::WriteMask(CellMask mask)
{
  // A reader needs all masks since the last one that stands alone.
  constexpr std::uint32_t distance = 16;
  if (this->Masks == 0 || !(mask == this->LastMask))
  {
    const bool isRelative = this->Masks % distance != 0;
    this->State.File.AddSection(
      SectionLive, mask.Write(isRelative ? &this->LastMask : nullptr, this->State.HasCells));
    this->LastMask = std::move(mask);
    ++this->Masks;
  }
  return this->Masks;
}
}
