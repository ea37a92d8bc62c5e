// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchVolume.h"

#include "benchHarness.h"

#include "gatunVolumePhantoms.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

namespace bench
{
namespace
{
using Image = vtkSmartPointer<vtkImageData>;

/** head:96. The axes have different lengths, which are no multiples of a block. */
Image MakeHead(const std::string& name)
{
  const auto length = static_cast<std::uint32_t>(std::stoi(name.substr(name.find(':') + 1)));
  if (length < 8 || length > 1024)
  {
    throw Failure(name, "is too small or too large");
  }
  const auto phantom = gatun::test::MakeHead({ length, length - length / 16, length - length / 8 });
  auto image = Image::New();
  image->SetDimensions(static_cast<int>(phantom.Size[0]), static_cast<int>(phantom.Size[1]),
    static_cast<int>(phantom.Size[2]));
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::memcpy(image->GetScalarPointer(), phantom.Values.data(), phantom.Values.size());
  return image;
}

template <typename Reader>
Image Read(const std::string& file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

Image Open(const std::string& name)
{
  if (name.starts_with("head:"))
  {
    return MakeHead(name);
  }
  if (!std::filesystem::exists(name))
  {
    throw Failure(name, "is not there");
  }
  return name.ends_with(".vti") ? Read<vtkXMLImageDataReader>(name)
                                : Read<vtkNIFTIImageReader>(name);
}

gatun::ScalarType GetType(int type, const std::string& name)
{
  switch (type)
  {
    case VTK_UNSIGNED_CHAR:
      return gatun::ScalarType::UInt8;
    case VTK_SHORT:
      return gatun::ScalarType::Int16;
    case VTK_UNSIGNED_SHORT:
      return gatun::ScalarType::UInt16;
    case VTK_FLOAT:
      return gatun::ScalarType::Float32;
    default:
      throw Failure(name, "has voxels of a type that is not measured here");
  }
}
}

//------------------------------------------------------------------------------
Volume::Volume(const std::string& name)
  : Image(Open(name))
{
  vtkDataArray* const array = this->Image->GetPointData()->GetScalars();
  if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() == 0)
  {
    throw Failure(name, "has no scalars of one component");
  }
  GetType(array->GetDataType(), name);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Size[axis] = static_cast<std::uint32_t>(this->Image->GetDimensions()[axis]);
  }
  this->Voxels.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < this->Voxels.size(); ++i)
  {
    this->Voxels[i] = static_cast<float>(array->GetTuple1(static_cast<vtkIdType>(i)));
  }
  const auto [low, high] = std::minmax_element(this->Voxels.begin(), this->Voxels.end());
  this->Lowest = *low;
  this->Highest = *high;
}

Volume::~Volume() = default;

//------------------------------------------------------------------------------
vtkImageData* Volume::GetImage() const
{
  return this->Image;
}

//------------------------------------------------------------------------------
gatun::VolumeInput Volume::GetInput() const
{
  gatun::VolumeInput input;
  input.Size = this->Size;
  input.VTKType = this->Image->GetScalarType();
  input.Type = GetType(input.VTKType, "the volume");
  input.Values = this->Image->GetScalarPointer();
  this->Image->GetSpacing(input.Spacing.data());
  this->Image->GetOrigin(input.Origin.data());
  return input;
}

//------------------------------------------------------------------------------
bool Volume::IsInteger() const
{
  return this->Image->GetScalarType() != VTK_FLOAT;
}

//------------------------------------------------------------------------------
gatun::test::ReferenceVolume Volume::GetReference() const
{
  return { this->Voxels.data(), this->Size, this->Lowest };
}

//------------------------------------------------------------------------------
gatun::HartleyView Volume::MakeView(const Turns& turns, unsigned pixels, double scale) const
{
  gatun::HartleyView view = gatun::test::MakeTurnedView(this->Size, turns, pixels, scale);
  const double* const spacing = this->Image->GetSpacing();
  const double shortest = *std::min_element(spacing, spacing + 3);
  const double half = (pixels - 1) / 2.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double stretch = shortest / spacing[axis];
    view.Step[axis] *= stretch;
    view.ColumnStep[axis] *= stretch;
    view.RowStep[axis] *= stretch;
    view.Origin[axis] =
      (this->Size[axis] - 1) / 2.0 - half * (view.ColumnStep[axis] + view.RowStep[axis]);
  }
  return view;
}

//------------------------------------------------------------------------------
unsigned Volume::GetPixels(double scale) const
{
  const double* const spacing = this->Image->GetSpacing();
  const double shortest = *std::min_element(spacing, spacing + 3);
  double squares = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double length = (this->Size[axis] + 1) * spacing[axis] / shortest;
    squares += length * length;
  }
  return static_cast<unsigned>(std::ceil(scale * std::sqrt(squares)));
}

//------------------------------------------------------------------------------
gatun::HartleyShading MakeGray(
  const Volume& volume, gatun::HartleyOpacityModel model, double opacity)
{
  gatun::HartleyShading shading;
  shading.OpacityModel = model;
  shading.Zero = volume.GetLowest();
  shading.Extinction = -std::log(1 - opacity) / volume.GetRange();
  shading.First = volume.GetLowest();
  shading.Last = volume.GetHighest();
  shading.Table = { { 0, 0, 0, 0 }, { 1, 1, 1, static_cast<float>(opacity) } };
  return shading;
}

//------------------------------------------------------------------------------
gatun::HartleyRateControl MakeQuality(double rate)
{
  gatun::HartleyRateControl control;
  control.Mode = rate > 0 ? gatun::HartleyRateMode::BitsPerVoxel : gatun::HartleyRateMode::RMSError;
  control.Value = rate;
  return control;
}

//------------------------------------------------------------------------------
const std::array<Turns, 4>& GetPaperTurns()
{
  static const std::array<Turns, 4> turns{ { { 0, 0, 0 }, { 0.5, 0, 1 }, { 0.25, 0.25, 0.25 },
    { 0.48, 0.1, 0.95 } } };
  return turns;
}

//------------------------------------------------------------------------------
double GetPSNR(double range, double meanSquareError)
{
  return 10 * std::log10(range * range / meanSquareError);
}
}
