// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchPixels.h"

#include "benchHarness.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"

#include <algorithm>
#include <cmath>

namespace bench
{
//------------------------------------------------------------------------------
void WritePicture(const Pixels& pixels, int size, const std::string& file)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* const bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < pixels.size() / 4; ++i)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const double value = std::clamp(static_cast<double>(pixels[4 * i + c]), 0.0, 1.0);
      bytes[3 * i + c] = static_cast<unsigned char>(std::lround(255 * value));
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(image);
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    throw Failure(file, "cannot be written");
  }
}
}
