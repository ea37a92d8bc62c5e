// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunRayScene_h
#define gatunRayScene_h

#include "gatunGridRaySource.h"
#include "gatunLevelOfDetailCache.h"
#include "gatunPieceRaySource.h"
#include "gatunRaySource.h"
#include "gatunTypes.h"

#include "vtkType.h"

#include <cstdint>
#include <memory>
#include <string>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
struct PublishedFile;
class RayCaster;
struct RayView;
class SharedFile;

/**
 * The mesh of an image: a grid in memory, a file of which only visible chunks are decoded, or a
 * pipeline of which one piece at a time is in memory. Prepared blocks are kept until another mesh
 * is to be drawn: those of a file within its budget, others within a budget of their own.
 *
 * Methods throw gatun::Error: no such array, cells that cannot be drawn, a file that is damaged.
 */
class RayScene
{
public:
  RayScene();
  ~RayScene();
  RayScene(RayScene&&) = delete;
  RayScene& operator=(RayScene&&) = delete;

  /** Simplifies: whether coarser meshes are to be drawn, too, if that is possible. */
  void SetGrid(vtkUnstructuredGrid* grid, const RayArray& array, std::uint64_t budget,
    bool simplifies = false);
  void SetFile(
    const PublishedFile& handle, std::size_t step, const RayArray& array, bool simplifies = false);
  void SetPieces(const RayProducer& producer, const PieceShare& pieces, const RayArray& array,
    std::uint64_t budget, const RaySource::Progress& progress = {});
  void Clear();

  /** From the file, since it was opened, by all its consumers; 0 without one. */
  std::uint64_t GetBytesRead() const;

  /** Coarser meshes; null if they are not wanted, or cannot be made. */
  LevelOfDetailCache* GetLevels() { return this->Levels.get(); }

  /** The reason why coarser meshes that were wanted cannot be made; empty if they can. */
  const std::string& GetReason() const { return this->Reason; }

  /** Draws what was set, or, if it is not null, another source of the same mesh. */
  void Draw(RayCaster& caster, const RayView& view, const RaySource::Progress& progress,
    RaySource* other = nullptr);

  /** What was set; null for pieces, as a source has one of them at a time, and for nothing. */
  std::shared_ptr<RaySource> GetSource() const { return this->Pieces ? nullptr : this->Source; }

  /** Of the values of everything. */
  const Range& GetRange() const { return this->Values; }

  /** Of what was set as pieces. */
  const Bounds& GetPieceBounds() const { return this->Pieces->GetWholeBounds(); }

private:
  /** What a source was made for. */
  struct Key
  {
    const void* Grid = nullptr;
    std::shared_ptr<SharedFile> File; // held, so that no other comes to be at its address
    std::size_t Step = 0;
    RayProducer Producer;
    PieceShare Pieces;
    double Time = 0;
    vtkMTimeType Stamp = 0;
    RayArray Array;
    std::uint64_t Budget = 0;
    bool Simplifies = false;

    bool operator==(const Key&) const = default;
  };

  bool IsKnown(const Key& key);
  void Drop();
  void Take(const Key& key, std::shared_ptr<RaySource> source, const Range& values);

  Key Known;
  std::shared_ptr<RaySource> Source;
  std::unique_ptr<LevelOfDetailCache> Levels;
  std::string Reason;
  PieceRaySource* Pieces = nullptr; // the source, if it is one
  Range Values;
};
}

#endif
