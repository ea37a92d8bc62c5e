// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunMergeBuilder.h"

#include "gatunError.h"
#include "gatunMergeCosts.h"
#include "gatunMergeMesh.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace gatun
{
namespace
{
/** What is to be done next, of all points. */
class Builder
{
public:
  Builder(const MergeInput& input, const MergeSettings& settings)
    : Mesh(input.Points.size(), input.Tets)
    , Costs(this->Mesh, input, settings)
    , States(input.Points.size(), State::Idle)
    , Choices(input.Points.size())
  {
  }

  std::vector<Merge> Run(const std::function<bool(double)>& progress)
  {
    const auto points = static_cast<std::uint32_t>(this->States.size());
    std::vector<Merge> merges;
    for (bool any = true; any;)
    {
      any = false;
      for (std::uint32_t point = 0; point < points; ++point)
      {
        if (this->States[point] == State::Idle)
        {
          this->Enqueue(point);
        }
        if (point % 4096 == 0)
        {
          Report(progress, merges.empty() ? 0.2 * point / points : 0.99);
        }
      }
      while (!this->Queue.empty())
      {
        const Entry entry = this->Queue.top();
        this->Queue.pop();
        if (this->States[entry.Point] == State::Changed)
        {
          this->Enqueue(entry.Point);
          continue;
        }
        const auto into = this->Choices[entry.Point];
        if (!this->Mesh.MayMerge(entry.Point, into))
        {
          // What is around the other one has changed.
          this->Enqueue(entry.Point);
          continue;
        }
        merges.push_back({ entry.Point, into, static_cast<float>(entry.Cost) });
        this->MergeNow(entry.Point, into);
        any = true;
        if (merges.size() % 1024 == 0)
        {
          Report(progress, 0.2 + 0.79 * static_cast<double>(merges.size()) / points);
        }
      }
      // Others may have become possible, by what happened behind their neighbours.
    }
    Report(progress, 1);
    return merges;
  }

private:
  enum class State : std::uint8_t
  {
    Idle,    ///< cannot be merged
    Queued,  ///< with what it costs
    Changed, ///< queued, but what it costs is no longer true
    Gone
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

  void Enqueue(std::uint32_t point)
  {
    const MergeChoice choice = this->Costs.Choose(point);
    this->States[point] = State::Idle;
    if (choice.Into != MergeMesh::None)
    {
      this->States[point] = State::Queued;
      this->Choices[point] = choice.Into;
      this->Queue.push({ choice.Cost, point });
    }
  }

  void MergeNow(std::uint32_t point, std::uint32_t into)
  {
    this->Affected.clear();
    for (const auto tet : this->Mesh.GetRing(point))
    {
      for (const auto corner : this->Mesh.GetTet(tet))
      {
        this->Affected.push_back(corner);
      }
    }
    std::sort(this->Affected.begin(), this->Affected.end());
    this->Affected.erase(
      std::unique(this->Affected.begin(), this->Affected.end()), this->Affected.end());
    this->Mesh.Merge(point, into);
    this->States[point] = State::Gone;
    for (const auto other : this->Affected)
    {
      if (this->States[other] == State::Queued)
      {
        this->States[other] = State::Changed;
      }
      else if (this->States[other] == State::Idle)
      {
        this->Enqueue(other);
      }
    }
  }

  MergeMesh Mesh;
  MergeCosts Costs;
  std::vector<State> States;
  std::vector<std::uint32_t> Choices;
  std::priority_queue<Entry> Queue;
  std::vector<std::uint32_t> Affected;
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
  Builder builder(input, settings);
  return { static_cast<std::uint32_t>(input.Points.size()), builder.Run(progress) };
}
}
