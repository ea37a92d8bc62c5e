// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunPVContour
 * @brief Isosurfaces in ParaView, where something is between a reader and its filters.
 *
 * As vtkGatunContour, but it knows a reader of .gtn files behind ParaView's reader of series, too,
 * and makes the surface straight from the file. Its input is asked for as any other: what the
 * reader tells of itself is then what it would be without this filter.
 *
 * @sa vtkGatunContour vtkGatunReader
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

  vtkAlgorithm* FindProducer() override;

private:
  vtkGatunPVContour(const vtkGatunPVContour&) = delete;
  void operator=(const vtkGatunPVContour&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
