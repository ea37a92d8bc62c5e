// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBisection.h"

#include "gatunError.h"
#include "gatunParallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace gatun
{
namespace
{
constexpr std::size_t ItemsPerTask = 1u << 15;
constexpr std::size_t Bins = 1024;

/** Four times the mean of the points of a cell. */
using Place = std::array<float, 3>;

/** Rounds a place. NaN comes first, and there is no -0. */
float Round(double place)
{
  constexpr double largest = std::numeric_limits<float>::max();
  return static_cast<float>(std::isnan(place) ? -largest : std::clamp(place, -largest, largest)) +
    0.0F;
}

std::array<float, 3> GetPlace(const MeshAccess& mesh, std::uint32_t cell)
{
  std::array<double, 3> sum{};
  std::uint64_t points = 0;
  const auto add = [&](std::uint64_t point)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      sum[axis] += mesh.GetCoordinate(point, axis);
    }
    ++points;
  };
  mesh.ForEachPoint(cell, add);
  if (points != 4 && points != 0)
  {
    for (double& component : sum)
    {
      component *= 4.0 / static_cast<double>(points);
    }
  }
  return { Round(sum[0]), Round(sum[1]), Round(sum[2]) };
}

/** The order of the cells along an axis. Without branches, because it is unpredictable. */
struct IsBefore
{
  const std::vector<Place>& Places;
  unsigned Axis;

  bool operator()(std::uint32_t l, std::uint32_t r) const
  {
    const float left = this->Places[l][this->Axis];
    const float right = this->Places[r][this->Axis];
    return (left < right) | ((left == right) & (l < r));
  }
};

struct Part
{
  std::size_t Begin;
  std::size_t End;
  std::uint32_t MostCells; // of a part that is not divided

  std::size_t GetSize() const { return this->End - this->Begin; }
  std::size_t CountTasks() const { return (this->GetSize() + ItemsPerTask - 1) / ItemsPerTask; }

  std::span<const std::uint32_t> GetTask(
    std::span<const std::uint32_t> cells, std::size_t task) const
  {
    const auto begin = this->Begin + task * ItemsPerTask;
    return cells.subspan(begin, std::min(ItemsPerTask, this->End - begin));
  }
};

/** Divides parts, from one array of cells into another. The places are by cell: they are read
 * nearly in their order, as the cells of a part keep theirs, and need no second array. */
class Divider
{
public:
  Divider(const MeshAccess& mesh, std::span<std::uint32_t> cells)
    : Places(static_cast<std::size_t>(mesh.GetMesh().Cells))
    , Room(cells.size())
    , From(cells)
    , To(Room)
  {
    const Part all{ 0, cells.size(), 0 };
    ParallelFor(all.CountTasks(),
      [&](std::size_t task)
      {
        const auto some = all.GetTask(cells, task);
        for (std::size_t i = 0; i < some.size(); ++i)
        {
          mesh.FetchPointsAhead(some, i);
          this->Places[some[i]] = GetPlace(mesh, some[i]);
        }
      });
  }

  /** Writes both halves of a part in their former order. Returns the beginning of the second one.
   */
  std::size_t Divide(const Part& part)
  {
    const auto box = this->GetBox(part);
    unsigned axis = 0;
    for (unsigned i = 1; i < 3; ++i)
    {
      axis = box[i].GetLength() > box[axis].GetLength() ? i : axis;
    }
    const auto parts = (part.GetSize() + part.MostCells - 1) / part.MostCells;
    const auto half = part.GetSize() * (parts / 2) / parts;
    const IsBefore isBefore{ this->Places, axis };
    std::vector<std::size_t> starts; // of the tasks in the first half
    const auto pivot = this->Select(part, axis, box[axis], half, starts);
    ParallelFor(part.CountTasks(),
      [&](std::size_t task)
      {
        std::array<std::size_t, 2> next{ part.Begin + half + task * ItemsPerTask - starts[task],
          part.Begin + starts[task] };
        for (const auto cell : part.GetTask(this->From, task))
        {
          this->To[next[isBefore(cell, pivot)]++] = cell;
        }
      });
    return part.Begin + half;
  }

  /** Continues with the halves. */
  void Swap() { std::swap(this->From, this->To); }

  /** Copies the cells of a part that is not divided further to those of the caller. */
  void Take(const Part& part, std::span<std::uint32_t> cells) const
  {
    if (this->From.data() != cells.data())
    {
      std::copy(this->From.begin() + static_cast<std::ptrdiff_t>(part.Begin),
        this->From.begin() + static_cast<std::ptrdiff_t>(part.End),
        cells.begin() + static_cast<std::ptrdiff_t>(part.Begin));
    }
  }

private:
  struct Extent
  {
    float Min = std::numeric_limits<float>::max();
    float Max = std::numeric_limits<float>::lowest();

    void Include(const Extent& other)
    {
      this->Min = std::min(this->Min, other.Min);
      this->Max = std::max(this->Max, other.Max);
    }
    double GetLength() const { return double{ this->Max } - double{ this->Min }; }
  };
  using Box = std::array<Extent, 3>;

  Box GetBox(const Part& part)
  {
    std::vector<Box> boxes(part.CountTasks());
    ParallelFor(boxes.size(),
      [&](std::size_t task)
      {
        Box box;
        for (const auto cell : part.GetTask(this->From, task))
        {
          for (unsigned i = 0; i < 3; ++i)
          {
            box[i].Include({ this->Places[cell][i], this->Places[cell][i] });
          }
        }
        boxes[task] = box;
      });
    Box all;
    for (const auto& box : boxes)
    {
      for (unsigned i = 0; i < 3; ++i)
      {
        all[i].Include(box[i]);
      }
    }
    return all;
  }

  /** The cell at a position of the order along an axis. A histogram leaves few cells to sort.
   * before: how many cells before it the tasks before each task have. */
  std::uint32_t Select(const Part& part, unsigned axis, const Extent& extent, std::size_t position,
    std::vector<std::size_t>& before)
  {
    const double scale = static_cast<double>(Bins - 1) / extent.GetLength();
    const auto binOf = [&](std::uint32_t cell)
    {
      const double bin = (double{ this->Places[cell][axis] } - double{ extent.Min }) * scale;
      return bin < static_cast<double>(Bins) ? static_cast<std::size_t>(bin) : 0; // 0 for NaN
    };
    std::vector<std::array<std::uint32_t, Bins>> counts(part.CountTasks());
    ParallelFor(counts.size(),
      [&](std::size_t task)
      {
        auto& count = counts[task];
        count.fill(0);
        for (const auto cell : part.GetTask(this->From, task))
        {
          ++count[binOf(cell)];
        }
      });
    std::size_t bin = 0;
    std::size_t inBins = 0; // before this one
    for (;; ++bin)
    {
      std::size_t count = 0;
      for (const auto& list : counts)
      {
        count += list[bin];
      }
      if (inBins + count > position)
      {
        break;
      }
      inBins += count;
    }
    std::vector<std::size_t> starts(counts.size() + 1, 0);
    for (std::size_t task = 0; task < counts.size(); ++task)
    {
      starts[task + 1] = starts[task] + counts[task][bin];
    }
    std::vector<std::uint32_t> rest(starts.back());
    ParallelFor(counts.size(),
      [&](std::size_t task)
      {
        auto next = starts[task];
        for (const auto cell : part.GetTask(this->From, task))
        {
          if (binOf(cell) == bin)
          {
            rest[next++] = cell;
          }
        }
      });
    const IsBefore isBefore{ this->Places, axis };
    auto sorted = rest;
    const auto nth = sorted.begin() + static_cast<std::ptrdiff_t>(position - inBins);
    std::nth_element(sorted.begin(), nth, sorted.end(), isBefore);
    before.assign(1, 0);
    for (std::size_t task = 0; task < counts.size(); ++task)
    {
      const auto first = rest.begin() + static_cast<std::ptrdiff_t>(starts[task]);
      const auto last = rest.begin() + static_cast<std::ptrdiff_t>(starts[task + 1]);
      const auto ofBin = static_cast<std::size_t>(
        std::count_if(first, last, [&](std::uint32_t cell) { return isBefore(cell, *nth); }));
      before.push_back(before.back() + ofBin +
        std::accumulate(counts[task].begin(),
          counts[task].begin() + static_cast<std::ptrdiff_t>(bin), std::size_t{ 0 }));
    }
    return *nth;
  }

  std::vector<Place> Places;
  std::vector<std::uint32_t> Room;
  std::span<std::uint32_t> From; // those of the caller, or the room
  std::span<std::uint32_t> To;
};
}

//------------------------------------------------------------------------------
std::vector<std::size_t> Bisect(const MeshAccess& mesh, std::span<std::uint32_t> cells,
  std::span<const std::size_t> starts, std::span<const std::uint32_t> partCells,
  const std::function<bool(double)>& progress)
{
  Divider divider(mesh, cells);
  std::vector<std::size_t> all(starts.begin(), starts.end());
  std::vector<Part> parts; // that are not finished
  for (std::size_t i = 0; i + 1 < all.size(); ++i)
  {
    parts.push_back({ all[i], all[i + 1], partCells[i] });
  }
  while (!parts.empty())
  {
    if (progress && !progress(0))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
    std::vector<std::size_t> middles(parts.size());
    const auto divide = [&](std::size_t i)
    {
      const auto& part = parts[i];
      if (part.GetSize() > part.MostCells)
      {
        middles[i] = divider.Divide(part);
        return;
      }
      middles[i] = part.End;
      divider.Take(part, cells);
    };
    if (parts.size() < static_cast<std::size_t>(GetNumberOfThreads()))
    {
      for (std::size_t i = 0; i < parts.size(); ++i)
      {
        divide(i); // by all threads
      }
    }
    else
    {
      ParallelFor(parts.size(), divide);
    }
    divider.Swap();
    std::vector<Part> next;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      if (middles[i] < parts[i].End)
      {
        next.push_back({ parts[i].Begin, middles[i], parts[i].MostCells });
        next.push_back({ middles[i], parts[i].End, parts[i].MostCells });
        all.push_back(middles[i]);
      }
    }
    parts.swap(next);
  }
  std::sort(all.begin(), all.end());
  return all;
}
}
