// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunVolumeImage.h"

#include "gatunRayScene.h"

#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
RayStatistics VolumeImage::Draw(RayScene& scene, RaySource* other, const ImageSetup& setup,
  const RayGrid& grid, const RaySource::Progress& progress)
{
  this->Refresh.reset();
  RayCaster caster(setup.View, setup.Table, setup.Limits, setup.Settings);
  scene.Draw(caster, setup.View, progress, other);
  this->Image.Take(caster, grid);
  this->Redrawn = 1;
  return caster.GetStatistics();
}

//------------------------------------------------------------------------------
void VolumeImage::DrawChanges(std::shared_ptr<RaySource> source, ImageSetup setup,
  const RayGrid& grid, const RaySource::Progress& progress)
{
  setup.Settings.Repeatable = true;
  if (!this->Refresh || *this->Setup != setup)
  {
    this->Setup = std::make_shared<const ImageSetup>(std::move(setup));
    this->Refresh = std::make_unique<RayRefresh>(
      [kept = this->Setup] {
        return std::make_unique<RayCaster>(kept->View, kept->Table, kept->Limits, kept->Settings);
      });
  }
  this->Redrawn = this->Image.Take(*this->Refresh, std::move(source), grid, progress);
}

//------------------------------------------------------------------------------
void VolumeImage::Take(const std::vector<float>& colors, const Viewport& viewport)
{
  this->Refresh.reset();
  this->Image.Take(colors, viewport.Width, viewport.Height);
  this->Redrawn = 1;
}

//------------------------------------------------------------------------------
void VolumeImage::Show(const VolumeFrame& frame, bool inFront)
{
  this->Image.Show(frame.GetRenderer(), frame.GetVolume(), inFront);
}
}
