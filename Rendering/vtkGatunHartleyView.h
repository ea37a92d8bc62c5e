// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunHartleyView
 * @brief Sets a vtkGatunHartleyProjection from a vtkCamera and a vtkVolumeProperty.
 *
 * vtkGatunHartleyProjection has plain view parameters and does not depend on VTK's rendering
 * modules. The static methods of this class copy the state of rendering objects to them. Call a
 * method again when its camera or property has changed.
 *
 * @sa vtkGatunHartleyProjection
 */

#ifndef vtkGatunHartleyView_h
#define vtkGatunHartleyView_h

#include "vtkGatunRenderingModule.h" // For export macro
#include "vtkObject.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkCamera;
class vtkGatunHartleyProjection;
class vtkVolumeProperty;

class VTKGATUNRENDERING_EXPORT vtkGatunHartleyView : public vtkObject
{
public:
  static vtkGatunHartleyView* New();
  vtkTypeMacro(vtkGatunHartleyView, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Sets ViewDirection, ViewUp, FocalPoint, ParallelScale and Zoom (to 1) so that the image is that
   * of the camera at the projection's Size. The clipping range is not used. If the camera is in
   * stereo, its current eye is used. Returns false, after an error message, if the camera's
   * projection is not parallel, or if the camera is sheared or scaled unevenly. The projection is
   * then unchanged.
   */
  static bool SetView(vtkGatunHartleyProjection* projection, vtkCamera* camera);

  /**
   * Sets ColorTransferFunction, ScalarOpacity and ScalarOpacityUnitDistance from a property. The
   * projection refers to the property's functions and follows their changes; a gray transfer
   * function is copied. Null restores the defaults.
   */
  static void SetProperty(vtkGatunHartleyProjection* projection, vtkVolumeProperty* property);

  /**
   * Moves a camera without turning it, so that its image shows all of the projection's volume, and
   * turns parallel projection on. Updates the information of the projection's input. Does not set
   * the projection: call SetView afterwards. Returns false, and leaves the camera unchanged, if
   * there is no volume.
   */
  static bool ResetCamera(vtkGatunHartleyProjection* projection, vtkCamera* camera);

protected:
  vtkGatunHartleyView() = default;
  ~vtkGatunHartleyView() override = default;

private:
  vtkGatunHartleyView(const vtkGatunHartleyView&) = delete;
  void operator=(const vtkGatunHartleyView&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
