// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunReader
 * @brief Reads a compressed tetrahedral mesh (`.gtn`).
 *
 * @warning Not written yet: the output is empty and an error is reported.
 *
 * @sa vtkGatunWriter
 */

#ifndef vtkGatunReader_h
#define vtkGatunReader_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

class VTKGATUNIO_EXPORT vtkGatunReader : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkGatunReader* New();
  vtkTypeMacro(vtkGatunReader, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the file to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkGatunReader();
  ~vtkGatunReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* FileName = nullptr;

private:
  vtkGatunReader(const vtkGatunReader&) = delete;
  void operator=(const vtkGatunReader&) = delete;
};

#endif
