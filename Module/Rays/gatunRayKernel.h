// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayKernel_h
#define gatunRayKernel_h

// The loops of the ray caster that have a version for each instruction set.

#include "gatunInline.h"
#include "gatunRayBlock.h"
#include "gatunRayColoring.h"
#include "gatunRayInstructions.h"
#include "gatunRayShading.h"
#include "gatunRayTable.h"
#include "gatunRayTile.h"
#include "gatunRayView.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace gatun
{
/** The projection of a point: pixel, and distance in samples; NaN if it is not in front of the eye.
 */
struct alignas(16) SeenPoint
{
  float X, Y, Samples, Value;
};

/** The pixels that a tetrahedron may cover; none, if it cannot be seen. */
struct SeenTet
{
  float Nearest; // lower bound of its distances
  std::int16_t FirstX, FirstY, LastX, LastY;

  bool IsEmpty() const { return this->LastX < this->FirstX; }
};

/** The tetrahedra that are skipped before their planes are set up. */
enum class RayFilter : std::uint8_t
{
  None,   ///< those outside of the image
  Pixels, ///< also those between the rays: their bounding box contains no pixel
  Samples ///< also those between two samples of all rays
};

/** Calls use(tile) for each tile that a tetrahedron may reach and that is not opaque in front of
 * it. */
template <typename Use>
GATUN_INLINE void ForEachTile(const SeenTet& seen, int tilesX, const float* limits, Use&& use)
{
  for (int y = seen.FirstY / RayTile::Size; y <= seen.LastY / RayTile::Size; ++y)
  {
    for (int x = seen.FirstX / RayTile::Size; x <= seen.LastX / RayTile::Size; ++x)
    {
      const int tile = y * tilesX + x;
      if (seen.Nearest < limits[tile])
      {
        use(tile);
      }
    }
  }
}

/** A tetrahedron in a tile. Pixels are counted from the tile's corner. */
struct TetItem
{
  // The plane of a face is at depth Base + x StepX + y StepY at pixel (x, y), measured in samples
  // or, in perspective, as -1 / Z. The planes through which rays enter come first.
  std::array<float, 4> Base, StepX, StepY;

  // The place in the table at distance k is T + x TX + y TY + k TK, or in perspective
  // T + k / SamplesPerDepth(x, y) (TK + x TX + y TY); and it is from TMin to TMax.
  float T, TX, TY, TK;
  float TMin, TMax;

  std::uint8_t FirstX, FirstY, LastX, LastY;
  std::uint8_t Entries;                // number of planes through which rays enter
  bool Transparent;                    // values from TMin to TMax are invisible
  std::uint16_t FirstPiece, LastPiece; // of the table, from TMin to TMax
};

/** Items of a tile. */
struct TetItems
{
  const TetItem* Items;
  std::size_t Count;

  // The shade of item i is Shades[Origins[i]], and its colors are Hues[Origins[i]]. Null without
  // shading, and if the colors are those of the table; not both are there.
  const std::uint32_t* Origins;
  const RayShade* Shades;
  const RayHue* Hues;

  int FirstX, FirstY; // the corner of the tile in the image
};

/** What determines colors besides the table. */
enum class RayLook : std::uint8_t
{
  Plain,  ///< nothing
  Shaded, ///< the light on a tetrahedron, by its RayShade
  Hued    ///< a RayHue in place of the table
};

/** The parameters of Draw. */
struct DrawContext
{
  bool Perspective;
  const RayTable::Cell* Table;
  const RayTable::Piece* Pieces; // null in modes without
  float Opaque;                  // a fragment with a lower transmittance hides everything behind it
};

/** The parameters of SetUp besides the mesh. */
struct SetUpContext
{
  const RayView* View;
  int TilesX;                        // tiles in a row
  const float* Limits;               // RayTile::Limit of each tile
  const std::uint32_t* VisibleCells; // RayTable::VisibleCells
  int TableSize;
  const std::array<std::uint16_t, 2>* PiecesOf; // RayTable's, null in modes without
  double Low, Scale;                            // RayTable's
};

/** The loops that have a version for each instruction set. */
struct RayKernel
{
  using Tet = std::array<std::uint32_t, 4>;

  const char* Name;

  /** Transforms points to ray coordinates, and values to places in the table: (value - low) scale.
   */
  void (*Transform)(const RayView& view, double low, double scale, const RayPoint* points,
    std::size_t count, RayPoint* rayPoints, SeenPoint* seenPoints);

  /** Finds the pixels that tetrahedra may cover (none for those that the filter skips), their faces
   * towards the eye (bit i: the face opposite to corner i) and away from it (bit 4 + i). Turned:
   * whether the volume is negative in world coordinates. */
  void (*Look)(const RayView& view, RayFilter filter, const SeenPoint* points, const Tet* tets,
    const std::uint8_t* turned, std::size_t count, SeenTet* seen, std::uint8_t* facing);

  /** Makes the items of the chosen tetrahedra for all tiles that they reach. Places: for each tile,
   * the place of its next item. CellValues: null, or the values of tetrahedra, which replace those
   * at points. Origins: null, or gets the index into chosen for each item. */
  void (*SetUp)(const SetUpContext& context, const RayPoint* points, const Tet* tets,
    const double* cellValues, const SeenTet* seen, const std::uint32_t* chosen, std::size_t count,
    std::uint32_t* places, TetItem* items, std::uint32_t* origins);

  /** Modes Maximum and XRay are never shaded. Mode Maximum has the colors of the table. */
  void (*Draw)(RayMode mode, const DrawContext& context, const TetItems& items, RayTile& tile);
};

/** The kernel for any processor. */
const RayKernel& GetPortableRayKernel();

/** The kernels for processors with AVX2 and FMA, and with AVX-512 F, VL, DQ and BW; null in builds
 * for another architecture. */
const RayKernel* GetAVX2RayKernel();
const RayKernel* GetAVX512RayKernel();

/** The kernel for an instruction set, or for the next simpler one that this processor has. */
const RayKernel& GetRayKernel(RayInstructions instructions);
}

#endif
