// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunRayCaster
 * @brief Volume rendering of a tetrahedral mesh into an image, without a window.
 *
 * Input: a vtkUnstructuredGrid with point or cell scalars of any numeric type. Other 3D cells than
 * tetrahedra are split into tetrahedra (Documentation/cells.md), nonlinear ones without the points
 * between their corners. Cells of a lower dimension are left out, and so are hidden, refined and
 * duplicate cells (vtkGhostType). Tetrahedra with a coordinate or value that is NaN or infinite are
 * invisible.
 *
 * If the input is the output of a vtkGatunReader (without a region of interest or a value range),
 * the filter finds a vtkGatunFileHandle in the information of its input and draws from the file:
 * chunk by chunk from front to back, each decoded when it is needed. Chunks that are outside the
 * view, transparent or hidden are not read. The filter shares the open file and the memory budget
 * of the reader, and the reader is not asked for the mesh. Other inputs must be in memory as a
 * whole.
 *
 * Output: a vtkImageData of Size with the point arrays
 *
 *  - RGBA (float, 4 components, the active scalars): red, green and blue premultiplied by opacity,
 *    and opacity, 0 to 1;
 *  - Depth (float): distance where the ray meets the first visible value, in world units, from the
 * eye along the ray, or from the camera's plane in a parallel projection. It is infinite in empty
 * pixels and in the blend modes maximum intensity and X-ray.
 *
 * Point (0, 0) is at the lower left.
 *
 * Values are interpolated linearly in each tetrahedron. The emission-absorption integral along the
 * ray is exact: the transfer function is approximated by few parabolas, each of which is integrated
 * in closed form. The mean error is below 0.05/255 and the largest below 1.5/255, steps of the
 * transfer function included. The image does not depend on the
 * order of the cells, on chunks or on the number of threads, except for rounding (below 1/255). The
 * order of overlapping tetrahedra is undefined.
 *
 * *Cost.* Memory: about 75 bytes for each covered pixel and 20 MB for each thread, in addition to
 * MemoryBudget or, for a file, to the budget of the reader. Time: in proportion to the visible
 * tetrahedra and to the tetrahedra that each ray crosses. All threads are used.
 *
 * *Errors.* A mesh, array, parameter or file that cannot be drawn is reported by vtkErrorMacro and
 * GetErrorCode (see vtkGatunReader). The output is then empty.
 *
 * @par Background
 * C. Yang, T. Mitra, T. Chiueh: On-the-fly rendering of losslessly compressed irregular volume
 * data. IEEE Visualization 2000. P. Bunyk, A. Kaufman, C. Silva: Simple, fast and robust ray
 * casting of irregular grids. Dagstuhl 1997.
 *
 * @sa vtkGatunDetailPolicy vtkGatunReader vtkGatunFileHandle vtkUnstructuredGridVolumeRayCastMapper
 */

#ifndef vtkGatunRayCaster_h
#define vtkGatunRayCaster_h

#include "vtkGatunRenderingModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkCamera;
class vtkGatunDetailPolicy;
class vtkMatrix4x4;
class vtkPlaneCollection;
class vtkTable;
class vtkVolumeProperty;

class VTKGATUNRENDERING_EXPORT vtkGatunRayCaster : public vtkImageAlgorithm
{
public:
  static vtkGatunRayCaster* New();
  vtkTypeMacro(vtkGatunRayCaster, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How the values along a ray are blended. The numbers are those of vtkVolumeMapper where it has
   * the mode, and beyond its range where it does not.
   */
  enum BlendModes
  {
    COMPOSITE_BLEND = 0,         ///< color and opacity, integrated front to back
    MAXIMUM_INTENSITY_BLEND = 1, ///< color and opacity of the largest value
    XRAY_BLEND = 101             ///< integral of the absorption along the ray; colors are averaged
  };

  ///@{
  /**
   * Blend mode, one of BlendModes. Any other value is reported as an error and changes nothing.
   * Default: COMPOSITE_BLEND.
   */
  void SetBlendMode(int mode);
  vtkGetMacro(BlendMode, int);
  void SetBlendModeToComposite() { this->SetBlendMode(COMPOSITE_BLEND); }
  void SetBlendModeToMaximumIntensity() { this->SetBlendMode(MAXIMUM_INTENSITY_BLEND); }
  void SetBlendModeToXRay() { this->SetBlendMode(XRAY_BLEND); }
  ///@}

  ///@{
  /**
   * The camera. Its clipping range is not used. Default: none, which is an error.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /**
   * Colors and opacities. The caster uses the color function (of one or three channels), the scalar
   * opacity and its unit distance, and Shade with its coefficients (see vtkGatunVolumeMapper), with
   * a light at the camera. Default: none, which is an error.
   */
  void SetProperty(vtkVolumeProperty* property);
  vtkVolumeProperty* GetProperty();
  ///@}

  ///@{
  /**
   * Affine transformation of the mesh into world coordinates. Default: none, the identity.
   */
  void SetVolumeMatrix(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetVolumeMatrix();
  ///@}

  ///@{
  /**
   * Clipping planes in world coordinates. The positive side of all planes is drawn. Default: none.
   */
  void SetClippingPlanes(vtkPlaneCollection* planes);
  vtkPlaneCollection* GetClippingPlanes();
  ///@}

  ///@{
  /**
   * Width and height of the image in pixels, 1 to 32000 each. Default: 512, 512.
   */
  void SetSize(int width, int height);
  void SetSize(const int size[2]) { this->SetSize(size[0], size[1]); }
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /**
   * Name of the array to draw. Without a name, the active scalars of the points are drawn, or those
   * of the cells if there are none. Default: none.
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
   * Component of the array to draw, from 0. -1 is the length of the tuple, or the value of an array
   * of one component. Default: -1.
   */
  vtkSetClampMacro(ArrayComponent, int, -1, VTK_INT_MAX);
  vtkGetMacro(ArrayComponent, int);
  ///@}

  ///@{
  /**
   * Transparency at which a ray ends, from 0 (never) to 1. Default: 0.001.
   */
  vtkSetClampMacro(OpacityLimit, double, 0.0, 1.0);
  vtkGetMacro(OpacityLimit, double);
  ///@}

  ///@{
  /**
   * Memory for the parts of a mesh in memory that are kept for the next image, in MiB, 0 or more.
   * What does not fit is converted again for each image. For a file, the budget is that of the
   * reader. Default: 512.
   */
  vtkSetClampMacro(MemoryBudget, int, 0, VTK_INT_MAX);
  vtkGetMacro(MemoryBudget, int);
  ///@}

  ///@{
  /**
   * How far the mesh is simplified. For a mesh in memory, the order of edge collapses is computed
   * first (see vtkGatunSimplify) and kept for the next image. With JustInTime, the number of points
   * follows from the times of the images before. Null sets a new policy, which draws the whole
   * mesh.
   */
  void SetDetailPolicy(vtkGatunDetailPolicy* policy);
  vtkGatunDetailPolicy* GetDetailPolicy();
  ///@}

  /**
   * Statistics of the last image, in the columns of a table of one row; zeros before the first
   * image. Seconds are summed over all threads:
   *
   *  - FetchSeconds: conversion or decoding of chunks
   *  - SimplifySeconds: of these, merging points of a file; not summed over threads
   *  - OrderSeconds: projection and order of tetrahedra
   *  - SetUpSeconds: planes of faces
   *  - DrawSeconds: rays
   *  - FinishSeconds: compositing of fragments
   *  - DrawnChunks: chunks drawn
   *  - SkippedChunks: chunks outside the view, transparent or hidden
   *  - DrawnTetrahedra: tetrahedra in the chunks drawn
   *  - SeenTetrahedra: of these, those that may be on a ray
   *  - DrawnPoints: points of the simplified mesh; 0 if it is not simplified
   *  - MostWaitingTetrahedra: largest number of tetrahedra of a chunk that wait for others
   *  - MostFragments: largest number of ray fragments, in all pixels together
   *  - MostBytes: peak memory of image and chunks, without MemoryBudget
   *
   * The next call returns another table.
   */
  vtkTable* GetStatistics();

  /**
   * Includes the camera, the property, the matrix, the planes and the policy.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkGatunRayCaster();
  ~vtkGatunRayCaster() override;

  vtkExecutive* CreateDefaultExecutive() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int BlendMode = COMPOSITE_BLEND;
  int Size[2] = { 512, 512 };
  char* ArrayName = nullptr;
  int ArrayAssociation = -1;
  int ArrayComponent = -1;
  double OpacityLimit = 0.001;
  int MemoryBudget = 512;

private:
  vtkGatunRayCaster(const vtkGatunRayCaster&) = delete;
  void operator=(const vtkGatunRayCaster&) = delete;

  class vtkPipeline;
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
