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

namespace gatun
{
namespace
{
constexpr std::size_t ItemsPerTask = 1u << 15;
constexpr std::size_t Bins = 1024;

/** A cell and four times the mean of its points. */
struct Item
{
  std::array<float, 3> Place;
  std::uint32_t Cell;
};

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
  unsigned Axis;

  bool operator()(const Item& l, const Item& r) const
  {
    const float left = l.Place[this->Axis];
    const float right = r.Place[this->Axis];
    return (left < right) | ((left == right) & (l.Cell < r.Cell));
  }
};

struct Part
{
  std::size_t Begin;
  std::size_t End;
  std::uint32_t MostCells; // of a part that is not divided

  std::size_t GetSize() const { return this->End - this->Begin; }
  std::size_t CountTasks() const { return (this->GetSize() + ItemsPerTask - 1) / ItemsPerTask; }

  template <typename T>
  std::span<T> GetTask(std::vector<T>& items, std::size_t task) const
  {
    const auto begin = this->Begin + task * ItemsPerTask;
    return { items.data() + begin, std::min(ItemsPerTask, this->End - begin) };
  }
};

/** Divides parts, from one array of items into another. */
class Divider
{
public:
  Divider(const MeshAccess& mesh, std::span<const std::uint32_t> cells)
    : From(cells.size())
    , To(cells.size())
  {
    const Part all{ 0, cells.size(), 0 };
    ParallelFor(all.CountTasks(),
      [&](std::size_t task)
      {
        auto cell = cells.begin() + static_cast<std::ptrdiff_t>(task * ItemsPerTask);
        for (auto& item : all.GetTask(this->From, task))
        {
          item.Cell = *cell++;
          item.Place = GetPlace(mesh, item.Cell);
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
    const IsBefore isBefore{ axis };
    const Item pivot = this->Select(part, axis, box[axis], half);

    std::vector<std::size_t> starts(part.CountTasks() + 1, 0); // of the tasks in the first half
    ParallelFor(part.CountTasks(),
      [&](std::size_t task)
      {
        for (const auto& item : part.GetTask(this->From, task))
        {
          starts[task + 1] += isBefore(item, pivot);
        }
      });
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    ParallelFor(part.CountTasks(),
      [&](std::size_t task)
      {
        std::array<std::size_t, 2> next{ part.Begin + half + task * ItemsPerTask - starts[task],
          part.Begin + starts[task] };
        for (const auto& item : part.GetTask(this->From, task))
        {
          this->To[next[isBefore(item, pivot)]++] = item;
        }
      });
    return part.Begin + half;
  }

  /** Continues with the halves. */
  void Swap() { this->From.swap(this->To); }

  const Item& operator[](std::size_t i) const { return this->From[i]; }

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
        for (const auto& item : part.GetTask(this->From, task))
        {
          for (unsigned i = 0; i < 3; ++i)
          {
            box[i].Include({ item.Place[i], item.Place[i] });
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

  /** The item at a position of the order along an axis. A histogram leaves few items to sort. */
  Item Select(const Part& part, unsigned axis, const Extent& extent, std::size_t position)
  {
    const double scale = static_cast<double>(Bins - 1) / extent.GetLength();
    const auto binOf = [&](const Item& item)
    {
      const double bin = (double{ item.Place[axis] } - double{ extent.Min }) * scale;
      return bin < static_cast<double>(Bins) ? static_cast<std::size_t>(bin) : 0; // 0 for NaN
    };
    std::vector<std::array<std::uint32_t, Bins>> counts(part.CountTasks());
    ParallelFor(counts.size(),
      [&](std::size_t task)
      {
        auto& count = counts[task];
        count.fill(0);
        for (const auto& item : part.GetTask(this->From, task))
        {
          ++count[binOf(item)];
        }
      });
    std::size_t bin = 0;
    std::size_t before = 0;
    for (;; ++bin)
    {
      std::size_t count = 0;
      for (const auto& list : counts)
      {
        count += list[bin];
      }
      if (before + count > position)
      {
        break;
      }
      before += count;
    }
    std::vector<std::size_t> starts(counts.size() + 1, 0);
    for (std::size_t task = 0; task < counts.size(); ++task)
    {
      starts[task + 1] = starts[task] + counts[task][bin];
    }
    std::vector<Item> rest(starts.back());
    ParallelFor(counts.size(),
      [&](std::size_t task)
      {
        auto next = starts[task];
        for (const auto& item : part.GetTask(this->From, task))
        {
          if (binOf(item) == bin)
          {
            rest[next++] = item;
          }
        }
      });
    const auto nth = rest.begin() + static_cast<std::ptrdiff_t>(position - before);
    std::nth_element(rest.begin(), nth, rest.end(), IsBefore{ axis });
    return *nth;
  }

  std::vector<Item> From;
  std::vector<Item> To;
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
      for (auto at = part.Begin; at < part.End; ++at)
      {
        cells[at] = divider[at].Cell;
      }
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
