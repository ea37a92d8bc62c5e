// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunRayScene_h
#define gatunRayScene_h

#include "gatunFileInput.h"
#include "gatunGridRaySource.h"
#include "gatunPieceRaySource.h"
#include "gatunRayLevels.h"
#include "gatunRaySource.h"
#include "gatunTypes.h"

#include "vtkType.h"

#include <cstdint>
#include <memory>
#include <string>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkAlgorithm;
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
class FileReader;
class RayCaster;
struct RayView;

/** The part of the points to be merged away: that which is wanted, or what is asked of the reader
 * whose file is drawn, if that is more. */
double GetRatio(vtkAlgorithm* input, double ratio);

/**
 * What is drawn: a grid in memory, a file of which only what is seen is ever decoded, or a pipeline
 * of which a piece at a time is in memory. What has been prepared is kept, up to a budget, until
 * something else is to be drawn.
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

  /** Simplifies: whether simpler meshes are to be drawn, too, if that is possible. */
  void SetGrid(vtkUnstructuredGrid* grid, const RayArray& array, std::uint64_t budget,
    bool simplifies = false);
  void SetFile(const std::string& path, double time, const RayArray& array, std::uint64_t budget,
    bool simplifies = false);
  void SetPieces(const RayProducer& producer, int pieces, const RayArray& array,
    std::uint64_t budget, const RaySource::Progress& progress = {});
  void Clear();

  /** Of the points of a file. Opens it, and decodes nothing. */
  const Bounds& GetFileBounds(const std::string& path);

  /** From the file, since it was opened; 0 without one. */
  std::uint64_t GetBytesRead() const;

  /** Simpler meshes; null if they are not wanted, or cannot be made. */
  RayLevels* GetLevels() { return this->Levels.get(); }

  /** Why simpler meshes that were wanted cannot be made; empty if they can. */
  const std::string& GetObstacle() const { return this->Obstacle; }

  /** Draws what was set, or, if it is not null, another source of the same mesh. */
  void Draw(RayCaster& caster, const RayView& view, const RaySource::Progress& progress,
    RaySource* other = nullptr);

  /** Of the values of everything. */
  const Range& GetRange() const { return this->Values; }

  /** Of what was set as pieces. */
  const Bounds& GetPieceBounds() const { return this->Pieces->GetWholeBounds(); }

private:
  /** What a source was made for. */
  struct Key
  {
    const void* Grid = nullptr;
    std::shared_ptr<const FileReader> File; // held, so that no other comes to be at its address
    std::size_t Step = 0;
    RayProducer Producer;
    int Pieces = 0;
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
  void OpenFile(const std::string& path);

  Key Known;
  std::shared_ptr<RaySource> Source;
  std::unique_ptr<RayLevels> Levels;
  std::string Obstacle;
  PieceRaySource* Pieces = nullptr; // the source, if it is one
  Range Values;

  CurrentFile File;
};
}

#endif
