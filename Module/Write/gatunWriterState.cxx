// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunWriterState.h"

#include "gatunChunkMesh.h"
#include "gatunPageSection.h"
#include "gatunParallel.h"
#include "gatunSurfaceTable.h"
#include "gatunVersion.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
WriterState::WriterState(const std::string& path, const std::vector<ArrayDescription>& arrays,
  const WriterOptions& options)
  : Options(options)
  , File(path, MeshContainer)
{
  this->DescribeArrays(arrays);
}

//------------------------------------------------------------------------------
WriterState::WriterState(const InputFile& before, const WriterOptions& options)
  : Options(options)
  , File(before, SectionTime)
{
  this->Statistics.OtherMeshBytes = this->File.GetSize();
}

//------------------------------------------------------------------------------
WriterState::WriterState(const std::vector<ArrayDescription>& arrays, const WriterOptions& options,
  const std::string& folder)
  : Options(options)
  , File(folder)
{
  this->DescribeArrays(arrays);
}

//------------------------------------------------------------------------------
WriterState::WriterState(const WriterState& whole, const std::vector<ArrayDescription>& arrays,
  const WriterOptions& options)
  : Options(options)
  , File(OutputFile::Embedded(), whole.File)
{
  this->DescribeArrays(arrays);
}

//------------------------------------------------------------------------------
void WriterState::DescribeArrays(const std::vector<ArrayDescription>& arrays)
{
  this->Meta.WriterVersion = PackageVersion();
  this->Meta.WideIds = false;
  this->Meta.Keep = this->Options.Keep;
  this->Meta.Coding = this->Options.Coding;
  this->Meta.KeyStepInterval = this->Options.KeyStepInterval;
  this->Meta.PointsMove = this->Options.PointsMove;
  this->Meta.Arrays = arrays;
  this->Statistics.ArrayBytes.resize(arrays.size());
}

//------------------------------------------------------------------------------
void WriterState::Describe(const MeshAccess& part)
{
  const MeshInput& mesh = part.GetMesh();
  if (this->Meta.ChunkSize != 0 && mesh.CoordinateType != this->Meta.CoordinateType)
  {
    ThrowInvalid("parts have coordinates of different types");
  }
  if (this->Meta.Points == 0)
  {
    this->Meta.PointArray = mesh.PointArray;
  }
  this->Meta.CoordinateType = mesh.CoordinateType;
  this->Meta.WideIds = this->Meta.WideIds || mesh.WideIds;
  this->Meta.Points += mesh.Points;
  this->Meta.ChunkSize = std::max(this->Meta.ChunkSize, this->GetChunkLimits(part).Size);
  this->HasCells = this->HasCells || !part.IsTetrahedral();
  this->NumberOfCells += mesh.Cells;
}

//------------------------------------------------------------------------------
ChunkLimits WriterState::GetChunkLimits(const MeshAccess& part) const
{
  const bool isFast = this->Options.Coding == Profile::Fast;
  ChunkLimits limits{ this->Options.ChunkSize, isFast ? MaxFastVertices : 0 };
  if (limits.Size == 0)
  {
    const auto number = isFast ? part.GetMesh().Cells : part.EstimateTets();
    limits.Size = GetDefaultChunkSize(
      number * std::uint64_t{ this->Options.Parts }, this->Options.Layers.has_value());
  }
  return limits;
}

//------------------------------------------------------------------------------
void WriterState::LinkGroups()
{
  this->Table.Blocks = this->Groups.MakeBlocks();
  this->Groups = {};
  this->Table.Unused.Points = this->Meta.UnusedPoints;
  if (this->Meta.UnusedPoints >= std::uint64_t{ 1 } << 32)
  {
    ThrowInvalid("more than 2^32 points belong to no cell");
  }
  try
  {
    this->Table.LinkGroups();
  }
  catch (const Error& error)
  {
    ThrowInvalid(error.what() + std::string("; make chunks larger"));
  }
  if (this->HasCells)
  {
    for (std::size_t type = 0; type < this->TypeCounts.size(); ++type)
    {
      if (this->TypeCounts[type] > 0)
      {
        this->Cells.Types.push_back({ static_cast<std::uint8_t>(type), this->TypeCounts[type] });
      }
    }
    this->Cells.SetShapes(this->Shapes.Write());
    this->Shapes = {};
  }
}

//------------------------------------------------------------------------------
void WriterState::WriteTables(OutputFile& file)
{
  this->Steps.Write(file, this->Meta);
  if (this->HasCells)
  {
    file.AddSection(SectionCells, this->Cells.Write());
  }
  if (this->Options.IsSurface)
  {
    file.AddSection(SectionSurface, WriteSurfaceMark(), 0);
  }
  const auto keep = this->Options.Keep;
  auto index = MakeMeshIndex(this->Table);
  PageSection pages(file);
  WriteMeshPages(index, this->Table, keep, [&](const Bytes& page) { return pages.Put(page); });
  pages.Write();
  file.AddSection(SectionTable, index.Write(keep));
}

//------------------------------------------------------------------------------
void WriterState::AddStep(const StepTable& step)
{
  this->Steps.Add(step, this->Meta, MakeMeshIndex(this->Table));
}

//------------------------------------------------------------------------------
FileStatistics WriterState::Commit(OutputFile& file)
{
  FileStatistics& s = this->Statistics;
  s.SplitPoints(this->Meta.PointsMove);
  s.FileBytes = file.Commit();
  s.DirectoryBytes = s.FileBytes - s.ConnectivityBytes - s.GeometryBytes - s.SharedGeometryBytes -
    s.OrderBytes - s.FieldDataBytes - s.TreeBytes - s.DependencyBytes - s.LevelBytes -
    s.BoundaryBytes - s.OtherMeshBytes - s.MotionBytes;
  for (const auto bytes : s.ArrayBytes)
  {
    s.DirectoryBytes -= bytes;
  }
  return s;
}

//------------------------------------------------------------------------------
void ForEachBatch(std::size_t chunks, const std::function<void(std::size_t)>& encode,
  const std::function<void(std::size_t, std::size_t)>& finish,
  const std::function<bool(double)>& progress)
{
  for (std::size_t first = 0; first < chunks; first += ChunksPerBatch)
  {
    const auto count = std::min(ChunksPerBatch, chunks - first);
    ParallelFor(
      count, [&](std::size_t i) { encode(first + i); },
      [&](double done)
      {
        return !progress ||
          progress((static_cast<double>(first) + done * static_cast<double>(count)) /
            static_cast<double>(chunks));
      });
    finish(first, count);
  }
}
}
