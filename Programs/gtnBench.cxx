// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn bench: how fast and how large, against VTK's own files.

#include "gtnCommands.h"
#include "gtnFailure.h"
#include "gtnGridWriter.h"
#include "gtnInput.h"
#include "gtnJson.h"
#include "gtnMessages.h"
#include "gtnProgress.h"
#include "gtnText.h"
#include "gtnThreads.h"
#include "gtnWriteGatun.h"

#include "gatunVersion.h"
#include "vtkGatunReader.h"

#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersion.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <thread>

namespace gtn
{
namespace
{

struct BenchOptions
{
  std::string In;
  std::string Folder;
  int Repeat = 5;
  std::vector<int> Threads;
  bool Json = false;
};

// A folder that goes with everything in it.
class TemporaryFolder
{
public:
  explicit TemporaryFolder(const std::string& parent)
  {
    std::random_device random;
    this->Path =
      parent.empty() ? std::filesystem::temp_directory_path() : std::filesystem::path(parent);
    this->Path /= fmt::format("gtn-bench-{:08x}", random());
    std::error_code error;
    std::filesystem::create_directory(this->Path, error);
    if (error)
    {
      throw Failure(this->Path.string(), error.message());
    }
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Path, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string File(const std::string& name) const { return (this->Path / name).string(); }

private:
  std::filesystem::path Path;
};

struct Format
{
  std::string Name;
  std::string File;
  std::function<vtkIdType(const std::string&)> Load; ///< returns the number of cells
  std::uint64_t Bytes = 0;
  double WriteSeconds = 0;
};

struct Case
{
  std::size_t Format;
  int Threads;
  std::vector<double> Seconds;

  double Median() const
  {
    std::vector<double> sorted = this->Seconds;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t middle = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
  }
};

double SecondsOf(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <typename Reader>
vtkIdType Load(const std::string& file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  CheckMessages(file, true);
  return reader->GetOutput()->GetNumberOfCells();
}

std::string NameOfProcessor()
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
  {
    if (line.starts_with("model name"))
    {
      return line.substr(std::min(line.size(), line.find(": ") + 2));
    }
  }
  return "unknown";
}

std::vector<Format> WriteFormats(
  vtkUnstructuredGrid* grid, const TemporaryFolder& folder, bool showProgress)
{
  std::vector<Format> formats{ { "gtn", folder.File("mesh.gtn"), Load<vtkGatunReader> },
    { "vtu-raw", folder.File("raw.vtu"), Load<vtkXMLUnstructuredGridReader> },
    { "vtu-zlib", folder.File("zlib.vtu"), Load<vtkXMLUnstructuredGridReader> },
    { "vtu-lzma", folder.File("lzma.vtu"), Load<vtkXMLUnstructuredGridReader> } };
  constexpr Compressor compressors[] = { Compressor::None, Compressor::None, Compressor::ZLib,
    Compressor::LZMA };
  for (std::size_t i = 0; i < formats.size(); ++i)
  {
    Format& format = formats[i];
    Progress progress("writing " + format.Name, showProgress);
    format.WriteSeconds = SecondsOf(
      [&]
      {
        if (i == 0)
        {
          WriteGatun(grid, format.File, progress);
        }
        else
        {
          WriteGrid(grid, format.File, compressors[i], progress);
        }
      });
    format.Bytes = std::filesystem::file_size(format.File);
  }
  return formats;
}

// All cases once, and again, so that what disturbs the machine disturbs all alike.
std::vector<Case> LoadAll(const std::vector<Format>& formats, const BenchOptions& options,
  vtkIdType cells, bool showProgress)
{
  std::vector<Case> cases;
  for (const int threads : options.Threads)
  {
    for (std::size_t i = 0; i < formats.size(); ++i)
    {
      cases.push_back({ i, threads, {} });
    }
  }
  Progress progress("loading", showProgress);
  const double rounds = options.Repeat + 1; // the first one warms up
  for (int round = 0; round <= options.Repeat; ++round)
  {
    for (std::size_t i = 0; i < cases.size(); ++i)
    {
      progress((round + static_cast<double>(i) / static_cast<double>(cases.size())) / rounds);
      CheckInterrupt();
      Case& one = cases[i];
      const Format& format = formats[one.Format];
      vtkIdType loaded = 0;
      double seconds = 0;
      WithThreads(
        one.Threads, [&] { seconds = SecondsOf([&] { loaded = format.Load(format.File); }); });
      if (loaded != cells)
      {
        throw Failure(format.File, fmt::format("read {} cells, not {}", loaded, cells));
      }
      if (round > 0)
      {
        one.Seconds.push_back(seconds);
      }
    }
  }
  return cases;
}

void PrintText(const std::vector<Format>& formats, const std::vector<Case>& cases, vtkIdType number)
{
  const auto cells = static_cast<double>(number);
  fmt::print(
    "{:<10} {:>14} {:>10} {:>10} {:>9}\n", "file", "bytes", "bits/cell", "gtn is", "write s");
  for (const Format& format : formats)
  {
    fmt::print("{:<10} {:>14} {:>10.2f} {:>9.2f}x {:>9.3f}\n", format.Name, Grouped(format.Bytes),
      8. * static_cast<double>(format.Bytes) / cells,
      static_cast<double>(format.Bytes) / static_cast<double>(formats[0].Bytes),
      format.WriteSeconds);
  }
  fmt::print(
    "\n{:<10} {:>8} {:>10} {:>10} {:>10}\n", "load", "threads", "median s", "M cells/s", "gtn is");
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    const Case& one = cases[i];
    const Case& gtn = cases[i - one.Format];
    fmt::print("{:<10} {:>8} {:>10.4f} {:>10.2f} {:>9.2f}x\n", formats[one.Format].Name,
      one.Threads, one.Median(), cells / one.Median() / 1e6, one.Median() / gtn.Median());
  }
}

void PrintJson(const std::vector<Format>& formats, const std::vector<Case>& cases,
  const BenchOptions& options, vtkUnstructuredGrid* grid)
{
  const auto cells = static_cast<double>(grid->GetNumberOfCells());
  Json::Value json;
  json["input"] = options.In;
  json["cells"] = static_cast<std::uint64_t>(grid->GetNumberOfCells());
  json["points"] = static_cast<std::uint64_t>(grid->GetNumberOfPoints());
  json["machine"]["processor"] = NameOfProcessor();
  json["machine"]["processors"] = static_cast<std::uint64_t>(std::thread::hardware_concurrency());
  json["machine"]["gatun"] = gatun::PackageVersion();
  json["machine"]["vtk"] = vtkVersion::GetVTKVersion();
  json["machine"]["smpBackend"] = ThreadBackend();
  json["files"] = Json::arrayValue;
  for (const Format& format : formats)
  {
    Json::Value fileJson;
    fileJson["format"] = format.Name;
    fileJson["bytes"] = format.Bytes;
    fileJson["bitsPerCell"] = 8. * static_cast<double>(format.Bytes) / cells;
    fileJson["timesGtn"] =
      static_cast<double>(format.Bytes) / static_cast<double>(formats[0].Bytes);
    fileJson["writeSeconds"] = format.WriteSeconds;
    json["files"].append(fileJson);
  }
  json["loads"] = Json::arrayValue;
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    const Case& one = cases[i];
    Json::Value loadJson;
    loadJson["format"] = formats[one.Format].Name;
    loadJson["threads"] = one.Threads;
    loadJson["seconds"] = Json::arrayValue;
    for (const double seconds : one.Seconds)
    {
      loadJson["seconds"].append(seconds);
    }
    loadJson["median"] = one.Median();
    loadJson["cellsPerSecond"] = cells / one.Median();
    loadJson["timesGtn"] = one.Median() / cases[i - one.Format].Median();
    json["loads"].append(loadJson);
  }
  fmt::print("{}", JsonText(json));
}

void Bench(BenchOptions options, const Settings& settings)
{
  if (options.Threads.empty())
  {
    options.Threads = { 1 };
    const int most = static_cast<int>(std::thread::hardware_concurrency());
    if (most > 1)
    {
      options.Threads.push_back(most);
    }
  }
  InputOptions inputOptions;
  inputOptions.Quiet = settings.Quiet;
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  {
    Input input({ options.In }, inputOptions);
    Progress progress("reading", settings.ShowProgress);
    grid = input.ReadGrid(0, progress);
  }
  if (grid->GetNumberOfCells() == 0)
  {
    throw Failure(options.In, "has no cells");
  }
  const TemporaryFolder folder(options.Folder);
  const std::vector<Format> formats = WriteFormats(grid, folder, settings.ShowProgress);
  const std::vector<Case> cases =
    LoadAll(formats, options, grid->GetNumberOfCells(), settings.ShowProgress);
  if (options.Json)
  {
    PrintJson(formats, cases, options, grid);
  }
  else
  {
    PrintText(formats, cases, grid->GetNumberOfCells());
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddBench(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = AddCommand(app, settings, "bench",
    "Measure the size, writing time and loading time of a mesh as .gtn and as .vtu (raw, zlib and "
    "LZMA).\n"
    "The files are written to a temporary folder. Rounds are interleaved, and medians are printed. "
    "Only\n"
    "the first time step of a mesh is used.",
    "  gtn bench mesh.vtu\n"
    "  gtn bench --repeat 9 --threads 1,2,4 --json mesh.vtu > bench.json",
    false);
  command
    ->add_option("--repeat", options->Repeat,
      "Number of measured rounds after a warm-up round, 1 to 1000 (default: 5)")
    ->check(CLI::Range(1, 1000))
    ->option_text("N");
  command
    ->add_option("--threads", options->Threads,
      "Numbers of threads for loading, 1 to 1024 each (default: 1, and one per processor)")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->check(CLI::Range(1, 1024))
    ->option_text("N,...");
  command
    ->add_option(
      "--folder", options->Folder, "Parent of the temporary folder (default: that of the system)")
    ->option_text("FOLDER");
  command->add_flag("--json", options->Json, "Print JSON");
  command->add_option("IN", options->In, std::string("The mesh: ") + InputFormats)->required();
  command->callback([options, &settings] { Bench(*options, settings); });
}
}
