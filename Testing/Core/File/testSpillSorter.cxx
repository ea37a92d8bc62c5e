// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSpillSorter.h"

#include "gatunFileSizeLimit.h"
#include "gatunHostile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>

namespace
{
using namespace gatun;
using namespace gatun::test;

struct Number
{
  std::uint32_t Value = 0;
  std::uint32_t Tag = 0;
  bool operator<(const Number& other) const { return this->Value < other.Value; }
};

std::vector<std::uint32_t> Take(SpillSorter<Number>& sorter)
{
  std::vector<std::uint32_t> values;
  for (; sorter.Get(); sorter.Next())
  {
    EXPECT_EQ(sorter.Get()->Tag, ~sorter.Get()->Value);
    values.push_back(sorter.Get()->Value);
  }
  return values;
}
}

TEST(SpillSorter, SortsWhateverFitsIntoMemory)
{
  const auto folder = std::filesystem::path(GetPath("x")).parent_path().string();
  std::mt19937 random(3);
  for (const std::size_t count : { 0, 1, 63, 64, 65, 5000, 100000 })
  {
    std::vector<std::uint32_t> all(count);
    std::generate(all.begin(), all.end(), [&] { return random() % 50000; });
    for (const std::size_t memory : { 0, 4000, 300000, 100000000 })
    {
      SpillSorter<Number> sorter(folder, memory);
      for (const auto value : all)
      {
        sorter.Add({ value, ~value });
      }
      sorter.Sort();
      auto sorted = all;
      std::sort(sorted.begin(), sorted.end());
      ASSERT_EQ(Take(sorter), sorted) << count << " records, " << memory << " bytes";
      const auto inMemory = std::max<std::size_t>(64, memory / sizeof(Number));
      EXPECT_EQ(sorter.GetSpilledBytes(), count <= inMemory ? 0 : count * sizeof(Number));
      EXPECT_TRUE(std::filesystem::is_empty(folder)) << "the file must not have a name";
    }
  }
}

TEST(SpillSorter, NamesTheFolderThatIsMissingOrFull)
{
  const auto fill = [](const std::string& folder)
  {
    SpillSorter<Number> sorter(folder, 0);
    for (std::uint32_t i = 0; i < 1000; ++i)
    {
      sorter.Add({ i, ~i });
    }
  };
  const auto missing = GetPath("missing");
  EXPECT_GATUN_SYSTEM_ERROR(ErrorCode::CannotWrite, missing, ENOENT, [&] { fill(missing); });
  const auto file = PutFile("file", { 1 });
  EXPECT_GATUN_SYSTEM_ERROR(ErrorCode::CannotWrite, file, ENOTDIR, [&] { fill(file); });
  const auto folder = std::filesystem::path(file).parent_path().string();
  const FileSizeLimit full(2000);
  EXPECT_GATUN_SYSTEM_ERROR(ErrorCode::CannotWrite, folder, EFBIG, [&] { fill(folder); });
}
