// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFileContour.h"

#include "gatunFileConsumer.h"
#include "gatunFileReader.h"
#include "gatunSurfaceOutput.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace gatun
{
namespace
{
/** The arrays of the surface: those that the reader would read, as of any other input. */
SurfaceOutput ChooseArrays(
  const PublishedFile& handle, const ContourSettings& settings, FileSurfaceRequest& request)
{
  const FileReader& file = *handle.File->GetFile();
  const auto& arrays = file.GetArrays();
  SurfaceOutput content;
  std::optional<std::uint32_t> scalars;
  // Without steps, arrays have no values.
  for (std::uint32_t i = 0; i < arrays.size() && file.GetNumberOfSteps() > 0; ++i)
  {
    if (!handle.Selected[i])
    {
      continue;
    }
    ArrayDescription array = arrays[i];
    const bool isContoured = !scalars && settings.Array.IsThis(array);
    scalars = isContoured ? i : scalars;
    if (settings.Carries(array, isContoured))
    {
      request.Arrays.push_back(i);
      content.Arrays.push_back(std::move(array));
    }
  }
  if (!scalars)
  {
    settings.Array.Fail();
  }
  request.Array = *scalars;
  request.Component = settings.ChooseComponent(arrays[*scalars]);
  return content;
}
}

//------------------------------------------------------------------------------
void FileContour::Open(const PublishedFile& handle)
{
  if (this->Extractor && handle.File == this->File && handle.Merges == this->Merges)
  {
    return;
  }
  this->Close();
  const SharedFile::Place place = handle.File->Find(handle.Merges);
  this->Extractor = std::make_unique<FileSurface>(
    handle.File->MakeView(place.File, true), place.Tree, place.Merges);
  this->File = handle.File;
  this->Merges = handle.Merges;
}

//------------------------------------------------------------------------------
void FileContour::Close()
{
  this->Extractor.reset();
  this->File.reset();
  this->Merges = 0;
}

//------------------------------------------------------------------------------
void FileContour::Fill(const PublishedFile& handle, const ContourSettings& settings,
  vtkInformation* inInfo, vtkInformation* outInfo, const ContourProgress& progress,
  vtkPolyData* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  this->Open(handle);
  const FileReader& file = *handle.File->GetFile();
  FileSurfaceRequest request;
  SurfaceOutput content = ChooseArrays(handle, settings, request);
  request.Step = GetRequestedStep(file, inInfo);
  request.Options.Values = settings.Values;
  request.Options.CoordinateType = settings.ChoosePrecision(file.GetCoordinateType());
  request.Options.Normals = settings.ComputeNormals;
  const int pieces = std::max(1, Pipeline::GetUpdateNumberOfPieces(outInfo));
  const int piece = Pipeline::GetUpdatePiece(outInfo);
  if (piece >= 0 && piece < pieces)
  {
    request.Piece = static_cast<unsigned>(piece);
    request.Pieces = static_cast<unsigned>(pieces);
    const auto surface = this->Extractor->Extract(request, progress);
    this->Statistics = this->Extractor->GetStatistics();
    content.CoordinateType = request.Options.CoordinateType;
    content.Normals = settings.ComputeNormals;
    content.Strips = settings.OutputStrips;
    FillPolyData(surface, content, output);
  }
  if (file.HasTime() && request.Step < file.GetTimes().size())
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), file.GetTimes()[request.Step]);
  }
}

//------------------------------------------------------------------------------
std::size_t FileContour::GetNumberOfChunks() const
{
  return this->Extractor ? this->Extractor->GetFile()->GetChunks().size() : 0;
}

//------------------------------------------------------------------------------
std::uint64_t FileContour::CountFlatCells() const
{
  const FileReader* const file = this->File ? this->File->GetFile().get() : nullptr;
  return file && file->GetNumberOfTets() == 0 ? file->GetNumberOfCells() : 0;
}

//------------------------------------------------------------------------------
std::uint64_t FileContour::GetBytesRead() const
{
  return this->File ? this->File->GetBytesRead() : 0;
}
}
