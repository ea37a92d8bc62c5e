// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunRayImage.h"

#include "gatunError.h"
#include "gatunParallel.h"
#include "gatunRayCaster.h"
#include "gatunRayRefresh.h"
#include "gatunRayRendering.h"

#include "vtkRayCastImageDisplayHelper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <array>
#include <utility>

namespace gatun
{
namespace
{
// Of a strip of the image that goes to the graphics card at once.
constexpr std::size_t MostTexels = std::size_t{ 1 } << 20;

/** Row by row, of what is from 0 to 1. Times: how often each of the numbers' fours is there. */
void ToTexels(const float* numbers, std::size_t width, std::size_t times, unsigned short* texels)
{
  for (std::size_t x = 0; x < width; ++x, numbers += 4)
  {
    for (std::size_t copy = 0; copy < times; ++copy, texels += 4)
    {
      for (std::size_t c = 0; c < 4; ++c)
      {
        const float v = numbers[c];
        const float inRange = v > 0 ? (v < 1 ? v : 1.0f) : 0.0f; // NaN too
        texels[c] = static_cast<unsigned short>(inRange * 65535 + 0.5f);
      }
    }
  }
}

// Depths are from 0 to 1, without 0, which VTK takes for none.
constexpr float Nearest = 1e-6f;
}

//------------------------------------------------------------------------------
float GetDepth(vtkRenderer* renderer, const double* point)
{
  renderer->SetWorldPoint(point[0], point[1], point[2], 1);
  renderer->WorldToDisplay();
  return std::clamp(static_cast<float>(renderer->GetDisplayPoint()[2]), Nearest, 1.0f);
}

RayImage::RayImage() = default;
RayImage::~RayImage() = default;

//------------------------------------------------------------------------------
void RayImage::SetGrid(const RayGrid& grid)
{
  this->Width = grid.Width;
  this->Height = grid.Height;
  this->IsExact = !grid.ToBorders;
  this->Colors.resize(
    4 * static_cast<std::size_t>(grid.Width) * static_cast<std::size_t>(grid.Height));
}

//------------------------------------------------------------------------------
void RayImage::Take(RayCaster& caster, const RayGrid& grid)
{
  this->SetGrid(grid);
  caster.Finish(this->Colors.data());
}

//------------------------------------------------------------------------------
double RayImage::Take(RayRefresh& refresh, std::shared_ptr<RaySource> source, const RayGrid& grid,
  const std::function<bool(double)>& progress)
{
  this->SetGrid(grid);
  return refresh.Draw(std::move(source), this->Colors.data(), progress);
}

//------------------------------------------------------------------------------
void RayImage::Take(std::vector<float> colors, int width, int height, bool toBorders)
{
  this->SetGrid({ width, height, 0, toBorders });
  this->Colors = std::move(colors);
}

//------------------------------------------------------------------------------
void RayImage::Show(vtkRenderer* renderer, vtkVolume* volume, bool inFront)
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
  // VTK's own way to find the middle leaves it too far behind.
  const float depth = inFront ? Nearest : GetDepth(renderer, volume->GetCenter());

  // VTK puts the outermost texels' centers on the borders of the image. Where a ray is to be a
  // pixel, what a pixel shows would be between two rays, unless each is there twice. And then
  // strips of the image fit together, and take less memory than all of it.
  const int times = this->IsExact ? 2 : 1;
  const auto perRow = static_cast<std::size_t>(times) * static_cast<std::size_t>(this->Width);
  const std::array<int, 2> whole{ times * this->Width, times * this->Height };
  const int most =
    this->IsExact ? std::max(1, static_cast<int>(MostTexels / (2 * perRow))) : this->Height;
  for (int first = 0; first < this->Height; first += most)
  {
    const int rows = std::min(most, this->Height - first);
    this->Texels.resize(4 * perRow * static_cast<std::size_t>(times * rows));
    ParallelFor(static_cast<std::size_t>(rows),
      [&](std::size_t row)
      {
        const auto from =
          4 * (static_cast<std::size_t>(first) + row) * static_cast<std::size_t>(this->Width);
        for (int copy = 0; copy < times; ++copy)
        {
          const auto to = row * static_cast<std::size_t>(times) + static_cast<std::size_t>(copy);
          ToTexels(this->Colors.data() + from, static_cast<std::size_t>(this->Width),
            static_cast<std::size_t>(times), this->Texels.data() + 4 * perRow * to);
        }
      });
    std::array<int, 2> size{ whole[0], times * rows };
    std::array<int, 2> viewport = whole;
    std::array<int, 2> origin{ 0, times * first };
    this->Helper->RenderTexture(volume, renderer, size.data(), viewport.data(), size.data(),
      origin.data(), depth, this->Texels.data());
  }
  // It would not notice that its program goes with another window which shares the context, as when
  // a view of ParaView is closed, and then show nothing.
  this->Helper->ReleaseGraphicsResources(renderer->GetRenderWindow());
}

//------------------------------------------------------------------------------
void RayImage::Release(vtkWindow* window)
{
  if (this->Helper)
  {
    this->Helper->ReleaseGraphicsResources(window);
  }
}
}
