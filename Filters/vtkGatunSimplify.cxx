// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunSimplify.h"

#include "gatunCopyTuples.h"
#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunExactGhosts.h"
#include "gatunFileConsumer.h"
#include "gatunFileReader.h"
#include "gatunMergeGrid.h"
#include "gatunNewArray.h"
#include "gatunPieceBoundary.h"
#include "gatunPieceReader.h"
#include "gatunProcessExchange.h"
#include "gatunReport.h"
#include "gatunSimplifiedSurface.h"
#include "gatunSimplifyProperties.h"
#include "gatunSurfaceGrid.h"
#include "gatunTetInput.h"
#include "vtkGatunCompat.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunSimplify);
vtkCxxSetObjectMacro(vtkGatunSimplify, Controller, vtkMultiProcessController);

namespace
{

/** What is left of a grid after so many merges. */
void FillOutput(vtkUnstructuredGrid* grid, const gatun::MergeTree& tree, std::size_t merges,
  vtkUnstructuredGrid* output)
{
  const auto ancestors = tree.FindAncestors(merges);
  std::vector<vtkIdType> places(ancestors.size(), -1);
  vtkNew<vtkIdList> kept;
  for (std::size_t i = 0; i < ancestors.size(); ++i)
  {
    if (ancestors[i] == i)
    {
      places[i] = kept->InsertNextId(static_cast<vtkIdType>(i));
    }
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(grid->GetPoints()->GetDataType());
  gatun::SizePoints(points, kept->GetNumberOfIds());
  grid->GetPoints()->GetPoints(kept, points);
  output->SetPoints(points);
  gatun::CopyTuples(grid->GetPointData(), kept, output->GetPointData());

  vtkNew<vtkIdList> cells;
  gatun::CellCollector tets;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    grid->GetCellPoints(cell, count, ids);
    gatun::MergeTree::Tet tet{};
    std::transform(
      ids, ids + 4, tet.begin(), [](vtkIdType id) { return static_cast<std::uint32_t>(id); });
    if (gatun::Simplify(tet, ancestors))
    {
      tets.Add({ places[tet[0]], places[tet[1]], places[tet[2]], places[tet[3]] });
      cells->InsertNextId(cell);
    }
  }
  output->SetCells(VTK_TETRA, tets.Make());
  gatun::CopyTuples(grid->GetCellData(), cells, output->GetCellData());
  output->GetFieldData()->ShallowCopy(grid->GetFieldData());
}
}

//------------------------------------------------------------------------------
class vtkGatunSimplify::vtkInternals
{
public:
  gatun::MergeWeights Weights;

  // What the tree was made for: tetrahedra or a surface.
  vtkSmartPointer<vtkUnstructuredGrid> Tets;
  std::unique_ptr<gatun::SimplifiedSurface> Surface;
  vtkPointSet* Input = nullptr; // only ever compared
  vtkMTimeType Stamp = 0;
  int NumberOfPieces = 1;
  gatun::MergeWeights UsedWeights;
  gatun::MergeSettings Settings;
  double FeatureAngle = 0;
  gatun::MergeTree Tree;
  double OutputRMSError = 0;

  // The file that the last output came from, if it came from one.
  std::shared_ptr<gatun::SharedFile> File;
  std::size_t FileMerges = 0;
  gatun::PieceReader Pieces;

  static const gatun::PublishedFile* FindHierarchy(vtkGatunSimplify* self, vtkInformation* inInfo);

  void ForgetFile();
  void ForgetGrid();
  void FillFromFile(vtkGatunSimplify* self, const gatun::PublishedFile& handle,
    vtkInformation* inInfo, vtkInformation* outInfo, vtkPointSet* output);
  void FillFromSurface(
    vtkGatunSimplify* self, vtkInformation* outInfo, vtkPolyData* input, vtkPolyData* output);
  void FillFromGrid(vtkGatunSimplify* self, vtkInformation* outInfo, vtkUnstructuredGrid* input,
    vtkUnstructuredGrid* output);
  void Prepare(vtkGatunSimplify* self, vtkInformation* outInfo, vtkUnstructuredGrid* input);
  std::size_t CountMerges(const vtkGatunSimplify* self) const;
  bool IsPrepared(vtkPointSet* input, int pieces, const gatun::MergeSettings& settings) const;
  void SetPrepared(vtkPointSet* input, int pieces, const gatun::MergeSettings& settings);
  static gatun::SimplifyProperties Target(const vtkGatunSimplify* self);
  static vtkMultiProcessController* FindController(
    const vtkGatunSimplify* self, vtkInformation* outInfo);
};

//------------------------------------------------------------------------------
/** The processes that each make their piece of the output, or null. */
vtkMultiProcessController* vtkGatunSimplify::vtkInternals::FindController(
  const vtkGatunSimplify* self, vtkInformation* outInfo)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkMultiProcessController* const controller = self->Controller;
  const bool isOfAll = controller && controller->GetNumberOfProcesses() > 1 &&
    Pipeline::GetUpdateNumberOfPieces(outInfo) == controller->GetNumberOfProcesses() &&
    Pipeline::GetUpdatePiece(outInfo) == controller->GetLocalProcessId();
  return isOfAll ? controller : nullptr;
}

//------------------------------------------------------------------------------
/** The file that the input comes from, if its hierarchy is to be used. */
const gatun::PublishedFile* vtkGatunSimplify::vtkInternals::FindHierarchy(
  vtkGatunSimplify* self, vtkInformation* inInfo)
{
  if (!self->UseFileHierarchy)
  {
    return nullptr;
  }
  const gatun::PublishedFile* const handle = gatun::GetUsableFile(self->GetFileInformation(inInfo));
  return handle && handle->File->GetFile()->HasMergeTree() ? handle : nullptr;
}

//------------------------------------------------------------------------------
void vtkGatunSimplify::vtkInternals::ForgetFile()
{
  this->Pieces.Close();
  this->File.reset();
  this->FileMerges = 0;
}

//------------------------------------------------------------------------------
void vtkGatunSimplify::vtkInternals::ForgetGrid()
{
  this->Tets = nullptr;
  this->Surface.reset();
  this->Input = nullptr;
  this->Tree = {};
}

//------------------------------------------------------------------------------
/** The merges of the file, after those that the reader makes. */
void vtkGatunSimplify::vtkInternals::FillFromFile(vtkGatunSimplify* self,
  const gatun::PublishedFile& handle, vtkInformation* inInfo, vtkInformation* outInfo,
  vtkPointSet* output)
{
  this->ForgetGrid();
  if (handle.File != this->File)
  {
    this->ForgetFile();
    this->File = handle.File;
  }
  const gatun::FileReader& file = *handle.File->GetFile();
  handle.File->RequireHierarchy();
  // The target is about the reader's mesh, except for an error, which is about the whole mesh.
  const gatun::SimplifyTarget target = Target(self).GetTarget();
  const bool isError = target.Kind == gatun::SimplifyTarget::RMSError;
  const std::size_t before = isError ? 0 : handle.Merges;
  const std::size_t merges = before +
    gatun::CountMerges(target, file.GetNumberOfPoints() - before, file.GetNumberOfMerges() - before,
      [&handle]() -> const gatun::MergeTree& { return handle.File->GetTree(); });
  this->FileMerges = std::max(merges, handle.Merges);

  gatun::PortRequest port(file, outInfo);
  port.Step = gatun::GetRequestedStep(file, inInfo);
  this->Pieces.Choose(handle, this->FileMerges);
  std::vector<std::uint32_t> chunks(this->Pieces.GetMesh().GetChunks().size());
  std::iota(chunks.begin(), chunks.end(), 0u);
  auto* const surface = vtkPolyData::SafeDownCast(output);
  vtkSmartPointer<vtkUnstructuredGrid> grid = vtkUnstructuredGrid::SafeDownCast(output);
  if (surface)
  {
    grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
  this->Pieces.Read(handle, this->Pieces.MakeRequest(handle, port, chunks),
    handle.GenerateGlobalIds || port.Pieces > 1, grid,
    [self](double fraction)
    {
      self->UpdateProgress(fraction);
      return !gatun::IsAborted(self);
    });
  if (surface)
  {
    gatun::MakeSurface(grid, gatun::FindSurfaceCells(grid), surface);
  }
  gatun::SetStepTime(file, port.Step, output);
}

//------------------------------------------------------------------------------
void vtkGatunSimplify::vtkInternals::FillFromGrid(vtkGatunSimplify* self, vtkInformation* outInfo,
  vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  this->ForgetFile();
  this->Prepare(self, outInfo, input);
  const std::size_t merges = this->CountMerges(self);
  if (merges == 0)
  {
    output->ShallowCopy(this->Tets);
    return;
  }
  FillOutput(this->Tets, this->Tree, merges, output);
  this->OutputRMSError = this->Tree.GetLargestError(merges);
}

//------------------------------------------------------------------------------
void vtkGatunSimplify::vtkInternals::FillFromSurface(
  vtkGatunSimplify* self, vtkInformation* outInfo, vtkPolyData* input, vtkPolyData* output)
{
  this->ForgetFile();
  const gatun::MergeSettings settings{ static_cast<gatun::MergeMetric>(self->Metric),
    self->BoundaryWeight };
  const int pieces = vtkStreamingDemandDrivenPipeline::GetUpdateNumberOfPieces(outInfo);
  if (!this->IsPrepared(input, pieces, settings) || self->FeatureAngle != this->FeatureAngle)
  {
    auto surface = std::make_unique<gatun::SimplifiedSurface>(input, this->Weights,
      gatun::SurfaceMergeSettings{ self->BoundaryWeight, self->FeatureAngle, pieces > 1 },
      [self](double done)
      {
        self->UpdateProgress(0.9 * done);
        return !gatun::IsAborted(self);
      });
    this->ForgetGrid();
    this->Tree = surface->TakeTree();
    this->Surface = std::move(surface);
    this->FeatureAngle = self->FeatureAngle;
    this->SetPrepared(input, pieces, settings);
  }
  const std::size_t merges = this->CountMerges(self);
  this->Surface->Fill(this->Tree, merges, output);
  this->OutputRMSError = this->Tree.GetLargestError(merges);
}

//------------------------------------------------------------------------------
std::size_t vtkGatunSimplify::vtkInternals::CountMerges(const vtkGatunSimplify* self) const
{
  return this->Tree.CountMergesOfRounds(
    gatun::CountMerges(Target(self).GetTarget(), this->Tree.GetNumberOfPoints(),
      this->Tree.GetMerges().size(), [this]() -> const gatun::MergeTree& { return this->Tree; }));
}

//------------------------------------------------------------------------------
/** Whether the order of merges is known. */
bool vtkGatunSimplify::vtkInternals::IsPrepared(
  vtkPointSet* input, int pieces, const gatun::MergeSettings& settings) const
{
  return (this->Tets || this->Surface) && input == this->Input &&
    input->GetMTime() == this->Stamp && pieces == this->NumberOfPieces &&
    this->Weights == this->UsedWeights && settings.Metric == this->Settings.Metric &&
    settings.BoundaryWeight == this->Settings.BoundaryWeight;
}

//------------------------------------------------------------------------------
/** Finds the order of merges, unless it is known. */
void vtkGatunSimplify::vtkInternals::Prepare(
  vtkGatunSimplify* self, vtkInformation* outInfo, vtkUnstructuredGrid* input)
{
  const gatun::MergeSettings settings{ static_cast<gatun::MergeMetric>(self->Metric),
    self->BoundaryWeight };
  const int pieces = vtkStreamingDemandDrivenPipeline::GetUpdateNumberOfPieces(outInfo);
  gatun::ProcessExchange exchange(FindController(self, outInfo));
  const auto isPrepared = exchange.Gather<std::uint8_t>(this->IsPrepared(input, pieces, settings));
  if (std::find(isPrepared.begin(), isPrepared.end(), 0) == isPrepared.end())
  {
    return;
  }
  vtkNew<vtkUnstructuredGrid> tets;
  exchange.Together(
    [&]
    {
      const auto made = gatun::MakeTetInput(input);
      for (const auto& warning : made.Warnings)
      {
        vtkWarningWithObjectMacro(self, << warning);
      }
      tets->ShallowCopy(made.Grid); // the input itself may be given something else later
    });
  std::vector<std::uint8_t> isKept;
  if (exchange.GetProcesses() > 1)
  {
    isKept = gatun::FindCommonPoints(tets, exchange);
  }
  else if (pieces > 1)
  {
    isKept = gatun::FindCommonPoints(tets, input);
  }
  auto tree = gatun::BuildMergeTree(
    tets, this->Weights, settings,
    [self](double done)
    {
      self->UpdateProgress(0.9 * done);
      return !gatun::IsAborted(self);
    },
    isKept);
  // All at once, so that whatever fails leaves what belongs together.
  this->Surface.reset();
  this->Tets = tets;
  this->Tree = std::move(tree);
  this->SetPrepared(input, pieces, settings);
}

//------------------------------------------------------------------------------
void vtkGatunSimplify::vtkInternals::SetPrepared(
  vtkPointSet* input, int pieces, const gatun::MergeSettings& settings)
{
  this->Input = input;
  this->Stamp = input->GetMTime();
  this->NumberOfPieces = pieces;
  this->UsedWeights = this->Weights;
  this->Settings = settings;
}

//------------------------------------------------------------------------------
gatun::SimplifyProperties vtkGatunSimplify::vtkInternals::Target(const vtkGatunSimplify* self)
{
  return { self->SimplificationRatio, self->SimplificationNumberOfPoints,
    self->SimplificationRMSError };
}

//------------------------------------------------------------------------------
vtkGatunSimplify::vtkGatunSimplify()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkGatunSimplify::~vtkGatunSimplify()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkGatunSimplify::SetArrayWeight(const char* name, double weight)
{
  if (this->Internals->Weights.Set(name, weight))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkGatunSimplify::GetArrayWeight(const char* name)
{
  return this->Internals->Weights.Get(name);
}

//------------------------------------------------------------------------------
void vtkGatunSimplify::ClearArrayWeights()
{
  if (this->Internals->Weights.Clear())
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunSimplify::GetMostMerges()
{
  const auto& self = *this->Internals;
  return static_cast<vtkIdType>(
    self.File ? self.File->GetFile()->GetNumberOfMerges() : self.Tree.GetMerges().size());
}

//------------------------------------------------------------------------------
double vtkGatunSimplify::GetOutputRMSError()
{
  auto& self = *this->Internals;
  if (!self.File || self.FileMerges == 0)
  {
    return self.OutputRMSError;
  }
  try
  {
    // The tree is not needed for the output if that is a base mesh.
    const gatun::MergeTree& tree = self.File->GetTree();
    return tree.GetLargestError(tree.CountMergesOfRounds(self.FileMerges));
  }
  catch (...)
  {
    vtkErrorMacro(<< gatun::DescribeFailure(self.File->GetFile()->GetPath().c_str()).Message);
    return 0;
  }
}

//------------------------------------------------------------------------------
vtkInformation* vtkGatunSimplify::GetFileInformation(vtkInformation* inInfo)
{
  return inInfo;
}

//------------------------------------------------------------------------------
int vtkGatunSimplify::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunSimplify::ExecuteInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* const outInfo = outputVector->GetInformationObject(0);
  outInfo->Remove(gatun::ExactGhostLevels());
  if (vtkInternals::FindHierarchy(this, inputVector[0]->GetInformationObject(0)))
  {
    // As the reader, whose ghost levels depend on nothing but the request.
    outInfo->Set(gatun::ExactGhostLevels(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunSimplify::ComputeInputUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* const inInfo = inputVector[0]->GetInformationObject(0);
  // Only where the handle is that of the input itself: others are asked as always.
  if (gatun::GetUsableFile(inInfo) && vtkInternals::FindHierarchy(this, inInfo))
  {
    gatun::RequestNothing(inInfo);
    return 1;
  }
  vtkInformation* const outInfo = outputVector->GetInformationObject(0);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (Pipeline::GetUpdateNumberOfPieces(outInfo) > 1 &&
    !vtkInternals::FindController(this, outInfo))
  {
    // Their points are those that pieces have in common.
    inInfo->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      std::max(1, Pipeline::GetUpdateGhostLevel(outInfo)));
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunSimplify::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* const inInfo = inputVector[0]->GetInformationObject(0);
  vtkInformation* const outInfo = outputVector->GetInformationObject(0);
  auto* const output = vtkPointSet::GetData(outInfo);
  output->Initialize();
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(output);
  auto* const surface = vtkPolyData::GetData(inInfo);
  this->SetErrorCode(vtkErrorCode::NoError);
  auto& self = *this->Internals;
  self.OutputRMSError = 0;
  const gatun::PublishedFile* const file = vtkInternals::FindHierarchy(this, inInfo);
  try
  {
    if (file)
    {
      self.FillFromFile(this, *file, inInfo, outInfo, output);
    }
    else if (surface)
    {
      self.FillFromSurface(this, outInfo, surface, vtkPolyData::SafeDownCast(output));
    }
    else
    {
      self.FillFromGrid(this, outInfo, vtkUnstructuredGrid::GetData(inInfo), grid);
    }
    this->UpdateProgress(1);
    return 1;
  }
  catch (...)
  {
    output->Initialize();
    self.Pieces.ForgetMesh();
    const gatun::VTKFailure failure =
      gatun::DescribeFailure(file ? file->Path.c_str() : "The mesh cannot be simplified");
    this->SetErrorCode(failure.Code);
    gatun::ReportFailure(this, failure, nullptr);
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkGatunSimplify::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  vtkInternals::Target(this).Print(os, indent);
  os << indent << "Metric: " << (this->Metric == METRIC_MASS ? "Mass" : "Density") << "\n";
  os << indent << "BoundaryWeight: " << this->BoundaryWeight << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "UseFileHierarchy: " << (this->UseFileHierarchy ? "On" : "Off") << "\n";
  this->Internals->Weights.Print(os, indent);
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
