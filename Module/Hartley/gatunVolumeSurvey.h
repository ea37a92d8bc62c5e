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
 * Finds how many voxels of a volume have which values. Of larger volumes than MostSurveyedVoxels,
 * cubes from all parts of the volume are taken, of a file whole chunks. Range: as for SurveyValues.
 * The box is that of the volume along its own axes. Voxels that are not finite are left out.
 */
GATUN_EXPORT ValueSurvey SurveyVolume(
  const VolumeInput& volume, const std::optional<Range>& range = {});

/** The same for the decoded voxels of a file. Throws if the file is damaged. */
GATUN_EXPORT ValueSurvey SurveyVolume(
  const HartleyFile& file, const std::optional<Range>& range = {});
}

#endif
