// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunHartleyRepresentation
 * @brief ParaView's "Gatun Hartley": regular volumes drawn from their Hartley coefficients.
 *
 * The image is that of vtkGatunHartleyMapper for the camera of the view, with the color map and the
 * opacities of the array that is selected for coloring. The coefficients are those of a
 * vtkGatunHartleyReader or vtkGatunHartleyEncoder that the input comes from directly. Any other
 * volume is encoded with default parameters.
 *
 * The projection of the view must be parallel. Several processes draw nothing, after an error
 * message.
 *
 * @sa vtkGatunHartleyMapper
 */

#ifndef vtkGatunHartleyRepresentation_h
#define vtkGatunHartleyRepresentation_h

#include "vtkGatunParaViewModule.h" // For export macro
#include "vtkNew.h"                 // For ivars
#include "vtkSmartPointer.h"        // For ivars
#include "vtkVolumeRepresentation.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkGatunHartleyMapper;
class vtkImageData;
class vtkPolyDataMapper;

class VTKGATUNPARAVIEW_EXPORT vtkGatunHartleyRepresentation : public vtkVolumeRepresentation
{
public:
  static vtkGatunHartleyRepresentation* New();
  vtkTypeMacro(vtkGatunHartleyRepresentation, vtkVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How the values along a ray determine color and opacity, see vtkGatunHartleyProjection: X-ray
   * (0), exponential (1) or by the transfer functions (2). Default: 2.
   */
  void SetOpacityModel(int model);
  int GetOpacityModel();
  ///@}

  ///@{
  /**
   * For the exponential model, see vtkGatunHartleyProjection. Default: 0.
   */
  void SetExtinction(double extinction);
  double GetExtinction();
  ///@}

  ///@{
  /**
   * For X-ray: the sums along a ray that are drawn black and white. If they are equal, the smallest
   * and the largest sum of the image. Default: 0, 0.
   */
  void SetWindow(double black, double white);
  double* GetWindow() VTK_SIZEHINT(2);
  ///@}

  ///@{
  /**
   * Memory for coefficients or spectra that are kept for the next image, in MiB. Default: 512.
   */
  void SetMemoryBudget(int mebibytes);
  int GetMemoryBudget();
  ///@}

  ///@{
  /**
   * Whether fewer rays are drawn while somebody interacts. Default: on.
   */
  void SetAutoAdjustSampleDistances(bool on);
  bool GetAutoAdjustSampleDistances();
  vtkBooleanMacro(AutoAdjustSampleDistances, bool);
  ///@}

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkGatunHartleyRepresentation();
  ~vtkGatunHartleyRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkGatunHartleyRepresentation(const vtkGatunHartleyRepresentation&) = delete;
  void operator=(const vtkGatunHartleyRepresentation&) = delete;

  void Deliver(vtkInformation* inInfo);
  void PrepareToDraw();

  class vtkProjection;
  vtkNew<vtkGatunHartleyMapper> VolumeMapper;
  vtkNew<vtkPolyDataMapper> OutlineMapper; // which vtkPVLODVolume wants to have
  vtkSmartPointer<vtkProjection> Projection;
  bool HasReportedParallel = false;
  vtkSmartPointer<vtkImageData> Volume; // its place, and its voxels if there are no coefficients
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
