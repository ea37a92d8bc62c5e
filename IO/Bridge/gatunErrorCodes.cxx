// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunErrorCodes.h"

#include "gatunError.h"

#include "vtkErrorCode.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <new>
#include <system_error>

namespace
{

//------------------------------------------------------------------------------
unsigned long CodeOf(const gatun::Error& error, const std::string& path)
{
  const std::string message = error.what();
  const auto tells = [&message](int number)
  { return message.find(std::strerror(number)) != std::string::npos; };
  switch (error.Code)
  {
    case gatun::ErrorCode::Ok:
      return vtkErrorCode::NoError;
    case gatun::ErrorCode::CannotOpen:
    {
      std::error_code ignored;
      return std::filesystem::exists(path, ignored) || ignored ? vtkErrorCode::CannotOpenFileError
                                                               : vtkErrorCode::FileNotFoundError;
    }
    case gatun::ErrorCode::NotGatun:
      return vtkErrorCode::UnrecognizedFileTypeError;
    case gatun::ErrorCode::Truncated:
      return vtkErrorCode::PrematureEndOfFileError;
    case gatun::ErrorCode::Corrupt:
      return vtkErrorCode::FileFormatError;
    case gatun::ErrorCode::CannotWrite:
      return tells(ENOSPC) || tells(EDQUOT) ? vtkErrorCode::OutOfDiskSpaceError
                                            : vtkErrorCode::CannotOpenFileError;
    case gatun::ErrorCode::UnsupportedVersion:
    case gatun::ErrorCode::InvalidInput:
    case gatun::ErrorCode::Aborted:
      break;
  }
  return vtkErrorCode::UserError + static_cast<unsigned long>(error.Code);
}

//------------------------------------------------------------------------------
gatun::VTKFailure Describe(const std::string& path)
{
  const auto named = [&path](const std::string& what)
  { return what.compare(0, path.size(), path) == 0 ? what : path + ": " + what; };
  try
  {
    throw;
  }
  catch (const gatun::Error& error)
  {
    return { CodeOf(error, path), named(error.what()), error.Code == gatun::ErrorCode::Aborted };
  }
  catch (const std::bad_alloc&)
  {
    return { vtkErrorCode::UnknownError, path + ": not enough memory", false };
  }
  catch (const std::exception& error)
  {
    return { vtkErrorCode::UnknownError, named(error.what()), false };
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
    // Short enough for a string that allocates nothing.
    return { vtkErrorCode::UnknownError, "out of memory", false };
  }
}

}
