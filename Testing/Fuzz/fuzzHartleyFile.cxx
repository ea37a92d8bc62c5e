// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as the tables and streams of a volume, with checksums made right: two bytes and a part
// each for META and TABL, the rest for the streams. Bytes that begin as a file are taken as one.

#include "fuzzFiles.h"
#include "fuzzInput.h"
#include "gatunFileImage.h"
#include "gatunHartleyFile.h"
#include "gatunHartleyTables.h"

#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace
{
using namespace gatun;

/** More than that is not asked for, as the caller has to have memory for it. */
constexpr std::size_t MostVoxels = 1u << 18;

void Decode(std::span<const std::uint8_t> bytes)
{
  try
  {
    const HartleyFile file(std::make_shared<const MemorySource>(bytes), fuzz::FileName);
    const auto& layout = file.GetLayout();
    const auto& size = layout.Size;
    if (layout.GetVoxelsPerBlock() > MostVoxels)
    {
      return;
    }
    file.GetChunk(layout.GetNumberOfChunks() - 1);
    if (std::uint64_t{ size[0] } * size[1] <= MostVoxels / size[2])
    {
      std::vector<std::uint8_t> voxels(
        std::size_t{ size[0] } * size[1] * size[2] * SizeOf(file.GetVolume().Type));
      file.GetVoxels({ 0, 0, 0 }, size, voxels.data());
      file.Verify();
    }
  }
  catch (const Error& error)
  {
    if (error.Path != fuzz::FileName)
    {
      std::abort();
    }
  }
}

/** Makes the sums of all streams right, if the tables are. */
Bytes Repair(const Bytes& meta, Bytes table, std::span<const std::uint8_t> streams)
{
  try
  {
    const auto described = HartleyMeta::Read(meta);
    auto entries = HartleyTable::Read(table, described);
    const auto repair = [&](StreamRef& stream)
    {
      const auto first = HeaderSize + SectionHeaderSize;
      if (stream.Offset >= first && stream.Offset - first <= streams.size() &&
        stream.Length <= streams.size() - (stream.Offset - first))
      {
        stream.Sum = Checksum(streams.subspan(stream.Offset - first, stream.Length));
      }
    };
    for (auto& chunk : entries.Chunks)
    {
      std::for_each(chunk.Streams.begin(), chunk.Streams.end(), repair);
      repair(chunk.Corrections);
    }
    table = entries.Write(described);
  }
  catch (const Error&)
  {
    // Damaged tables are given to the reader as they are.
  }
  test::FileImage frame;
  frame.Kind = &VolumeContainer;
  return frame.Assemble({ { SectionBlocks, Bytes(streams.begin(), streams.end()) },
    { SectionTable, table }, { SectionMeta, meta } });
}
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::UseOneThread();
  const auto& magic = VolumeContainer.FileMagic;
  if (size >= magic.size() && std::equal(magic.begin(), magic.end(), data))
  {
    Decode({ data, size });
  }
  else
  {
    fuzz::Input in(data, size);
    const auto meta = fuzz::Copy(in.TakePart());
    const auto table = fuzz::Copy(in.TakePart());
    Decode(Repair(meta, table, in.TakeRest()));
  }
  return 0;
}
