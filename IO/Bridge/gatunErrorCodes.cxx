// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunErrorCodes.h"

#include "gatunError.h"

#include "vtkErrorCode.h"

#include <cerrno>
#include <new>

namespace
{

//------------------------------------------------------------------------------
unsigned long GetCode(const gatun::Error& error)
{
  switch (error.Code)
  {
    case gatun::ErrorCode::Ok:
      return vtkErrorCode::NoError;
    case gatun::ErrorCode::CannotOpen:
      return error.SystemError == ENOENT || error.SystemError == ENOTDIR
        ? vtkErrorCode::FileNotFoundError
        : vtkErrorCode::CannotOpenFileError;
    case gatun::ErrorCode::NotGatun:
      return vtkErrorCode::UnrecognizedFileTypeError;
    case gatun::ErrorCode::Truncated:
      return vtkErrorCode::PrematureEndOfFileError;
    case gatun::ErrorCode::Corrupt:
      return vtkErrorCode::FileFormatError;
    case gatun::ErrorCode::CannotWrite:
      return error.SystemError == ENOSPC || error.SystemError == EDQUOT
        ? vtkErrorCode::OutOfDiskSpaceError
        : vtkErrorCode::CannotOpenFileError;
    case gatun::ErrorCode::UnsupportedVersion:
    case gatun::ErrorCode::InvalidInput:
    case gatun::ErrorCode::Aborted:
    case gatun::ErrorCode::NotHere:
      break;
  }
  return vtkErrorCode::UserError + static_cast<unsigned long>(error.Code);
}

//------------------------------------------------------------------------------
gatun::VTKFailure Describe(const std::string& path)
{
  try
  {
    throw;
  }
  catch (const gatun::Error& error)
  {
    const std::string message = error.what();
    return { GetCode(error), error.Path.empty() ? path + ": " + message : message,
      error.Code == gatun::ErrorCode::Aborted };
  }
  catch (const std::bad_alloc&)
  {
    return { vtkErrorCode::UnknownError, path + ": not enough memory", false };
  }
  catch (const std::exception& error)
  {
    return { vtkErrorCode::UnknownError, path + ": " + error.what(), false };
  }
  catch (...)
  {
    return { vtkErrorCode::UnknownError, path + ": failed for an unknown reason", false };
  }
}

} // anonymous namespace

namespace gatun
{

//------------------------------------------------------------------------------
VTKFailure DescribeFailure(const char* path) noexcept
{
  try
  {
    return Describe(path);
  }
  catch (...)
  {
    // Short enough for the small string optimization, which does not allocate.
    return { vtkErrorCode::UnknownError, "out of memory", false };
  }
}

}
