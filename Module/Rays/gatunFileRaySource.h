// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFileRaySource_h
#define gatunFileRaySource_h

#include "gatunExport.h"
#include "gatunRaySource.h"
#include "gatunRayValues.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace gatun
{
class ChunkCache;
class FileReader;

/** The chunks of a file as blocks. Decoded blocks are kept within a budget. */
class GATUN_EXPORT FileRaySource final : public RaySource
{
public:
  /** Budget: in bytes. Throws InvalidInput if the file has no such array or step. */
  FileRaySource(
    std::shared_ptr<const FileReader> file, const RayValues& values, std::uint64_t budget);

  /** Uses a shared cache, and keeps blocks within the same budget. */
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
}

#endif
