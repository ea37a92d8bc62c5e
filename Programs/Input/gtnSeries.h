// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnSeries_h
#define gtnSeries_h

// Several files as the time steps of one pipeline.

#include "gtnFileList.h"
#include "gtnInputOptions.h"
#include "gtnPartList.h"

#include "vtkDataObjectAlgorithm.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace gtn
{
/** Files as steps, in the order of OrderFiles by the times in their field data (TimeValue). Throws
 * Failure. */
std::vector<SeriesStep> StepsOfFiles(
  const std::vector<std::string>& files, const InputOptions& options);

/** Reads the files of the time asked for, by readers for their formats, as a grid, or as a surface
 * if the first file is one and no step has several of them to be read together. If a piece is asked
 * for, it consists of some of these files. */
class SeriesReader : public vtkDataObjectAlgorithm
{
public:
  static SeriesReader* New();
  vtkTypeMacro(SeriesReader, vtkDataObjectAlgorithm);

  /** hasTime: whether the steps have times; if not, there is only one. */
  void SetSteps(
    const std::vector<SeriesStep>& steps, const InputOptions& options, bool hasTime = true);

  /** Whether the output is a surface. */
  bool IsSurface() const { return this->Surface; }

protected:
  SeriesReader();

  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  void Read(const std::vector<std::string>& files, const PartForm& form, vtkDataObject* output);

  bool Surface = false;
  std::vector<SeriesStep> Steps;
  InputOptions Options;
  std::vector<double> Times;
  std::map<std::size_t, PartForm> Forms; // of the files of each step, if they are its parts
};
}

#endif
