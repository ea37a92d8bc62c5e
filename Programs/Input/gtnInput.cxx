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
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

namespace gtn
{
const char* const InputFormats = ".vtu .pvtu .vtk .vtm .pvd .series .vtkhdf .vti .vts .vtr, Exodus "
                                 "(.e .exo .ex2), EnSight (.case), OpenFOAM (.foam), "
                                 "CGNS, .gtn";

//------------------------------------------------------------------------------
Input::Input(const std::vector<std::string>& files, const InputOptions& options)
  : Name(files.front())
  , Quiet(options.Quiet)
{
  std::vector<SeriesStep> steps;
  if (files.size() > 1)
  {
    steps = StepsOfFiles(files);
  }
  else if (IsFileList(this->Name))
  {
    steps = ReadFileList(this->Name);
  }

  if (!steps.empty())
  {
    vtkNew<SeriesReader> series;
    series->SetSteps(steps, options);
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
