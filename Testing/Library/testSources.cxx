// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Bytes from elsewhere: sources, what is not here yet, plans, damaged files, errors.

#include "gatunBlock.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <random>
#include <thread>

namespace
{
using namespace gatun::test;

/** A file of which some bytes have come. Callbacks of gatun_source. */
struct Remote
{
  explicit Remote(const std::string& path)
    : Bytes(ReadBytes(path))
    , IsHere(Bytes.size(), 0)
  {
  }

  void Fetch(std::uint64_t offset, std::uint64_t length)
  {
    ASSERT_LE(offset + length, this->Bytes.size());
    ++this->Requests;
    for (auto i = offset; i < offset + length; ++i)
    {
      this->Fetched += !this->IsHere[i];
      this->IsHere[i] = 1;
    }
  }

  /** A request, unless all has been fetched. */
  void Need(std::uint64_t offset, std::uint64_t length)
  {
    const auto begin = this->IsHere.begin() + static_cast<std::ptrdiff_t>(offset);
    if (std::find(begin, begin + static_cast<std::ptrdiff_t>(length), 0) !=
      begin + static_cast<std::ptrdiff_t>(length))
    {
      this->Fetch(offset, length);
    }
  }

  gatun_source GetSource()
  {
    auto source = Make<gatun_source>();
    source.bytes = this->Bytes.size();
    source.user = this;
    source.name = "remote.gtn";
    source.read = [](void* user, std::uint64_t offset, void* to, std::size_t length)
    {
      auto& self = *static_cast<Remote*>(user);
      for (auto i = offset; i < offset + length; ++i)
      {
        if (!self.IsHere[i])
        {
          return static_cast<int>(GATUN_SOURCE_NOT_HERE);
        }
      }
      std::memcpy(to, self.Bytes.data() + offset, length);
      return 0;
    };
    source.close = [](void* user) { ++static_cast<Remote*>(user)->Closed; };
    return source;
  }

  /** Calls a function until its bytes have come; those that are missing are fetched. */
  template <typename Call>
  gatun_status Repeat(Call&& call)
  {
    for (;;)
    {
      const auto status = call();
      if (status != GATUN_NOT_HERE)
      {
        return status;
      }
      std::uint64_t offset = 0;
      std::uint64_t length = 0;
      EXPECT_EQ(gatun_error_place(&offset, &length, nullptr), 1);
      EXPECT_GT(length, 0u);
      this->Fetch(offset, length);
    }
  }

  std::vector<char> Bytes;
  std::vector<char> IsHere;
  std::uint64_t Fetched = 0;
  int Requests = 0;
  int Closed = 0;
};

/** Fetches what a request needs by its plan. Returns the number of rounds. */
int FetchPlan(Remote& remote, gatun_file* file, const gatun_request& request)
{
  for (int rounds = 1;; ++rounds)
  {
    std::vector<gatun_range> ranges(1000);
    std::size_t count = 0;
    const auto status = gatun_plan(file, &request, 4096, ranges.data(), ranges.size(), &count);
    EXPECT_TRUE(status == GATUN_OK || status == GATUN_NOT_HERE) << gatun_error();
    EXPECT_LE(count, ranges.size());
    for (std::size_t i = 0; i < count; ++i)
    {
      EXPECT_TRUE(i == 0 || ranges[i].offset > ranges[i - 1].offset + ranges[i - 1].length + 4096);
      remote.Fetch(ranges[i].offset, ranges[i].length);
    }
    if (status != GATUN_NOT_HERE)
    {
      return rounds;
    }
  }
}

std::string MakeLeveledFile(const std::string& name)
{
  const auto path = PathOf(name);
  auto options = Make<gatun_options>();
  options.chunk_size = 1000;
  options.keep_order = 7;
  options.boundary = 1;
  options.levels = 2;
  Block(30).Write(path, options);
  return path;
}

class LibrarySources : public ::testing::TestWithParam<int>
{
};

gatun_request MakeRequestOf(int kind)
{
  auto request = MakeRequest();
  switch (kind)
  {
    case 0:
      break;
    case 1:
      request.pieces = 7;
      request.piece = 2;
      break;
    case 2:
      request.pieces = 7;
      request.piece = 2;
      request.ghost_levels = 1;
      break;
    case 3:
      request.flags |= GATUN_IN_BOX;
      request.box[1] = request.box[3] = request.box[5] = 0.2;
      break;
    case 4:
      request.flags |= GATUN_IN_RANGE;
      request.range_component = -1;
      request.range[0] = 5;
      request.range[1] = 9;
      break;
    default:
      request.ratio = 0.5;
  }
  return request;
}

TEST_P(LibrarySources, ReadWhatIsPlannedOnly)
{
  const auto path = MakeLeveledFile("planned" + std::to_string(GetParam()) + ".gtn");
  const auto request = MakeRequestOf(GetParam());
  Remote remote(path);
  const auto source = remote.GetSource();
  gatun_file* file = nullptr;
  ASSERT_OK(remote.Repeat([&] { return gatun_open_source(&source, 0, &file); }));
  EXPECT_LT(remote.Fetched, remote.Bytes.size() / 2);
  const int rounds = FetchPlan(remote, file, request);
  // Pages of tables, and the plan; for values the pages with their ranges before, and for a ratio
  // the header and the tables of a level, and its merges.
  const std::array<int, 6> most{ 2, 2, 2, 2, 3, 6 };
  EXPECT_LE(rounds, most[static_cast<std::size_t>(GetParam())]);
  const int requests = remote.Requests;
  const auto piece = ReadPiece(file, request);
  EXPECT_EQ(remote.Requests, requests);
  const OpenedFile local(path);
  EXPECT_EQ(piece, ReadPiece(local, request));
  EXPECT_FALSE(piece.Cells.empty());
  if (GetParam() == 1 || GetParam() == 3)
  {
    EXPECT_LT(remote.Fetched, remote.Bytes.size() / 2);
  }
  const int before = remote.Closed;
  gatun_close(file);
  EXPECT_EQ(remote.Closed, before + 1);
}

INSTANTIATE_TEST_SUITE_P(Requests, LibrarySources, ::testing::Range(0, 6));

/** A file with time steps of noise, which makes them long, a boundary and a coarser mesh. */
std::string MakeStepsFile(int steps)
{
  const auto path = PathOf("steps" + std::to_string(steps) + ".gtn");
  Block block(20);
  auto options = Make<gatun_options>();
  options.levels = 1;
  options.boundary = 1;
  const auto mesh = block.GetMesh();
  const auto arrays = block.GetArrays();
  gatun_writer* writer = nullptr;
  EXPECT_OK(gatun_create(
    path.c_str(), &mesh, arrays.data(), arrays.size(), &options, nullptr, nullptr, &writer));
  std::mt19937_64 random;
  for (int step = 0; step < steps; ++step)
  {
    for (double& value : block.Field)
    {
      value = static_cast<double>(random());
    }
    const std::array<gatun_buffer, 2> buffers{ BufferOf(block.Field), BufferOf(block.Numbers) };
    auto values = Make<gatun_values>();
    values.arrays = buffers.data();
    values.array_count = buffers.size();
    values.has_time = 1;
    values.time = step;
    EXPECT_OK(gatun_write_step(writer, &values, nullptr, nullptr));
  }
  EXPECT_OK(gatun_finish(writer, nullptr));
  return path;
}

/** A source with fetch, as one on a web server: each range is a request. */
gatun_source GetServer(Remote& remote)
{
  auto source = remote.GetSource();
  source.read = [](void* user, std::uint64_t offset, void* to, std::size_t length)
  {
    auto& self = *static_cast<Remote*>(user);
    self.Need(offset, length);
    std::memcpy(to, self.Bytes.data() + offset, length);
    return 0;
  };
  source.fetch = [](void* user, const gatun_range* ranges, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      EXPECT_TRUE(i == 0 || ranges[i].offset > ranges[i - 1].offset + ranges[i - 1].length);
      static_cast<Remote*>(user)->Need(ranges[i].offset, ranges[i].length);
    }
    return 0;
  };
  return source;
}

TEST(LibrarySource, NeedsNoMoreRequestsForMoreSteps)
{
  const std::map<int, std::string> paths{ { 20, MakeStepsFile(20) }, { 50, MakeStepsFile(50) } };
  const auto count = [&](int steps, auto&& open)
  {
    Remote remote(paths.at(steps));
    gatun_file* file = open(remote);
    auto info = Make<gatun_info>();
    EXPECT_OK(gatun_get_info(file, &info));
    EXPECT_EQ(info.steps, static_cast<std::uint32_t>(steps));
    EXPECT_EQ(info.levels, 1u);
    gatun_close(file);
    EXPECT_LT(remote.Fetched, remote.Bytes.size() / 2);
    return remote.Requests;
  };
  const auto describe = [](Remote& remote)
  {
    const auto source = GetServer(remote);
    gatun_file* file = nullptr;
    EXPECT_OK(gatun_open_source(&source, 0, &file));
    std::size_t length = 0;
    EXPECT_OK(gatun_describe(file, 0, nullptr, 0, &length));
    return file;
  };
  const auto open = [](Remote& remote)
  {
    const auto source = remote.GetSource();
    gatun_file* file = nullptr;
    EXPECT_OK(remote.Repeat([&] { return gatun_open_source(&source, 0, &file); }));
    return file;
  };
  // Both ends of the file and of each mesh in it, the tables, the summary and the pages.
  EXPECT_LE(count(20, describe), 9);
  EXPECT_EQ(count(50, describe), count(20, describe));
  EXPECT_EQ(count(50, open), count(20, open));
}

TEST(LibrarySource, TellsThatFetchingFails)
{
  Remote remote(MakeLeveledFile("fetch.gtn"));
  auto source = GetServer(remote);
  source.fetch = [](void*, const gatun_range*, std::size_t) { return EIO; };
  gatun_file* file = nullptr;
  EXPECT_EQ(gatun_open_source(&source, 0, &file), GATUN_CANNOT_OPEN);
  EXPECT_EQ(std::string(gatun_error()).substr(0, 11), "remote.gtn:");
  source.fetch = [](void*, const gatun_range*, std::size_t)
  { return static_cast<int>(GATUN_SOURCE_NOT_HERE); };
  ASSERT_OK(gatun_open_source(&source, 0, &file)); // read has it
  gatun_close(file);
}

TEST(LibrarySource, IsClosedIfTheFileCannotBeOpened)
{
  Remote remote(MakeLeveledFile("closed.gtn"));
  remote.Bytes.resize(100);
  remote.IsHere.assign(100, 1);
  const auto source = remote.GetSource();
  gatun_file* file = nullptr;
  EXPECT_EQ(gatun_open_source(&source, 0, &file), GATUN_TRUNCATED);
  EXPECT_EQ(std::string(gatun_error()).substr(0, 11), "remote.gtn:");
  EXPECT_EQ(remote.Closed, 1);
  EXPECT_EQ(file, nullptr);
}

TEST(LibrarySource, TellsWhereAFileIsDamaged)
{
  const auto path = MakeLeveledFile("damaged.gtn");
  const auto bytes = ReadBytes(path);
  std::size_t failed = 0;
  for (std::size_t at = 0; at < bytes.size(); at += bytes.size() / 97)
  {
    Remote remote(path);
    remote.IsHere.assign(bytes.size(), 1);
    remote.Bytes[at] = static_cast<char>(remote.Bytes[at] ^ 0x11);
    const auto source = remote.GetSource();
    gatun_file* file = nullptr;
    auto status = gatun_open_source(&source, 0, &file);
    if (status == GATUN_OK)
    {
      status = gatun_verify(file, nullptr, nullptr);
    }
    ASSERT_NE(status, GATUN_OK) << at;
    EXPECT_TRUE(status == GATUN_CORRUPT || status == GATUN_NOT_GATUN ||
      status == GATUN_UNSUPPORTED_VERSION || status == GATUN_TRUNCATED)
      << gatun_error();
    failed += gatun_error_place(nullptr, nullptr, nullptr);
    gatun_close(file);
  }
  EXPECT_GT(failed, 80u);
}

TEST(LibrarySource, ServesManyThreads)
{
  const auto path = MakeLeveledFile("threads.gtn");
  const OpenedFile file(path);
  const auto whole = ReadPiece(file, MakeRequest());
  std::vector<std::thread> threads;
  std::array<bool, 4> same{};
  for (std::size_t i = 0; i < same.size(); ++i)
  {
    threads.emplace_back(
      [&, i]
      {
        same[i] = ReadPiece(file, MakeRequest()) == whole;
        gatun_error_place(nullptr, nullptr, nullptr);
      });
  }
  for (auto& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(same, (std::array<bool, 4>{ true, true, true, true }));
}

TEST(LibraryErrors, NameFileAndSystemError)
{
  gatun_file* file = nullptr;
  EXPECT_EQ(gatun_open(PathOf("missing.gtn").c_str(), 0, &file), GATUN_CANNOT_OPEN);
  int error = 0;
  EXPECT_EQ(gatun_error_place(nullptr, nullptr, &error), 0);
  EXPECT_EQ(error, ENOENT);
  EXPECT_NE(std::string(gatun_error()).find("missing.gtn"), std::string::npos);
  EXPECT_EQ(gatun_open(GATUN_TEST_TEMP, 0, &file), GATUN_CANNOT_OPEN);
  EXPECT_EQ(gatun_kind_of(PathOf("missing.gtn").c_str()), GATUN_KIND_NONE);
  EXPECT_EQ(file, nullptr);
}

TEST(LibraryErrors, RefuseWhatIsWrong)
{
  const OpenedFile file(MakeLeveledFile("wrong.gtn"));
  auto sizes = Make<gatun_sizes>();
  gatun_piece* piece = nullptr;
  const auto refuse = [&](const gatun_request& request)
  {
    EXPECT_EQ(gatun_prepare(file, &request, &sizes, nullptr, nullptr, &piece), GATUN_INVALID_INPUT);
  };
  auto request = MakeRequest();
  request.step = 1;
  refuse(request);
  request = MakeRequest();
  request.piece = 1;
  refuse(request);
  request = MakeRequest();
  request.level = 99;
  refuse(request);
  request = MakeRequest();
  request.ratio = 1.5;
  refuse(request);
  request = MakeRequest();
  request.array_count = 1;
  request.arrays = nullptr;
  refuse(request);
  request = MakeRequest();
  request.size = 0;
  refuse(request);
  request = MakeRequest();
  request.flags |= GATUN_IN_RANGE;
  request.range_array = 7;
  refuse(request);
  EXPECT_EQ(
    gatun_prepare(nullptr, &request, &sizes, nullptr, nullptr, &piece), GATUN_INVALID_INPUT);
  EXPECT_EQ(piece, nullptr);

  request = MakeRequest();
  ASSERT_OK(gatun_prepare(file, &request, &sizes, nullptr, nullptr, &piece));
  std::vector<double> points(3 * sizes.points - 1, 7);
  auto buffers = Make<gatun_buffers>();
  buffers.points = BufferOf(points);
  EXPECT_EQ(gatun_read(piece, &buffers, nullptr, nullptr), GATUN_INVALID_INPUT);
  EXPECT_EQ(points, std::vector<double>(points.size(), 7));
  const auto stop = [](double, void*) { return 0; };
  points.push_back(7);
  buffers.points = BufferOf(points);
  EXPECT_EQ(gatun_read(piece, &buffers, stop, nullptr), GATUN_ABORTED);
  EXPECT_OK(gatun_read(piece, &buffers, nullptr, nullptr));
  gatun_end(piece);
}

TEST(LibraryErrors, OlderAndNewerStructures)
{
  const OpenedFile file(MakeLeveledFile("structures.gtn"));
  auto whole = Make<gatun_info>();
  ASSERT_OK(gatun_get_info(file, &whole));
  gatun_info older{};
  older.size = offsetof(gatun_info, tets);
  older.tets = 17;
  ASSERT_OK(gatun_get_info(file, &older));
  EXPECT_EQ(older.cells, whole.cells);
  EXPECT_EQ(older.tets, 17u); // not known then
  EXPECT_EQ(older.size, offsetof(gatun_info, tets));
  struct
  {
    gatun_info Info;
    std::uint64_t Later;
  } newer{};
  newer.Info.size = sizeof(newer);
  newer.Later = 18;
  ASSERT_OK(gatun_get_info(file, &newer.Info));
  EXPECT_EQ(newer.Info.bytes_read > 0, true);
  EXPECT_EQ(newer.Later, 18u);
}
}
