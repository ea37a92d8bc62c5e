// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The C interface on a file of any bytes. The first four bytes choose a request. Checksums keep
// most inputs from getting far, so the corpus has whole files.

#include "fuzzInput.h"

#include "gatun.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <vector>

namespace
{
// Pieces that are larger are prepared, but not read.
constexpr std::uint64_t MostBytes = std::uint64_t{ 1 } << 26;

[[noreturn]] void Stop(const char* why)
{
  std::fprintf(stderr, "fuzz target: %s\n", why);
  std::abort();
}

template <typename T>
T Make()
{
  T made{};
  made.size = sizeof(T);
  return made;
}

int ReadAt(void* user, std::uint64_t offset, void* to, std::size_t length)
{
  const auto& bytes = *static_cast<const std::span<const std::uint8_t>*>(user);
  if (offset > bytes.size() || length > bytes.size() - offset)
  {
    Stop("the library reads behind the end of a source");
  }
  std::memcpy(to, bytes.data() + offset, length);
  return 0;
}

/** Reads all of a piece into buffers of exactly its sizes. */
void ReadPiece(gatun_file* file, gatun_piece* piece, const gatun_sizes& sizes,
  const std::vector<std::uint32_t>& numbers)
{
  if (std::max({ sizes.points, sizes.cells, sizes.connectivity, sizes.faces }) > MostBytes / 8)
  {
    return;
  }
  std::vector<std::vector<std::uint8_t>> memory;
  memory.reserve(16 + numbers.size());
  const auto take = [&](std::uint64_t bytes)
  {
    auto& own = memory.emplace_back(static_cast<std::size_t>(bytes));
    return gatun_buffer{ own.data(), bytes };
  };
  auto buffers = Make<gatun_buffers>();
  buffers.wide_ids = 1;
  buffers.points = take(24 * sizes.points);
  buffers.connectivity = take(8 * sizes.connectivity);
  buffers.offsets = take(8 * (sizes.cells + 1));
  buffers.types = take(sizes.cells);
  buffers.face_locations = take(8 * sizes.cells);
  buffers.faces = take(8 * sizes.faces);
  buffers.point_ghosts = take(sizes.points);
  buffers.cell_ids = take(8 * sizes.cells);
  std::vector<gatun_buffer> arrays;
  for (const auto number : numbers)
  {
    auto array = Make<gatun_array>();
    gatun_get_array(file, number, &array);
    const auto tuples = array.is_cell ? sizes.cells : sizes.points;
    if (array.components > MostBytes / 8 / std::max<std::uint64_t>(tuples, 1))
    {
      return;
    }
    arrays.push_back(take(8 * array.components * tuples));
  }
  buffers.arrays = arrays.data();
  buffers.array_count = arrays.size();
  gatun_read(piece, &buffers, nullptr, nullptr);
}

void ReadMesh(gatun_file* file, std::uint8_t choice, std::uint8_t flags, std::uint8_t step)
{
  auto info = Make<gatun_info>();
  gatun_get_info(file, &info);
  std::size_t length = 0;
  gatun_describe(file, 1, nullptr, 0, &length);
  gatun_fields* fields = nullptr;
  std::uint32_t count = 0;
  if (gatun_get_fields(file, step, &fields, &count) == GATUN_OK)
  {
    auto field = Make<gatun_field>();
    gatun_get_field(fields, count / 2, &field);
    gatun_free_fields(fields);
  }
  std::vector<std::uint32_t> numbers(std::min(info.arrays, 8u));
  for (std::uint32_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = i;
  }
  auto request = Make<gatun_request>();
  request.step = step;
  request.flags = flags;
  request.pieces = 1 + choice % 3;
  request.ghost_levels = choice / 3 % 3;
  request.level = choice / 9 % 3;
  request.ratio = choice / 27 % 3 == 1 ? 0.4 : 0;
  std::copy_n(info.bounds, 6, request.box);
  request.box[1] = (request.box[0] + request.box[1]) / 2;
  request.range_component = -1;
  gatun_get_range(file, 0, -1, step, request.range);
  request.origin[0] = request.box[1];
  request.normal[0] = 1;
  request.arrays = numbers.data();
  request.array_count = info.steps > 0 ? numbers.size() : 0;
  numbers.resize(request.array_count);
  std::vector<gatun_range> ranges(100);
  std::size_t planned = 0;
  gatun_plan(file, &request, 100, ranges.data(), ranges.size(), &planned);
  auto sizes = Make<gatun_sizes>();
  gatun_piece* piece = nullptr;
  auto status = gatun_status{};
  auto contour = Make<gatun_contour>();
  contour.values = &request.box[1];
  contour.value_count = 1;
  contour.component = -1;
  switch (choice / 81)
  {
    case 1:
      status = gatun_prepare_contour(file, &request, &contour, &sizes, nullptr, nullptr, &piece);
      break;
    case 2:
      status = gatun_prepare_slice(file, &request, &sizes, nullptr, nullptr, &piece);
      break;
    default:
      status = gatun_prepare(file, &request, &sizes, nullptr, nullptr, &piece);
  }
  if (status == GATUN_OK)
  {
    ReadPiece(file, piece, sizes, numbers);
    gatun_end(piece);
  }
  else if (*gatun_error() == 0 || status == GATUN_INTERNAL)
  {
    Stop("a failure without a reason");
  }
}
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  constexpr std::size_t choices = 4;
  if (size < choices)
  {
    return 0;
  }
  gatun_set_threads(1);
  std::span<const std::uint8_t> bytes(data + choices, size - choices);
  auto source = Make<gatun_source>();
  source.bytes = bytes.size();
  source.user = &bytes;
  source.read = ReadAt;
  source.name = "fuzz";
  gatun_volume* volume = nullptr;
  if (gatun_open_volume_source(&source, &volume) == GATUN_OK)
  {
    auto info = Make<gatun_volume_info>();
    gatun_get_volume_info(volume, &info);
    const std::uint32_t first[3] = { 0, 0, 0 };
    const std::uint32_t end[3] = { 1, 1, 1 };
    std::uint64_t voxel = 0;
    const gatun_buffer to{ &voxel, sizeof(voxel) };
    gatun_read_voxels(volume, first, end, &to, nullptr, nullptr);
    gatun_close_volume(volume);
  }
  gatun_file* file = nullptr;
  if (gatun_open_source(&source, 1u << 22, &file) == GATUN_OK)
  {
    ReadMesh(file, data[0], data[1], data[2]);
    gatun_close(file);
  }
  return 0;
}
