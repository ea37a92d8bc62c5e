// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMergeRounds_h
#define gatunMergeRounds_h

#include "gatunError.h"
#include "gatunLargeArray.h"
#include "gatunMergeChoice.h"
#include "gatunMergeQueue.h"
#include "gatunMergeRanks.h"
#include "gatunMergeTree.h"
#include "gatunParallel.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

namespace gatun
{
/** Makes a worker for each thread. */
template <typename CostsType, typename... Arguments>
std::vector<std::unique_ptr<CostsType>> MakeMergeWorkers(const Arguments&... arguments)
{
  std::vector<std::unique_ptr<CostsType>> workers;
  for (int i = 0; i < std::max(1, GetNumberOfThreads()); ++i)
  {
    workers.push_back(std::make_unique<CostsType>(arguments...));
  }
  return workers;
}

/** The best merge of a point when it was last looked for. Into is None if there was none. */
struct MergeHint
{
  std::uint32_t Into = MergeChoice::None;
  MergeQueue::Key Key = 0;
};

/**
 * Merges points in rounds. The points of a round have the lowest costs of all, which are found anew
 * where they are outdated. Of these points, all are merged around which nothing has changed in the
 * round. Costs are only found between the merges of two rounds, by all threads, so that the result
 * does not depend on their number.
 *
 * The mesh has the rings and the functions of MergeRings. Costs has Choose and MayMerge, as
 * MergeCosts does, and MostChanges: the number of changes around a point after which its cost is
 * found anew. Later is faster, but merges that have become cheaper wait. Rounds may form batches of
 * a part of the merges (MergeSettings::PartAtOnce). The errors of merges are the roots of the sums
 * of the changes, divided by ChangePerError.
 */
template <typename MeshType, typename CostsType>
class MergeRounds
{
public:
  /** One worker finds costs in each thread. isKept: of each point, or empty. All arguments must
   * exist as long as this object. Progress: see BuildMergeTree. partAtOnce: see MergeSettings. */
  MergeRounds(MeshType& mesh, std::span<const std::unique_ptr<CostsType>> workers,
    std::span<const std::uint8_t> isKept, const std::function<bool(double)>& progress,
    double partAtOnce = 0)
    : Progress(progress)
    , Mesh(mesh)
    , Workers(workers)
    , Candidates(mesh.GetNumberOfPoints())
    , Ranks(mesh.GetNumberOfPoints())
    , PartAtOnce(partAtOnce)
    , Changed(partAtOnce > 0 ? mesh.GetNumberOfPoints() : 0, 0)
  {
    for (std::size_t point = 0; point < isKept.size(); ++point)
    {
      if (isKept[point] != 0)
      {
        this->Candidates[point].Is = State::Kept;
      }
    }
  }

  /** Called before each merge, with the key of its round and its change. */
  using Listener = std::function<void(const Merge&, MergeQueue::Key, double)>;
  void SetListener(Listener listener) { this->OnMerge = std::move(listener); }

  /** Queues a point with a merge that was found before. It is found anew when it is due. */
  void SetHint(std::uint32_t point, const MergeHint& hint)
  {
    Candidate& candidate = this->Candidates[point];
    if (candidate.Is == State::Idle)
    {
      candidate.Into = hint.Into;
      candidate.Key = hint.Key;
      candidate.Changes = 1;
      candidate.Is = State::Queued;
      this->Enqueue(point);
    }
  }

  /** The merge that was last found for a point, if it can still be merged. */
  MergeHint GetHint(std::uint32_t point) const
  {
    const Candidate& candidate = this->Candidates[point];
    return candidate.Is == State::Queued ? MergeHint{ candidate.Into, candidate.Key } : MergeHint{};
  }

  /** Merges all that can be merged. */
  RankedMerges Run()
  {
    for (bool any = true; any;)
    {
      const auto before = this->Merges.size();
      this->FindIdle();
      this->BeginBatch();
      MergeQueue::Key key = 0;
      while (this->TakeDue(key))
      {
        this->RunRound(key);
      }
      // Others may have become possible by changes behind their neighbors.
      any = this->Merges.size() > before;
    }
    this->Report(1);
    return this->Ranks.Arrange(this->Merges, CostsType::ChangePerError);
  }

  /** Merges what has a key below a limit. To be called once. */
  void RunBelow(unsigned limit)
  {
    this->FindIdle();
    this->BeginBatch();
    MergeQueue::Key key = 0;
    while (this->TakeDue(key) && key < limit)
    {
      this->RunRound(key);
    }
  }

private:
  /** Fewer points than this are evaluated by one thread. */
  static constexpr std::size_t FewestInParallel = 64;

  static constexpr bool IsOfTets = std::tuple_size_v<typename MeshType::Cell> == 4;

  enum class State : std::uint8_t
  {
    Idle, ///< cannot be merged
    Queued,
    Kept, ///< is not to be merged
    Gone
  };

  struct Candidate
  {
    double Change = 0;
    std::uint32_t Into = MergeChoice::None;
    MergeQueue::Key Key = 0;
    std::uint8_t Changes = 0; // around it since it was found, at most CostsType::MostChanges
    State Is = State::Idle;
    std::uint32_t Seen = 0; // by the last of so many merges
  };

  void Report(double done) const
  {
    if (this->Progress && !this->Progress(done))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
  }

  /** Calls body(costs, point) for each point, in any order. */
  template <typename Body>
  void ForEach(const std::vector<std::uint32_t>& points, Body&& body)
  {
    const auto run = [&](CostsType& costs, std::size_t first, std::size_t last)
    {
      for (auto i = first; i < last; ++i)
      {
        this->Mesh.PrefetchRing(points[std::min(i + 3, last - 1)]);
        __builtin_prefetch(&this->Candidates[points[std::min(i + 3, last - 1)]]);
        this->Mesh.PrefetchCells(points[std::min(i + 2, last - 1)]);
        this->Mesh.PrefetchCorners(points[std::min(i + 1, last - 1)]);
        body(costs, points[i]);
      }
    };
    if (points.size() < FewestInParallel || this->Workers.size() == 1)
    {
      run(*this->Workers[0], 0, points.size());
      return;
    }
    std::atomic<std::size_t> next = 0;
    ParallelFor(this->Workers.size(),
      [&](std::size_t worker)
      {
        constexpr std::size_t step = 16;
        for (auto first = next.fetch_add(step); first < points.size(); first = next.fetch_add(step))
        {
          run(*this->Workers[worker], first, std::min(first + step, points.size()));
        }
      });
  }

  /** Finds the best merge of a point. The topology, which takes long to check, nearly always allows
   * the cheapest one. */
  void Find(CostsType& costs, std::uint32_t point, bool checkTopology)
  {
    Candidate& candidate = this->Candidates[point];
    const MergeChoice choice = costs.Choose(point, candidate.Into, checkTopology);
    candidate.Change = choice.Change;
    candidate.Into = choice.Into;
    candidate.Key = MergeQueue::GetKey(choice.Cost);
    candidate.Changes = 0;
    candidate.Is = choice.Into == MergeChoice::None ? State::Idle : State::Queued;
  }

  /** Finds the best merges of points that have none, or outdated ones. */
  void FindAll(std::vector<std::uint32_t>& points)
  {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    this->ForEach(
      points, [this](CostsType& costs, std::uint32_t point) { this->Find(costs, point, false); });
    for (const auto point : points)
    {
      this->Enqueue(point);
    }
  }

  void Enqueue(std::uint32_t point)
  {
    if (this->Candidates[point].Is == State::Queued)
    {
      this->Queue.Push(this->Candidates[point].Key, point);
    }
  }

  void FindIdle()
  {
    const auto points = static_cast<std::uint32_t>(this->Candidates.size());
    constexpr std::uint32_t step = 1 << 14;
    for (std::uint32_t first = 0; first < points; first += step)
    {
      this->Report(this->Merges.empty() ? 0.2 * first / points : 0.99);
      this->Outdated.clear();
      for (std::uint32_t point = first; point < std::min(points, first + step); ++point)
      {
        if (this->Candidates[point].Is == State::Idle)
        {
          this->Outdated.push_back(point);
        }
      }
      this->FindAll(this->Outdated);
    }
  }

  /** Whether the state of a point may still be that of a key. */
  bool IsOf(std::uint32_t point, MergeQueue::Key key) const
  {
    const Candidate& candidate = this->Candidates[point];
    return candidate.Is == State::Queued && candidate.Key == key;
  }

  /** Lets the points that wait be merged again, and finds the largest cost of the next batch. */
  void BeginBatch()
  {
    if (this->PartAtOnce == 0)
    {
      return;
    }
    ++this->Batch;
    for (const auto point : this->Waiting)
    {
      this->Enqueue(point);
    }
    this->Waiting.clear();
    std::vector<MergeQueue::Key> keys;
    for (const Candidate& candidate : this->Candidates)
    {
      if (candidate.Is == State::Queued)
      {
        keys.push_back(candidate.Key);
      }
    }
    if (!keys.empty())
    {
      const auto last = keys.begin() +
        static_cast<std::ptrdiff_t>(this->PartAtOnce * static_cast<double>(keys.size() - 1));
      std::nth_element(keys.begin(), last, keys.end());
      this->LastKey = *last;
    }
  }

  /** Takes the points of the next round, of this batch or of the next one. */
  bool TakeDue(MergeQueue::Key& key)
  {
    for (;;)
    {
      const bool any = this->Queue.Take(key, this->Due);
      if (any && (this->PartAtOnce == 0 || key <= this->LastKey))
      {
        return true;
      }
      if (!any && this->Waiting.empty())
      {
        return false;
      }
      for (const auto point : this->Due)
      {
        this->Enqueue(point);
      }
      this->BeginBatch();
    }
  }

  /** Whether a point must wait for the next batch, and lets it. */
  bool Waits(std::uint32_t point)
  {
    const bool waits = this->PartAtOnce > 0 && this->Changed[point] == this->Batch;
    if (waits)
    {
      this->Waiting.push_back(point);
    }
    return waits;
  }

  void RunRound(MergeQueue::Key key)
  {
    auto& due = this->Due;
    due.erase(std::unique(due.begin(), due.end()), due.end());
    std::erase_if(
      due, [&](std::uint32_t point) { return !this->IsOf(point, key) || this->Waits(point); });
    this->ForEach(due,
      [&](CostsType& costs, std::uint32_t point)
      {
        Candidate& candidate = this->Candidates[point];
        if (candidate.Changes > 0)
        {
          this->Find(costs, point, false);
        }
        if (candidate.Is == State::Queued && candidate.Key <= key &&
          !costs.MayMerge(point, candidate.Into))
        {
          this->Find(costs, point, true);
        }
      });
    this->Outdated.clear();
    const std::size_t before = this->Merges.size();
    for (std::size_t i = 0; i < due.size(); ++i)
    {
      const auto point = due[i];
      this->PrefetchMerges(due, i);
      const Candidate& candidate = this->Candidates[point];
      const bool isNow = candidate.Is == State::Queued && candidate.Key <= key;
      if (isNow && candidate.Changes == 0)
      {
        // A merge next to the neighbor may have joined it to another neighbor of the point.
        if (this->Candidates[candidate.Into].Seen <= before ||
          this->Workers[0]->MayMerge(point, candidate.Into))
        {
          this->MergeNow(point, key);
        }
        else
        {
          this->Outdated.push_back(point);
        }
      }
      else if (candidate.Changes < CostsType::MostChanges)
      {
        this->Enqueue(point);
      }
    }
    this->FindAll(this->Outdated);
  }

  /** Loads what the merges of the next points change into the cache of the processor. Triangles
   * around points are few, and asking for them takes longer than to wait. */
  void PrefetchMerges(const std::vector<std::uint32_t>& points, std::size_t i) const
  {
    if constexpr (!IsOfTets)
    {
      return;
    }
    const std::size_t last = points.size() - 1;
    this->Mesh.PrefetchRing(points[std::min(i + 6, last)]);
    this->Mesh.PrefetchCells(points[std::min(i + 4, last)]);
    const auto next = points[std::min(i + 2, last)];
    this->Mesh.PrefetchRings(next);
    for (const auto cell : this->Mesh.GetRing(next))
    {
      for (const auto corner : this->Mesh.GetCell(cell))
      {
        __builtin_prefetch(&this->Candidates[corner]);
      }
    }
  }

  void MergeNow(std::uint32_t point, MergeQueue::Key key)
  {
    Candidate& merged = this->Candidates[point];
    this->Merges.push_back({ point, merged.Into, 0 }); // its error follows from the order
    if (this->OnMerge)
    {
      this->OnMerge(this->Merges.back(), key, merged.Change);
    }
    merged.Is = State::Gone;
    const auto number = static_cast<std::uint32_t>(this->Merges.size());
    const auto rank = this->Ranks.Add(point, merged.Change);
    for (const auto cell : this->Mesh.GetRing(point))
    {
      for (const auto corner : this->Mesh.GetCell(cell))
      {
        if constexpr (IsOfTets)
        {
          this->Mesh.PrefetchRing(corner);
        }
        this->Touch(this->Candidates[corner], corner, number);
        this->Ranks.Touch(corner, rank);
        if (this->PartAtOnce > 0)
        {
          this->Changed[corner] = this->Batch;
        }
      }
    }
    this->Mesh.Merge(point, merged.Into);
    if (this->Merges.size() % 1024 == 0)
    {
      this->Report(0.2 +
        0.79 * static_cast<double>(this->Merges.size()) /
          static_cast<double>(this->Candidates.size()));
    }
  }

  /** Something around a point has changed by a merge. Called for each cell of the point. */
  void Touch(Candidate& candidate, std::uint32_t point, std::uint32_t merge)
  {
    const bool counts = (candidate.Seen != merge) & (candidate.Is < State::Kept) &
      (candidate.Changes != CostsType::MostChanges);
    candidate.Seen = merge;
    candidate.Changes = static_cast<std::uint8_t>(candidate.Changes + counts);
    if (counts && candidate.Changes == CostsType::MostChanges)
    {
      this->Outdated.push_back(point);
    }
  }

  const std::function<bool(double)>& Progress;
  Listener OnMerge;
  MeshType& Mesh;
  std::span<const std::unique_ptr<CostsType>> Workers;
  LargeArray<Candidate> Candidates; // of each point
  MergeQueue Queue;
  std::vector<std::uint32_t> Due;      // points of the round
  std::vector<std::uint32_t> Outdated; // points to be found anew after the round
  std::vector<Merge> Merges;
  MergeRanks Ranks;

  const double PartAtOnce;
  LargeArray<std::uint32_t> Changed; // the last batch that had a merge around each point
  std::uint32_t Batch = 0;
  MergeQueue::Key LastKey = 0;        // of the batch
  std::vector<std::uint32_t> Waiting; // points for the next batch
};
}

#endif
