// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files with valid checksums and invalid base meshes.

#include "gatunHostileTrees.h"

#include <cstring>

namespace
{
using namespace gatun;
using namespace gatun::test;

/** Changes a base mesh of a good file and expects that opening and verifying it fail like this. Its
 * name stands behind that of the file. */
void ExpectLevelRefused(const std::string& what, const Bytes& bytes)
{
  auto image = GetGoodImage();
  image.Levels[1] = bytes;
  const auto path = PutFile("changed.gtn", image.Build());
  const auto name = path + ", base mesh 2";
  EXPECT_GATUN_ERROR(ErrorCode::Corrupt, name, what, [&] { FileReader(path).OpenLevel(1); });
  EXPECT_GATUN_ERROR(ErrorCode::Corrupt, name, what, [&] { VerifyFile(FileReader(path)); });
  // The rest of the file is not affected.
  EXPECT_NO_THROW(FileReader(path).OpenLevel(0));
}

const std::string NotWhatIsLeft = "it is not what is left of the mesh after its merges";

TEST(HostileBaseMeshes, BaseMeshesMustBeAsManyAsTheTreeSays)
{
  const std::string number = "there are not as many base meshes as the file says";
  const std::string ascend = "numbers of merges do not ascend";
  ExpectRefused(number, [](TreeImage& f) { f.Levels.pop_back(); });
  ExpectRefused(number, [](TreeImage& f) { f.Levels.push_back(f.Levels.back()); });
  ExpectRefused("there are not as many parts of the merges as meshes",
    [](TreeImage& f) { f.Tree.Levels.clear(); });
  ExpectRefused("the merges of its tree are missing", [](TreeImage& f) { f.Tree.Parts.clear(); });
  ExpectRefused(ascend, [](TreeImage& f) { f.Tree.Levels[0] = 0; });
  ExpectRefused(ascend, [](TreeImage& f) { f.Tree.Levels[1] = f.Tree.Levels[0]; });
  ExpectRefused(ascend, [](TreeImage& f) { f.Tree.Levels[1] = f.Tree.Merges + 1; });
}

TEST(HostileBaseMeshes, ABaseMeshMustBeAFile)
{
  const auto& good = GetGoodImage().Levels[1];
  ExpectLevelRefused("the file is empty", {});
  ExpectLevelRefused("this is not a .gtn file", Bytes(1000, 0));
  auto bytes = good;
  bytes[20] ^= 1; // only verifying looks at the headers of sections
  auto image = GetGoodImage();
  image.Levels[1] = bytes;
  const auto path = PutFile("changed.gtn", image.Build());
  EXPECT_NO_THROW(ReadTree(path));
  EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path + ", base mesh 2", "the header of section",
    [&] { VerifyFile(FileReader(path)); });
  bytes = good;
  bytes[bytes.size() - TrailerSize - 1] ^= 1;
  ExpectLevelRefused("the directory", bytes);
}

TEST(HostileBaseMeshes, ABaseMeshMustBeWhatIsLeft)
{
  const auto& good = GetGoodImage();
  const auto sample = MakeTreeSample(3, Steps);
  WriterOptions options;
  options.ChunkSize = 64;
  const auto path = GetPath("level.gtn");
  const auto merges = good.Tree.Levels[1];
  const auto expectRefused = [&](const TreeSample& other, std::uint32_t after)
  { ExpectLevelRefused(NotWhatIsLeft, MakeLevel(path, other, options, after)); };

  auto right = good;
  right.Levels[1] = MakeLevel(path, sample, options, merges);
  const auto rightPath = PutFile("right.gtn", right.Build());
  EXPECT_TRUE(VerifyFile(FileReader(rightPath)));

  ExpectLevelRefused(NotWhatIsLeft, good.Levels[0]); // another level
  expectRefused(sample, merges - 1);
  auto other = sample;
  other.CoordinateType = ScalarType::Float32;
  expectRefused(other, merges);
  other = sample;
  other.Arrays[0].Name = "other";
  expectRefused(other, merges);
  other = sample;
  other.Arrays[1].Where = Association::Point;
  other.Steps.clear();
  expectRefused(other, merges);
  other = sample;
  other.Steps.pop_back();
  expectRefused(other, merges);
  other = sample;
  other.HasTime = false;
  other.Steps.pop_back();
  expectRefused(other, merges);
  other = sample; // fewer merges behind
  auto fewer = sample.Tree.GetMerges();
  fewer.pop_back();
  other.Tree = MergeTree(static_cast<std::uint32_t>(sample.GetPoints()), std::move(fewer));
  expectRefused(other, merges);

  // No tree, base meshes of its own, the whole file itself, times that differ.
  auto level = TreeImage(PutFile("level.gtn", good.Levels[1]));
  level.TreeName = MakeFourCC("NONE");
  ExpectLevelRefused(NotWhatIsLeft, level.Build());
  level.TreeName = SectionTree;
  level.Tree.Levels = { 1 };
  level.Levels = { good.Levels[1] };
  ExpectLevelRefused(NotWhatIsLeft, level.Build());
  ExpectLevelRefused(NotWhatIsLeft, good.Build());
  FileImage moved(PutFile("level.gtn", good.Levels[1]));
  moved.Steps[1].Time += 1;
  ExpectLevelRefused(NotWhatIsLeft, moved.Build());
}

/** Writes another place and length of the last section into the directory. */
Bytes PointLastSectionTo(Bytes file, std::uint64_t offset, std::uint64_t length)
{
  const auto directoryEnd = file.size() - TrailerSize;
  std::memcpy(file.data() + directoryEnd - 8, &offset, sizeof(offset));
  std::memcpy(file.data() + directoryEnd - 24, &length, sizeof(length));
  std::uint64_t start = 0;
  std::memcpy(&start, file.data() + directoryEnd, sizeof(start));
  Bytes vouched(file.begin(), file.begin() + HeaderSize);
  vouched.insert(vouched.end(), file.begin() + static_cast<std::ptrdiff_t>(start),
    file.begin() + static_cast<std::ptrdiff_t>(directoryEnd));
  const auto sum = Checksum(vouched);
  std::memcpy(file.data() + directoryEnd + 16, &sum, sizeof(sum));
  return file;
}

TEST(HostileBaseMeshes, ABaseMeshCannotBeElsewhereOrTheFileItself)
{
  const auto good = GetGoodImage().Build();
  const auto size = static_cast<std::uint64_t>(good.size());
  const auto open = [](const std::string& path) { return [=] { FileReader(path).OpenLevel(1); }; };
  const auto verify = [](const std::string& path) { return [=] { VerifyFile(FileReader(path)); }; };

  auto path = PutFile("itself.gtn", PointLastSectionTo(good, 0, size));
  EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path + ", base mesh 2", NotWhatIsLeft, open(path));
  EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path, "section 'LEVL' does not follow", verify(path));
  path = PutFile("start.gtn", PointLastSectionTo(good, 0, 1000));
  EXPECT_GATUN_ERROR(ErrorCode::Truncated, path + ", base mesh 2", "does not end", open(path));
  for (const auto& [offset, length] :
    { std::pair{ size, std::uint64_t{ 1 } }, std::pair{ size - 9, std::uint64_t{ 10 } },
      std::pair{ ~std::uint64_t{ 0 }, std::uint64_t{ 100 } },
      std::pair{ std::uint64_t{ 100 }, ~std::uint64_t{ 0 } } })
  {
    path = PutFile("outside.gtn", PointLastSectionTo(good, offset, length));
    EXPECT_GATUN_ERROR(
      ErrorCode::Truncated, path, "base mesh 2 at byte " + std::to_string(offset), open(path));
    EXPECT_GATUN_ERROR(ErrorCode::Corrupt, path, "section 'LEVL'", verify(path));
  }
}
}
