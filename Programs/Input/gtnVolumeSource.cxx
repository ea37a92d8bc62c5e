// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnVolumeSource.h"

#include "gtnFailure.h"
#include "gtnInput.h"
#include "gtnReadable.h"
#include "gtnSettings.h"
#include "gtnText.h"

#include "gatunHartleyFile.h"
#include "vtkGatunDefaults.h"

#include "vtkDataArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace gtn
{
//------------------------------------------------------------------------------
VolumeSource::VolumeSource(const VolumeInputOptions& options, const Settings& settings)
  : File(options.Files.front())
{
  if (ExtensionOf(this->File) != ".ghv")
  {
    this->Read(options, settings);
    return;
  }
  if (!options.Array.empty() || options.Spacing)
  {
    throw UsageError("--array and --spacing do not apply to .ghv files");
  }
  this->OpenFile();
}

//------------------------------------------------------------------------------
VolumeSource::~VolumeSource() = default;

//------------------------------------------------------------------------------
void VolumeSource::OpenFile()
{
  CheckReadable(this->File);
  const gatun::HartleyFile file(this->File);
  const gatun::VolumeInput& volume = file.GetVolume();
  this->Array = volume.Name;
  this->Range = file.GetRange();
  vtkNew<vtkGatunHartleyReader> reader;
  reader->SetFileName(this->File.c_str());
  this->Reader = reader;

  vtkNew<vtkImageData> place;
  place->SetDimensions(static_cast<int>(volume.Size[0]), static_cast<int>(volume.Size[1]),
    static_cast<int>(volume.Size[2]));
  int extent[6];
  place->GetExtent(extent);
  for (std::size_t i = 0; i < 6; ++i)
  {
    extent[i] += volume.FirstIndex[i / 2];
  }
  place->SetExtent(extent);
  place->SetOrigin(volume.Origin.data());
  place->SetSpacing(volume.Spacing.data());
  place->SetDirectionMatrix(volume.Direction.data());
  this->SetPlace(place);
}

//------------------------------------------------------------------------------
void VolumeSource::Read(const VolumeInputOptions& options, const Settings& settings)
{
  this->Volume = ReadVolume(options, settings);
  vtkDataArray* const array = this->Volume->GetPointData()->GetScalars();
  this->Array = array->GetName() ? array->GetName() : "";
  double range[2];
  array->GetRange(range);
  this->Range = { range[0], range[1] };
  this->SetPlace(this->Volume);
}

//------------------------------------------------------------------------------
void VolumeSource::SetPlace(vtkImageData* volume)
{
  const double* const bounds = volume->GetBounds();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Bounds[axis] = { bounds[2 * axis], bounds[2 * axis + 1] };
    this->Size[axis] = static_cast<std::uint32_t>(volume->GetDimensions()[axis]);
  }
}

//------------------------------------------------------------------------------
void VolumeSource::Connect(vtkImageAlgorithm* algorithm) const
{
  if (this->Reader)
  {
    algorithm->SetInputConnection(this->Reader->GetOutputPort());
  }
  else
  {
    algorithm->SetInputData(this->Volume);
  }
}

//------------------------------------------------------------------------------
void VolumeSource::Connect(vtkGatunDefaults* defaults) const
{
  if (this->Reader)
  {
    defaults->SetInputConnection(this->Reader->GetOutputPort());
  }
  else
  {
    defaults->SetInputData(this->Volume);
  }
}
}
