// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFileReader.h"

#include "gatunCellSplitter.h"
#include "gatunFileReaderInternals.h"
#include "gatunKeepMemory.h"
#include "gatunPalette.h"
#include "gatunSurfaceTable.h"
#include "gatunTableParts.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace gatun
{
//------------------------------------------------------------------------------
FileReader::Internals::Internals(std::shared_ptr<const ByteSource> source, const std::string& name)
  : File(std::move(source), name)
{
  this->Read();
  this->RequireMerges();
  if (!this->Masks.empty() && this->Series.empty())
  {
    this->File.Fail(ErrorCode::Corrupt, "it does not say which time steps have some cells only");
  }
}

FileReader::Internals::Internals(
  const Internals& whole, const StreamRef& embedded, const std::string& name)
  : File(whole.File, embedded, name)
{
  this->Read();
  if (!this->Series.empty())
  {
    this->File.Fail(ErrorCode::Corrupt, "it is part of a file, and has several meshes");
  }
}

FileReader::Internals::Internals(std::shared_ptr<const Internals> whole, std::size_t level)
  : Internals(*whole, whole->Levels.at(level), GetLevelName(level))
{
  this->CheckLevel(*whole, level);
  this->Whole = std::move(whole);
  this->Part = level + 1;
}

FileReader::Internals::Internals(const Internals& whole, const StreamRef& boundary)
  : Internals(whole, boundary, BoundaryName)
{
  this->RequireMerges();
  this->CheckBoundary(whole);
}

//------------------------------------------------------------------------------
void FileReader::Internals::Read()
{
  constexpr std::array names{ SectionMeta, SectionCells, SectionTable, SectionSurface, SectionStep,
    SectionLayers, SectionTree, SectionTreeStep, SectionTime };
  std::vector<StreamRef> tables;
  for (const auto& section : this->File.GetSections())
  {
    if (std::find(names.begin(), names.end(), section.Name) != names.end())
    {
      tables.push_back(section.Payload);
    }
  }
  this->File.ReadTogether(tables, [this] { this->ReadTables(); });
}

//------------------------------------------------------------------------------
MetaTable FileReader::Internals::ReadMeta(const InputFile& file)
{
  constexpr const char* metaName = "the meta data";
  const auto meta = file.FindSection(SectionMeta, metaName);
  return file.Guarded(metaName, meta, [&] { return MetaTable::Read(file.Read(meta, metaName)); });
}

//------------------------------------------------------------------------------
void FileReader::Internals::ReadTables()
{
  constexpr const char* stepName = "the table of a time step";
  this->Meta = ReadMeta(this->File);
  const auto end =
    this->Meta.Arrays.begin() + static_cast<std::ptrdiff_t>(this->Meta.GetListedArrays());
  this->ListedArrays.assign(this->Meta.Arrays.begin(), end);
  this->Cells = ReadCells(this->File);
  this->Tables.emplace(this->File, this->Meta, this->Cells ? &*this->Cells : nullptr);
  this->CountCells();
  this->ReadSurface();
  for (const auto& step : this->File.FindSections(SectionStep))
  {
    const auto bytes = this->File.Read(step, stepName);
    this->File.Guarded(stepName, step, [&] { this->AddStepBytes(bytes); });
    this->Tables->AddStep(step, bytes);
    this->Times.push_back(this->GetSteps().back().Time);
    this->CheckLastStep();
  }
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    this->Domains[axis] = this->MakeDomain(this->Meta.CoordinateType,
      this->GetTables().GetIndex().Palettes[axis], "the palette of the coordinates");
  }
  this->ReadLayers();
  this->ReadTree();
  this->ReadBoundary();
  this->ReadSeries();
}

//------------------------------------------------------------------------------
/** Reads the types and sizes of cells, if not all are tetrahedra. */
std::optional<CellTable> FileReader::Internals::ReadCells(const InputFile& file)
{
  constexpr const char* cellsName = "the table of cells";
  if (file.FindSections(SectionCells).empty())
  {
    return std::nullopt;
  }
  const auto where = file.FindSection(SectionCells, cellsName);
  return file.Guarded(
    cellsName, where, [&] { return CellTable::Read(file.Read(where, cellsName)); });
}

//------------------------------------------------------------------------------
MeshCounts FileReader::Internals::Count(
  const Internals& whole, const StreamRef& embedded, const std::string& name)
{
  const InputFile file(whole.File, embedded, name);
  const auto meta = ReadMeta(file);
  MeshCounts counts{ meta.Points, meta.Tets, meta.Tets };
  if (const auto cells = ReadCells(file))
  {
    counts.Cells = std::accumulate(cells->Types.begin(), cells->Types.end(), std::uint64_t{ 0 },
      [](std::uint64_t sum, const CellTypeCount& type) { return sum + type.Cells; });
  }
  return counts;
}

//------------------------------------------------------------------------------

void FileReader::Internals::CountCells()
{
  const auto cells = this->GetTables().GetNumberOfCells();
  if (!this->Cells)
  {
    if (cells > 0)
    {
      this->CellTypes.push_back({ TetraType, cells });
    }
    return;
  }
  std::uint64_t sum = 0;
  for (const auto& type : this->Cells->Types)
  {
    sum += type.Cells;
  }
  if (sum != cells)
  {
    this->File.Fail(ErrorCode::Corrupt, "the types of cells do not add up to the mesh's cells");
  }
  this->CellTypes = std::move(this->Cells->Types);
}

//------------------------------------------------------------------------------
void FileReader::Internals::ReadSurface()
{
  constexpr const char* surfaceName = "the mark of surfaces";
  this->IsSurface = !this->File.FindSections(SectionSurface).empty();
  if (this->IsSurface)
  {
    const auto where = this->File.FindSection(SectionSurface, surfaceName);
    this->File.Guarded(surfaceName, where,
      [&] { CheckSurfaceMark(this->File.Read(where, surfaceName), this->CellTypes); });
  }
}

//------------------------------------------------------------------------------
/** Adds the unpacked size of a step's table, before memory is taken for it. The expansion of one
 * table may be large, but not that of all of them. */
void FileReader::Internals::AddStepBytes(std::span<const std::uint8_t> packed)
{
  const auto size = ByteReader(packed).GetVarint();
  if (size > std::max(SmallStep, TableExpansion * packed.size()))
  {
    return; // StepIndex::Read refuses it
  }
  const auto most = std::max(SmallStep, TableExpansion * this->File.GetSize());
  if (size > most - this->StepBytes)
  {
    ThrowCorrupt("the tables of the time steps are too large for such a file");
  }
  this->StepBytes += size;
}

void FileReader::Internals::CheckLastStep() const
{
  // Checked for each step, so that a table that is listed many times is not read many times.
  const auto fail = [&](const char* what) { this->File.Fail(ErrorCode::Corrupt, what); };
  const auto count = this->GetSteps().size();
  if (count > 1 && !this->Meta.HasTime)
  {
    fail("there are several time steps, but the file says that it has no time");
  }
  if (!this->GetSteps().front().Key)
  {
    fail("the first time step needs one before it");
  }
  if (count > 1 && !(this->Times[count - 1] > this->Times[count - 2]))
  {
    fail("the times of the steps do not ascend");
  }
}

std::vector<Domain> FileReader::Internals::MakeDomains(std::size_t array, std::size_t step) const
{
  const auto& description = this->Meta.Arrays[array];
  std::vector<Domain> domains(description.Components, Domain(description.Type));
  for (const auto& [component, ref] : this->GetSteps()[step].Arrays[array].Palettes)
  {
    domains[component] =
      this->MakeDomain(description.Type, ref, "the palette of array '" + description.Name + "'");
  }
  return domains;
}

FileReader::Internals::ArraySource FileReader::Internals::FindSource(
  std::uint32_t array, std::size_t step) const
{
  const auto& entry = this->GetSteps()[step].Arrays[array];
  ArraySource source{ array, std::vector<std::uint32_t>(entry.Components) };
  std::iota(source.Components.begin(), source.Components.end(), 0u);
  if (entry.IsCopy())
  {
    source.Array = static_cast<std::uint32_t>(this->GetSteps()[step].GetSource(array));
    std::transform(entry.Palettes.begin(), entry.Palettes.end(), source.Components.begin(),
      [](const auto& component) { return component.second.SourceComponent; });
  }
  return source;
}

Domain FileReader::Internals::MakeDomain(
  ScalarType type, const PaletteRef& palette, const std::string& what) const
{
  if (palette.Rounding)
  {
    return Domain(type, palette.Rounding);
  }
  if (palette.Count == 0)
  {
    return Domain(type, palette.Steps);
  }
  return Domain(type,
    this->File.Guarded(what, palette.Stream,
      [&] { return DecodePalette(type, this->File.Read(palette.Stream, what), palette.Count); }));
}

//------------------------------------------------------------------------------
bool FileReader::CanRead(const std::string& path) noexcept
{
  return BeginsAs(path, MeshContainer);
}

//------------------------------------------------------------------------------
bool FileReader::IsSurfaceFile(const std::string& path) noexcept
{
  try
  {
    return CanRead(path) && !InputFile(path).FindSections(SectionSurface).empty();
  }
  catch (...)
  {
    return false; // opening the file reports what is wrong
  }
}

FileReader::FileReader(const std::string& path)
  : FileReader(OpenFile(path), path)
{
}

FileReader::FileReader(std::shared_ptr<const ByteSource> source, const std::string& name)
  : Self(std::make_shared<const Internals>(std::move(source), name))
{
  KeepFreedMemory();
}

FileReader::FileReader(std::shared_ptr<const Internals> self)
  : Self(std::move(self))
{
}

FileReader::~FileReader() = default;

const std::string& FileReader::GetPath() const
{
  return this->Self->File.GetPath();
}

std::uint64_t FileReader::GetNumberOfPoints() const
{
  return this->Remaining ? this->Remaining->Points : this->Self->Meta.Points;
}

std::uint64_t FileReader::GetNumberOfCells() const
{
  return this->Remaining ? this->Remaining->Cells : this->Self->GetTables().GetNumberOfCells();
}

//------------------------------------------------------------------------------
std::uint64_t FileReader::GetNumberOfTets() const
{
  return this->Remaining ? this->MaskedTets : this->Self->Meta.Tets;
}

//------------------------------------------------------------------------------
bool FileReader::IsTetrahedral() const
{
  return !this->Self->Cells;
}

//------------------------------------------------------------------------------
bool FileReader::IsSurface() const
{
  return this->Self->IsSurface;
}

//------------------------------------------------------------------------------
const std::vector<CellTypeCount>& FileReader::GetCellTypes() const
{
  return this->Remaining ? this->Remaining->Types : this->Self->CellTypes;
}

std::uint64_t FileReader::GetNumberOfSharedPoints() const
{
  return this->Self->GetTables().GetSharedPoints();
}

std::uint64_t FileReader::GetNumberOfUnusedPoints() const
{
  return this->Self->Meta.UnusedPoints;
}

ScalarType FileReader::GetCoordinateType() const
{
  return this->Self->Meta.CoordinateType;
}

const PointsDescription& FileReader::GetPointArray() const
{
  return this->Self->Meta.PointArray;
}

bool FileReader::HasWideIds() const
{
  return this->Self->Meta.WideIds;
}

std::uint8_t FileReader::GetKeptOrder() const
{
  return this->Self->Meta.Keep;
}

Profile FileReader::GetProfile() const
{
  return this->Self->Meta.Coding;
}

const Bounds& FileReader::GetBounds() const
{
  return this->Self->Meta.Box;
}

bool FileReader::HasMovingPoints() const
{
  return this->Self->Meta.PointsMove;
}

//------------------------------------------------------------------------------
namespace
{
Bounds ToBounds(const ArrayRanges& ranges)
{
  return { ranges[0], ranges[1], ranges[2] };
}
}

//------------------------------------------------------------------------------
std::size_t FileReader::GetPointStep(std::size_t step) const
{
  return step < this->GetNumberOfSteps() ? this->Self->GetTables().GetPointStep(step) : 0;
}

//------------------------------------------------------------------------------
Bounds FileReader::GetBounds(std::size_t step) const
{
  return this->HasMovingPoints() && step > 0 && step < this->GetNumberOfSteps()
    ? ToBounds(this->Self->GetSteps()[step].Arrays.back().Ranges)
    : this->GetBounds();
}

//------------------------------------------------------------------------------
Bounds FileReader::GetChunkBounds(std::size_t chunk, std::size_t merges, std::size_t step) const
{
  if (!this->HasMovingPoints() || step == 0 || step >= this->GetNumberOfSteps())
  {
    return this->GetChunkBounds(chunk, merges);
  }
  return ToBounds(this->GetRangesAfter(this->Self->GetPointArray(), step, chunk, merges));
}

//------------------------------------------------------------------------------
const std::string& FileReader::GetWriterVersion() const
{
  return this->Self->Meta.WriterVersion;
}

std::uint32_t FileReader::GetFormatVersion() const
{
  return this->Self->File.GetVersion();
}

const std::vector<ArrayDescription>& FileReader::GetArrays() const
{
  return this->Self->ListedArrays;
}

std::size_t FileReader::GetNumberOfSteps() const
{
  return this->Self->GetSteps().size();
}

bool FileReader::HasTime() const
{
  return this->Self->Meta.HasTime;
}

const std::vector<double>& FileReader::GetTimes() const
{
  return this->Self->Times;
}

const std::vector<ChunkInfo>& FileReader::GetChunks() const
{
  return this->Remaining ? this->MaskedChunks : this->Self->GetTables().GetChunks();
}

const ArrayRanges& FileReader::GetRanges(std::size_t array, std::size_t step) const
{
  return this->Self->GetSteps().at(step).Arrays.at(array).Ranges;
}

Quantizer FileReader::GetRounding(std::size_t array, std::size_t component, std::size_t step) const
{
  const auto source = this->Self->FindSource(static_cast<std::uint32_t>(array), step);
  const auto wanted = source.Components.at(component);
  for (const auto& [c, palette] : this->Self->GetSteps().at(step).Arrays.at(source.Array).Palettes)
  {
    if (c == wanted)
    {
      return palette.Rounding;
    }
  }
  return {};
}

std::vector<std::uint32_t> FileReader::GetNeighbors(std::size_t chunk) const
{
  return this->Self->GetTables().GetNeighbors(chunk);
}

ArrayRanges FileReader::GetChunkRanges(std::size_t array, std::size_t step, std::size_t chunk) const
{
  return this->Self->GetTables().GetChunkRanges(chunk, array, step);
}

FieldData FileReader::GetFieldData(std::size_t step) const
{
  const auto& where = this->Self->GetSteps().at(step).Field;
  if (where.Length == 0)
  {
    return {};
  }
  return this->Self->File.Guarded("the field data", where,
    [&] { return ReadFieldData(this->Self->File.Read(where, "the field data")); });
}

FileStatistics FileReader::GetStatistics() const
{
  FileStatistics s;
  s.FileBytes = this->Self->File.GetSize();
  this->Self->GetTables().AddBytes(s);
  s.SplitPoints(this->Self->Meta.PointsMove);
  for (const auto& section : this->Self->File.GetSections())
  {
    const auto name = section.Name;
    s.TreeBytes += name == SectionTree || name == SectionMerges || name == SectionTreeStep
      ? section.Payload.Length
      : 0;
    s.DependencyBytes += name == SectionDependencies ? section.Payload.Length : 0;
    s.LevelBytes += name == SectionLevel ? section.Payload.Length : 0;
    s.BoundaryBytes += name == SectionBoundary ? section.Payload.Length : 0;
    s.OtherMeshBytes += name == SectionGrid ? section.Payload.Length : 0;
  }
  auto parts = s.TreeBytes + s.DependencyBytes + s.LevelBytes + s.BoundaryBytes + s.OtherMeshBytes +
    s.ConnectivityBytes + s.GeometryBytes + s.SharedGeometryBytes + s.OrderBytes +
    s.FieldDataBytes + s.MotionBytes;
  parts = std::accumulate(s.ArrayBytes.begin(), s.ArrayBytes.end(), parts);
  s.DirectoryBytes = s.FileBytes - std::min(parts, s.FileBytes);
  return s;
}

//------------------------------------------------------------------------------
void FileReader::AnnounceDescription() const
{
  auto streams = this->Self->GetTables().ListPages();
  const auto add = [&](const StreamRef& mesh) { InputFile::AddEnds(mesh, streams); };
  std::for_each(this->Self->Levels.begin(), this->Self->Levels.end(), add);
  std::for_each(this->Self->Meshes.begin(), this->Self->Meshes.end(), add);
  if (this->HasBoundary())
  {
    add(*this->Self->Boundary);
  }
  this->Self->File.Announce(streams);
}

//------------------------------------------------------------------------------
std::uint64_t FileReader::GetChunkMeshBytes(std::size_t chunk) const
{
  return this->Self->GetTables().GetMeshBytes(chunk);
}

std::uint64_t FileReader::GetChunkArrayBytes(
  std::size_t chunk, std::size_t array, std::size_t step) const
{
  return this->Self->GetTables().GetChunkValues(chunk, array, step).Length;
}

std::uint64_t FileReader::GetBytesRead() const
{
  return this->Self->File.GetBytesRead();
}
}
