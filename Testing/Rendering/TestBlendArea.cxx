// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A volume in mode area, one sample a tetrahedron, looks as it did.

#include "gatunBlendPicture.h"

int TestBlendArea(int argc, char* argv[])
{
  return CompareBlendPicture(argc, argv, vtkGatunVolumeMapper::AREA_BLEND);
}
