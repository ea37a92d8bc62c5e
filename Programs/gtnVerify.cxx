// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn verify: whether a file is intact, and whether it holds what another one holds.

#include "gtnCommands.h"
#include "gtnCompare.h"
#include "gtnFailure.h"
#include "gtnInput.h"
#include "gtnNames.h"
#include "gtnOptions.h"
#include "gtnProgress.h"
#include "gtnReadable.h"
#include "gtnText.h"

#include "gatunFileReader.h"
#include "gatunVerifyFile.h"

#include "vtkUnstructuredGrid.h"

#include <fmt/core.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gtn
{
namespace
{

struct Options
{
  std::string File;
  std::vector<std::string> Originals;
  InputOptions Input;
};

// Names to tell the two by, in messages.
std::pair<std::string, std::string> ShortNames(const std::string& first, const std::string& second)
{
  std::pair<std::string, std::string> names(FileOf(first), FileOf(second));
  return names.first == names.second ? std::pair(first, second) : names;
}

void CompareWithOriginals(const Options& options, const Settings& settings, std::uint8_t keptOrder)
{
  Input original(options.Originals, options.Input);
  Input packed({ options.File }, options.Input);
  const auto [nameOfPacked, nameOfOriginal] = ShortNames(options.File, original.GetName());

  const std::vector<double>& times = original.GetTimes();
  // A lone step may have lost or gained its time: the values are what counts.
  const std::size_t steps = std::max<std::size_t>(times.size(), 1);
  const std::size_t packedSteps = std::max<std::size_t>(packed.GetTimes().size(), 1);
  if (packedSteps != steps)
  {
    throw Failure(options.File,
      fmt::format("differs: {} time steps, not {} as {}", packedSteps, steps, nameOfOriginal));
  }
  Comparison comparison(nameOfPacked, nameOfOriginal, keptOrder);
  for (std::size_t step = 0; step < steps; ++step)
  {
    if (steps > 1 && times[step] != packed.GetTimes()[step])
    {
      throw Failure(options.File,
        fmt::format("differs: step {} is at time {}, not {} as in {}", step,
          Number(packed.GetTimes()[step]), Number(times[step]), nameOfOriginal));
    }
    Progress progress(steps > 1 ? fmt::format("comparing step {} of {}", step + 1, steps)
                                : std::string("comparing"),
      settings.ShowProgress);
    vtkUnstructuredGrid* a = packed.Read(step, progress);
    vtkUnstructuredGrid* b = original.Read(step, progress);
    const std::string difference = comparison.Compare(GridView(a), GridView(b));
    CheckInterrupt();
    if (!difference.empty())
    {
      throw Failure(options.File,
        steps > 1
          ? fmt::format("differs at step {} (time {}): {}", step, Number(times[step]), difference)
          : "differs: " + difference);
    }
  }
  if (!settings.Quiet)
  {
    fmt::print("{}: identical to {}{}{}\n", options.File, original.GetName(),
      options.Originals.size() > 1 ? fmt::format(" and {} more", options.Originals.size() - 1) : "",
      steps > 1 ? fmt::format(", {} time steps", steps) : "");
    if (settings.Verbose && comparison.GetAmbiguousPoints() > 0)
    {
      fmt::print("  {} points coincide with others in all values and neighbours\n",
        Grouped(comparison.GetAmbiguousPoints()));
    }
  }
}

// "12 chunks, 3 arrays, 2 time steps, the order of points, cells".
std::string ListChecked(const gatun::FileReader& file)
{
  const auto count = [](std::size_t number, const std::string& what)
  { return fmt::format("{} {}{}", Grouped(number), what, number == 1 ? "" : "s"); };
  std::vector<std::string> parts{ count(file.GetChunks().size(), "chunk"),
    count(file.GetArrays().size(), "array") };
  if (file.HasTime())
  {
    parts.push_back(count(file.GetNumberOfSteps(), "time step"));
  }
  if (file.GetKeptOrder() != gatun::KeepNone)
  {
    parts.push_back("the order of " + NameOfOrder(file.GetKeptOrder()));
  }
  return Joined(parts);
}

void Verify(const Options& options, const Settings& settings)
{
  CheckReadable(options.File);
  const auto file = std::make_shared<const gatun::FileReader>(options.File);
  {
    Progress progress("checking", settings.ShowProgress);
    if (!VerifyFile(*file, std::ref(progress)))
    {
      throw Interrupted();
    }
  }
  if (!options.Originals.empty())
  {
    CompareWithOriginals(options, settings, file->GetKeptOrder());
  }
  else if (!settings.Quiet)
  {
    fmt::print("{}: intact: all checksums are right, and everything decodes ({})\n", options.File,
      ListChecked(*file));
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddVerify(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<Options>();
  CLI::App* command = AddCommand(app, settings, "verify",
    "Check that a .gtn file is intact: all checksums, and that all of it decodes. With ORIGINAL,\n"
    "also that nothing differs from it, bit by bit, at any time step; where the file does not "
    "keep\n"
    "the order of points or cells, up to that order. Says what differs first; the exit code is 1.",
    "  gtn verify mesh.gtn\n"
    "  gtn verify mesh.gtn mesh.vtu\n"
    "  gtn verify run.gtn run_0.vtu run_1.vtu run_2.vtu");
  AddArrays(command, options->Input, "Compare only these point and cell arrays");
  command->add_flag(
    "--linearize", options->Input.Linearize, "ORIGINAL was packed with --linearize");
  command->add_option("IN", options->File, "The .gtn file")->required();
  command->add_option(
    "ORIGINAL", options->Originals, "What was packed: one file, or one a time step");
  command->callback(
    [=, &settings]
    {
      options->Input.Quiet = settings.Quiet;
      Verify(*options, settings);
    });
}
}
