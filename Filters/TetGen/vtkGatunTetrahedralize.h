// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunTetrahedralize
 * @brief Fills a closed surface (vtkPolyData) with tetrahedra (vtkUnstructuredGrid) by TetGen.
 *
 * @warning Not written yet: the output is empty and an error is reported.
 *
 * @warning TetGen is under the GNU Affero General Public License, and so is a program that ships
 * with this library.
 */

#ifndef vtkGatunTetrahedralize_h
#define vtkGatunTetrahedralize_h

#include "vtkGatunTetGenModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

class VTKGATUNTETGEN_EXPORT vtkGatunTetrahedralize : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkGatunTetrahedralize* New();
  vtkTypeMacro(vtkGatunTetrahedralize, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkGatunTetrahedralize();
  ~vtkGatunTetrahedralize() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkGatunTetrahedralize(const vtkGatunTetrahedralize&) = delete;
  void operator=(const vtkGatunTetrahedralize&) = delete;
};

#endif
