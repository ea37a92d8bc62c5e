// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnPrepare_h
#define gtnPrepare_h

// What happens to every mesh before it is packed or compared.

#include "gtnInputOptions.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGridAlgorithm.h"

namespace gtn
{
/**
 * Makes an unstructured grid of any data object: blocks are merged, cells are split and arrays left
 * out if the options say so. Warns of changes. Time passes.
 */
class Preparer : public vtkUnstructuredGridAlgorithm
{
public:
  static Preparer* New();
  vtkTypeMacro(Preparer, vtkUnstructuredGridAlgorithm);

  void SetOptions(const InputOptions& options);

  /** Prepares a data object into a grid. Throws Failure if that is not possible, which has been
   * reported as an error before. */
  static void Prepare(
    vtkDataObject* input, const InputOptions& options, vtkUnstructuredGrid* output);

protected:
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSmartPointer<vtkUnstructuredGrid> Convert(vtkUnstructuredGrid* grid);

  InputOptions Options;
};
}

#endif
