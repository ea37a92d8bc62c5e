// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunErrorCodes_h
#define gatunErrorCodes_h

#include "vtkGatunIOModule.h" // For export macro

#include <exception>
#include <string>

namespace gatun
{
/** How a failure is told in VTK. */
struct VTKFailure
{
  unsigned long Code; ///< for vtkAlgorithm::SetErrorCode
  std::string Message;
  bool Aborted; ///< the user asked for it: no message is due
};

/**
 * To be called within a catch block: describes the exception that is being handled. The codes are
 * those of vtkErrorCode where it has one, else vtkErrorCode::UserError + gatun::ErrorCode.
 * path: the file concerned, which begins the message. Whatever was thrown, and however little
 * memory there is, nothing is thrown from here; without any memory the message is short.
 */
VTKGATUNIO_EXPORT VTKFailure DescribeFailure(const char* path) noexcept;
}

#endif
