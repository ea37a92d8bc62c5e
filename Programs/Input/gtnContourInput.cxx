// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnContourInput.h"

#include "gtnFailure.h"
#include "gtnFileSteps.h"
#include "gtnMessages.h"
#include "gtnProgress.h"
#include "gtnReadable.h"
#include "gtnReaders.h"
#include "gtnSettings.h"
#include "gtnText.h"

#include "gatunFileReader.h"
#include "vtkGatunContour.h"
#include "vtkGatunReader.h"
#include "vtkGatunSimplify.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <fmt/core.h>

#include <algorithm>

namespace gtn
{
namespace
{
vtkSmartPointer<vtkUnstructuredGrid> Simplify(
  vtkUnstructuredGrid* grid, const ContourInputOptions& options, const Settings& settings)
{
  vtkNew<vtkGatunSimplify> simplifier;
  options.Target.Apply(simplifier.Get());
  Progress progress("simplifying", settings.ShowProgress);
  simplifier->SetInputData(grid);
  progress.Watch(simplifier);
  simplifier->Update();
  CheckInterrupt();
  CheckMessages(options.File, settings.Quiet);
  return simplifier->GetUnstructuredGridOutput();
}

bool NeedsMesh(const ContourInputOptions& options)
{
  return ExtensionOf(options.File) != ".gtn" ||
    (options.Target.IsGiven() && !gatun::FileReader(options.File).HasMergeTree());
}
}

//------------------------------------------------------------------------------
ContourInput::ContourInput(const ContourInputOptions& options, const Settings& settings)
  : File(options.File)
{
  CheckReadable(this->File);
  if (NeedsMesh(options))
  {
    this->Read(options, settings);
  }
  else
  {
    this->OpenFile(options, settings);
  }
}

//------------------------------------------------------------------------------
ContourInput::~ContourInput() = default;

//------------------------------------------------------------------------------
void ContourInput::OpenFile(const ContourInputOptions& options, const Settings& settings)
{
  const FileSteps::Place place = OpenStep(this->File, options.Step, settings.Quiet);
  const gatun::FileReader& file = *place.Mesh;
  RequireGrid(file);
  this->Time = place.Time;
  const std::vector<ArrayChoice> choices = GetChoices(file);
  this->Choose(options, choices);
  this->Range = gtn::GetRange(file, this->Array, this->Component, place.Step);
  this->Layered = file.HasLayers() && file.GetLayers().Array == this->Array.Index &&
    file.GetLayers().Component == this->Component;

  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(this->File.c_str());
  reader->SetMemoryBudget(0); // each chunk is decoded once
  for (const ArrayChoice& choice : choices)
  {
    const bool isOfPoints = choice.Association == vtkDataObject::POINT;
    const bool isWanted = this->IsCarried(options, choice.Name);
    if (isOfPoints)
    {
      const bool isContoured = choice.Index == this->Array.Index;
      reader->SetPointArrayStatus(choice.Name.c_str(), isWanted || isContoured ? 1 : 0);
    }
    else
    {
      reader->SetCellArrayStatus(choice.Name.c_str(), isWanted ? 1 : 0);
    }
  }
  if (options.Target.IsGiven())
  {
    options.Target.Apply(reader.Get());
  }
  this->Reader = reader;
}

//------------------------------------------------------------------------------
void ContourInput::Read(const ContourInputOptions& options, const Settings& settings)
{
  InputOptions all;
  all.VolumesOnly = true;
  all.Quiet = settings.Quiet;
  Input input({ this->File }, all);
  const auto whole = ReadGridStep(input, options.Step, settings);
  this->Grid = options.Target.IsGiven() ? Simplify(whole, options, settings) : whole;
  const std::vector<ArrayChoice> choices = GetChoices(this->Grid.Get());
  this->Choose(options, choices);
  this->Range = gtn::GetRange(this->Grid.Get(), this->Array, this->Component);

  const std::string contoured = this->Array.Name;
  for (const ArrayChoice& choice : choices)
  {
    const bool isOfPoints = choice.Association == vtkDataObject::POINT;
    const bool isContoured = isOfPoints && choice.Name == contoured;
    if (!choice.Name.empty() && !isContoured && !this->IsCarried(options, choice.Name))
    {
      this->Grid->GetAttributes(choice.Association)->RemoveArray(choice.Name.c_str());
    }
  }
}

//------------------------------------------------------------------------------
bool ContourInput::IsCarried(const ContourInputOptions& options, const std::string& name) const
{
  const auto& names = options.Carried.Arrays;
  return options.Carried.AllArrays || std::find(names.begin(), names.end(), name) != names.end();
}

//------------------------------------------------------------------------------
void ContourInput::Choose(
  const ContourInputOptions& options, const std::vector<ArrayChoice>& choices)
{
  CheckNames(options.Carried.Arrays, this->File, choices);
  const auto isOfPoints = [](const ArrayChoice& choice)
  { return choice.Association == vtkDataObject::POINT; };
  std::vector<ArrayChoice> ofPoints;
  std::copy_if(choices.begin(), choices.end(), std::back_inserter(ofPoints), isOfPoints);
  const std::string& name = options.Array.Name;
  const auto hasName = [&name](const ArrayChoice& choice) { return choice.Name == name; };
  if (!name.empty() && std::any_of(choices.begin(), choices.end(), hasName) &&
    std::none_of(ofPoints.begin(), ofPoints.end(), hasName))
  {
    throw Failure(this->File,
      fmt::format("array '{}' is one of the cells; isosurfaces need one of the points",
        MakePrintableLine(name)));
  }
  this->Array = ChooseArray(options.Array, this->File, ofPoints, "of the points");
  this->Component = ChooseComponent(options.Array, this->File, this->Array);
  this->WithScalars = this->IsCarried(options, this->Array.Name);
}

//------------------------------------------------------------------------------
void ContourInput::Connect(vtkGatunContour* contour) const
{
  if (this->Reader)
  {
    contour->SetInputConnection(this->Reader->GetOutputPort());
  }
  else
  {
    contour->SetInputData(this->Grid);
  }
  // The one without a name can only be had as the active one, which it then is.
  if (!this->Array.Name.empty())
  {
    contour->SetInputArrayToProcess(0, 0, 0, vtkDataObject::POINT, this->Array.Name.c_str());
  }
  contour->SetArrayComponent(this->Component);
  contour->SetComputeScalars(this->WithScalars);
}

//------------------------------------------------------------------------------
void ContourInput::Run(vtkGatunContour* contour) const
{
  if (this->Time)
  {
    contour->UpdateTimeStep(*this->Time);
  }
  else
  {
    contour->Update();
  }
}
}
