// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnArray.h"

#include "gtnFailure.h"
#include "gtnParse.h"
#include "gtnText.h"

#include "gatunFileReader.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

namespace gtn
{
namespace
{
[[noreturn]] void FailForName(
  const std::string& name, const std::string& file, const std::vector<ArrayChoice>& choices)
{
  throw Failure(file,
    fmt::format("has no array '{}'; there are {}", MakePrintableLine(name),
      choices.empty() ? "none" : NamesOf(choices)));
}

int ParseComponent(const std::string& text)
{
  const int component = text == "magnitude" ? -1 : Parse<int>(text).value_or(-2);
  if (component < -1 || text == "-1")
  {
    Refuse("--component", text, "a number from 0 or 'magnitude'");
  }
  return component;
}
}

//------------------------------------------------------------------------------
std::array<CLI::Option*, 2> AddArray(
  CLI::App* command, ArrayOptions& options, const std::string& what)
{
  CLI::Option* const array = command
                               ->add_option("--array", options.Name,
                                 what + " (default: the active scalars, or else the first array)")
                               ->option_text("NAME");
  CLI::Option* const component =
    command
      ->add_option_function<std::string>(
        "--component",
        [&options](const std::string& text) { options.Component = ParseComponent(text); },
        "Component of the array: a number from 0, or magnitude (default: magnitude)")
      ->option_text("N|magnitude");
  return { array, component };
}

//------------------------------------------------------------------------------
std::vector<ArrayChoice> GetChoices(const gatun::FileReader& file)
{
  std::vector<ArrayChoice> choices;
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
  return choices;
}

//------------------------------------------------------------------------------
std::vector<ArrayChoice> GetChoices(vtkDataSet* mesh)
{
  std::vector<ArrayChoice> choices;
  for (const int association : { 0, 1 })
  {
    vtkDataSetAttributes* const data = mesh->GetAttributes(association);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      if (vtkDataArray* const array = data->GetArray(i))
      {
        choices.push_back(
          { array->GetName() ? array->GetName() : "", association, array->GetNumberOfComponents(),
            array == data->GetScalars(), static_cast<std::size_t>(i) });
      }
    }
  }
  return choices;
}

//------------------------------------------------------------------------------
ArrayChoice ChooseArray(const ArrayOptions& options, const std::string& file,
  const std::vector<ArrayChoice>& choices, const std::string& purpose)
{
  const auto find = [&choices](auto&& fits)
  { return std::find_if(choices.begin(), choices.end(), fits); };
  auto chosen = choices.end();
  if (!options.Name.empty())
  {
    chosen = find([&options](const ArrayChoice& choice) { return choice.Name == options.Name; });
  }
  else
  {
    chosen = find([](const ArrayChoice& choice) { return choice.Active; });
    if (chosen == choices.end())
    {
      // Ghost flags and the like are not what anybody wants to see.
      chosen = find([](const ArrayChoice& choice)
        { return !choice.Name.empty() && !choice.Name.starts_with("vtk"); });
    }
  }
  if (chosen == choices.end())
  {
    if (!options.Name.empty())
    {
      FailForName(options.Name, file, choices);
    }
    throw Failure(file,
      fmt::format(
        "has no array {}; there are {}", purpose, choices.empty() ? "none" : NamesOf(choices)));
  }
  return *chosen;
}

//------------------------------------------------------------------------------
int ChooseComponent(const ArrayOptions& options, const std::string& file, const ArrayChoice& array)
{
  const int component = options.Component.value_or(-1);
  if (component >= array.Components)
  {
    throw Failure(file,
      fmt::format("array '{}' has no component {}; they are numbered 0 to {}",
        MakePrintableLine(array.Name), component, array.Components - 1));
  }
  return array.Components == 1 ? 0 : component; // its length would be without the sign
}

//------------------------------------------------------------------------------
gatun::Range GetRange(
  const gatun::FileReader& file, const ArrayChoice& array, int component, std::size_t step)
{
  const gatun::ArrayRanges& ranges = file.GetRanges(array.Index, step);
  return component < 0 ? ranges.back() : ranges.at(static_cast<std::size_t>(component));
}

//------------------------------------------------------------------------------
gatun::Range GetRange(vtkDataSet* mesh, const ArrayChoice& array, int component)
{
  std::array<double, 2> range{};
  mesh->GetAttributes(array.Association)
    ->GetArray(static_cast<int>(array.Index))
    ->GetRange(range.data(), component);
  return { range[0], range[1] };
}

//------------------------------------------------------------------------------
void CheckNames(const std::vector<std::string>& names, const std::string& file,
  const std::vector<ArrayChoice>& choices)
{
  for (const std::string& name : names)
  {
    if (std::none_of(choices.begin(), choices.end(),
          [&name](const ArrayChoice& choice) { return choice.Name == name; }))
    {
      FailForName(name, file, choices);
    }
  }
}

//------------------------------------------------------------------------------
std::string NamesOf(const std::vector<ArrayChoice>& choices)
{
  std::vector<std::string> names;
  names.reserve(choices.size());
  for (const ArrayChoice& choice : choices)
  {
    names.push_back(choice.Name.empty() ? "(no name)" : MakePrintableLine(choice.Name));
  }
  return Join(names);
}
}
