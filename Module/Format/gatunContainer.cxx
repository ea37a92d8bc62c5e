// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunContainer.h"

#include "gatunByteSource.h"

#include <xxhash.h>

#include <algorithm>
#include <new>

namespace gatun
{
//------------------------------------------------------------------------------
void PutSectionHeader(ByteWriter& out, const SectionRef& section)
{
  out.Put(section.Name);
  out.Put(section.Version);
  out.Put(section.Flags);
  out.Put(section.Payload.Length);
  out.Put(section.Payload.Sum);
}

//------------------------------------------------------------------------------
SectionRef GetSectionHeader(ByteReader& in)
{
  SectionRef section;
  section.Name = in.Get<FourCC>();
  section.Version = in.Get<std::uint16_t>();
  section.Flags = in.Get<std::uint16_t>();
  section.Payload.Length = in.Get<std::uint64_t>();
  section.Payload.Sum = in.Get<std::uint64_t>();
  return section;
}

//------------------------------------------------------------------------------
Bytes MakeHeader(const ContainerKind& kind)
{
  ByteWriter header;
  header.PutBytes(kind.FileMagic);
  header.Put(kind.Version);
  header.Put(std::uint32_t{ 0 });
  return std::move(header.Data);
}

//------------------------------------------------------------------------------
bool BeginsAs(const std::string& path, const ContainerKind& kind) noexcept
{
  try
  {
    const auto source = OpenFile(path);
    std::array<std::uint8_t, FileMagic.size()> begin{};
    std::span<std::uint8_t> rest(begin);
    return source->ReadAt(0, rest) == 0 && rest.empty() && begin == kind.FileMagic;
  }
  catch (...)
  {
    return false;
  }
}

//------------------------------------------------------------------------------
std::uint64_t Checksum(std::span<const std::uint8_t> bytes)
{
  return XXH3_64bits(bytes.data(), bytes.size());
}

//------------------------------------------------------------------------------
std::uint64_t GetFrameChecksum(std::span<const std::uint8_t> header, const Bytes& directory)
{
  Bytes both(header.begin(), header.end());
  both.insert(both.end(), directory.begin(), directory.end());
  return Checksum(both);
}

//------------------------------------------------------------------------------
class RunningChecksum::State
{
public:
  State()
    : Hash(XXH3_createState(), &XXH3_freeState)
  {
    if (!this->Hash)
    {
      throw std::bad_alloc();
    }
    XXH3_64bits_reset(this->Hash.get());
  }

  std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> Hash;
};

//------------------------------------------------------------------------------
RunningChecksum::RunningChecksum()
  : Self(std::make_unique<State>())
{
}

//------------------------------------------------------------------------------
RunningChecksum::~RunningChecksum() = default;

//------------------------------------------------------------------------------
void RunningChecksum::Add(std::span<const std::uint8_t> bytes)
{
  XXH3_64bits_update(this->Self->Hash.get(), bytes.data(), bytes.size());
}

//------------------------------------------------------------------------------
std::uint64_t RunningChecksum::Get() const
{
  return XXH3_64bits_digest(this->Self->Hash.get());
}
}
