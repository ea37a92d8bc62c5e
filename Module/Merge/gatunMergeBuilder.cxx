// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeBuilder.h"

#include "gatunError.h"
#include "gatunLargeArray.h"
#include "gatunMergeCosts.h"
#include "gatunMergeFields.h"
#include "gatunMergeMesh.h"
#include "gatunMergeOrder.h"
#include "gatunMergeQueue.h"
#include "gatunParallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

namespace gatun
{
namespace
{
/** After so many changes around it, what a point costs is found anew. Later is faster, but merges
 * that have become cheaper wait. */
constexpr std::uint8_t MostChanges = 3;

/** Roots of sums of changes are so many times what is measured of meshes that were simplified. */
constexpr double ChangePerError = 6;

/** Fewer points than this are evaluated by one thread. */
constexpr std::size_t FewestInParallel = 64;

/**
 * Merges points in rounds. The points of a round have the lowest costs of all, which are found anew
 * where they are outdated. Of these points, all are merged around which nothing has changed in the
 * round. Costs are only found between the merges of two rounds, by all threads, so that the result
 * does not depend on their number.
 */
template <std::size_t NumberOfFields>
class Builder
{
public:
  Builder(const MergeInput& input, const MergeSettings& settings,
    const std::function<bool(double)>& progress)
    : Progress(progress)
    , Mesh(input.Points.size(), input.Tets)
    , Fields(this->Mesh, input)
    , Candidates(input.Points.size())
  {
    for (int i = 0; i < std::max(1, GetNumberOfThreads()); ++i)
    {
      this->Workers.push_back(
        std::make_unique<MergeCosts<NumberOfFields>>(this->Mesh, this->Fields, settings));
    }
    for (std::size_t point = 0; point < input.IsKept.size(); ++point)
    {
      if (input.IsKept[point] != 0)
      {
        this->Candidates[point].Is = State::Kept;
      }
    }
  }

  std::vector<Merge> Run()
  {
    for (bool any = true; any;)
    {
      this->FindIdle();
      const auto before = this->Merges.size();
      MergeQueue::Key key = 0;
      while (this->Queue.Take(key, this->Due))
      {
        this->RunRound(key);
      }
      // Others may have become possible, by what happened behind their neighbors.
      any = this->Merges.size() > before;
    }
    this->Report(1);
    return std::move(this->Merges);
  }

private:
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
    std::uint32_t Into = MergeMesh::None;
    MergeQueue::Key Key = 0;
    std::uint8_t Changes = 0; // around it since it was found, at most MostChanges
    State Is = State::Idle;
    std::uint32_t Seen = 0; // by the last of so many merges
  };

  using Costs = MergeCosts<NumberOfFields>;

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
    const auto run = [&](Costs& costs, std::size_t first, std::size_t last)
    {
      for (auto i = first; i < last; ++i)
      {
        this->Mesh.PrefetchRing(points[std::min(i + 2, last - 1)]);
        this->Mesh.PrefetchTets(points[std::min(i + 1, last - 1)]);
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
  void Find(Costs& costs, std::uint32_t point, bool checkTopology)
  {
    Candidate& candidate = this->Candidates[point];
    const MergeChoice choice = costs.Choose(point, candidate.Into, checkTopology);
    candidate.Change = choice.Change;
    candidate.Into = choice.Into;
    candidate.Key = MergeQueue::GetKey(choice.Cost);
    candidate.Changes = 0;
    candidate.Is = choice.Into == MergeMesh::None ? State::Idle : State::Queued;
  }

  /** Finds the best merges of points that have none, or outdated ones. */
  void FindAll(std::vector<std::uint32_t>& points)
  {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    this->ForEach(
      points, [this](Costs& costs, std::uint32_t point) { this->Find(costs, point, false); });
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

  /** Whether what is known of a point may still be that of a key. */
  bool IsOf(std::uint32_t point, MergeQueue::Key key) const
  {
    const Candidate& candidate = this->Candidates[point];
    return candidate.Is == State::Queued && candidate.Key == key;
  }

  void RunRound(MergeQueue::Key key)
  {
    auto& due = this->Due;
    due.erase(std::unique(due.begin(), due.end()), due.end());
    std::erase_if(due, [&](std::uint32_t point) { return !this->IsOf(point, key); });
    this->ForEach(due,
      [&](Costs& costs, std::uint32_t point)
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
    for (const auto point : due)
    {
      const Candidate& candidate = this->Candidates[point];
      const bool isNow = candidate.Is == State::Queued && candidate.Key <= key;
      if (isNow && candidate.Changes == 0)
      {
        this->MergeNow(point);
      }
      else if (candidate.Changes < MostChanges)
      {
        this->Enqueue(point);
      }
    }
    this->FindAll(this->Outdated);
  }

  void MergeNow(std::uint32_t point)
  {
    Candidate& merged = this->Candidates[point];
    this->Change += merged.Change;
    this->Merges.push_back(
      { point, merged.Into, static_cast<float>(std::sqrt(this->Change) / ChangePerError) });
    merged.Is = State::Gone;
    const auto number = static_cast<std::uint32_t>(this->Merges.size());
    for (const auto tet : this->Mesh.GetRing(point))
    {
      for (const auto corner : this->Mesh.GetTet(tet))
      {
        this->Touch(this->Candidates[corner], corner, number);
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

  /** Something around a point has changed by a merge. Called for each tetrahedron of the point. */
  void Touch(Candidate& candidate, std::uint32_t point, std::uint32_t merge)
  {
    const bool counts =
      (candidate.Seen != merge) & (candidate.Is < State::Kept) & (candidate.Changes != MostChanges);
    candidate.Seen = merge;
    candidate.Changes = static_cast<std::uint8_t>(candidate.Changes + counts);
    if (counts && candidate.Changes == MostChanges)
    {
      this->Outdated.push_back(point);
    }
  }

  const std::function<bool(double)>& Progress;
  MergeMesh Mesh;
  MergeFields Fields;
  std::vector<std::unique_ptr<Costs>> Workers;
  LargeArray<Candidate> Candidates; // of each point
  MergeQueue Queue;
  std::vector<std::uint32_t> Due;      // points of the round
  std::vector<std::uint32_t> Outdated; // points to be found anew after the round
  std::vector<Merge> Merges;
  double Change = 0; // of all merges
};

void Check(const MergeInput& input, const MergeSettings& settings)
{
  const auto fail = [](const char* what) { throw Error(ErrorCode::InvalidInput, what); };
  if (input.Points.size() >= MergeMesh::None || input.Tets.size() >= MergeMesh::None)
  {
    fail("more than four thousand million points or tetrahedra cannot be simplified");
  }
  for (const auto& tet : input.Tets)
  {
    if (*std::max_element(tet.begin(), tet.end()) >= input.Points.size())
    {
      fail("a tetrahedron has a point that does not exist");
    }
  }
  for (const auto& field : input.Fields)
  {
    if (field.Values.size() != input.Points.size())
    {
      fail("a field must have one value for each point");
    }
    if (!(field.Weight >= 0) || !std::isfinite(field.Weight))
    {
      fail("the weight of a field must be 0 or more");
    }
  }
  if (!input.IsKept.empty() && input.IsKept.size() != input.Points.size())
  {
    fail("there must be a mark for each point, or none");
  }
  if (!(settings.BoundaryWeight >= 0 && settings.BoundaryWeight <= 1))
  {
    fail("the weight of the boundary must be from 0 to 1");
  }
}
}

//------------------------------------------------------------------------------
MergeTree BuildMergeTree(const MergeInput& input, const MergeSettings& settings,
  const std::function<bool(double)>& progress)
{
  Check(input, settings);
  const LocalMergeInput local(input);
  // One field, which is frequent, is faster if its loops are known when they are compiled.
  auto merges = input.Fields.size() == 1 ? Builder<1>(local.Get(), settings, progress).Run()
                                         : Builder<0>(local.Get(), settings, progress).Run();
  for (Merge& merge : merges)
  {
    merge.Point = local.GetIds()[merge.Point];
    merge.Into = local.GetIds()[merge.Into];
  }
  return { static_cast<std::uint32_t>(input.Points.size()), std::move(merges) };
}
}
