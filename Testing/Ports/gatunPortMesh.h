// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunPortMesh_h
#define gatunPortMesh_h

// Meshes that are decoded and written anew.

#include "gatunPortFile.h"

#include "gatunFileReader.h"
#include "gatunFileWriter.h"
#include "gatunMergeTree.h"
#include "gatunMeshInput.h"
#include "gatunPieceDecoder.h"

#include <memory>
#include <string>
#include <vector>

namespace gatun::port
{
/** All that a piece has. */
struct PortPiece
{
  std::uint64_t Points = 0;
  std::uint64_t Cells = 0;
  bool IsTetrahedral = true;
  std::vector<std::uint8_t> Coordinates;
  std::vector<std::int64_t> Ids;
  std::vector<std::int64_t> Offsets; // these if it is not tetrahedral
  std::vector<std::uint8_t> Types;
  std::vector<std::int64_t> FaceLocations;
  std::vector<std::int64_t> Faces;
  std::vector<std::int64_t> GlobalPointIds;
  std::vector<std::int64_t> GlobalCellIds;
  std::vector<std::vector<std::uint8_t>> Arrays;

  void AddTo(Hash& hash) const;
  MeshInput GetInput(const FileReader& file) const;
  bool IsSameMesh(const PortPiece& other) const;
};

/** How a piece is decoded. */
struct PortRequest
{
  std::size_t Step = 0;
  PieceForm Form = PieceForm::Original;
  bool RestoreOrder = true;
  std::size_t Merges = 0;
  std::shared_ptr<const MergeTree> Tree;
};

PortPiece Decode(const std::shared_ptr<const FileReader>& file, const PortRequest& request);

/** A mesh of a file with all of its steps, in the order of the file. */
class PortMesh
{
public:
  explicit PortMesh(std::shared_ptr<const FileReader> file);

  /** The cells in both forms and all values of all steps, and the mesh after half of its merges. */
  void AddDecoded(Hash& hash) const;

  /** Options that make a file as this one is. */
  WriterOptions GetOptions() const;

  void Write(const std::string& path, const WriterOptions& options) const;

  /** Throws unless a file has this mesh. */
  void Compare(const std::string& path) const;

  std::shared_ptr<const FileReader> File;
  std::shared_ptr<const MergeTree> Tree; // the file's, or null
  std::vector<PortPiece> Steps;          // at least one
};

/** A mesh written in both profiles, with bounded errors, and with a tree of merges. */
void AddEncoded(Line& line, const PortMesh& mesh);

/** The same for a grid of so many cubes in each direction, whose points are moved, with values; and
 * the grid written in two parts. */
void AddGrid(Line& line, std::uint32_t cubes);
}

#endif
