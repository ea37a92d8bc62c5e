// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Versions, unknown sections, wrong headers and trailers, and compression bombs.

#include "gatunHostile.h"
#include "gatunVerifyFile.h"

namespace
{
using namespace gatun;
using namespace gatun::test;

void ExpectRefused(const std::string& what, const Bytes& bytes, ErrorCode code)
{
  const auto path = PutFile("changed.gtn", bytes);
  EXPECT_GATUN_ERROR(code, path, what, [&] { ReadAll(path); });
}

TEST(HostileContainer, OtherFilesAreNotGatun)
{
  const auto good = MakeImage().Build();
  for (std::size_t i = 0; i < FileMagic.size(); ++i)
  {
    auto bytes = good;
    bytes[i] ^= 0x20;
    ExpectRefused("not a .gtn file", bytes, ErrorCode::NotGatun);
    EXPECT_FALSE(FileReader::CanRead(GetPath("changed.gtn")));
  }
  ExpectRefused("the file is empty", {}, ErrorCode::NotGatun);
  ExpectRefused("not a .gtn file", Bytes(1000, 0), ErrorCode::NotGatun);
  ExpectRefused("truncated", Bytes(good.begin(), good.begin() + 20), ErrorCode::Truncated);
  ExpectRefused("truncated", Bytes(good.begin(), good.end() - 1), ErrorCode::Truncated);
}

TEST(HostileContainer, AnotherVersionIsNamed)
{
  auto image = MakeImage();
  for (const std::uint32_t version : { 0u, 2u, 1u << 16 | 1u, 0xffffffffu })
  {
    image.Version = version;
    ExpectRefused("the file has version " + std::to_string(version) +
        " of the .gtn format; this program reads version 1 only",
      image.Build(), ErrorCode::UnsupportedVersion);
    EXPECT_TRUE(FileReader::CanRead(GetPath("changed.gtn")));
  }
  image.Version = 1;
  EXPECT_EQ(FileReader(PutFile("same.gtn", image.Build())).GetFormatVersion(), 1u);
}

TEST(HostileContainer, TheReservedWordIsZero)
{
  auto image = MakeImage();
  image.Reserved = 1;
  ExpectRefused("header is damaged at byte 12", image.Build(), ErrorCode::Corrupt);
}

TEST(HostileContainer, UnknownSectionsStopAReaderOnlyIfMandatory)
{
  auto image = MakeImage();
  image.MoreSections.push_back({ MakeFourCC("NEWS"), Bytes(10, 1), 1, FlagMandatory });
  ExpectRefused("a section 'NEWS' (version 1)", image.Build(), ErrorCode::UnsupportedVersion);
  image.MoreSections[0].Flags = 0;
  const auto path = PutFile("more.gtn", image.Build());
  EXPECT_NO_THROW(ReadAll(path));
  EXPECT_TRUE(VerifyFile(FileReader(path)));
}

TEST(HostileContainer, AnotherVersionOfASectionIsNamed)
{
  for (const auto name : MeshSections)
  {
    for (const std::uint16_t flags : { std::uint16_t{ 0 }, FlagMandatory })
    {
      for (const std::uint16_t version : { 0, 2, 0xffff })
      {
        auto image = MakeImage();
        image.MoreSections.push_back({ name, Bytes(10, 1), version, flags });
        ExpectRefused("has version " + std::to_string(version) + "; this program reads version 1",
          image.Build(), ErrorCode::UnsupportedVersion);
      }
    }
  }
}

TEST(HostileContainer, TablesAreThereOnce)
{
  auto image = MakeImage();
  image.MoreSections.push_back({ SectionMeta, image.Meta.Write() });
  ExpectRefused("several sections for the meta data", image.Build(), ErrorCode::Corrupt);
  image.MoreSections[0] = { SectionTable, MakeMeshIndex(image.Mesh).Write(image.Meta.Keep) };
  ExpectRefused("several sections for the table of chunks", image.Build(), ErrorCode::Corrupt);
  ExpectRefused(
    "no section for the meta data", image.Assemble({ { SectionMesh, {} } }), ErrorCode::Corrupt);
}

TEST(HostileContainer, ADirectoryMustFitTheFile)
{
  const auto good = MakeImage().Build();
  const auto setTrailer = [&](std::size_t at, std::uint64_t value)
  {
    auto bytes = good;
    std::memcpy(bytes.data() + bytes.size() - TrailerSize + at, &value, sizeof(value));
    return bytes;
  };
  const std::string what = "it points to no directory";
  ExpectRefused(what, setTrailer(0, 0), ErrorCode::Corrupt);
  ExpectRefused(what, setTrailer(0, ~std::uint64_t{ 0 }), ErrorCode::Corrupt);
  ExpectRefused(what, setTrailer(8, ~std::uint64_t{ 0 }), ErrorCode::Corrupt);
  ExpectRefused("their checksum is wrong", setTrailer(16, 0), ErrorCode::Corrupt);
}

TEST(HostileContainer, SectionsMustLieInTheFile)
{
  auto bytes = MakeImage().Build();
  // The last entry of the directory is META; its length is 16 bytes before the offset.
  const auto set = [&](std::size_t fromEntryEnd, std::uint64_t value)
  {
    auto changed = bytes;
    const auto directoryEnd = changed.size() - TrailerSize;
    std::memcpy(changed.data() + directoryEnd - fromEntryEnd, &value, sizeof(value));
    std::uint64_t start = 0;
    std::memcpy(&start, changed.data() + directoryEnd, sizeof(start));
    Bytes vouched(changed.begin(), changed.begin() + HeaderSize);
    vouched.insert(vouched.end(), changed.begin() + static_cast<std::ptrdiff_t>(start),
      changed.begin() + static_cast<std::ptrdiff_t>(directoryEnd));
    const auto sum = Checksum(vouched);
    std::memcpy(changed.data() + directoryEnd + 16, &sum, sizeof(sum));
    return changed;
  };
  const std::string what = "the meta data at byte";
  ExpectRefused(what, set(8, ~std::uint64_t{ 0 }), ErrorCode::Truncated);
  ExpectRefused(what, set(24, ~std::uint64_t{ 0 }), ErrorCode::Truncated);
  ExpectRefused(what, set(24, std::uint64_t{ 1 } << 40), ErrorCode::Truncated);
}

TEST(HostileContainer, CompressedPartsCannotExpandAtWill)
{
  auto image = MakeImage();
  const auto meta = image.Meta.Write();
  // Zeros compress a thousandfold and more.
  for (const std::size_t size : { std::size_t{ 2 } << 20, std::size_t{ 20 } << 20 })
  {
    const auto bomb = Compress(Bytes(size, 0));
    ASSERT_LT(bomb.size(), size / 1000);
    ExpectRefused("claims to hold", image.Assemble({ { SectionMeta, bomb } }), ErrorCode::Corrupt);
    ExpectRefused("claims to hold",
      image.Assemble({ { SectionMeta, meta }, { SectionTable, bomb } }), ErrorCode::Corrupt);
  }
  // A length that is not true, either way.
  auto less = meta;
  ++less[0];
  ExpectRefused("wrong length", image.Assemble({ { SectionMeta, less } }), ErrorCode::Corrupt);
  less[0] = 3;
  ExpectRefused("the meta data", image.Assemble({ { SectionMeta, less } }), ErrorCode::Corrupt);
}
}
