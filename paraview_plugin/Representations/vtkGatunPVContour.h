// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkGatunPVContour
 * @brief Isosurfaces in ParaView, where a vtkPVPostFilter is between a reader and its filters.
 *
 * The filter finds the file handle of a reader behind ParaView's vtkPVPostFilter, too, and then
 * works directly from the file. It asks for its input like any other filter, so that the
 * information that ParaView shows of the reader is the same as without this filter.
 *
 * @sa vtkGatunContour vtkGatunFileHandle
 */

#ifndef vtkGatunPVContour_h
#define vtkGatunPVContour_h

#include "vtkGatunContour.h"
#include "vtkGatunParaViewModule.h" // For export macro

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKGATUNPARAVIEW_EXPORT vtkGatunPVContour : public vtkGatunContour
{
public:
  static vtkGatunPVContour* New();
  vtkTypeMacro(vtkGatunPVContour, vtkGatunContour);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkGatunPVContour();
  ~vtkGatunPVContour() override;

  vtkInformation* GetFileInformation(vtkInformation* inInfo) override;

private:
  vtkGatunPVContour(const vtkGatunPVContour&) = delete;
  void operator=(const vtkGatunPVContour&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
