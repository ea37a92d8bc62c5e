// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFileWriter.h"

#include "gatunDomainSurvey.h"
#include "gatunFileReader.h"
#include "gatunFileReaderInternals.h"
#include "gatunFileWriterInternals.h"
#include "gatunKeepMemory.h"
#include "gatunLayerTable.h"
#include "gatunMergeOrder.h"
#include "gatunParallel.h"
#include "gatunRoundedArrays.h"
#include "gatunSeriesTable.h"
#include "gatunWriterCheck.h"

#include <optional>
#include <utility>

namespace gatun
{
namespace
{
/** Lets layers be made of the values that readers will have. Returns these values, which must exist
 * until the mesh has been divided. */
std::unique_ptr<RoundedArray> RoundLayerValues(
  const MeshInput& mesh, const std::vector<ArrayDescription>& arrays, WriterOptions& options)
{
  if (!options.Layers || !FindBound(options.Errors, arrays[options.Layers->Array]))
  {
    return nullptr;
  }
  const auto& array = arrays[options.Layers->Array];
  const auto points = static_cast<std::size_t>(mesh.Points);
  std::vector<Domain> domains;
  for (std::uint32_t c = 0; c < array.Components; ++c)
  {
    domains.push_back(FindDomain(array.Type, options.Layers->Values, points, array.Components, c,
      PaletteUse::Array, nullptr, GetRoundingRequest(options, array)));
  }
  auto rounded = std::make_unique<RoundedArray>(array, options.Layers->Values, points);
  rounded->PutOnLattice(domains, {}, {});
  options.Layers->Values = rounded->GetValues();
  return rounded;
}

/** The arrays of a mesh with the coordinates, if they move. */
std::vector<ArrayDescription> ListArrays(
  std::vector<ArrayDescription> arrays, const MeshInput& mesh, const WriterOptions& options)
{
  if (options.PointsMove)
  {
    arrays.push_back(DescribePoints(mesh.CoordinateType));
  }
  return arrays;
}
}

//------------------------------------------------------------------------------
void FileWriter::Internals::Begin(const Progress& progress)
{
  this->BeginMesh(progress);
  if (this->State.Options.Tree) // it needs the order of the points in all chunks
  {
    this->WriteMesh(progress);
    this->BeginLevels(progress);
    this->WriteTrees(progress);
  }
  if (this->Boundary)
  {
    this->WriteBoundary(progress);
  }
}

//------------------------------------------------------------------------------
void FileWriter::Internals::BeginMesh(const Progress& progress)
{
  this->State.Describe(this->Part.Mesh);
  this->Mesh.MakeLayout(this->Part, progress);
  if (this->State.Options.Boundary)
  {
    this->Boundary = std::make_unique<Embedded<BoundaryMesh>>(Embedded<BoundaryMesh>{
      BoundaryMesh(this->Part.Mesh, this->Part.Layout), this->State.Options, nullptr });
  }
  this->Mesh.AddChunks(this->Part);
  this->Mesh.AddGroups(this->Part);
  this->State.Meta.UnusedPoints = this->Part.Layout.UnusedPoints.size();
  this->State.LinkGroups();
  this->Part.Place.Blocks = this->State.Table.Blocks.size();
  this->Part.PlaceShared(this->State.Table, this->Part.Layout.SharedPoints);
  this->Part.Layout.SharedPoints = {};
  this->FindDomains();
}

//------------------------------------------------------------------------------
void FileWriter::Internals::WriteMesh(const Progress& progress)
{
  this->Mesh.Write(this->Part, progress);
  this->IsMeshWritten = true;
}

//------------------------------------------------------------------------------
void FileWriter::Internals::FindDomains()
{
  const auto& mesh = this->Part.Mesh.GetMesh();
  PointDomain domains;
  ParallelFor(domains.size(),
    [&](std::size_t axis)
    {
      domains[axis] = FindDomain(mesh.CoordinateType, mesh.Coordinates,
        static_cast<std::size_t>(mesh.Points), 3, axis, PaletteUse::Coordinates);
    });
  this->Mesh.SetDomains(domains);
}

//------------------------------------------------------------------------------
void FileWriter::Internals::BeginLevels(const Progress& progress)
{
  const auto& options = this->State.Options;
  const auto add = [&](std::uint32_t merges)
  {
    this->Levels.push_back(this->MakeLevel(merges, progress));
    this->Merges.push_back(merges);
  };
  std::for_each(options.LevelMerges.begin(), options.LevelMerges.end(), add);
  if (!options.LevelMerges.empty())
  {
    return;
  }
  const auto countCells = [](const WriterState& state)
  { return state.Options.IsSurface ? state.NumberOfCells : state.Meta.Tets; };
  std::uint64_t cells = countCells(this->State);
  // Finer base meshes take much room, and are not read much faster than the whole mesh. Surfaces
  // are drawn as they are.
  std::uint64_t points =
    options.IsSurface ? this->State.Meta.Points : (this->State.Meta.Points + 3) / 4;
  for (unsigned i = 0; i < options.Levels && cells > SmallLevel; ++i)
  {
    points = (points + 1) / 2;
    const auto merges = static_cast<std::uint32_t>(options.Tree->CountMergesForPoints(points));
    if (merges == 0 || (!this->Merges.empty() && merges <= this->Merges.back()))
    {
      return;
    }
    add(merges);
    cells = countCells(this->Levels.back()->File->State);
  }
}

//------------------------------------------------------------------------------
/** Simplifies the mesh and writes the result, without values, to a file of its own. */
std::unique_ptr<FileWriter::Internals::Level> FileWriter::Internals::MakeLevel(
  std::uint32_t merges, const Progress& progress) const
{
  const auto& whole = this->State.Options;
  auto level =
    std::make_unique<Level>(Level{ BaseMesh(this->Part.Mesh, *whole.Tree, merges,
                                     whole.IsSurface ? PieceForm::Original : PieceForm::Tetrahedra),
      MakeLevelOptions(whole), nullptr });
  WriterOptions& options = level->Options;
  Bytes layerValues; // needed until the mesh has been written
  if (options.Layers)
  {
    const auto& array = this->State.Meta.Arrays[options.Layers->Array];
    layerValues = level->Mesh.Gather(
      options.Layers->Values, Association::Point, array.Components * SizeOf(array.Type));
    options.Layers->Values = layerValues.data();
  }
  level->File = std::make_unique<Internals>(this->State, level->Mesh.GetInput(), options);
  level->File->BeginMesh([&](double) { return !progress || progress(1); });
  level->File->WriteMesh([&](double) { return !progress || progress(1); });
  return level;
}

//------------------------------------------------------------------------------
/** Writes the boundary, without values, to a file of its own. */
void FileWriter::Internals::WriteBoundary(const Progress& progress)
{
  WriterOptions& options = this->Boundary->Options;
  if (options.Tree)
  {
    this->Boundary->Tree = this->Boundary->Mesh.MakeTree(*options.Tree);
  }
  options = MakeBoundaryOptions(
    this->State.Options, this->Boundary->Tree ? &*this->Boundary->Tree : nullptr);
  this->Boundary->File =
    std::make_unique<Internals>(this->State, this->Boundary->Mesh.GetInput(), options);
  this->Boundary->File->Begin([&](double) { return !progress || progress(1); });
}

//------------------------------------------------------------------------------
template <typename MeshT>
void FileWriter::Internals::WriteEmbeddedStep(const Embedded<MeshT>& embedded,
  std::span<const void* const> values, bool hasTime, double time,
  const std::vector<std::vector<Domain>>& domains) const
{
  std::vector<Bytes> gathered;
  std::vector<const void*> pointers;
  for (std::size_t a = 0; a < values.size(); ++a)
  {
    const auto& array = this->State.Meta.Arrays[a];
    gathered.push_back(
      embedded.Mesh.Gather(values[a], array.Where, array.Components * SizeOf(array.Type)));
    pointers.push_back(gathered.back().data());
  }
  embedded.File->WriteStep(pointers, {}, hasTime, time, {}, &domains);
}

//------------------------------------------------------------------------------
void FileWriter::Internals::WriteStep(std::span<const void* const> values, const FieldData& field,
  bool hasTime, double time, const Progress& progress,
  const std::vector<std::vector<Domain>>* rounded, const CellSubset* remaining)
{
  if (this->State.Steps.AreLarge())
  {
    this->State.Steps.Write(this->State.File, this->State.Meta);
  }
  const StepValues all{ values, &field, hasTime, time, rounded, remaining };
  if (this->State.Meta.PointsMove && !hasTime)
  {
    ThrowInvalid("points can only move in a file with time");
  }
  // Without time, no step follows that would need the chunks again.
  const bool isTogether = !this->IsMeshWritten && !hasTime;
  if (!this->IsMeshWritten && hasTime)
  {
    this->WriteMesh(progress);
  }
  const StepInput& step = isTogether
    ? this->Steps.WriteWithMesh(this->Mesh, this->Part, all, progress)
    : this->Steps.WriteValues(this->Part, all, progress);
  this->IsMeshWritten = true;
  if (this->Steps.GetCount() == 0 && this->Mesh.GetLayers())
  {
    this->CheckLayers(step.Table);
  }
  const auto arrays = step.Arrays;
  const auto domains = step.GetRounded();
  std::vector<const void*> decoded; // the values that readers will have
  for (const ArrayInput& input : arrays)
  {
    decoded.push_back(input.Now);
  }
  this->Steps.Finish(this->Part, all);
  if (this->Tree)
  {
    this->Tree->AddStep(
      [&](std::size_t array, std::size_t range) -> TreeSection::GetValue
      {
        const ArrayInput& input = arrays[array];
        const int component = range < input.Description->Components ? static_cast<int>(range) : -1;
        return [this, component, isPoints = input.IsPoints, reader = input.GetReader()](
                 std::uint32_t point)
        {
          const double value = reader.Get(this->PointOrder[point], component);
          return isPoints ? ArrayInput::Finite(value) : value;
        };
      });
    for (const auto& level : this->Levels)
    {
      this->WriteEmbeddedStep(*level, decoded, hasTime, time, domains);
    }
  }
  if (this->Boundary)
  {
    this->WriteEmbeddedStep(*this->Boundary, decoded, hasTime, time, domains);
  }
}

//------------------------------------------------------------------------------
/** Throws unless the values of the first step are those that define the layers. */
void FileWriter::Internals::CheckLayers(const StepTable& step) const
{
  const Layers& layers = this->Mesh.GetLayers()->Result;
  const auto& ranges = step.Arrays[layers.Array].ChunkRanges;
  for (std::size_t c = 0; c < ranges.size(); ++c)
  {
    if (!IsInside(layers, layers.Chunks[c], GetRange(ranges[c], layers.Component)))
    {
      ThrowInvalid("the values of array '" + this->Mesh.GetLayers()->Array.Name +
        "' differ from those that define the layers");
    }
  }
}

//------------------------------------------------------------------------------
void FileWriter::Internals::WriteTables()
{
  if (!this->IsMeshWritten)
  {
    this->WriteMesh({});
  }
  OutputFile& file = this->State.File;
  this->State.WriteTables(file);
  if (this->Mesh.GetLayers())
  {
    file.AddSection(
      SectionLayers, WriteLayers(this->Mesh.GetLayers()->Result, this->State.Meta), 0);
  }
  if (this->Tree)
  {
    this->Tree->WriteTable(this->Merges);
  }
  file.AddSection(SectionMeta, this->State.Meta.Write());
}

//------------------------------------------------------------------------------
/** Completes an embedded file and adds it. Returns its size. */
std::uint64_t FileWriter::Internals::AddEmbedded(FourCC section, Internals& embedded)
{
  embedded.Complete();
  return section == SectionGrid ? this->State.File.AddShared(section, embedded.State.File)
                                : this->State.File.AddSection(section, embedded.State.File);
}

//------------------------------------------------------------------------------
void FileWriter::Internals::Complete()
{
  if (this->Boundary)
  {
    this->State.Statistics.BoundaryBytes =
      this->AddEmbedded(SectionBoundary, *this->Boundary->File);
  }
  for (const auto& level : this->Levels) // the coarsest one is next to the tables
  {
    this->State.Statistics.LevelBytes += this->AddEmbedded(SectionLevel, *level->File);
  }
  this->EndOther();
  if (this->NumberOfMeshes > 1 || HasMasks(this->Series))
  {
    this->State.File.AddSection(SectionTime, WriteSeries(this->Series));
  }
  if (!this->IsAppending)
  {
    this->WriteTables();
  }
}

//------------------------------------------------------------------------------
FileStatistics FileWriter::Internals::Finish()
{
  this->Complete();
  return this->State.Commit(this->State.File);
}

//------------------------------------------------------------------------------
FileWriter::FileWriter(const std::string& path, const MeshInput& mesh,
  const std::vector<ArrayDescription>& arrays, const WriterOptions& options,
  const Progress& progress)
{
  CheckWriterInput(mesh, arrays, options);
  KeepFreedMemory();
  WriterOptions rounded = options;
  const auto layerValues = RoundLayerValues(mesh, arrays, rounded);
  this->Arrays = arrays;
  this->Self = std::make_unique<Internals>(path, mesh, ListArrays(arrays, mesh, options), rounded);
  this->Self->Begin(progress);
}

//------------------------------------------------------------------------------
FileWriter::FileWriter(Append, const std::string& path)
{
  const FileReader file(path);
  if (!file.HasTime())
  {
    InternalsOf(file).File.Fail(
      ErrorCode::CannotOpen, "the file has no time, so that no steps can be added");
  }
  WriterOptions options;
  options.Keep = file.GetKeptOrder();
  options.Coding = file.GetProfile();
  options.ChunkSize = InternalsOf(file).Meta.ChunkSize;
  options.KeyStepInterval = InternalsOf(file).Meta.KeyStepInterval;
  options.IsSurface = file.IsSurface();
  KeepFreedMemory();
  this->Arrays = file.GetArrays();
  this->Self = std::make_unique<Internals>(file, options);
}

//------------------------------------------------------------------------------
FileWriter::~FileWriter() = default;

//------------------------------------------------------------------------------
void FileWriter::WriteStep(std::span<const void* const> values, const FieldData& field,
  bool hasTime, double time, const Progress& progress, const void* coordinates,
  const RemainingCells* remaining)
{
  this->Self->WriteSeriesStep(values, field, hasTime, time, progress, coordinates, remaining);
}

//------------------------------------------------------------------------------
std::uint32_t FileWriter::AddMesh(
  const MeshInput& mesh, const WriterOptions& options, const Progress& progress)
{
  CheckWriterInput(mesh, this->Arrays, options);
  WriterOptions rounded = this->Self->FitOptions(options);
  const auto layerValues = RoundLayerValues(mesh, this->Arrays, rounded);
  return this->Self->AddMesh(mesh, ListArrays(this->Arrays, mesh, options), rounded, progress);
}

//------------------------------------------------------------------------------
void FileWriter::UseMesh(std::uint32_t mesh)
{
  this->Self->UseMesh(mesh);
}

//------------------------------------------------------------------------------
FileStatistics FileWriter::Finish()
{
  return this->Self->Finish();
}
}
