// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunGatherImages
 * @brief Puts the parts of an image together that several processes have.
 *
 * What ParaView sends from process to process begins at index 0, with an origin of its own: so it
 * is by their origins that parts are put where they belong. They must have one spacing and
 * direction. The output begins at index 0.
 */

#ifndef vtkGatunGatherImages_h
#define vtkGatunGatherImages_h

#include "vtkGatunParaViewModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKGATUNPARAVIEW_EXPORT vtkGatunGatherImages : public vtkImageAlgorithm
{
public:
  static vtkGatunGatherImages* New();
  vtkTypeMacro(vtkGatunGatherImages, vtkImageAlgorithm);

protected:
  vtkGatunGatherImages();
  ~vtkGatunGatherImages() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkGatunGatherImages(const vtkGatunGatherImages&) = delete;
  void operator=(const vtkGatunGatherImages&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
