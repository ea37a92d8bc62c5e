// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunRayScene.h"

#include "gatunError.h"
#include "gatunFileReader.h"
#include "gatunRayCaster.h"
#include "vtkGatunReader.h"

#include "vtkInformation.h"
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
  throw Error(ErrorCode::InvalidInput, file.GetPath() + ": " + DescribeMissing(wanted));
}

/** The last step not later than a time, or the first. */
std::size_t FindStep(const FileReader& file, double time)
{
  const auto& times = file.GetTimes();
  return file.HasTime() ? static_cast<std::size_t>(std::max<std::ptrdiff_t>(0,
                            std::upper_bound(times.begin(), times.end(), time) - times.begin() - 1))
                        : 0;
}
}

//------------------------------------------------------------------------------
vtkGatunReader* GetFileReader(vtkAlgorithm* input)
{
  auto* const reader = vtkGatunReader::SafeDownCast(input);
  return reader && reader->GetFileName() && !reader->GetUseBox() && !reader->GetUseValueRange()
    ? reader
    : nullptr;
}

RayScene::RayScene() = default;
RayScene::~RayScene() = default;

//------------------------------------------------------------------------------
void RayScene::Clear()
{
  this->Source.reset();
  this->Pieces = nullptr;
  this->Known = {};
  this->Values = {};
  this->File.reset();
}

//------------------------------------------------------------------------------
bool RayScene::IsKnown(const Key& key)
{
  if (this->Source && key == this->Known)
  {
    return true;
  }
  // Before another is made: there need not be memory for both.
  this->Source.reset();
  this->Pieces = nullptr;
  return false;
}

//------------------------------------------------------------------------------
void RayScene::Take(const Key& key, std::unique_ptr<RaySource> source, const Range& values)
{
  this->Source = std::move(source);
  this->Known = key;
  this->Values = values;
}

//------------------------------------------------------------------------------
void RayScene::SetGrid(vtkUnstructuredGrid* grid, const RayArray& array, std::uint64_t budget)
{
  Key key;
  key.Grid = grid;
  key.Stamp = grid->GetMTime();
  key.Array = array;
  key.Budget = budget;
  if (!this->IsKnown(key))
  {
    auto source = std::make_unique<GridRaySource>(grid, array, budget);
    const Range values = GetWholeRange(*source);
    this->Take(key, std::move(source), values);
  }
}

//------------------------------------------------------------------------------
void RayScene::OpenFile(const std::string& path)
{
  const FileSignature signature = SignatureOf(path);
  if (!this->File || path != this->Path || signature != this->Signature)
  {
    this->Clear();
    this->File = std::make_shared<const FileReader>(path);
    this->Path = path;
    this->Signature = signature;
  }
}

//------------------------------------------------------------------------------
const Bounds& RayScene::GetFileBounds(const std::string& path)
{
  this->OpenFile(path);
  return this->File->GetBounds();
}

//------------------------------------------------------------------------------
std::uint64_t RayScene::GetBytesRead() const
{
  return this->File ? this->File->GetBytesRead() : 0;
}

//------------------------------------------------------------------------------
void RayScene::SetFile(
  const std::string& path, double time, const RayArray& array, std::uint64_t budget)
{
  this->OpenFile(path);
  Key key;
  key.File = this->File;
  key.Step = FindStep(*this->File, time);
  key.Array = array;
  key.Budget = budget;
  if (this->IsKnown(key))
  {
    return;
  }
  const auto index = FindArray(*this->File, array);
  RequireComponent(array, this->File->GetArrays()[index].Components);
  this->Take(key,
    std::make_unique<FileRaySource>(
      this->File, RayValues{ index, array.Component, key.Step }, budget),
    GetDrawnRange(this->File->GetRanges(index, key.Step), array.Component));
}

//------------------------------------------------------------------------------
void RayScene::SetPieces(const RayProducer& producer, int pieces, const RayArray& array,
  std::uint64_t budget, const RaySource::Progress& progress)
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
    auto source = std::make_unique<PieceRaySource>(producer, pieces, array, budget, progress);
    PieceRaySource* const made = source.get();
    this->Take(key, std::move(source), made->GetWholeRange());
    this->Pieces = made;
  }
}

//------------------------------------------------------------------------------
void RayScene::Draw(RayCaster& caster, const RayView& view, const RaySource::Progress& progress)
{
  if (this->Pieces)
  {
    this->Pieces->Draw(caster, view, progress);
  }
  else
  {
    caster.Draw(*this->Source, progress);
  }
}
}
