// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunRayScene.h"

#include "gatunError.h"
#include "gatunFileLevelsOfDetail.h"
#include "gatunFileRaySource.h"
#include "gatunFileReader.h"
#include "gatunMemoryLevelsOfDetail.h"
#include "gatunPublishedFile.h"
#include "gatunRayCaster.h"

#include "vtkAlgorithm.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace gatun
{
namespace
{
std::uint32_t FindArray(const FileReader& file, const RayArray& wanted)
{
  const auto& arrays = file.GetArrays();
  constexpr std::uint32_t scalars = 1;
  for (const auto where : { Association::Point, Association::Cell })
  {
    if (wanted.Association >= 0 && wanted.Association != static_cast<int>(where))
    {
      continue;
    }
    int before = 0; // of the same kind
    for (std::size_t i = 0; i < arrays.size(); ++i)
    {
      if (arrays[i].Where != where)
      {
        continue;
      }
      const bool fits = wanted.Index ? *wanted.Index == before
        : wanted.Name.empty()        ? (arrays[i].AttributeRoles & scalars) != 0
                                     : arrays[i].Name == wanted.Name;
      if (fits)
      {
        return static_cast<std::uint32_t>(i);
      }
      ++before;
    }
  }
  ThrowInvalid(DescribeMissing(wanted), file.GetPath());
}

/** How much of a number of bytes is for what. */
LevelOfDetailCache::Limits Divide(std::uint64_t budget)
{
  return { budget - budget / 4, budget / 4 };
}
}

//------------------------------------------------------------------------------
RayScene::RayScene() = default;
RayScene::~RayScene() = default;

//------------------------------------------------------------------------------
void RayScene::Drop()
{
  this->Levels.reset();
  this->Reason.clear();
  this->Source.reset();
  this->Pieces = nullptr;
}

//------------------------------------------------------------------------------
void RayScene::Clear()
{
  this->Drop();
  this->Known = {};
  this->Values = {};
}

//------------------------------------------------------------------------------
bool RayScene::IsKnown(const Key& key)
{
  if (this->Source && key == this->Known)
  {
    return true;
  }
  // Before another is made: there need not be memory for both.
  this->Drop();
  return false;
}

//------------------------------------------------------------------------------
void RayScene::Take(const Key& key, std::shared_ptr<RaySource> source, const Range& values)
{
  this->Source = std::move(source);
  this->Known = key;
  this->Values = values;
}

//------------------------------------------------------------------------------
void RayScene::SetGrid(
  vtkUnstructuredGrid* grid, const RayArray& array, std::uint64_t budget, bool simplifies)
{
  Key key;
  key.Grid = grid;
  key.Stamp = grid->GetMTime();
  key.Array = array;
  key.Budget = budget;
  key.Simplifies = simplifies;
  if (this->IsKnown(key))
  {
    return;
  }
  if (!simplifies)
  {
    auto source = std::make_shared<GridRaySource>(grid, array, budget);
    const Range values = GetWholeRange(*source);
    this->Take(key, std::move(source), values);
    return;
  }
  // A copy, as the grid may change while coarser meshes are made in the background.
  const GridMesh original(grid, array);
  const auto mesh = std::make_shared<const MemoryRayMesh>(
    original.GetMesh(), original.GetValues(), original.GetHidden());
  const LevelOfDetailCache::Limits limits = Divide(budget);
  auto whole = MakeWholeSource(mesh, limits.Whole);
  this->Levels = std::make_unique<LevelOfDetailCache>(
    [mesh, limits](const RaySource::Progress& progress) {
      return std::make_shared<MemoryLevelsOfDetail>(
        mesh, mesh->BuildTree(progress), limits.Simpler);
    },
    whole, limits);
  const Range values = GetWholeRange(*whole);
  this->Take(key, std::move(whole), values);
}

//------------------------------------------------------------------------------
std::uint64_t RayScene::GetBytesRead() const
{
  return this->Known.File ? this->Known.File->GetBytesRead() : 0;
}

//------------------------------------------------------------------------------
void RayScene::SetFile(
  const PublishedFile& handle, std::size_t step, const RayArray& array, bool simplifies)
{
  Key key;
  key.File = handle.File;
  key.Step = step;
  key.Array = array;
  key.Simplifies = simplifies;
  if (this->IsKnown(key))
  {
    return;
  }
  const FileReader& file = *handle.File->GetFile();
  const auto index = FindArray(file, array);
  const int component = FindComponent(array, file.GetArrays()[index].Components);
  const RayValues values{ index, component, step };
  auto whole =
    std::make_shared<FileRaySource>(handle.File->MakeView(handle.File->GetFile(), false), values);
  if (simplifies && file.HasMergeTree())
  {
    this->Levels = std::make_unique<LevelOfDetailCache>(
      [shared = handle.File, values](const RaySource::Progress&)
      { return std::make_shared<FileLevelsOfDetail>(shared, values); },
      whole, Divide(handle.File->GetBudget()->GetBytes()));
  }
  else if (simplifies)
  {
    this->Reason =
      handle.Path + ": there is no hierarchy in the file; make one with gtn pack --hierarchy";
  }
  this->Take(key, std::move(whole), GetDrawnRange(file.GetRanges(index, step), component));
}

//------------------------------------------------------------------------------
void RayScene::SetPieces(const RayProducer& producer, const PieceShare& pieces,
  const RayArray& array, std::uint64_t budget, const RaySource::Progress& progress)
{
  auto* const pipeline =
    vtkStreamingDemandDrivenPipeline::SafeDownCast(producer.Algorithm->GetExecutive());
  if (!pipeline || !pipeline->UpdateInformation())
  {
    throw Error(ErrorCode::InvalidInput, "the input could not be made");
  }
  Key key;
  key.Producer = producer;
  key.Pieces = pieces;
  key.Time = GetRequestedTime(producer);
  key.Stamp = pipeline->GetPipelineMTime();
  key.Array = array;
  key.Budget = budget;
  if (!this->IsKnown(key))
  {
    auto source = std::make_shared<PieceRaySource>(producer, pieces, array, budget, progress);
    PieceRaySource* const made = source.get();
    this->Take(key, std::move(source), made->GetWholeRange());
    this->Pieces = made;
  }
}

//------------------------------------------------------------------------------
void RayScene::Draw(
  RayCaster& caster, const RayView& view, const RaySource::Progress& progress, RaySource* other)
{
  if (other)
  {
    caster.Draw(*other, progress);
  }
  else if (this->Pieces)
  {
    this->Pieces->Draw(caster, view, progress);
  }
  else
  {
    caster.Draw(*this->Source, progress);
  }
}
}
