// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunParallelImage.h"

#include "gatunBytes.h"
#include "gatunParallel.h"
#include "gatunRayCaster.h"
#include "gatunRayMerger.h"
#include "gatunRayRendering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace gatun
{
namespace
{
// That of RayCaster, so that the tiles of rays and of pixels are the same where a ray is a pixel.
constexpr int TileSize = 32;
constexpr std::size_t TilePixels = std::size_t{ TileSize } * TileSize;

constexpr std::uint16_t None = 0xffff;

// How much nearer than all geometry a pixel of the volume is: the smallest step of a depth buffer
// of 24 bits, four times.
constexpr float Step = 0x1p-22f;

using Message = ProcessExchange::Message;

/** The geometry in a tile. */
struct TileDepths
{
  std::array<float, TilePixels> Depths;
  std::array<std::uint16_t, TilePixels> Processes;

  TileDepths()
  {
    this->Depths.fill(1);
    this->Processes.fill(None);
  }
};

std::uint16_t ToTexel(float value)
{
  const float inRange = value > 0 ? std::min(value, 1.0f) : 0.0f; // NaN too
  return static_cast<std::uint16_t>(inRange * 65535 + 0.5f);
}

template <typename T, std::size_t N>
void PutAll(const std::array<T, N>& values, ByteWriter& bytes)
{
  bytes.PutBytes({ reinterpret_cast<const std::uint8_t*>(values.data()), sizeof(values) });
}

template <typename T, std::size_t N>
void GetAll(ByteReader& reader, std::array<T, N>& values)
{
  const auto bytes = reader.GetBytes(sizeof(values));
  std::memcpy(values.data(), bytes.data(), bytes.size());
}

/** The nearest geometry of all processes in the tiles of their messages, as a message. */
Message FindNearest(const std::vector<Message>& messages)
{
  std::map<std::uint32_t, TileDepths> tiles;
  for (std::size_t process = 0; process < messages.size(); ++process)
  {
    ByteReader reader(messages[process]);
    while (reader.GetRemaining() > 0)
    {
      TileDepths& nearest = tiles[reader.Get<std::uint32_t>()];
      std::array<float, TilePixels> depths;
      GetAll(reader, depths);
      for (std::size_t i = 0; i < TilePixels; ++i)
      {
        if (depths[i] < nearest.Depths[i])
        {
          nearest.Depths[i] = depths[i];
          nearest.Processes[i] = static_cast<std::uint16_t>(process);
        }
      }
    }
  }
  ByteWriter writer;
  for (const auto& [index, nearest] : tiles)
  {
    writer.Put(index);
    PutAll(nearest.Depths, writer);
    PutAll(nearest.Processes, writer);
  }
  return std::move(writer.Data);
}
}

//------------------------------------------------------------------------------
ParallelImage::ParallelImage(ProcessExchange& exchange, int width, int height, int imageProcess)
  : Exchange(exchange)
  , Width(width)
  , Height(height)
  , ImageProcess(imageProcess)
{
}

//------------------------------------------------------------------------------
/** Calls use(tile) for the tiles of an image, in order of their numbers. */
template <typename Use>
void ParallelImage::VisitTiles(int width, int height, Use&& use)
{
  std::size_t index = 0;
  for (int y = 0; y < height; y += TileSize)
  {
    for (int x = 0; x < width; x += TileSize)
    {
      use(Tile{ index, x, y, std::min(TileSize, width - x), std::min(TileSize, height - y) });
      ++index;
    }
  }
}

//------------------------------------------------------------------------------
int ParallelImage::GetOwner(const Tile& tile) const
{
  // Neither rows nor columns of tiles belong to one process.
  return (tile.X + tile.Y) / TileSize % this->Exchange.GetProcesses();
}

//------------------------------------------------------------------------------
int ParallelImage::GetImageProcess(int x, int y) const
{
  if (this->ImageProcess >= 0)
  {
    return this->ImageProcess;
  }
  const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(this->Width) +
    static_cast<std::size_t>(x);
  if (!this->Nearest.empty() && this->Nearest[pixel] != None)
  {
    return this->Nearest[pixel];
  }
  return (x / TileSize + y / TileSize) % this->Exchange.GetProcesses();
}

//------------------------------------------------------------------------------
void ParallelImage::ShareDepths(std::span<const float> own)
{
  const auto processes = static_cast<std::size_t>(this->Exchange.GetProcesses());
  std::vector<Message> messages(processes);
  this->Exchange.Together(
    [&]
    {
      if (!own.empty())
      {
        this->PackDepths(own, messages);
      }
    });
  auto received = this->Exchange.Exchange(std::move(messages));
  messages.assign(processes, {});
  this->Exchange.Together([&] { messages.assign(processes, FindNearest(received)); });
  received = this->Exchange.Exchange(std::move(messages));
  this->Exchange.Together([&] { this->UnpackDepths(received); });
}

//------------------------------------------------------------------------------
/** Calls use(place in tile, pixel) for the pixels of a tile. */
template <typename Use>
void ParallelImage::VisitPixels(const Tile& tile, Use&& use) const
{
  for (int y = 0; y < tile.Height; ++y)
  {
    for (int x = 0; x < tile.Width; ++x)
    {
      use(static_cast<std::size_t>(y * TileSize + x),
        static_cast<std::size_t>(tile.Y + y) * static_cast<std::size_t>(this->Width) +
          static_cast<std::size_t>(tile.X + x));
    }
  }
}

//------------------------------------------------------------------------------
/** For the owners of the tiles that have geometry. */
void ParallelImage::PackDepths(std::span<const float> own, std::vector<Message>& messages) const
{
  std::vector<ByteWriter> writers(messages.size());
  VisitTiles(this->Width, this->Height,
    [&](const Tile& tile)
    {
      TileDepths depths;
      this->VisitPixels(
        tile, [&](std::size_t inTile, std::size_t pixel) { depths.Depths[inTile] = own[pixel]; });
      if (*std::min_element(depths.Depths.begin(), depths.Depths.end()) < 1)
      {
        ByteWriter& writer = writers[static_cast<std::size_t>(this->GetOwner(tile))];
        writer.Put(static_cast<std::uint32_t>(tile.Index));
        PutAll(depths.Depths, writer);
      }
    });
  for (std::size_t p = 0; p < messages.size(); ++p)
  {
    messages[p] = std::move(writers[p].Data);
  }
}

//------------------------------------------------------------------------------
void ParallelImage::UnpackDepths(const std::vector<Message>& messages)
{
  const auto pixels =
    static_cast<std::size_t>(this->Width) * static_cast<std::size_t>(this->Height);
  this->Depths.assign(pixels, 1);
  this->Nearest.assign(pixels, None);
  std::vector<Tile> tiles;
  VisitTiles(this->Width, this->Height, [&](const Tile& tile) { tiles.push_back(tile); });
  for (const Message& message : messages)
  {
    ByteReader reader(message);
    while (reader.GetRemaining() > 0)
    {
      const Tile& tile = tiles.at(reader.Get<std::uint32_t>());
      TileDepths nearest;
      GetAll(reader, nearest.Depths);
      GetAll(reader, nearest.Processes);
      this->VisitPixels(tile,
        [&](std::size_t inTile, std::size_t pixel)
        {
          this->Depths[pixel] = nearest.Depths[inTile];
          this->Nearest[pixel] = nearest.Processes[inTile];
        });
    }
  }
}

//------------------------------------------------------------------------------
void ParallelImage::Merge(
  RayCaster* caster, const RayView& view, const RayTable& table, const RayGrid& grid)
{
  const auto processes = static_cast<std::size_t>(this->Exchange.GetProcesses());
  const bool exact = !grid.ToBorders && grid.Width == this->Width && grid.Height == this->Height;
  std::vector<Message> messages(processes);
  std::vector<std::vector<std::size_t>> tiles(processes);
  this->Exchange.Together(
    [&]
    {
      VisitTiles(grid.Width, grid.Height,
        [&](const Tile& tile)
        { tiles[static_cast<std::size_t>(this->GetOwner(tile))].push_back(tile.Index); });
      for (std::size_t p = 0; caster && p < processes; ++p)
      {
        messages[p] = caster->TakeFragments(tiles[p]);
      }
    });
  auto received = this->Exchange.Exchange(std::move(messages));
  messages.assign(processes, {});
  this->Exchange.Together(
    [&]
    {
      this->Rays.assign(
        4 * static_cast<std::size_t>(grid.Width) * static_cast<std::size_t>(grid.Height), 0);
      RayMerger merger(view, table);
      for (Message& message : received)
      {
        merger.Add(std::move(message));
      }
      merger.Finish(
        tiles[static_cast<std::size_t>(this->Exchange.GetProcess())], this->Rays.data());
      VisitTiles(grid.Width, grid.Height,
        [&](const Tile& tile)
        {
          if (this->GetOwner(tile) == this->Exchange.GetProcess())
          {
            exact ? this->PackExact(tile, messages) : this->PackAll(tile, grid.Width, messages);
          }
        });
    });
  received = this->Exchange.Exchange(std::move(messages));
  this->Exchange.Together(
    [&]
    {
      std::vector<float>& target = exact ? this->Colors : this->Rays;
      target.assign(
        4 * static_cast<std::size_t>(grid.Width) * static_cast<std::size_t>(grid.Height), 0);
      std::vector<Tile> all;
      VisitTiles(grid.Width, grid.Height, [&](const Tile& tile) { all.push_back(tile); });
      for (const Message& message : received)
      {
        ByteReader reader(message);
        while (reader.GetRemaining() > 0)
        {
          this->Unpack(all.at(reader.Get<std::uint32_t>()), exact, grid.Width, reader, target);
        }
      }
      if (!exact)
      {
        this->Interpolate(grid.Width, grid.Height);
      }
    });
}

//------------------------------------------------------------------------------
/** Sends each pixel of a tile to the process that shows it. */
void ParallelImage::PackExact(const Tile& tile, std::vector<Message>& messages) const
{
  std::map<int, ByteWriter> writers;
  std::map<int, bool> isSeen;
  for (int y = tile.Y; y < tile.Y + tile.Height; ++y)
  {
    for (int x = tile.X; x < tile.X + tile.Width; ++x)
    {
      const int imageProcess = this->GetImageProcess(x, y);
      ByteWriter& writer = writers[imageProcess];
      const float* const color = this->Rays.data() +
        4 *
          (static_cast<std::size_t>(y) * static_cast<std::size_t>(this->Width) +
            static_cast<std::size_t>(x));
      for (std::size_t c = 0; c < 4; ++c)
      {
        const std::uint16_t texel = ToTexel(color[c]);
        writer.Put(texel);
        isSeen[imageProcess] |= texel != 0;
      }
    }
  }
  for (const auto& [imageProcess, writer] : writers)
  {
    if (isSeen[imageProcess])
    {
      ByteWriter number;
      number.Put(static_cast<std::uint32_t>(tile.Index));
      Message& message = messages[static_cast<std::size_t>(imageProcess)];
      message.insert(message.end(), number.Data.begin(), number.Data.end());
      message.insert(message.end(), writer.Data.begin(), writer.Data.end());
    }
  }
}

//------------------------------------------------------------------------------
/** Sends all rays of a tile to each process that shows any pixels. */
void ParallelImage::PackAll(const Tile& tile, int width, std::vector<Message>& messages) const
{
  ByteWriter writer;
  writer.Put(static_cast<std::uint32_t>(tile.Index));
  bool isSeen = false;
  for (int y = tile.Y; y < tile.Y + tile.Height; ++y)
  {
    const float* const row = this->Rays.data() +
      4 *
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
          static_cast<std::size_t>(tile.X));
    for (std::size_t i = 0; i < 4 * static_cast<std::size_t>(tile.Width); ++i)
    {
      const std::uint16_t texel = ToTexel(row[i]);
      writer.Put(texel);
      isSeen |= texel != 0;
    }
  }
  for (std::size_t p = 0; isSeen && p < messages.size(); ++p)
  {
    if (this->ImageProcess < 0 || static_cast<std::size_t>(this->ImageProcess) == p)
    {
      messages[p].insert(messages[p].end(), writer.Data.begin(), writer.Data.end());
    }
  }
}

//------------------------------------------------------------------------------
void ParallelImage::Unpack(
  const Tile& tile, bool exact, int width, ByteReader& reader, std::vector<float>& colors) const
{
  for (int y = tile.Y; y < tile.Y + tile.Height; ++y)
  {
    for (int x = tile.X; x < tile.X + tile.Width; ++x)
    {
      if (exact && this->GetImageProcess(x, y) != this->Exchange.GetProcess())
      {
        continue;
      }
      float* const color = colors.data() +
        4 *
          (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(x));
      for (std::size_t c = 0; c < 4; ++c)
      {
        color[c] = static_cast<float>(reader.Get<std::uint16_t>()) / 65535;
      }
    }
  }
}

//------------------------------------------------------------------------------
/** Makes the pixels that this process shows of rays, the outermost of which are on the borders of
 * the image. */
void ParallelImage::Interpolate(int width, int height)
{
  this->Colors.assign(
    4 * static_cast<std::size_t>(this->Width) * static_cast<std::size_t>(this->Height), 0);
  struct Place
  {
    std::size_t First, Second;
    float Part;
  };
  const auto find = [](int pixel, int pixels, int rays)
  {
    const double at = (pixel + 0.5) / pixels * (rays - 1);
    const auto first = static_cast<std::size_t>(at);
    return Place{ first, std::min(first + 1, static_cast<std::size_t>(rays) - 1),
      static_cast<float>(at - static_cast<double>(first)) };
  };
  ParallelFor(static_cast<std::size_t>(this->Height),
    [&](std::size_t row)
    {
      const auto y = static_cast<int>(row);
      const Place inY = find(y, this->Height, height);
      const auto getRow = [&](std::size_t of)
      { return this->Rays.data() + 4 * of * static_cast<std::size_t>(width); };
      const float* const lower = getRow(inY.First);
      const float* const upper = getRow(inY.Second);
      for (int x = 0; x < this->Width; ++x)
      {
        if (this->GetImageProcess(x, y) != this->Exchange.GetProcess())
        {
          continue;
        }
        const Place inX = find(x, this->Width, width);
        float* const color = this->Colors.data() +
          4 * (row * static_cast<std::size_t>(this->Width) + static_cast<std::size_t>(x));
        for (std::size_t c = 0; c < 4; ++c)
        {
          const auto across = [&](const float* from)
          { return std::lerp(from[4 * inX.First + c], from[4 * inX.Second + c], inX.Part); };
          color[c] = std::lerp(across(lower), across(upper), inY.Part);
        }
      }
    });
}

//------------------------------------------------------------------------------
void ParallelImage::HideBehindGeometry(float depth)
{
  for (std::size_t pixel = 0; pixel < this->Depths.size(); ++pixel)
  {
    if (this->Depths[pixel] < depth)
    {
      std::fill_n(this->Colors.begin() + static_cast<std::ptrdiff_t>(4 * pixel), 4, 0.0f);
    }
  }
}

//------------------------------------------------------------------------------
void ParallelImage::BringForward(std::span<float> own) const
{
  for (int y = 0; y < this->Height; ++y)
  {
    for (int x = 0; x < this->Width; ++x)
    {
      if (this->GetImageProcess(x, y) == this->Exchange.GetProcess())
      {
        float& depth = own[static_cast<std::size_t>(y) * static_cast<std::size_t>(this->Width) +
          static_cast<std::size_t>(x)];
        depth = std::max(0.0f, depth - Step);
      }
    }
  }
}
}
