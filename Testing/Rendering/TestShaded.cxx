// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A shaded volume looks as it did.

#include "gatunBlendPicture.h"

int TestShaded(int argc, char* argv[])
{
  return CompareBlendPicture(argc, argv, vtkGatunVolumeMapper::COMPOSITE_BLEND, true);
}
