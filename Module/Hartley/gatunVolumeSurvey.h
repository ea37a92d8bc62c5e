// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunVolumeSurvey_h
#define gatunVolumeSurvey_h

#include "gatunDefaultOpacity.h"
#include "gatunExport.h"
#include "gatunHartleyInput.h"
#include "gatunTypes.h"

#include <cstdint>
#include <optional>

namespace gatun
{
class HartleyFile;

/** Volumes of up to this number of voxels are surveyed as a whole. */
constexpr std::uint64_t MostSurveyedVoxels = std::uint64_t{ 1 } << 23;

/**
 * Makes the histogram of the voxels of a volume. Of volumes above MostSurveyedVoxels, it takes
 * cubes (of a file, whole chunks) from all parts of the volume. Range: as for SurveyValues. The box
 * of the volume is along its own axes. Voxels that are not finite are left out.
 */
GATUN_EXPORT ValueSurvey SurveyVolume(
  const VolumeInput& volume, const std::optional<Range>& range = {});

/** The same for the decoded voxels of a file. Throws if the file is damaged. */
GATUN_EXPORT ValueSurvey SurveyVolume(
  const HartleyFile& file, const std::optional<Range>& range = {});
}

#endif
