// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunFileDescription
 * @brief What is in a `.gtn` or `.ghv` file, as text for programs.
 *
 * The text is a JSON object, the same as that of `gtn info --json` or `gtn volume info --json`: of
 * a mesh, among others, the members points, cells, tets, bounds, times, arrays and sizes; of a
 * volume size, range and bitsPerVoxel. Only the directory of the file is read.
 *
 * A file that cannot be read is an error: a message, an error code, and no text.
 *
 * @sa vtkGatunReader vtkGatunHartleyReader
 */

#ifndef vtkGatunFileDescription_h
#define vtkGatunFileDescription_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkObject.h"

#include <string> // For std::string

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKGATUNIO_EXPORT vtkGatunFileDescription : public vtkObject
{
public:
  static vtkGatunFileDescription* New();
  vtkTypeMacro(vtkGatunFileDescription, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the file. Its contents tell what it is. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Reads the file and returns its description; empty if it cannot be read.
   */
  std::string ReadJSON();

  /**
   * Error code of the last call of ReadJSON, one of vtkErrorCode or vtkGatunErrorCode.
   */
  vtkGetMacro(ErrorCode, unsigned long);

protected:
  vtkGatunFileDescription();
  ~vtkGatunFileDescription() override;

private:
  vtkGatunFileDescription(const vtkGatunFileDescription&) = delete;
  void operator=(const vtkGatunFileDescription&) = delete;

  char* FileName = nullptr;
  unsigned long ErrorCode = 0;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
