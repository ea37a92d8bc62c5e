// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnInput.h"

#include "gtnFailure.h"
#include "gtnFileList.h"
#include "gtnMessages.h"
#include "gtnObj.h"
#include "gtnPrepare.h"
#include "gtnProgress.h"
#include "gtnReadable.h"
#include "gtnReaders.h"
#include "gtnSeries.h"
#include "gtnText.h"

#include "gatunCellCheck.h"
#include "gatunError.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <filesystem>

namespace gtn
{
const char* const InputFormats = ".vtu .pvtu .vtk .vtm .pvd .series .vtkhdf .vti .vts .vtr, Exodus "
                                 "(.e .exo .ex2), EnSight (.case), OpenFOAM (.foam), "
                                 "CGNS, .gtn";

//------------------------------------------------------------------------------
namespace
{

// The bytes of a tuple of all arrays.
std::uint64_t SizeOfTuple(vtkInformationVector* arrays)
{
  std::uint64_t bytes = 0;
  for (int i = 0; arrays && i < arrays->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* array = arrays->GetInformationObject(i);
    const int type = array->Get(vtkDataObject::FIELD_ARRAY_TYPE());
    bytes += static_cast<std::uint64_t>(vtkDataArray::GetDataTypeSize(type) *
      array->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS()));
  }
  return bytes;
}

// About the number of bytes of a file as a mesh in memory.
std::uint64_t EstimateMesh(const std::string& file)
{
  CheckReadable(file);
  vtkSmartPointer<vtkAlgorithm> reader = MakeReader(file, false);
  auto* xml = vtkXMLUnstructuredGridReader::SafeDownCast(reader);
  if (!xml)
  {
    constexpr std::uint64_t compression = 4;
    return compression * std::filesystem::file_size(file);
  }
  xml->UpdateInformation();
  CheckMessages(file, true);
  vtkInformation* info = xml->GetOutputInformation(0);
  const auto size = [&](vtkInformationInformationVectorKey* key)
  { return info->Has(key) ? SizeOfTuple(info->Get(key)) : 0; };
  constexpr std::uint64_t coordinates = 24;
  constexpr std::uint64_t ids = 8 * (8 + 1) + 1; // of a hexahedron
  return static_cast<std::uint64_t>(xml->GetNumberOfPoints()) *
    (coordinates + size(vtkDataObject::POINT_DATA_VECTOR())) +
    static_cast<std::uint64_t>(xml->GetNumberOfCells()) *
    (ids + size(vtkDataObject::CELL_DATA_VECTOR()));
}

} // anonymous namespace

//------------------------------------------------------------------------------
Input::Input(const std::vector<std::string>& files, const InputOptions& options)
  : Name(files.front())
  , Quiet(options.Quiet)
{
  std::vector<SeriesStep>& steps = this->Steps;
  bool hasTime = true;
  if (files.size() > 1)
  {
    steps = StepsOfFiles(files, options.InPieces);
  }
  else if (IsFileList(this->Name))
  {
    steps = ReadFileList(this->Name);
    for (SeriesStep& step : steps)
    {
      std::vector<std::string> parts;
      for (const std::string& file : step.Files)
      {
        const auto more = options.InPieces ? FindParts(file) : std::vector<std::string>{ file };
        parts.insert(parts.end(), more.begin(), more.end());
      }
      step.Files = parts;
    }
  }
  else if (options.InPieces && ExtensionOf(this->Name) == ".pvtu")
  {
    steps.push_back({ 0, FindParts(this->Name) });
    hasTime = false;
  }

  if (!steps.empty())
  {
    vtkNew<SeriesReader> series;
    series->SetSteps(steps, options, hasTime);
    this->Algorithm = series;
  }
  else
  {
    CheckReadable(this->Name);
    vtkSmartPointer<vtkAlgorithm> reader = MakeReader(this->Name, options.Sets);
    if (!reader)
    {
      throw Failure(this->Name,
        std::string("no reader for this extension; there are those for ") + InputFormats);
    }
    vtkNew<Preparer> preparer;
    preparer->SetOptions(options);
    preparer->SetInputConnection(reader->GetOutputPort());
    this->Algorithm = preparer;
  }
  this->Algorithm->UpdateInformation();
  CheckMessages(this->Name, this->Quiet);

  vtkInformation* info = this->Algorithm->GetOutputInformation(0);
  auto* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  if (info->Has(key))
  {
    this->Times.assign(info->Get(key), info->Get(key) + info->Length(key));
  }
}

//------------------------------------------------------------------------------
Input::~Input() = default;

//------------------------------------------------------------------------------
vtkAlgorithm* Input::GetSource() const
{
  vtkAlgorithm* source = this->Algorithm;
  while (source->GetNumberOfInputPorts() > 0 && source->GetNumberOfInputConnections(0) > 0)
  {
    source = source->GetInputAlgorithm(0, 0);
  }
  return source;
}

//------------------------------------------------------------------------------
std::size_t Input::GetNumberOfParts() const
{
  for (const SeriesStep& step : this->Steps)
  {
    if (step.Files.size() != this->Steps.front().Files.size())
    {
      throw Failure(this->Name, "the time steps have different numbers of files");
    }
  }
  return this->Steps.empty() ? 1 : this->Steps.front().Files.size();
}

//------------------------------------------------------------------------------
std::uint64_t Input::EstimateLargestPart() const
{
  const std::vector<std::string> files =
    this->Steps.empty() ? std::vector<std::string>{ this->Name } : this->Steps.front().Files;
  std::uint64_t largest = 0;
  for (const std::string& file : files)
  {
    largest = std::max(largest, EstimateMesh(file));
  }
  return largest;
}

//------------------------------------------------------------------------------
vtkUnstructuredGrid* Input::Read(std::size_t step, Progress& progress)
{
  progress.Watch(this->GetSource()); // which takes the time
  if (this->Times.empty())
  {
    this->Algorithm->Update();
  }
  else
  {
    this->Algorithm->UpdateTimeStep(this->Times.at(step));
  }
  CheckInterrupt();
  CheckMessages(this->Name, this->Quiet);
  return vtkUnstructuredGrid::SafeDownCast(this->Algorithm->GetOutputDataObject(0));
}

namespace
{

// VTK's readers do not check the cells of a file, and its filters rely on them.
void CheckCells(const std::string& file, vtkPolyData* surface)
{
  for (vtkCellArray* cells :
    { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
  {
    try
    {
      gatun::CheckOffsets(cells);
      gatun::CheckPointIds(cells, surface->GetNumberOfPoints());
    }
    catch (const gatun::Error& error)
    {
      throw Failure(file, error.what());
    }
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadSurface(const std::string& file, Progress& progress, bool quiet)
{
  CheckReadable(file);
  if (ExtensionOf(file) == ".obj")
  {
    return ReadObj(file, progress);
  }
  vtkSmartPointer<vtkAlgorithm> reader = MakeSurfaceReader(file);
  if (!reader)
  {
    throw Failure(
      file, "no reader for this extension; there are those for .stl .ply .obj .vtp .vtk");
  }
  progress.Watch(reader);
  reader->Update();
  CheckInterrupt();
  CheckMessages(file, quiet);
  vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
  if (!surface)
  {
    throw Failure(file, "does not hold a surface");
  }
  CheckCells(file, surface);
  return surface;
}
}
