// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnImageFile.h"

#include "gtnFailure.h"
#include "gtnLibrary.h"
#include "gtnOutput.h"
#include "gtnPng.h"
#include "gtnText.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

#include <cstring>

namespace gtn
{
namespace
{

/** Writes a .png file. Throws Failure. */
void WritePNG(const Image& image, const std::string& file)
{
  vtkNew<vtkImageData> pixels;
  pixels->SetDimensions(image.Width, image.Height, 1);
  pixels->AllocateScalars(
    image.Type == gatun::ScalarType::UInt16 ? VTK_UNSIGNED_SHORT : VTK_UNSIGNED_CHAR,
    static_cast<int>(image.Channels.size()));
  // VTK's rows go up.
  const std::size_t row =
    gatun::SizeOf(image.Type) * image.Channels.size() * static_cast<std::size_t>(image.Width);
  const auto* from = static_cast<const unsigned char*>(image.Values);
  for (int y = image.Height; y-- > 0; from += row)
  {
    std::memcpy(pixels->GetScalarPointer(0, y, 0), from, row);
  }
  // Into memory: with a full disk, libpng would write messages of its own.
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(pixels);
  writer->WriteToMemoryOn();
  for (const auto& [key, text] : image.Remarks)
  {
    writer->AddText(key.c_str(), text.c_str());
  }
  writer->Write();
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  CheckWritten(writer, bytes && bytes->GetNumberOfValues() > 0, file);
  WriteBytes(file,
    { reinterpret_cast<const char*>(bytes->GetPointer(0)),
      static_cast<std::size_t>(bytes->GetNumberOfValues()) });
}

const ImageCodec& GetCodec()
{
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
  throw Failure(file, reason.empty() ? otherwise : MakePrintableLine(reason));
}

} // anonymous namespace

//------------------------------------------------------------------------------
void WriteImageFile(const Image& image, const std::string& file)
{
  TemporaryFile temporary(file);
  if (ExtensionOf(file) == ".png")
  {
    try
    {
      WritePNG(image, temporary.GetName());
    }
    catch (const Failure& failure)
    {
      throw Failure(file, failure.what());
    }
    temporary.Commit();
    return;
  }
  std::string reason;
  if (!GetCodec().Write(image, temporary.GetName(), reason))
  {
    Fail(file, temporary.GetName(), reason, "cannot be written");
  }
  temporary.Commit();
}

//------------------------------------------------------------------------------
void ReadImageFile(const std::string& file, const ImageFunction& take)
{
  const auto read = ExtensionOf(file) == ".png" ? ReadPNG : GetCodec().Read;
  std::string reason;
  if (!read(file, take, reason))
  {
    Fail(file, file, reason, "cannot be read");
  }
}
}
