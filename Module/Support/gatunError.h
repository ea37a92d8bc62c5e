// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunError_h
#define gatunError_h

#include "gatunExport.h" // For export macro

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

namespace gatun
{
/**
 * The reason why an operation failed. The values are part of the interface and never change.
 */
enum class ErrorCode
{
  Ok = 0,
  CannotOpen = 1,         ///< missing, a directory, no permission
  NotGatun = 2,           ///< the file does not begin with the signature of its format
  UnsupportedVersion = 3, ///< the file or a part of it has another version of the format
  Truncated = 4,          ///< the file ends before the data that its tables refer to
  Corrupt = 5,            ///< wrong checksum, or content that the format does not allow
  CannotWrite = 6,        ///< no permission, disk full, missing folder
  InvalidInput = 7,       ///< the caller passed an unusable mesh or parameter
  Aborted = 8,            ///< the caller asked to stop
  NotHere = 9             ///< bytes that the source of a file does not have yet (ByteSource)
};

/**
 * The parts of an error message. The message is
 * "Path, Part: What at byte Offset Problem: text of SystemError"; empty parts are left out.
 */
struct ErrorDetails
{
  std::string Path = {};                    ///< the file
  std::string Part = {};                    ///< a file embedded in it, such as a base mesh
  std::string What = {};                    ///< the failed operation, or the faulty item
  std::optional<std::uint64_t> Offset = {}; ///< position in the file, in bytes
  std::string Problem = {};                 ///< predicate of What, such as "is damaged"
  int SystemError = 0;                      ///< value of errno, or 0
  std::uint64_t Length = 0;                 ///< of the bytes that are not here; not in the message
};

/**
 * The only exception class that the core throws. The VTK classes catch it at their border.
 *
 * Programs distinguish errors by the fields. The text of the message is meant for people: see
 * MakePrintable.
 */
class Error : public std::runtime_error
{
public:
  /** An error that does not concern a particular file. */
  GATUN_EXPORT Error(ErrorCode code, const std::string& message);

  /** Composes the message from its parts. */
  GATUN_EXPORT Error(ErrorCode code, const ErrorDetails& details);

  ErrorCode Code;

  /** Value of errno if a system call failed, otherwise 0. */
  int SystemError = 0;

  /** Path of the file concerned. Empty if the thrower did not know it; in that case the message
   * does not name a file either. */
  std::string Path;

  /** Position in the file, in bytes. */
  std::optional<std::uint64_t> Offset;

  /** The number of bytes from there that are not here yet: for NotHere. */
  std::uint64_t Length = 0;
};

/** Throws Error(Corrupt) for content that no well-formed file has. Hot loops keep it out of line.
 */
[[noreturn]] GATUN_EXPORT void ThrowCorrupt(const std::string& message);

/** Throws Error(InvalidInput) for input that cannot be used. path: the file concerned, if any. */
[[noreturn]] GATUN_EXPORT void ThrowInvalid(
  const std::string& message, const std::string& path = {});
}

#endif
