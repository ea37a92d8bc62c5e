// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchWindow.h"

#include "benchHarness.h"

#include "gatunParallel.h"
#include "vtkGatunVolumeMapper.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGridVolumeRayCastMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace bench
{
namespace
{
template <typename Class>
vtkSmartPointer<Class> MakeCaster()
{
  auto mapper = vtkSmartPointer<Class>::New();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetImageSampleDistance(1);
  return mapper;
}

Mapper Make(bool isGatun, int budget)
{
  if (isGatun)
  {
    auto mapper = MakeCaster<vtkGatunVolumeMapper>();
    mapper->SetMemoryBudget(budget);
    return mapper;
  }
  auto mapper = MakeCaster<vtkUnstructuredGridVolumeRayCastMapper>();
  mapper->SetNumberOfThreads(gatun::GetNumberOfThreads());
  return mapper;
}
}

//------------------------------------------------------------------------------
Mapper MakeMapper(bool isGatun, const std::string& array, int budget)
{
  Mapper mapper = Make(isGatun, budget);
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectScalarArray(array.c_str());
  return mapper;
}

//------------------------------------------------------------------------------
VolumeWindow::VolumeWindow(int size)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(size, size);
  this->Window->AddRenderer(this->Renderer);
  this->Window->Render();
  this->Window->WaitForCompletion();
}

VolumeWindow::~VolumeWindow() = default;

//------------------------------------------------------------------------------
void VolumeWindow::SetVolume(vtkUnstructuredGridVolumeMapper* mapper, const Scene& scene)
{
  this->View = scene;
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  scene.SetUp(volume->GetProperty());
  this->Renderer->RemoveAllViewProps();
  this->Renderer->AddVolume(volume);
}

//------------------------------------------------------------------------------
void VolumeWindow::Render(double turn)
{
  this->View.SetUp(this->Renderer->GetActiveCamera(), turn);
  this->Window->Render();
  this->Window->WaitForCompletion();
}

//------------------------------------------------------------------------------
double VolumeWindow::GetMean()
{
  const int* const extent = this->Window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  this->Window->GetPixelData(0, 0, extent[0] - 1, extent[1] - 1, 0, pixels);
  double sum = 0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfValues(); ++i)
  {
    sum += pixels->GetValue(i);
  }
  if (sum <= 0)
  {
    throw Failure("an image is empty");
  }
  return sum / (255 * static_cast<double>(pixels->GetNumberOfValues()));
}
}
