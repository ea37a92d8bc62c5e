// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartWriter.h"

#include "gatunError.h"
#include "gatunKeepMemory.h"
#include "gatunMeshSection.h"
#include "gatunPartSurvey.h"
#include "gatunSkinMerge.h"
#include "gatunStepSection.h"
#include "gatunWriterCheck.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace gatun
{
namespace
{
std::string GetSpillFolder(const std::string& path, const std::string& folder)
{
  const auto parent = std::filesystem::path(path).parent_path().string();
  return !folder.empty() ? folder : !parent.empty() ? parent : ".";
}

void CheckOptions(const WriterOptions& options)
{
  if (options.Tree || options.Levels > 0)
  {
    ThrowInvalid("a hierarchy needs the whole mesh, which cannot come in parts");
  }
  if (options.Layers)
  {
    ThrowInvalid("layers need the whole mesh, which cannot come in parts");
  }
}
}

//------------------------------------------------------------------------------
class PartWriter::Internals
{
public:
  Internals(const std::string& path, const std::vector<ArrayDescription>& arrays,
    const PartWriterOptions& options)
    : Options(options)
    , State(path, arrays, options.File)
    , Skins(GetSpillFolder(path, options.SpillFolder), options.SpillMemory)
  {
  }

  void Survey(const MeshInput& mesh, const std::int64_t* globalIds, const Progress& progress);
  void SurveyStep(std::span<const void* const> values);
  void Write(const MeshInput& mesh, const std::int64_t* globalIds, const Progress& progress);
  void WriteStep(std::span<const void* const> values, const FieldData& field, bool hasTime,
    double time, const Progress& progress);
  PartStatistics Finish();

private:
  /** What is known of a part after the survey. */
  struct Surveyed
  {
    std::size_t Chunks = 0;
    std::uint64_t Points = 0;
    std::uint64_t Cells = 0;
    std::uint64_t Hash = 0;                // of the mesh
    std::vector<std::uint64_t> StepHashes; // of the values
  };

  void EndSurvey();
  void Join();
  void EndPart();
  void ApplyJoins(const PartJoins& joins);
  void NumberPoints(const PartJoins& joins);

  const PartWriterOptions Options;
  WriterState State;
  MeshSection Mesh{ State };
  StepSection Steps{ State };
  SkinMerge Skins;
  std::vector<Surveyed> Parts;
  std::optional<PartSurvey> Current; // the part that is being surveyed
  PaletteSurvey Palettes{ State };
  bool HasIds = false;
  bool IsJoined = false;

  // While parts are written.
  std::vector<PartPlace> Places;
  std::size_t Written = 0; // parts that were begun
  std::optional<WriterPart> Part;
  std::vector<std::vector<std::uint64_t>> JoinedNumbers; // original numbers of each group
};

//------------------------------------------------------------------------------
void PartWriter::Internals::Survey(
  const MeshInput& mesh, const std::int64_t* globalIds, const Progress& progress)
{
  if (this->IsJoined)
  {
    ThrowInvalid("all parts have to be surveyed before the first one is written");
  }
  this->EndSurvey();
  CheckWriterInput(mesh, this->State.Meta.Arrays, this->Options.File);
  if (mesh.Points > 0)
  {
    const bool isFirst = std::all_of(this->Parts.begin(), this->Parts.end(),
      [](const Surveyed& part) { return part.Points == 0; });
    if (!isFirst && this->HasIds != (globalIds != nullptr))
    {
      ThrowInvalid("some parts have global ids of points, and some do not");
    }
    this->HasIds = globalIds != nullptr;
  }
  WriterPart part(mesh);
  part.Place.FirstChunk = this->State.Table.Chunks.size();
  this->State.Describe(part.Mesh);
  this->Mesh.MakeLayout(part, progress);
  this->Mesh.AddChunks(part);
  this->Mesh.AddGroups(part);
  this->State.Meta.UnusedPoints += part.Layout.UnusedPoints.size();
  this->Palettes.AddMesh(mesh);
  this->Current.emplace(
    part, static_cast<std::uint32_t>(this->Parts.size()), globalIds, this->Options.JoinAllPoints);
  this->Parts.push_back(
    { part.Layout.GetChunkCount(), mesh.Points, mesh.Cells, HashPart(mesh, globalIds), {} });
}

//------------------------------------------------------------------------------
void PartWriter::Internals::SurveyStep(std::span<const void* const> values)
{
  if (!this->Current)
  {
    ThrowInvalid("there is no part to survey");
  }
  const auto& arrays = this->State.Meta.Arrays;
  if (values.size() != arrays.size())
  {
    ThrowInvalid("a step needs the values of every array");
  }
  auto& part = this->Parts.back();
  this->Palettes.AddStep(part.StepHashes.size(), values, part.Points, part.Cells);
  this->Current->AddValues(arrays, values);
  part.StepHashes.push_back(HashValues(arrays, values, part.Points, part.Cells));
}

//------------------------------------------------------------------------------
void PartWriter::Internals::EndSurvey()
{
  if (!this->Current)
  {
    return;
  }
  if (this->Parts.back().StepHashes.size() != this->Parts.front().StepHashes.size())
  {
    ThrowInvalid("parts have different numbers of time steps");
  }
  for (const auto& use : this->Current->GetUses())
  {
    this->Skins.Add(use);
  }
  this->Current.reset();
}

//------------------------------------------------------------------------------
/** Joins the parts when all have been surveyed, and makes the tables. */
void PartWriter::Internals::Join()
{
  this->EndSurvey();
  this->IsJoined = true;
  this->Skins.Join(this->Parts.size(), this->State.Groups);
  auto& meta = this->State.Meta;
  meta.UnusedPoints -= this->Skins.GetDropped();
  for (std::size_t p = 0; p < this->Parts.size(); ++p)
  {
    meta.Points -= this->Skins.GetRepeated(p);
  }
  this->State.LinkGroups();
  PartPlace place;
  for (std::size_t p = 0; p < this->Parts.size(); ++p)
  {
    const auto& part = this->Parts[p];
    const auto end = place.FirstChunk + part.Chunks;
    const auto& blocks = this->State.Table.Blocks;
    place.Blocks = 0;
    while (place.FirstBlock + place.Blocks < blocks.size() &&
      blocks[place.FirstBlock + place.Blocks].Groups[0].Chunks[0] < end)
    {
      ++place.Blocks;
    }
    place.IsFirst = p == 0;
    place.IsLast = p + 1 == this->Parts.size();
    this->Places.push_back(place);
    place.FirstChunk = end;
    place.FirstBlock += place.Blocks;
    place.FirstPoint += part.Points - this->Skins.GetRepeated(p);
    place.FirstCell += part.Cells;
  }
  this->Mesh.SetPalettes(this->Palettes.FinishMesh());
  for (std::size_t step = 0; step < this->Palettes.GetSteps(); ++step)
  {
    this->Steps.SetPalettes(step, this->Palettes.FinishStep(step));
  }
}

//------------------------------------------------------------------------------
void PartWriter::Internals::EndPart()
{
  if (this->Part)
  {
    this->Steps.EndPart();
    this->Part.reset();
  }
}

//------------------------------------------------------------------------------
void PartWriter::Internals::Write(
  const MeshInput& mesh, const std::int64_t* globalIds, const Progress& progress)
{
  if (!this->IsJoined)
  {
    this->Join();
  }
  this->EndPart();
  const auto number = this->Written;
  if (number >= this->Parts.size())
  {
    ThrowInvalid("more parts are to be written than were surveyed");
  }
  CheckWriterInput(mesh, this->State.Meta.Arrays, this->Options.File);
  const auto& surveyed = this->Parts[number];
  if (mesh.Points != surveyed.Points || mesh.Cells != surveyed.Cells ||
    HashPart(mesh, globalIds) != surveyed.Hash)
  {
    ThrowInvalid("part " + std::to_string(number) + " has changed since it was surveyed");
  }
  ++this->Written;
  this->Part.emplace(mesh);
  this->Part->Place = this->Places[number];
  this->Mesh.MakeLayout(*this->Part, {});
  this->ApplyJoins(this->Skins.Take(static_cast<std::uint32_t>(number)));
  this->Mesh.Write(*this->Part, progress);
}

//------------------------------------------------------------------------------
/** Takes the points that other parts have, too, from the layout of the part, and places all shared
 * points. */
void PartWriter::Internals::ApplyJoins(const PartJoins& joins)
{
  auto& layout = this->Part->Layout;
  if (this->Parts.size() > 1 && (this->Options.File.Keep & KeepPoints))
  {
    this->NumberPoints(joins);
  }
  std::vector<std::uint8_t> isJoined(
    static_cast<std::size_t>(this->Part->Mesh.GetMesh().Points), 0);
  for (const auto point : joins.Dropped)
  {
    isJoined[point] = 1;
  }
  for (const auto& [group, points] : joins.Groups)
  {
    for (const auto point : points)
    {
      isJoined[point] = 1;
    }
  }
  const auto remove = [&](std::vector<std::uint32_t>& points)
  { std::erase_if(points, [&](std::uint32_t point) { return isJoined[point] != 0; }); };
  remove(layout.UnusedPoints);
  for (auto& points : layout.OwnPoints)
  {
    remove(points);
  }
  std::map<ChunkSet, std::vector<std::uint32_t>> groups;
  for (auto& [users, points] : layout.SharedPoints)
  {
    remove(points);
    if (!points.empty())
    {
      ChunkSet chunks = users;
      for (auto& chunk : chunks)
      {
        chunk += static_cast<std::uint32_t>(this->Part->Place.FirstChunk);
      }
      groups[chunks] = std::move(points);
    }
  }
  layout.SharedPoints = {};
  for (const auto& [group, points] : joins.Groups)
  {
    groups[this->Skins.GetGroup(group)] = points;
  }
  this->Part->PlaceShared(this->State.Table, groups);
}

//------------------------------------------------------------------------------
/** Gives the points of the part their original numbers in the file. */
void PartWriter::Internals::NumberPoints(const PartJoins& joins)
{
  constexpr std::uint64_t repeated = ~std::uint64_t{ 0 };
  auto& numbers = this->Part->PointNumbers;
  numbers.assign(static_cast<std::size_t>(this->Part->Mesh.GetMesh().Points), 0);
  for (const auto point : joins.Dropped)
  {
    numbers[point] = repeated;
  }
  const auto isFirst = [&](std::uint32_t group)
  { return this->Skins.GetGroup(group).front() >= this->Part->Place.FirstChunk; };
  for (const auto& [group, points] : joins.Groups)
  {
    for (const auto point : points)
    {
      numbers[point] = isFirst(group) ? 0 : repeated;
    }
  }
  auto next = this->Part->Place.FirstPoint;
  for (auto& number : numbers)
  {
    number = number == repeated ? repeated : next++;
  }
  for (const auto& [group, points] : joins.Groups)
  {
    this->JoinedNumbers.resize(std::max<std::size_t>(this->JoinedNumbers.size(), group + 1));
    auto& known = this->JoinedNumbers[group];
    known.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      (isFirst(group) ? known[i] : numbers[points[i]]) =
        isFirst(group) ? numbers[points[i]] : known[i];
    }
  }
}

//------------------------------------------------------------------------------
void PartWriter::Internals::WriteStep(std::span<const void* const> values, const FieldData& field,
  bool hasTime, double time, const Progress& progress)
{
  if (!this->Part)
  {
    ThrowInvalid("there is no part to write of which a further time step was surveyed");
  }
  const auto& surveyed = this->Parts[this->Written - 1];
  const auto step = this->Steps.GetCount();
  if (step >= surveyed.StepHashes.size())
  {
    ThrowInvalid("more time steps are to be written than were surveyed");
  }
  if (values.size() != this->State.Meta.Arrays.size() ||
    HashValues(this->State.Meta.Arrays, values, surveyed.Points, surveyed.Cells) !=
      surveyed.StepHashes[step])
  {
    ThrowInvalid("the values of part " + std::to_string(this->Written - 1) +
      " have changed since it was surveyed");
  }
  const StepValues all{ values, &field, hasTime, time };
  this->Steps.WriteValues(*this->Part, all, progress);
  this->Steps.Finish(*this->Part, all);
  if (step + 1 == surveyed.StepHashes.size())
  {
    this->EndPart(); // before the caller gets the next part
  }
}

//------------------------------------------------------------------------------
PartStatistics PartWriter::Internals::Finish()
{
  if (this->Parts.empty() || this->Written < this->Parts.size())
  {
    ThrowInvalid("not all parts have been written");
  }
  this->EndPart();
  this->State.WriteTables();
  this->State.File.AddSection(SectionMeta, this->State.Meta.Write());
  PartStatistics statistics;
  statistics.File = this->State.Commit();
  statistics.Points = this->State.Meta.Points;
  statistics.Cells = this->State.NumberOfCells;
  for (std::size_t p = 0; p < this->Parts.size(); ++p)
  {
    statistics.JoinedPoints += this->Skins.GetRepeated(p);
  }
  statistics.DifferentPoints = this->Skins.GetDifferent();
  statistics.AmbiguousPoints = this->Skins.GetAmbiguous();
  statistics.SpilledBytes = this->Skins.GetSpilledBytes();
  return statistics;
}

//------------------------------------------------------------------------------
PartWriter::PartWriter(const std::string& path, const std::vector<ArrayDescription>& arrays,
  const PartWriterOptions& options)
{
  CheckOptions(options.File);
  KeepFreedMemory();
  this->Self = std::make_unique<Internals>(path, arrays, options);
}

//------------------------------------------------------------------------------
PartWriter::~PartWriter() = default;

//------------------------------------------------------------------------------
void PartWriter::Survey(
  const MeshInput& part, const std::int64_t* globalIds, const Progress& progress)
{
  this->Self->Survey(part, globalIds, progress);
}

//------------------------------------------------------------------------------
void PartWriter::SurveyStep(std::span<const void* const> values)
{
  this->Self->SurveyStep(values);
}

//------------------------------------------------------------------------------
void PartWriter::Write(
  const MeshInput& part, const std::int64_t* globalIds, const Progress& progress)
{
  this->Self->Write(part, globalIds, progress);
}

//------------------------------------------------------------------------------
void PartWriter::WriteStep(std::span<const void* const> values, const FieldData& field,
  bool hasTime, double time, const Progress& progress)
{
  this->Self->WriteStep(values, field, hasTime, time, progress);
}

//------------------------------------------------------------------------------
PartStatistics PartWriter::Finish()
{
  return this->Self->Finish();
}
}
