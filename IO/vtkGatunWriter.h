// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunWriter
 * @brief Writes a tetrahedral vtkUnstructuredGrid as a compressed mesh (`.gtn`).
 *
 * @warning Not written yet: no file is made and an error is reported.
 *
 * @sa vtkGatunReader
 */

#ifndef vtkGatunWriter_h
#define vtkGatunWriter_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkWriter.h"

class VTKGATUNIO_EXPORT vtkGatunWriter : public vtkWriter
{
public:
  static vtkGatunWriter* New();
  vtkTypeMacro(vtkGatunWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the file to write. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkGatunWriter();
  ~vtkGatunWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  char* FileName = nullptr;

private:
  vtkGatunWriter(const vtkGatunWriter&) = delete;
  void operator=(const vtkGatunWriter&) = delete;
};

#endif
