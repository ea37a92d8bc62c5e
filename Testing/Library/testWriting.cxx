// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Writing through the C interface, and reading it again.

#include "gatunBlock.h"

#include <cmath>
#include <cstring>

namespace
{
using namespace gatun::test;

gatun_values MakeStep(const std::array<gatun_buffer, 2>& arrays, double time)
{
  auto step = Make<gatun_values>();
  step.arrays = arrays.data();
  step.array_count = arrays.size();
  step.has_time = 1;
  step.time = time;
  return step;
}

TEST(LibraryWriting, StepsWithFieldsAndKeys)
{
  const auto path = PathOf("steps.gtn");
  Block block(5);
  auto mesh = block.GetMesh();
  auto descriptions = block.GetArrays();
  auto key = Make<gatun_key>();
  key.location = "vtkDataArray";
  key.name = "UNITS_LABEL";
  key.kind = 5; // a text
  key.count = 1;
  const char* const unit = "m/s";
  key.texts = &unit;
  descriptions[0].keys = &key;
  descriptions[0].key_count = 1;
  const char* const component = "speed";
  descriptions[0].component_names = &component;
  auto options = Make<gatun_options>();
  options.keep_order = GATUN_KEEP_POINTS | GATUN_KEEP_CELLS | GATUN_KEEP_CORNERS;
  options.points_move = 1;
  gatun_writer* writer = nullptr;
  ASSERT_OK(
    gatun_create(path.c_str(), &mesh, descriptions.data(), 2, &options, nullptr, nullptr, &writer));
  std::vector<std::vector<double>> points;
  std::vector<std::vector<double>> fields;
  for (int i = 0; i < 4; ++i)
  {
    points.push_back(block.Points);
    fields.push_back(block.Field);
    for (auto& value : points.back())
    {
      value += 0.125 * i * value;
    }
    for (auto& value : fields.back())
    {
      value = std::sin(value + i);
    }
    const std::array<gatun_buffer, 2> arrays{ BufferOf(fields.back()), BufferOf(block.Numbers) };
    auto step = MakeStep(arrays, 0.5 * i);
    const auto coordinates = BufferOf(points.back());
    step.coordinates = i > 0 ? &coordinates : nullptr;
    auto number = Make<gatun_field>();
    number.name = "iteration";
    number.type = GATUN_INT32;
    number.count = 1;
    const std::int32_t iteration = 100 * i;
    number.values = &iteration;
    auto text = Make<gatun_field>();
    text.name = "log";
    text.count = 2;
    const char* const lines[] = { "a\0b", "" };
    const std::uint64_t lengths[] = { 3, 0 };
    text.texts = lines;
    text.text_bytes = lengths;
    const gatun_field both[] = { number, text };
    step.fields = both;
    step.field_count = 2;
    ASSERT_OK(gatun_write_step(writer, &step, nullptr, nullptr));
  }
  ASSERT_OK(gatun_finish(writer, nullptr));

  const OpenedFile file(path);
  auto info = Make<gatun_info>();
  ASSERT_OK(gatun_get_info(file, &info));
  EXPECT_EQ(info.steps, 4u);
  EXPECT_TRUE(info.points_move);
  auto array = Make<gatun_array>();
  ASSERT_OK(gatun_get_array(file, 0, &array));
  ASSERT_EQ(array.key_count, 1u);
  EXPECT_STREQ(array.keys[0].texts[0], "m/s");
  EXPECT_STREQ(array.component_names[0], "speed");
  EXPECT_EQ(gatun_get_array(file, 2, &array), GATUN_INVALID_INPUT);
  ASSERT_OK(gatun_get_array(file, GATUN_POINT_ARRAY, &array));
  EXPECT_STREQ(array.name, "Points");
  for (int i = 3; i >= 0; --i)
  {
    auto request = MakeRequest();
    request.step = static_cast<std::uint64_t>(i);
    const auto piece = ReadPiece(file, request);
    EXPECT_EQ(piece.Points, points[static_cast<std::size_t>(i)]);
    EXPECT_EQ(piece.Field, fields[static_cast<std::size_t>(i)]);
    EXPECT_EQ(piece.Cells, block.Cells);
    auto step = Make<gatun_step>();
    ASSERT_OK(gatun_get_step(file, request.step, &step));
    EXPECT_EQ(step.time, 0.5 * i);
    EXPECT_EQ(step.bounds[1], 1 + 0.125 * i);
    gatun_fields* list = nullptr;
    std::uint32_t count = 0;
    ASSERT_OK(gatun_get_fields(file, request.step, &list, &count));
    ASSERT_EQ(count, 2u);
    auto field = Make<gatun_field>();
    ASSERT_OK(gatun_get_field(list, 0, &field));
    EXPECT_EQ(*static_cast<const std::int32_t*>(field.values), 100 * i);
    ASSERT_OK(gatun_get_field(list, 1, &field));
    ASSERT_EQ(field.count, 2u);
    EXPECT_EQ(field.text_bytes[0], 3u);
    EXPECT_EQ(std::memcmp(field.texts[0], "a\0b", 4), 0);
    EXPECT_EQ(gatun_get_field(list, 2, &field), GATUN_INVALID_INPUT);
    gatun_free_fields(list);
  }
}

TEST(LibraryWriting, AppendsStepsWithTheSameMeshOnce)
{
  const auto path = PathOf("append.gtn");
  Block block(12);
  const auto mesh = block.GetMesh();
  const auto descriptions = block.GetArrays();
  auto options = Make<gatun_options>();
  options.keep_order = 7;
  const std::array<gatun_buffer, 2> arrays{ BufferOf(block.Field), BufferOf(block.Numbers) };
  gatun_writer* writer = nullptr;
  ASSERT_OK(
    gatun_create(path.c_str(), &mesh, descriptions.data(), 2, &options, nullptr, nullptr, &writer));
  auto step = MakeStep(arrays, 0);
  ASSERT_OK(gatun_write_step(writer, &step, nullptr, nullptr));
  std::uint64_t first = 0;
  ASSERT_OK(gatun_finish(writer, &first));
  for (int i = 1; i < 4; ++i)
  {
    ASSERT_OK(gatun_append(path.c_str(), nullptr, 0, nullptr, &writer));
    ASSERT_OK(gatun_add_mesh(writer, &mesh, nullptr, nullptr, nullptr, nullptr));
    step = MakeStep(arrays, i);
    ASSERT_OK(gatun_write_step(writer, &step, nullptr, nullptr));
    std::uint64_t bytes = 0;
    ASSERT_OK(gatun_finish(writer, &bytes));
    EXPECT_LT(bytes, first + first / 2 * static_cast<std::uint64_t>(i));
  }
  const OpenedFile file(path);
  auto info = Make<gatun_info>();
  ASSERT_OK(gatun_get_info(file, &info));
  EXPECT_EQ(info.steps, 4u);
  EXPECT_EQ(info.meshes, 4u);
  auto request = MakeRequest();
  request.step = 3;
  EXPECT_EQ(ReadPiece(file, request).Field, block.Field);
}

TEST(LibraryWriting, GoesBackToTheFirstMesh)
{
  const auto path = PathOf("meshes.gtn");
  Block block(8);
  Block small(5);
  const auto mesh = block.GetMesh();
  const auto other = small.GetMesh();
  const auto descriptions = block.GetArrays();
  const std::array<gatun_buffer, 2> arrays{ BufferOf(block.Field), BufferOf(block.Numbers) };
  const std::array<gatun_buffer, 2> others{ BufferOf(small.Field), BufferOf(small.Numbers) };
  auto options = Make<gatun_options>();
  options.keep_order = 7;
  gatun_writer* writer = nullptr;
  ASSERT_OK(
    gatun_create(path.c_str(), &mesh, descriptions.data(), 2, &options, nullptr, nullptr, &writer));
  auto step = MakeStep(arrays, 0);
  ASSERT_OK(gatun_write_step(writer, &step, nullptr, nullptr));
  std::uint32_t number = 0;
  ASSERT_OK(gatun_add_mesh(writer, &other, nullptr, nullptr, nullptr, &number));
  EXPECT_EQ(number, 1u);
  step = MakeStep(others, 1);
  ASSERT_OK(gatun_write_step(writer, &step, nullptr, nullptr));
  ASSERT_OK(gatun_use_mesh(writer, 0));
  step = MakeStep(arrays, 2);
  ASSERT_OK(gatun_write_step(writer, &step, nullptr, nullptr));
  ASSERT_OK(gatun_use_mesh(writer, 1));
  step = MakeStep(others, 3);
  ASSERT_OK(gatun_write_step(writer, &step, nullptr, nullptr));
  ASSERT_OK(gatun_finish(writer, nullptr));
  const OpenedFile file(path);
  for (std::uint64_t i = 0; i < 4; ++i)
  {
    auto request = MakeRequest();
    request.step = i;
    EXPECT_EQ(ReadPiece(file, request).Field, (i % 2 ? small : block).Field);
  }

  // A file that is appended to has no mesh at first; buffers of the first one would be too small.
  ASSERT_OK(gatun_append(path.c_str(), nullptr, 0, nullptr, &writer));
  step = MakeStep(others, 4);
  EXPECT_EQ(gatun_write_step(writer, &step, nullptr, nullptr), GATUN_INVALID_INPUT);
  EXPECT_EQ(gatun_use_mesh(writer, 0), GATUN_INVALID_INPUT);
  gatun_discard(writer);
}

TEST(LibraryWriting, LevelsLayersAndBoundary)
{
  const auto path = PathOf("levels.gtn");
  Block block(20);
  auto options = Make<gatun_options>();
  options.levels = 3;
  options.boundary = 1;
  options.dependencies = 1;
  options.layers = GATUN_HISTOGRAM;
  options.layer_count = 8;
  options.chunk_size = 2000;
  options.profile = GATUN_SMALL;
  block.Write(path, options);
  const OpenedFile file(path);
  auto info = Make<gatun_info>();
  ASSERT_OK(gatun_get_info(file, &info));
  EXPECT_TRUE(info.has_hierarchy);
  EXPECT_TRUE(info.has_boundary);
  ASSERT_GE(info.levels, 1u);
  auto level = Make<gatun_level>();
  ASSERT_OK(gatun_get_level(file, 1, &level));
  EXPECT_LT(level.points, info.points);
  auto request = MakeRequest();
  request.level = 1;
  EXPECT_EQ(ReadPiece(file, request).Sizes.points, level.points);
  request = MakeRequest();
  request.ratio = 0.75;
  const auto coarse = ReadPiece(file, request);
  EXPECT_EQ(coarse.Sizes.points, info.points - static_cast<std::uint64_t>(0.75 * info.points));
  for (std::size_t i = 0; i < coarse.Field.size(); ++i)
  {
    EXPECT_EQ(coarse.Field[i],
      coarse.Points[3 * i] + 2 * coarse.Points[3 * i + 1] + 3 * coarse.Points[3 * i + 2]);
  }
  request = MakeRequest();
  request.flags |= GATUN_BOUNDARY;
  auto sizes = Make<gatun_sizes>();
  gatun_piece* piece = nullptr;
  ASSERT_OK(gatun_prepare(file, &request, &sizes, nullptr, nullptr, &piece));
  EXPECT_EQ(sizes.cells, 6u * 20 * 20 * 2);
  gatun_end(piece);
  std::size_t length = 0;
  ASSERT_OK(gatun_describe(file, 1, nullptr, 0, &length));
  std::string text(length, ' ');
  ASSERT_OK(gatun_describe(file, 1, text.data(), text.size(), &length));
  EXPECT_NE(text.find("\"spacing\": \"histogram\""), std::string::npos) << text;
}

TEST(LibraryWriting, BoundsErrors)
{
  const auto path = PathOf("bounds.gtn");
  Block block(8);
  for (auto& value : block.Field)
  {
    value = std::sin(10 * value);
  }
  const auto mesh = block.GetMesh();
  auto descriptions = block.GetArrays();
  descriptions[0].error = "abs:0.01";
  auto options = Make<gatun_options>();
  options.keep_order = 7;
  gatun_writer* writer = nullptr;
  ASSERT_OK(
    gatun_create(path.c_str(), &mesh, descriptions.data(), 2, &options, nullptr, nullptr, &writer));
  const std::array<gatun_buffer, 2> arrays{ BufferOf(block.Field), BufferOf(block.Numbers) };
  auto step = MakeStep(arrays, 0);
  step.has_time = 0;
  ASSERT_OK(gatun_write_step(writer, &step, nullptr, nullptr));
  ASSERT_OK(gatun_finish(writer, nullptr));
  const OpenedFile file(path);
  const auto piece = ReadPiece(file, MakeRequest());
  double largest = 0;
  for (std::size_t i = 0; i < piece.Field.size(); ++i)
  {
    largest = std::max(largest, std::abs(piece.Field[i] - block.Field[i]));
  }
  EXPECT_LE(largest, 0.01);
  EXPECT_GT(largest, 0);
  // The core knows bounds by names, and "*" for all.
  descriptions[1].name = descriptions[0].name;
  EXPECT_EQ(gatun_create(PathOf("much.gtn").c_str(), &mesh, descriptions.data(), 2, &options,
              nullptr, nullptr, &writer),
    GATUN_INVALID_INPUT);
  descriptions[1] = block.GetArrays()[1];
  descriptions[0].name = "*";
  EXPECT_EQ(gatun_create(PathOf("much.gtn").c_str(), &mesh, descriptions.data(), 2, &options,
              nullptr, nullptr, &writer),
    GATUN_INVALID_INPUT);
  descriptions[0].error = "much";
  EXPECT_EQ(gatun_create(PathOf("much.gtn").c_str(), &mesh, descriptions.data(), 2, &options,
              nullptr, nullptr, &writer),
    GATUN_INVALID_INPUT);
}

TEST(LibraryWriting, InParts)
{
  const auto path = PathOf("parts.gtn");
  Block block(8);
  auto descriptions = block.GetArrays();
  gatun_writer* writer = nullptr;
  ASSERT_OK(gatun_create_parts(path.c_str(), descriptions.data(), 2, nullptr, &writer));
  // Two halves of the cells, each with all points that the other half has, too.
  const auto half = block.Numbers.size() / 2;
  const auto makePart = [&](std::size_t first)
  {
    auto part = block.GetMesh();
    part.cells = half;
    part.connectivity = block.Cells.data() + 4 * first;
    return part;
  };
  for (const bool survey : { true, false })
  {
    for (const std::size_t first : { std::size_t{ 0 }, half })
    {
      const auto part = makePart(first);
      const std::array<gatun_buffer, 2> arrays{ BufferOf(block.Field),
        gatun_buffer{ block.Numbers.data() + first, half * sizeof(std::int32_t) } };
      auto step = MakeStep(arrays, 0);
      step.has_time = 0;
      if (survey)
      {
        ASSERT_OK(gatun_survey_part(writer, &part, nullptr, nullptr, nullptr));
        ASSERT_OK(gatun_survey_step(writer, &step));
      }
      else
      {
        ASSERT_OK(gatun_add_part(writer, &part, nullptr, nullptr, nullptr));
        ASSERT_OK(gatun_write_step(writer, &step, nullptr, nullptr));
      }
    }
  }
  ASSERT_OK(gatun_finish(writer, nullptr));
  const OpenedFile file(path);
  auto info = Make<gatun_info>();
  ASSERT_OK(gatun_get_info(file, &info));
  EXPECT_EQ(info.cells, 2 * half);
  ASSERT_OK(gatun_verify(file, nullptr, nullptr));
}

TEST(LibraryWriting, SurfacesAndPolyhedra)
{
  // A cube as a polyhedron, and a pyramid on it.
  const std::vector<float> points{ 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0,
    1, 1, 0.5f, 0.5f, 2 };
  const std::vector<std::int32_t> ids{ 0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 8 };
  const std::vector<std::int32_t> offsets{ 0, 8, 13 };
  const std::vector<std::uint8_t> types{ 42, 14 };
  const std::vector<std::int64_t> faces{ 6, 4, 0, 3, 2, 1, 4, 4, 5, 6, 7, 4, 0, 1, 5, 4, 4, 1, 2, 6,
    5, 4, 2, 3, 7, 6, 4, 3, 0, 4, 7 };
  const std::vector<std::int64_t> locations{ 0, -1 };
  auto mesh = Make<gatun_mesh>();
  mesh.points = 9;
  mesh.cells = 2;
  mesh.coordinate_type = GATUN_FLOAT32;
  mesh.coordinates = points.data();
  mesh.connectivity = ids.data();
  mesh.offsets = offsets.data();
  mesh.types = types.data();
  mesh.face_locations = locations.data();
  mesh.faces = faces.data();
  mesh.faces_size = faces.size();
  auto options = Make<gatun_options>();
  options.keep_order = 7;
  const auto path = PathOf("polyhedron.gtn");
  gatun_writer* writer = nullptr;
  ASSERT_OK(gatun_create(path.c_str(), &mesh, nullptr, 0, &options, nullptr, nullptr, &writer));
  ASSERT_OK(gatun_finish(writer, nullptr));
  EXPECT_EQ(gatun_kind_of(path.c_str()), GATUN_KIND_MESH);
  const OpenedFile file(path);
  auto request = Make<gatun_request>();
  request.flags = GATUN_RESTORE_ORDER;
  auto sizes = Make<gatun_sizes>();
  gatun_piece* piece = nullptr;
  ASSERT_OK(gatun_prepare(file, &request, &sizes, nullptr, nullptr, &piece));
  EXPECT_EQ(sizes.cell_type, 0u);
  std::vector<std::int32_t> readIds(sizes.connectivity);
  std::vector<std::int32_t> readOffsets(sizes.cells + 1);
  std::vector<std::uint8_t> readTypes(sizes.cells);
  std::vector<std::int64_t> readLocations(sizes.cells);
  std::vector<std::int64_t> readFaces(sizes.faces);
  auto buffers = Make<gatun_buffers>();
  buffers.connectivity = BufferOf(readIds);
  EXPECT_EQ(gatun_read(piece, &buffers, nullptr, nullptr), GATUN_INVALID_INPUT); // without types
  buffers.offsets = BufferOf(readOffsets);
  buffers.types = BufferOf(readTypes);
  buffers.face_locations = BufferOf(readLocations);
  buffers.faces = BufferOf(readFaces);
  ASSERT_OK(gatun_read(piece, &buffers, nullptr, nullptr));
  gatun_end(piece);
  EXPECT_EQ(readIds, ids);
  EXPECT_EQ(readOffsets, offsets);
  EXPECT_EQ(readTypes, types);
  EXPECT_EQ(readLocations, locations);
  EXPECT_EQ(readFaces, faces);
}

TEST(LibraryWriting, TetrahedraWithTypesAreThoseWithout)
{
  Block block(3);
  auto mesh = block.GetMesh();
  const std::vector<std::uint8_t> types(mesh.cells, 10);
  std::vector<std::int64_t> offsets;
  for (std::uint64_t cell = 0; cell <= mesh.cells; ++cell)
  {
    offsets.push_back(static_cast<std::int64_t>(4 * cell));
  }
  const auto write = [&](const char* name)
  {
    const auto path = PathOf(name);
    auto options = Make<gatun_options>();
    options.levels = 2;
    gatun_writer* writer = nullptr;
    EXPECT_OK(gatun_create(path.c_str(), &mesh, nullptr, 0, &options, nullptr, nullptr, &writer));
    EXPECT_OK(gatun_finish(writer, nullptr));
    return ReadBytes(path);
  };
  ASSERT_NE(mesh.wide_ids, 0);
  const auto without = write("plain.gtn");
  mesh.types = types.data();
  mesh.offsets = offsets.data();
  EXPECT_EQ(write("typed.gtn"), without);
}

TEST(LibraryWriting, LeavesAFileThatIsThereAlone)
{
  const auto path = PathOf("kept.gtn");
  auto options = Make<gatun_options>();
  Block(3).Write(path, options);
  const auto before = ReadBytes(path);
  Block block(3);
  const auto mesh = block.GetMesh();
  const auto arrays = block.GetArrays();
  gatun_writer* writer = nullptr;
  ASSERT_OK(
    gatun_create(path.c_str(), &mesh, arrays.data(), 2, &options, nullptr, nullptr, &writer));
  auto step = Make<gatun_values>();
  EXPECT_EQ(gatun_write_step(writer, &step, nullptr, nullptr), GATUN_INVALID_INPUT);
  EXPECT_EQ(gatun_write_step(writer, &step, nullptr, nullptr), GATUN_INVALID_INPUT);
  EXPECT_EQ(gatun_finish(writer, nullptr), GATUN_INVALID_INPUT);
  EXPECT_EQ(ReadBytes(path), before);
}

TEST(LibraryVolumes, WithoutLoss)
{
  const auto path = PathOf("volume.ghv");
  std::vector<std::uint16_t> voxels(20 * 30 * 40);
  for (std::size_t i = 0; i < voxels.size(); ++i)
  {
    voxels[i] = static_cast<std::uint16_t>(1000 + 500 * std::sin(0.01 * static_cast<double>(i)));
  }
  auto info = Make<gatun_volume_info>();
  info.dimensions[0] = 20;
  info.dimensions[1] = 30;
  info.dimensions[2] = 40;
  info.type = GATUN_UINT16;
  info.name = "density";
  info.origin[1] = 5;
  const auto buffer = BufferOf(voxels);
  auto written = Make<gatun_volume_info>();
  ASSERT_OK(gatun_write_volume(
    path.c_str(), &info, &buffer, 0, GATUN_RMS_ERROR, 0, nullptr, nullptr, &written));
  EXPECT_EQ(written.maximum_error, 0);
  EXPECT_EQ(gatun_kind_of(path.c_str()), GATUN_KIND_VOLUME);
  gatun_volume* volume = nullptr;
  ASSERT_OK(gatun_open_volume(path.c_str(), &volume));
  auto read = Make<gatun_volume_info>();
  ASSERT_OK(gatun_get_volume_info(volume, &read));
  EXPECT_STREQ(read.name, "density");
  EXPECT_EQ(read.origin[1], 5);
  EXPECT_EQ(read.spacing[0], 1);
  EXPECT_TRUE(read.is_lossless);
  const std::uint32_t first[3] = { 3, 0, 35 };
  const std::uint32_t end[3] = { 20, 30, 40 };
  std::vector<std::uint16_t> some(17 * 30 * 5);
  const auto to = BufferOf(some);
  ASSERT_OK(gatun_read_voxels(volume, first, end, &to, nullptr, nullptr));
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    const auto x = 3 + i % 17;
    const auto y = i / 17 % 30;
    const auto z = 35 + i / 17 / 30;
    ASSERT_EQ(some[i], voxels[x + 20 * (y + 30 * z)]);
  }
  std::size_t count = 0;
  gatun_range ranges[64];
  ASSERT_OK(gatun_plan_voxels(volume, first, end, 0, ranges, 64, &count));
  ASSERT_GT(count, 0u);
  EXPECT_LT(ranges[0].offset, read.file_bytes);
  ASSERT_OK(gatun_verify_volume(volume, nullptr, nullptr));
  EXPECT_EQ(gatun_read_voxels(volume, end, first, &to, nullptr, nullptr), GATUN_INVALID_INPUT);
  std::size_t length = 0;
  ASSERT_OK(gatun_describe_volume(volume, 0, nullptr, 0, &length));
  EXPECT_GT(length, 100u);
  gatun_close_volume(volume);
}
}
