// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunImageEncoder.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
bool ImageEncoder::Encode(vtkImageData* image, vtkInformation* wanted,
  const HartleyParameters& parameters, const std::function<bool(double)>& progress)
{
  vtkDataArray* const array = FindVolumeArray(image, wanted);
  const vtkMTimeType time = std::max(image->GetMTime(), array->GetMTime());
  if (this->Coefficients && this->Array == array && this->Time == time &&
    this->Parameters == parameters)
  {
    return false;
  }
  this->Clear();
  const BridgedVolume bridged = BridgeVolume(image, wanted);
  this->Coefficients =
    HartleyVolume::Make(bridged.Volume, parameters.BlockSize, parameters.RateControl, progress);
  this->Volume = bridged.Volume;
  this->Volume.Values = nullptr;
  this->Array = array;
  this->Time = time;
  this->Parameters = parameters;
  return true;
}

//------------------------------------------------------------------------------
void ImageEncoder::Clear()
{
  this->Coefficients.reset();
  this->Volume = {};
  this->Array = nullptr;
}
}
