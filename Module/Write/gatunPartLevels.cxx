// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartLevels.h"

#include "gatunBaseMesh.h"

#include <algorithm>
#include <span>
#include <utility>

namespace gatun
{
namespace
{
/** A level that leaves more than this part of the tetrahedra is no base mesh. */
constexpr double LargestStep = 0.75;
constexpr double LargestFirst = 0.15; // of the points of the mesh, with an eighth in mind

/** A part of a base mesh as a writer takes it. */
class LevelPart
{
public:
  /** unused: further points. */
  LevelPart(MergedPart part, std::span<const std::uint32_t> unused, const PartValues& values,
    const WriterState& whole)
    : Part(std::move(part))
  {
    auto& points = this->Part.Points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->Ids.push_back(this->Part.IsShared[i] != 0 ? std::int64_t{ points[i] } : -1);
    }
    points.insert(points.end(), unused.begin(), unused.end());
    this->Ids.resize(points.size(), -1);
    this->Coordinates = values.GetCoordinates(points);
    for (const auto& tet : this->Part.Tets)
    {
      this->Connectivity.insert(this->Connectivity.end(), tet.begin(), tet.end());
    }
    this->Part.Tets = {};
    this->Type = whole.Meta.CoordinateType;
  }

  MeshInput GetInput() const
  {
    MeshInput input;
    input.Points = this->Part.Points.size();
    input.CoordinateType = this->Type;
    input.Coordinates = this->Coordinates.data();
    input.Cells = this->Connectivity.size() / 4;
    input.Connectivity = this->Connectivity.data();
    input.WideIds = true;
    return input;
  }

  const std::vector<std::uint32_t>& GetPoints() const { return this->Part.Points; }
  const std::int64_t* GetIds() const { return this->Ids.data(); }

  std::vector<Bytes> GetValues(const PartValues& values, std::size_t step) const
  {
    return values.GetValues(step, this->Part.Points, this->Part.Cells);
  }

private:
  MergedPart Part;
  ScalarType Type;
  Bytes Coordinates;
  std::vector<std::int64_t> Connectivity;
  std::vector<std::int64_t> Ids;
};
}

//------------------------------------------------------------------------------
PartLevels::PartLevels(
  WriterState& whole, const PartValues& values, const PartMerges& merges, MakeFile make)
  : Whole(whole)
  , Values(values)
  , Merges(merges)
  , Make(std::move(make))
{
}

//------------------------------------------------------------------------------
/** Cells of the mesh that was written last. */
std::uint64_t PartLevels::CountCells() const
{
  return this->Levels.empty() ? this->Whole.Meta.Tets
                              : this->Levels.back().File->GetState().NumberOfCells;
}

//------------------------------------------------------------------------------
bool PartLevels::IsComplete() const
{
  return this->Levels.size() >= this->Whole.Options.Levels || this->CountCells() <= SmallLevel;
}

//------------------------------------------------------------------------------
void PartLevels::Add(std::uint32_t merges, const Progress& progress)
{
  const auto points = static_cast<double>(this->Whole.Meta.Points);
  const bool isFewer = this->Levels.empty() ? points - merges <= LargestFirst * points
                                            : static_cast<double>(this->Merges.CountTets()) <=
      LargestStep * static_cast<double>(this->CountCells());
  if (!this->IsComplete() && isFewer)
  {
    this->Write(
      merges, this->Merges.GetNumberOfParts(),
      [this](std::size_t part) { return this->Merges.ReadPart(part); },
      [this](std::uint32_t point) { return !this->Merges.IsMerged(point); }, progress);
  }
}

//------------------------------------------------------------------------------
void PartLevels::AddRest(const MergeTree& tree, const Progress& progress)
{
  std::uint64_t points =
    this->Levels.empty() ? (this->Whole.Meta.Points + 3) / 4 : this->Levels.back().Points.size();
  while (!this->IsComplete())
  {
    points = (points + 1) / 2;
    const auto merges = std::max(static_cast<std::uint32_t>(tree.CountMergesForPoints(points)),
      this->Merges.GetMergesOfLevels());
    if (merges == 0 || (!this->Levels.empty() && merges <= this->Levels.back().Merges))
    {
      return;
    }
    const auto ancestors = tree.FindAncestors(merges);
    this->Write(
      merges, 1, [&](std::size_t) { return this->Merges.ReadRest(ancestors); },
      [&](std::uint32_t point) { return ancestors[point] == point; }, progress);
  }
}

//------------------------------------------------------------------------------
/** Writes a base mesh that comes in parts. isLeft: whether it has a point, which need not be that
 * of a tetrahedron. */
void PartLevels::Write(std::uint32_t merges, std::size_t parts,
  const std::function<MergedPart(std::size_t)>& read,
  const std::function<bool(std::uint32_t)>& isLeft, const Progress& progress)
{
  WriterOptions options = MakeLevelOptions(this->Whole.Options);
  options.Parts = static_cast<std::uint32_t>(parts);
  Level level;
  level.Merges = merges;
  level.File = this->Make(options);
  PartLevelFile& file = *level.File;
  const auto& steps = this->Values.GetSteps();
  const auto check = [&](double) { return !progress || progress(1); };
  std::vector<bool> isUsed(static_cast<std::size_t>(this->Whole.Meta.Points), false);
  std::vector<std::uint32_t> unused;
  const auto make = [&](std::size_t p, MergedPart part)
  {
    const bool isLast = p + 1 == parts;
    return LevelPart(std::move(part),
      isLast ? std::span<const std::uint32_t>(unused) : std::span<const std::uint32_t>(),
      this->Values, this->Whole);
  };
  for (std::size_t p = 0; p < parts; ++p)
  {
    MergedPart merged = read(p);
    for (const auto point : merged.Points)
    {
      isUsed[point] = true;
    }
    for (std::uint32_t point = 0; p + 1 == parts && point < isUsed.size(); ++point)
    {
      if (!isUsed[point] && isLeft(point))
      {
        unused.push_back(point);
      }
    }
    const LevelPart part = make(p, std::move(merged));
    file.Survey(part.GetInput(), part.GetIds(), check);
    for (std::size_t step = 0; step < steps.size(); ++step)
    {
      const auto values = part.GetValues(this->Values, step);
      file.SurveyStep(ListPointers(values));
    }
  }
  for (std::size_t p = 0; p < parts; ++p)
  {
    const LevelPart part = make(p, read(p));
    file.Write(part.GetInput(), part.GetIds(), check);
    level.Points.resize(static_cast<std::size_t>(file.GetState().Meta.Points));
    for (std::size_t i = 0; i < part.GetPoints().size(); ++i)
    {
      level.Points[file.GetNumbers()[i]] = part.GetPoints()[i];
    }
    for (std::size_t step = 0; step < steps.size(); ++step)
    {
      const auto values = part.GetValues(this->Values, step);
      file.WriteStep(ListPointers(values), {}, steps[step].HasTime, steps[step].Time, check);
    }
  }
  file.EndParts();
  file.GetState().Meta.WideIds = this->Whole.Meta.WideIds;
  this->Levels.push_back(std::move(level));
}

//------------------------------------------------------------------------------
void PartLevels::List(std::vector<MeshOfTree>& meshes) const
{
  for (const Level& level : this->Levels)
  {
    meshes.push_back({ level.Merges, level.Points, [&level](MergeTree tree) -> TreeSection& {
                        return level.File->BeginTree(std::move(tree));
                      } });
  }
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> PartLevels::Embed()
{
  std::vector<std::uint32_t> merges;
  for (const Level& level : this->Levels) // the coarsest one is next to the tables
  {
    level.File->Complete({});
    this->Whole.Statistics.LevelBytes +=
      this->Whole.File.AddSection(SectionLevel, level.File->GetState().File);
    merges.push_back(level.Merges);
  }
  return merges;
}
}
