// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunVolumeArrays_h
#define gatunVolumeArrays_h

#include <string>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkColorTransferFunction;
class vtkDataSet;
class vtkGatunVolumeMapper;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** An array as ParaView's panel names it. */
struct ChosenArray
{
  std::string Name; ///< empty for none
  bool OfCells = false;
  int Component = 0; ///< the number of components, or more, for the length of the tuple
};

/** What ParaView's panel says about the arrays of a volume. */
struct VolumeChoice
{
  ChosenArray Color;           ///< the component is that of the color map
  bool MapScalars = true;      ///< off: up to four components are colors and opacity themselves
  bool MapsComponents = false; ///< "Multi Components Mapping"
  bool HasOpacity = false;     ///< whether opacities are by an array of their own
  ChosenArray Opacity;
};

/**
 * Sets which arrays a mapper draws. As with ParaView's volumes, opacities are by the separate
 * array, if there is one. Otherwise, with Multi Components Mapping or without Map Scalars, an array
 * with two components has its color in the first and its opacity in the second, and one with four
 * has red, green, blue and opacity. Opacities are always those of the opacity function. Arrays:
 * where the chosen ones are; may be null.
 */
void SetVolumeArrays(vtkGatunVolumeMapper* mapper, vtkDataSet* arrays, const VolumeChoice& choice,
  vtkColorTransferFunction* colors);
}

#endif
