// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The library gtnTetGen. It is apart from the program, so that it need not be installed.

#include "gtnTetGen.h"

#include "vtkGatunTetrahedralize.h"

#include "vtkNew.h"

namespace
{

vtkSmartPointer<vtkAlgorithm> MakeMesher(const gtn::MeshSettings& settings)
{
  vtkNew<vtkGatunTetrahedralize> mesher;
  mesher->SetQuality(settings.Quality);
  mesher->SetMinDihedral(settings.MinDihedral);
  mesher->SetMaximumVolume(settings.MaximumVolume);
  mesher->SetPreserveSurface(settings.PreserveSurface);
  mesher->SetSwitches(settings.Switches.c_str());
  return mesher;
}

} // anonymous namespace

extern "C" const gtn::Mesher gtnMesher;
const gtn::Mesher gtnMesher{ MakeMesher };
