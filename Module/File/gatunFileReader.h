// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFileReader_h
#define gatunFileReader_h

#include "gatunFieldData.h"
#include "gatunLayers.h"
#include "gatunMergeTree.h"
#include "gatunTypes.h"
#include "vtkGatunCoreModule.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
/**
 * An open .gtn file: all that its directory tells, without decoding any chunk.
 *
 * Safe on hostile input: whatever the bytes are, every method returns or throws gatun::Error with
 * a message "file: what is wrong, and where". Immutable and thread safe once made.
 */
class VTKGATUNCORE_EXPORT FileReader
{
public:
  /** Whether the file begins as a .gtn file does, of whatever version. Never throws. */
  static bool CanRead(const std::string& path) noexcept;

  explicit FileReader(const std::string& path);
  ~FileReader();
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;

  const std::string& GetPath() const;
  std::uint64_t GetNumberOfPoints() const;
  std::uint64_t GetNumberOfTets() const;
  std::uint64_t GetNumberOfSharedPoints() const; ///< used by several chunks
  std::uint64_t GetNumberOfUnusedPoints() const; ///< used by no tetrahedron; they come last
  ScalarType GetCoordinateType() const;
  bool HasWideIds() const;           ///< MeshInput::WideIds
  std::uint8_t GetKeptOrder() const; ///< flags of KeepOrder
  const Bounds& GetBounds() const;
  const std::string& GetWriterVersion() const;  ///< version of the package that wrote the file
  std::pair<int, int> GetFormatVersion() const; ///< major, minor

  const std::vector<ArrayDescription>& GetArrays() const;

  /** Number of steps; 1 for a file without time (0 if no values were ever written). */
  std::size_t GetNumberOfSteps() const;
  bool HasTime() const;
  const std::vector<double>& GetTimes() const; ///< one a step, strictly ascending

  const std::vector<ChunkInfo>& GetChunks() const;

  /** Ranges of an array over the whole mesh, or over one chunk (shared points included). */
  const ArrayRanges& GetRanges(std::size_t array, std::size_t step) const;
  const ArrayRanges& GetChunkRanges(std::size_t array, std::size_t step, std::size_t chunk) const;

  /** Field data of a step; decoded anew at each call. */
  FieldData GetFieldData(std::size_t step) const;

  FileStatistics GetStatistics() const;

  /** Bytes of the mesh and of each array (of the step) that a chunk alone takes in the file. */
  std::uint64_t GetChunkMeshBytes(std::size_t chunk) const;
  std::uint64_t GetChunkArrayBytes(std::size_t chunk, std::size_t array, std::size_t step) const;

  /** Bytes of the mesh and of arrays (at a step, without those before it) that some chunks take,
   * with what they need of the points that they share with others. */
  std::uint64_t GetPieceBytes(std::span<const std::uint32_t> chunks,
    std::span<const std::uint32_t> arrays, std::size_t step) const;

  /** By which values the file is organised, if it is. */
  bool HasLayers() const;
  const Layers& GetLayers() const; ///< without bounds and chunks if it is not

  /** Whether the file tells how its mesh becomes simpler. */
  bool HasMergeTree() const;
  std::size_t GetNumberOfMerges() const; ///< 0 if it does not

  /** The tree, of the points as the file numbers them (see PieceDecoder); decoded anew at each
   * call. A file that has none gives one without merges. */
  MergeTree GetMergeTree() const;

  /** Of each base mesh in the file, how many merges it has behind it; ascending. */
  const std::vector<std::uint32_t>& GetLevels() const;

  /** A base mesh, with the rest of the tree if there is one. Its points are those that are left of
   * this one's, in an order of their own. */
  std::shared_ptr<const FileReader> OpenLevel(std::size_t level) const;

  /** Bounds of a chunk, and ranges of an array over it, after any number of merges up to this one.
   * They hold for all that its tetrahedra become. */
  const Bounds& GetChunkBounds(std::size_t chunk, std::size_t merges) const;
  const ArrayRanges& GetChunkRanges(
    std::size_t array, std::size_t step, std::size_t chunk, std::size_t merges) const;

  /** Bytes read from the file since it was opened, by all threads. */
  std::uint64_t GetBytesRead() const;

  class Internals;

private:
  friend const Internals& InternalsOf(const FileReader& file);

  FileReader(const FileReader& whole, std::size_t level);

  std::unique_ptr<Internals> Self;
};
}

#endif
