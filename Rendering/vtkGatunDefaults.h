// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunDefaults
 * @brief A transfer function that shows structure, and a camera from which an object fills the
 * image.
 *
 * Input: a vtkUnstructuredGrid with 3D cells and point or cell scalars, or a vtkImageData with
 * point scalars; for cameras also a vtkPolyData. Behind a vtkGatunReader, a vtkGatunSurfaceReader
 * or a vtkGatunHartleyReader, the file is used: the mesh or volume is not read as a whole, and the
 * reader is not asked for it. Other algorithms are updated.
 *
 * *Transfer function.* Values that fill most of the volume are nearly transparent. Values that are
 * rare, or far from the median, are opaque. Opacities are scaled so that the image is neither empty
 * nor solid. They follow from a histogram, weighted by volume, of meshes with up to two million
 * tetrahedra and volumes with up to eight million voxels as a whole, and of evenly distributed
 * parts of larger ones. Colors span the values without the outermost 0.05 % of the volume at each
 * end, so that outliers do not matter. NaN and infinite values are left out. A constant is drawn as
 * an even haze. The result does not depend on the number of threads, nor on chunks or on whether
 * the mesh is in a file, if it is used as a whole. Of a series, the values of one time step are
 * used: for images with one scale, set Range, or use the functions of one step.
 *
 * *Camera.* The camera keeps its direction, and is moved so that the projection of all cells fills
 * 94 % of the width or height of the image and is in its middle. Of a file, the outermost chunks
 * are decoded, up to 2^20 points. Other chunks count by their boxes, so that the object may fill
 * less of the image, but nothing is cut off.
 *
 * *Cost.* A histogram decodes the chunks that it uses once, or up to four times if a few values are
 * far from all others.
 *
 * *Errors.* Methods return false and report missing or damaged input by vtkErrorMacro. Arguments
 * are unchanged then.
 *
 * @sa vtkGatunVolumeMapper vtkGatunRayCaster vtkGatunHartleyProjection
 */

#ifndef vtkGatunDefaults_h
#define vtkGatunDefaults_h

#include "vtkGatunRenderingModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkAlgorithmOutput;
class vtkCamera;
class vtkColorTransferFunction;
class vtkDataObject;
class vtkPiecewiseFunction;
class vtkVolumeProperty;

class VTKGATUNRENDERING_EXPORT vtkGatunDefaults : public vtkObject
{
public:
  static vtkGatunDefaults* New();
  vtkTypeMacro(vtkGatunDefaults, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The object: the output of an algorithm, or data. Default: none, which is an error.
   */
  void SetInputConnection(vtkAlgorithmOutput* output);
  void SetInputData(vtkDataObject* data);
  ///@}

  ///@{
  /**
   * Name of the array that is drawn. Without a name, the active scalars of the points are used, or
   * those of the cells if there are none. Default: none.
   */
  vtkSetStringMacro(ArrayName);
  vtkGetStringMacro(ArrayName);
  ///@}

  ///@{
  /**
   * Association of the array: points (0), cells (1), or points, then cells (-1). Default: -1.
   */
  vtkSetClampMacro(ArrayAssociation, int, -1, 1);
  vtkGetMacro(ArrayAssociation, int);
  ///@}

  ///@{
  /**
   * Component of the array, from 0. -1 is the length of the tuple, or the value of an array of one
   * component. Default: -1.
   */
  vtkSetClampMacro(ArrayComponent, int, -1, VTK_INT_MAX);
  vtkGetMacro(ArrayComponent, int);
  ///@}

  ///@{
  /**
   * Time of a file. If UseTime is off, the last time that the reader was asked for, or the first
   * one. Defaults: 0 and off.
   */
  vtkSetMacro(Time, double);
  vtkGetMacro(Time, double);
  vtkSetMacro(UseTime, bool);
  vtkGetMacro(UseTime, bool);
  vtkBooleanMacro(UseTime, bool);
  ///@}

  ///@{
  /**
   * Range of values that colors and opacities span. If the first value is not below the second one,
   * the histogram determines the range. Default: 1, -1.
   */
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  ///@}

  ///@{
  /**
   * Length of a ray to which the opacities refer, in world units. 0: a hundredth of the diagonal of
   * the object's bounds. Not negative. Default: 0.
   */
  vtkSetClampMacro(UnitDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(UnitDistance, double);
  ///@}

  /**
   * Sets colors, opacities and the unit distance of opacities.
   */
  bool MakeProperty(vtkVolumeProperty* property);

  /**
   * Replaces the nodes of a color and an opacity function, either of which may be null. Opacities
   * are for UnitDistance.
   */
  bool MakeFunctions(vtkColorTransferFunction* colors, vtkPiecewiseFunction* opacities);

  /**
   * Colors for a range of values, from violet over blue and green to yellow, with even steps of
   * lightness. Replaces the nodes of the function.
   */
  static void MakeColors(double least, double most, vtkColorTransferFunction* colors);

  /**
   * Opacities for a range of values, from 0.01 to 0.45, that grow with them: for images of the
   * largest value of each ray, which do not depend on lengths. Replaces the nodes of the function.
   */
  static void MakeRamp(double least, double most, vtkPiecewiseFunction* opacities);

  /**
   * Moves the camera along its direction of projection so that all of the object fills the image.
   * Aspect: width by height of the image. Position, focal point and parallel scale are set; view
   * angle, direction, view up and the kind of projection are kept.
   */
  bool FitCamera(vtkCamera* camera, double aspect);

  /**
   * The same with a given point in the middle of an image.
   */
  bool FitCameraAt(vtkCamera* camera, double aspect, double x, double y, double z);

protected:
  vtkGatunDefaults();
  ~vtkGatunDefaults() override;

  char* ArrayName = nullptr;
  int ArrayAssociation = -1;
  int ArrayComponent = -1;
  double Time = 0;
  bool UseTime = false;
  double Range[2] = { 1, -1 };
  double UnitDistance = 0;

private:
  vtkGatunDefaults(const vtkGatunDefaults&) = delete;
  void operator=(const vtkGatunDefaults&) = delete;

  class vtkInternals;
  const std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
