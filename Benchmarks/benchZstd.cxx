// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A file has for each array its Header, the sizes of its blocks, and the blocks. The benchmark
// reads what it wrote itself: there are no checks but those of zstd.

#include "benchZstd.h"

#include "benchHarness.h"

#include "gatunCellArrays.h"
#include "gatunFaceStream.h"
#include "gatunParallel.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <zstd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>

namespace bench
{
namespace
{
using Array = vtkSmartPointer<vtkDataArray>;

constexpr std::size_t BlockBytes = std::size_t{ 1 } << 20;

enum class ArrayRole : std::uint32_t
{
  Points,
  PointIds,
  Offsets,
  Types,
  Faces,
  FaceLocations,
  PointArray,
  CellArray
};

struct Header
{
  ArrayRole Role;
  std::int32_t Type;
  std::int32_t Components;
  std::uint32_t Stride; ///< of shuffled bytes; 1: not shuffled
  std::uint64_t Tuples;
  std::uint64_t Blocks;
  char Name[64];
};

struct Part
{
  ArrayRole Role;
  Array Values;
};

void AddArrays(std::vector<Part>& parts, ArrayRole role, vtkDataSetAttributes* attributes)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    parts.push_back({ role, attributes->GetArray(i) });
  }
}

std::vector<Part> GetParts(vtkUnstructuredGrid* grid)
{
  std::vector<Part> parts{ { ArrayRole::Points, grid->GetPoints()->GetData() },
    { ArrayRole::PointIds, gatun::GetPointIds(grid->GetCells()) },
    { ArrayRole::Offsets, gatun::GetOffsets(grid->GetCells()) },
    { ArrayRole::Types, gatun::GetCellTypes(grid) } };
  const gatun::FaceStream faces = gatun::GetFaceStream(grid);
  if (faces.Values)
  {
    parts.push_back({ ArrayRole::Faces, faces.Values });
    parts.push_back({ ArrayRole::FaceLocations, faces.Locations });
  }
  AddArrays(parts, ArrayRole::PointArray, grid->GetPointData());
  AddArrays(parts, ArrayRole::CellArray, grid->GetCellData());
  return parts;
}

std::size_t GetBytes(vtkDataArray* array)
{
  return static_cast<std::size_t>(array->GetNumberOfValues()) *
    static_cast<std::size_t>(array->GetDataTypeSize());
}

void Shuffle(const char* from, std::size_t size, std::size_t stride, char* to)
{
  const std::size_t count = size / stride;
  for (std::size_t i = 0; i < size; ++i)
  {
    to[i % stride * count + i / stride] = from[i];
  }
}

/** The inverse, in a loop that compilers vectorize. */
template <typename Value>
void Unshuffle(const unsigned char* from, std::size_t size, void* to)
{
  const std::size_t count = size / sizeof(Value);
  auto* const values = static_cast<Value*>(to);
  for (std::size_t i = 0; i < count; ++i)
  {
    Value value = 0;
    for (std::size_t k = 0; k < sizeof(Value); ++k)
    {
      value |= static_cast<Value>(from[k * count + i]) << (8 * k);
    }
    values[i] = value;
  }
}

void WritePart(std::ostream& out, const Part& part, bool shuffle)
{
  Header header{ part.Role, part.Values->GetDataType(), part.Values->GetNumberOfComponents(), 1,
    static_cast<std::uint64_t>(part.Values->GetNumberOfTuples()), 0, {} };
  const int bytesOfValue = part.Values->GetDataTypeSize();
  if (shuffle && (bytesOfValue == 4 || bytesOfValue == 8))
  {
    header.Stride = static_cast<std::uint32_t>(bytesOfValue);
  }
  if (const char* const name = part.Values->GetName())
  {
    std::strncpy(header.Name, name, sizeof(header.Name) - 1);
  }
  const auto* const values = static_cast<const char*>(part.Values->GetVoidPointer(0));
  const std::size_t size = GetBytes(part.Values);
  std::vector<std::uint64_t> sizes;
  std::string blocks;
  std::vector<char> block;
  std::vector<char> packed(ZSTD_compressBound(BlockBytes));
  for (std::size_t begin = 0; begin < size; begin += BlockBytes)
  {
    block.resize(std::min(BlockBytes, size - begin));
    Shuffle(values + begin, block.size(), header.Stride, block.data());
    constexpr int level = 3;
    sizes.push_back(ZSTD_compress(packed.data(), packed.size(), block.data(), block.size(), level));
    blocks.append(packed.data(), sizes.back());
  }
  header.Blocks = sizes.size();
  out.write(reinterpret_cast<const char*>(&header), sizeof(header));
  out.write(reinterpret_cast<const char*>(sizes.data()),
    static_cast<std::streamsize>(sizes.size() * sizeof(std::uint64_t)));
  out.write(blocks.data(), static_cast<std::streamsize>(blocks.size()));
}

/** A compressed block, and where its values go. */
struct Block
{
  const char* From;
  std::size_t Size;
  unsigned char* To;
  std::size_t Bytes;
  std::size_t Stride;
};

void Restore(const Block& block)
{
  thread_local std::vector<unsigned char> shuffled(BlockBytes);
  unsigned char* const to = block.Stride == 1 ? block.To : shuffled.data();
  if (ZSTD_decompress(to, block.Bytes, block.From, block.Size) != block.Bytes)
  {
    throw Failure("zstd does not give its input back");
  }
  if (block.Stride == 4)
  {
    Unshuffle<std::uint32_t>(to, block.Bytes, block.To);
  }
  else if (block.Stride == 8)
  {
    Unshuffle<std::uint64_t>(to, block.Bytes, block.To);
  }
}

/** Makes an array, and adds its blocks. Returns where the next array begins. */
const char* ReadPart(const char* at, Part& part, std::vector<Block>& blocks)
{
  Header header;
  std::memcpy(&header, at, sizeof(header));
  part = { header.Role, Array::Take(vtkDataArray::CreateDataArray(header.Type)) };
  part.Values->SetName(header.Name);
  part.Values->SetNumberOfComponents(header.Components);
  part.Values->SetNumberOfTuples(static_cast<vtkIdType>(header.Tuples));
  std::vector<std::uint64_t> sizes(header.Blocks);
  std::memcpy(sizes.data(), at + sizeof(header), header.Blocks * sizeof(std::uint64_t));
  const char* from = at + sizeof(header) + header.Blocks * sizeof(std::uint64_t);
  auto* const to = static_cast<unsigned char*>(part.Values->GetVoidPointer(0));
  const std::size_t bytes = GetBytes(part.Values);
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    const std::size_t begin = i * BlockBytes;
    blocks.push_back(
      { from, sizes[i], to + begin, std::min(BlockBytes, bytes - begin), header.Stride });
    from += sizes[i];
  }
  return from;
}

Grid MakeGrid(const std::vector<Part>& parts)
{
  auto grid = Grid::New();
  std::map<ArrayRole, Array> arrays;
  for (const Part& part : parts)
  {
    arrays[part.Role] = part.Values;
    if (part.Role == ArrayRole::PointArray)
    {
      grid->GetPointData()->AddArray(part.Values);
    }
    else if (part.Role == ArrayRole::CellArray)
    {
      grid->GetCellData()->AddArray(part.Values);
    }
  }
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(arrays[ArrayRole::Points]);
  grid->SetPoints(points);
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(arrays[ArrayRole::Offsets], arrays[ArrayRole::PointIds]);
  gatun::SetCells(grid, vtkUnsignedCharArray::SafeDownCast(arrays[ArrayRole::Types]), cells,
    { vtkIdTypeArray::SafeDownCast(arrays[ArrayRole::Faces]),
      vtkIdTypeArray::SafeDownCast(arrays[ArrayRole::FaceLocations]) });
  return grid;
}
} // anonymous namespace

//------------------------------------------------------------------------------
void WriteZstd(vtkUnstructuredGrid* grid, const std::string& file, bool shuffle)
{
  std::ofstream out(file, std::ios::binary);
  for (const Part& part : GetParts(grid))
  {
    WritePart(out, part, shuffle);
  }
  if (!out.flush())
  {
    throw Failure(file, "cannot be written");
  }
}

//------------------------------------------------------------------------------
Grid LoadZstd(const std::string& file)
{
  const std::size_t size = FileSize(file);
  const std::unique_ptr<char[]> bytes(new char[size]); // not cleared
  if (!std::ifstream(file, std::ios::binary).read(bytes.get(), static_cast<std::streamsize>(size)))
  {
    throw Failure(file, "cannot be read");
  }
  std::vector<Part> parts;
  std::vector<Block> blocks;
  for (const char* at = bytes.get(); at != bytes.get() + size;)
  {
    at = ReadPart(at, parts.emplace_back(), blocks);
  }
  gatun::ParallelFor(blocks.size(), [&](std::size_t i) { Restore(blocks[i]); });
  return MakeGrid(parts);
}
}
