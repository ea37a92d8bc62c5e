// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyImage_h
#define gatunHartleyImage_h

// A .ghv file taken apart, to be changed and put together again with right checksums.

#include "gatunFileImage.h"
#include "gatunHartleyTables.h"

#include <optional>
#include <string>
#include <vector>

namespace gatun::test
{
struct HartleyFileImage
{
  explicit HartleyFileImage(const std::string& path)
  {
    const InputFile file(path, VolumeContainer);
    const auto read = [&](FourCC name, const char* what)
    { return file.Read(file.FindSection(name, what), what); };
    this->Meta = HartleyMeta::Read(read(SectionMeta, "META"));
    this->Table = HartleyTable::Read(read(SectionTable, "TABL"), this->Meta);
    this->EachStream(
      [&](StreamRef& stream) { this->Streams.push_back(file.Read(stream, "a stream")); });
  }

  /** Calls use for all streams, in the order of Streams. */
  template <typename Use>
  void EachStream(Use&& use)
  {
    for (auto& chunk : this->Table.Chunks)
    {
      std::for_each(chunk.Streams.begin(), chunk.Streams.end(), use);
      if (this->Meta.HasCorrections())
      {
        use(chunk.Corrections);
      }
    }
  }

  /** The whole file; streams of the table become those of Streams, as long as there are any. */
  Bytes Build() const
  {
    auto placed = *this;
    Bytes blocks;
    std::size_t next = 0;
    placed.EachStream(
      [&](StreamRef& stream)
      {
        const auto offset = HeaderSize + SectionHeaderSize + blocks.size();
        const Bytes bytes = next < this->Streams.size() ? this->Streams[next] : Bytes();
        ++next;
        stream = { offset, bytes.size(), Checksum(bytes) };
        blocks.insert(blocks.end(), bytes.begin(), bytes.end());
      });
    FileImage frame;
    frame.Kind = &VolumeContainer;
    frame.Version = this->Version;
    return frame.Assemble({ { SectionBlocks, blocks },
      { SectionTable, this->TableBytes ? *this->TableBytes : placed.Table.Write(this->Meta) },
      { SectionMeta, this->MetaBytes ? *this->MetaBytes : this->Meta.Write() } });
  }

  std::uint32_t Version = 1;
  HartleyMeta Meta;
  HartleyTable Table;
  std::vector<Bytes> Streams;

  /** Written in place of the tables above, if there. */
  std::optional<Bytes> MetaBytes, TableBytes;
};
}

#endif
