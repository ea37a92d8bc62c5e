// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Measures operations, Gatun's and those of its peers, in one run. GATUN_DATA_DIR names the folder
// of the meshes (.vtu) to measure with.

#include "gatunVersion.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace
{

void LoadVtu(benchmark::State& state, const std::string& file)
{
  vtkIdType cells = 0;
  for ([[maybe_unused]] auto _ : state)
  {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    cells += reader->GetOutput()->GetNumberOfCells();
  }
  state.SetItemsProcessed(cells);
}

} // anonymous namespace

int main(int argc, char* argv[])
{
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    return 2;
  }
  benchmark::AddCustomContext("gatun", gatun::PackageVersion());
  if (const char* folder = std::getenv("GATUN_DATA_DIR"))
  {
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
      if (entry.path().extension() == ".vtu")
      {
        benchmark::RegisterBenchmark(
          ("load/vtu/" + entry.path().stem().string()).c_str(), LoadVtu, entry.path().string())
          ->Unit(benchmark::kMillisecond);
      }
    }
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
