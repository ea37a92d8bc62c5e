// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnScene_h
#define gtnScene_h

#include "vtkPolyDataAlgorithm.h"

namespace gtn
{
/** Makes one surface of all surfaces of a scene, which a composite data set has, as
 * vtkGatunMergeBlocks makes one grid of blocks. Warns that it does. */
class SceneMerger : public vtkPolyDataAlgorithm
{
public:
  static SceneMerger* New();
  vtkTypeMacro(SceneMerger, vtkPolyDataAlgorithm);

protected:
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
};
}

#endif
