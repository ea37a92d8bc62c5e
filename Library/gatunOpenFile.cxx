// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunOpenFile.h"

#include "gatunChunkCache.h"
#include "gatunHartleyFile.h"
#include "gatunMeshDescription.h"
#include "gatunSimplifyTarget.h"
#include "gatunVerifyFile.h"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace gatun;

//------------------------------------------------------------------------------
gatun_file::gatun_file(std::shared_ptr<const FileReader> file, std::uint64_t cacheBytes)
  : Shared(std::make_shared<SharedFile>(
      std::move(file), cacheBytes > 0 ? cacheBytes : ChunkCache::DefaultBudget))
{
  for (const auto& array : this->GetFile().GetArrays())
  {
    this->ComponentNames.emplace_back(array.ComponentNames);
    this->Keys.emplace_back(array.Keys);
  }
  this->ComponentNames.emplace_back(this->GetFile().GetPointArray().ComponentNames);
  this->Keys.emplace_back(this->GetFile().GetPointArray().Keys);
}

//------------------------------------------------------------------------------
std::size_t gatun_file::CountSteps() const
{
  const auto& file = this->GetFile();
  return file.GetSeries().empty() ? file.GetNumberOfSteps() : file.GetSeries().size();
}

//------------------------------------------------------------------------------
gatun_file::Place gatun_file::Find(std::uint64_t step) const
{
  Need(step < std::max<std::size_t>(this->CountSteps(), 1), "there is no such time step");
  const auto& file = this->GetFile();
  const auto number = static_cast<std::size_t>(step);
  if (file.GetSeries().empty())
  {
    return { this->Shared, number, 0, file.HasTime() ? file.GetTimes()[number] : 0 };
  }
  const auto& entry = file.GetSeries()[number];
  const auto mesh = entry.Mesh == 0 ? this->Shared : this->Shared->GetMesh(entry.Mesh);
  // A mesh with some cells of another one has the steps of that.
  const auto& times = mesh->GetFile()->GetTimes();
  const auto next = std::upper_bound(times.begin(), times.end(), entry.Time);
  const auto own = std::max<std::ptrdiff_t>(next - times.begin() - 1, 0);
  return { mesh, static_cast<std::size_t>(own), entry.Mesh, entry.Time };
}

//------------------------------------------------------------------------------
SharedFile::Place gatun_file::Simplify(SharedFile& mesh, std::uint32_t level, double ratio)
{
  Need(level == 0 || ratio == 0, "there is either a level or a ratio");
  const auto& file = *mesh.GetFile();
  if (level > 0)
  {
    Need(level < mesh.GetNumberOfLevels(), "there is no such level");
    auto place = mesh.GetLevel(level);
    place.Merges = 0;
    return place;
  }
  if (ratio == 0)
  {
    return { mesh.GetFile(), nullptr, 0 };
  }
  mesh.RequireHierarchy();
  return mesh.Find(CountMerges({ SimplifyTarget::Ratio, ratio }, file.GetNumberOfPoints(),
    file.GetNumberOfMerges(), [&mesh]() -> const MergeTree& { return mesh.GetTree(); }));
}

//------------------------------------------------------------------------------
gatun_kind gatun_kind_of(const char* path)
{
  gatun_kind kind = GATUN_KIND_NONE;
  Guard(
    [&]
    {
      NeedPointers(path);
      const std::string name(path);
      kind = FileReader::IsSurfaceFile(name) ? GATUN_KIND_SURFACE
        : FileReader::CanRead(name)          ? GATUN_KIND_MESH
        : HartleyFile::CanRead(name)         ? GATUN_KIND_VOLUME
                                             : GATUN_KIND_NONE;
    });
  return kind;
}

gatun_status gatun_open(const char* path, uint64_t cache_bytes, gatun_file** file)
{
  return Guard(
    [&]
    {
      NeedPointers(path, file);
      *file = std::make_unique<gatun_file>(
        std::make_shared<const FileReader>(std::string(path)), cache_bytes)
                .release();
    });
}

gatun_status gatun_open_source(const gatun_source* source, uint64_t cache_bytes, gatun_file** file)
{
  return Guard(
    [&]
    {
      NeedPointers(source, file);
      std::string name;
      auto bytes = WrapSource(source, name);
      *file = std::make_unique<gatun_file>(
        std::make_shared<const FileReader>(std::move(bytes), name), cache_bytes)
                .release();
    });
}

void gatun_close(gatun_file* file)
{
  delete file;
}

//------------------------------------------------------------------------------
gatun_status gatun_get_info(gatun_file* file, gatun_info* info)
{
  return Guard(
    [&]
    {
      NeedPointers(file, info);
      const auto& from = file->GetFile();
      gatun_info own{};
      own.points = from.GetNumberOfPoints();
      own.cells = from.GetNumberOfCells();
      own.tets = from.GetNumberOfTets();
      GiveBounds(from.GetBounds(), own.bounds);
      own.coordinate_type = static_cast<gatun_type>(from.GetCoordinateType());
      own.arrays = static_cast<std::uint32_t>(from.GetArrays().size());
      own.steps = static_cast<std::uint32_t>(file->CountSteps());
      own.meshes = static_cast<std::uint32_t>(from.GetNumberOfMeshes());
      own.levels = static_cast<std::uint32_t>(from.GetLevels().size());
      own.chunks = static_cast<std::uint32_t>(from.GetChunks().size());
      own.kept_order = from.GetKeptOrder();
      own.is_surface = from.IsSurface();
      own.is_tetrahedral = from.IsTetrahedral();
      own.has_time = from.HasTime();
      own.has_hierarchy = from.HasMergeTree();
      own.has_boundary = from.HasBoundary();
      own.has_wide_ids = from.HasWideIds();
      own.points_move = from.HasMovingPoints();
      own.format_version = from.GetFormatVersion();
      own.writer_version = from.GetWriterVersion().c_str();
      own.bytes_read = file->Shared->GetBytesRead();
      Give(own, info);
    });
}

gatun_status gatun_describe(
  gatun_file* file, int verbose, char* text, size_t capacity, size_t* length)
{
  return Guard(
    [&]
    {
      NeedPointers(file, length);
      GiveText(
        WriteJson(DescribeMesh(file->GetFile(), verbose != 0).GetJson()), text, capacity, length);
    });
}

gatun_status gatun_get_array(gatun_file* file, uint32_t array, gatun_array* description)
{
  return Guard(
    [&]
    {
      NeedPointers(file, description);
      const auto& from = file->GetFile();
      const bool isPoints = array == GATUN_POINT_ARRAY;
      Need(isPoints || array < from.GetArrays().size(), "the file has no such array");
      const std::size_t number = isPoints ? from.GetArrays().size() : array;
      gatun_array own{};
      if (!isPoints)
      {
        const auto& named = from.GetArrays()[number];
        own.name = named.Name.c_str();
        own.is_cell = named.Where == Association::Cell;
        own.type = static_cast<gatun_type>(named.Type);
        own.components = named.Components;
        own.vtk_type = named.VTKType;
        own.roles = named.AttributeRoles;
      }
      else
      {
        own.name = from.GetPointArray().Name.c_str();
        own.type = static_cast<gatun_type>(from.GetCoordinateType());
        own.components = 3;
      }
      own.component_names = file->ComponentNames[number].Get();
      own.keys = file->Keys[number].Get();
      own.key_count = file->Keys[number].GetCount();
      Give(own, description);
    });
}

gatun_status gatun_get_range(
  gatun_file* file, uint32_t array, int32_t component, uint64_t step, double range[2])
{
  return Guard(
    [&]
    {
      NeedPointers(file, range);
      const auto& arrays = file->GetFile().GetArrays();
      Need(array < arrays.size() && component >= -1 &&
          component < static_cast<std::int64_t>(arrays[array].Components) &&
          step < file->CountSteps(),
        "the file has no such array, component or time step");
      const auto place = file->Find(step);
      const auto& found = GetRange(place.Mesh->GetFile()->GetRanges(array, place.Step), component);
      range[0] = found.Min;
      range[1] = found.Max;
    });
}

gatun_status gatun_get_step(gatun_file* file, uint64_t step, gatun_step* description)
{
  return Guard(
    [&]
    {
      NeedPointers(file, description);
      const auto place = file->Find(step);
      const auto& mesh = *place.Mesh->GetFile();
      gatun_step own{};
      own.time = place.Time;
      own.mesh = place.Number;
      own.points = mesh.GetNumberOfPoints();
      own.cells = mesh.GetNumberOfCells();
      GiveBounds(
        place.Step < mesh.GetNumberOfSteps() ? mesh.GetBounds(place.Step) : mesh.GetBounds(),
        own.bounds);
      Give(own, description);
    });
}

gatun_status gatun_get_level(gatun_file* file, uint32_t level, gatun_level* description)
{
  return Guard(
    [&]
    {
      NeedPointers(file, description);
      const auto& from = file->GetFile();
      Need(level <= from.GetLevels().size(), "there is no such level");
      const auto counts = level > 0
        ? from.CountLevel(level - 1)
        : MeshCounts{ from.GetNumberOfPoints(), from.GetNumberOfCells(), from.GetNumberOfTets() };
      gatun_level own{};
      own.points = counts.Points;
      own.cells = counts.Cells;
      Give(own, description);
    });
}

//------------------------------------------------------------------------------
gatun_status gatun_verify(gatun_file* file, gatun_progress progress, void* user)
{
  return Guard(
    [&]
    {
      NeedPointers(file);
      if (!VerifyFile(file->GetFile(), WrapProgress(progress, user)))
      {
        throw Error(ErrorCode::Aborted, "aborted");
      }
    });
}
