// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A volume in mode sampled looks as it did.

#include "gatunBlendPicture.h"

int TestBlendSampled(int argc, char* argv[])
{
  return CompareBlendPicture(argc, argv, vtkGatunVolumeMapper::SAMPLED_BLEND);
}
