// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunParallelImage_h
#define gatunParallelImage_h

#include "gatunProcessExchange.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
class ByteReader;
class RayCaster;
struct RayGrid;
struct RayTable;
struct RayView;

/**
 * An image of cells that several processes have, in any partition.
 *
 * The image is divided into tiles of 32 by 32 rays, which the processes own in turn. Each process
 * casts its rays through its own cells and sends the fragments to the owners of the tiles, which
 * merge them. Each pixel is shown by one process, over what that has drawn there before: by the one
 * with the nearest opaque geometry, so that compositing by depth keeps it, or else by the owner of
 * the tile; or all pixels by a given process. An owner sends a pixel to the process that shows it.
 * Where there is no geometry, that is the owner itself.
 */
class ParallelImage
{
public:
  /** Size: in pixels. ImageProcess: the process that shows the image; -1: each its pixels. */
  ParallelImage(ProcessExchange& exchange, int width, int height, int imageProcess);

  int GetImageProcess() const { return this->ImageProcess; }

  /** Finds the nearest opaque geometry of all processes. Own: that of this one, for each pixel, row
   * by row from below, as in a z-buffer; empty for none. Collective. */
  void ShareDepths(std::span<const float> own);

  /** The nearest opaque geometry for each pixel; empty for none, as without ShareDepths. */
  const std::vector<float>& GetDepths() const { return this->Depths; }

  /** Merges what the casters of all processes have drawn, with the same view, table and grid, and
   * takes it from them. Caster: null for nothing. Collective. */
  void Merge(RayCaster* caster, const RayView& view, const RayTable& table, const RayGrid& grid);

  /** Leaves out the pixels with geometry in front of a depth. */
  void HideBehindGeometry(float depth);

  /** For each pixel, premultiplied color and opacity; 0 where another process shows it. */
  const std::vector<float>& GetColors() const { return this->Colors; }

  /** Makes depths a little smaller where this process shows the image, so that compositing by depth
   * keeps what it shows. Where there is no geometry, that may be nothing. Own: for each pixel. */
  void BringForward(std::span<float> own) const;

private:
  struct Tile
  {
    std::size_t Index;
    int X, Y, Width, Height; // of rays or pixels
  };

  template <typename Use>
  static void VisitTiles(int width, int height, Use&& use);
  template <typename Use>
  void VisitPixels(const Tile& tile, Use&& use) const;
  void PackDepths(
    std::span<const float> own, std::vector<ProcessExchange::Message>& messages) const;
  void UnpackDepths(const std::vector<ProcessExchange::Message>& messages);
  int GetOwner(const Tile& tile) const;
  int GetImageProcess(int x, int y) const;
  void PackExact(const Tile& tile, std::vector<ProcessExchange::Message>& messages) const;
  void PackAll(const Tile& tile, int width, std::vector<ProcessExchange::Message>& messages) const;
  void Unpack(
    const Tile& tile, bool exact, int width, ByteReader& reader, std::vector<float>& colors) const;
  void Interpolate(int width, int height);

  ProcessExchange& Exchange;
  int Width;
  int Height;
  int ImageProcess;
  std::vector<float> Depths;
  std::vector<std::uint16_t> Nearest; // process with the nearest geometry, or None
  std::vector<float> Rays;            // colors of rays
  std::vector<float> Colors;          // of pixels
};
}

#endif
