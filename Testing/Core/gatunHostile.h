// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHostile_h
#define gatunHostile_h

// Helpers of the tests of damaged files and unusual paths.

#include "gatunError.h"
#include "gatunFileImage.h"
#include "gatunFileReader.h"
#include "gatunPieceDecoder.h"
#include "gatunSampleFile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace gatun::test
{
/** A path in a folder of the running test's own, which is made empty at the first call. */
inline std::string GetPath(const std::string& name)
{
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(GATUN_TEST_TEMP) /
    (std::string(test->test_suite_name()) + "." + test->name());
  static std::string last;
  if (last != folder)
  {
    last = folder;
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  return (folder / name).string();
}

/** Names of the files next to a path, the path itself included. */
inline std::vector<std::string> ListFolder(const std::string& path)
{
  std::vector<std::string> names;
  for (const auto& entry :
    std::filesystem::directory_iterator(std::filesystem::path(path).parent_path()))
  {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/** A file of several chunks with shared points, kept order, and three time steps. */
inline FileImage MakeImage()
{
  const auto path = GetPath("sample.gtn");
  WriterOptions options;
  options.ChunkSize = 64;
  options.Keep = KeepAll;
  WriteSample(path, MakeCubes(3, 0.2), options, 3);
  return FileImage(path);
}

inline std::string PutFile(const std::string& name, const Bytes& bytes)
{
  const auto path = GetPath(name);
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out.write(
    reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return path;
}

/** Decodes all of a file, as a program would that shows it whole. */
inline void ReadAll(const std::string& path)
{
  const auto file = std::make_shared<FileReader>(path);
  PieceRequest request;
  request.Chunks.resize(file->GetChunks().size());
  std::iota(request.Chunks.begin(), request.Chunks.end(), 0u);
  request.WithUnusedPoints = true;
  if (file->GetNumberOfSteps() > 0)
  {
    request.Arrays.resize(file->GetArrays().size());
    std::iota(request.Arrays.begin(), request.Arrays.end(), 0u);
    request.Step = file->GetNumberOfSteps() - 1;
    file->GetFieldData(request.Step);
  }
  PieceDecoder decoder(file);
  decoder.SetRequest(request);
  const auto points = static_cast<std::size_t>(decoder.GetNumberOfPoints());
  const auto tets = static_cast<std::size_t>(decoder.GetNumberOfCells());
  std::vector<double> coordinates(3 * points);
  std::vector<std::int64_t> connectivity(4 * tets);
  std::vector<std::vector<std::uint8_t>> values;
  PieceTarget target;
  target.Points = coordinates.data();
  target.Connectivity = connectivity.data();
  for (const auto a : request.Arrays)
  {
    const auto& array = file->GetArrays()[a];
    values.emplace_back(
      (array.Where == Association::Point ? points : tets) * array.Components * SizeOf(array.Type));
    target.Arrays.push_back(values.back().data());
  }
  decoder.Fill(target);
}

/** Runs something that must fail with an error that names the file. path: the beginning of the
 * message, a file or a file and an embedded one. what: part of the message. */
template <typename Run>
void ExpectError(ErrorCode code, const std::string& path, const std::string& what, Run&& run,
  const char* where, std::optional<int> systemError = {})
{
  try
  {
    run();
    ADD_FAILURE() << where << ": no error, but expected: " << what;
  }
  catch (const Error& error)
  {
    const std::string message = error.what();
    EXPECT_EQ(static_cast<int>(error.Code), static_cast<int>(code)) << where << ": " << message;
    EXPECT_EQ(error.SystemError, systemError.value_or(error.SystemError))
      << where << ": " << message;
    EXPECT_EQ(error.Path, path.substr(0, path.find(", "))) << where << ": " << message;
    EXPECT_EQ(message.find(path + ": "), 0u) << where << ": " << message;
    EXPECT_NE(message.find(what), std::string::npos) << where << ": " << message;
  }
}

#define EXPECT_GATUN_ERROR(code, path, what, run) \
  ::gatun::test::ExpectError(code, path, what, run, __FILE__)

/** The same for a system call that fails with a value of errno. */
#define EXPECT_GATUN_SYSTEM_ERROR(code, path, systemError, run) \
  ::gatun::test::ExpectError(code, path, {}, run, __FILE__, systemError)
}

#endif
