// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// make-steps: time steps of a mesh, each in a .vtu file. steps: times to go forward through them,
// and through those of .gtn files.

#include "benchCases.h"
#include "benchFiles.h"

#include "gatunParallel.h"
#include "vtkGatunReader.h"

#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <filesystem>
#include <memory>

namespace bench
{
namespace
{
struct StepOptions
{
  std::string Mesh;
  std::string Folder;
  std::vector<std::string> Files;
  int Steps = 0;
  bool Moves = false;
  int Rounds = 3;
};

void MakeSteps(const StepOptions& options)
{
  const Grid mesh = Load(options.Mesh);
  for (int step = 0; step < options.Steps; ++step)
  {
    const std::string digits = std::to_string(10000 + step).substr(1);
    Write({ "vtu-zlib" }, MakeStep(mesh, step, options.Moves),
      options.Folder + "/step-" + digits + ".vtu");
  }
}

/** Adds the cells of all steps. */
void GoThroughGatun(const std::string& file, std::uint64_t& cells)
{
  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  vtkInformation* const information = reader->GetOutputInformation(0);
  const double* const times = information->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  const int count = information->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  for (int i = 0; i < count; ++i)
  {
    reader->UpdateTimeStep(times[i]);
    cells += static_cast<std::uint64_t>(reader->GetOutput()->GetNumberOfCells());
  }
}

void GoThroughFolder(const std::vector<std::string>& files, std::uint64_t& cells)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  for (const std::string& file : files)
  {
    reader->SetFileName(file.c_str());
    reader->Update();
    cells += static_cast<std::uint64_t>(reader->GetOutput()->GetNumberOfCells());
  }
}

std::vector<std::string> FindFiles(const std::string& folder)
{
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    if (entry.path().extension() == ".vtu")
    {
      files.push_back(entry.path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

void MeasureSteps(const StepOptions& options)
{
  const std::vector<std::string> peers = FindFiles(options.Folder);
  std::vector<std::uint64_t> cells(options.Files.size() + 1);
  std::vector<Operation> operations{ { "vtu", [&] { GoThroughFolder(peers, cells.back() = 0); } } };
  for (std::size_t i = 0; i < options.Files.size(); ++i)
  {
    operations.push_back(
      { options.Files[i], [&, i] { GoThroughGatun(options.Files[i], cells[i] = 0); } });
  }
  WarmUpAndRunInterleaved(operations, options.Rounds);
  if (std::count(cells.begin(), cells.end(), cells[0]) != static_cast<std::ptrdiff_t>(cells.size()))
  {
    throw Failure(options.Folder, "has other steps than the files");
  }
  std::uint64_t bytes = 0;
  for (const std::string& file : peers)
  {
    bytes += FileSize(file);
  }
  PrintJson(
    [&](Json::Value& json)
    {
      json["threads"] = gatun::GetNumberOfThreads();
      json["steps"] = static_cast<std::uint64_t>(peers.size());
      json["cells"] = cells[0]; // of all steps
      for (std::size_t i = 0; i < operations.size(); ++i)
      {
        json["bytes"].append(i == 0 ? bytes : FileSize(options.Files[i - 1]));
        json["seconds"].append(gtn::MakeJsonArray(operations[i].Seconds));
      }
    });
}
} // anonymous namespace

//------------------------------------------------------------------------------
void AddSteps(CLI::App& app)
{
  auto options = std::make_shared<StepOptions>();
  CLI::App* make =
    app.add_subcommand("make-steps", "Make time steps of a mesh, as zlib .vtu files of a folder");
  make->add_option("MESH", options->Mesh)->required();
  make->add_option("FOLDER", options->Folder)->required();
  make->add_option("--steps", options->Steps)->required()->check(CLI::Range(1, 9999));
  make->add_flag("--moves", options->Moves, "Points move");
  make->callback([options] { MakeSteps(*options); });

  CLI::App* steps = app.add_subcommand(
    "steps", "Times to go forward through the steps of a folder of .vtu files, and of .gtn files");
  steps->add_option("FOLDER", options->Folder)->required();
  steps->add_option("FILES", options->Files, "The same steps as .gtn files")->required();
  steps->add_option("--rounds", options->Rounds, "Rounds, after one to warm up")
    ->check(CLI::Range(1, 1000));
  steps->callback([options] { MeasureSteps(*options); });
}
}
