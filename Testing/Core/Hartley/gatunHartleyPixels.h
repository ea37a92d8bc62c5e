// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyPixels_h
#define gatunHartleyPixels_h

// Views of volumes, and how images are compared pixel by pixel.

#include "gatunHartleyProjector.h"
#include "gatunVolumeReference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace gatun::test
{
/** The dissertation's, ones that are nearly along an axis, and others. */
inline std::vector<Vector> GetTurns()
{
  std::vector<Vector> turns{ { 0, 0, 0 }, { 0.5, 0, 1 }, { 0.25, 0.25, 0.25 }, { 0.48, 0.1, 0.95 },
    { 0.003, 0.002, 0 }, { 1, 0.501, 0.3 }, { 0.25, 0, 0 } };
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-1, 1);
  for (int i = 0; i < 3; ++i)
  {
    turns.push_back({ angle(random), angle(random), angle(random) });
  }
  return turns;
}

struct PixelDifference
{
  double Largest = 0;
  double Mean = 0; // root of the mean square

  void Add(double a, double b)
  {
    this->Largest = std::max(this->Largest, std::abs(a - b));
    this->Squares += (a - b) * (a - b);
    this->Mean = std::sqrt(this->Squares / static_cast<double>(++this->Count));
  }

private:
  double Squares = 0;
  std::size_t Count = 0;
};

/** Calls use(index, point that is seen) for each pixel. */
template <typename Use>
void ForEachPixel(const HartleyView& view, Use&& use)
{
  for (unsigned row = 0; row < view.Height; ++row)
  {
    for (unsigned column = 0; column < view.Width; ++column)
    {
      use(std::size_t{ row } * view.Width + column, GetPixel(view, column, row));
    }
  }
}

/** Densities are as bright as they are large, and as opaque. */
inline HartleyShading MakeGray(HartleyOpacityModel opacities)
{
  HartleyShading shading;
  shading.OpacityModel = opacities;
  for (int i = 0; i < 256; ++i)
  {
    const float part = static_cast<float>(i) / 255;
    shading.Table.push_back({ part, part, part, 0.2f * part });
  }
  return shading;
}
}

#endif
