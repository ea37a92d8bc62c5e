// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunPartMerges.h"

#include "gatunError.h"
#include "gatunMergeCosts.h"
#include "gatunMergeInputCheck.h"
#include "gatunParallel.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <tuple>

namespace gatun
{
namespace
{
/** Bricks of a group, at least, before merges: so many that walls have a choice of places. */
constexpr std::uint64_t BricksOfGroup = 64;

/** The memory for records of merges before they go to disk. */
constexpr std::size_t RecordMemory = std::size_t{ 32 } << 20;

/** A level that leaves more than this part of the tetrahedra does little. The next limit is then
 * further away, and after some such levels in a row there is no use in going on. */
constexpr double SlowLevel = 0.9;
constexpr unsigned SlowStep = 16; // a factor of two of the cost
constexpr int MostSlowLevels = 3;

/** Of the best merges that are left after a level, the next one makes this part. */
constexpr double PartOfLevel = 0.7;

/** Faces that are read at once. */
constexpr std::size_t FacesAtOnce = std::size_t{ 1 } << 16;

/** The part of the time that passes before the first merges. */
constexpr double PartOfFinding = 0.2;

}

//------------------------------------------------------------------------------
bool PartMerges::Record::operator<(const Record& other) const
{
  return std::tie(this->Level, this->Key, this->Pass, this->Group, this->Number) <
    std::tie(other.Level, other.Key, other.Pass, other.Group, other.Number);
}

//------------------------------------------------------------------------------
PartMerges::PartMerges(std::uint32_t points, std::size_t fields, const PartMergeSettings& settings)
  : Points(points)
  , Settings(settings)
  , OfGroups{ settings.Merges, fields }
  , Builder(fields,
      static_cast<std::size_t>(std::max<std::uint64_t>(1, settings.TetsOfGroup / BricksOfGroup)))
  , Bricks(settings.Folder, fields, settings.KeepsCells)
  , BricksOfPoint(points, 0)
  , IsGone(points, false)
  , Histogram(std::size_t{ 1 } << 15, 0)
  , Records(settings.Folder, RecordMemory)
  , Earlier(AtomicFile::MakeScratch(settings.Folder))
{
  CheckMergeSettings(settings.Merges);
  if (settings.Merges.PartAtOnce != 0 || settings.TetsOfGroup == 0)
  {
    ThrowInvalid("these settings are not for merges in parts");
  }
}

//------------------------------------------------------------------------------
void PartMerges::Add(const MergePart& part)
{
  const auto isThere = [&](std::uint32_t point) { return point < this->Points; };
  if (!std::all_of(part.Numbers.begin(), part.Numbers.end(), isThere))
  {
    ThrowInvalid("a part of a mesh has points that the mesh does not have");
  }
  if (this->Settings.KeepsCells ? part.Cells.size() != part.Mesh.Cells.size() : !part.Cells.empty())
  {
    ThrowInvalid("a part of a mesh has not the numbers of cells that others have");
  }
  this->Builder.Add(part,
    [this](const MergeBrick& brick, const Bounds& box)
    {
      this->Bricks.Add(brick);
      this->Boxes.push_back(box);
      for (const auto point : brick.Points)
      {
        auto& bricks = this->BricksOfPoint[point];
        bricks = static_cast<std::uint8_t>(bricks + (bricks < ManyBricks ? 1 : 0));
      }
    });
}

//------------------------------------------------------------------------------
std::vector<std::uint64_t> PartMerges::ListTets() const
{
  std::vector<std::uint64_t> tets;
  for (std::size_t brick = 0; brick < this->Bricks.GetNumber(); ++brick)
  {
    tets.push_back(this->Bricks.GetTets(brick));
  }
  return tets;
}

//------------------------------------------------------------------------------
std::uint64_t PartMerges::CountTets() const
{
  const auto tets = this->ListTets();
  return std::accumulate(tets.begin(), tets.end(), std::uint64_t{ 0 });
}

//------------------------------------------------------------------------------
MergeBrick PartMerges::ReadBrick(std::size_t number) const
{
  MergeBrick brick = this->Bricks.Read(number);
  if (this->HasSums)
  {
    this->Builder.Finish(brick);
  }
  return brick;
}

//------------------------------------------------------------------------------
bool PartMerges::Report(double done)
{
  this->Done = std::max(this->Done, done);
  return !*this->Progress || (*this->Progress)(this->Done);
}

//------------------------------------------------------------------------------
/** The limit below which the keys of the last pass make the part of a level. */
unsigned PartMerges::FindLimit() const
{
  const auto all =
    std::accumulate(this->Histogram.begin(), this->Histogram.end(), std::uint64_t{ 0 });
  const double wanted = PartOfLevel * static_cast<double>(all);
  double below = 0;
  unsigned key = 0;
  for (; key < this->Histogram.size() && below < wanted; ++key)
  {
    below += static_cast<double>(this->Histogram[key]);
  }
  return key;
}

//------------------------------------------------------------------------------
MergedGroup PartMerges::RunGroup(const BrickDivision::Group& group, unsigned limit)
{
  std::vector<MergeBrick> bricks;
  for (const auto brick : group)
  {
    bricks.push_back(this->ReadBrick(brick));
  }
  MergedGroup merged =
    MergeBricks(std::move(bricks), this->OfGroups, this->BricksOfPoint, this->Bared, limit);
  for (std::size_t i = 0; i < group.size(); ++i)
  {
    this->Bricks.Replace(group[i], merged.Bricks[i]);
  }
  merged.Bricks = {};
  return merged;
}

//------------------------------------------------------------------------------
void PartMerges::Note(
  const MergedGroup& merged, std::uint16_t level, std::uint16_t pass, std::uint32_t group)
{
  std::uint32_t number = 0;
  for (const KeyedMerge& merge : merged.Merges)
  {
    this->Records.Add(
      { merge.Change, merge.Point, merge.Into, group, number++, level, pass, merge.Key });
    this->IsGone[merge.Point] = true;
  }
  std::vector<std::uint32_t> earlier;
  std::size_t at = 0;
  for (const KeyedMerge& merge : merged.Merges)
  {
    const auto count = merged.Earlier[at];
    earlier.push_back(merge.Point);
    earlier.insert(earlier.end(), merged.Earlier.begin() + static_cast<std::ptrdiff_t>(at),
      merged.Earlier.begin() + static_cast<std::ptrdiff_t>(at + 1 + count));
    at += 1 + count;
  }
  this->EarlierOfGroup.push_back(earlier.size() * sizeof(earlier[0]));
  this->Earlier.Write(
    { reinterpret_cast<const std::uint8_t*>(earlier.data()), this->EarlierOfGroup.back() });
  if (!merged.Touched.empty())
  {
    this->Touched->Write({ reinterpret_cast<const std::uint8_t*>(merged.Touched.data()),
      merged.Touched.size() * sizeof(TouchedFace) });
  }
  this->Merges += merged.Merges.size();
  for (const auto key : merged.Keys)
  {
    ++this->Histogram[key];
  }
}

//------------------------------------------------------------------------------
void PartMerges::CountBricks(std::span<const std::pair<std::uint32_t, int>> changes)
{
  for (const auto& [point, change] : changes)
  {
    auto& bricks = this->BricksOfPoint[point];
    if (bricks != ManyBricks)
    {
      bricks = static_cast<std::uint8_t>(std::clamp<int>(bricks + change, 0, ManyBricks));
    }
  }
}

//------------------------------------------------------------------------------
/** Merges all groups of a division up to a limit. */
void PartMerges::RunPass(std::uint16_t level, std::uint16_t pass, unsigned limit)
{
  const auto tets = this->ListTets();
  this->Groups = this->Division->Divide(tets, this->Settings.TetsOfGroup);
  const auto& groups = this->Groups;
  std::fill(this->Histogram.begin(), this->Histogram.end(), 0);
  std::vector<std::vector<std::pair<std::uint32_t, int>>> changes(groups.size());
  std::vector<std::vector<BaredFace>> bared(groups.size());
  this->Touched.reset(new AtomicFile(AtomicFile::MakeScratch(this->Settings.Folder)));
  std::mutex mutex;
  const double before = this->Done;
  const double part = limit == 0 ? PartOfFinding : 0.2 * (1 - before);
  ParallelFor(
    groups.size(),
    [&](std::size_t g)
    {
      auto merged = this->RunGroup(groups[g], limit);
      changes[g] = std::move(merged.Changes);
      bared[g] = std::move(merged.Bared);
      const std::scoped_lock lock(mutex);
      this->Note(merged, level, pass, static_cast<std::uint32_t>(g));
    },
    [&](double done) { return this->Report(before + part * done); });
  // All groups of a pass have seen the same numbers.
  for (const auto& some : changes)
  {
    this->CountBricks(some);
  }
  this->Bared.clear();
  for (const auto& some : bared)
  {
    this->Bared.insert(this->Bared.end(), some.begin(), some.end());
  }
  this->FindTouched();
}

//------------------------------------------------------------------------------
/** Finds the merges of a pass that have changed tetrahedra at a side that another one of
 * the pass has bared in another group. Either may come first; the order decides. */
void PartMerges::FindTouched()
{
  const std::uint64_t all = this->Bared.empty() ? 0 : this->Touched->GetSize();
  const auto isBefore = [](const BaredFace& a, const BaredFace& b)
  { return std::tie(a.Points, a.Merge) < std::tie(b.Points, b.Merge); };
  std::sort(this->Bared.begin(), this->Bared.end(), isBefore);
  std::vector<TouchedFace> faces;
  for (std::uint64_t at = 0; at < all; at += faces.size() * sizeof(TouchedFace))
  {
    faces.resize(static_cast<std::size_t>(
      std::min<std::uint64_t>(FacesAtOnce, (all - at) / sizeof(TouchedFace))));
    this->Touched->ReadAt(
      at, { reinterpret_cast<std::uint8_t*>(faces.data()), faces.size() * sizeof(TouchedFace) });
    for (const TouchedFace& face : faces)
    {
      auto bared = std::lower_bound(
        this->Bared.begin(), this->Bared.end(), BaredFace{ face.Points, 0, 0 }, isBefore);
      for (; bared != this->Bared.end() && bared->Points == face.Points; ++bared)
      {
        if (bared->Merge != face.Merge)
        {
          this->Either.push_back({ face.Merge, bared->Merge });
        }
      }
    }
  }
  this->Touched.reset();
}

//------------------------------------------------------------------------------
/** Returns the number of levels. */
std::uint16_t PartMerges::ReduceToOneGroup()
{
  std::uint16_t level = 0;
  std::uint64_t most = this->Settings.TetsOfGroup;
  std::uint64_t left = this->CountTets();
  if (left <= most)
  {
    return level;
  }
  const auto all = static_cast<double>(left);
  unsigned limit = 0;
  int slow = 0;
  this->RunPass(level, 0, limit);
  this->HasSums = false;
  while (left > most)
  {
    limit = std::max(limit + 1 + (slow > 0 ? SlowStep : 0), this->FindLimit());
    this->RunPass(level, 0, limit);
    this->RunPass(level, 1, limit);
    this->EndLevel();
    ++level;
    const std::uint64_t before = left;
    left = this->CountTets();
    slow = static_cast<double>(left) > SlowLevel * static_cast<double>(before) ? slow + 1 : 0;
    if (slow == MostSlowLevels)
    {
      most *= 2;
      slow = 0;
    }
    this->Report(PartOfFinding + (1 - PartOfFinding) * (1 - static_cast<double>(left) / all));
  }
  return level;
}

//------------------------------------------------------------------------------
void PartMerges::EndLevel()
{
  this->MergesOfLevels = static_cast<std::uint32_t>(this->Merges);
  if (this->OnLevel)
  {
    this->OnLevel(this->MergesOfLevels);
  }
}

//------------------------------------------------------------------------------
/** ancestors: of each point after further merges. Empty: there are none. */
MergedPart PartMerges::Read(
  const BrickDivision::Group& group, std::span<const std::uint32_t> ancestors) const
{
  MergedPart part;
  std::vector<MergeBrick> bricks;
  std::vector<std::uint32_t> uses; // of points by bricks
  for (const auto number : group)
  {
    auto& brick = bricks.emplace_back(this->Bricks.Read(number));
    brick.Samples = {};
    for (auto& point : brick.Points)
    {
      point = ancestors.empty() ? point : ancestors[point];
    }
    uses.insert(uses.end(), brick.Points.begin(), brick.Points.end());
  }
  std::sort(uses.begin(), uses.end());
  for (std::size_t first = 0, end = 0; first < uses.size(); first = end)
  {
    while (end < uses.size() && uses[end] == uses[first])
    {
      ++end;
    }
    const auto all = this->BricksOfPoint[uses[first]];
    part.Points.push_back(uses[first]);
    part.IsShared.push_back(ancestors.empty() && (all == ManyBricks || all > end - first) ? 1 : 0);
  }
  std::vector<std::uint32_t> places;
  for (const MergeBrick& brick : bricks)
  {
    places.clear();
    for (const auto point : brick.Points)
    {
      places.push_back(static_cast<std::uint32_t>(
        std::lower_bound(part.Points.begin(), part.Points.end(), point) - part.Points.begin()));
    }
    for (std::size_t i = 0; i < brick.Tets.size(); ++i)
    {
      auto tet = brick.Tets[i];
      if (Simplify(tet, places))
      {
        part.Tets.push_back(tet);
        if (!brick.Cells.empty())
        {
          part.Cells.push_back(brick.Cells[i]);
        }
      }
    }
  }
  return part;
}

//------------------------------------------------------------------------------
MergedPart PartMerges::ReadRest(std::span<const std::uint32_t> ancestors) const
{
  BrickDivision::Group all(this->Bricks.GetNumber());
  std::iota(all.begin(), all.end(), 0u);
  return this->Read(all, ancestors);
}

//------------------------------------------------------------------------------
MergeTree PartMerges::MakeTree()
{
  this->Records.Sort();
  std::vector<Merge> merges;
  merges.reserve(this->Merges);
  double change = 0;
  for (; const Record* const record = this->Records.Get(); this->Records.Next())
  {
    change += record->Change;
    merges.push_back({ record->Point, record->Into,
      static_cast<float>(std::sqrt(change) / MergeCosts<1>::ChangePerError) });
  }
  return { this->Points, std::move(merges) };
}

//------------------------------------------------------------------------------
MergeDependencies PartMerges::FindDependencies(const MergeTree& tree)
{
  const auto& merges = tree.GetMerges();
  std::vector<std::uint32_t> numbers(this->Points); // of the merges of points
  for (std::uint32_t i = 0; i < merges.size(); ++i)
  {
    numbers[merges[i].Point] = i;
  }
  SpillSorter<Dependency> sorted(this->Settings.Folder, RecordMemory);
  std::uint64_t place = 0;
  std::vector<std::uint32_t> earlier;
  for (const auto bytes : this->EarlierOfGroup)
  {
    earlier.resize(bytes / sizeof(earlier[0]));
    this->Earlier.ReadAt(place, { reinterpret_cast<std::uint8_t*>(earlier.data()), bytes });
    place += bytes;
    for (std::size_t at = 0; at < earlier.size();)
    {
      const auto merge = numbers[earlier[at++]];
      for (auto count = earlier[at++]; count > 0; --count)
      {
        sorted.Add({ merge, numbers[earlier[at++]] });
      }
    }
  }
  for (const auto& [merge, other] : this->Either)
  {
    if (numbers[other] < numbers[merge])
    {
      sorted.Add({ numbers[merge], numbers[other] });
    }
  }
  sorted.Sort();
  MergeDependencies dependencies;
  for (std::uint32_t i = 0; i < merges.size(); ++i)
  {
    earlier.clear();
    for (; sorted.Get() && sorted.Get()->Merge == i; sorted.Next())
    {
      if (earlier.empty() || earlier.back() != sorted.Get()->Earlier)
      {
        earlier.push_back(sorted.Get()->Earlier);
      }
    }
    dependencies.Add(earlier);
  }
  return dependencies;
}

//------------------------------------------------------------------------------
MergeTree PartMerges::Build(const std::function<bool(double)>& progress)
{
  this->Progress = &progress;
  this->Division.emplace(std::move(this->Boxes));
  this->Builder.End();
  this->OfGroups.PerWhole = this->Builder.GetPerWhole();
  this->OfGroups.PerTet = this->Builder.GetPerTet();
  const std::uint16_t levels = this->ReduceToOneGroup();
  std::vector<MergeBrick> rest;
  for (std::size_t brick = 0; brick < this->Bricks.GetNumber(); ++brick)
  {
    if (this->Bricks.GetTets(brick) > 0)
    {
      rest.push_back(this->ReadBrick(brick));
    }
  }
  const double before = this->Done;
  const auto merged = MergeBricks(std::move(rest), this->OfGroups, {}, this->Bared, {},
    [&](double done) { return this->Report(before + (1 - before) * done); });
  this->Note(merged, levels, 0, 0);
  return this->MakeTree();
}
}
