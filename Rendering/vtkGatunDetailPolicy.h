// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunDetailPolicy
 * @brief How far meshes are simplified for images.
 *
 * vtkGatunVolumeMapper, vtkGatunSurfaceMapper and vtkGatunRayCaster own one policy each. Several of
 * them may share one: see their methods SetDetailPolicy. A new policy draws whole meshes.
 *
 * Surfaces and meshes that are drawn from files need a file with a hierarchy
 * (vtkGatunWriter::Hierarchy) to be simplified. Surfaces in memory are never simplified.
 *
 * Values beyond a range are set to its nearest limit. A value that is not a number is reported as
 * an error by the next image.
 *
 * @sa vtkGatunVolumeMapper vtkGatunSurfaceMapper vtkGatunRayCaster
 */

#ifndef vtkGatunDetailPolicy_h
#define vtkGatunDetailPolicy_h

#include "vtkGatunRenderingModule.h" // For export macro
#include "vtkObject.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKGATUNRENDERING_EXPORT vtkGatunDetailPolicy : public vtkObject
{
public:
  static vtkGatunDetailPolicy* New();
  vtkTypeMacro(vtkGatunDetailPolicy, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether meshes are simplified so that an image takes the time of TimeBudget: images during an
   * interaction of the mappers, and all images of vtkGatunRayCaster. Default: off.
   */
  vtkSetMacro(JustInTime, bool);
  vtkGetMacro(JustInTime, bool);
  vtkBooleanMacro(JustInTime, bool);
  ///@}

  ///@{
  /**
   * Time for an image if JustInTime is on, in seconds, 0 to 1e6. 0 is the time that VTK allocates
   * to the volume or actor (see vtkRenderWindow::SetDesiredUpdateRate), and no limit for
   * vtkGatunRayCaster, whose time does not include decoding and simplification. Default: 0.
   */
  vtkSetClampMacro(TimeBudget, double, 0.0, 1e6);
  vtkGetMacro(TimeBudget, double);
  ///@}

  ///@{
  /**
   * Whether a mesh that is simplified for a time is finer where the view needs it: near the eye,
   * where values of a volume are visible, and at the silhouette of a surface. Off: it is as coarse
   * everywhere. Default: on.
   */
  vtkSetMacro(ViewDependent, bool);
  vtkGetMacro(ViewDependent, bool);
  vtkBooleanMacro(ViewDependent, bool);
  ///@}

  ///@{
  /**
   * Largest error of all images in pixels, 0 to 1e6: the error of the shape and the values (see
   * vtkGatunSimplify), relative to the size of the mesh and the range of the values, times the size
   * of the mesh in pixels if it were as far away as the place in question. The error of a surface
   * is that of its shape. It counts less where the surface faces the eye, and not at all out of the
   * view or where it is turned away and hidden. Points are merged as far as the error allows. 0:
   * none. With JustInTime, it may be larger during an interaction. Default: 0.
   */
  vtkSetClampMacro(PixelError, double, 0.0, 1e6);
  vtkGetMacro(PixelError, double);
  ///@}

  ///@{
  /**
   * Fraction of points removed in all images, from 0 (none) to 1 (as many as possible). Default: 0.
   */
  vtkSetClampMacro(SimplificationRatio, double, 0.0, 1.0);
  vtkGetMacro(SimplificationRatio, double);
  ///@}

  /**
   * Takes all properties of another policy.
   */
  void DeepCopy(vtkGatunDetailPolicy* other);

protected:
  vtkGatunDetailPolicy() = default;
  ~vtkGatunDetailPolicy() override = default;

  bool JustInTime = false;
  double TimeBudget = 0;
  bool ViewDependent = true;
  double PixelError = 0;
  double SimplificationRatio = 0;

private:
  vtkGatunDetailPolicy(const vtkGatunDetailPolicy&) = delete;
  void operator=(const vtkGatunDetailPolicy&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
