// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunWriter.h"

#include "gatunArrayBridge.h"
#include "gatunBridgedMesh.h"
#include "gatunCellInput.h"
#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunFileWriter.h"
#include "gatunMergeGrid.h"
#include "gatunReport.h"
#include "gatunWriterArrays.h"
#include "vtkGatunCompat.h"
#include "vtkGatunErrorCode.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArraySelection.h"
#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

namespace
{

// Building a hierarchy takes about nine times as long as writing the rest.
constexpr double PartOfTree = 0.9;

} // anonymous namespace

//------------------------------------------------------------------------------
class vtkGatunWriter::vtkInternals
{
public:
  explicit vtkInternals(vtkGatunWriter* owner)
    : Owner(owner)
  {
  }

  void Warn(const std::string& what);
  std::function<bool(double)> MakeProgress(std::size_t part);
  gatun::WriterOptions MakeOptions(
    vtkUnstructuredGrid* grid, const std::vector<gatun::BridgedArray>& arrays);
  void PublishStatistics(const gatun::FileStatistics& statistics);

  vtkGatunWriter* const Owner;
  vtkNew<vtkDataArraySelection> PointSelection;
  vtkNew<vtkDataArraySelection> CellSelection;
  gatun::MergeWeights Weights;

  // The times to write, if all time steps of the input are wanted, and the next one of them.
  std::vector<double> Times;
  std::size_t Step = 0;
  bool Writing = false; // whether Write is running

  // While a file is being written.
  std::unique_ptr<gatun::FileWriter> File;
  std::unique_ptr<gatun::BridgedMesh> Mesh;
  std::size_t MeshHash = 0;
  std::vector<gatun::ArrayDescription> Arrays;
  gatun::MergeTree Tree;
  std::set<std::string> Warned;

  void Discard()
  {
    this->File.reset();
    this->Mesh.reset();
    this->Arrays.clear();
    this->Tree = {};
    this->Warned.clear();
    this->Step = 0;
  }

  std::size_t GetNumberOfSteps() const { return std::max<std::size_t>(1, this->Times.size()); }

  // Throws unless a time step has the mesh and the arrays of the first one.
  void CheckUnchanged(
    const gatun::BridgedMesh& mesh, const std::vector<gatun::ArrayDescription>& arrays) const
  {
    const std::string step = " in time step " + std::to_string(this->Step) + " (time " +
      std::to_string(this->Times[this->Step]) + ")";
    const gatun::MeshInput& first = this->Mesh->Mesh;
    const gatun::MeshInput& now = mesh.Mesh;
    if (now.Points != first.Points || now.Cells != first.Cells ||
      now.CoordinateType != first.CoordinateType || now.WideIds != first.WideIds ||
      mesh.Hash() != this->MeshHash)
    {
      gatun::ThrowInvalid("the points or the cells change" + step +
        "; one file holds one mesh, so write such steps as a series of files");
    }
    if (arrays != this->Arrays)
    {
      gatun::ThrowInvalid("the point or cell arrays change" + step);
    }
  }
};

//------------------------------------------------------------------------------
// Reports a warning once for each file.
void vtkGatunWriter::vtkInternals::Warn(const std::string& what)
{
  if (this->Warned.insert(what).second)
  {
    vtkWarningWithObjectMacro(this->Owner, << this->Owner->FileName << ": " << what);
  }
}

//------------------------------------------------------------------------------
// Reports progress of a part of the work. Part 0 is the mesh, part i + 1 is time step i.
std::function<bool(double)> vtkGatunWriter::vtkInternals::MakeProgress(std::size_t part)
{
  const double parts = static_cast<double>(this->GetNumberOfSteps()) + 1;
  return [this, part, parts](double fraction)
  {
    const double forTree = this->Owner->Hierarchy ? PartOfTree : 0;
    const double done = (static_cast<double>(part) + fraction) / parts;
    this->Owner->UpdateProgress(forTree + (1 - forTree) * done);
    return !gatun::IsAborted(this->Owner);
  };
}

//------------------------------------------------------------------------------
gatun::WriterOptions vtkGatunWriter::vtkInternals::MakeOptions(
  vtkUnstructuredGrid* grid, const std::vector<gatun::BridgedArray>& arrays)
{
  gatun::WriterOptions options;
  options.Keep = static_cast<std::uint8_t>(this->Owner->KeepOrder);
  options.ChunkTets = static_cast<std::uint32_t>(this->Owner->ChunkTets);
  options.KeyStepInterval = static_cast<std::uint32_t>(this->Owner->KeyStepInterval);
  options.ReplaceReadOnly = this->Owner->ReplaceReadOnly;
  if (this->Owner->LayerArray && *this->Owner->LayerArray)
  {
    options.Layers =
      gatun::FindLayerArray(arrays, this->Owner->LayerArray, this->Owner->LayerComponent);
    options.Layers->Count = static_cast<std::uint32_t>(this->Owner->NumberOfLayers);
    options.Layers->Spacing = static_cast<gatun::LayerSpacing>(this->Owner->LayerSpacing);
  }
  if (this->Owner->Hierarchy)
  {
    this->Tree = gatun::BuildMergeTree(grid, this->Weights,
      { static_cast<gatun::MergeMetric>(this->Owner->Metric), this->Owner->BoundaryWeight },
      [this](double fraction)
      {
        this->Owner->UpdateProgress(PartOfTree * fraction);
        return !gatun::IsAborted(this->Owner);
      });
    options.Tree = &this->Tree;
    options.Levels = static_cast<unsigned>(this->Owner->Levels);
  }
  return options;
}

//------------------------------------------------------------------------------
void vtkGatunWriter::vtkInternals::PublishStatistics(const gatun::FileStatistics& statistics)
{
  this->Owner->WrittenPoints = this->Mesh->Mesh.Points;
  this->Owner->WrittenCells = this->Mesh->Mesh.Cells;
  this->Owner->WrittenSteps = this->GetNumberOfSteps();
  this->Owner->FileBytes = statistics.FileBytes;
  this->Owner->ConnectivityBytes = statistics.ConnectivityBytes;
  this->Owner->GeometryBytes = statistics.GeometryBytes + statistics.SharedGeometryBytes;
  this->Owner->OrderBytes = statistics.OrderBytes;
  this->Owner->ArrayBytes = 0;
  for (const std::uint64_t bytes : statistics.ArrayBytes)
  {
    this->Owner->ArrayBytes += bytes;
  }
  this->Owner->FieldDataBytes = statistics.FieldDataBytes;
  this->Owner->HierarchyBytes = statistics.TreeBytes;
  this->Owner->LevelBytes = statistics.LevelBytes;
  this->Owner->DirectoryBytes = statistics.DirectoryBytes;
}

//------------------------------------------------------------------------------
vtkStandardNewMacro(vtkGatunWriter);

//------------------------------------------------------------------------------
vtkGatunWriter::vtkGatunWriter()
  : Internals(std::make_unique<vtkInternals>(this))
{
}

//------------------------------------------------------------------------------
vtkGatunWriter::~vtkGatunWriter()
{
  this->SetFileName(nullptr);
  this->SetLayerArray(nullptr);
}

//------------------------------------------------------------------------------
void vtkGatunWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "WriteUnlistedArrays: " << (this->WriteUnlistedArrays ? "On" : "Off") << "\n";
  os << indent << "KeepOrder: " << this->KeepOrder << "\n";
  os << indent << "ChunkTets: " << this->ChunkTets << "\n";
  os << indent << "KeyStepInterval: " << this->KeyStepInterval << "\n";
  os << indent << "Hierarchy: " << (this->Hierarchy ? "On" : "Off") << "\n";
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "Metric: " << (this->Metric == METRIC_MASS ? "Mass" : "Density") << "\n";
  os << indent << "BoundaryWeight: " << this->BoundaryWeight << "\n";
  this->Internals->Weights.Print(os, indent);
  os << indent << "LayerArray: " << (this->LayerArray ? this->LayerArray : "(none)") << "\n";
  os << indent << "LayerComponent: " << this->LayerComponent << "\n";
  os << indent << "NumberOfLayers: " << this->NumberOfLayers << "\n";
  os << indent << "LayerSpacing: " << this->LayerSpacing << "\n";
  os << indent << "WriteAllTimeSteps: " << (this->WriteAllTimeSteps ? "On" : "Off") << "\n";
  os << indent << "SplitCells: " << (this->SplitCells ? "On" : "Off") << "\n";
  os << indent << "ReplaceReadOnly: " << (this->ReplaceReadOnly ? "On" : "Off") << "\n";
  os << indent << "WrittenPoints: " << this->WrittenPoints << "\n";
  os << indent << "WrittenCells: " << this->WrittenCells << "\n";
  os << indent << "WrittenSteps: " << this->WrittenSteps << "\n";
  os << indent << "FileBytes: " << this->FileBytes << "\n";
  os << indent << "ConnectivityBytes: " << this->ConnectivityBytes << "\n";
  os << indent << "GeometryBytes: " << this->GeometryBytes << "\n";
  os << indent << "OrderBytes: " << this->OrderBytes << "\n";
  os << indent << "ArrayBytes: " << this->ArrayBytes << "\n";
  os << indent << "FieldDataBytes: " << this->FieldDataBytes << "\n";
  os << indent << "HierarchyBytes: " << this->HierarchyBytes << "\n";
  os << indent << "LevelBytes: " << this->LevelBytes << "\n";
  os << indent << "DirectoryBytes: " << this->DirectoryBytes << "\n";
  os << indent << "PointDataArraySelection:\n";
  this->GetPointDataArraySelection()->PrintSelf(os, indent.GetNextIndent());
  os << indent << "CellDataArraySelection:\n";
  this->GetCellDataArraySelection()->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkGatunWriter::GetPointDataArraySelection()
{
  return this->Internals->PointSelection;
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkGatunWriter::GetCellDataArraySelection()
{
  return this->Internals->CellSelection;
}

//------------------------------------------------------------------------------
void vtkGatunWriter::SetChunkTets(int tets)
{
  const int clamped = tets <= 0 ? 0 : std::clamp(tets, 64, 1048576);
  if (this->ChunkTets != clamped)
  {
    this->ChunkTets = clamped;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGatunWriter::SetArrayWeight(const char* name, double weight)
{
  if (this->Internals->Weights.Set(name, weight))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkGatunWriter::GetArrayWeight(const char* name)
{
  return this->Internals->Weights.Get(name);
}

//------------------------------------------------------------------------------
void vtkGatunWriter::ClearArrayWeights()
{
  if (this->Internals->Weights.Clear())
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkGatunWriter::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunWriter::Write()
{
  vtkInternals& self = *this->Internals;
  if (this->GetNumberOfInputConnections(0) < 1)
  {
    this->SetErrorCode(vtkGatunErrorCode::InvalidInputError);
    vtkErrorMacro("No input was set.");
    return 0;
  }
  self.Discard();
  self.Writing = true;
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    if (!this->WriteSteps() && this->GetErrorCode() == vtkErrorCode::NoError)
    {
      throw std::runtime_error("not written, as the input could not be updated");
    }
  }
  catch (...)
  {
    // This includes exceptions of VTK and of upstream algorithms.
    this->HandleFailure();
  }
  self.Discard();
  self.Times.clear();
  self.Writing = false;
  return this->GetErrorCode() == vtkErrorCode::NoError ? 1 : 0;
}

//------------------------------------------------------------------------------
// Updates the input for each time step. The pipeline could continue by itself (CONTINUE_EXECUTING),
// but would never stop if the input fails. Returns whether the file is complete.
bool vtkGatunWriter::WriteSteps()
{
  vtkInternals& self = *this->Internals;
  for (;;)
  {
    const std::size_t step = self.Step;
    this->Modified();
    this->UpdateWholeExtent();
    if (self.Step <= step)
    {
      return false; // after a failure it is 0 again
    }
    if (self.Step >= self.Times.size())
    {
      return true;
    }
  }
}

//------------------------------------------------------------------------------
// To be called in a catch block. Reports the error and discards the file. Returns whether the error
// is an abort.
bool vtkGatunWriter::HandleFailure() noexcept
{
  this->Internals->Discard();
  this->SetErrorCode(vtkErrorCode::UnknownError);
  try
  {
    const gatun::VTKFailure failure =
      gatun::DescribeFailure(this->FileName ? this->FileName : "(no file)");
    this->SetErrorCode(failure.Code);
    gatun::ReportFailure(this, failure, nullptr);
    return failure.Aborted;
  }
  catch (...)
  {
    return false; // there is no memory for the message
  }
}

//------------------------------------------------------------------------------
void vtkGatunWriter::Update()
{
  this->Write();
}

//------------------------------------------------------------------------------
void vtkGatunWriter::Update(int vtkNotUsed(port))
{
  this->Write();
}

//------------------------------------------------------------------------------
vtkTypeBool vtkGatunWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInternals& self = *this->Internals;
  vtkInformation* inInfo = inputVector[0]->GetInformationObject(0);
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    if (self.File)
    {
      // Between two steps.
      return 1;
    }
    self.Times.clear();
    if (self.Writing && this->WriteAllTimeSteps &&
      inInfo->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()))
    {
      const double* times = inInfo->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
      self.Times.assign(
        times, times + inInfo->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
    }
    return 1;
  }
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_TIME()) ||
    request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    if (self.Step < self.Times.size())
    {
      inInfo->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), self.Times[self.Step]);
    }
    if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
    {
      inInfo->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
      inInfo->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      inInfo->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkGatunWriter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* vtkNotUsed(outputVector))
{
  vtkInternals& self = *this->Internals;
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->FileName || !*this->FileName)
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("No FileName was set.");
    return 0;
  }
  try
  {
    vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
    if (!input)
    {
      gatun::ThrowInvalid("the input is not a vtkUnstructuredGrid");
    }
    this->WriteStep(input);
  }
  catch (...)
  {
    return this->HandleFailure() ? 1 : 0;
  }
  if (self.Step >= self.Times.size())
  {
    this->WriteTime.Modified();
    this->UpdateProgress(1);
    if (!self.Writing)
    {
      self.Discard();
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
// Writes the current time step. The first step also writes the mesh, the last one completes the
// file.
void vtkGatunWriter::WriteStep(vtkUnstructuredGrid* input)
{
  vtkInternals& self = *this->Internals;
  const gatun::CellInput cells = gatun::MakeCellInput(input, this->SplitCells);
  for (const std::string& warning : cells.Warnings)
  {
    self.Warn(warning);
  }
  auto mesh = std::make_unique<gatun::BridgedMesh>(cells.Grid);
  if (mesh->PointsConverted)
  {
    self.Warn("integer coordinates are written as double");
  }
  const std::vector<gatun::BridgedArray> arrays = gatun::BridgeSelected(
    cells.Grid, self.PointSelection, self.CellSelection, this->WriteUnlistedArrays);
  std::vector<gatun::ArrayDescription> descriptions;
  std::vector<const void*> values;
  for (const gatun::BridgedArray& array : arrays)
  {
    descriptions.push_back(array.Description);
    values.push_back(array.Values);
  }

  if (!self.File)
  {
    const gatun::WriterOptions options = self.MakeOptions(cells.Grid, arrays);
    self.Mesh = std::move(mesh);
    self.MeshHash = self.GetNumberOfSteps() > 1 ? self.Mesh->Hash() : 0;
    self.Arrays = descriptions;
    self.File = std::make_unique<gatun::FileWriter>(
      this->FileName, self.Mesh->Mesh, self.Arrays, options, self.MakeProgress(0));
  }
  else
  {
    self.CheckUnchanged(*mesh, descriptions);
  }

  std::vector<std::string> refused;
  const gatun::FieldData field = gatun::BridgeFieldData(cells.Grid->GetFieldData(), refused);
  for (const std::string& name : refused)
  {
    self.Warn(
      "the field array '" + name + "' is left out, because arrays of its type cannot be written");
  }
  vtkInformation* info = input->GetInformation();
  const bool hasSteps = !self.Times.empty();
  const bool hasTime = hasSteps || info->Has(vtkDataObject::DATA_TIME_STEP());
  const double time = hasSteps ? self.Times[self.Step]
    : hasTime                  ? info->Get(vtkDataObject::DATA_TIME_STEP())
                               : 0.0;
  self.File->WriteStep(values, field, hasTime, time, self.MakeProgress(self.Step + 1));
  ++self.Step;
  if (self.Step >= self.GetNumberOfSteps())
  {
    self.PublishStatistics(self.File->Finish());
  }
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
