// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunValueSurvey_h
#define gatunValueSurvey_h

#include "gatunDefaultOpacity.h"
#include "gatunExport.h"
#include "gatunRaySource.h"
#include "gatunTypes.h"

#include <cstdint>
#include <optional>

namespace gatun
{
/** Meshes of up to this number of tetrahedra are surveyed as a whole. */
constexpr std::uint64_t MostSurveyedTets = std::uint64_t{ 1 } << 21;

/**
 * Makes the histogram of the values of a mesh, by volume. Of meshes above MostSurveyedTets, it
 * takes blocks from all parts of the mesh, at least 16. The result does not depend on the number of
 * threads and, if all of the mesh is surveyed, neither on the blocks nor on the order of
 * tetrahedra.
 *
 * Range: of the values that count. A given range is kept; otherwise it is narrowed as by
 * MakeValueHistogram. Tetrahedra with a value or coordinate that is not finite are left out. Throws
 * the exceptions of the source.
 */
GATUN_EXPORT ValueSurvey SurveyValues(RaySource& source, const std::optional<Range>& range = {},
  const RaySource::Progress& progress = {}, std::uint64_t mostTets = MostSurveyedTets);
}

#endif
