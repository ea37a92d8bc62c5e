// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnWriteImage.h"

#include "gtnFailure.h"
#include "gtnImageFile.h"
#include "gtnText.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace gtn
{
const char* const ImageFormats = ".png or .exr";

namespace
{

unsigned char ToByte(double value)
{
  return static_cast<unsigned char>(std::lround(255 * std::clamp(value, 0., 1.)));
}

// Four bytes of a pixel, or three where there is a background.
void AppendBytes(
  const float* rgba, const std::optional<Color>& background, std::vector<unsigned char>& bytes)
{
  const double alpha = rgba[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double color = rgba[i];
    bytes.push_back(ToByte(background ? color + (1 - alpha) * (*background)[i]
        : alpha > 0                   ? color / alpha
                                      : 0));
  }
  if (!background)
  {
    bytes.push_back(ToByte(alpha));
  }
}

void AppendFloats(
  const float* rgba, const std::optional<Color>& background, std::vector<float>& floats)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double through = background ? (1. - rgba[3]) * (*background)[i] : 0;
    floats.push_back(static_cast<float>(rgba[i] + through));
  }
  floats.push_back(background ? 1.F : rgba[3]);
}

} // anonymous namespace

//------------------------------------------------------------------------------
bool IsImage(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  return extension == ".png" || extension == ".exr";
}

//------------------------------------------------------------------------------
void WriteImage(vtkImageData* rendered, const std::optional<Color>& background,
  const std::vector<std::pair<std::string, std::string>>& remarks, const std::string& file)
{
  auto* const colors = vtkFloatArray::SafeDownCast(rendered->GetPointData()->GetArray("RGBA"));
  auto* const depths = vtkFloatArray::SafeDownCast(rendered->GetPointData()->GetArray("Depth"));
  if (!colors)
  {
    throw Failure(file, "there is no image to write");
  }
  const bool asBytes = ExtensionOf(file) == ".png";
  Image image{ rendered->GetDimensions()[0], rendered->GetDimensions()[1], { "R", "G", "B" },
    asBytes ? gatun::ScalarType::UInt8 : gatun::ScalarType::Float32 };
  image.Remarks = remarks;
  if (!asBytes || !background)
  {
    image.Channels.emplace_back("A");
  }
  if (!asBytes && depths)
  {
    image.Channels.emplace_back("Z");
  }
  std::vector<unsigned char> bytes;
  std::vector<float> floats;
  const auto pixels = static_cast<std::size_t>(colors->GetNumberOfTuples());
  asBytes ? bytes.reserve(pixels * image.Channels.size())
          : floats.reserve(pixels * image.Channels.size());
  // VTK's rows go up, those of files go down.
  for (vtkIdType row = image.Height - 1; row >= 0; --row)
  {
    for (vtkIdType i = row * image.Width; i < (row + 1) * image.Width; ++i)
    {
      const float* const rgba = colors->GetPointer(4 * i);
      if (asBytes)
      {
        AppendBytes(rgba, background, bytes);
        continue;
      }
      AppendFloats(rgba, background, floats);
      if (depths)
      {
        floats.push_back(depths->GetValue(i));
      }
    }
  }
  image.Values = asBytes ? static_cast<const void*>(bytes.data()) : floats.data();
  WriteImageFile(image, file);
}
}
