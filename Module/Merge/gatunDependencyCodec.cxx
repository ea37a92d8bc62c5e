// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunDependencyCodec.h"

#include "gatunEntropy.h"
#include "gatunError.h"
#include "gatunNumberModel.h"
#include "gatunResidual.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
constexpr std::uint32_t None = 0xffffffffu;

constexpr std::size_t MostPerMerge = 64; // on average, with the merges that are skipped

/** The earlier merges into each point, from the last one. */
class MergesInto
{
public:
  explicit MergesInto(const MergeTree& tree)
    : Last(tree.GetNumberOfPoints(), None)
    , Before(tree.GetMerges().size(), None)
  {
  }

  void Add(std::uint32_t merge, std::uint32_t into)
  {
    this->Before[merge] = std::exchange(this->Last[into], merge);
  }

  /** None if there is none. */
  std::uint32_t GetLast(std::uint32_t point) const { return this->Last[point]; }
  std::uint32_t GetBefore(std::uint32_t merge) const { return this->Before[merge]; }

private:
  std::vector<std::uint32_t> Last;   // by points
  std::vector<std::uint32_t> Before; // by merges: the one before it into the same point
};

/** What is known of the points around each point from merges and their dependencies. */
class KnownNeighbors
{
public:
  static constexpr std::size_t Most = 8; // of a point

  explicit KnownNeighbors(std::uint32_t points)
    : Of(points)
  {
    for (List& list : this->Of)
    {
      list.fill(None);
    }
  }

  /** From the last one that was met. */
  const auto& Get(std::uint32_t point) const { return this->Of[point]; }

  void Meet(std::uint32_t one, std::uint32_t other)
  {
    if (one != other)
    {
      this->Move(one, other);
      this->Move(other, one);
    }
  }

private:
  using List = std::array<std::uint32_t, Most>;

  /** To the front. */
  void Move(std::uint32_t point, std::uint32_t neighbor)
  {
    List& list = this->Of[point];
    const auto found = std::find(list.begin(), list.end() - 1, neighbor);
    std::copy_backward(list.begin(), found, found + 1);
    list.front() = neighbor;
  }

  std::vector<List> Of;
};

/** Codes the points that the merges lead to which a merge depends on. */
class DependencyCoder
{
public:
  explicit DependencyCoder(const MergeTree& tree)
    : Points(tree.GetNumberOfPoints())
    , Room(MostPerMerge * tree.GetMerges().size())
    , Into(tree)
    , Neighbors(this->Points)
  {
  }

  /** Whether a stream may not have so many dependencies. */
  bool IsFull() const { return this->Taken > this->Room; }

  /**
   * Codes the numbers of the merges that a merge depends on. earlier: those to be encoded. Returns
   * those that were coded, ascending. They are not complete if there is no room for more.
   */
  template <typename Coder>
  std::vector<std::uint32_t> Code(Coder& coder, std::uint32_t number, const MergeTree& tree,
    const std::vector<std::uint32_t>& earlier)
  {
    const Merge& merge = tree.GetMerges()[number];
    std::vector<std::uint32_t> wanted;
    for (const auto one : earlier)
    {
      wanted.push_back(tree.GetMerges()[one].Into);
    }
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    const auto points = this->CodePoints(coder, merge, std::move(wanted));
    std::vector<std::uint32_t> coded;
    for (const auto point : points)
    {
      this->CodeMerges(coder, point, earlier, coded);
      if (this->IsFull())
      {
        return coded;
      }
    }
    this->Learn(number, merge, points);
    std::sort(coded.begin(), coded.end());
    return coded;
  }

private:
  /** How a point is known to be near. */
  enum Source : std::uint8_t
  {
    Target, // the merge leads to it
    Self,
    OfPoint,  // known to be next to the point
    OfTarget, // or to the one that it is merged into
    OfBoth,
    Sources
  };

  struct Candidate
  {
    std::uint32_t Point;
    std::uint32_t Last; // merge into it
    Source From;
  };

  /** Points that the merge may depend on, from the one that was merged into last. */
  void FindCandidates(const Merge& merge)
  {
    this->Candidates.clear();
    const auto add = [&](std::uint32_t point, Source from)
    {
      const auto last = point == None ? None : this->Into.GetLast(point);
      if (last == None)
      {
        return;
      }
      for (Candidate& known : this->Candidates)
      {
        if (known.Point == point)
        {
          known.From = known.From == OfPoint && from == OfTarget ? OfBoth : known.From;
          return;
        }
      }
      this->Candidates.push_back({ point, last, from });
    };
    add(merge.Into, Target);
    add(merge.Point, Self);
    for (const auto point : this->Neighbors.Get(merge.Point))
    {
      add(point, OfPoint);
    }
    for (const auto point : this->Neighbors.Get(merge.Into))
    {
      add(point, OfTarget);
    }
    std::sort(this->Candidates.begin(), this->Candidates.end(),
      [](const Candidate& a, const Candidate& b) { return a.Last > b.Last; });
  }

  template <typename Coder>
  std::vector<std::uint32_t> CodePoints(
    Coder& coder, const Merge& merge, std::vector<std::uint32_t> wanted)
  {
    this->FindCandidates(merge);
    std::vector<std::uint32_t> points;
    for (std::size_t i = 0; i < this->Candidates.size(); ++i)
    {
      const Candidate& candidate = this->Candidates[i];
      const auto found = std::lower_bound(wanted.begin(), wanted.end(), candidate.Point);
      const bool isWanted = found != wanted.end() && *found == candidate.Point;
      auto& model = this->IsNeeded[candidate.From][std::min(i, LastPlace)];
      if (coder.Bit(model, isWanted) != 0)
      {
        points.push_back(candidate.Point);
      }
      if (isWanted)
      {
        wanted.erase(found);
      }
    }
    // The others ascend.
    const auto count = this->CodeCount(coder, points.size(), wanted.size());
    std::int64_t last = merge.Point;
    for (std::size_t i = 0; i < count; ++i)
    {
      Step& step = this->Steps[i > 0 ? 1 : 0];
      const std::int64_t distance = step.Model.Code(coder, step.Spread.Get(),
        i < wanted.size() ? static_cast<std::int64_t>(wanted[i]) - last : 0);
      step.Spread.Add(distance);
      last = static_cast<std::int64_t>(
        static_cast<std::uint64_t>(last) + static_cast<std::uint64_t>(distance));
      if (last < 0 || last >= this->Points || (i > 0 && distance <= 0))
      {
        ThrowCorrupt("a merge depends on one into a point that is not there");
      }
      points.push_back(static_cast<std::uint32_t>(last));
    }
    return points;
  }

  /** Codes the number of points that are no candidates. */
  template <typename Coder>
  std::size_t CodeCount(Coder& coder, std::size_t candidates, std::size_t count)
  {
    constexpr std::size_t most = 7;
    const auto few = std::min(count, most);
    auto& model = this->Few[std::min(candidates, this->Few.size() - 1)];
    const std::size_t coded = model.Code(coder, static_cast<unsigned>(few));
    return coded == most ? coded + this->Many.Code(coder, static_cast<std::uint32_t>(count - few))
                         : coded;
  }

  /** The first merge, from a given one back, that is among earlier ones, or None. Those before are
   * skipped. */
  std::uint32_t FindWanted(
    std::uint32_t merge, const std::vector<std::uint32_t>& earlier, std::uint32_t& skipped) const
  {
    while (merge != None && !std::binary_search(earlier.begin(), earlier.end(), merge))
    {
      const bool isBeforeAll = earlier.empty() || merge < earlier.front();
      merge = isBeforeAll ? None : this->Into.GetBefore(merge);
      ++skipped;
    }
    return merge;
  }

  /** Codes which merges into a point are needed, from the last one. */
  template <typename Coder>
  void CodeMerges(Coder& coder, std::uint32_t point, const std::vector<std::uint32_t>& earlier,
    std::vector<std::uint32_t>& coded)
  {
    auto merge = this->Into.GetLast(point);
    for (unsigned order = 0;; order = 1)
    {
      std::uint32_t skipped = 0;
      const auto wanted = this->FindWanted(merge, earlier, skipped);
      // 0 ends the list of further ones.
      const std::uint32_t value = order == 0 ? skipped : wanted == None ? 0 : skipped + 1;
      std::uint32_t steps = this->Skipped[order].Code(coder, value);
      if (order > 0 && steps == 0)
      {
        return;
      }
      steps -= order;
      for (; steps > 0 && merge != None; --steps)
      {
        merge = this->Into.GetBefore(merge);
        ++this->Taken;
      }
      if (merge == None)
      {
        ThrowCorrupt("a merge depends on one that is not there");
      }
      coded.push_back(merge);
      ++this->Taken;
      merge = this->Into.GetBefore(merge);
      if (merge == None)
      {
        return;
      }
    }
  }

  void Learn(std::uint32_t number, const Merge& merge, const std::vector<std::uint32_t>& points)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->Neighbors.Meet(merge.Into, points[i]);
      for (std::size_t k = 0; k < i; ++k)
      {
        this->Neighbors.Meet(points[k], points[i]);
      }
    }
    const auto inherited = this->Neighbors.Get(merge.Point);
    for (std::size_t i = inherited.size(); i > 0; --i)
    {
      if (inherited[i - 1] != None)
      {
        this->Neighbors.Meet(merge.Into, inherited[i - 1]);
      }
    }
    this->Into.Add(number, merge.Into);
  }

  struct Step
  {
    ResidualModel Model;
    RunningSpread Spread;
  };

  static constexpr std::size_t LastPlace = 9;

  std::uint32_t Points;
  std::size_t Room;
  std::size_t Taken = 0; // by dependencies and merges that were skipped
  MergesInto Into;
  KnownNeighbors Neighbors;
  std::vector<Candidate> Candidates;
  std::array<std::array<BitModel, LastPlace + 1>, Sources> IsNeeded;
  std::array<BitTree<3>, 4> Few;
  NumberModel Many;
  std::array<Step, 2> Steps;
  std::array<NumberModel, 2> Skipped;
};

/** The merges that a merge depends on but for those that others of them depend on, directly or by
 * one between them. */
std::vector<std::uint32_t> Reduce(const MergeDependencies& all, std::size_t merge)
{
  const auto hasDirectly = [&](std::uint32_t later, std::uint32_t earlier)
  {
    const auto some = all.Get(later);
    return std::binary_search(some.begin(), some.end(), earlier);
  };
  const auto has = [&](std::uint32_t later, std::uint32_t earlier)
  {
    const auto between = all.Get(later);
    return hasDirectly(later, earlier) ||
      std::any_of(std::upper_bound(between.begin(), between.end(), earlier), between.end(),
        [&](std::uint32_t other) { return hasDirectly(other, earlier); });
  };
  const auto earlier = all.Get(merge);
  std::vector<std::uint32_t> left;
  for (auto one = earlier.begin(); one != earlier.end(); ++one)
  {
    if (std::none_of(one + 1, earlier.end(), [&](std::uint32_t later) { return has(later, *one); }))
    {
      left.push_back(*one);
    }
  }
  return left;
}
}

//------------------------------------------------------------------------------
MergeDependencies SelectDependencies(
  const MergeDependencies& all, std::uint32_t first, std::uint32_t end)
{
  MergeDependencies selected;
  for (std::size_t merge = first; merge < all.GetNumberOfMerges(); ++merge)
  {
    auto earlier = Reduce(all, merge);
    std::erase_if(earlier, [=](std::uint32_t one) { return one < first || one >= end; });
    for (auto& one : earlier)
    {
      one -= first;
    }
    selected.Add(earlier);
  }
  return selected;
}

//------------------------------------------------------------------------------
MergeDependencies JoinDependencies(
  const MergeDependencies& onFirst, std::uint32_t merges, const MergeDependencies& rest)
{
  MergeDependencies joined;
  std::vector<std::uint32_t> earlier;
  for (std::size_t merge = 0; merge < onFirst.GetNumberOfMerges(); ++merge)
  {
    const auto first = onFirst.Get(merge);
    earlier.assign(first.begin(), first.end());
    if (merge >= merges)
    {
      for (const auto one : rest.Get(merge - merges))
      {
        earlier.push_back(one + merges);
      }
    }
    joined.Add(earlier);
  }
  return joined;
}

//------------------------------------------------------------------------------
Bytes EncodeDependencies(const MergeTree& tree, const MergeDependencies& dependencies,
  const std::function<bool(double)>& progress)
{
  DependencyCoder dependent(tree);
  EntropyEncoder coder;
  const std::size_t merges = tree.GetMerges().size();
  for (std::uint32_t i = 0; i < merges; ++i)
  {
    if (progress && i % MergeDependencies::MergesBetweenProgress == 0 &&
      !progress(static_cast<double>(i) / static_cast<double>(merges)))
    {
      throw Error(ErrorCode::Aborted, "aborted");
    }
    dependent.Code(coder, i, tree, Reduce(dependencies, i));
    if (dependent.IsFull())
    {
      return {};
    }
  }
  return coder.Finish();
}

//------------------------------------------------------------------------------
MergeDependencies DecodeDependencies(std::span<const std::uint8_t> stream, const MergeTree& tree)
{
  DependencyCoder dependent(tree);
  EntropyDecoder coder(stream);
  MergeDependencies dependencies;
  for (std::uint32_t i = 0; i < tree.GetMerges().size(); ++i)
  {
    const auto earlier = dependent.Code(coder, i, tree, {});
    if (dependent.IsFull())
    {
      ThrowCorrupt("there are more dependencies of merges than there may be");
    }
    dependencies.Add(earlier);
  }
  return dependencies;
}
}
