// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnRenderInput.h"

#include "gtnFailure.h"
#include "gtnInput.h"
#include "gtnMessages.h"
#include "gtnProgress.h"
#include "gtnText.h"

#include "gatunFileReader.h"
#include "vtkGatunRayCaster.h"
#include "vtkGatunReader.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <fmt/core.h>

#include <algorithm>
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
  const gatun::FileReader file(this->File);
  static const std::vector<double> none;
  const std::vector<double>& times = file.HasTime() ? file.GetTimes() : none;
  const std::size_t step = ChooseStep(options.Step, this->File, times, options.Quiet);
  if (!times.empty())
  {
    this->Time = times[step];
  }

  std::vector<Choice> choices;
  for (const auto where : { gatun::Association::Point, gatun::Association::Cell })
  {
    for (std::size_t i = 0; i < file.GetArrays().size(); ++i)
    {
      const gatun::ArrayDescription& array = file.GetArrays()[i];
      if (array.Where == where)
      {
        constexpr std::uint32_t scalars = 1;
        choices.push_back({ array.Name, where == gatun::Association::Point ? 0 : 1,
          static_cast<int>(array.Components), (array.AttributeRoles & scalars) != 0, i });
      }
    }
  }
  this->Choose(options, choices);
  const gatun::ArrayRanges& ranges = file.GetRanges(this->Array.Index, step);
  this->Range =
    this->Component < 0 ? ranges.back() : ranges.at(static_cast<std::size_t>(this->Component));
  this->Bounds = file.GetBounds();
  this->Tets = file.GetNumberOfTets();

  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(this->File.c_str());
  this->Reader = reader;
}

//------------------------------------------------------------------------------
void RenderInput::Read(const RenderInputOptions& options, Progress& progress)
{
  InputOptions inputOptions;
  inputOptions.Linearize = true; // the caster draws nothing else
  inputOptions.Quiet = options.Quiet;
  Input input({ this->File }, inputOptions);
  const std::size_t step = ChooseStep(options.Step, this->File, input.GetTimes(), options.Quiet);
  this->Grid = input.Read(step, progress);

  std::vector<Choice> choices;
  std::vector<vtkDataArray*> arrays;
  for (const int association : { 0, 1 })
  {
    vtkDataSetAttributes* const data = this->Grid->GetAttributes(association);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      if (vtkDataArray* const array = data->GetArray(i))
      {
        choices.push_back({ array->GetName() ? array->GetName() : "", association,
          array->GetNumberOfComponents(), array == data->GetScalars(), arrays.size() });
        arrays.push_back(array);
      }
    }
  }
  this->Choose(options, choices);
  const auto toRange = [](vtkDataArray* array, int component)
  {
    std::array<double, 2> range{};
    array->GetRange(range.data(), component);
    return gatun::Range{ range[0], range[1] };
  };
  this->Range = toRange(arrays[this->Array.Index], this->Component);
  for (int axis = 0; axis < 3 && this->Grid->GetNumberOfPoints() > 0; ++axis)
  {
    this->Bounds[static_cast<std::size_t>(axis)] =
      toRange(this->Grid->GetPoints()->GetData(), axis);
  }
  this->Tets = static_cast<std::uint64_t>(this->Grid->GetNumberOfCells());
}

//------------------------------------------------------------------------------
void RenderInput::Choose(const RenderInputOptions& options, const std::vector<Choice>& choices)
{
  const auto find = [&choices](auto&& fits)
  { return std::find_if(choices.begin(), choices.end(), fits); };
  auto chosen = choices.end();
  if (!options.Array.empty())
  {
    chosen = find([&options](const Choice& choice) { return choice.Name == options.Array; });
  }
  else
  {
    chosen = find([](const Choice& choice) { return choice.Active; });
    if (chosen == choices.end())
    {
      // Ghost flags and the like are not what anybody wants to see.
      chosen = find([](const Choice& choice)
        { return !choice.Name.empty() && !choice.Name.starts_with("vtk"); });
    }
  }
  if (chosen == choices.end())
  {
    std::vector<std::string> names;
    for (const Choice& choice : choices)
    {
      names.push_back(choice.Name.empty() ? "(no name)" : Printable(choice.Name));
    }
    const std::string others = names.empty() ? "there are none" : "there are " + Joined(names);
    throw Failure(this->File,
      options.Array.empty()
        ? "has no array to draw; " + others
        : fmt::format("has no array '{}'; {}", Printable(options.Array), others));
  }
  this->Array = *chosen;
  const int components = this->Array.Components;
  this->Component = options.Component.value_or(-1);
  if (this->Component >= components)
  {
    throw Failure(this->File,
      fmt::format("array '{}' has no component {}; they are numbered 0 to {}",
        Printable(this->Array.Name), this->Component, components - 1));
  }
  if (components == 1)
  {
    this->Component = 0; // its length would be without the sign
  }
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
void RenderInput::Connect(vtkGatunRayCaster* caster) const
{
  if (this->Reader)
  {
    caster->SetInputConnection(this->Reader->GetOutputPort());
  }
  else
  {
    caster->SetInputData(this->Grid);
  }
  // The one without a name can only be drawn as the active one.
  caster->SetArrayName(this->Array.Name.empty() ? nullptr : this->Array.Name.c_str());
  caster->SetArrayAssociation(this->Array.Association);
  caster->SetArrayComponent(this->Component);
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
