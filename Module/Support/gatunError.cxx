// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunError.h"

#include "gatunPrintable.h"

#include <system_error>

namespace gatun
{
namespace
{
std::string MakeMessage(const ErrorDetails& details)
{
  std::string message = details.Path;
  if (!details.Part.empty())
  {
    message += ", " + details.Part;
  }
  if (!message.empty())
  {
    message += ": ";
  }
  message += details.What;
  if (details.Offset)
  {
    message += " at byte " + std::to_string(*details.Offset);
  }
  if (!details.Problem.empty())
  {
    message += " " + details.Problem;
  }
  if (details.SystemError != 0)
  {
    message += ": " + std::generic_category().message(details.SystemError);
  }
  return message;
}
}

//------------------------------------------------------------------------------
Error::Error(ErrorCode code, const std::string& message)
  : std::runtime_error(MakePrintable(message))
  , Code(code)
{
}

//------------------------------------------------------------------------------
Error::Error(ErrorCode code, const ErrorDetails& details)
  : std::runtime_error(MakePrintable(MakeMessage(details)))
  , Code(code)
  , SystemError(details.SystemError)
  , Path(details.Path)
  , Offset(details.Offset)
  , Length(details.Length)
{
}

//------------------------------------------------------------------------------
void ThrowCorrupt(const std::string& message)
{
  throw Error(ErrorCode::Corrupt, message);
}

//------------------------------------------------------------------------------
void ThrowInvalid(const std::string& message, const std::string& path)
{
  throw Error(ErrorCode::InvalidInput, { .Path = path, .What = message });
}
}
