// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnSeries.h"

#include "gtnBlockList.h"
#include "gtnFailure.h"
#include "gtnFileList.h"
#include "gtnFileOrder.h"
#include "gtnMessages.h"
#include "gtnPartReader.h"
#include "gtnPrepare.h"
#include "gtnReadable.h"
#include "gtnReaders.h"
#include "gtnText.h"
#include "gtnTimes.h"
#include "gtnXMLMesh.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <exception>
#include <optional>

namespace gtn
{
vtkStandardNewMacro(SeriesReader);

namespace
{

// Nothing if the file does not tell.
std::optional<double> TimeValueOf(const std::string& file, const InputOptions& options)
{
  const std::string extension = ExtensionOf(file);
  for (const char* const timeless : { ".stl", ".ply", ".obj", ".glb", ".gltf" })
  {
    if (extension == timeless)
    {
      CheckReadable(file);
      return {};
    }
  }
  vtkSmartPointer<vtkDataObject> data;
  if (extension == ".vtu")
  {
    data = ReadXMLSummary(file).Grid;
  }
  else
  {
    vtkSmartPointer<vtkAlgorithm> reader = OpenFile(file, options);
    // One block tells as much as all.
    reader->UpdatePiece(
      0, IsBlockList(file) ? static_cast<int>(ReadBlockList(file, options).Files.size()) : 1, 0);
    CheckMessages(file, true);
    data = reader->GetOutputDataObject(0);
  }
  vtkDataArray* time = data->GetFieldData()->GetArray("TimeValue");
  return time && time->GetNumberOfValues() == 1 ? std::optional(time->GetComponent(0, 0))
                                                : std::nullopt;
}

} // anonymous namespace

//------------------------------------------------------------------------------
std::vector<SeriesStep> StepsOfFiles(
  const std::vector<std::string>& files, const InputOptions& options)
{
  std::vector<TimedFile> timed;
  for (const std::string& file : files)
  {
    timed.push_back(
      { file, TimeValueOf(options.InPieces ? FindParts(file, options).front() : file, options) });
  }
  std::vector<SeriesStep> steps;
  for (const TimedFile& file : OrderFiles(timed, options.Quiet))
  {
    SeriesStep step;
    step.Time = *file.Time;
    step.List = file.File;
    step.Files =
      options.InPieces ? FindParts(file.File, options) : std::vector<std::string>{ file.File };
    steps.push_back(step);
  }
  return steps;
}

//------------------------------------------------------------------------------
SeriesReader::SeriesReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
void SeriesReader::SetSteps(
  const std::vector<SeriesStep>& steps, const InputOptions& options, bool hasTime)
{
  this->Steps = steps;
  this->Times = hasTime ? TimesOf(steps) : std::vector<double>();
  this->Options = options;
  this->Forms.clear();
  const auto isOne = [&](const SeriesStep& step)
  { return options.InPieces || step.Files.size() == 1; };
  this->Surface =
    IsSurfaceFile(steps.front().Files.front()) && std::all_of(steps.begin(), steps.end(), isOne);
  this->Modified();
}

//------------------------------------------------------------------------------
int SeriesReader::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  return this->SetOutputDataObject(this->Surface ? VTK_POLY_DATA : VTK_UNSTRUCTURED_GRID,
    outputVector->GetInformationObject(0), true);
}

//------------------------------------------------------------------------------
int SeriesReader::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  PublishTimes(info, this->Times);
  return 1;
}

//------------------------------------------------------------------------------
int SeriesReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const std::size_t number = FindStep(info, this->Times);
  const SeriesStep& step = this->Steps[number];
  std::vector<std::string> files = step.Files;
  const auto pieces = static_cast<std::size_t>(std::max(1,
    info->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) ? info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())
                                                   : 1));
  if (pieces > 1)
  {
    const auto piece = static_cast<std::size_t>(info->Get(Pipeline::UPDATE_PIECE_NUMBER()));
    files.assign(step.Files.begin() + static_cast<std::ptrdiff_t>(piece * files.size() / pieces),
      step.Files.begin() + static_cast<std::ptrdiff_t>((piece + 1) * files.size() / pieces));
  }
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  try
  {
    // The pieces of a step are asked for one by one, and each needs what all files declare.
    if (this->Options.InPieces && !this->Forms.contains(number))
    {
      this->Forms.try_emplace(
        number, step.List.empty() ? step.Files.front() : step.List, step.Files, this->Options);
    }
    this->Read(files, this->Forms[number], output);
    if (auto* const piece = vtkPointSet::SafeDownCast(output);
        piece && pieces > 1 && this->Options.KeepApart && piece->GetNumberOfPoints() > 0)
    {
      AddJoinArray(piece, nullptr);
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< ReasonOf(error));
    return 0;
  }
  if (!this->Times.empty())
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), step.Time);
    output->GetInformation()->Set(vtkCompositeDataSet::NAME(), FileOf(step.Files.front()).c_str());
  }
  return 1;
}

//------------------------------------------------------------------------------
// Reads the parts of a mesh.
void SeriesReader::Read(
  const std::vector<std::string>& files, const PartForm& form, vtkDataObject* output)
{
  if (files.empty())
  {
    return;
  }
  if (this->Options.InPieces && files.size() > 1)
  {
    Preparer::Prepare(ReadParts(files, form, this->Options), this->Options, output);
    return;
  }
  vtkNew<vtkMultiBlockDataSet> parts;
  for (const std::string& file : files)
  {
    parts->SetBlock(parts->GetNumberOfBlocks(), ReadPart(file, form, this->Options));
  }
  Preparer::Prepare(files.size() > 1 ? parts.Get() : parts->GetBlock(0), this->Options, output);
}
}
