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
#include <utility>

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

// A reader or writer of libpng with its file.
class Png
{
public:
  Png(const std::string& file, bool isWriter)
    : IsWriter(isWriter)
    , File(std::fopen(file.c_str(), isWriter ? "wb" : "rb"))
    , Main(isWriter
          ? png_create_write_struct(PNG_LIBPNG_VER_STRING, &this->State, HandleError, IgnoreWarning)
          : png_create_read_struct(PNG_LIBPNG_VER_STRING, &this->State, HandleError, IgnoreWarning))
    , Info(this->Main ? png_create_info_struct(this->Main) : nullptr)
  {
  }
  ~Png()
  {
    this->IsWriter ? png_destroy_write_struct(&this->Main, &this->Info)
                   : png_destroy_read_struct(&this->Main, &this->Info, nullptr);
    this->Close();
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

  // Returns false if what is still in the buffer cannot be written.
  bool Close()
  {
    std::FILE* const file = std::exchange(this->File, nullptr);
    return !file || std::fclose(file) == 0;
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

  const bool IsWriter;
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

bool WritePng(const Image& image, const std::string& file, std::string& reason)
try
{
  constexpr int colorTypes[] = { PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
    PNG_COLOR_TYPE_RGB_ALPHA };
  const std::size_t size = gatun::SizeOf(image.Type);
  const std::size_t channels = image.Channels.size();
  // libpng takes pointers to what it does not change.
  auto* const values = static_cast<png_bytep>(const_cast<void*>(image.Values));
  std::vector<png_bytep> rows = RowsOf(values, static_cast<std::size_t>(image.Height),
    size * channels * static_cast<std::size_t>(image.Width));
  std::vector<png_text> texts;
  for (const auto& [key, text] : image.Remarks)
  {
    png_text& entry = texts.emplace_back();
    entry.compression = PNG_TEXT_COMPRESSION_NONE;
    entry.key = const_cast<char*>(key.c_str());
    entry.text = const_cast<char*>(text.c_str());
    entry.text_length = text.size();
  }
  Png png(file, true);
  const auto work = [&]
  {
    png_structp main = png.GetMain();
    png_init_io(main, png.GetFile());
    png_set_user_limits(main, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(main, png.GetInfo(), static_cast<png_uint_32>(image.Width),
      static_cast<png_uint_32>(image.Height), static_cast<int>(8 * size), colorTypes[channels - 1],
      PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (channels > 2)
    {
      png_set_sRGB_gAMA_and_cHRM(main, png.GetInfo(), PNG_sRGB_INTENT_ABSOLUTE);
    }
    png_set_text(main, png.GetInfo(), texts.data(), static_cast<int>(texts.size()));
    png_write_info(main, png.GetInfo());
    if (size == 2 && std::endian::native == std::endian::little)
    {
      png_set_swap(main);
    }
    png_write_image(main, rows.data());
    png_write_end(main, nullptr);
  };
  if (!png.Run(work, reason))
  {
    return false;
  }
  if (!png.Close())
  {
    reason = std::strerror(errno);
    return false;
  }
  return true;
}
catch (const std::bad_alloc&)
{
  reason = "not enough memory";
  return false;
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

bool ReadPng(const std::string& file, const ImageFunction& take, std::string& reason)
{
  Png png(file, false);
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

} // anonymous namespace

const ImageCodec PngCodec{ WritePng, ReadPng };
}
