// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The library gtnImages: images by OpenImageIO.

#include "gtnImageFile.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <memory>
#include <new>

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

// Writes and closes: what did not fit on the disk may show only there.
bool WritePixels(const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* pixels,
  const std::string& file, std::string& reason)
{
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(file);
  if (!output)
  {
    reason = OIIO::geterror();
    return false;
  }
  bool good = output->open(file, spec) && output->write_image(type, pixels);
  reason = output->geterror();
  good = output->close() && good;
  if (reason.empty())
  {
    reason = output->geterror();
  }
  return good && reason.empty();
}

bool Write(const gtn::Image& image, const std::string& file, std::string& reason)
{
  const bool bytes = !image.Bytes.empty();
  const void* const pixels =
    bytes ? static_cast<const void*>(image.Bytes.data()) : image.Floats.data();
  return WritePixels(
    MakeSpec(image), bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT, pixels, file, reason);
}

struct TypePair
{
  gatun::ScalarType Ours;
  OIIO::TypeDesc::BASETYPE Theirs;
};

constexpr std::array<TypePair, 10> Types{ {
  { gatun::ScalarType::Int8, OIIO::TypeDesc::INT8 },
  { gatun::ScalarType::UInt8, OIIO::TypeDesc::UINT8 },
  { gatun::ScalarType::Int16, OIIO::TypeDesc::INT16 },
  { gatun::ScalarType::UInt16, OIIO::TypeDesc::UINT16 },
  { gatun::ScalarType::Int32, OIIO::TypeDesc::INT32 },
  { gatun::ScalarType::UInt32, OIIO::TypeDesc::UINT32 },
  { gatun::ScalarType::Int64, OIIO::TypeDesc::INT64 },
  { gatun::ScalarType::UInt64, OIIO::TypeDesc::UINT64 },
  { gatun::ScalarType::Float32, OIIO::TypeDesc::FLOAT },
  { gatun::ScalarType::Float64, OIIO::TypeDesc::DOUBLE },
} };

// Others, such as half, become float.
gatun::ScalarType TypeOf(OIIO::TypeDesc type)
{
  const auto found = std::find_if(Types.begin(), Types.end(),
    [type](const TypePair& pair) { return pair.Theirs == type.basetype; });
  return found == Types.end() ? gatun::ScalarType::Float32 : found->Ours;
}

OIIO::TypeDesc TypeOf(gatun::ScalarType type)
{
  const auto found = std::find_if(
    Types.begin(), Types.end(), [type](const TypePair& pair) { return pair.Ours == type; });
  return found->Theirs;
}

bool Read(
  const std::string& file, const std::function<bool(const gtn::Slice&)>& take, std::string& reason)
{
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(file);
  if (!input)
  {
    reason = OIIO::geterror();
    return false;
  }
  for (int page = 0; input->seek_subimage(page, 0); ++page)
  {
    const OIIO::ImageSpec& spec = input->spec();
    gtn::Slice slice{ spec.width, spec.height, spec.nchannels, TypeOf(spec.format), nullptr };
    if (spec.depth > 1)
    {
      reason = "has a picture of several layers, which is no slice";
      return false;
    }
    std::vector<unsigned char> values;
    if (slice.Channels == 1)
    {
      values.resize(static_cast<std::size_t>(spec.image_pixels()) * gatun::SizeOf(slice.Type));
      if (!input->read_image(page, 0, 0, 1, TypeOf(slice.Type), values.data()))
      {
        reason = input->geterror();
        return false;
      }
      slice.Values = values.data();
    }
    if (!take(slice))
    {
      return true;
    }
  }
  input->geterror(); // that there is no other page
  return true;
}

bool WriteSlice(const gtn::Slice& slice, const std::string& file, std::string& reason)
{
  OIIO::ImageSpec spec(slice.Width, slice.Height, 1, TypeOf(slice.Type));
  spec.attribute("compression", "zip");
  spec.attribute("tiff:write_exif", 0); // there is none, and some versions fail to write that
  return WritePixels(spec, TypeOf(slice.Type), slice.Values, file, reason);
}

// Calls a function, and makes a reason of what it throws.
template <typename Function>
bool Guarded(std::string& reason, Function&& function)
{
  try
  {
    return function();
  }
  catch (const std::bad_alloc&)
  {
    reason = "not enough memory";
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

} // anonymous namespace

extern "C" bool gtnWriteImage(
  const gtn::Image& image, const std::string& file, std::string& reason);
extern "C" bool gtnReadSlices(
  const std::string& file, const std::function<bool(const gtn::Slice&)>& take, std::string& reason);
extern "C" bool gtnWriteSlice(
  const gtn::Slice& slice, const std::string& file, std::string& reason);

extern "C" bool gtnWriteImage(const gtn::Image& image, const std::string& file, std::string& reason)
{
  return Guarded(reason, [&] { return Write(image, file, reason); });
}

extern "C" bool gtnReadSlices(
  const std::string& file, const std::function<bool(const gtn::Slice&)>& take, std::string& reason)
{
  // What the caller throws goes back to the caller.
  std::exception_ptr thrown;
  const bool good = Guarded(reason,
    [&]
    {
      return Read(
        file,
        [&](const gtn::Slice& slice)
        {
          try
          {
            return take(slice);
          }
          catch (...)
          {
            thrown = std::current_exception();
            return false;
          }
        },
        reason);
    });
  if (thrown)
  {
    std::rethrow_exception(thrown);
  }
  return good;
}

extern "C" bool gtnWriteSlice(const gtn::Slice& slice, const std::string& file, std::string& reason)
{
  return Guarded(reason, [&] { return WriteSlice(slice, file, reason); });
}
