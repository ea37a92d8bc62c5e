// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunErrorCodes_h
#define gatunErrorCodes_h

#include "vtkGatunIOModule.h" // For export macro

#include <exception>
#include <string>

namespace gatun
{
/** An exception in terms of VTK. */
struct VTKFailure
{
  unsigned long Code; ///< for vtkAlgorithm::SetErrorCode
  std::string Message;
  bool Aborted; ///< whether the user asked for it, so that no message is needed
};

/**
 * Describes the current exception. To be called in a catch block. The codes are those of
 * vtkErrorCode where it has one, otherwise vtkErrorCode::UserError + gatun::ErrorCode. path: the
 * file concerned, which begins the message unless the exception names a file. Never throws; if
 * there is no memory, the message is short.
 */
VTKGATUNIO_EXPORT VTKFailure DescribeFailure(const char* path) noexcept;
}

#endif
