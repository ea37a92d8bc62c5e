// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMapperInput.h"

#include "gatunError.h"
#include "gatunFileConsumer.h"
#include "gatunFileReader.h"

#include "vtkAlgorithm.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkTrivialProducer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <bit>
#include <exception>

namespace gatun
{
//------------------------------------------------------------------------------
/** Brings the information of the input up to date, in which a reader publishes its file. */
void MapperInput::UpdateInformation(const RayProducer& producer)
{
  auto* const pipeline = vtkDemandDrivenPipeline::SafeDownCast(producer.Algorithm->GetExecutive());
  if (!pipeline)
  {
    return;
  }
  pipeline->UpdatePipelineMTime();
  const vtkMTimeType time = pipeline->GetPipelineMTime();
  if (producer.Algorithm == this->FailedInput && time == this->FailedTime)
  {
    return;
  }
  const bool isKnown = pipeline->UpdateInformation() != 0;
  this->FailedInput = isKnown ? nullptr : producer.Algorithm;
  this->FailedTime = time;
}

//------------------------------------------------------------------------------
const PublishedFile* MapperInput::FindFile(const MapperConnection& input)
{
  const RayProducer& producer = input.Producer;
  if (!producer.Algorithm)
  {
    return nullptr;
  }
  this->UpdateInformation(producer);
  const PublishedFile* const handle =
    GetPublishedFile(producer.Algorithm->GetOutputInformation(producer.Port));
  return handle && (!handle->File || handle->CanReplaceOutput()) ? handle : nullptr;
}

//------------------------------------------------------------------------------
const PublishedFile& MapperInput::GetFile(const MapperConnection& input)
{
  const PublishedFile* const handle = this->FindFile(input);
  if (!handle->File)
  {
    std::rethrow_exception(handle->Failure);
  }
  return *handle;
}

//------------------------------------------------------------------------------
std::size_t MapperInput::GetStep(const MapperConnection& input, const PublishedFile& file)
{
  const RayProducer& producer = input.Producer;
  return GetRequestedStep(
    *file.File->GetFile(), producer.Algorithm->GetOutputInformation(producer.Port));
}

//------------------------------------------------------------------------------
InputKind MapperInput::GetKind(const MapperConnection& input)
{
  vtkAlgorithm* const algorithm = input.Producer.Algorithm;
  if (!algorithm)
  {
    return InputKind::None;
  }
  if (this->FindFile(input))
  {
    return InputKind::File;
  }
  // A grid that was given as such is there as a whole, whatever piece is asked for.
  return input.Pieces.Pieces > 1 && !vtkTrivialProducer::SafeDownCast(algorithm) ? InputKind::Pieces
                                                                                 : InputKind::Grid;
}

//------------------------------------------------------------------------------
void MapperInput::Pull(const MapperConnection& input)
{
  vtkAlgorithm* const algorithm = input.Producer.Algorithm;
  switch (this->GetKind(input))
  {
    case InputKind::None:
      break;
    case InputKind::Grid:
    {
      // A grid that was given as such is the part of this process.
      const bool isGiven = vtkTrivialProducer::SafeDownCast(algorithm) != nullptr;
      const auto share = isGiven ? PieceShare{} : input.Pieces;
      PullPiece(input.Producer, share.Process, share.Processes);
      break;
    }
    case InputKind::File:
    case InputKind::Pieces:
      // vtkVolume draws nothing where there is no object, even if it is empty.
      algorithm->UpdateDataObject();
      break;
  }
}

//------------------------------------------------------------------------------
bool MapperInput::SetScene(const MapperConnection& input, const RayArray& array,
  std::uint64_t budget, bool simplifies, const RaySource::Progress& progress)
{
  const RayProducer& producer = input.Producer;
  switch (this->GetKind(input))
  {
    case InputKind::None:
      return false;
    case InputKind::File:
    {
      const PublishedFile& file = this->GetFile(input);
      this->Scene.SetFile(file, GetStep(input, file), array, simplifies);
      return true;
    }
    case InputKind::Pieces:
      this->Scene.SetPieces(producer, input.Pieces, array, budget, progress);
      return true;
    case InputKind::Grid:
      break;
  }
  this->Pull(input);
  auto* const grid =
    vtkUnstructuredGrid::SafeDownCast(producer.Algorithm->GetOutputDataObject(producer.Port));
  if (!grid)
  {
    ThrowInvalid("the input is not a vtkUnstructuredGrid");
  }
  if (grid->GetNumberOfCells() == 0)
  {
    return false;
  }
  this->Scene.SetGrid(grid, array, budget, simplifies);
  return true;
}

//------------------------------------------------------------------------------
Bounds MapperInput::GetFileBounds(const MapperConnection& input)
{
  const PublishedFile& file = this->GetFile(input);
  return file.File->GetFile()->GetBounds(GetStep(input, file));
}

//------------------------------------------------------------------------------
std::uint64_t MapperInput::Identify(const MapperConnection& input)
{
  const PublishedFile* const handle = this->FindFile(input);
  if (!handle)
  {
    return 0;
  }
  const FileReader& file = *handle->File->GetFile();
  const std::size_t step = GetStep(input, *handle);
  const Range& values = this->Scene.GetRange();
  std::uint64_t number = 0xcbf29ce484222325;
  const auto add = [&](std::uint64_t value)
  { number = (number ^ value) * 0x9e3779b97f4a7c15 ^ number >> 29; };
  add(file.GetNumberOfPoints());
  add(file.GetNumberOfTets());
  add(file.GetChunks().size());
  add(step);
  add(std::bit_cast<std::uint64_t>(values.Min));
  add(std::bit_cast<std::uint64_t>(values.Max));
  constexpr std::size_t enough = 1000;
  for (std::size_t chunk = 0; chunk < std::min(enough, file.GetChunks().size()); ++chunk)
  {
    for (const Range& side : file.GetChunkBounds(chunk, 0, step))
    {
      add(std::bit_cast<std::uint64_t>(side.Min));
      add(std::bit_cast<std::uint64_t>(side.Max));
    }
  }
  return std::max<std::uint64_t>(number, 1);
}

//------------------------------------------------------------------------------
std::string MapperInput::TakeReason()
{
  if (this->Scene.GetReason() == this->Reason)
  {
    return {};
  }
  this->Reason = this->Scene.GetReason();
  return this->Reason;
}

//------------------------------------------------------------------------------
std::string MapperInput::GetCause(const MapperConnection& input, const VTKFailure& failure)
{
  return failure.Code == vtkErrorCode::FileFormatError && this->GetKind(input) == InputKind::File
    ? this->FindFile(input)->Path
    : failure.Message;
}
}
