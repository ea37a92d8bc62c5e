// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnPng.h"

#include "vtk_png.h"

#include <bit>
#include <cerrno>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <new>
#include <vector>

namespace gtn
{
namespace
{

// What libpng calls for an error. The reason is kept as an array: longjmp runs no destructors.
struct ErrorState
{
  char Reason[128] = "";
};

[[noreturn]] void HandleError(png_structp png, png_const_charp reason)
{
  auto* const state = static_cast<ErrorState*>(png_get_error_ptr(png));
  std::snprintf(state->Reason, sizeof(state->Reason), "%s", reason);
  png_longjmp(png, 1);
}

void IgnoreWarning(png_structp /*png*/, png_const_charp /*warning*/) {}

// A reader of libpng with its file.
class Png
{
public:
  explicit Png(const std::string& file)
    : File(std::fopen(file.c_str(), "rb"))
    , Main(png_create_read_struct(PNG_LIBPNG_VER_STRING, &this->State, HandleError, IgnoreWarning))
    , Info(this->Main ? png_create_info_struct(this->Main) : nullptr)
  {
  }
  ~Png()
  {
    png_destroy_read_struct(&this->Main, &this->Info, nullptr);
    if (this->File)
    {
      std::fclose(this->File);
    }
  }
  Png(const Png&) = delete;
  Png& operator=(const Png&) = delete;

  png_structp GetMain() const { return this->Main; }
  png_infop GetInfo() const { return this->Info; }
  std::FILE* GetFile() const { return this->File; }

  // Calls work, which calls libpng and must not have objects with destructors. Returns false, and
  // sets the reason, if libpng or the file fails.
  template <typename Work>
  bool Run(const Work& work, std::string& reason)
  {
    errno = 0;
    if (!this->File || !this->Main || !this->Info)
    {
      reason = this->File ? "not enough memory" : std::strerror(errno);
      return false;
    }
    if (this->Try(work))
    {
      return true;
    }
    reason = errno != 0 ? std::strerror(errno) : this->State.Reason;
    return false;
  }

private:
  template <typename Work>
  bool Try(const Work& work)
  {
    if (setjmp(png_jmpbuf(this->Main)) != 0)
    {
      return false;
    }
    work();
    return true;
  }

  std::FILE* File;
  ErrorState State;
  png_structp Main;
  png_infop Info;
};

// Rows of an image, one after the other.
std::vector<png_bytep> RowsOf(png_bytep values, std::size_t count, std::size_t bytes)
{
  std::vector<png_bytep> rows(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    rows[i] = values + i * bytes;
  }
  return rows;
}

// Whether a file can hold that many bytes: deflate shrinks them to a 1032nd at most.
bool CanHold(std::FILE* file, double bytes)
{
  const long here = std::ftell(file);
  std::fseek(file, 0, SEEK_END);
  const auto length = static_cast<double>(std::ftell(file));
  std::fseek(file, here, SEEK_SET);
  return bytes / 1032 <= length;
}

} // anonymous namespace

//------------------------------------------------------------------------------
bool ReadPNG(const std::string& file, const ImageFunction& take, std::string& reason)
{
  Png png(file);
  Image image;
  int channels = 0;
  std::size_t rowBytes = 0;
  const auto readHeader = [&]
  {
    png_structp main = png.GetMain();
    png_infop info = png.GetInfo();
    png_init_io(main, png.GetFile());
    png_set_user_limits(main, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_read_info(main, info);
    const int bits = png_get_bit_depth(main, info);
    if (png_get_color_type(main, info) == PNG_COLOR_TYPE_PALETTE)
    {
      png_set_palette_to_rgb(main);
    }
    else if (bits < 8)
    {
      png_set_expand_gray_1_2_4_to_8(main);
    }
    if (bits == 16 && std::endian::native == std::endian::little)
    {
      png_set_swap(main);
    }
    png_set_interlace_handling(main);
    png_read_update_info(main, info);
    image.Width = static_cast<int>(png_get_image_width(main, info));
    image.Height = static_cast<int>(png_get_image_height(main, info));
    image.Type = bits == 16 ? gatun::ScalarType::UInt16 : gatun::ScalarType::UInt8;
    channels = png_get_channels(main, info);
    rowBytes = png_get_rowbytes(main, info);
  };
  if (!png.Run(readHeader, reason))
  {
    return false;
  }
  image.Channels.resize(static_cast<std::size_t>(channels));
  if (channels != 1)
  {
    take(image);
    return true;
  }
  if (!CanHold(png.GetFile(), static_cast<double>(rowBytes) * image.Height))
  {
    reason = "is too short for its size in pixels";
    return false;
  }
  std::vector<unsigned char> values;
  std::vector<png_bytep> rows;
  try
  {
    values.resize(rowBytes * static_cast<std::size_t>(image.Height));
    rows = RowsOf(values.data(), static_cast<std::size_t>(image.Height), rowBytes);
  }
  catch (const std::bad_alloc&)
  {
    reason = "not enough memory";
    return false;
  }
  const auto readRows = [&]
  {
    png_read_image(png.GetMain(), rows.data());
    png_read_end(png.GetMain(), nullptr);
  };
  if (!png.Run(readRows, reason))
  {
    return false;
  }
  image.Values = values.data();
  take(image);
  return true;
}
}
