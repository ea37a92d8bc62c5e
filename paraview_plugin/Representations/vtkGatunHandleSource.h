// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkGatunHandleSource
 * @brief A source whose output stands for a file that is already open.
 *
 * The output is a copy of a data set, such as an outline, and its information has the
 * vtkGatunFileHandle of a file, as that of the vtkGatunReader that opened it has. Consumers such as
 * vtkGatunVolumeMapper then use the file, also after the reader has changed to another one.
 *
 * @sa vtkGatunFileHandle vtkGatunVolumeRepresentation
 */

#ifndef vtkGatunHandleSource_h
#define vtkGatunHandleSource_h

#include "vtkDataSetAlgorithm.h"
#include "vtkGatunParaViewModule.h" // For export macro
#include "vtkSmartPointer.h"        // For ivars

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkGatunFileHandle;

class VTKGATUNPARAVIEW_EXPORT vtkGatunHandleSource : public vtkDataSetAlgorithm
{
public:
  static vtkGatunHandleSource* New();
  vtkTypeMacro(vtkGatunHandleSource, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The file, and the data set that the output is a copy of. Default: none of either.
   */
  void SetFile(vtkGatunFileHandle* handle, vtkDataSet* grid);

protected:
  vtkGatunHandleSource();
  ~vtkGatunHandleSource() override;

  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkGatunHandleSource(const vtkGatunHandleSource&) = delete;
  void operator=(const vtkGatunHandleSource&) = delete;

  vtkSmartPointer<vtkGatunFileHandle> Handle;
  vtkSmartPointer<vtkDataSet> Grid;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
