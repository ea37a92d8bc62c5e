// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnTetGen_h
#define gtnTetGen_h

// TetGen, by a library that is loaded on demand, so that it need not be installed.

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;

namespace gtn
{
/** The properties of vtkGatunTetrahedralize. */
struct MeshSettings
{
  double Quality = 1.414;
  double MinDihedral = 0;
  double MaximumVolume = 0;
  bool PreserveSurface = false;
  std::string Switches;
};

struct Mesher
{
  /** A filter from a surface to its tetrahedra. Does not throw. */
  vtkSmartPointer<vtkAlgorithm> (*Make)(const MeshSettings& settings);
};

/** What the library gtnTetGen exports by this name. */
inline constexpr const char* MesherName = "gtnMesher";
}

#endif
