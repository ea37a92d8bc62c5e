// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunGatherImages.h"

#include "vtkDataObject.h"
#include "vtkImageAppend.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunGatherImages);

namespace
{
//------------------------------------------------------------------------------
// The parts that are not empty, in copies whose indices are those of the first one's origin.
std::vector<vtkSmartPointer<vtkImageData>> PlaceParts(vtkInformationVector* inputs)
{
  std::vector<vtkSmartPointer<vtkImageData>> parts;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    vtkImageData* const part = vtkImageData::GetData(inputs, i);
    if (!part || part->GetNumberOfPoints() == 0)
    {
      continue;
    }
    auto copy = vtkSmartPointer<vtkImageData>::New();
    copy->ShallowCopy(part);
    if (!parts.empty())
    {
      std::array<double, 3> index{};
      parts.front()->TransformPhysicalPointToContinuousIndex(part->GetOrigin(), index.data());
      std::array<int, 6> extent{};
      part->GetExtent(extent.data());
      for (std::size_t k = 0; k < extent.size(); ++k)
      {
        extent[k] += static_cast<int>(std::lround(index[k / 2]));
      }
      copy->SetExtent(extent.data());
      copy->SetOrigin(parts.front()->GetOrigin());
    }
    parts.push_back(copy);
  }
  return parts;
}
}

//------------------------------------------------------------------------------
vtkGatunGatherImages::vtkGatunGatherImages() = default;

vtkGatunGatherImages::~vtkGatunGatherImages() = default;

//------------------------------------------------------------------------------
int vtkGatunGatherImages::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkGatunGatherImages::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // parts tell where they are when they are there
}

//------------------------------------------------------------------------------
int vtkGatunGatherImages::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int i = 0; i < inputs[0]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* const info = inputs[0]->GetInformationObject(i);
    if (info->Has(Pipeline::WHOLE_EXTENT()))
    {
      info->Set(Pipeline::UPDATE_EXTENT(), info->Get(Pipeline::WHOLE_EXTENT()), 6);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunGatherImages::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* const output = vtkImageData::GetData(outputs, 0);
  output->Initialize();
  const auto parts = PlaceParts(inputs[0]);
  if (parts.empty())
  {
    return 1;
  }
  vtkNew<vtkImageAppend> append;
  append->PreserveExtentsOn();
  for (const auto& part : parts)
  {
    append->AddInputData(part);
  }
  append->Update();
  output->ShallowCopy(append->GetOutput());
  // It begins where the first voxel is.
  std::array<int, 6> extent{};
  output->GetExtent(extent.data());
  std::array<double, 3> origin{};
  output->TransformIndexToPhysicalPoint(extent[0], extent[2], extent[4], origin.data());
  output->SetExtent(0, extent[1] - extent[0], 0, extent[3] - extent[2], 0, extent[5] - extent[4]);
  output->SetOrigin(origin.data());
  return 1;
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
