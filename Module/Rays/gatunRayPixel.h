// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayPixel_h
#define gatunRayPixel_h

#include "gatunRayTable.h"
#include "gatunRayTile.h"

#include <vector>

namespace gatun
{
/** The fragment of a ray that meets nothing. */
constexpr Fragment NoFragment()
{
  return { 0, 0, -RayTile::Never, 0, { 0, 0, 0, 1 } };
}

/** Sorts the fragments of a pixel and composites them. */
Fragment CompositeFragments(std::vector<Fragment>& fragments);

/** Color and opacity of a pixel. In mode Maximum only the largest place in the table counts, or
 * RayTile::Never for none; in other modes only the sums. */
void ToPixel(const RayTable& table, const Fragment& sum, float largest, float* rgba);
}

#endif
