// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// gtn verify: checks a file, and compares it with another one.

#include "gtnAlign.h"
#include "gtnBounds.h"
#include "gtnCommands.h"
#include "gtnCompare.h"
#include "gtnFailure.h"
#include "gtnFileSteps.h"
#include "gtnInput.h"
#include "gtnMessages.h"
#include "gtnNames.h"
#include "gtnOptions.h"
#include "gtnProgress.h"
#include "gtnReadable.h"
#include "gtnReaders.h"
#include "gtnStepChooser.h"
#include "gtnText.h"

#include "gatunBlockArrays.h"
#include "gatunCellInput.h"
#include "gatunFileReader.h"
#include "gatunGhosts.h"
#include "gatunSurfaceGrid.h"
#include "gatunVerifyFile.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace gtn
{
namespace
{

struct VerifyOptions
{
  std::string File;
  std::vector<std::string> Originals;
  InputOptions Input;
  bool NoSets = false;
  bool FillMissing = false;
};

// Distinct names for messages.
std::pair<std::string, std::string> ShortNames(const std::string& first, const std::string& second)
{
  std::pair<std::string, std::string> names(FileOf(first), FileOf(second));
  return names.first == names.second ? std::pair(first, second) : names;
}

// Whether a file was packed with the sets of its original: then it has as many cells.
bool HasSetsIn(
  const std::vector<std::string>& originals, InputOptions options, const gatun::FileReader& file)
{
  if (originals.size() > 1 || ListSets(originals.front()).empty())
  {
    return false;
  }
  options.Sets = true;
  options.Quiet = true;
  options.Lost = std::make_shared<std::set<std::string>>();
  Input input(originals, options);
  Progress progress("reading", false);
  auto* const data = vtkDataSet::SafeDownCast(input.Read(0, progress));
  return data && static_cast<std::uint64_t>(data->GetNumberOfCells()) == file.GetNumberOfCells();
}

// Whether a file has what 'gtn pack' tells of blocks; the files of a mesh in pieces are none.
bool HasBlocks(Input& packed, const Settings& settings)
{
  Progress progress("reading", settings.ShowProgress);
  vtkFieldData* const field = packed.Read(0, progress)->GetFieldData();
  return field->HasArray(gatun::BlockNamesName);
}

vtkSmartPointer<vtkUnstructuredGrid> GridOf(vtkDataObject* data)
{
  auto* const surface = vtkPolyData::SafeDownCast(data);
  return surface ? gatun::MakeSurfaceGrid(surface)
                 : vtkSmartPointer<vtkUnstructuredGrid>(vtkUnstructuredGrid::SafeDownCast(data));
}

// Compares a file with its original, and keeps what differs.
class Verification
{
public:
  Verification(const VerifyOptions& options, const Settings& how, FileSteps& file);

  /** Throws Failure unless the file is identical. */
  void Run();

private:
  void CompareTimes();
  void CompareStep(std::size_t ofPacked, std::size_t ofOriginal, Progress& progress);
  vtkSmartPointer<vtkUnstructuredGrid> WithoutGhosts(
    const vtkSmartPointer<vtkUnstructuredGrid>& original, vtkUnstructuredGrid* packedGrid);
  void Add(const std::string& difference);
  void Report() const;
  void ReportIdentical() const;

  const VerifyOptions& Options;
  const Settings& How;
  FileSteps& File;
  std::shared_ptr<std::set<std::string>> Lost;
  std::unique_ptr<Input> Original;
  std::unique_ptr<Input> Packed;
  std::string NameOfPacked;
  std::string NameOfOriginal;
  std::unique_ptr<Comparison> Values;
  std::unique_ptr<BoundedComparison> Bounded;
  std::vector<std::pair<std::size_t, std::size_t>> Steps; // of both, with the same time
  std::shared_ptr<const gatun::FileReader> Mesh;          // of the step before
  bool RolesDiffer = false;                               // at a later step than the first
  Differences Found;
  std::set<std::string> Known; // what was found
};

Verification::Verification(const VerifyOptions& options, const Settings& how, FileSteps& file)
  : Options(options)
  , How(how)
  , File(file)
  , Lost(std::make_shared<std::set<std::string>>())
{
  InputOptions input = options.Input;
  input.Skip.clear(); // the file may well be without
  input.Steps.reset();
  this->Packed = std::make_unique<Input>(std::vector{ options.File }, input);
  input = options.Input;
  input.Lost = this->Lost;
  input.InPieces = !HasBlocks(*this->Packed, how);
  input.Sets = !options.NoSets && HasSetsIn(options.Originals, input, file.GetFile());
  input.NamesSets = !options.NoSets;
  this->Original = std::make_unique<Input>(options.Originals, input);
  std::tie(this->NameOfPacked, this->NameOfOriginal) =
    ShortNames(options.File, this->Original->GetName());
  this->Values = std::make_unique<Comparison>(
    this->NameOfPacked, this->NameOfOriginal, file.GetFile().GetKeptOrder());
  if (this->Original->IsInFiles())
  {
    this->Values->AllowJoined();
  }
  this->Bounded = std::make_unique<BoundedComparison>(*this->Values);
}

void Verification::Add(const std::string& difference)
{
  if (this->Known.insert(difference).second)
  {
    this->Found.push_back(difference);
  }
}

// Pairs the steps of the same times.
void Verification::CompareTimes()
{
  const std::vector<double>& times = this->Original->GetTimes();
  const std::vector<double>& packed = this->Packed->GetTimes();
  const std::size_t steps = std::max<std::size_t>(times.size(), 1);
  const std::size_t packedSteps = std::max<std::size_t>(packed.size(), 1);
  if (packedSteps != steps)
  {
    this->Add(fmt::format("{} time steps, not {} as {}", packedSteps, steps, this->NameOfOriginal));
  }
  if (steps == 1 && packedSteps == 1)
  {
    this->Steps.emplace_back(0, 0); // the values count, whatever their times
    if (packed.empty() && !times.empty())
    {
      this->Add(
        fmt::format("no time, not {} as in {}", DescribeNumber(times[0]), this->NameOfOriginal));
      return;
    }
  }
  for (std::size_t step = 0; step < times.size(); ++step)
  {
    const auto found = std::find(packed.begin(), packed.end(), times[step]);
    if (found != packed.end())
    {
      if (steps > 1 || packedSteps > 1)
      {
        this->Steps.emplace_back(static_cast<std::size_t>(found - packed.begin()), step);
      }
    }
    else if (steps == packedSteps)
    {
      this->Add(fmt::format("step {} is at time {}, not {} as in {}", step,
        DescribeNumber(packed[step]), DescribeNumber(times[step]), this->NameOfOriginal));
    }
    else
    {
      this->Add(fmt::format(
        "the step at time {} is in {} only", DescribeNumber(times[step]), this->NameOfOriginal));
    }
  }
}

// The original without its ghost cells, if the file has none, which is a difference.
vtkSmartPointer<vtkUnstructuredGrid> Verification::WithoutGhosts(
  const vtkSmartPointer<vtkUnstructuredGrid>& original, vtkUnstructuredGrid* packedGrid)
{
  if (gatun::CountGhosts(original->GetCellData()) == 0 ||
    gatun::CountGhosts(packedGrid->GetCellData()) > 0)
  {
    return original;
  }
  const auto cells = gatun::MakeCellInput(original, false, gatun::GhostCells::Remove);
  this->Add(fmt::format("{} ghost cells of {} are missing; --no-ghosts compares without them",
    cells.GhostCells, this->NameOfOriginal));
  return cells.Grid;
}

void Verification::CompareStep(std::size_t ofPacked, std::size_t ofOriginal, Progress& progress)
{
  vtkDataObject* const a = this->Packed->Read(ofPacked, progress);
  vtkDataObject* const b = this->Original->Read(ofOriginal, progress);
  Differences differences;
  if (a->GetDataObjectType() != b->GetDataObjectType())
  {
    differences.push_back(
      fmt::format("it is a {}, not a {}", a->GetClassName(), b->GetClassName()));
  }
  else
  {
    const bool isFirst = ofOriginal == this->Steps.front().second;
    const auto first = GridOf(a);
    const auto second = AlignArrays(this->WithoutGhosts(GridOf(b), first), first,
      { this->Steps.size() > 1, isFirst, this->Options.FillMissing }, this->RolesDiffer);
    const FileSteps::Place place = this->File.Find(ofPacked);
    if (std::exchange(this->Mesh, place.Mesh) != place.Mesh)
    {
      this->Bounded->BeginMesh();
    }
    differences =
      this->Bounded->Compare(GridView(first), GridView(second), *place.Mesh, place.Step);
  }
  CheckInterrupt();
  for (const std::string& difference : differences)
  {
    if (this->Known.insert(difference).second)
    {
      this->Found.push_back(this->Steps.size() > 1
          ? fmt::format("at step {} (time {}): {}", ofOriginal,
              DescribeNumber(this->Original->GetTimes()[ofOriginal]), difference)
          : difference);
    }
  }
}

void Verification::Report() const
{
  const auto text = [](const std::string& difference)
  { return (difference.starts_with("at step ") ? "differs " : "differs: ") + difference; };
  if (this->Found.size() == 1)
  {
    throw Failure(this->Options.File, text(this->Found.front()));
  }
  for (const std::string& difference : this->Found)
  {
    Say(this->Options.File + ": " + text(difference));
  }
  throw Failure(this->Options.File,
    fmt::format("there are {} differences to {}", this->Found.size(), this->NameOfOriginal));
}

void Verification::ReportIdentical() const
{
  const std::size_t alike = this->Values->GetIndistinguishablePoints();
  const std::size_t files = this->Options.Originals.size();
  const std::size_t joined = this->Values->GetJoinedPoints();
  const std::string joins = joined > 0
    ? fmt::format(
        " but for {} points that its files have in common and that are joined", GroupDigits(joined))
    : "";
  const std::string errors = this->Bounded->HasBounds()
    ? fmt::format(" but for bounded errors, of which the largest is {:.6f} of its bound",
        this->Bounded->GetWorst())
    : "";
  fmt::print("{}: identical to {}{}{}{}{}{}{}\n", this->Options.File, this->Original->GetName(),
    files > 1 ? fmt::format(" and {} more", files - 1) : "",
    this->Steps.size() > 1 ? fmt::format(", {} time steps", this->Steps.size()) : "",
    alike > 0 ? fmt::format(", up to {} indistinguishable points", GroupDigits(alike)) : "", joins,
    errors,
    this->RolesDiffer ? " but for the active arrays, which are those of the first step at all steps"
                      : "");
}

void Verification::Run()
{
  this->CompareTimes();
  for (std::size_t i = 0; i < this->Steps.size(); ++i)
  {
    Progress progress(this->Steps.size() > 1
        ? fmt::format("comparing step {} of {}", i + 1, this->Steps.size())
        : std::string("comparing"),
      this->How.ShowProgress);
    this->CompareStep(this->Steps[i].first, this->Steps[i].second, progress);
  }
  for (const std::string& lost : *this->Lost)
  {
    this->Add(this->NameOfOriginal + ": " + lost);
  }
  if (!this->Found.empty())
  {
    this->Report();
  }
  if (!this->How.Quiet)
  {
    this->ReportIdentical();
  }
}

// "12 chunks, 3 arrays, 2 time steps, the order of points, cells".
std::string ListChecked(const gatun::FileReader& file)
{
  const auto count = [](std::size_t number, const std::string& what)
  { return fmt::format("{} {}{}", GroupDigits(number), what, number == 1 ? "" : "s"); };
  std::size_t chunks = file.GetChunks().size();
  for (std::size_t mesh = 1; mesh < file.GetNumberOfMeshes(); ++mesh)
  {
    chunks += file.OpenMesh(mesh)->GetChunks().size();
  }
  std::vector<std::string> parts{ count(chunks, "chunk"), count(file.GetArrays().size(), "array") };
  if (file.GetNumberOfMeshes() > 1)
  {
    parts.push_back(fmt::format("{} meshes", GroupDigits(file.GetNumberOfMeshes())));
  }
  if (file.HasTime())
  {
    parts.push_back(count(file.GetSeriesTimes().size(), "time step"));
  }
  if (file.GetKeptOrder() != gatun::KeepNone)
  {
    parts.push_back("the order of " + NameOfKeptOrder(file.GetKeptOrder()));
  }
  return Join(parts);
}

void Verify(const VerifyOptions& options, const Settings& settings)
{
  CheckReadable(options.File);
  FileSteps file(options.File);
  {
    Progress progress("checking", settings.ShowProgress);
    if (!VerifyFile(file.GetFile(), std::ref(progress)))
    {
      throw Interrupted();
    }
  }
  if (!options.Originals.empty())
  {
    Verification(options, settings, file).Run();
  }
  else if (!settings.Quiet)
  {
    fmt::print("{}: intact: all checksums are right, and everything decodes ({})\n", options.File,
      ListChecked(file.GetFile()));
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
void AddVerify(CLI::App& app, Settings& settings)
{
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = AddCommand(app, settings, "verify",
    "Check a .gtn file. All checksums are checked, and everything is decoded. With ORIGINAL, each\n"
    "time step is also compared with it, bit by bit, or by their bounds where values have\n"
    "errors. Points and cells are compared in order where the file keeps their order, and as\n"
    "sets elsewhere. As sets, points that coincide in their coordinates and all of their values\n"
    "are indistinguishable: a cell may use one in place of another. The number of such points is\n"
    "reported. ORIGINAL is read with all that it has; everything that differs or is missing is\n"
    "listed, of values the first difference, and the exit code is then 1.",
    "  gtn verify mesh.gtn\n"
    "  gtn verify mesh.gtn mesh.vtu\n"
    "  gtn verify run.gtn run_0.vtu run_1.vtu run_2.vtu");
  AddArrays(command, options->Input, "Compare only these point and cell arrays");
  AddSkipMissing(command, options->Input);
  AddSkip(command, options->Input, "Compare without these point and cell arrays of ORIGINAL");
  command->add_flag("--no-sets", options->NoSets,
    "Compare without the side sets, node sets, patches and boundaries of ORIGINAL (default: all "
    "of them are missing unless the file was packed with --sets)");
  AddNoGhosts(command, options->Input,
    "Compare without the ghost cells of ORIGINAL, which was packed in pieces or with --no-ghosts");
  AddSteps(command, options->Input.Steps)
    ->description("Compare with these time steps of ORIGINAL, as it was packed with --steps");
  command->add_flag("--fill-missing", options->FillMissing,
    "Fill in the arrays that steps of ORIGINAL lack, which was packed with --fill-missing");
  command->add_flag("--split-cells", options->Input.Split,
    "Split the cells of ORIGINAL, which was packed with --split-cells");
  command->add_flag("--triangles", options->Input.Triangles,
    "Divide the polygons and strips of ORIGINAL, which was packed with --triangles");
  command->add_option("IN", options->File, "The .gtn file")->required();
  command->add_option("ORIGINAL", options->Originals,
    "The source of the .gtn file: one file, or one for each time step");
  command->callback(
    [=, &settings]
    {
      options->Input.Quiet = settings.Quiet;
      Verify(*options, settings);
    });
}
}
