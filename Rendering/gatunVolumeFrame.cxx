// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunVolumeFrame.h"

#include "gatunRayImage.h"

#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
//------------------------------------------------------------------------------
Viewport::Viewport(vtkRenderer* renderer)
{
  renderer->GetTiledSizeAndOrigin(&this->Width, &this->Height, &this->X, &this->Y);
}

//------------------------------------------------------------------------------
VolumeFrame::VolumeFrame(vtkRenderer* renderer, vtkVolume* volume, const VolumeSettings& settings)
  : Renderer(renderer)
  , Volume(volume)
  , Settings(settings)
  , Port(renderer)
{
  volume->GetMatrix(this->Matrix);
}

VolumeFrame::~VolumeFrame() = default;

//------------------------------------------------------------------------------
RayGrid VolumeFrame::MakeGrid(float distance) const
{
  const bool toBorders =
    distance > 1 || std::max(this->Port.Width, this->Port.Height) > RayImage::MostPixels;
  const auto count = [&](int pixels)
  { return toBorders ? std::max(2, static_cast<int>(std::ceil(pixels / distance))) : pixels; };
  return { count(this->Port.Width), count(this->Port.Height), this->Renderer->GetTiledAspectRatio(),
    toBorders };
}

//------------------------------------------------------------------------------
RayView VolumeFrame::MakeView(const RayGrid& grid) const
{
  return MakeRayView(this->Renderer->GetActiveCamera(), grid, this->Matrix, true);
}

//------------------------------------------------------------------------------
std::shared_ptr<const DetailView> VolumeFrame::MakeDetailView(const Range& values) const
{
  const RayView view = this->MakeView(this->MakeGrid(1));
  return gatun::MakeDetailView(this->Settings.Detail.PixelError, view,
    MakeRayTable(this->Volume->GetProperty(), this->Settings.Mode, values, view.SampleDistance));
}

//------------------------------------------------------------------------------
ImageSetup VolumeFrame::MakeSetup(const void* mesh, const RayView& view, const Range& values) const
{
  vtkVolumeProperty* const property = this->Volume->GetProperty();
  RaySettings settings;
  settings.Opaque = static_cast<float>(this->Settings.OpacityLimit);
  settings.Shading = MakeRayShading(
    property, this->Renderer->GetActiveCamera(), this->Renderer->GetLights(), this->Matrix);
  return { mesh, this->Renderer, this->Volume, view,
    MakeRayTable(property, this->Settings.Mode, values, view.SampleDistance),
    MakeRayLimits(view, this->Settings.ClippingPlanes, this->Matrix), settings };
}

//------------------------------------------------------------------------------
void VolumeFrame::ReadDepths(vtkFloatArray* depths) const
{
  this->Renderer->GetRenderWindow()->GetZbufferData(this->Port.X, this->Port.Y,
    this->Port.X + this->Port.Width - 1, this->Port.Y + this->Port.Height - 1, depths);
}
}
