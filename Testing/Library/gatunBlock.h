// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBlock_h
#define gatunBlock_h

// A block of cubes, each of six tetrahedra, and helpers around the C interface.

#include "gatun.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace gatun::test
{
#define EXPECT_OK(call) EXPECT_EQ((call), GATUN_OK) << gatun_error()
#define ASSERT_OK(call) ASSERT_EQ((call), GATUN_OK) << gatun_error()

template <typename T>
T Make()
{
  T made{};
  made.size = sizeof(T);
  return made;
}

template <typename T>
gatun_buffer BufferOf(std::vector<T>& values)
{
  return { values.data(), values.size() * sizeof(T) };
}

/** A file in a folder of these tests, because others run at the same time. */
inline std::string PathOf(const std::string& name)
{
  const auto folder = std::filesystem::path(GATUN_TEST_TEMP) / "library";
  std::filesystem::create_directories(folder);
  return (folder / name).string();
}

inline std::vector<char> ReadBytes(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>() };
}

/** The cube from 0 to 1 in count^3 cubes, with the field x + 2 y + 3 z at its points. */
struct Block
{
  explicit Block(int count)
  {
    const int side = count + 1;
    for (int i = 0; i < side * side * side; ++i)
    {
      const double x = static_cast<double>(i % side) / count;
      const double y = static_cast<double>(i / side % side) / count;
      const double z = static_cast<double>(i / side / side) / count;
      this->Points.insert(this->Points.end(), { x, y, z });
      this->Field.push_back(x + 2 * y + 3 * z);
    }
    constexpr int paths[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 1, 0, 2 }, { 0, 2, 1 },
      { 2, 1, 0 } };
    const std::array<std::int64_t, 3> steps{ 1, side, side * side };
    for (int cube = 0; cube < count * count * count; ++cube)
    {
      const std::int64_t first =
        cube % count + cube / count % count * steps[1] + cube / count / count * steps[2];
      for (int p = 0; p < 6; ++p)
      {
        const auto a = first + steps[paths[p][0]];
        const auto b = a + steps[paths[p][1]];
        const auto c = b + steps[paths[p][2]];
        if (p < 3)
        {
          this->Cells.insert(this->Cells.end(), { first, a, b, c });
        }
        else
        {
          this->Cells.insert(this->Cells.end(), { first, b, a, c });
        }
        this->Numbers.push_back(static_cast<std::int32_t>(this->Numbers.size()));
      }
    }
  }

  gatun_mesh GetMesh() const
  {
    auto mesh = Make<gatun_mesh>();
    mesh.points = this->Points.size() / 3;
    mesh.cells = this->Cells.size() / 4;
    mesh.coordinate_type = GATUN_FLOAT64;
    mesh.wide_ids = 1;
    mesh.coordinates = this->Points.data();
    mesh.connectivity = this->Cells.data();
    return mesh;
  }

  /** Descriptions of the field and of the numbers of the cells. */
  std::array<gatun_array, 2> GetArrays() const
  {
    auto field = Make<gatun_array>();
    field.name = "field";
    field.type = GATUN_FLOAT64;
    field.components = 1;
    field.values = this->Field.data();
    auto number = Make<gatun_array>();
    number.name = "number";
    number.is_cell = 1;
    number.type = GATUN_INT32;
    number.components = 1;
    return { field, number };
  }

  void Write(const std::string& path, const gatun_options& options)
  {
    const auto mesh = this->GetMesh();
    const auto arrays = this->GetArrays();
    gatun_writer* writer = nullptr;
    ASSERT_OK(gatun_create(
      path.c_str(), &mesh, arrays.data(), arrays.size(), &options, nullptr, nullptr, &writer));
    const std::array<gatun_buffer, 2> values{ BufferOf(this->Field), BufferOf(this->Numbers) };
    auto step = Make<gatun_values>();
    step.arrays = values.data();
    step.array_count = values.size();
    ASSERT_OK(gatun_write_step(writer, &step, nullptr, nullptr));
    std::uint64_t bytes = 0;
    ASSERT_OK(gatun_finish(writer, &bytes));
    EXPECT_EQ(bytes, std::filesystem::file_size(path));
  }

  std::vector<double> Points;
  std::vector<std::int64_t> Cells;
  std::vector<double> Field;
  std::vector<std::int32_t> Numbers; // of the cells
};

/** What a piece of a block holds. */
struct BlockPiece
{
  gatun_sizes Sizes{};
  std::vector<double> Points;
  std::vector<std::int64_t> Cells;
  std::vector<double> Field;
  std::vector<std::int32_t> Numbers;
  std::vector<float> Normals;

  /** Reads a prepared piece with both arrays. */
  void Read(gatun_piece* piece, const gatun_sizes& sizes, bool normals = false)
  {
    this->Sizes = sizes;
    this->Points.resize(3 * sizes.points);
    this->Cells.resize(sizes.connectivity);
    this->Field.resize(sizes.points);
    this->Numbers.resize(sizes.cells);
    this->Normals.resize(normals ? 3 * sizes.points : 0);
    const std::array<gatun_buffer, 2> arrays{ BufferOf(this->Field), BufferOf(this->Numbers) };
    auto to = Make<gatun_buffers>();
    to.points = BufferOf(this->Points);
    to.connectivity = BufferOf(this->Cells);
    to.normals = BufferOf(this->Normals);
    to.wide_ids = 1;
    to.arrays = arrays.data();
    to.array_count = arrays.size();
    EXPECT_OK(gatun_read(piece, &to, nullptr, nullptr));
    gatun_end(piece);
  }

  bool operator==(const BlockPiece& other) const
  {
    return this->Points == other.Points && this->Cells == other.Cells &&
      this->Field == other.Field && this->Numbers == other.Numbers;
  }
};

inline const std::uint32_t BothArrays[] = { 0, 1 };

inline gatun_request MakeRequest()
{
  auto request = Make<gatun_request>();
  request.flags = GATUN_RESTORE_ORDER | GATUN_UNUSED_POINTS;
  request.arrays = BothArrays;
  request.array_count = 2;
  return request;
}

inline BlockPiece ReadPiece(gatun_file* file, const gatun_request& request)
{
  BlockPiece read;
  auto sizes = Make<gatun_sizes>();
  gatun_piece* piece = nullptr;
  EXPECT_OK(gatun_prepare(file, &request, &sizes, nullptr, nullptr, &piece));
  if (piece)
  {
    read.Read(piece, sizes);
  }
  return read;
}

/** An open file that closes itself. */
struct OpenedFile
{
  explicit OpenedFile(const std::string& path)
  {
    EXPECT_OK(gatun_open(path.c_str(), 0, &this->File));
  }
  ~OpenedFile() { gatun_close(this->File); }
  OpenedFile(const OpenedFile&) = delete;
  OpenedFile& operator=(const OpenedFile&) = delete;
  operator gatun_file*() const { return this->File; }

  gatun_file* File = nullptr;
};
}

#endif
