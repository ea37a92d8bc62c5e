// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnSeries_h
#define gtnSeries_h

// Several files as the time steps of one pipeline.

#include "gtnFileList.h"
#include "gtnInputOptions.h"

#include "vtkUnstructuredGridAlgorithm.h"

#include <string>
#include <vector>

namespace gtn
{
/** Files as steps: at the times in their field data (TimeValue) if these ascend, or else 0, 1, 2
 * and so on. Throws Failure. */
std::vector<SeriesStep> StepsOfFiles(const std::vector<std::string>& files);

/** Reads the file of the time asked for, by a reader for its format. */
class SeriesReader : public vtkUnstructuredGridAlgorithm
{
public:
  static SeriesReader* New();
  vtkTypeMacro(SeriesReader, vtkUnstructuredGridAlgorithm);

  void SetSteps(const std::vector<SeriesStep>& steps, const InputOptions& options);

protected:
  SeriesReader();

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  std::vector<SeriesStep> Steps;
  InputOptions Options;
};
}

#endif
