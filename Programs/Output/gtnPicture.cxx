// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnPicture.h"

#include "gtnFailure.h"
#include "gtnImageFile.h"
#include "gtnImageLibrary.h"
#include "gtnOutput.h"
#include "gtnText.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace gtn
{
const char* const PictureFormats = ".png or .exr";

namespace
{

unsigned char ToByte(double value)
{
  return static_cast<unsigned char>(std::lround(255 * std::clamp(value, 0., 1.)));
}

// Four bytes of a pixel, or three where there is a background.
void AppendBytes(
  const float* rgba, const std::optional<Colour>& background, std::vector<unsigned char>& bytes)
{
  const double alpha = rgba[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double colour = rgba[i];
    bytes.push_back(ToByte(background ? colour + (1 - alpha) * (*background)[i]
        : alpha > 0                   ? colour / alpha
                                      : 0));
  }
  if (!background)
  {
    bytes.push_back(ToByte(alpha));
  }
}

void AppendFloats(
  const float* rgba, const std::optional<Colour>& background, std::vector<float>& floats)
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
bool IsPicture(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  return extension == ".png" || extension == ".exr";
}

//------------------------------------------------------------------------------
void WritePicture(vtkImageData* picture, const std::optional<Colour>& background,
  const std::vector<std::pair<std::string, std::string>>& remarks, const std::string& file)
{
  auto* const colours = vtkFloatArray::SafeDownCast(picture->GetPointData()->GetArray("RGBA"));
  auto* const depths = vtkFloatArray::SafeDownCast(picture->GetPointData()->GetArray("Depth"));
  if (!colours)
  {
    throw Failure(file, "there is no picture to write");
  }
  Image image;
  image.Width = picture->GetDimensions()[0];
  image.Height = picture->GetDimensions()[1];
  image.Remarks = remarks;
  const bool asBytes = ExtensionOf(file) == ".png";
  image.Channels = { "R", "G", "B" };
  if (!asBytes)
  {
    image.Channels.emplace_back("A");
    if (depths)
    {
      image.Channels.emplace_back("Z");
    }
  }
  else if (!background)
  {
    image.Channels.emplace_back("A");
  }
  const auto pixels = static_cast<std::size_t>(colours->GetNumberOfTuples());
  asBytes ? image.Bytes.reserve(pixels * image.Channels.size())
          : image.Floats.reserve(pixels * image.Channels.size());
  // VTK's rows go up, those of files down.
  for (vtkIdType row = image.Height - 1; row >= 0; --row)
  {
    for (vtkIdType i = row * image.Width; i < (row + 1) * image.Width; ++i)
    {
      const float* const rgba = colours->GetPointer(4 * i);
      if (asBytes)
      {
        AppendBytes(rgba, background, image.Bytes);
      }
      else
      {
        AppendFloats(rgba, background, image.Floats);
        if (depths)
        {
          image.Floats.push_back(depths->GetValue(i));
        }
      }
    }
  }

  static auto* const write = FindImageFunction<WriteImageFunction>(WriteImageName);
  TemporaryFile temporary(file);
  std::string reason;
  if (!write(image, temporary.GetName(), reason))
  {
    FailForImage(file, temporary.GetName(), reason, "cannot be written");
  }
  temporary.Commit();
}
}
