// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnPrepare_h
#define gtnPrepare_h

// What happens to every mesh before it is packed or compared.

#include "gtnInputOptions.h"

#include "vtkDataObjectAlgorithm.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkDataSet;
class vtkUnstructuredGrid;

namespace gtn
{
/**
 * Makes an unstructured grid of any data object, but a surface (vtkPolyData) of a surface: blocks
 * are merged, cells are split and arrays left out if the options say so. Warns of changes. Time
 * passes.
 */
class Preparer : public vtkDataObjectAlgorithm
{
public:
  static Preparer* New();
  vtkTypeMacro(Preparer, vtkDataObjectAlgorithm);

  void SetOptions(const InputOptions& options);

  /** Prepares a data object into a grid or a surface. Throws Failure if that is not possible, which
   * has been reported as an error before, or if the result is of the other kind. */
  static void Prepare(vtkDataObject* input, const InputOptions& options, vtkDataObject* output);

protected:
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  void Lose(const std::string& what);
  void LoseTables(vtkDataSet* data);
  void NameArrays(vtkUnstructuredGrid* grid);
  void MakeOutput(vtkDataObject* input, vtkDataObject* output);
  vtkSmartPointer<vtkUnstructuredGrid> Convert(vtkUnstructuredGrid* grid, bool isSurface);

  InputOptions Options;
};
}

#endif
