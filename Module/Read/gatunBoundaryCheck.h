// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBoundaryCheck_h
#define gatunBoundaryCheck_h

#include "gatunBoundaryFaces.h"
#include "gatunFileReader.h"
#include "gatunPieceRequest.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/**
 * Compares the boundary in a file with that of its mesh, which arrives part by part: faces by the
 * coordinates and the values of their points, and by the values of their cells. Does nothing if
 * the file has no boundary. Memory goes with the faces between parts.
 */
class BoundaryCheck
{
public:
  explicit BoundaryCheck(const FileReader& file);

  /** Begins with another part. isOneOfMany: whether it is not the whole mesh. */
  void BeginPart(bool isOneOfMany);

  /** Adds the next time step of the part. The target has everything but ghosts and parents. */
  void AddStep(
    const PieceRequest& request, const PieceTarget& target, std::size_t points, std::size_t cells);

  /** Throws Error(Corrupt) if the boundary is another one than that in the file. */
  void Compare();

private:
  void FindFaces(const MeshAccess& mesh, const PieceRequest& request, const std::int64_t* numbers);
  std::vector<std::uint64_t> HashBoundary() const;

  const FileReader& File;
  bool IsOneOfMany = false;
  bool HasFaces = false;             // of the current part
  std::vector<BoundaryFace> Faces;   // open ones of the current part
  std::vector<std::uint32_t> Cells;  // of a lower dimension of the current part
  std::vector<std::uint64_t> Hashes; // of these faces and cells, over the time steps

  std::vector<BoundaryFace> AllFaces;    // of all parts; the cell is the place of its hash
  std::vector<std::uint64_t> FaceHashes; // of all parts
  std::vector<std::uint64_t> CellHashes;

  void EndPart();
};
}

#endif
