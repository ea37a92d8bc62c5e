// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunContour.h"

#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunFileConsumer.h"
#include "gatunFileContour.h"
#include "gatunGridContour.h"
#include "gatunReport.h"
#include "gatunStatistics.h"
#include "vtkGatunCompat.h"

#include "vtkContourValues.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunContour);

namespace
{
//------------------------------------------------------------------------------
/** Isovalues as the core takes them. */
std::vector<double> SortValues(vtkContourValues* values)
{
  const double* const first = values->GetValues();
  std::vector<double> sorted(first, first + values->GetNumberOfContours());
  if (!std::all_of(sorted.begin(), sorted.end(), [](double v) { return std::isfinite(v); }))
  {
    gatun::ThrowInvalid("an isovalue is not a finite number");
  }
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  return sorted;
}
}

//------------------------------------------------------------------------------
class vtkGatunContour::vtkInternals
{
public:
  vtkNew<vtkContourValues> Values;
  gatun::FileContour File;
  gatun::Statistics Statistics;

  gatun::ContourSettings GetSettings(vtkGatunContour* self)
  {
    return { SortValues(this->Values), gatun::ContourArray(self->GetInputArrayInformation(0)),
      self->ArrayComponent, self->ComputeNormals, self->ComputeScalars, self->OutputStrips,
      self->OutputPointsPrecision };
  }
};

//------------------------------------------------------------------------------
vtkGatunContour::vtkGatunContour()
  : Internals(std::make_unique<vtkInternals>())
{
  this->Internals->Values->SetNumberOfContours(0);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkGatunContour::~vtkGatunContour() = default;

//------------------------------------------------------------------------------
void vtkGatunContour::SetValue(int i, double value)
{
  this->Internals->Values->SetValue(i, value);
}

//------------------------------------------------------------------------------
double vtkGatunContour::GetValue(int i)
{
  return this->Internals->Values->GetValue(i);
}

//------------------------------------------------------------------------------
double* vtkGatunContour::GetValues()
{
  return this->Internals->Values->GetValues();
}

//------------------------------------------------------------------------------
void vtkGatunContour::GetValues(double* values)
{
  this->Internals->Values->GetValues(values);
}

//------------------------------------------------------------------------------
void vtkGatunContour::SetNumberOfContours(int number)
{
  this->Internals->Values->SetNumberOfContours(number);
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunContour::GetNumberOfContours()
{
  return this->Internals->Values->GetNumberOfContours();
}

//------------------------------------------------------------------------------
void vtkGatunContour::GenerateValues(int number, double range[2])
{
  this->Internals->Values->GenerateValues(number, range);
}

//------------------------------------------------------------------------------
void vtkGatunContour::GenerateValues(int number, double first, double last)
{
  this->Internals->Values->GenerateValues(number, first, last);
}

//------------------------------------------------------------------------------
vtkTable* vtkGatunContour::GetStatistics()
{
  const gatun::FileContour& file = this->Internals->File;
  gatun::Statistics& table = this->Internals->Statistics;
  table.Clear();
  table.Add("Chunks", file.GetNumberOfChunks());
  table.Add("UsedChunks", file.GetStatistics().Chunks);
  table.Add("UsedTetrahedra", file.GetStatistics().Tets);
  table.Add("BytesRead", file.GetBytesRead());
  return table.Get();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkGatunContour::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Internals->Values->GetMTime());
}

//------------------------------------------------------------------------------
int vtkGatunContour::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
vtkInformation* vtkGatunContour::GetFileInformation(vtkInformation* inInfo)
{
  return inInfo;
}

//------------------------------------------------------------------------------
int vtkGatunContour::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* const inInfo = inputVector[0]->GetInformationObject(0);
  if (gatun::GetUsableFile(inInfo))
  {
    gatun::RequestNothing(inInfo);
    return 1;
  }
  vtkInformation* const outInfo = outputVector->GetInformationObject(0);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (this->ComputeNormals && Pipeline::GetUpdateNumberOfPieces(outInfo) > 1)
  {
    inInfo->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      std::max(1, Pipeline::GetUpdateGhostLevel(outInfo)));
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunContour::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* const output = vtkPolyData::GetData(outputVector, 0);
  output->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);
  auto& self = *this->Internals;
  self.File.ClearStatistics();
  const auto progress = [this](double fraction)
  {
    this->UpdateProgress(fraction);
    return !gatun::IsAborted(this);
  };
  vtkInformation* const inInfo = inputVector[0]->GetInformationObject(0);
  const gatun::PublishedFile* const file = gatun::GetUsableFile(this->GetFileInformation(inInfo));
  try
  {
    const auto settings = self.GetSettings(this);
    if (file)
    {
      self.File.Fill(
        *file, settings, inInfo, outputVector->GetInformationObject(0), progress, output);
      if (const auto cells = self.File.CountFlatCells())
      {
        vtkWarningMacro(<< file->Path << ": there are no 3D cells, only " << cells
                        << " of a lower dimension");
      }
    }
    else
    {
      self.File.Close();
      const auto warnings =
        gatun::ContourGrid(vtkUnstructuredGrid::GetData(inInfo), settings, progress, output);
      for (const auto& warning : warnings)
      {
        vtkWarningMacro(<< warning);
      }
    }
    this->UpdateProgress(1);
    return 1;
  }
  catch (...)
  {
    output->Initialize();
    const gatun::VTKFailure failure =
      gatun::DescribeFailure(file ? file->Path.c_str() : "The isosurface cannot be made");
    this->SetErrorCode(failure.Code);
    gatun::ReportFailure(this, failure, nullptr);
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkGatunContour::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto tell = [](bool value) { return value ? "On" : "Off"; };
  os << indent << "Values:\n";
  this->Internals->Values->PrintSelf(os, indent.GetNextIndent());
  os << indent << "ArrayComponent: " << this->ArrayComponent << "\n";
  os << indent << "ComputeNormals: " << tell(this->ComputeNormals) << "\n";
  os << indent << "ComputeScalars: " << tell(this->ComputeScalars) << "\n";
  os << indent << "OutputStrips: " << tell(this->OutputStrips) << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
