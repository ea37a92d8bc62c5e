// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBaseMeshes_h
#define gatunBaseMeshes_h

#include "gatunExport.h"

#include <cstddef>
#include <cstdint>

namespace gatun
{
class SharedFile;

/** What a view needs of the base mesh that its mesh is made from. */
struct BaseNeeds
{
  std::uint64_t Points = 0; ///< that are to be left
  double PixelError = 0;
  double Weight = 0; ///< the largest one: pixels of an error of 1
};

/** The finest places of a mesh for a view are those of a uniform mesh with this factor times its
 * points. */
constexpr std::uint64_t FinestToUniform = 8;

/** Whether a base mesh, a level of a file, is fine enough for a view: it has eight times as many
 * points as are to be left, or the merges that lead to it have no larger errors than the view
 * allows. */
GATUN_EXPORT bool IsFineEnough(SharedFile& file, std::size_t level, const BaseNeeds& needs);

/** The coarsest level that is fine enough for a view, from one level to a finer one; that one if
 * there is none. */
GATUN_EXPORT std::size_t FindBaseMesh(
  SharedFile& file, std::size_t coarsest, std::size_t finest, const BaseNeeds& needs);
}

#endif
