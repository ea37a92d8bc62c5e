// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunSimplify.h"

#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunMergeBuilder.h"
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
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkGatunSimplify);

namespace
{
/** A mesh as the core takes it. */
struct Mesh
{
  std::vector<std::array<double, 3>> Points;
  std::vector<gatun::MergeTree::Tet> Tets;
  std::vector<std::vector<double>> Values;
  std::vector<double> Weights;

  explicit Mesh(vtkUnstructuredGrid* grid)
    : Points(static_cast<std::size_t>(grid->GetNumberOfPoints()))
    , Tets(static_cast<std::size_t>(grid->GetNumberOfCells()))
  {
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      grid->GetPoint(static_cast<vtkIdType>(i), this->Points[i].data());
    }
    for (std::size_t i = 0; i < this->Tets.size(); ++i)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      grid->GetCellPoints(static_cast<vtkIdType>(i), count, ids);
      for (std::size_t c = 0; c < 4; ++c)
      {
        if (ids[c] < 0 || ids[c] >= grid->GetNumberOfPoints())
        {
          gatun::ThrowInvalid("cell " + std::to_string(i) + " has a point that does not exist");
        }
        this->Tets[i][c] = static_cast<std::uint32_t>(ids[c]);
      }
    }
  }

  void AddArray(vtkDataArray* array, double weight)
  {
    const int components = array->GetNumberOfComponents();
    for (int c = 0; c < components; ++c)
    {
      auto& values = this->Values.emplace_back(this->Points.size());
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        values[i] = array->GetComponent(static_cast<vtkIdType>(i), c);
      }
      this->Weights.push_back(weight / components);
    }
  }

  gatun::MergeInput GetInput() const
  {
    gatun::MergeInput input{ this->Points, this->Tets, {} };
    for (std::size_t i = 0; i < this->Values.size(); ++i)
    {
      input.Fields.push_back({ this->Values[i], this->Weights[i] });
    }
    return input;
  }
};

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
  std::map<std::string, double> Weights;

  // What the tree was made for.
  vtkSmartPointer<vtkUnstructuredGrid> Tets;
  vtkUnstructuredGrid* Input = nullptr; // only ever compared
  vtkMTimeType Stamp = 0;
  std::map<std::string, double> UsedWeights;
  gatun::MergeSettings Settings;
  gatun::MergeTree Tree;
  double OutputError = 0;

  void Prepare(vtkGatunSimplify* self, vtkUnstructuredGrid* input);
  void AddArrays(vtkPointData* data, Mesh& mesh) const;
  std::size_t CountMerges(const vtkGatunSimplify* self) const;
};

//------------------------------------------------------------------------------
void vtkGatunSimplify::vtkInternals::AddArrays(vtkPointData* data, Mesh& mesh) const
{
  for (const auto& [name, weight] : this->Weights)
  {
    vtkDataArray* const array = data->GetArray(name.c_str());
    if (!array)
    {
      gatun::ThrowInvalid("there is no point array '" + name + "', which has a weight");
    }
    mesh.AddArray(array, weight);
  }
  if (!this->Weights.empty())
  {
    return;
  }
  if (data->GetScalars())
  {
    mesh.AddArray(data->GetScalars(), 1);
    return;
  }
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* const array = data->GetArray(i))
    {
      mesh.AddArray(array, 1);
    }
  }
}

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
  Mesh mesh(tets);
  this->AddArrays(tets->GetPointData(), mesh);
  auto weights = this->Weights;
  auto tree = gatun::BuildMergeTree(mesh.GetInput(), settings,
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
std::size_t vtkGatunSimplify::vtkInternals::CountMerges(const vtkGatunSimplify* self) const
{
  const double points = this->Tree.GetNumberOfPoints();
  double left = 0;
  switch (self->Target)
  {
    case TARGET_RATIO:
      if (!(self->Ratio >= 0 && self->Ratio <= 1))
      {
        gatun::ThrowInvalid("the ratio must be from 0 to 1");
      }
      left = points - std::floor(points * self->Ratio);
      break;
    case TARGET_PERCENT:
      if (!(self->Percent >= 0 && self->Percent <= 100))
      {
        gatun::ThrowInvalid("the percentage must be from 0 to 100");
      }
      left = std::ceil(points * self->Percent / 100);
      break;
    case TARGET_NUMBER_OF_POINTS:
      if (self->NumberOfPoints < 0)
      {
        gatun::ThrowInvalid("the number of points must be 0 or more");
      }
      return this->Tree.CountMergesForPoints(static_cast<std::uint64_t>(self->NumberOfPoints));
    default:
      if (!(self->MaximumError >= 0))
      {
        gatun::ThrowInvalid("the error must be 0 or more");
      }
      return this->Tree.CountMergesForError(self->MaximumError);
  }
  return this->Tree.CountMergesForPoints(static_cast<std::uint64_t>(left));
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
  if (name && (!this->Internals->Weights.count(name) || this->Internals->Weights[name] != weight))
  {
    this->Internals->Weights[name] = weight;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkGatunSimplify::GetArrayWeight(const char* name)
{
  const auto& weights = this->Internals->Weights;
  const auto found = name ? weights.find(name) : weights.end();
  return found == weights.end() ? 0 : found->second;
}

//------------------------------------------------------------------------------
void vtkGatunSimplify::ClearArrayWeights()
{
  if (!this->Internals->Weights.empty())
  {
    this->Internals->Weights.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunSimplify::GetMostMerges()
{
  return static_cast<vtkIdType>(this->Internals->Tree.GetMerges().size());
}

//------------------------------------------------------------------------------
double vtkGatunSimplify::GetOutputError()
{
  return this->Internals->OutputError;
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
  self.OutputError = 0;
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
      self.OutputError = self.Tree.GetLargestError(merges);
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
  const char* const targets[] = { "Ratio", "Percent", "NumberOfPoints", "MaximumError" };
  os << indent << "Target: " << targets[this->Target] << "\n";
  os << indent << "Ratio: " << this->Ratio << "\n";
  os << indent << "Percent: " << this->Percent << "\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "Metric: " << (this->Metric == METRIC_MASS ? "Mass" : "Density") << "\n";
  os << indent << "BoundaryWeight: " << this->BoundaryWeight << "\n";
  for (const auto& [name, weight] : this->Internals->Weights)
  {
    os << indent << "Weight of " << name << ": " << weight << "\n";
  }
}
