// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFileLevelsOfDetail_h
#define gatunFileLevelsOfDetail_h

#include "gatunLevelsOfDetail.h"
#include "gatunRayValues.h"
#include "gatunSharedFile.h"
#include "gatunSimplifiedFile.h"
#include "vtkGatunCoreModule.h"

#include <cstdint>
#include <memory>

namespace gatun
{
/**
 * The levels of detail of a file with a merge tree. A level comes from the coarsest base mesh of
 * the file that has enough points, or from the whole mesh.
 */
class VTKGATUNCORE_EXPORT FileLevelsOfDetail final : public LevelsOfDetail
{
public:
  /** Throws InvalidInput if the file has no merge tree, or no such array or step. */
  FileLevelsOfDetail(std::shared_ptr<const FileReader> file, const RayValues& values);

  /** The same for a file that others use, too. Its sources keep their blocks within the budget of
   * the file, whatever budget MakeSource is given. */
  FileLevelsOfDetail(std::shared_ptr<SharedFile> shared, const RayValues& values);

  ~FileLevelsOfDetail() override;

  std::uint64_t GetNumberOfPoints() const override;
  std::uint64_t GetFewestPoints() const override;
  std::shared_ptr<RaySource> MakeSource(std::uint64_t points, std::uint64_t budget) override;
  std::uint64_t EstimateTets(std::uint64_t points) const override;

private:
  std::uint64_t CountMerges(std::uint64_t points) const;

  std::shared_ptr<SharedFile> Shared;        // null for a file of one's own
  const std::shared_ptr<SimplifiedFile> Own; // null for a shared one
  SimplifiedFile& File;                      // of these two
  RayValues Values;
};
}

#endif
