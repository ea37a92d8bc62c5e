// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunSimplify.h"

#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunMergeGrid.h"
#include "gatunSimplifyTarget.h"
#include "gatunTetInput.h"
#include "vtkGatunCompat.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
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

namespace
{
static_assert(int{ vtkGatunSimplify::TARGET_RATIO } == gatun::SimplifyTarget::Ratio);
static_assert(
  int{ vtkGatunSimplify::TARGET_NUMBER_OF_POINTS } == gatun::SimplifyTarget::NumberOfPoints);
static_assert(int{ vtkGatunSimplify::TARGET_RMS_ERROR } == gatun::SimplifyTarget::RMSError);

void CopyTuples(vtkDataSetAttributes* from, vtkIdList* ids, vtkDataSetAttributes* to)
{
  vtkNew<vtkIdList> places;
  places->SetNumberOfIds(ids->GetNumberOfIds());
  std::iota(places->begin(), places->end(), vtkIdType{ 0 });
  to->CopyGlobalIdsOn();
  to->CopyAllocate(from, ids->GetNumberOfIds());
  to->CopyData(from, ids, places);
}

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
  grid->GetPoints()->GetPoints(kept, points);
  output->SetPoints(points);
  CopyTuples(grid->GetPointData(), kept, output->GetPointData());

  vtkNew<vtkIdList> cells;
  vtkNew<vtkCellArray> tets;
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
      tets->InsertNextCell({ places[tet[0]], places[tet[1]], places[tet[2]], places[tet[3]] });
      cells->InsertNextId(cell);
    }
  }
  output->SetCells(VTK_TETRA, tets);
  CopyTuples(grid->GetCellData(), cells, output->GetCellData());
  output->GetFieldData()->ShallowCopy(grid->GetFieldData());
}
}

//------------------------------------------------------------------------------
class vtkGatunSimplify::vtkInternals
{
public:
  gatun::MergeWeights Weights;

  // What the tree was made for.
  vtkSmartPointer<vtkUnstructuredGrid> Tets;
  vtkUnstructuredGrid* Input = nullptr; // only ever compared
  vtkMTimeType Stamp = 0;
  gatun::MergeWeights UsedWeights;
  gatun::MergeSettings Settings;
  gatun::MergeTree Tree;
  double OutputRMSError = 0;

  void Prepare(vtkGatunSimplify* self, vtkUnstructuredGrid* input);
  static gatun::SimplifyProperties Target(const vtkGatunSimplify* self);
  std::size_t CountMerges(const vtkGatunSimplify* self) const;
};

//------------------------------------------------------------------------------
/** Finds the order of merges, unless it is known. */
void vtkGatunSimplify::vtkInternals::Prepare(vtkGatunSimplify* self, vtkUnstructuredGrid* input)
{
  const gatun::MergeSettings settings{ static_cast<gatun::MergeMetric>(self->Metric),
    self->BoundaryWeight };
  if (this->Tets && input == this->Input && input->GetMTime() == this->Stamp &&
    this->Weights == this->UsedWeights && settings.Metric == this->Settings.Metric &&
    settings.BoundaryWeight == this->Settings.BoundaryWeight)
  {
    return;
  }
  const auto made = gatun::MakeTetInput(input, true);
  for (const auto& warning : made.Warnings)
  {
    vtkWarningWithObjectMacro(self, << warning);
  }
  // The input itself may be given something else later.
  vtkNew<vtkUnstructuredGrid> tets;
  tets->ShallowCopy(made.Grid);
  auto weights = this->Weights;
  auto tree = gatun::BuildMergeTree(tets, weights, settings,
    [self](double done)
    {
      self->UpdateProgress(0.9 * done);
      return !gatun::IsAborted(self);
    });
  // All at once, so that whatever fails leaves what belongs together.
  this->Tets = tets;
  this->Tree = std::move(tree);
  this->Input = input;
  this->Stamp = input->GetMTime();
  this->UsedWeights = std::move(weights);
  this->Settings = settings;
}

//------------------------------------------------------------------------------
gatun::SimplifyProperties vtkGatunSimplify::vtkInternals::Target(const vtkGatunSimplify* self)
{
  return { self->SimplificationTarget, self->SimplificationRatio,
    self->SimplificationNumberOfPoints, self->SimplificationRMSError };
}

//------------------------------------------------------------------------------
std::size_t vtkGatunSimplify::vtkInternals::CountMerges(const vtkGatunSimplify* self) const
{
  return gatun::CountMerges(Target(self).GetTarget(), this->Tree.GetNumberOfPoints(),
    this->Tree.GetMerges().size(), [this]() -> const gatun::MergeTree& { return this->Tree; });
}

//------------------------------------------------------------------------------
vtkGatunSimplify::vtkGatunSimplify()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkGatunSimplify::~vtkGatunSimplify() = default;

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
  return static_cast<vtkIdType>(this->Internals->Tree.GetMerges().size());
}

//------------------------------------------------------------------------------
double vtkGatunSimplify::GetOutputRMSError()
{
  return this->Internals->OutputRMSError;
}

//------------------------------------------------------------------------------
int vtkGatunSimplify::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* const input = vtkUnstructuredGrid::GetData(inputVector[0], 0);
  auto* const output = vtkUnstructuredGrid::GetData(outputVector, 0);
  output->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);
  auto& self = *this->Internals;
  self.OutputRMSError = 0;
  try
  {
    self.Prepare(this, input);
    const std::size_t merges = self.CountMerges(this);
    if (merges == 0)
    {
      output->ShallowCopy(self.Tets);
    }
    else
    {
      FillOutput(self.Tets, self.Tree, merges, output);
      self.OutputRMSError = self.Tree.GetLargestError(merges);
    }
    this->UpdateProgress(1);
    return 1;
  }
  catch (...)
  {
    output->Initialize();
    const gatun::VTKFailure failure = gatun::DescribeFailure("The mesh cannot be simplified");
    this->SetErrorCode(failure.Code);
    if (!failure.Aborted)
    {
      vtkErrorMacro(<< failure.Message);
    }
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
  this->Internals->Weights.Print(os, indent);
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
