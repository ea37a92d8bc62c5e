// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPieceRaySource_h
#define gatunPieceRaySource_h

#include "gatunGridRaySource.h"
#include "gatunRayBlockCache.h"
#include "gatunRaySource.h"
#include "gatunTypes.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkAlgorithm;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
class RayCaster;
struct RayView;

/** Where a pipeline's mesh comes from. */
struct RayProducer
{
  vtkAlgorithm* Algorithm = nullptr;
  int Port = 0;

  bool operator==(const RayProducer&) const = default;
};

/** The pieces of one of several processes, each of which has as many. */
struct PieceShare
{
  int Pieces = 1; ///< of each process
  int Process = 0;
  int Processes = 1;

  bool operator==(const PieceShare&) const = default;
};

/** What is connected to an input port 0; without an algorithm if nothing is. */
RayProducer GetProducer(vtkAlgorithm* consumer);

/** The time that is asked of an output; 0 if none is. */
double GetRequestedTime(const RayProducer& producer);

/** Brings a piece of an output up to date, without ghost cells. */
void PullPiece(const RayProducer& producer, int piece, int pieces);

/**
 * The mesh that a pipeline makes, one piece in memory at a time. When made, it pulls each piece
 * once for its bounds and values. Blocks are kept up to a number of bytes; of pieces whose blocks
 * are all kept, or not seen, nothing is pulled again. As a source it is the piece selected.
 *
 * Methods throw gatun::Error as GridRaySource does, and InvalidInput if the pipeline fails.
 */
class PieceRaySource final : public RaySource
{
public:
  PieceRaySource(const RayProducer& producer, const PieceShare& share, const RayArray& array,
    std::uint64_t budget, const Progress& progress = {});
  ~PieceRaySource() override;

  /** Draws all pieces that can be seen, front to back. */
  void Draw(RayCaster& caster, const RayView& view, const Progress& progress);

  /** Of all pieces together. */
  const Bounds& GetWholeBounds() const { return this->Box; }
  const Range& GetWholeRange() const { return this->Values; }

  std::size_t GetNumberOfBlocks() const override;
  const Bounds& GetBounds(std::size_t block) const override;
  Range GetRange(std::size_t block) const override;
  Blocks GetBlocks(std::span<const std::size_t> blocks, const Progress& progress) override;

private:
  struct Piece
  {
    std::size_t FirstBlock = 0; ///< its place among the blocks of all pieces, for the cache
    Bounds Box;
    std::vector<Bounds> Boxes; ///< of its blocks
    std::vector<Range> Ranges;
  };

  void Select(std::size_t piece);
  void Pull();
  void Measure();
  void KeepBlocks();

  vtkSmartPointer<vtkAlgorithm> Owner; // keeps the producer alive
  RayProducer Producer;
  PieceShare Share;
  RayArray Array;
  RayBlockCache Cache;
  bool IsFull; // whether the cache has refused a block
  std::vector<Piece> Pieces;
  std::size_t Selected = 0;
  std::unique_ptr<GridRaySource> Grid; // the piece selected, once it was pulled
  Bounds Box;
  Range Values;
};
}

#endif
