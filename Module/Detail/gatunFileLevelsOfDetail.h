// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFileLevelsOfDetail_h
#define gatunFileLevelsOfDetail_h

#include "gatunExport.h"
#include "gatunLevelsOfDetail.h"
#include "gatunRayValues.h"
#include "gatunSharedFile.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace gatun
{
class FileCuts;
class RayChunks;

/**
 * The levels of detail of a file with a merge tree. A level comes from the coarsest base mesh of
 * the file that has enough points, or from the whole mesh. One for a view comes from several of
 * them (see FileCuts).
 */
class GATUN_EXPORT FileLevelsOfDetail final : public LevelsOfDetail
{
public:
  /** Sources keep their blocks within the budget of the file. Throws InvalidInput if the file has
   * no merge tree, or no such array or step. */
  FileLevelsOfDetail(std::shared_ptr<SharedFile> file, const RayValues& values);

  ~FileLevelsOfDetail() override;

  std::uint64_t GetNumberOfPoints() const override;
  std::uint64_t GetFewestPoints() const override;
  DetailLevel MakeLevel(const DetailRequest& request, const RaySource::Progress& progress) override;
  std::uint64_t EstimateTets(std::uint64_t points) const override;

private:
  std::uint64_t CountMerges(std::uint64_t points) const;
  DetailLevel MakeUniform(std::uint64_t points);
  std::size_t FindLevel(std::uint64_t points) const;
  std::size_t FindFinest(
    const DetailView& view, std::uint64_t points, bool isForRest, std::size_t coarse);
  std::shared_ptr<RayChunks> GetChunks(std::size_t level);
  FileCuts* FindCuts(std::size_t fine, std::size_t coarse, const RaySource::Progress& progress);

  const std::shared_ptr<SharedFile> File;
  RayValues Values;

  // For views: the chunks of levels that were used, and the last meshes of some levels.
  std::vector<std::shared_ptr<RayChunks>> Chunks;
  std::size_t Fine = 0;
  std::size_t Coarse = 0;
  std::unique_ptr<FileCuts> Cuts;
};
}

#endif
