// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunWriter.h"

#include "gatunArrayBridge.h"
#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunFileWriter.h"
#include "gatunMergeGrid.h"
#include "gatunTetInput.h"
#include "gatunTetMesh.h"
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

using gatun::Association;

//------------------------------------------------------------------------------
// By which of the arrays to organise a file; component -1 is the length. Throws if it is not there.
gatun::LayerRequest FindLayerArray(
  const std::vector<gatun::BridgedArray>& arrays, const std::string& name, int component)
{
  bool isOfCells = false;
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    const gatun::ArrayDescription& array = arrays[i].Description;
    if (array.Name != name)
    {
      continue;
    }
    if (array.Where != Association::Point)
    {
      isOfCells = true;
      continue;
    }
    if (component >= static_cast<int>(array.Components))
    {
      gatun::ThrowInvalid("array '" + name + "' has no component " + std::to_string(component) +
        " to make layers of");
    }
    gatun::LayerRequest request;
    request.Array = static_cast<std::uint32_t>(i);
    request.Component = component >= 0 ? static_cast<std::uint32_t>(component)
      : array.Components > 1           ? array.Components
                                       : 0;
    request.Values = arrays[i].Values;
    return request;
  }
  gatun::ThrowInvalid(isOfCells ? "layers need a point array, and '" + name + "' is one of cells"
                                : "there is no point array '" + name + "' to make layers of");
}

} // anonymous namespace

//------------------------------------------------------------------------------
class vtkGatunWriter::vtkInternals
{
public:
  vtkNew<vtkDataArraySelection> PointSelection;
  vtkNew<vtkDataArraySelection> CellSelection;
  gatun::MergeWeights Weights;

  // The times to write, if the input has any and all are wanted, and which one is next.
  std::vector<double> Times;
  std::size_t Step = 0;
  bool Writing = false; ///< within Write, which goes through the times

  // While a file is being written.
  std::unique_ptr<gatun::FileWriter> File;
  std::unique_ptr<gatun::TetMesh> Mesh;
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

  bool Wants(vtkAbstractArray* array, vtkDataArraySelection* selection, bool unlisted) const
  {
    const char* name = array->GetName();
    if (!name || !*name)
    {
      return true;
    }
    return selection->ArrayExists(name) ? selection->ArrayIsEnabled(name) != 0 : unlisted;
  }

  std::vector<gatun::BridgedArray> Bridge(vtkUnstructuredGrid* grid, bool unlisted) const
  {
    std::vector<gatun::BridgedArray> arrays;
    const auto add =
      [&](vtkDataSetAttributes* attributes, Association where, vtkDataArraySelection* selection)
    {
      for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
      {
        vtkAbstractArray* array = attributes->GetAbstractArray(i);
        if (this->Wants(array, selection, unlisted))
        {
          arrays.push_back(gatun::Bridge(array, where));
          arrays.back().Description.AttributeRoles = gatun::AttributeRolesOf(attributes, array);
        }
      }
    };
    add(grid->GetPointData(), Association::Point, this->PointSelection);
    add(grid->GetCellData(), Association::Cell, this->CellSelection);
    return arrays;
  }
};

vtkStandardNewMacro(vtkGatunWriter);

//------------------------------------------------------------------------------
vtkGatunWriter::vtkGatunWriter()
  : Internals(std::make_unique<vtkInternals>())
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
  os << indent << "LinearizeQuadratic: " << (this->LinearizeQuadratic ? "On" : "Off") << "\n";
  os << indent << "ReplaceReadOnly: " << (this->ReplaceReadOnly ? "On" : "Off") << "\n";
  os << indent << "WrittenPoints: " << this->WrittenPoints << "\n";
  os << indent << "WrittenTets: " << this->WrittenTets << "\n";
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
    // What VTK and the algorithms before this one throw, too.
    this->HandleFailure();
  }
  self.Discard();
  self.Times.clear();
  self.Writing = false;
  return this->GetErrorCode() == vtkErrorCode::NoError ? 1 : 0;
}

//------------------------------------------------------------------------------
// A step an update. The pipeline could go on by itself (CONTINUE_EXECUTING), but does so forever
// if the input fails on the way. Returns whether the file is complete.
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
// Within a catch block: reports, and gives up the file. Returns whether it was an abort.
bool vtkGatunWriter::HandleFailure() noexcept
{
  this->Internals->Discard();
  this->SetErrorCode(vtkErrorCode::UnknownError);
  try
  {
    const gatun::VTKFailure failure =
      gatun::DescribeFailure(this->FileName ? this->FileName : "(no file)");
    this->SetErrorCode(failure.Code);
    if (!failure.Aborted)
    {
      vtkErrorMacro(<< failure.Message);
    }
    return failure.Aborted;
  }
  catch (...)
  {
    return false; // not even memory for the message
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
// Writes the current step, with the mesh before the first and the end after the last one.
void vtkGatunWriter::WriteStep(vtkUnstructuredGrid* input)
{
  vtkInternals& self = *this->Internals;
  const std::string path = this->FileName;
  const bool hasSteps = !self.Times.empty();
  const std::size_t steps = std::max<std::size_t>(1, self.Times.size());

  // The mesh counts as a step, and the hierarchy, which takes far longer, as nine times the rest.
  const double forTree = this->Hierarchy ? 0.9 : 0;
  const auto progressOf = [this, steps, forTree](std::size_t part)
  {
    return [this, steps, part, forTree](double fraction)
    {
      const double done = (static_cast<double>(part) + fraction) / (static_cast<double>(steps) + 1);
      this->UpdateProgress(forTree + (1 - forTree) * done);
      return !gatun::IsAborted(this);
    };
  };
  const auto warn = [this, &self, &path](const std::string& what)
  {
    if (self.Warned.insert(what).second)
    {
      vtkWarningMacro(<< path << ": " << what);
    }
  };
  const std::string here = hasSteps ? " in time step " + std::to_string(self.Step) + " (time " +
      std::to_string(self.Times[self.Step]) + ")"
                                    : "";

  const gatun::TetInput tets = gatun::MakeTetInput(input, this->LinearizeQuadratic);
  for (const std::string& warning : tets.Warnings)
  {
    warn(warning);
  }
  auto mesh = std::make_unique<gatun::TetMesh>(tets.Grid);
  if (mesh->PointsConverted)
  {
    warn("integer coordinates are written as double");
  }
  const std::vector<gatun::BridgedArray> arrays = self.Bridge(tets.Grid, this->WriteUnlistedArrays);
  std::vector<gatun::ArrayDescription> descriptions;
  std::vector<const void*> values;
  for (const gatun::BridgedArray& array : arrays)
  {
    descriptions.push_back(array.Description);
    values.push_back(array.Values);
  }

  if (!self.File)
  {
    gatun::WriterOptions options;
    options.Keep = static_cast<std::uint8_t>(this->KeepOrder);
    options.ChunkTets = static_cast<std::uint32_t>(this->ChunkTets);
    options.KeyStepInterval = static_cast<std::uint32_t>(this->KeyStepInterval);
    options.ReplaceReadOnly = this->ReplaceReadOnly;
    if (this->LayerArray && *this->LayerArray)
    {
      options.Layers = FindLayerArray(arrays, this->LayerArray, this->LayerComponent);
      options.Layers->Count = static_cast<std::uint32_t>(this->NumberOfLayers);
      options.Layers->Spacing = static_cast<gatun::LayerSpacing>(this->LayerSpacing);
    }
    if (this->Hierarchy)
    {
      self.Tree = gatun::BuildMergeTree(tets.Grid, self.Weights,
        { static_cast<gatun::MergeMetric>(this->Metric), this->BoundaryWeight },
        [this, forTree](double fraction)
        {
          this->UpdateProgress(forTree * fraction);
          return !gatun::IsAborted(this);
        });
      options.Tree = &self.Tree;
      options.Levels = static_cast<unsigned>(this->Levels);
    }
    self.Mesh = std::move(mesh);
    self.MeshHash = steps > 1 ? self.Mesh->Hash() : 0;
    self.Arrays = descriptions;
    self.File = std::make_unique<gatun::FileWriter>(
      path, self.Mesh->Mesh, self.Arrays, options, progressOf(0));
  }
  else
  {
    const gatun::MeshInput& first = self.Mesh->Mesh;
    if (mesh->Mesh.Points != first.Points || mesh->Mesh.Tets != first.Tets ||
      mesh->Mesh.CoordinateType != first.CoordinateType || mesh->Mesh.WideIds != first.WideIds ||
      mesh->Hash() != self.MeshHash)
    {
      gatun::ThrowInvalid("the points or the cells change" + here +
        "; one file holds one mesh, so write such steps as a series of files");
    }
    if (descriptions != self.Arrays)
    {
      gatun::ThrowInvalid("the point or cell arrays are others" + here + " than before");
    }
  }

  std::vector<std::string> refused;
  const gatun::FieldData field = gatun::BridgeFieldData(tets.Grid->GetFieldData(), refused);
  for (const std::string& name : refused)
  {
    warn("the field array '" + name + "' is left out, being of a type that cannot be written");
  }
  vtkInformation* info = input->GetInformation();
  const bool hasTime = hasSteps || info->Has(vtkDataObject::DATA_TIME_STEP());
  const double time = hasSteps ? self.Times[self.Step]
    : hasTime                  ? info->Get(vtkDataObject::DATA_TIME_STEP())
                               : 0.0;
  self.File->WriteStep(values, field, hasTime, time, progressOf(self.Step + 1));
  ++self.Step;
  if (self.Step < steps)
  {
    return;
  }

  const gatun::FileStatistics statistics = self.File->Finish();
  this->WrittenPoints = self.Mesh->Mesh.Points;
  this->WrittenTets = self.Mesh->Mesh.Tets;
  this->WrittenSteps = steps;
  this->FileBytes = statistics.FileBytes;
  this->ConnectivityBytes = statistics.ConnectivityBytes;
  this->GeometryBytes = statistics.GeometryBytes + statistics.SharedGeometryBytes;
  this->OrderBytes = statistics.OrderBytes;
  this->ArrayBytes = 0;
  for (const std::uint64_t bytes : statistics.ArrayBytes)
  {
    this->ArrayBytes += bytes;
  }
  this->FieldDataBytes = statistics.FieldDataBytes;
  this->HierarchyBytes = statistics.TreeBytes;
  this->LevelBytes = statistics.LevelBytes;
  this->DirectoryBytes = statistics.DirectoryBytes;
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
