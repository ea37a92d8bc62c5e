// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunErrorCode
 * @brief Error codes of Gatun's classes in addition to those of vtkErrorCode.
 *
 * GetErrorCode of Gatun's readers, writers, filters and mappers returns one of these codes or one
 * of vtkErrorCode. Codes never change their meaning.
 *
 * @sa vtkErrorCode
 */

#ifndef vtkGatunErrorCode_h
#define vtkGatunErrorCode_h

#include "vtkErrorCode.h"
#include "vtkGatunIOModule.h" // For export macro

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKGATUNIO_EXPORT vtkGatunErrorCode
{
public:
  enum ErrorIds
  {
    /** The file, or a part of it, has another version of the format. */
    UnsupportedVersionError = vtkErrorCode::UserError + 3,
    /** The input data or the value of a property cannot be used. The message names it. */
    InvalidInputError = vtkErrorCode::UserError + 7,
    /** AbortExecute was set. There is no message. */
    AbortedError = vtkErrorCode::UserError + 8
  };

  /**
   * Name of a code of this class or of vtkErrorCode, such as "UnsupportedVersionError".
   */
  static const char* GetStringFromErrorCode(unsigned long error);
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
