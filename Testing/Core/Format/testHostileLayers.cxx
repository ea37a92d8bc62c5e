// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files with valid checksums and invalid layers.

#include "gatunHostile.h"
#include "gatunLayerTable.h"
#include "gatunTableParts.h"
#include "gatunVerifyFile.h"

#include <cmath>
#include <functional>
#include <limits>

namespace
{
using namespace gatun;
using namespace gatun::test;

/** The sample, with layers of its first point array, all chunks in all of them. */
struct LayerImage
{
  LayerImage()
    : File(MakeImage())
  {
    while (this->File.Meta.Arrays[this->Table.Array].Where != Association::Point)
    {
      ++this->Table.Array;
    }
    this->Table.Spacing = LayerSpacing::Uniform;
    this->Table.Bounds = { -1e9, 0, 1e9 };
    this->Table.Chunks.assign(this->File.Mesh.Chunks.size(), { 0, 3 });
  }

  Bytes Build() const
  {
    auto file = this->File;
    file.MoreSections.push_back(
      { this->Name, this->Stored ? Store(*this->Stored) : WriteLayers(this->Table, this->File.Meta),
        SectionVersion, 0 });
    file.MoreSections.insert(file.MoreSections.end(), this->More.begin(), this->More.end());
    return file.Build();
  }

  FileImage File;
  Layers Table;
  std::optional<Bytes> Stored; // written in place of the table
  FourCC Name = SectionLayers;
  std::vector<FileImage::Section> More;
};

void ExpectRefused(const std::string& what, const std::function<void(LayerImage&)>& change)
{
  LayerImage image;
  change(image);
  const auto path = PutFile("changed.gtn", image.Build());
  EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path, what, [&] { FileReader file(path); });
}

const std::string Name = "the table of layers at byte ";

TEST(HostileLayers, TheUnchangedFileIsRead)
{
  const auto path = PutFile("same.gtn", LayerImage().Build());
  EXPECT_NO_THROW(ReadAll(path));
  const FileReader file(path);
  EXPECT_TRUE(VerifyFile(file));
  EXPECT_EQ(file.GetLayers().Bounds, (std::vector<double>{ -1e9, 0, 1e9 }));
  EXPECT_EQ(file.GetLayers().Chunks.back(), (LayerSpan{ 0, 3 }));
}

TEST(HostileLayers, TheyMustBeOfAPointArrayAndAComponentOfIt)
{
  ExpectRefused("the layers are those of no point array",
    [](LayerImage& f) { f.Table.Array = static_cast<std::uint32_t>(f.File.Meta.Arrays.size()); });
  ExpectRefused("the layers are those of no point array",
    [](LayerImage& f)
    {
      f.Table.Array = 0;
      while (f.File.Meta.Arrays[f.Table.Array].Where == Association::Point)
      {
        ++f.Table.Array;
      }
    });
  ExpectRefused("the layers are those of no component",
    [](LayerImage& f)
    {
      const auto components = f.File.Meta.Arrays[f.Table.Array].Components;
      f.Table.Component = static_cast<int>(GetRangeCount(components));
    });
}

TEST(HostileLayers, BoundsMustBeFiniteAndAscend)
{
  const std::string finite = "the bound of a layer is not a finite number";
  const std::string ascend = "the bounds of layers do not ascend";
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ExpectRefused(finite, [](LayerImage& f) { f.Table.Bounds[0] = std::nan(""); });
  ExpectRefused(finite, [](LayerImage& f) { f.Table.Bounds[2] = std::nan(""); });
  ExpectRefused(finite, [](LayerImage& f) { f.Table.Bounds[0] = -infinity; });
  ExpectRefused(finite, [](LayerImage& f) { f.Table.Bounds[2] = infinity; });
  ExpectRefused(ascend, [](LayerImage& f) { f.Table.Bounds[1] = f.Table.Bounds[0]; });
  ExpectRefused(ascend, [](LayerImage& f) { std::swap(f.Table.Bounds[1], f.Table.Bounds[2]); });
  ExpectRefused(ascend,
    [](LayerImage& f)
    {
      f.Table.Bounds[0] = 0.0;
      f.Table.Bounds[1] = -0.0;
    });
}

TEST(HostileLayers, ChunksMustBeInLayersThatExist)
{
  const std::string what = "a chunk is in layers that do not exist";
  ExpectRefused(what, [](LayerImage& f) { f.Table.Chunks[0] = { 2, 1 }; });
  ExpectRefused(what, [](LayerImage& f) { f.Table.Chunks.back() = { 0, 4 }; });
  ExpectRefused(what, [](LayerImage& f) { f.Table.Chunks[1] = { 4, 4 }; });
  ExpectRefused(Name, [](LayerImage& f) { f.Table.Chunks.pop_back(); });
  ExpectRefused("bytes behind the end", [](LayerImage& f) { f.Table.Chunks.push_back({ 0, 0 }); });
}

TEST(HostileLayers, CountsMustFitWhatIsThere)
{
  const auto withCount = [](std::uint64_t count, std::size_t more)
  {
    return [=](LayerImage& f)
    {
      ByteWriter content;
      content.PutVarint(f.Table.Array);
      content.PutVarint(0);
      content.Put(std::uint8_t{ 3 });
      content.PutVarint(count);
      content.Data.resize(content.Data.size() + more);
      f.Stored = content.Data;
    };
  };
  const std::string number = "the number of layers is not from 1 to 4096";
  ExpectRefused(number, withCount(0, 100));
  ExpectRefused(number, withCount(4097, 100000));
  ExpectRefused("a number is too large", withCount(std::uint64_t{ 1 } << 32, 100000));
  ExpectRefused("the bounds of layers are not all there", withCount(4096, 8 * 4095 - 1));
  ExpectRefused("the layers of some of the chunks are missing", withCount(1, 1));
  // One layer, and all chunks in it.
  LayerImage good;
  withCount(1, 2 * good.File.Mesh.Chunks.size())(good);
  EXPECT_EQ(FileReader(PutFile("good.gtn", good.Build())).GetLayers().GetCount(), 1u);
}

TEST(HostileLayers, ATableCutShortIsRefused)
{
  const auto content = Decompress(WriteLayers(LayerImage().Table, LayerImage().File.Meta), 1 << 20);
  for (std::size_t size = 0; size < content.size(); ++size)
  {
    ExpectRefused(
      Name, [&](LayerImage& f) { f.Stored = Bytes(content.data(), content.data() + size); });
  }
  ExpectRefused("claims to hold",
    [](LayerImage& f)
    {
      f.Name = MakeFourCC("NONE"); // then it is not looked at
      f.More.push_back(
        { SectionLayers, Compress(Bytes((std::size_t{ 1 } << 20) + 1, 0)), SectionVersion, 0 });
    });
}

TEST(HostileLayers, ThereIsOneTable)
{
  ExpectRefused("the file has several sections for the table of layers",
    [](LayerImage& f) {
      f.More.push_back({ SectionLayers, WriteLayers(f.Table, f.File.Meta), SectionVersion, 0 });
    });
}

TEST(HostileLayers, ASpacingOfALaterVersionIsAnother)
{
  LayerImage image;
  image.Table.Spacing = static_cast<LayerSpacing>(4);
  EXPECT_EQ(
    FileReader(PutFile("later.gtn", image.Build())).GetLayers().Spacing, LayerSpacing::Other);
}

TEST(HostileLayers, VerifyingFindsValuesOutsideOfThem)
{
  const auto expect = [](const std::function<void(LayerImage&)>& change)
  {
    LayerImage image;
    change(image);
    const auto path = PutFile("changed.gtn", image.Build());
    EXPECT_NO_THROW(ReadAll(path)); // layers only inform
    EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path,
      "the values of chunk 1 are not in the layers that the table of layers tells",
      [&] { VerifyFile(FileReader(path)); });
  };
  expect([](LayerImage& f) { f.Table.Chunks[1] = { 0, 0 }; });
  expect([](LayerImage& f) { f.Table.Chunks[1] = { 3, 3 }; });
}
}
