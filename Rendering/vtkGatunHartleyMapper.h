// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunHartleyMapper
 * @brief Draws regular volumes from their Hartley coefficients in a window.
 *
 * The input is a vtkImageData of vtkGatunHartleyReader or vtkGatunHartleyEncoder, whose
 * coefficients are projected; voxels are not needed. Any other volume is encoded with default
 * parameters. The image is that of vtkGatunHartleyProjection for the camera of the renderer, with
 * the transfer functions of the property of the volume.
 *
 * The image is blended over the window at the depth of the center of the volume: opaque geometry in
 * front of the center hides it, other geometry is behind it. The matrix of the volume may turn,
 * move and scale it evenly.
 *
 * During an interaction, when VTK allocates less than 10 seconds to an image, fewer rays are drawn,
 * so that the image takes that time.
 *
 * @warning Coefficients can be projected along parallel rays only. With a perspective projection,
 * nothing is drawn, after an error message. Call vtkCamera::ParallelProjectionOn.
 *
 * @sa vtkGatunHartleyProjection
 */

#ifndef vtkGatunHartleyMapper_h
#define vtkGatunHartleyMapper_h

#include "vtkGatunRenderingModule.h" // For export macro
#include "vtkGatunUpdateResult.h"
#include "vtkSmartPointer.h" // For ivars
#include "vtkVolumeMapper.h"

#include <memory> // For std::unique_ptr

namespace gatun
{
class RayImage;
}

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkGatunHartleyProjection;

class VTKGATUNRENDERING_EXPORT vtkGatunHartleyMapper : public vtkVolumeMapper
{
public:
  static vtkGatunHartleyMapper* New();
  vtkTypeMacro(vtkGatunHartleyMapper, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The projection, for its options: OpacityModel, Extinction, Method, MemoryBudget and others. The
   * mapper sets camera, size, property and input. Another one may be set, of a subclass
   * that finds the coefficients elsewhere. Not null.
   */
  void SetProjection(vtkGatunHartleyProjection* projection);
  vtkGatunHartleyProjection* GetProjection();
  ///@}

  ///@{
  /**
   * Whether fewer rays are drawn during an interaction. Default: on.
   */
  vtkSetMacro(AutoAdjustSampleDistances, bool);
  vtkGetMacro(AutoAdjustSampleDistances, bool);
  vtkBooleanMacro(AutoAdjustSampleDistances, bool);
  ///@}

  /**
   * Distance of the rays of the last image, in pixels, from 1 to 8.
   */
  vtkGetMacro(ImageSampleDistance, double);

  ///@{
  /**
   * Bounds of the whole volume. Updates the information of the input.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  ///@}

  ///@{
  /**
   * Updates the information of an input with coefficients, and all of any other input. Ports and
   * requests are ignored.
   */
  VTK_GATUN_UPDATE_RESULT Update() override;
  VTK_GATUN_UPDATE_RESULT Update(int port) override;
  vtkTypeBool Update(int port, vtkInformationVector* requests) override;
  vtkTypeBool Update(vtkInformation* requests) override;
  ///@}

  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGatunHartleyMapper();
  ~vtkGatunHartleyMapper() override;

private:
  vtkGatunHartleyMapper(const vtkGatunHartleyMapper&) = delete;
  void operator=(const vtkGatunHartleyMapper&) = delete;

  bool HasCoefficients();
  bool SetCamera(vtkRenderer* renderer, vtkVolume* volume, int rows, bool toBorders);
  double ChooseDistance(vtkVolume* volume, double pixels) const;

  vtkSmartPointer<vtkGatunHartleyProjection> Projection;
  std::unique_ptr<gatun::RayImage> Image;
  bool AutoAdjustSampleDistances = true;
  double ImageSampleDistance = 1;
  double SecondsPerPixel = 0; // of the last image; 0 if it is not known
  bool HasReportedPerspective = false;

  // What the camera of the projection was made of, so that the same view is not drawn again.
  vtkMTimeType CameraTime = 0;
  vtkMTimeType MatrixTime = 0;
  int BorderRows = 0; // 0: not to the borders
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
