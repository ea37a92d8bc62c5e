// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunHartleyOutput.h"

#include "gatunNewArray.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gatun
{
namespace
{
using Pixel = std::array<float, 4>;

//------------------------------------------------------------------------------
unsigned char ToByte(double value)
{
  return static_cast<unsigned char>(std::lround(255 * std::clamp(value, 0., 1.)));
}

//------------------------------------------------------------------------------
Pixel Over(const Pixel& pixel, const std::array<double, 3>& background)
{
  const double through = 1. - static_cast<double>(pixel[3]);
  Pixel opaque{ 0, 0, 0, 1 };
  for (std::size_t i = 0; i < 3; ++i)
  {
    opaque[i] = static_cast<float>(static_cast<double>(pixel[i]) + through * background[i]);
  }
  return opaque;
}

//------------------------------------------------------------------------------
// Not premultiplied, as in image files.
void SetBytes(const Pixel& pixel, unsigned char* bytes)
{
  const double alpha = pixel[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    bytes[i] = ToByte(alpha > 0 ? static_cast<double>(pixel[i]) / alpha : 0);
  }
  bytes[3] = ToByte(alpha);
}

//------------------------------------------------------------------------------
vtkNew<vtkFloatArray> MakeFloats(const char* name, int components, vtkIdType tuples)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  SizeArray(array, tuples);
  return array;
}
}

//------------------------------------------------------------------------------
void FillImage(const HartleyImage& drawn, const ImageOutput& options,
  const std::array<int, 6>& extent, vtkImageData* output)
{
  output->SetExtent(extent[0], extent[1], extent[2], extent[3], extent[4], extent[5]);
  const vtkIdType pixels = output->GetNumberOfPoints();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Color");
  colors->SetNumberOfComponents(4);
  SizeArray(colors, pixels);
  const vtkNew<vtkFloatArray> rgba = MakeFloats("RGBA", 4, options.Floats ? pixels : 0);
  const bool hasSums = options.Floats && !drawn.Sums.empty();
  const vtkNew<vtkFloatArray> sums = MakeFloats("Sum", 1, hasSums ? pixels : 0);
  const vtkNew<vtkFloatArray> samples = MakeFloats("Samples", 1, hasSums ? pixels : 0);
  vtkIdType to = 0;
  for (int row = extent[2]; pixels > 0 && row <= extent[3]; ++row)
  {
    for (int column = extent[0]; column <= extent[1]; ++column, ++to)
    {
      const std::size_t from =
        static_cast<std::size_t>(row) * drawn.Width + static_cast<std::size_t>(column);
      const Pixel& color = drawn.Colors[from];
      const Pixel pixel = options.Background ? Over(color, *options.Background) : color;
      SetBytes(pixel, colors->GetPointer(4 * to));
      if (options.Floats)
      {
        std::copy(pixel.begin(), pixel.end(), rgba->GetPointer(4 * to));
      }
      if (hasSums)
      {
        sums->SetValue(to, drawn.Sums[from]);
        samples->SetValue(to, drawn.Samples[from]);
      }
    }
  }
  output->GetPointData()->SetScalars(colors);
  if (options.Floats)
  {
    output->GetPointData()->AddArray(rgba);
  }
  if (hasSums)
  {
    output->GetPointData()->AddArray(sums);
    output->GetPointData()->AddArray(samples);
  }
}
}
