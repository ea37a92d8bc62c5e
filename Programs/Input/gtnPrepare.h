// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnPrepare_h
#define gtnPrepare_h

// What happens to every mesh before it is packed or compared.

#include "gtnInputOptions.h"

#include "vtkUnstructuredGridAlgorithm.h"

namespace gtn
{
/**
 * Makes a grid of tetrahedra of any data object: blocks are merged, structured grids and other
 * cells are split, arrays that are not wanted are left out. Says so by warnings. Time passes.
 */
class Preparer : public vtkUnstructuredGridAlgorithm
{
public:
  static Preparer* New();
  vtkTypeMacro(Preparer, vtkUnstructuredGridAlgorithm);

  void SetOptions(const InputOptions& options);

protected:
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  InputOptions Options;
};
}

#endif
