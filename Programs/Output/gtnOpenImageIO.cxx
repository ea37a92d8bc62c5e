// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The library gtnImages: image files by OpenImageIO. It is apart from the program because
// OpenImageIO loads hundreds of other libraries, which takes longer than most commands of gtn.

#include "gtnImage.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <memory>
#include <new>

namespace
{

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

OIIO::ImageSpec MakeSpec(const gtn::Image& image)
{
  OIIO::ImageSpec spec(
    image.Width, image.Height, static_cast<int>(image.Channels.size()), TypeOf(image.Type));
  spec.channelnames = image.Channels;
  const auto place = [&image](const char* name)
  {
    const auto found = std::find(image.Channels.begin(), image.Channels.end(), name);
    return found == image.Channels.end() ? -1 : static_cast<int>(found - image.Channels.begin());
  };
  spec.alpha_channel = place("A");
  spec.z_channel = place("Z");
  spec.attribute("compression", "zip");
  spec.attribute("tiff:write_exif", 0); // there is none, and some versions fail to write it
  for (const auto& [name, text] : image.Remarks)
  {
    spec.attribute(name, text);
  }
  return spec;
}

// Closes the file, too: an error of the disk may show only there. One thread is enough, and more
// may not be allowed.
bool Write(const gtn::Image& image, const std::string& file, std::string& reason)
{
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(file);
  if (!output)
  {
    reason = OIIO::geterror();
    return false;
  }
  output->threads(1);
  bool good =
    output->open(file, MakeSpec(image)) && output->write_image(TypeOf(image.Type), image.Values);
  reason = output->geterror();
  good = output->close() && good;
  if (reason.empty())
  {
    reason = output->geterror();
  }
  return good && reason.empty();
}

bool Read(const std::string& file, const gtn::ImageFunction& take, std::string& reason)
{
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(file);
  if (!input)
  {
    reason = OIIO::geterror();
    return false;
  }
  input->threads(1);
  for (int page = 0; input->seek_subimage(page, 0); ++page)
  {
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.depth > 1)
    {
      reason = "has an image of several layers, which is no slice";
      return false;
    }
    gtn::Image image{ spec.width, spec.height, spec.channelnames, TypeOf(spec.format) };
    std::vector<unsigned char> values;
    if (spec.nchannels == 1)
    {
      values.resize(static_cast<std::size_t>(spec.image_pixels()) * gatun::SizeOf(image.Type));
      if (!input->read_image(page, 0, 0, 1, TypeOf(image.Type), values.data()))
      {
        reason = input->geterror();
        return false;
      }
      image.Values = values.data();
    }
    if (!take(image))
    {
      return true;
    }
  }
  input->geterror(); // that there is no other page
  return true;
}

// Calls a function, and turns what it throws into a reason.
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

bool GuardedWrite(const gtn::Image& image, const std::string& file, std::string& reason)
{
  return Guarded(reason, [&] { return Write(image, file, reason); });
}

bool GuardedRead(const std::string& file, const gtn::ImageFunction& take, std::string& reason)
{
  // Exceptions of the caller's function go back to the caller.
  std::exception_ptr thrown;
  const auto guardedTake = [&](const gtn::Image& image)
  {
    try
    {
      return take(image);
    }
    catch (...)
    {
      thrown = std::current_exception();
      return false;
    }
  };
  const bool good = Guarded(reason, [&] { return Read(file, guardedTake, reason); });
  if (thrown)
  {
    std::rethrow_exception(thrown);
  }
  return good;
}

} // anonymous namespace

extern "C" const gtn::ImageCodec gtnImageCodec;
extern "C" const gtn::ImageCodec gtnImageCodec{ GuardedWrite, GuardedRead };
