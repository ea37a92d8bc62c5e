// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunBrickGroup.h"

#include "gatunMergeOrder.h"
#include "gatunTetRounds.h"
#include "gatunVector.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <numeric>
#include <optional>
#include <unordered_map>

namespace gatun
{
namespace
{
/** The bricks as one mesh. Its points and tetrahedra have places, such that neighbors are near. */
class Group
{
public:
  using Tet = MergeMesh::Tet;

  Group(std::vector<MergeBrick> bricks, const BrickGroupSettings& settings,
    std::span<const std::uint8_t> bricksOfPoint)
    : Settings(settings)
    , Bricks(std::move(bricks))
  {
    this->PlacePoints();
    this->PlaceTets();
    this->FindKept(bricksOfPoint);
  }

  template <std::size_t NumberOfFields>
  MergedGroup Run(std::span<const BaredFace> bared, std::optional<unsigned> limit,
    const std::function<bool(double)>& progress);

private:
  void PlacePoints();
  void PlaceTets();
  void FindKept(std::span<const std::uint8_t> bricksOfPoint);
  std::uint32_t FindPlace(std::uint32_t number) const;
  void TakeBared(const MergeMesh& mesh, std::span<const BaredFace> bared);
  void Note(const MergeMesh& mesh, const Merge& merge, MergeQueue::Key key, double change);
  void NoteEarlier(std::span<const std::uint32_t> ring);
  std::optional<std::array<std::uint32_t, 3>> FindWall(
    const Tet& corners, std::uint32_t point) const;
  void FindBared(const MergeMesh& mesh, const Merge& merge);
  MergeBrick Rebuild(std::size_t brick, const MergeMesh& mesh, const MergeFields& fields);
  void CountChanges();

  const BrickGroupSettings& Settings;
  std::vector<MergeBrick> Bricks;
  std::vector<std::uint32_t> Numbers;             // in the mesh, of each place
  std::vector<std::uint32_t> ByNumber;            // places
  std::vector<std::vector<std::uint32_t>> Places; // of the points of each brick
  std::vector<MergeHint> Hints;                   // of each place; Into is a number in the mesh
  LargeArray<MergeFields::Sample> Samples;
  std::vector<std::uint8_t> IsKept;
  std::vector<int> Counts;     // bricks of each point
  std::vector<int> CountsLeft; // afterwards

  std::vector<Tet> Tets;
  std::vector<MergeQueue::Key> Keys;                                   // of each tetrahedron
  std::vector<std::uint32_t> Last;                                     // see MergeBrick
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> Bared; // by tetrahedra
  std::vector<std::uint32_t> TetPlaces; // of those of one brick after the other
  std::vector<std::size_t> FirstTets;   // of each brick among them

  // Of the merge that comes next.
  std::vector<std::uint32_t> Earlier;
  std::vector<std::uint32_t> BaredTets;
  std::vector<std::array<std::uint32_t, 3>> BaredWalls;

  MergeQueue::Key LargestKey = 0;   // of the merges of this pass and those before
  std::vector<std::uint32_t> Found; // of each place, one more than the place in a new brick
  MergedGroup Merged;
};

//------------------------------------------------------------------------------
void Group::PlacePoints()
{
  struct Source
  {
    std::uint32_t Number, Brick, Point;
    bool operator<(const Source& other) const
    {
      return std::pair(this->Number, this->Brick) < std::pair(other.Number, other.Brick);
    }
  };
  std::vector<Source> sources;
  for (std::uint32_t b = 0; b < this->Bricks.size(); ++b)
  {
    for (std::uint32_t i = 0; i < this->Bricks[b].Points.size(); ++i)
    {
      sources.push_back({ this->Bricks[b].Points[i], b, i });
    }
  }
  std::sort(sources.begin(), sources.end());
  const auto isSame = [](const Source& a, const Source& b) { return a.Number == b.Number; };
  std::vector<Source> firsts;
  std::unique_copy(sources.begin(), sources.end(), std::back_inserter(firsts), isSame);
  const std::size_t each = 1 + this->Settings.Fields;
  const auto getSample = [&](const Source& source)
  { return this->Bricks[source.Brick].Samples.data() + source.Point * each; };
  std::vector<std::array<double, 3>> points;
  points.reserve(firsts.size());
  for (const Source& source : firsts)
  {
    points.push_back(ToArray(getSample(source)->Gradient));
  }
  const auto order = OrderByPlace(points);
  const auto places = InvertOrder(order);
  this->Numbers.reserve(order.size());
  this->Hints.reserve(order.size());
  this->Samples.reserve(order.size() * each);
  for (const auto i : order)
  {
    const Source& source = firsts[i];
    this->Numbers.push_back(source.Number);
    this->Hints.push_back(this->Bricks[source.Brick].Hints[source.Point]);
    this->Samples.insert(this->Samples.end(), getSample(source), getSample(source) + each);
  }
  this->ByNumber = places; // as firsts are by number
  this->Counts.assign(order.size(), 0);
  for (const MergeBrick& brick : this->Bricks)
  {
    this->Places.emplace_back(brick.Points.size());
  }
  std::size_t at = 0;
  for (const Source& source : sources)
  {
    at += source.Number == firsts[at].Number ? 0 : 1;
    this->Places[source.Brick][source.Point] = places[at];
    ++this->Counts[places[at]];
  }
}

//------------------------------------------------------------------------------
void Group::PlaceTets()
{
  std::vector<Tet> tets;
  for (std::size_t b = 0; b < this->Bricks.size(); ++b)
  {
    this->FirstTets.push_back(tets.size());
    for (const Tet& tet : this->Bricks[b].Tets)
    {
      auto& placed = tets.emplace_back();
      std::transform(tet.begin(), tet.end(), placed.begin(),
        [&](std::uint32_t point) { return this->Places[b][point]; });
    }
  }
  std::vector<std::uint32_t> same(this->Numbers.size());
  std::iota(same.begin(), same.end(), 0u);
  const auto order = OrderByLowestPoint<4>(tets, same);
  this->TetPlaces = InvertOrder(order);
  this->Keys.resize(tets.size());
  this->Last.resize(tets.size());
  for (std::size_t b = 0; b < this->Bricks.size(); ++b)
  {
    const MergeBrick& brick = this->Bricks[b];
    const auto* const placesOfTets = this->TetPlaces.data() + this->FirstTets[b];
    for (std::size_t i = 0; i < brick.Tets.size(); ++i)
    {
      this->Keys[placesOfTets[i]] = brick.Keys[i];
      this->Last[placesOfTets[i]] = brick.Last[i];
    }
    for (const BaredTet& bared : brick.Bared)
    {
      this->Bared[placesOfTets[bared.Tet]].push_back(bared.Merge);
    }
  }
  this->Tets.reserve(tets.size());
  for (const auto tet : order)
  {
    this->Tets.push_back(tets[tet]);
  }
}

//------------------------------------------------------------------------------
void Group::FindKept(std::span<const std::uint8_t> bricksOfPoint)
{
  this->IsKept.assign(this->Numbers.size(), 0);
  for (std::size_t place = 0; place < this->Numbers.size() && !bricksOfPoint.empty(); ++place)
  {
    const auto all = bricksOfPoint[this->Numbers[place]];
    this->IsKept[place] = all == ManyBricks || all > this->Counts[place] ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
/** The place of a point of the mesh; None if it is not in the group. */
std::uint32_t Group::FindPlace(std::uint32_t number) const
{
  const auto found = std::lower_bound(this->ByNumber.begin(), this->ByNumber.end(), number,
    [&](std::uint32_t at, std::uint32_t wanted) { return this->Numbers[at] < wanted; });
  return found != this->ByNumber.end() && this->Numbers[*found] == number ? *found
                                                                          : MergeMesh::None;
}

//------------------------------------------------------------------------------
/** Finds the tetrahedra behind sides that other groups have bared. */
void Group::TakeBared(const MergeMesh& mesh, std::span<const BaredFace> bared)
{
  for (const BaredFace& face : bared)
  {
    std::array<std::uint32_t, 3> places{};
    std::transform(face.Points.begin(), face.Points.end(), places.begin(),
      [this](std::uint32_t point) { return this->FindPlace(point); });
    if (std::find(places.begin(), places.end(), MergeMesh::None) != places.end())
    {
      continue;
    }
    for (const auto tet : mesh.GetRing(places[0]))
    {
      const Tet& corners = mesh.GetTet(tet);
      if (MergeMesh::FindCorner(corners, places[1]) < 4 &&
        MergeMesh::FindCorner(corners, places[2]) < 4)
      {
        this->Keys[tet] = std::max(this->Keys[tet], face.Key);
        this->Bared[tet].push_back(face.Merge);
      }
    }
  }
}

//------------------------------------------------------------------------------
/** Notes a merge that comes next. What it changes, and what becomes a part of the boundary by it,
 * then needs it. It comes behind all merges before that have changed either. */
void Group::Note(const MergeMesh& mesh, const Merge& merge, MergeQueue::Key key, double change)
{
  const auto ring = mesh.GetRing(merge.Point);
  this->FindBared(mesh, merge);
  for (const auto tet : ring)
  {
    key = std::max(key, this->Keys[tet]);
  }
  for (const auto tet : this->BaredTets)
  {
    key = std::max(key, this->Keys[tet]);
  }
  if (!this->BaredWalls.empty())
  {
    key = std::max(key, this->LargestKey); // as the tetrahedron is elsewhere
  }
  this->NoteEarlier(ring);
  const std::uint32_t number = this->Numbers[merge.Point];
  this->Merged.Merges.push_back({ number, this->Numbers[merge.Into], change, key });
  for (const auto tet : ring)
  {
    this->Keys[tet] = key;
    this->Last[tet] = number;
    if (const auto wall = this->FindWall(mesh.GetTet(tet), merge.Point))
    {
      this->Merged.Touched.push_back({ *wall, number });
    }
  }
  for (const auto tet : this->BaredTets)
  {
    this->Keys[tet] = key;
    this->Bared[tet].push_back(number);
  }
  for (const auto& wall : this->BaredWalls)
  {
    this->Merged.Bared.push_back({ wall, number, key });
  }
}

//------------------------------------------------------------------------------
/** Notes what a merge depends on, see MergeDependencies. ring: the tetrahedra around its point. */
void Group::NoteEarlier(std::span<const std::uint32_t> ring)
{
  auto& earlier = this->Earlier;
  earlier.clear();
  for (const auto tet : ring)
  {
    if (this->Last[tet] != MergeMesh::None)
    {
      earlier.push_back(this->Last[tet]);
    }
    if (const auto bared = this->Bared.find(tet); bared != this->Bared.end())
    {
      earlier.insert(earlier.end(), bared->second.begin(), bared->second.end());
      this->Bared.erase(bared); // others depend on this merge
    }
  }
  std::sort(earlier.begin(), earlier.end());
  earlier.erase(std::unique(earlier.begin(), earlier.end()), earlier.end());
  this->Merged.Earlier.push_back(static_cast<std::uint32_t>(earlier.size()));
  this->Merged.Earlier.insert(this->Merged.Earlier.end(), earlier.begin(), earlier.end());
}

//------------------------------------------------------------------------------
/** A tetrahedron that vanishes, with a side on the boundary, leaves it to the one behind it: finds
 * the latter, or the walls of the group behind which they are. */
void Group::FindBared(const MergeMesh& mesh, const Merge& merge)
{
  this->BaredTets.clear();
  this->BaredWalls.clear();
  for (const auto vanishing : mesh.GetRing(merge.Point))
  {
    const Tet& corners = mesh.GetTet(vanishing);
    const unsigned into = MergeMesh::FindCorner(corners, merge.Into);
    if (into == 4 || (mesh.GetBoundaryFaces(vanishing) >> into & 1) == 0)
    {
      continue;
    }
    const auto rest = MergeMesh::FindOthers(MergeMesh::FindCorner(corners, merge.Point), into);
    const auto before = this->BaredTets.size();
    for (const auto next : mesh.GetRing(merge.Into))
    {
      const Tet& c = mesh.GetTet(next);
      if (next != vanishing && MergeMesh::FindCorner(c, corners[rest[0]]) < 4 &&
        MergeMesh::FindCorner(c, corners[rest[1]]) < 4)
      {
        this->BaredTets.push_back(next);
      }
    }
    const auto wall = this->FindWall(corners, merge.Point);
    if (wall && this->BaredTets.size() == before)
    {
      this->BaredWalls.push_back(*wall);
    }
  }
}

//------------------------------------------------------------------------------
/** The side of a tetrahedron opposite to a point, if other groups may have it, too. */
std::optional<std::array<std::uint32_t, 3>> Group::FindWall(
  const Tet& corners, std::uint32_t point) const
{
  std::array<std::uint32_t, 3> face{};
  auto* next = face.begin();
  for (const auto corner : corners)
  {
    if (corner == point)
    {
      continue;
    }
    if (this->IsKept[corner] == 0)
    {
      return {};
    }
    *next++ = this->Numbers[corner];
  }
  std::sort(face.begin(), face.end());
  return face;
}

//------------------------------------------------------------------------------
/** Returns what is left of a brick. */
MergeBrick Group::Rebuild(std::size_t brick, const MergeMesh& mesh, const MergeFields& fields)
{
  MergeBrick made;
  std::vector<std::uint32_t> places;
  for (std::size_t i = 0; i < this->Bricks[brick].Tets.size(); ++i)
  {
    const auto tet = this->TetPlaces[this->FirstTets[brick] + i];
    if (mesh.GetTet(tet)[0] == MergeMesh::None)
    {
      continue;
    }
    made.Tets.push_back(mesh.GetTet(tet));
    made.Keys.push_back(this->Keys[tet]);
    made.Last.push_back(this->Last[tet]);
    if (const auto bared = this->Bared.find(tet); bared != this->Bared.end())
    {
      for (const auto merge : bared->second)
      {
        made.Bared.push_back({ static_cast<std::uint32_t>(made.Tets.size() - 1), merge });
      }
    }
    if (!this->Bricks[brick].Cells.empty())
    {
      made.Cells.push_back(this->Bricks[brick].Cells[i]);
    }
    for (const auto place : mesh.GetTet(tet))
    {
      if (this->Found[place] == 0)
      {
        this->Found[place] = 1;
        places.push_back(place);
      }
    }
  }
  std::sort(places.begin(), places.end(),
    [&](std::uint32_t a, std::uint32_t b) { return this->Numbers[a] < this->Numbers[b]; });
  for (const auto place : places)
  {
    this->Found[place] = static_cast<std::uint32_t>(made.Points.size());
    made.Points.push_back(this->Numbers[place]);
    made.Hints.push_back(this->Hints[place]);
    const auto* const data = fields.GetData(place);
    made.Samples.insert(made.Samples.end(), data, data + 1 + this->Settings.Fields);
    ++this->CountsLeft[place];
  }
  for (Tet& tet : made.Tets)
  {
    std::transform(
      tet.begin(), tet.end(), tet.begin(), [&](std::uint32_t place) { return this->Found[place]; });
  }
  for (const auto place : places)
  {
    this->Found[place] = 0;
  }
  return made;
}

//------------------------------------------------------------------------------
void Group::CountChanges()
{
  for (std::size_t place = 0; place < this->Counts.size(); ++place)
  {
    const bool isGone = this->IsKept[place] == 0 && this->CountsLeft[place] == 0;
    if (!isGone && this->CountsLeft[place] != this->Counts[place])
    {
      this->Merged.Changes.emplace_back(
        this->Numbers[place], this->CountsLeft[place] - this->Counts[place]);
    }
  }
}

//------------------------------------------------------------------------------
template <std::size_t NumberOfFields>
MergedGroup Group::Run(std::span<const BaredFace> bared, std::optional<unsigned> limit,
  const std::function<bool(double)>& progress)
{
  using Costs = MergeCosts<NumberOfFields>;
  using Rounds = MergeRounds<MergeMesh, Costs>;
  MergeMesh mesh(this->Numbers.size(), this->Tets);
  this->Tets = {};
  this->TakeBared(mesh, bared);
  this->LargestKey = static_cast<MergeQueue::Key>(limit.value_or(0));
  const MergeFields fields(this->Settings.Fields, std::move(this->Samples), this->Settings.PerWhole,
    this->Settings.PerTet);
  std::vector<std::unique_ptr<Costs>> workers;
  if (limit)
  {
    // The groups of a pass are merged at the same time, each by one thread.
    workers.push_back(std::make_unique<Costs>(mesh, fields, this->Settings.Merges));
  }
  else
  {
    workers = MakeMergeWorkers<Costs>(mesh, fields, this->Settings.Merges);
  }
  Rounds rounds(mesh, workers, this->IsKept, progress);
  rounds.SetListener([&](const Merge& merge, MergeQueue::Key key, double change)
    { this->Note(mesh, merge, key, change); });
  for (std::uint32_t place = 0; place < this->Hints.size(); ++place)
  {
    const MergeHint& hint = this->Hints[place];
    if (hint.Into == MergeChoice::None)
    {
      continue;
    }
    rounds.SetHint(place, { this->FindPlace(hint.Into), hint.Key });
  }
  if (!limit)
  {
    rounds.Run();
    return std::move(this->Merged);
  }
  rounds.RunBelow(*limit);
  for (std::uint32_t place = 0; place < this->Hints.size(); ++place)
  {
    if (this->IsKept[place] == 0)
    {
      const MergeHint hint = rounds.GetHint(place);
      const bool any = hint.Into != MergeChoice::None;
      this->Hints[place] = { any ? this->Numbers[hint.Into] : MergeChoice::None, hint.Key };
      if (any)
      {
        this->Merged.Keys.push_back(hint.Key);
      }
    }
  }
  this->Found.assign(this->Numbers.size(), 0);
  this->CountsLeft.assign(this->Numbers.size(), 0);
  for (std::size_t b = 0; b < this->Bricks.size(); ++b)
  {
    this->Merged.Bricks.push_back(this->Rebuild(b, mesh, fields));
    this->Bricks[b] = {};
  }
  this->CountChanges();
  return std::move(this->Merged);
}
}

//------------------------------------------------------------------------------
MergedGroup MergeBricks(std::vector<MergeBrick> bricks, const BrickGroupSettings& settings,
  std::span<const std::uint8_t> bricksOfPoint, std::span<const BaredFace> bared,
  std::optional<unsigned> limit, const std::function<bool(double)>& progress)
{
  Group group(std::move(bricks), settings, bricksOfPoint);
  // One field, which is frequent, is faster if its loops are known when they are compiled.
  return settings.Fields == 1 ? group.Run<1>(bared, limit, progress)
                              : group.Run<0>(bared, limit, progress);
}
}
