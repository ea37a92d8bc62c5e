// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A volume as in an X-ray looks as it did.

#include "gatunBlendPicture.h"

int TestBlendXRay(int argc, char* argv[])
{
  return CompareBlendPicture(argc, argv, vtkGatunVolumeMapper::XRAY_BLEND);
}
