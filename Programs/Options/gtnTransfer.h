// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnTransfer_h
#define gtnTransfer_h

// Which value has which color and opacity.

#include "gatunTypes.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPiecewiseFunction;
class vtkVolumeProperty;

namespace gtn
{
struct ColorNode
{
  double Value;
  double Red;
  double Green;
  double Blue;
};

/** What is between this node and the next one: see vtkPiecewiseFunction::AddPoint. */
struct OpacityNode
{
  double Value;
  double Opacity;
  double Midpoint = 0.5;
  double Sharpness = 0;
};

/** How colors between two nodes are mixed, as vtkColorTransferFunction can. */
enum class ColorSpace
{
  RGB,
  HSV,
  Lab,
  LabCIEDE2000,
  Diverging,
  Step
};

/** Nodes by ascending value; several may be at one value, where there is a jump. Outside them,
 * their outermost colors and opacities go on. */
struct Transfer
{
  std::vector<ColorNode> Colors;      ///< at least two, not all at one value
  std::vector<OpacityNode> Opacities; ///< at least one
  ColorSpace Space = ColorSpace::RGB;
};

/** Names of the transfer functions that are built in. */
std::vector<std::string> GetPresetNames();

/** A built-in one, for values of 0 to 1, or one from a file: a color map as ParaView exports it.
 * Throws UsageError if the name is neither, and Failure if the file is no good. */
Transfer FindTransfer(const std::string& presetOrFile);

/** From a file. Throws Failure. */
Transfer ReadTransfer(const std::string& file);

/** Writes functions of a property to a file that ReadTransfer and ParaView read. Throws Failure. */
void WriteTransfer(vtkVolumeProperty* property, const std::string& name, const std::string& file);

/** Whether the colors are for values of 0 to 1, to be stretched to those of the mesh. */
bool IsNormalized(const Transfer& transfer);

/** Moves all nodes as it takes to bring the first color to Min and the last one to Max. */
void Stretch(Transfer& transfer, const gatun::Range& range);

/** Multiplies all opacities, which stay at most 1. */
void ScaleOpacity(Transfer& transfer, double factor);

/** The same for a function of VTK. */
void ScaleOpacity(vtkPiecewiseFunction* opacity, double factor);

/** What vtkGatunRayCaster wants to have; the opacities are those of a length of unitDistance. */
vtkSmartPointer<vtkVolumeProperty> MakeProperty(const Transfer& transfer, double unitDistance);
}

#endif
