// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeBuilder.h"

#include "gatunError.h"
#include "gatunLocalIndex.h"
#include "gatunMergeCosts.h"
#include "gatunMergeMesh.h"
#include "gatunMergeOrder.h"
#include "gatunMergeQueue.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
namespace
{
/** After so many changes around it, what a point costs is found anew. Later is faster, but merges
 * that have become cheaper wait. */
constexpr unsigned MostChanges = 3;

/** Roots of sums of changes are so many times what is measured of meshes that were simplified. */
constexpr double ChangePerError = 6;

/** Merges points in the order of their costs. */
template <typename Costs>
class Builder
{
public:
  Builder(const MergeInput& input, const MergeSettings& settings)
    : Mesh(input.Points.size(), input.Tets)
    , CostOf(this->Mesh, input, settings)
    , Candidates(input.Points.size())
  {
  }

  std::vector<Merge> Run(const std::function<bool(double)>& progress)
  {
    const auto points = static_cast<std::uint32_t>(this->Candidates.size());
    std::vector<std::uint32_t> cheapest;
    MergeQueue::Key key = 0;
    for (bool any = true; any;)
    {
      for (std::uint32_t point = 0; point < points; ++point)
      {
        if (this->Candidates[point].Is == State::Idle)
        {
          this->Enqueue(point);
        }
        if (point % 4096 == 0)
        {
          Report(progress, this->Merges.empty() ? 0.2 * point / points : 0.99);
        }
      }
      const auto before = this->Merges.size();
      while (this->Queue.Take(key, cheapest))
      {
        for (const auto point : cheapest)
        {
          if (this->IsDue(point, key))
          {
            this->MergeNow(point);
            if (this->Merges.size() % 1024 == 0)
            {
              Report(progress, 0.2 + 0.79 * static_cast<double>(this->Merges.size()) / points);
            }
          }
        }
      }
      // Others may have become possible, by what happened behind their neighbors.
      any = this->Merges.size() > before;
    }
    Report(progress, 1);
    return std::move(this->Merges);
  }

private:
  enum class State : std::uint8_t
  {
    Idle, ///< cannot be merged
    Queued,
    Gone
  };

  struct Candidate
  {
    double Change = 0;
    std::uint32_t Into = MergeMesh::None;
    MergeQueue::Key Key = 0;
    std::uint8_t Changes = 0; // around it since it was found
    State Is = State::Idle;
  };

  static void Report(const std::function<bool(double)>& progress, double done)
  {
    if (progress && !progress(done))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
  }

  /** Finds the best merge of a point. Returns whether there is one. */
  bool Find(std::uint32_t point, bool checkTopology)
  {
    Candidate& candidate = this->Candidates[point];
    const MergeChoice choice = this->CostOf.Choose(point, candidate.Into, checkTopology);
    candidate.Change = choice.Change;
    candidate.Into = choice.Into;
    candidate.Key = MergeQueue::GetKey(choice.Cost);
    candidate.Changes = 0;
    candidate.Is = choice.Into == MergeMesh::None ? State::Idle : State::Queued;
    return candidate.Is == State::Queued;
  }

  /** The topology, which takes long to check, nearly always allows the cheapest merge. */
  void Enqueue(std::uint32_t point)
  {
    const Candidate& candidate = this->Candidates[point];
    const bool isQueued = candidate.Is == State::Queued;
    const auto before = candidate.Key;
    if (this->Find(point, false) && !(isQueued && candidate.Key == before))
    {
      this->Queue.Push(candidate.Key, point);
    }
  }

  /** Finds the best merge anew. Returns whether it is due; otherwise it is queued. */
  bool FindDue(std::uint32_t point, MergeQueue::Key key, bool checkTopology)
  {
    if (!this->Find(point, checkTopology))
    {
      return false;
    }
    const auto now = this->Candidates[point].Key;
    if (now > key)
    {
      this->Queue.Push(now, point);
    }
    return now <= key;
  }

  /** Whether the best merge of a point has a key, or a lower one, and may be made. */
  bool IsDue(std::uint32_t point, MergeQueue::Key key)
  {
    const Candidate& candidate = this->Candidates[point];
    if (candidate.Is != State::Queued || candidate.Key != key)
    {
      return false; // it was found anew since
    }
    if (candidate.Changes > 0 && !this->FindDue(point, key, false))
    {
      return false;
    }
    return this->Mesh.MayMerge(point, candidate.Into) || this->FindDue(point, key, true);
  }

  void MergeNow(std::uint32_t point)
  {
    Candidate& merged = this->Candidates[point];
    this->Change += merged.Change;
    this->Merges.push_back(
      { point, merged.Into, static_cast<float>(std::sqrt(this->Change) / ChangePerError) });
    merged.Is = State::Gone;
    this->Seen.Clear();
    this->Affected.clear();
    for (const auto tet : this->Mesh.GetRing(point))
    {
      for (const auto corner : this->Mesh.GetTet(tet))
      {
        if (this->Seen[corner]++ == 0)
        {
          this->Affected.push_back(corner);
        }
      }
    }
    this->Mesh.Merge(point, merged.Into);
    for (const auto other : this->Affected)
    {
      Candidate& candidate = this->Candidates[other];
      if (candidate.Is == State::Idle ||
        (candidate.Is == State::Queued && ++candidate.Changes == MostChanges))
      {
        this->Enqueue(other);
      }
    }
  }

  MergeMesh Mesh;
  Costs CostOf;
  std::vector<Candidate> Candidates; // of each point
  MergeQueue Queue;
  LocalIndex Seen;
  std::vector<std::uint32_t> Affected;
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
  auto merges = input.Fields.size() == 1
    ? Builder<MergeCosts<1>>(local.Get(), settings).Run(progress)
    : Builder<MergeCosts<0>>(local.Get(), settings).Run(progress);
  for (Merge& merge : merges)
  {
    merge.Point = local.GetIds()[merge.Point];
    merge.Into = local.GetIds()[merge.Into];
  }
  return { static_cast<std::uint32_t>(input.Points.size()), std::move(merges) };
}
}
