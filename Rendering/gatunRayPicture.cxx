// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunRayPicture.h"

#include "gatunError.h"
#include "gatunRayCaster.h"
#include "gatunRayRendering.h"

#include "vtkRayCastImageDisplayHelper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
unsigned short ToTexel(float value)
{
  return static_cast<unsigned short>(std::lround(std::clamp(value, 0.0f, 1.0f) * 65535));
}

// Depths are from 0 to 1, without 0, which VTK takes for none.
constexpr float Nearest = 1e-6f;

/** Where the middle of a volume is. VTK's own way to find out leaves it too far behind. */
float GetCentreDepth(vtkRenderer* renderer, vtkVolume* volume)
{
  const double* const centre = volume->GetCenter();
  renderer->SetWorldPoint(centre[0], centre[1], centre[2], 1);
  renderer->WorldToDisplay();
  return std::clamp(static_cast<float>(renderer->GetDisplayPoint()[2]), Nearest, 1.0f);
}
}

RayPicture::RayPicture() = default;
RayPicture::~RayPicture() = default;

//------------------------------------------------------------------------------
void RayPicture::Take(RayCaster& caster, const RayGrid& grid)
{
  const auto width = static_cast<std::size_t>(grid.Width);
  const auto height = static_cast<std::size_t>(grid.Height);
  this->Colours.resize(4 * width * height);
  caster.Finish(this->Colours.data());

  // VTK puts the outermost texels' centres on the borders of the picture. Where a ray is to be a
  // pixel, what a pixel shows would be between two rays, unless each is there twice.
  const std::size_t times = grid.ToBorders ? 1 : 2;
  this->Size = { static_cast<int>(times) * grid.Width, static_cast<int>(times) * grid.Height };
  this->Texels.resize(4 * times * width * times * height);
  auto* out = this->Texels.data();
  for (std::size_t y = 0; y < times * height; ++y)
  {
    const float* in = this->Colours.data() + 4 * (y / times) * width;
    for (std::size_t x = 0; x < width; ++x, in += 4)
    {
      std::transform(in, in + 4, out, ToTexel);
      out += 4;
      if (times == 2)
      {
        out = std::copy(out - 4, out, out);
      }
    }
  }
}

//------------------------------------------------------------------------------
void RayPicture::Show(vtkRenderer* renderer, vtkVolume* volume, bool inFront)
{
  if (!this->Helper)
  {
    this->Helper = vtk::TakeSmartPointer(vtkRayCastImageDisplayHelper::New());
  }
  if (!this->Helper)
  {
    throw Error(ErrorCode::InvalidInput,
      "the program has no way to show volumes; VTK::RenderingVolumeOpenGL2 is not there");
  }
  this->Helper->PreMultipliedColorsOn();
  std::array<int, 2> origin{};
  const float depth = inFront ? Nearest : GetCentreDepth(renderer, volume);
  this->Helper->RenderTexture(volume, renderer, this->Size.data(), this->Size.data(),
    this->Size.data(), origin.data(), depth, this->Texels.data());
  // It would not notice that its program goes with another window which shares the context, as when
  // a view of ParaView is closed, and then show nothing.
  this->Helper->ReleaseGraphicsResources(renderer->GetRenderWindow());
}

//------------------------------------------------------------------------------
void RayPicture::Release(vtkWindow* window)
{
  if (this->Helper)
  {
    this->Helper->ReleaseGraphicsResources(window);
  }
}
}
