// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeBuilder.h"

#include "gatunError.h"
#include "gatunMergeCosts.h"
#include "gatunMergeMesh.h"
#include "gatunMergeOrder.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace gatun
{
namespace
{
/** After so many changes around it, what a point costs is found anew. Later is faster, but merges
 * that have become cheaper wait. */
constexpr unsigned MostChanges = 3;

/** Roots of sums of changes are so many times what is measured of meshes that were simplified. */
constexpr double ChangePerError = 6;

/** What is to be done next, of all points. */
class Builder
{
public:
  Builder(const MergeInput& input, const MergeSettings& settings)
    : Mesh(input.Points.size(), input.Tets)
    , Costs(this->Mesh, input, settings)
    , Candidates(input.Points.size())
    , Touched(input.Points.size(), 0)
  {
  }

  std::vector<Merge> Run(const std::function<bool(double)>& progress)
  {
    const auto points = static_cast<std::uint32_t>(this->Candidates.size());
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
      while (!this->Queue.empty())
      {
        const Entry entry = this->Queue.top();
        this->Queue.pop();
        if (this->IsDue(entry))
        {
          this->MergeNow(entry.Point);
          if (this->Merges.size() % 1024 == 0)
          {
            Report(progress, 0.2 + 0.79 * static_cast<double>(this->Merges.size()) / points);
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
    MergeChoice Choice;
    std::uint32_t When = 0;   // how many merges there had been
    std::uint8_t Changes = 0; // around it since then
    bool IsChecked = false;   // whether the topology allowed it then
    State Is = State::Idle;
  };

  struct Entry
  {
    double Cost;
    std::uint32_t Point;
    bool operator<(const Entry& other) const // the cheapest first
    {
      return this->Cost != other.Cost ? this->Cost > other.Cost : this->Point > other.Point;
    }
  };

  static void Report(const std::function<bool(double)>& progress, double done)
  {
    if (progress && !progress(done))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
  }

  /** The topology, which takes long to look at, mostly allows what is best. */
  void Enqueue(std::uint32_t point, bool checkTopology = false)
  {
    Candidate& candidate = this->Candidates[point];
    candidate.Choice = this->Costs.Choose(point, candidate.Choice.Into, checkTopology);
    candidate.When = static_cast<std::uint32_t>(this->Merges.size());
    candidate.Changes = 0;
    candidate.IsChecked = checkTopology;
    candidate.Is = State::Idle;
    if (candidate.Choice.Into != MergeMesh::None)
    {
      candidate.Is = State::Queued;
      this->Queue.push({ candidate.Choice.Cost, point });
    }
  }

  /** Whether a merge is to be done as it was found. If not, it is found anew. */
  bool IsDue(const Entry& entry)
  {
    const Candidate& candidate = this->Candidates[entry.Point];
    if (candidate.Is != State::Queued || candidate.Choice.Cost != entry.Cost)
    {
      return false; // it was found anew since
    }
    const auto into = candidate.Choice.Into;
    if (candidate.Changes > 0)
    {
      this->Enqueue(entry.Point);
      return false;
    }
    if (!(candidate.IsChecked && this->Touched[into] <= candidate.When) &&
      !this->Mesh.MayMerge(entry.Point, into))
    {
      this->Enqueue(entry.Point, true);
      return false;
    }
    return true;
  }

  void MergeNow(std::uint32_t point)
  {
    const MergeChoice choice = this->Candidates[point].Choice;
    this->Change += choice.Change;
    this->Merges.push_back(
      { point, choice.Into, static_cast<float>(std::sqrt(this->Change) / ChangePerError) });
    this->Candidates[point].Is = State::Gone;
    this->Affected.clear();
    for (const auto tet : this->Mesh.GetRing(point))
    {
      for (const auto corner : this->Mesh.GetTet(tet))
      {
        // Each one once.
        if (this->Touched[corner] != this->Merges.size())
        {
          this->Touched[corner] = static_cast<std::uint32_t>(this->Merges.size());
          this->Affected.push_back(corner);
        }
      }
    }
    this->Mesh.Merge(point, choice.Into);
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
  MergeCosts Costs;
  std::vector<Candidate> Candidates;
  std::vector<std::uint32_t> Touched; // at which merge a point's surroundings changed, last
  std::priority_queue<Entry> Queue;
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
  auto merges = Builder(local.Get(), settings).Run(progress);
  for (Merge& merge : merges)
  {
    merge.Point = local.GetIds()[merge.Point];
    merge.Into = local.GetIds()[merge.Into];
  }
  return { static_cast<std::uint32_t>(input.Points.size()), std::move(merges) };
}
}
