// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnImageFile.h"

#include "gtnFailure.h"
#include "gtnLibrary.h"
#include "gtnOutput.h"
#include "gtnPng.h"
#include "gtnText.h"

namespace gtn
{
namespace
{

const ImageCodec& CodecOf(const std::string& file)
{
  if (ExtensionOf(file) == ".png")
  {
    return PngCodec;
  }
  static const void* const codec = LoadLibrary("gtnImages", ImageCodecName, "read or write images");
  return *static_cast<const ImageCodec*>(codec);
}

// The reason may have the name that was given to the codec.
[[noreturn]] void Fail(
  const std::string& file, const std::string& given, std::string reason, const char* otherwise)
{
  if (const auto place = reason.find(given); place != reason.npos)
  {
    reason.replace(place, given.size(), file);
  }
  throw Failure(file, reason.empty() ? otherwise : Printable(reason));
}

} // anonymous namespace

//------------------------------------------------------------------------------
void WriteImageFile(const Image& image, const std::string& file)
{
  const ImageCodec& codec = CodecOf(file);
  TemporaryFile temporary(file);
  std::string reason;
  if (!codec.Write(image, temporary.GetName(), reason))
  {
    Fail(file, temporary.GetName(), reason, "cannot be written");
  }
  temporary.Commit();
}

//------------------------------------------------------------------------------
void ReadImageFile(const std::string& file, const ImageFunction& take)
{
  std::string reason;
  if (!CodecOf(file).Read(file, take, reason))
  {
    Fail(file, file, reason, "cannot be read");
  }
}
}
