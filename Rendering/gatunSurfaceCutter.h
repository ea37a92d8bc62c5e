// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceCutter_h
#define gatunSurfaceCutter_h

#include "gatunBackgroundWorker.h"
#include "gatunPublishedFile.h"
#include "gatunSurfaceDetail.h"
#include "gatunSurfaceLevel.h"

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <vector>

namespace gatun
{
/** A surface for a view. */
struct SurfaceCutOrder
{
  PublishedFile Source;
  SurfaceContents What;
  std::size_t Merges = 0;        ///< those that are made in any case
  std::uint64_t MemoryLimit = 0; ///< for base meshes, in bytes
  SurfaceDetailView View;
};

/** The result of an order: a surface, none as there is no room for one that is fine enough, or the
 * reason why it failed. */
struct SurfaceCutResult
{
  std::shared_ptr<const SurfaceLevel> Cut;
  std::exception_ptr Failure;
};

/**
 * Makes surfaces for views from the coarsest base mesh of their file that is fine enough: with
 * eight times the points that may be left, or else with a smaller error than is allowed everywhere.
 * The last base meshes are kept.
 *
 * Orders are carried out in the background, which rests as long as it has worked, or at once.
 * All methods must be called from one thread.
 */
class SurfaceCutter
{
public:
  using Progress = SurfaceLevel::Progress;

  /** Orders a surface from the background. Its result takes the place of one that was not taken. */
  void Request(SurfaceCutOrder order);

  /** Whether an order is not carried out yet. */
  bool IsBusy() { return this->Worker.IsBusy(); }

  /** The result of the last order, once. */
  std::optional<SurfaceCutResult> Take();

  /** Carries out an order at once. If progress returns false, the failure is Aborted. */
  SurfaceCutResult Make(const SurfaceCutOrder& order, const Progress& progress);

  /** Waits until the last order is carried out. */
  void Wait() { this->Worker.Wait(); }

  /** Forgets orders, results and base meshes. */
  void Clear();

private:
  SurfaceCutResult CarryOut(const SurfaceCutOrder& order, const Progress& progress);
  /** A level of the file, and what chooses its merges. */
  struct Base
  {
    std::size_t Level = 0;
    std::shared_ptr<const SurfaceDetail> Detail; // null: there is no room for it
  };

  Base FindBase(const SurfaceCutOrder& order, const Progress& progress);
  double BoundWeights(const SurfaceCutOrder& order, const Progress& progress);

  // While an order is carried out, by one thread at a time:
  std::vector<Base> Bases;                       // of one file and step, the last one first
  std::shared_ptr<const SurfaceDetail> Coarsest; // base mesh; knows how near the eye is

  std::optional<SurfaceCutResult> Ready; // with the lock of the worker
  BackgroundWorker Worker;
};
}

#endif
