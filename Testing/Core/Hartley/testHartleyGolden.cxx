// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Golden files of volumes: what is read of them is what a decoder said that was written from
// Documentation/ghv-format.md alone. See Testing/Python/make_golden.py.

#include "gatunContainer.h"
#include "gatunGolden.h"
#include "gatunHartleyFile.h"
#include "gatunHartleySample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>

namespace gatun::test
{
namespace
{
std::string GetSum(std::span<const std::uint8_t> bytes)
{
  std::array<char, 17> text{};
  std::snprintf(
    text.data(), text.size(), "%016llx", static_cast<unsigned long long>(Checksum(bytes)));
  return text.data();
}

/** Lines as in expected.json. */
std::string Describe(const std::filesystem::path& path)
{
  const HartleyFile file(path.string());
  const auto& volume = file.GetVolume();
  const auto& layout = file.GetLayout();
  std::ostringstream out;
  out << "= " << path.filename().string() << "\nsize";
  for (const auto size : volume.Size)
  {
    out << " " << size;
  }
  out << " type " << static_cast<int>(volume.Type) << " block";
  for (const auto size : layout.Block)
  {
    out << " " << size;
  }
  out << " chunks " << layout.GetNumberOfChunks() << "\n";
  ByteWriter place;
  const auto put = [&](const auto& values)
  { std::for_each(values.begin(), values.end(), [&](auto value) { place.Put(value); }); };
  put(volume.Origin);
  put(volume.Spacing);
  put(volume.Direction);
  place.Put(file.GetRange().Min);
  place.Put(file.GetRange().Max);
  put(volume.FirstIndex);
  place.Put(volume.VTKType);
  out << "place " << GetSum(place.Data) << " name " << volume.Name << "\n";
  for (std::size_t i = 0; i < layout.GetNumberOfChunks(); ++i)
  {
    const auto chunk = file.GetChunk(i);
    ByteWriter terms;
    for (std::uint32_t block = 0; block + 1 < chunk->Starts.size(); ++block)
    {
      for (const auto& term : chunk->GetBlock(block))
      {
        terms.Put(block);
        terms.Put(term.Index);
        terms.Put(term.Value);
      }
    }
    out << "chunk " << i << " terms " << chunk->Terms.size() << " " << GetSum(terms.Data) << "\n";
  }
  if (!IsFloating(volume.Type))
  {
    out << "voxels " << GetSum(ReadVoxels(file)) << "\n";
  }
  file.Verify();
  return out.str();
}
}

TEST(HartleyGolden, FilesAreReadAsTheySay)
{
  const auto expected = ReadExpectedLines("volumes");
  EXPECT_GT(expected.size(), 5u);
  for (const auto& [name, lines] : expected)
  {
    EXPECT_EQ(Describe(GetGoldenFolder() / name), lines);
  }
}
}
