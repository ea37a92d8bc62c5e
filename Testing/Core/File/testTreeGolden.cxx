// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Golden files with merge trees. They must be read as by an independent decoder, which was written
// from Documentation/format.md alone. See Testing/Python/make_golden.py.

#include "gatunContainer.h"
#include "gatunFileReader.h"
#include "gatunFileReaderInternals.h"
#include "gatunGolden.h"
#include "gatunMergeDependencies.h"
#include "gatunPieceDecoder.h"
#include "gatunVerifyFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <numeric>
#include <set>
#include <sstream>

namespace gatun
{
namespace
{
std::string GetSum(const ByteWriter& bytes)
{
  std::array<char, 17> text{};
  std::snprintf(
    text.data(), text.size(), "%016llx", static_cast<unsigned long long>(Checksum(bytes.Data)));
  return text.data();
}

template <typename T>
std::string GetSumOf(const std::vector<T>& values)
{
  ByteWriter bytes;
  for (const T& value : values)
  {
    bytes.Put(value);
  }
  return GetSum(bytes);
}

void Put(ByteWriter& out, const Range& range)
{
  out.Put(range.Min);
  out.Put(range.Max);
}

/** Lines as in expected.json. */
class Description
{
public:
  Description(std::shared_ptr<const FileReader> file, const std::string& name)
    : File(std::move(file))
    , Tree(std::make_shared<const MergeTree>(this->File->GetMergeTree()))
  {
    this->Out << "= " << name << "\npoints " << this->File->GetNumberOfPoints() << " unused "
              << this->File->GetNumberOfUnusedPoints() << " tets " << this->File->GetNumberOfTets()
              << "\n";
    this->AddTree();
    this->AddRanges();
    const auto count = this->Tree->GetMerges().size();
    for (const auto merges : std::set<std::size_t>{ 1, count / 3, count / 2, count })
    {
      if (merges > 0 && count > 0)
      {
        this->AddMesh(merges);
      }
    }
    for (std::size_t i = 0; i < this->File->GetLevels().size(); ++i)
    {
      this->Out << Description(
        this->File->OpenLevel(i), name + ", base mesh " + std::to_string(i + 1))
                     .Out.str();
    }
  }

  std::ostringstream Out;

private:
  void AddTree()
  {
    ByteWriter bytes;
    for (const Merge& merge : this->Tree->GetMerges())
    {
      bytes.Put(merge.Point);
      bytes.Put(merge.Into);
      bytes.Put(std::bit_cast<std::uint32_t>(merge.Error));
    }
    this->Out << "merges " << this->Tree->GetMerges().size() << " " << GetSum(bytes);
    if (this->File->IsSurface())
    {
      const auto& bonds = this->Tree->GetBonds();
      this->Out << "\nbonds " << std::count(bonds.begin(), bonds.end(), true);
    }
    if (this->File->HasDependencies())
    {
      this->AddDependencies();
    }
    this->Out << "\nmerge_counts";
    this->MergeCounts = InternalsOf(*this->File).Tree->MergeCounts;
    for (const auto mergeCount : this->MergeCounts)
    {
      this->Out << " " << mergeCount;
    }
    this->Out << "\nlevels";
    for (const auto level : this->File->GetLevels())
    {
      this->Out << " " << level;
    }
    this->Out << "\n";
  }

  void AddDependencies()
  {
    const auto dependencies = this->File->ReadDependencies(*this->Tree);
    ByteWriter bytes;
    std::size_t all = 0;
    for (std::size_t i = 0; i < dependencies.GetNumberOfMerges(); ++i)
    {
      const auto earlier = dependencies.Get(i);
      all += earlier.size();
      bytes.Put(static_cast<std::uint32_t>(earlier.size()));
      for (const std::uint32_t merge : earlier)
      {
        bytes.Put(merge);
      }
    }
    this->Out << "\ndependencies " << all << " " << GetSum(bytes);
  }

  /** Of each chunk, for each merge count: what holds for that many merges. */
  template <typename GetRanges>
  std::string SumRanges(GetRanges&& getRanges) const
  {
    ByteWriter bytes;
    for (std::size_t chunk = 0; chunk < this->File->GetChunks().size(); ++chunk)
    {
      for (const auto mergeCount : this->MergeCounts)
      {
        for (const Range& range : getRanges(chunk, mergeCount))
        {
          Put(bytes, range);
        }
      }
    }
    return GetSum(bytes);
  }

  void AddRanges()
  {
    this->Out << "boxes "
              << this->SumRanges([&](std::size_t chunk, std::size_t merges) -> const Bounds&
                   { return this->File->GetChunkBounds(chunk, merges); })
              << "\n";
    for (std::size_t step = 0; step < this->File->GetNumberOfSteps(); ++step)
    {
      for (std::size_t array = 0; array < this->File->GetArrays().size(); ++array)
      {
        if (this->File->GetArrays()[array].Where == Association::Point)
        {
          this->Out << "step " << step << " array " << array << " ranges "
                    << this->SumRanges([&](std::size_t chunk, std::size_t merges)
                         { return this->File->GetChunkRanges(array, step, chunk, merges); })
                    << "\n";
        }
      }
    }
  }

  void AddMesh(std::size_t merges)
  {
    PieceRequest request;
    request.Chunks.resize(this->File->GetChunks().size());
    std::iota(request.Chunks.begin(), request.Chunks.end(), 0u);
    request.WithUnusedPoints = true;
    request.RestoreOrder = false;
    request.Merges = merges;
    request.Tree = this->Tree;
    request.Form = this->File->IsSurface() ? PieceForm::Original : PieceForm::Tetrahedra;
    PieceDecoder decoder(this->File);
    decoder.SetRequest(request);
    const auto points = static_cast<std::size_t>(decoder.GetNumberOfPoints());
    const auto cells = static_cast<std::size_t>(decoder.GetNumberOfCells());
    Bytes coordinates(3 * points * SizeOf(this->File->GetCoordinateType()));
    std::vector<std::int64_t> ids(static_cast<std::size_t>(decoder.GetConnectivitySize()));
    std::vector<std::int64_t> offsets(cells + 1);
    std::vector<std::uint8_t> types(cells);
    PieceTarget target;
    target.Points = coordinates.data();
    target.Connectivity = ids.data();
    const bool isSurface = this->File->IsSurface();
    target.Offsets = isSurface ? offsets.data() : nullptr;
    target.Types = isSurface ? types.data() : nullptr;
    decoder.Fill(target);
    for (std::size_t cell = cells; isSurface && cell > 0; --cell)
    {
      // In front of the corners of each cell, its type and their number.
      const std::int64_t before[] = { types[cell - 1], offsets[cell] - offsets[cell - 1] };
      ids.insert(ids.begin() + offsets[cell - 1], std::begin(before), std::end(before));
    }
    this->Out << "after " << merges << " points " << points << " " << GetSumOf(coordinates)
              << (isSurface ? " cells " : " tets ") << cells << " " << GetSumOf(ids) << "\n";
    for (std::size_t step = 0; step < this->File->GetNumberOfSteps(); ++step)
    {
      for (std::uint32_t a = 0; a < this->File->GetArrays().size(); ++a)
      {
        const auto& array = this->File->GetArrays()[a];
        Bytes values((array.Where == Association::Point ? points : cells) * array.Components *
          SizeOf(array.Type));
        request.Step = step;
        request.Arrays = { a };
        decoder.SetRequest(request);
        PieceTarget only;
        only.Arrays = { values.data() };
        decoder.Fill(only);
        this->Out << "after " << merges << " step " << step << " array " << a << " "
                  << GetSumOf(values) << "\n";
      }
    }
  }

  std::shared_ptr<const FileReader> File;
  std::shared_ptr<const MergeTree> Tree;
  std::vector<std::uint32_t> MergeCounts;
};

TEST(TreeGolden, FilesAreReadAsAnIndependentDecoderDoes)
{
  const auto expected = test::ReadExpectedLines("merges");
  EXPECT_GT(expected.size(), 10u);
  for (const auto& [name, lines] : expected)
  {
    const auto path = (test::GetGoldenFolder() / name).string();
    const auto file = std::make_shared<const FileReader>(path);
    EXPECT_TRUE(VerifyFile(*file)) << path;
    EXPECT_EQ(Description(file, name).Out.str(), lines);
  }
}
}
}
