// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnRenderInput.h"

#include "gtnFailure.h"
#include "gtnFileSteps.h"
#include "gtnInput.h"
#include "gtnMessages.h"
#include "gtnProgress.h"
#include "gtnReadable.h"
#include "gtnReaders.h"
#include "gtnText.h"

#include "gatunFileReader.h"
#include "vtkGatunDefaults.h"
#include "vtkGatunRayCaster.h"
#include "vtkGatunReader.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <array>

namespace gtn
{
//------------------------------------------------------------------------------
RenderInput::RenderInput(const RenderInputOptions& options, Progress& progress)
  : File(options.File)
{
  if (ExtensionOf(this->File) == ".gtn")
  {
    this->OpenFile(options);
  }
  else
  {
    this->Read(options, progress);
  }
  this->RequireContent();
}

//------------------------------------------------------------------------------
RenderInput::~RenderInput() = default;

//------------------------------------------------------------------------------
void RenderInput::OpenFile(const RenderInputOptions& options)
{
  CheckReadable(this->File);
  const FileSteps::Place place = OpenStep(this->File, options.Step, options.Quiet);
  const gatun::FileReader& file = *place.Mesh;
  RequireGrid(file);
  this->Time = place.Time;

  this->Choose(options, GetChoices(file));
  this->Range = gtn::GetRange(file, this->Array, this->Component, place.Step);
  this->Bounds = file.GetBounds(place.Step);
  this->Tets = file.GetNumberOfTets();

  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(this->File.c_str());
  this->Reader = reader;
}

//------------------------------------------------------------------------------
void RenderInput::Read(const RenderInputOptions& options, Progress& progress)
{
  InputOptions inputOptions;
  inputOptions.VolumesOnly = true;
  inputOptions.Quiet = options.Quiet;
  Input input({ this->File }, inputOptions);
  const std::size_t step = ChooseStep(options.Step, this->File, input.GetTimes(), options.Quiet);
  this->Grid = input.ReadGrid(step, progress);

  this->Choose(options, GetChoices(this->Grid.Get()));
  this->Range = gtn::GetRange(this->Grid.Get(), this->Array, this->Component);
  for (int axis = 0; axis < 3 && this->Grid->GetNumberOfPoints() > 0; ++axis)
  {
    std::array<double, 2> range{};
    this->Grid->GetPoints()->GetData()->GetRange(range.data(), axis);
    this->Bounds[static_cast<std::size_t>(axis)] = { range[0], range[1] };
  }
  this->Tets = static_cast<std::uint64_t>(this->Grid->GetNumberOfCells());
}

//------------------------------------------------------------------------------
void RenderInput::Choose(const RenderInputOptions& options, const std::vector<ArrayChoice>& choices)
{
  this->Array = ChooseArray(options.Array, this->File, choices, "to draw");
  this->Component = ChooseComponent(options.Array, this->File, this->Array);
}

//------------------------------------------------------------------------------
void RenderInput::RequireContent() const
{
  if (this->Tets == 0)
  {
    throw Failure(this->File, "has no cells");
  }
  for (const gatun::Range& range : this->Bounds)
  {
    if (!(range.Min <= range.Max))
    {
      throw Failure(this->File, "has no finite coordinates");
    }
  }
}

//------------------------------------------------------------------------------
template <typename Consumer>
void RenderInput::ConnectTo(Consumer* consumer, int memory) const
{
  if (this->Reader)
  {
    this->Reader->SetMemoryBudget(memory);
    consumer->SetInputConnection(this->Reader->GetOutputPort());
  }
  else
  {
    consumer->SetInputData(this->Grid);
  }
  // The one without a name can only be drawn as the active one.
  consumer->SetArrayName(this->Array.Name.empty() ? nullptr : this->Array.Name.c_str());
  consumer->SetArrayAssociation(this->Array.Association);
  consumer->SetArrayComponent(this->Component);
}

//------------------------------------------------------------------------------
void RenderInput::Connect(vtkGatunRayCaster* caster, int memory) const
{
  this->ConnectTo(caster, memory);
}

//------------------------------------------------------------------------------
void RenderInput::Connect(vtkGatunDefaults* defaults, int memory) const
{
  this->ConnectTo(defaults, memory);
  defaults->SetUseTime(this->Time.has_value());
  defaults->SetTime(this->Time.value_or(0));
}

//------------------------------------------------------------------------------
void RenderInput::Draw(vtkGatunRayCaster* caster) const
{
  if (this->Time)
  {
    caster->UpdateTimeStep(*this->Time);
  }
  else
  {
    caster->Update();
  }
}
}
