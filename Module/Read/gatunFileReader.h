// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFileReader_h
#define gatunFileReader_h

#include "gatunExport.h"
#include "gatunFieldData.h"
#include "gatunLayers.h"
#include "gatunMergeTree.h"
#include "gatunTypes.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
struct CellMask;
struct RemainingCounts;
struct Quantizer;

class ByteSource;
class MergeDependencies;

/**
 * An open .gtn file. Provides the content of its directory without decoding chunks. Details of
 * chunks are read on request.
 *
 * Safe on hostile input: for any bytes, every method returns or throws Error with file and
 * position. Immutable and thread safe.
 */
class GATUN_EXPORT FileReader
{
public:
  /** Whether the file has the signature of .gtn files of any version. Never throws. */
  static bool CanRead(const std::string& path) noexcept;

  /** Whether the file is a readable .gtn file of a surface. Reads only its directory. Never throws.
   */
  static bool IsSurfaceFile(const std::string& path) noexcept;

  explicit FileReader(const std::string& path);

  /** Bytes from elsewhere than a file on disk. name: that of the source in messages. */
  FileReader(std::shared_ptr<const ByteSource> source, const std::string& name);
  ~FileReader();
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;

  const std::string& GetPath() const;
  std::uint64_t GetNumberOfPoints() const;
  std::uint64_t GetNumberOfCells() const;
  std::uint64_t GetNumberOfTets() const;                  ///< of which the cells consist
  bool IsTetrahedral() const;                             ///< whether all cells are tetrahedra
  const std::vector<CellTypeCount>& GetCellTypes() const; ///< by ascending type
  bool IsSurface() const;                                 ///< WriterOptions::IsSurface
  std::uint64_t GetNumberOfSharedPoints() const;          ///< shared by several chunks
  std::uint64_t GetNumberOfUnusedPoints() const;          ///< used by no cell; numbered last
  ScalarType GetCoordinateType() const;
  const PointsDescription& GetPointArray() const; ///< the name of the points and their keys
  bool HasWideIds() const;                        ///< MeshInput::WideIds
  std::uint8_t GetKeptOrder() const;              ///< flags of KeepOrder
  Profile GetProfile() const;                     ///< WriterOptions::Coding
  const Bounds& GetBounds() const; ///< of the mesh: at the first time step if its points move

  /** Whether time steps have coordinates of their own (WriterOptions::PointsMove). */
  bool HasMovingPoints() const;

  /** The step with the coordinates of a step: an earlier one if its points do not move, and 0 for
   * the coordinates of the mesh. */
  std::size_t GetPointStep(std::size_t step) const;

  /** The bounds at a step. */
  Bounds GetBounds(std::size_t step) const;

  const std::string& GetWriterVersion() const; ///< version of the package that wrote the file
  std::uint32_t GetFormatVersion() const;

  const std::vector<ArrayDescription>& GetArrays() const;

  /** The number of time steps that have this mesh. 1 for a file without time, 0 if no values were
   * written. */
  std::size_t GetNumberOfSteps() const;
  bool HasTime() const;
  const std::vector<double>& GetTimes() const; ///< one for each step, strictly ascending

  /** The number of meshes: more than 1 if the mesh changes. This is the first one. A mesh with only
   * some of the cells of another one counts, too. */
  std::size_t GetNumberOfMeshes() const;

  /** The mesh with all cells, for one that has some of them; otherwise the same mesh. */
  std::size_t GetParentMesh(std::size_t mesh) const;

  /** Whether this is no mesh of which some cells are left out at some time steps. Such a mesh has
   * the chunks, the time steps, the bounds and the numbers of points and cells (GlobalPointIds,
   * GlobalCellIds) of the mesh with all cells. The numbers of tetrahedra of other cells are
   * estimates. */
  bool HasAllCells() const;

  /** The time steps of all meshes, by strictly ascending time. Empty unless there are several
   * meshes. */
  const std::vector<SeriesStep>& GetSeries() const;

  /** The times of the steps of all meshes; without time, none. */
  std::vector<double> GetSeriesTimes() const;

  /** A mesh other than this one, from 1, with the steps that have it. It has the same arrays.
   * Opened at each call. parent: the mesh of GetParentMesh, if that is open and another one, or
   * null. */
  std::shared_ptr<const FileReader> OpenMesh(
    std::size_t mesh, const std::shared_ptr<const FileReader>& parent = {}) const;

  const std::vector<ChunkInfo>& GetChunks() const;

  /** The other chunks that share a point with a chunk, ascending. Found at each call. */
  std::vector<std::uint32_t> GetNeighbors(std::size_t chunk) const;

  /** The ranges of an array over the mesh or over one chunk, shared points included. Those of
   * chunks are read at each call. */
  const ArrayRanges& GetRanges(std::size_t array, std::size_t step) const;
  ArrayRanges GetChunkRanges(std::size_t array, std::size_t step, std::size_t chunk) const;

  /** How the values of a component were rounded, none if they are exact. */
  Quantizer GetRounding(std::size_t array, std::size_t component, std::size_t step) const;

  /** The field data of a step, decoded at each call. */
  FieldData GetFieldData(std::size_t step) const;

  FileStatistics GetStatistics() const;

  /** Tells a remote source that the whole file will be described: its statistics, and the counts of
   * the meshes in it. */
  void AnnounceDescription() const;

  /** The size in the file of the mesh of a chunk and of its array at a step, without shared points.
   */
  std::uint64_t GetChunkMeshBytes(std::size_t chunk) const;
  std::uint64_t GetChunkArrayBytes(std::size_t chunk, std::size_t array, std::size_t step) const;

  /** The size in the file of the meshes of some chunks and of their arrays at a step, with the
   * shared points that they need. Previous steps are not counted. */
  std::uint64_t GetPieceBytes(std::span<const std::uint32_t> chunks,
    std::span<const std::uint32_t> arrays, std::size_t step) const;

  /** The layers that the file is organized by, if any. */
  bool HasLayers() const;
  const Layers& GetLayers() const; ///< empty if there are none

  /** Whether the file has a merge tree. */
  bool HasMergeTree() const;
  std::size_t GetNumberOfMerges() const; ///< 0 without merge tree

  /** The merge tree in the numbers of the file's points (see PieceDecoder), decoded at each call.
   * Without merge tree, returns a tree without merges. */
  MergeTree GetMergeTree() const;

  /** Whether the file has the dependencies of its merges (WriterOptions::Dependencies). */
  bool HasDependencies() const;

  /** The dependencies of the merges, decoded at each call. tree: GetMergeTree(). Throws
   * InvalidInput if the file has none. */
  MergeDependencies ReadDependencies(const MergeTree& tree) const;

  /** The number of merges that lead to each base mesh of the file, ascending. */
  const std::vector<std::uint32_t>& GetLevels() const;

  /** A base mesh with the remaining merges, if any. Its points are the remaining ones of this mesh
   * in an order of their own. */
  std::shared_ptr<const FileReader> OpenLevel(std::size_t level) const;

  /** What that consists of, by a part of its tables. */
  MeshCounts CountLevel(std::size_t level) const;

  /** Whether the file has the boundary of the mesh (WriterOptions::Boundary). */
  bool HasBoundary() const;

  /** The boundary, a surface with the arrays and time steps of this file and without field data.
   * Opened at each call. */
  std::shared_ptr<const FileReader> OpenBoundary() const;
  MeshCounts CountBoundary() const;

  /** The bounds of a chunk and the ranges of an array after any number of merges up to the given
   * one. They include all corners that the chunk's tetrahedra can get. */
  const Bounds& GetChunkBounds(std::size_t chunk, std::size_t merges) const;
  ArrayRanges GetChunkRanges(
    std::size_t array, std::size_t step, std::size_t chunk, std::size_t merges) const;

  /** The bounds of a chunk at a step, after any number of merges. */
  Bounds GetChunkBounds(std::size_t chunk, std::size_t merges, std::size_t step) const;

  /** The number of bytes read from the file since it was opened, by all threads. */
  std::uint64_t GetBytesRead() const;

  class Internals;

private:
  friend const Internals& InternalsOf(const FileReader& file);
  friend std::shared_ptr<const CellMask> MaskOf(const FileReader& file);

  explicit FileReader(std::shared_ptr<const Internals> self);
  void SetMask(std::uint32_t mask);

  ArrayRanges GetRangesAfter(
    std::uint32_t array, std::size_t step, std::size_t chunk, std::size_t merges) const;

  std::shared_ptr<const Internals> Self;

  // If some cells are left out.
  std::uint32_t Mask = 0;
  std::shared_ptr<const RemainingCounts> Remaining;
  std::vector<ChunkInfo> MaskedChunks;
  std::uint64_t MaskedTets = 0;
};
}

#endif
