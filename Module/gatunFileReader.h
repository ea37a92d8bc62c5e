// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFileReader_h
#define gatunFileReader_h

#include "gatunFieldData.h"
#include "gatunLayers.h"
#include "gatunMergeTree.h"
#include "gatunTypes.h"
#include "vtkGatunCoreModule.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
class ChunkCache;

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

  /** Reads the whole file and checks every checksum and that every stream decodes. Returns false
   * if progress asked to stop; throws at the first thing that is wrong. */
  bool Verify(const std::function<bool(double)>& progress = {}) const;

  class Internals;
  const Internals& GetInternals() const { return *this->Self; }

private:
  FileReader(const FileReader& whole, std::size_t level);

  std::unique_ptr<Internals> Self;
};

/** Which part of a file to decode. */
struct PieceRequest
{
  std::vector<std::uint32_t> Chunks; ///< ascending; their tetrahedra make the piece

  /** Ascending, with all of Chunks: the mesh that the piece is one of, as if the file had no other
   * chunks. Ghosts come from there, and there is the owner of each point. Empty: the whole file. */
  std::vector<std::uint32_t> Universe;

  std::vector<std::uint32_t> Arrays; ///< indices into GetArrays(), ascending
  std::size_t Step = 0;
  unsigned GhostLevels = 0;      ///< layers of cells around the piece, sharing a point
  bool WithUnusedPoints = false; ///< points of no tetrahedron too (give them to one piece)
  bool RestoreOrder = true;      ///< original order, if kept and all chunks are asked for

  /** How many merges to make, by the tree of the file; corners keep no order then but orientation.
   * With ghosts the whole universe is decoded. */
  std::size_t Merges = 0;
  std::shared_ptr<const MergeTree> Tree; ///< the file's, if there are merges

  bool operator==(const PieceRequest&) const = default;
};

/** Where the caller wants the piece; each pointer may be null if not wanted. Sizes as announced. */
struct PieceTarget
{
  void* Points = nullptr;                 ///< 3 values a point of GetCoordinateType()
  void* Connectivity = nullptr;           ///< 4 ids a cell
  bool WideIds = true;                    ///< ids are std::int64_t, else std::int32_t
  std::vector<void*> Arrays;              ///< one for each array of the request, or empty
  std::int64_t* GlobalPointIds = nullptr; ///< original ids where the file keeps point order
  std::int64_t* GlobalCellIds = nullptr;  ///< original ids where the file keeps cell order

  /** 0: of the piece; 1: a duplicate, owned by another (VTK's DUPLICATEPOINT, DUPLICATECELL).
   * A shared point is owned by the lowest chunk of the universe that uses it. */
  unsigned char* PointGhosts = nullptr;
  unsigned char* CellGhosts = nullptr;
};

/**
 * Decodes pieces of a file into arrays of the caller, chunks in parallel.
 *
 * Order of the cells: chunk by chunk, ghosts last. Order of the points: those shared by chunks,
 * then each chunk's own, then unused ones, ghosts' last. What it decodes it leaves in a cache, so
 * that another time step, other arrays or a piece with the same chunks need not decode all again.
 * Not thread safe; but several may use one cache, each in a thread of its own.
 */
class VTKGATUNCORE_EXPORT PieceDecoder
{
public:
  using Progress = std::function<bool(double)>; ///< as in FileWriter; abort throws Aborted

  /** With a cache of its own, or with one that others may use too. */
  explicit PieceDecoder(std::shared_ptr<const FileReader> file);
  explicit PieceDecoder(std::shared_ptr<ChunkCache> cache);
  ~PieceDecoder();
  PieceDecoder(const PieceDecoder&) = delete;
  PieceDecoder& operator=(const PieceDecoder&) = delete;

  /** Prepares a request; afterwards the sizes are known (with ghosts this decodes the mesh). */
  void SetRequest(const PieceRequest& request, const Progress& progress = {});
  std::uint64_t GetNumberOfPoints() const;
  std::uint64_t GetNumberOfTets() const;

  /** Fills the target for the request last set. May be called again with other pointers. */
  void Fill(const PieceTarget& target, const Progress& progress = {});

  const std::shared_ptr<const FileReader>& GetFile() const;

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
