// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnSpoolSource_h
#define gtnSpoolSource_h

// A mesh on the disk as the source of a pipeline, piece by piece.

#include "gtnInputOptions.h"
#include "gtnSpooledMesh.h"

#include "vtkUnstructuredGridAlgorithm.h"

#include <memory>

namespace gtn
{
/** Makes the pieces of a SpooledMesh, prepared as the options say. It has to be asked for as many
 * pieces as there are. */
class SpoolSource : public vtkUnstructuredGridAlgorithm
{
public:
  static SpoolSource* New();
  vtkTypeMacro(SpoolSource, vtkUnstructuredGridAlgorithm);

  void SetMesh(std::shared_ptr<const SpooledMesh> mesh, const InputOptions& options);

protected:
  SpoolSource();

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  std::shared_ptr<const SpooledMesh> Mesh;
  InputOptions Options;
};
}

#endif
