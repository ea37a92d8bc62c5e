// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPartSurface_h
#define gatunPartSurface_h

#include "gatunBoundaryMesh.h"
#include "gatunPartValues.h"
#include "gatunSpillSorter.h"
#include "gatunSurfaceCells.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
/**
 * Finds the boundary of a mesh that is written in parts. Faces between parts are in temporary files
 * until all parts are known. Memory: the boundary, at some 50 bytes a face.
 */
class PartSurface
{
public:
  /** folder: of temporary files. memory: before files are used. */
  PartSurface(const std::string& folder, std::size_t memory)
    : Walls(folder, memory)
  {
  }

  /** Adds a part whose mesh has been written. numbers: of its points in the file. isJoined: of each
   * point, whether other parts have it. */
  void Add(const WriterPart& part, std::span<const std::uint32_t> numbers,
    std::span<const std::uint8_t> isJoined);

  /** The boundary when all parts have been added. To be called once. */
  BoundaryMesh Finish(const WriterState& state, const PartValues& values);

private:
  /** A face whose corners are all in several parts. */
  struct Wall
  {
    static constexpr std::size_t Most = 4; // corners that a record has

    std::array<std::uint32_t, 3> Least;
    std::uint32_t Rest;
    std::uint32_t Cell; // of all parts
    std::uint16_t Number, Size;
    std::uint32_t Count; // of corners
    std::array<std::uint32_t, Most> Corners;
    std::uint64_t More; // the position of all corners, if there are more

    bool operator<(const Wall& other) const;
    bool IsSame(const Wall& other) const;
  };

  /** A cell of the boundary, whose corners are some of those of its list. */
  struct Face
  {
    std::uint32_t Cell;
    std::uint16_t Number;
    std::uint64_t Begin, End;
  };

  /** Cells of a boundary of the same list of a surface. */
  struct List
  {
    std::vector<Face> Faces;
    std::vector<std::uint32_t> Corners;

    void Add(std::uint32_t cell, std::uint16_t number, std::span<const std::uint32_t> corners);
  };

  void AddFaces(const WriterPart& part, std::span<const std::uint32_t> numbers,
    std::span<const std::uint8_t> isJoined);
  void AddCells(const WriterPart& part, std::span<const std::uint32_t> numbers);
  void AddWall(
    const BoundaryFace& face, std::uint32_t cell, std::span<const std::uint32_t> corners);
  void TakeWalls();

  SpillSorter<Wall> Walls;
  std::vector<std::uint32_t> MoreCorners; // of walls
  std::array<List, SurfaceLists> Lists;   // cells of a lower dimension
  List Faces;
};
}

#endif
