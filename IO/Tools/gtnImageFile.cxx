// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The library gtnImages: images by OpenImageIO.

#include "gtnImageFile.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <exception>
#include <memory>

namespace
{

OIIO::ImageSpec MakeSpec(const gtn::Image& image)
{
  const bool bytes = !image.Bytes.empty();
  OIIO::ImageSpec spec(image.Width, image.Height, static_cast<int>(image.Channels.size()),
    bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
  spec.channelnames = image.Channels;
  const auto place = [&image](const char* name)
  {
    const auto found = std::find(image.Channels.begin(), image.Channels.end(), name);
    return found == image.Channels.end() ? -1 : static_cast<int>(found - image.Channels.begin());
  };
  spec.alpha_channel = place("A");
  spec.z_channel = place("Z");
  if (bytes)
  {
    spec.attribute("oiio:UnassociatedAlpha", 1);
    spec.attribute("oiio:ColorSpace", "sRGB");
  }
  else
  {
    spec.attribute("compression", "zip");
  }
  for (const auto& [name, text] : image.Remarks)
  {
    spec.attribute(name, text);
  }
  return spec;
}

bool Write(const gtn::Image& image, const std::string& file, std::string& reason)
{
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(file);
  if (!output)
  {
    reason = OIIO::geterror();
    return false;
  }
  const bool bytes = !image.Bytes.empty();
  const void* const pixels =
    bytes ? static_cast<const void*>(image.Bytes.data()) : image.Floats.data();
  // Closed in any case: what did not fit on the disk may show only there.
  bool good = output->open(file, MakeSpec(image)) &&
    output->write_image(bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT, pixels);
  reason = output->geterror();
  good = output->close() && good;
  if (reason.empty())
  {
    reason = output->geterror();
  }
  return good && reason.empty();
}

} // anonymous namespace

extern "C" bool gtnWriteImage(
  const gtn::Image& image, const std::string& file, std::string& reason);

extern "C" bool gtnWriteImage(const gtn::Image& image, const std::string& file, std::string& reason)
{
  try
  {
    return Write(image, file, reason);
  }
  catch (const std::exception& error)
  {
    reason = error.what();
  }
  catch (...)
  {
    reason = "failed for an unknown reason";
  }
  return false;
}
