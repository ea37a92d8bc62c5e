// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchSurface.h"
#include "benchFiles.h"

#include "vtkGatunContour.h"
#include "vtkGatunReader.h"

#include "vtkContour3DLinearGrid.h"
#include "vtkContourGrid.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSpanSpace.h"
#include "vtkUnstructuredGrid.h"

namespace bench
{
namespace
{
/** Makes them with one filter. */
template <typename Filter>
class FilterMaker : public SurfaceMaker
{
public:
  explicit FilterMaker(const std::string& array)
  {
    this->Contour->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
  }

  vtkSmartPointer<vtkPolyData> Make(const std::vector<double>& values) override
  {
    this->Contour->SetNumberOfContours(static_cast<int>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      this->Contour->SetValue(static_cast<int>(i), values[i]);
    }
    this->Contour->Modified(); // also for the values that it had
    this->Contour->Update();
    auto* const output = vtkPolyData::SafeDownCast(this->Contour->GetOutputDataObject(0));
    if (!output || this->Contour->GetErrorCode() != 0)
    {
      throw Failure("an isosurface cannot be made");
    }
    vtkNew<vtkPolyData> copy;
    copy->ShallowCopy(output);
    return copy.Get();
  }

  vtkNew<Filter> Contour;
};

class GatunMaker final : public FilterMaker<vtkGatunContour>
{
public:
  using FilterMaker::FilterMaker;
  vtkGatunContour* GetGatun() override { return this->Contour; }
  vtkGatunReader* GetReader() override { return this->Reader; }
  vtkNew<vtkGatunReader> Reader;
};

class SpanMaker final : public FilterMaker<vtkContourGrid>
{
public:
  explicit SpanMaker(const std::string& array)
    : FilterMaker(array)
  {
    this->Contour->UseScalarTreeOn();
    this->Contour->SetScalarTree(this->Tree);
  }

private:
  vtkNew<vtkSpanSpace> Tree;
};
}

//------------------------------------------------------------------------------
std::unique_ptr<SurfaceMaker> MakeSurfaceMaker(
  const std::string& way, vtkUnstructuredGrid* grid, const std::string& array)
{
  if (way == "memory")
  {
    auto maker = std::make_unique<GatunMaker>(array);
    maker->Contour->SetInputData(grid);
    return maker;
  }
  if (way == "linear")
  {
    auto maker = std::make_unique<FilterMaker<vtkContour3DLinearGrid>>(array);
    maker->Contour->SetInputData(grid);
    maker->Contour->MergePointsOn();
    return maker;
  }
  auto maker = std::make_unique<SpanMaker>(array);
  maker->Contour->SetInputData(grid);
  return maker;
}

//------------------------------------------------------------------------------
std::unique_ptr<SurfaceMaker> MakeSurfaceMaker(
  const std::string& way, const std::string& file, const std::string& array)
{
  if (way == "file")
  {
    auto maker = std::make_unique<GatunMaker>(array);
    maker->Reader->SetFileName(file.c_str());
    maker->Reader->SetMemoryBudget(0);
    maker->Contour->SetInputConnection(maker->Reader->GetOutputPort());
    return maker;
  }
  return MakeSurfaceMaker(way, Load(file), array);
}
}
