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

namespace gatun
{
//------------------------------------------------------------------------------
FileReader::Internals::Internals(const std::string& path)
  : File(path)
{
  this->Read();
}

FileReader::Internals::Internals(const Internals& whole, std::size_t level)
  : File(whole.File, whole.Levels.at(level), GetLevelName(level))
{
  this->Read();
  this->CheckLevel(whole, level);
}

void FileReader::Internals::Read()
{
  constexpr const char* metaName = "the meta data";
  constexpr const char* meshName = "the table of chunks";
  constexpr const char* stepName = "the table of a time step";
  const auto meta = this->File.FindSection(SectionMeta, metaName);
  this->Meta =
    this->Guarded(metaName, meta, [&] { return MetaTable::Read(this->File.Read(meta, metaName)); });
  this->ReadCells();
  const auto mesh = this->File.FindSection(SectionTable, meshName);
  this->Mesh = this->Guarded(meshName, mesh,
    [&]
    {
      auto table = MeshTable::Read(
        this->File.Read(mesh, meshName), this->Meta, this->Cells ? &*this->Cells : nullptr);
      table.CheckLengths(this->File.GetSize());
      return table;
    });
  this->CountCells();
  this->ReadSurface();
  for (const auto& step : this->File.FindSections(SectionStep))
  {
    this->Steps.push_back(this->Guarded(stepName, step,
      [&]
      {
        const auto bytes = this->File.Read(step, stepName);
        this->AddStepBytes(bytes);
        return StepTable::Read(bytes, this->Meta, this->Mesh);
      }));
    this->Times.push_back(this->Steps.back().Time);
    this->CheckLastStep();
  }
  for (const auto& chunk : this->Mesh.Chunks)
  {
    this->Chunks.push_back(chunk.Info);
  }
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const auto& ref = this->Mesh.Palettes[axis];
    std::shared_ptr<const Palette> palette;
    if (ref.Count > 0)
    {
      palette = this->Guarded("the palette of the coordinates", ref.Stream,
        [&]
        {
          return DecodePalette(this->Meta.CoordinateType,
            this->File.Read(ref.Stream, "the palette of the coordinates"), ref.Count);
        });
    }
    this->Domains[axis] = Domain(this->Meta.CoordinateType, palette);
  }
  this->ReadLayers();
  this->ReadTree();
}

/** Reads the types and sizes of cells, if not all are tetrahedra. */
void FileReader::Internals::ReadCells()
{
  constexpr const char* cellsName = "the table of cells";
  if (!this->File.FindSections(SectionCells).empty())
  {
    const auto where = this->File.FindSection(SectionCells, cellsName);
    this->Cells = this->Guarded(
      cellsName, where, [&] { return CellTable::Read(this->File.Read(where, cellsName)); });
  }
}

void FileReader::Internals::CountCells()
{
  const auto cells = this->Mesh.GetNumberOfCells();
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
    this->Guarded(surfaceName, where,
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
    return; // StepTable::Read refuses it
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
  const auto count = this->Steps.size();
  if (count > 1 && !this->Meta.HasTime)
  {
    fail("there are several time steps, but the file says that it has no time");
  }
  if (!this->Steps.front().Key)
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
  std::vector<Domain> domains;
  for (const auto& ref : this->Steps[step].Arrays[array].Palettes)
  {
    std::shared_ptr<const Palette> palette;
    if (ref.Count > 0)
    {
      const std::string what = "the palette of array '" + description.Name + "'";
      palette = this->Guarded(what, ref.Stream,
        [&]
        { return DecodePalette(description.Type, this->File.Read(ref.Stream, what), ref.Count); });
    }
    domains.emplace_back(description.Type, palette);
  }
  return domains;
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
  : Self(std::make_unique<Internals>(path))
{
  KeepFreedMemory();
}

FileReader::FileReader(const FileReader& whole, std::size_t level)
  : Self(std::make_unique<Internals>(*whole.Self, level))
{
}

FileReader::~FileReader() = default;

const std::string& FileReader::GetPath() const
{
  return this->Self->File.GetPath();
}

std::uint64_t FileReader::GetNumberOfPoints() const
{
  return this->Self->Meta.Points;
}

std::uint64_t FileReader::GetNumberOfCells() const
{
  return this->Self->Mesh.GetNumberOfCells();
}

//------------------------------------------------------------------------------
std::uint64_t FileReader::GetNumberOfTets() const
{
  return this->Self->Meta.Tets;
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
  return this->Self->CellTypes;
}

std::uint64_t FileReader::GetNumberOfSharedPoints() const
{
  return this->Self->Mesh.GetSharedPoints();
}

std::uint64_t FileReader::GetNumberOfUnusedPoints() const
{
  return this->Self->Meta.UnusedPoints;
}

ScalarType FileReader::GetCoordinateType() const
{
  return this->Self->Meta.CoordinateType;
}

bool FileReader::HasWideIds() const
{
  return this->Self->Meta.WideIds;
}

std::uint8_t FileReader::GetKeptOrder() const
{
  return this->Self->Meta.Keep;
}

const Bounds& FileReader::GetBounds() const
{
  return this->Self->Meta.Box;
}

const std::string& FileReader::GetWriterVersion() const
{
  return this->Self->Meta.WriterVersion;
}

std::pair<int, int> FileReader::GetFormatVersion() const
{
  return { this->Self->File.GetMajor(), this->Self->File.GetMinor() };
}

const std::vector<ArrayDescription>& FileReader::GetArrays() const
{
  return this->Self->Meta.Arrays;
}

std::size_t FileReader::GetNumberOfSteps() const
{
  return this->Self->Steps.size();
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
  return this->Self->Chunks;
}

const ArrayRanges& FileReader::GetRanges(std::size_t array, std::size_t step) const
{
  return this->Self->Steps.at(step).Arrays.at(array).Ranges;
}

const ArrayRanges& FileReader::GetChunkRanges(
  std::size_t array, std::size_t step, std::size_t chunk) const
{
  return this->Self->Steps.at(step).Arrays.at(array).ChunkRanges.at(chunk);
}

FieldData FileReader::GetFieldData(std::size_t step) const
{
  const auto& where = this->Self->Steps.at(step).Field;
  if (where.Length == 0)
  {
    return {};
  }
  return this->Self->Guarded("the field data", where,
    [&] { return ReadFieldData(this->Self->File.Read(where, "the field data")); });
}

FileStatistics FileReader::GetStatistics() const
{
  FileStatistics s;
  s.FileBytes = this->Self->File.GetSize();
  const auto& mesh = this->Self->Mesh;
  for (const auto& palette : mesh.Palettes)
  {
    s.SharedGeometryBytes += palette.Stream.Length;
  }
  const auto addBlock = [&](const BlockEntry& block)
  {
    s.SharedGeometryBytes += block.Geometry.Length;
    s.OrderBytes += block.Order.Length;
  };
  std::for_each(mesh.Blocks.begin(), mesh.Blocks.end(), addBlock);
  addBlock(mesh.Unused);
  for (const auto& chunk : mesh.Chunks)
  {
    s.ConnectivityBytes += chunk.Connectivity.Length;
    s.GeometryBytes += chunk.Geometry.Length;
    s.OrderBytes += chunk.PointOrder.Length + chunk.CellOrder.Length + chunk.Corners.Length;
  }
  s.ArrayBytes.resize(this->GetArrays().size());
  std::uint64_t arrays = 0;
  std::uint64_t lastField = 0;
  for (const auto& step : this->Self->Steps)
  {
    // Steps may share their field data.
    s.FieldDataBytes += step.Field.Offset != lastField ? step.Field.Length : 0;
    lastField = step.Field.Offset;
    for (std::size_t a = 0; a < step.Arrays.size(); ++a)
    {
      std::uint64_t bytes = 0;
      for (const auto& palette : step.Arrays[a].Palettes)
      {
        bytes += palette.Stream.Length;
      }
      for (const auto* list : { &step.Arrays[a].Chunks, &step.Arrays[a].Blocks })
      {
        for (const auto& stream : *list)
        {
          bytes += stream.Length;
        }
      }
      s.ArrayBytes[a] += bytes;
      arrays += bytes;
    }
  }
  for (const auto& section : this->Self->File.GetSections())
  {
    const auto name = section.Name;
    s.TreeBytes += name == SectionTree || name == SectionMerges || name == SectionTreeStep
      ? section.Payload.Length
      : 0;
    s.LevelBytes += name == SectionLevel ? section.Payload.Length : 0;
  }
  const auto parts = s.TreeBytes + s.LevelBytes + s.ConnectivityBytes + s.GeometryBytes +
    s.SharedGeometryBytes + s.OrderBytes + s.FieldDataBytes + arrays;
  s.DirectoryBytes = s.FileBytes - std::min(parts, s.FileBytes);
  return s;
}

std::uint64_t FileReader::GetChunkMeshBytes(std::size_t chunk) const
{
  const auto& entry = this->Self->Mesh.Chunks.at(chunk);
  return entry.Connectivity.Length + entry.Geometry.Length;
}

std::uint64_t FileReader::GetChunkArrayBytes(
  std::size_t chunk, std::size_t array, std::size_t step) const
{
  return this->Self->Steps.at(step).Arrays.at(array).Chunks.at(chunk).Length;
}

std::uint64_t FileReader::GetBytesRead() const
{
  return this->Self->File.GetBytesRead();
}
}
