// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnInput.h"

#include "gtnBlockSource.h"
#include "gtnFailure.h"
#include "gtnFileList.h"
#include "gtnMessages.h"
#include "gtnPartList.h"
#include "gtnPartReader.h"
#include "gtnPrepare.h"
#include "gtnProgress.h"
#include "gtnRangedSeries.h"
#include "gtnReadable.h"
#include "gtnReaders.h"
#include "gtnSeries.h"
#include "gtnSpoolSource.h"
#include "gtnSpooledMesh.h"
#include "gtnStepChooser.h"
#include "gtnText.h"
#include "gtnXMLMesh.h"

#include "gatunByteSource.h"
#include "gatunCellCheck.h"
#include "gatunError.h"
#include "vtkGatunMeshReader.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArraySelection.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

namespace gtn
{
const char* const InputFormats =
  ".vtu .pvtu .vtk .vtm .vtpc .pvd .series .vtkhdf .vti .vts .vtr, Exodus "
  "(.e .exo .ex2), EnSight (.case), OpenFOAM (.foam), "
  "CGNS, .gtn; with python3-meshio also .msh .med .inp .su2 .xdmf .bdf";
const char* const SurfaceInputFormats = ".vtp .pvtp .vtk .stl .ply .obj .glb .gltf .gtn";

//------------------------------------------------------------------------------
namespace
{

// The bytes of a tuple of all arrays.
std::uint64_t SizeOfTuple(vtkFieldData* data)
{
  std::uint64_t bytes = 0;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    bytes += static_cast<std::uint64_t>(array->GetDataTypeSize() * array->GetNumberOfComponents());
  }
  return bytes;
}

// About the number of bytes of a file as a mesh in memory.
std::uint64_t EstimateMesh(const std::string& file, const InputOptions& options)
{
  CheckReadable(file);
  if (IsPartList(file))
  {
    std::uint64_t sum = 0;
    for (const std::string& part : FindParts(file, options))
    {
      sum += EstimateMesh(part, options);
    }
    return sum;
  }
  if (ExtensionOf(file) != ".vtu")
  {
    constexpr std::uint64_t compression = 4;
    return compression * gatun::OpenFile(file)->GetSize();
  }
  const XMLSummary summary = ReadXMLSummary(file);
  constexpr std::uint64_t coordinates = 24;
  constexpr std::uint64_t idBytes = 8;
  return idBytes * summary.Corners +
    summary.Points * (coordinates + SizeOfTuple(summary.Grid->GetPointData())) +
    summary.Cells * (idBytes + 1 + SizeOfTuple(summary.Grid->GetCellData()));
}

// Leaves what is not wanted of a .gtn file unread. If an array is unknown, all are read, as one of
// a later mesh may be wanted; if not, the Preparer says so.
void SelectArrays(vtkAlgorithm* algorithm, const InputOptions& options)
{
  auto* const reader = vtkGatunMeshReader::SafeDownCast(algorithm);
  if (!reader || options.AllArrays)
  {
    return;
  }
  reader->UpdateInformation();
  const std::array<vtkDataArraySelection*, 2> selections{ reader->GetPointDataArraySelection(),
    reader->GetCellDataArraySelection() };
  for (const std::string& name : options.Arrays)
  {
    if (std::none_of(selections.begin(), selections.end(),
          [&](vtkDataArraySelection* all) { return all->ArrayExists(name.c_str()) != 0; }))
    {
      return;
    }
  }
  for (vtkDataArraySelection* const selection : selections)
  {
    selection->DisableAllArrays();
    for (const std::string& name : options.Arrays)
    {
      if (selection->ArrayExists(name.c_str()))
      {
        selection->EnableArray(name.c_str());
      }
    }
  }
}

// Takes the files that are missing out of the steps of a list, with those that have no others.
void DropMissing(
  const std::string& list, const InputOptions& options, std::vector<SeriesStep>& steps)
{
  std::vector<std::string> all;
  for (const SeriesStep& step : steps)
  {
    all.insert(all.end(), step.Files.begin(), step.Files.end());
  }
  const std::vector<std::string> existing = FindExisting(list, all, options);
  const std::set<std::string> known(existing.begin(), existing.end());
  for (SeriesStep& step : steps)
  {
    std::erase_if(step.Files, [&](const std::string& file) { return !known.contains(file); });
  }
  std::erase_if(steps, [](const SeriesStep& step) { return step.Files.empty(); });
}

// Whether each step is in one file that lists blocks.
bool AreBlocks(const std::vector<SeriesStep>& steps)
{
  return !steps.empty() &&
    std::all_of(steps.begin(), steps.end(),
      [](const SeriesStep& step)
      { return step.Files.size() == 1 && IsBlockList(step.Files.front()); });
}

// Throws Failure if some files, by their names, are surfaces and others are not.
void RequireSameKind(const std::vector<std::string>& files)
{
  const std::string& first = files.front();
  for (const std::string& file : files)
  {
    if (ExtensionOf(file) == ExtensionOf(first))
    {
      continue; // those differ only if somebody wants them to
    }
    CheckReadable(first);
    CheckReadable(file);
    const bool isSurface = IsSurfaceFile(file);
    if (isSurface != IsSurfaceFile(first))
    {
      throw Failure(isSurface ? file : first,
        "is a surface (vtkPolyData), and " + (isSurface ? first : file) +
          " is not; they cannot be steps of one mesh: pack each by itself");
    }
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
Input::Input(const std::vector<std::string>& files, const InputOptions& options)
  : Name(files.front())
  , Options(options)
{
  std::vector<SeriesStep>& steps = this->Steps;
  if (files.size() > 1)
  {
    RequireSameKind(files);
    steps = StepsOfFiles(files, options);
    this->ChooseListed();
  }
  else if (IsFileList(this->Name))
  {
    steps = ReadFileList(this->Name);
    this->ChooseListed();
    DropMissing(this->Name, options, steps);
    for (SeriesStep& step : steps)
    {
      std::vector<std::string> parts;
      step.List =
        step.Files.size() == 1 && IsPartList(step.Files.front()) ? step.Files.front() : this->Name;
      for (const std::string& file : step.Files)
      {
        const auto more =
          options.InPieces ? FindParts(file, options) : std::vector<std::string>{ file };
        parts.insert(parts.end(), more.begin(), more.end());
      }
      step.Files = parts;
    }
  }
  else if (options.InPieces && IsPartList(this->Name))
  {
    steps.push_back({ 0, FindParts(this->Name, options), this->Name });
    this->HasTime = false;
  }
  else if (IsBlockList(this->Name))
  {
    steps.push_back({ 0, { this->Name } });
    this->HasTime = false;
  }

  if (options.InPieces && files.size() == 1 && IsExodus(this->Name))
  {
    vtkNew<BlockSource> blocks;
    blocks->SetExodus(this->Name, options);
    this->Algorithm = blocks;
    this->HasBlocks = true;
    steps.push_back(
      { 0, std::vector<std::string>(CountExodusBlocks(this->Name, options.Sets), this->Name) });
  }
  else if (AreBlocks(steps))
  {
    vtkNew<BlockSource> blocks;
    blocks->SetSteps(steps, options, this->HasTime);
    this->Algorithm = blocks;
    this->HasBlocks = true;
    for (SeriesStep& step : steps)
    {
      step.Files = ReadBlockList(step.Files.front(), options).Files;
    }
  }
  else if (!steps.empty())
  {
    vtkNew<SeriesReader> series;
    series->SetSteps(steps, options, this->HasTime);
    this->Algorithm = series;
  }
  else
  {
    CheckReadable(this->Name);
    vtkSmartPointer<vtkAlgorithm> reader;
    if (IsPartList(this->Name))
    {
      vtkNew<PartReader> parts;
      parts->SetFile(this->Name, options);
      reader = parts;
    }
    else
    {
      reader = MakeReader(this->Name, options.Sets);
      SelectArrays(reader, options);
    }
    if (!reader)
    {
      throw Failure(this->Name,
        std::string("no reader for this extension; there are those for ") + InputFormats +
          ", and for surfaces " + SurfaceInputFormats);
    }
    vtkNew<Preparer> preparer;
    preparer->SetOptions(options);
    preparer->SetInputConnection(reader->GetOutputPort());
    this->Algorithm = preparer;
  }
  this->FindTimes();
  this->ChooseOwn();
  if (options.NamesSets && !options.Sets && files.size() == 1)
  {
    this->NameSets();
  }
}

//------------------------------------------------------------------------------
// Tells which sets are left out.
void Input::NameSets() const
{
  std::vector<std::string> sets = ListSets(this->Name);
  if (sets.empty())
  {
    return;
  }
  constexpr std::size_t enough = 16;
  const std::size_t more = sets.size() - std::min(sets.size(), enough);
  sets.resize(sets.size() - more);
  const std::string lost = fmt::format("the sets or patches '{}'{} are left out; --sets keeps them",
    MakePrintableLine(fmt::format("{}", fmt::join(sets, "', '"))),
    more > 0 ? fmt::format(" and {} more", more) : "");
  if (this->Options.Lost)
  {
    this->Options.Lost->insert(lost);
  }
  else if (!this->Options.Quiet)
  {
    Say(this->Name + ": " + lost);
  }
}

//------------------------------------------------------------------------------
void Input::FindTimes()
{
  this->Algorithm->UpdateInformation();
  CheckMessages(this->Name, this->Options.Quiet);

  vtkInformation* info = this->Algorithm->GetOutputInformation(0);
  auto* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  if (info->Has(key))
  {
    this->Times.assign(info->Get(key), info->Get(key) + info->Length(key));
  }
}

//------------------------------------------------------------------------------
// Of the steps that were listed, those that are wanted.
void Input::ChooseListed()
{
  if (!this->Options.Steps)
  {
    return;
  }
  std::vector<SeriesStep> chosen;
  for (const std::size_t step : ChooseSteps(*this->Options.Steps, this->Steps.size(), this->Name))
  {
    chosen.push_back(this->Steps[step]);
  }
  this->Steps = chosen;
  this->Options.Steps.reset();
}

//------------------------------------------------------------------------------
// The same for those of a reader.
void Input::ChooseOwn()
{
  if (!this->Options.Steps)
  {
    return;
  }
  std::vector<double> chosen;
  for (const std::size_t step : ChooseSteps(*this->Options.Steps, this->Times.size(), this->Name))
  {
    chosen.push_back(this->Times[step]);
  }
  vtkNew<StepChooser> chooser;
  chooser->SetTimes(chosen);
  chooser->SetInputConnection(this->Algorithm->GetOutputPort());
  this->Algorithm = chooser;
  this->Options.Steps.reset();
  this->FindTimes();
}

//------------------------------------------------------------------------------
Input::~Input() = default;

//------------------------------------------------------------------------------
vtkAlgorithm* Input::GetSource() const
{
  vtkAlgorithm* source = this->Algorithm;
  while (source->GetNumberOfInputPorts() > 0 && source->GetNumberOfInputConnections(0) > 0)
  {
    source = source->GetInputAlgorithm(0, 0);
  }
  return source;
}

//------------------------------------------------------------------------------
bool Input::CanSpool() const
{
  const auto isOne = [](const std::string& file) { return ExtensionOf(file) == ".vtu"; };
  return this->Steps.empty() ? isOne(this->Name)
                             : !this->HasBlocks &&
      std::all_of(this->Steps.begin(), this->Steps.end(),
        [&](const SeriesStep& step) { return step.Files.size() == 1 && isOne(step.Files[0]); });
}

//------------------------------------------------------------------------------
bool Input::IsInFiles() const
{
  const auto isSplit = [](const SeriesStep& step)
  {
    return step.Files.size() > 1 ||
      std::any_of(
        step.Files.begin(), step.Files.end(), [](auto& file) { return IsPartList(file); });
  };
  return !this->HasBlocks &&
    (IsPartList(this->Name) || std::any_of(this->Steps.begin(), this->Steps.end(), isSplit));
}

//------------------------------------------------------------------------------
void Input::Spool(SpoolSettings settings, Progress& progress)
{
  settings.Name = this->Name;
  settings.Split = this->Options.Split;
  if (this->Spooled) // its disk space is needed
  {
    this->Algorithm = nullptr;
    this->Spooled.reset();
  }
  const auto open = [this](const std::string& file) -> std::unique_ptr<RangedMesh>
  {
    return std::make_unique<XMLMesh>(
      file, this->Options.AllArrays ? nullptr : &this->Options.Arrays, this->Options.Skip);
  };
  std::shared_ptr<RangedMesh> mesh;
  if (this->Steps.empty() || !this->HasTime)
  {
    mesh = open(this->Steps.empty() ? this->Name : this->Steps.front().Files.front());
  }
  else
  {
    std::vector<std::string> files;
    std::vector<double> times;
    for (const SeriesStep& step : this->Steps)
    {
      files.push_back(step.Files.front());
      times.push_back(step.Time);
    }
    mesh = std::make_shared<RangedSeries>(files, times, open);
  }
  try
  {
    this->Spooled = std::make_shared<SpooledMesh>(
      mesh, settings, [&progress](double fraction) { return progress(fraction); });
  }
  catch (const gatun::Error& error)
  {
    throw error.Path.empty() ? Failure(this->Name, error.what()) : Failure(error.what());
  }
  vtkNew<SpoolSource> source;
  source->SetMesh(this->Spooled, this->Options);
  this->Algorithm = source;
  this->FindTimes();
}

//------------------------------------------------------------------------------
std::uint64_t Input::GetBytesForAll() const
{
  return this->Spooled ? this->Spooled->GetUnusedBytes() : 0;
}

//------------------------------------------------------------------------------
std::size_t Input::GetNumberOfParts() const
{
  if (this->Spooled)
  {
    return this->Spooled->GetNumberOfPieces();
  }
  for (const SeriesStep& step : this->Steps)
  {
    if (step.Files.size() != this->Steps.front().Files.size())
    {
      throw Failure(this->Name,
        "the time steps have different numbers of files: " + DescribeUnequal(this->Steps));
    }
  }
  return this->Steps.empty() ? 1 : this->Steps.front().Files.size();
}

//------------------------------------------------------------------------------
std::uint64_t Input::EstimateLargestPart() const
{
  if (this->Spooled)
  {
    return this->Spooled->GetLargestPiece();
  }
  // A block is there once more while it is merged.
  const auto withCopy = [this](std::uint64_t bytes)
  { return this->HasBlocks ? bytes + bytes / 4 : bytes; };
  if (this->HasBlocks && IsExodus(this->Name))
  {
    return withCopy(EstimateExodusBlock(this->Name, this->Options.Sets));
  }
  const std::vector<std::string> files =
    this->Steps.empty() ? std::vector<std::string>{ this->Name } : this->Steps.front().Files;
  std::uint64_t largest = 0;
  for (const std::string& file : files)
  {
    largest = std::max(largest, EstimateMesh(file, this->Options));
  }
  return withCopy(largest);
}

//------------------------------------------------------------------------------
vtkDataObject* Input::Read(std::size_t step, Progress& progress)
{
  progress.Watch(this->GetSource()); // which takes the time
  if (this->Times.empty())
  {
    this->Algorithm->Update();
  }
  else
  {
    this->Algorithm->UpdateTimeStep(this->Times.at(step));
  }
  CheckInterrupt();
  CheckMessages(this->Name, this->Options.Quiet);
  return this->Algorithm->GetOutputDataObject(0);
}

//------------------------------------------------------------------------------
vtkUnstructuredGrid* Input::ReadGrid(std::size_t step, Progress& progress)
{
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(this->Read(step, progress));
  if (!grid)
  {
    throw Failure(this->Name, DescribeSurface());
  }
  return grid;
}

namespace
{

// VTK's readers do not check the cells of a file, and its filters rely on them.
void CheckCells(const std::string& file, vtkPolyData* surface)
{
  for (vtkCellArray* cells :
    { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
  {
    try
    {
      gatun::CheckOffsets(cells);
      gatun::CheckPointIds(cells, surface->GetNumberOfPoints());
    }
    catch (const gatun::Error& error)
    {
      throw Failure(file, error.what());
    }
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadSurface(const std::string& file, Progress& progress, bool quiet)
{
  CheckReadable(file);
  vtkSmartPointer<vtkAlgorithm> reader = MakeSurfaceReader(file);
  if (!reader)
  {
    throw Failure(
      file, "no reader for this extension; there are those for .stl .ply .obj .vtp .vtk .gtn");
  }
  progress.Watch(reader);
  reader->Update();
  CheckInterrupt();
  CheckMessages(file, quiet);
  vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
  if (!surface)
  {
    throw Failure(file, "does not hold a surface");
  }
  CheckCells(file, surface);
  return surface;
}
}
