// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunError_h
#define gatunError_h

#include <stdexcept>
#include <string>

namespace gatun
{
/**
 * Why an operation failed. The values are part of the interface and never change.
 */
enum class ErrorCode
{
  Ok = 0,
  CannotOpen = 1,         ///< missing, a directory, no permission
  NotGatun = 2,           ///< the file does not begin as a .gtn file does
  UnsupportedVersion = 3, ///< written by a newer major version of the format
  Truncated = 4,          ///< the file ends before what it promises
  Corrupt = 5,            ///< a checksum or the content is wrong
  CannotWrite = 6,        ///< no permission, disk full, the folder is missing
  InvalidInput = 7,       ///< the mesh or a parameter given by the caller is unusable
  Aborted = 8             ///< the caller asked to stop
};

/**
 * The one exception that gatun's core throws. The VTK classes catch it at their border.
 */
class Error : public std::runtime_error
{
public:
  Error(ErrorCode code, const std::string& message)
    : std::runtime_error(message)
    , Code(code)
  {
  }

  ErrorCode Code;
};

/** Reports content that a well-formed file cannot have; kept out of line in hot loops. */
[[noreturn]] inline void ThrowCorrupt(const std::string& what)
{
  throw Error(ErrorCode::Corrupt, what);
}

/** Reports what the caller gave that cannot be used. */
[[noreturn]] inline void ThrowInvalid(const std::string& what)
{
  throw Error(ErrorCode::InvalidInput, what);
}
}

#endif
