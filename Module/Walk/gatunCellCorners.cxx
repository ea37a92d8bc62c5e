// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellCorners.h"

#include "gatunCellShapes.h"
#include "gatunChunkCodec.h"
#include "gatunNumberModel.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace gatun
{
namespace
{
constexpr std::uint8_t Tetra = 10; // VTK's numbers of the cell types

using Ids = std::vector<std::uint32_t>;
using Face = std::span<const std::uint32_t>;

/** Codes a permutation as steps: mostly, the next element comes next. */
template <typename Coder>
class PermutationCoder
{
public:
  void Code(Coder& coder, std::span<std::uint32_t> order)
  {
    this->Used.assign(order.size(), 0);
    std::uint32_t next = 0;
    for (auto& element : order)
    {
      if (!coder.Bit(this->IsNext[this->Last], element == next))
      {
        this->Last = 0;
        element = CodeIndex(coder, element, order.size());
      }
      else
      {
        this->Last = 1;
        element = next;
      }
      if (element >= order.size() || this->Used[element])
      {
        ThrowCorrupt("a list of corners names one twice");
      }
      this->Used[element] = 1;
      next = element + 1;
    }
  }

private:
  std::array<BitModel, 2> IsNext;
  unsigned Last = 1;
  std::vector<char> Used;
};

std::vector<Face> SplitFaces(std::span<const std::uint32_t> stream)
{
  std::vector<Face> faces;
  for (std::size_t at = 0; at < stream.size(); at += 1 + stream[at])
  {
    faces.push_back(stream.subspan(at + 1, stream[at]));
  }
  return faces;
}

/** For each element of wanted, its place in found. Elements may be there several times. */
template <typename T, typename Less>
Ids Match(const std::vector<T>& found, const std::vector<T>& wanted, Less&& less)
{
  const auto sort = [&](const std::vector<T>& list)
  {
    Ids order(list.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
      [&](std::uint32_t a, std::uint32_t b) { return less(list[a], list[b]); });
    return order;
  };
  const auto from = sort(found);
  const auto to = sort(wanted);
  Ids places(wanted.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    places[to[i]] = from[i];
  }
  return places;
}

/** The place of the corner that a cycle begins with in its order: of all turns the least one. */
std::uint32_t FindBegin(Face face)
{
  std::uint32_t best = 0;
  for (std::uint32_t begin = 1; begin < face.size(); ++begin)
  {
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const auto one = face[(begin + i) % face.size()];
      const auto other = face[(best + i) % face.size()];
      if (one != other)
      {
        best = one < other ? begin : best;
        break;
      }
    }
  }
  return best;
}

/** A polyhedron's order of points and of faces, and the first corners of faces. */
struct PolyhedronOrder
{
  Ids Points, Faces, Begins;
};

PolyhedronOrder CompareTo(
  const Ids& corners, const Ids& stream, Face wantedCorners, Face wantedStream)
{
  PolyhedronOrder order;
  const auto faces = SplitFaces(stream);
  const auto wanted = SplitFaces(wantedStream);
  if (std::equal(corners.begin(), corners.end(), wantedCorners.begin(), wantedCorners.end()))
  {
    order.Points.resize(corners.size());
    std::iota(order.Points.begin(), order.Points.end(), 0u);
  }
  else
  {
    order.Points = Match(corners, { wantedCorners.begin(), wantedCorners.end() }, std::less<>());
  }
  order.Begins.assign(wanted.size(), 0);
  if (std::equal(stream.begin(), stream.end(), wantedStream.begin(), wantedStream.end()))
  {
    order.Faces.resize(wanted.size());
    std::iota(order.Faces.begin(), order.Faces.end(), 0u);
    return order;
  }
  const auto rotate = [](const std::vector<Face>& list)
  {
    std::vector<Ids> rotated;
    for (const auto& face : list)
    {
      auto& ids = rotated.emplace_back(face.begin(), face.end());
      std::rotate(ids.begin(), ids.begin() + FindBegin(face), ids.end());
    }
    return rotated;
  };
  order.Faces = Match(rotate(faces), rotate(wanted), std::less<>());
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    const auto size = static_cast<std::uint32_t>(wanted[i].size());
    if (size > 0)
    {
      order.Begins[i] = (FindBegin(faces[order.Faces[i]]) + size - FindBegin(wanted[i])) % size;
    }
  }
  return order;
}

/** Codes how corners are turned, cell by cell. */
template <typename Coder>
class CornerCoder
{
public:
  explicit CornerCoder(Coder& coder)
    : Symbols(coder)
  {
  }

  unsigned CodeRotation(unsigned rotation)
  {
    this->Rotation = this->Rotations[this->Rotation].Code(this->Symbols, rotation);
    if (this->Rotation >= 12)
    {
      ThrowCorrupt("a tetrahedron is turned in an impossible way");
    }
    return this->Rotation;
  }

  /** faces: those of the chunk. */
  void CodePolyhedron(PolyhedronOrder& order, std::span<const Face> faces)
  {
    this->Points.Code(this->Symbols, order.Points);
    this->Faces.Code(this->Symbols, order.Faces);
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      const auto size = faces[order.Faces[i]].size();
      if (size > 1 && this->Symbols.Bit(this->IsTurned, order.Begins[i] != 0))
      {
        order.Begins[i] = CodeIndex(this->Symbols, order.Begins[i], size);
      }
    }
  }

private:
  Coder& Symbols;
  std::array<BitTree<4>, 12> Rotations; // by the last one
  unsigned Rotation = 0;
  PermutationCoder<Coder> Points, Faces;
  BitModel IsTurned;
};

bool IsTetra(const CellList& cells, std::size_t cell)
{
  return cells.Types[cell] == Tetra && cells.Starts[cell + 1] - cells.Starts[cell] == 4;
}

std::array<std::uint32_t, 4> GetTetra(const CellList& cells, std::size_t cell)
{
  const auto c = cells.GetCorners(cell);
  return { c[0], c[1], c[2], c[3] };
}

unsigned FindRotation(
  const std::array<std::uint32_t, 4>& found, const std::array<std::uint32_t, 4>& wanted)
{
  unsigned rotation = 0;
  while (rotation < 11 && RotateCorners(found, rotation) != wanted)
  {
    ++rotation;
  }
  return rotation;
}

void RestorePolyhedron(CornerCoder<EntropyDecoder>& coder, std::span<std::uint32_t> corners,
  std::span<std::uint32_t> stream)
{
  const Ids oldCorners(corners.begin(), corners.end());
  const Ids oldStream(stream.begin(), stream.end());
  const auto faces = SplitFaces(oldStream);
  PolyhedronOrder order;
  order.Points.resize(corners.size());
  order.Faces.resize(faces.size());
  order.Begins.assign(faces.size(), 0);
  coder.CodePolyhedron(order, faces);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    corners[i] = oldCorners[order.Points[i]];
  }
  auto to = stream.begin();
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const auto face = faces[order.Faces[i]];
    *to++ = static_cast<std::uint32_t>(face.size());
    to = std::rotate_copy(face.begin(), face.begin() + order.Begins[i], face.end(), to);
  }
}
}

//------------------------------------------------------------------------------
Bytes EncodeCorners(const CellList& cells, const CellList& wanted,
  std::span<const std::uint32_t> order, std::span<const std::uint32_t> inputOf)
{
  EntropyEncoder symbols;
  CornerCoder<EntropyEncoder> coder(symbols);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (IsTetra(cells, i))
    {
      auto found = GetTetra(cells, i);
      for (auto& corner : found)
      {
        corner = inputOf[corner];
      }
      coder.CodeRotation(FindRotation(found, GetTetra(wanted, order[i])));
    }
    else if (cells.Types[i] == PolyhedronType)
    {
      Ids corners;
      for (const auto v : cells.GetCorners(i))
      {
        corners.push_back(inputOf[v]);
      }
      Ids stream;
      for (const auto& face : SplitFaces(cells.GetFaces(i)))
      {
        stream.push_back(static_cast<std::uint32_t>(face.size()));
        for (const auto v : face)
        {
          stream.push_back(inputOf[v]);
        }
      }
      auto turns =
        CompareTo(corners, stream, wanted.GetCorners(order[i]), wanted.GetFaces(order[i]));
      coder.CodePolyhedron(turns, SplitFaces(stream));
    }
  }
  return symbols.Finish();
}

void RestoreCorners(CellList& cells, std::span<const std::uint8_t> corners)
{
  EntropyDecoder symbols(corners);
  CornerCoder<EntropyDecoder> coder(symbols);
  for (std::size_t i = 0; i < cells.GetNumber(); ++i)
  {
    const auto own =
      std::span(cells.Corners).subspan(cells.Starts[i], cells.Starts[i + 1] - cells.Starts[i]);
    if (IsTetra(cells, i))
    {
      const auto restored = RotateCorners(GetTetra(cells, i), coder.CodeRotation(0));
      std::copy(restored.begin(), restored.end(), own.begin());
    }
    else if (cells.Types[i] == PolyhedronType)
    {
      RestorePolyhedron(coder, own,
        std::span(cells.Faces)
          .subspan(cells.FaceStarts[i], cells.FaceStarts[i + 1] - cells.FaceStarts[i]));
    }
  }
}
}
