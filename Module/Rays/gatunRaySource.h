// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRaySource_h
#define gatunRaySource_h

#include "gatunCacheBudget.h"
#include "gatunFileReader.h"
#include "gatunMeshInput.h"
#include "gatunRayBlock.h"
#include "gatunTypes.h"
#include "vtkGatunCoreModule.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace gatun
{
class ChunkCache;

/** A mesh in blocks, as much of which is made as is asked for. Not thread safe. */
class VTKGATUNCORE_EXPORT RaySource
{
public:
  /** Called with the fraction done; returns false to stop, and Error(Aborted) is thrown. */
  using Progress = std::function<bool(double)>;
  using Blocks = std::vector<std::shared_ptr<const RayBlock>>;

  virtual ~RaySource() = default;

  virtual std::size_t GetNumberOfBlocks() const = 0;
  virtual const Bounds& GetBounds(std::size_t block) const = 0;
  virtual Range GetRange(std::size_t block) const = 0; ///< of its values, without NaN

  /** Blocks ready for drawing, in the order asked for. */
  virtual Blocks GetBlocks(std::span<const std::size_t> blocks, const Progress& progress) = 0;
};

/** Keeps blocks within a budget. Blocks that have not been used for the longest time are removed
 * first. Thread safe. */
class VTKGATUNCORE_EXPORT RayBlockCache
{
public:
  /** Budget: in bytes. */
  explicit RayBlockCache(std::uint64_t budget);

  /** A cache that shares a budget with others. */
  explicit RayBlockCache(std::shared_ptr<CacheBudget> budget);

  ~RayBlockCache();
  RayBlockCache(const RayBlockCache&) = delete;
  RayBlockCache& operator=(const RayBlockCache&) = delete;

  /** The block, or null if it is not here. */
  std::shared_ptr<const RayBlock> Find(std::size_t block);
  void Add(std::size_t block, std::shared_ptr<const RayBlock> made);

  CacheStatistics GetStatistics() const;

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};

/** Which values are drawn. */
struct RayValues
{
  std::uint32_t Array = 0; ///< index into FileReader::GetArrays()
  int Component = 0;       ///< -1: the Euclidean length of the tuple
  std::size_t Step = 0;
};

/** The range of what is drawn, from those that a file keeps of an array; component as in RayValues.
 * Of arrays with one component a file keeps none of the tuples' lengths. */
VTKGATUNCORE_EXPORT Range GetDrawnRange(const ArrayRanges& ranges, int component);

/** The chunks of a file. Blocks that have been decoded are kept up to a number of bytes. */
class VTKGATUNCORE_EXPORT FileRaySource final : public RaySource
{
public:
  /** Throws InvalidInput if the file has no such array or step. */
  FileRaySource(
    std::shared_ptr<const FileReader> file, const RayValues& values, std::uint64_t budget);

  /** Uses a cache that others use, too, and keeps blocks within the same budget. */
  FileRaySource(std::shared_ptr<ChunkCache> parts, const RayValues& values);

  ~FileRaySource() override;

  std::size_t GetNumberOfBlocks() const override;
  const Bounds& GetBounds(std::size_t block) const override;
  Range GetRange(std::size_t block) const override;
  Blocks GetBlocks(std::span<const std::size_t> blocks, const Progress& progress) override;

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};

/** Values in the caller's memory. */
struct RayValuesInput
{
  Association Where = Association::Point;
  ScalarType Type = ScalarType::Float32;
  std::uint32_t Components = 1;
  int Component = 0; ///< -1: the Euclidean length of the tuple
  const void* Values = nullptr;
};

/**
 * A mesh in the caller's memory, which must stay there, in blocks of tetrahedra that are near each
 * other. Blocks that have been made are kept up to a number of bytes.
 */
class VTKGATUNCORE_EXPORT MemoryRaySource final : public RaySource
{
public:
  static constexpr std::uint32_t DefaultBlockTets = 32768;

  /** Hidden: null, or for each tetrahedron whether it is left out. Throws InvalidInput if a
   * tetrahedron names a point that is not there. */
  MemoryRaySource(const MeshInput& mesh, const RayValuesInput& values, const unsigned char* hidden,
    std::uint64_t budget, std::uint32_t blockTets = DefaultBlockTets,
    const Progress& progress = {});
  ~MemoryRaySource() override;

  std::size_t GetNumberOfBlocks() const override;
  const Bounds& GetBounds(std::size_t block) const override;
  Range GetRange(std::size_t block) const override;
  Blocks GetBlocks(std::span<const std::size_t> blocks, const Progress& progress) override;

private:
  class Internals;
  std::unique_ptr<Internals> Self;
};
}

#endif
