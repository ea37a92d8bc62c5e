// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnSeries.h"

#include "gtnBlockList.h"
#include "gtnFailure.h"
#include "gtnFileList.h"
#include "gtnFileOrder.h"
#include "gtnMessages.h"
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

vtkSmartPointer<vtkAlgorithm> OpenOne(const std::string& file, bool sets)
{
  CheckReadable(file);
  if (IsFileList(file))
  {
    throw Failure(file, "a list of files cannot be part of another");
  }
  vtkSmartPointer<vtkAlgorithm> reader = MakeReader(file, sets);
  if (!reader)
  {
    throw Failure(file, "no reader for this extension");
  }
  reader->UpdateInformation();
  CheckMessages(file, false);
  vtkInformation* info = reader->GetOutputInformation(0);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (info->Has(Pipeline::TIME_STEPS()) && info->Length(Pipeline::TIME_STEPS()) > 1)
  {
    throw Failure(file, "has several time steps itself, and cannot be a step of a series");
  }
  return reader;
}

// Nothing if the file does not tell.
std::optional<double> TimeValueOf(const std::string& file)
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
    vtkSmartPointer<vtkAlgorithm> reader = OpenOne(file, false);
    // One block tells as much as all.
    reader->UpdatePiece(
      0, IsBlockList(file) ? static_cast<int>(ReadBlockList(file).Files.size()) : 1, 0);
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
  const std::vector<std::string>& files, bool inPieces, bool quiet)
{
  std::vector<TimedFile> timed;
  for (const std::string& file : files)
  {
    timed.push_back({ file, TimeValueOf(inPieces ? FindParts(file).front() : file) });
  }
  std::vector<SeriesStep> steps;
  for (const TimedFile& file : OrderFiles(timed, quiet))
  {
    SeriesStep step;
    step.Time = *file.Time;
    step.Files = inPieces ? FindParts(file.File) : std::vector<std::string>{ file.File };
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
  const SeriesStep& step = this->Steps[FindStep(info, this->Times)];
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
    this->Read(files, output);
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
void SeriesReader::Read(const std::vector<std::string>& files, vtkDataObject* output)
{
  if (files.empty())
  {
    return;
  }
  if (this->Surface && files.size() > 1)
  {
    throw Failure(files.front(), "surfaces in several files are packed one by one: as many pieces");
  }
  vtkNew<vtkMultiBlockDataSet> parts;
  for (const std::string& file : files)
  {
    vtkSmartPointer<vtkAlgorithm> reader = OpenOne(file, this->Options.Sets);
    reader->Update();
    CheckMessages(file, this->Options.Quiet);
    parts->SetBlock(parts->GetNumberOfBlocks(), reader->GetOutputDataObject(0));
  }
  Preparer::Prepare(files.size() > 1 ? parts.Get() : parts->GetBlock(0), this->Options, output);
}
}
