// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunHartleyParameters.h"

#include "vtkGatunHartleyEncoding.h"

namespace gatun
{
//------------------------------------------------------------------------------
HartleyParameters GetParameters(vtkGatunHartleyEncoding* encoding)
{
  HartleyParameters parameters;
  parameters.BlockSize = static_cast<std::uint32_t>(encoding->GetBlockSize());
  HartleyRateControl& control = parameters.RateControl;
  control.FrequencyWeight = encoding->GetFrequencyWeight();
  control.Mode = static_cast<HartleyRateMode>(encoding->GetRateControl());
  switch (control.Mode)
  {
    case HartleyRateMode::Quality:
      control.Value = encoding->GetQuality();
      break;
    case HartleyRateMode::RMSError:
      control.Value = encoding->GetRMSError();
      break;
    case HartleyRateMode::PSNR:
      control.Value = encoding->GetPSNR();
      break;
    case HartleyRateMode::BitsPerVoxel:
      control.Value = encoding->GetBitsPerVoxel();
      break;
  }
  return parameters;
}
}
