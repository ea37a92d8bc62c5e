// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnSpool.h"

#include <algorithm>

namespace gtn
{
//------------------------------------------------------------------------------
Spool::Spool(const std::string& folder)
  : File(gatun::AtomicFile::MakeScratch(folder))
{
}

//------------------------------------------------------------------------------
std::size_t Spool::Open(std::size_t streams, std::size_t memory)
{
  constexpr std::size_t most = std::size_t{ 1 } << 20;
  const std::size_t first = this->Streams.size();
  this->FirstOpen = first;
  this->Streams.resize(first + streams);
  for (std::size_t i = first; i < this->Streams.size(); ++i)
  {
    // Multiples of a page
    this->Streams[i].Extent = std::clamp(memory / streams, LeastBuffer, most) & ~(LeastBuffer - 1);
  }
  return first;
}

//------------------------------------------------------------------------------
void Spool::Flush(Stream& stream)
{
  stream.Extents.push_back(this->File.GetSize());
  this->File.Write(stream.Buffer);
  stream.Buffer.clear();
}

//------------------------------------------------------------------------------
void Spool::Append(std::size_t number, std::span<const std::uint8_t> bytes)
{
  Stream& stream = this->Streams[number];
  stream.Size += bytes.size();
  while (!bytes.empty())
  {
    if (stream.Buffer.capacity() == 0)
    {
      stream.Buffer.reserve(stream.Extent);
    }
    const auto part = bytes.first(std::min(bytes.size(), stream.Extent - stream.Buffer.size()));
    stream.Buffer.insert(stream.Buffer.end(), part.begin(), part.end());
    bytes = bytes.subspan(part.size());
    if (stream.Buffer.size() == stream.Extent)
    {
      this->Flush(stream);
    }
  }
}

//------------------------------------------------------------------------------
void Spool::Close()
{
  for (std::size_t i = this->FirstOpen; i < this->Streams.size(); ++i)
  {
    Stream& stream = this->Streams[i];
    if (!stream.Buffer.empty())
    {
      this->Flush(stream);
    }
    stream.Buffer = std::vector<std::uint8_t>(); // which frees the memory, as {} does not
  }
  this->FirstOpen = this->Streams.size();
}

//------------------------------------------------------------------------------
template <typename Use>
void Spool::ForEachExtent(const Stream& stream, std::uint64_t begin, std::size_t size, Use&& use)
{
  for (std::size_t at = 0; at < size;)
  {
    const auto place = static_cast<std::size_t>((begin + at) % stream.Extent);
    const auto extent = static_cast<std::size_t>((begin + at) / stream.Extent);
    const std::size_t part = std::min(size - at, stream.Extent - place);
    use(stream.Extents[extent] + place, at, part);
    at += part;
  }
}

//------------------------------------------------------------------------------
void Spool::Read(std::size_t stream, std::uint64_t begin, std::span<std::uint8_t> bytes) const
{
  ForEachExtent(this->Streams[stream], begin, bytes.size(),
    [&](std::uint64_t offset, std::size_t at, std::size_t size)
    { this->File.ReadAt(offset, bytes.subspan(at, size)); });
}

//------------------------------------------------------------------------------
void Spool::Replace(std::size_t stream, std::span<const std::uint8_t> bytes)
{
  ForEachExtent(this->Streams[stream], 0, bytes.size(),
    [&](std::uint64_t offset, std::size_t at, std::size_t size)
    { this->File.Overwrite(offset, bytes.subspan(at, size)); });
}
}
