// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A volume in mode maximum looks as it did.

#include "gatunBlendPicture.h"

int TestBlendMaximum(int argc, char* argv[])
{
  return CompareBlendPicture(argc, argv, vtkGatunVolumeMapper::MAXIMUM_INTENSITY_BLEND);
}
