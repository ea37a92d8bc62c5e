// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnStepChooser.h"

#include "gtnFailure.h"
#include "gtnParse.h"
#include "gtnTimes.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <string_view>

namespace gtn
{
vtkStandardNewMacro(StepChooser);

namespace
{

// FIRST:LAST:STRIDE, of which each may be left out, or one number.
std::optional<StepRange> ParseSteps(std::string_view text)
{
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();)
  {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  std::vector<std::optional<std::size_t>> numbers;
  for (const std::string_view part : parts)
  {
    numbers.push_back(Parse<std::size_t>(part));
    if (!numbers.back() && (!part.empty() || parts.size() == 1))
    {
      return {};
    }
  }
  constexpr std::size_t most = 3;
  if (numbers.size() > most)
  {
    return {};
  }
  StepRange range;
  range.First = numbers[0].value_or(0);
  range.Last = numbers.size() == 1 ? numbers[0] : numbers[1];
  range.Stride = numbers.size() == most ? numbers[2].value_or(1) : 1;
  return range.Stride > 0 && range.First <= range.Last.value_or(range.First) ? std::optional(range)
                                                                             : std::nullopt;
}

} // anonymous namespace

//------------------------------------------------------------------------------
CLI::Option* AddSteps(CLI::App* command, std::optional<StepRange>& steps)
{
  return command
    ->add_option_function<std::string>(
      "--steps",
      [&steps](const std::string& text)
      {
        steps = ParseSteps(text);
        if (!steps)
        {
          Refuse("--steps", text, "FIRST:LAST:STRIDE with numbers from 0, FIRST up to LAST");
        }
      },
      "Only these time steps: those from FIRST to LAST, numbered from 0, and of these each "
      "STRIDE-th. Any of the three may be left out; a single number is one step (default: all)")
    ->option_text("FIRST:LAST:STRIDE");
}

//------------------------------------------------------------------------------
std::vector<std::size_t> ChooseSteps(
  const StepRange& range, std::size_t steps, const std::string& file)
{
  if (steps == 0)
  {
    throw Failure(file, "has no time steps, and --steps chooses some");
  }
  const std::size_t last = range.Last.value_or(steps - 1);
  if (range.First >= steps || last >= steps)
  {
    throw Failure(file,
      fmt::format("has no step {} as --steps wants; they are numbered 0 to {}",
        range.First >= steps ? range.First : last, steps - 1));
  }
  std::vector<std::size_t> chosen{ range.First };
  while (last - chosen.back() >= range.Stride)
  {
    chosen.push_back(chosen.back() + range.Stride);
  }
  return chosen;
}

//------------------------------------------------------------------------------
void StepChooser::SetTimes(const std::vector<double>& times)
{
  this->Times = times;
  this->Modified();
}

//------------------------------------------------------------------------------
int StepChooser::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  PublishTimes(outputVector->GetInformationObject(0), this->Times);
  return 1;
}

//------------------------------------------------------------------------------
int StepChooser::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject::GetData(outputVector)->ShallowCopy(vtkDataObject::GetData(inputVector[0]));
  return 1;
}
}
