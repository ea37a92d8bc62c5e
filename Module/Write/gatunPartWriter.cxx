// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartWriter.h"

#include "gatunError.h"
#include "gatunFileWriterInternals.h"
#include "gatunKeepMemory.h"
#include "gatunPartAssembly.h"
#include "gatunPartWriterInternals.h"
#include "gatunPaths.h"
#include "gatunWriterCheck.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace gatun
{
namespace
{
/** The folder of temporary files: that of the file. */
std::string GetSpillFolder(const std::string& path)
{
  const auto parent = ToText(ToPath(path).parent_path());
  return parent.empty() ? "." : parent;
}

void CheckWeights(const std::vector<double>& weights, const std::vector<ArrayDescription>& arrays)
{
  if (weights.size() != arrays.size())
  {
    ThrowInvalid("there must be a weight for each array");
  }
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    if (!(weights[a] >= 0) || !std::isfinite(weights[a]))
    {
      ThrowInvalid("the weight of array '" + arrays[a].Name + "' must be 0 or more");
    }
    if (weights[a] > 0 && arrays[a].Where != Association::Point)
    {
      ThrowInvalid("array '" + arrays[a].Name +
        "', which has a weight in the hierarchy, is not one of points");
    }
  }
}

void CheckOptions(
  const PartWriterOptions& all, const std::vector<ArrayDescription>& arrays, bool isAlone)
{
  const WriterOptions& options = all.File;
  if (options.Tree || !options.LevelMerges.empty())
  {
    ThrowInvalid("the merges of a mesh in parts cannot be given, but are found from weights");
  }
  if (options.Levels > 0 && !all.Weights)
  {
    ThrowInvalid("base meshes need a hierarchy");
  }
  if (options.Layers)
  {
    ThrowInvalid("layers need the whole mesh, which cannot come in parts");
  }
  if (all.Weights && !isAlone)
  {
    ThrowInvalid("a hierarchy cannot be written by several processes");
  }
  if (options.Boundary && !isAlone)
  {
    ThrowInvalid("a boundary cannot be written by several processes");
  }
  if (all.Weights && options.IsSurface)
  {
    ThrowInvalid("the hierarchy of a surface needs the whole surface, which cannot come in parts");
  }
  if (all.Weights)
  {
    CheckWeights(*all.Weights, arrays);
  }
}
}

//------------------------------------------------------------------------------
PartWriter::Internals::Internals(const std::string& path,
  const std::vector<ArrayDescription>& arrays, const PartWriterOptions& options)
  : Options(options)
  , Folder(GetSpillFolder(path))
  , State(path, arrays, options.File)
  , Boundaries(this->Folder, options.SpillMemory)
  , Domains(this->State)
{
}

//------------------------------------------------------------------------------
PartWriter::Internals::Internals(const std::string& path,
  const std::vector<ArrayDescription>& arrays, const PartWriterOptions& options,
  PartExchange& exchange)
  : Options(options)
  , Folder(GetSpillFolder(path))
  , State(arrays, options.File, this->Folder)
  , Boundaries(this->Folder, options.SpillMemory)
  , Domains(this->State)
  , Exchange(&exchange)
{
  if (exchange.GetProcess() == 0)
  {
    this->Common.emplace(OutputFile::Common(), path);
  }
  this->Agreement.emplace(exchange, this->State, this->Folder, options.SpillMemory);
  this->Steps.KeepTables();
}

//------------------------------------------------------------------------------
PartWriter::Internals::Internals(
  const WriterState& whole, const PartWriterOptions& options, const PartValues& values)
  : Options(options)
  , Folder(values.GetFolder())
  , Rounded(&values.GetSteps())
  , State(whole, whole.Meta.Arrays, options.File)
  , Boundaries(this->Folder, options.SpillMemory)
  , Domains(this->State, this->Rounded)
{
}

//------------------------------------------------------------------------------
void PartWriter::Internals::CheckInput(const MeshInput& mesh) const
{
  WriterOptions options = this->Options.File;
  options.Levels = 0; // their tree comes later
  CheckWriterInput(mesh, this->State.Meta.Arrays, options);
}

//------------------------------------------------------------------------------
void PartWriter::Internals::Survey(
  const MeshInput& mesh, const std::int64_t* globalIds, const Progress& progress)
{
  if (this->IsJoined)
  {
    ThrowInvalid("all parts have to be surveyed before the first one is written");
  }
  if (this->Options.File.PointsMove)
  {
    ThrowInvalid("points that move cannot be written in parts");
  }
  this->EndPartSurvey();
  this->CheckInput(mesh);
  if (mesh.Points > 0)
  {
    const bool hasIds = globalIds != nullptr;
    if (this->HasIds.value_or(hasIds) != hasIds)
    {
      ThrowInvalid("some parts have global ids of points, and some do not");
    }
    this->HasIds = hasIds;
  }
  WriterPart part(mesh);
  part.Place.FirstChunk = this->State.Table.Chunks.size();
  this->State.Describe(part.Mesh);
  this->Mesh.MakeLayout(part, progress);
  this->Mesh.AddChunks(part);
  this->Mesh.AddGroups(part);
  this->State.Meta.UnusedPoints += part.Layout.UnusedPoints.size();
  this->Domains.AddMesh(mesh);
  if (this->Agreement)
  {
    this->Agreement->AddUnused(part);
  }
  using Candidates = PartSurvey::Candidates;
  this->Current.emplace(part, static_cast<std::uint32_t>(this->Parts.size()), globalIds,
    this->Options.JoinByIdsOnly ? Candidates::WithIds : Candidates::Boundary);
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
  this->Domains.AddStep(part.StepHashes.size(), values, part.Points, part.Cells);
  this->Current->AddValues(arrays, values);
  if (this->Agreement)
  {
    this->Agreement->AddUnusedValues(values);
  }
  part.StepHashes.push_back(HashValues(arrays, values, part.Points, part.Cells));
}

//------------------------------------------------------------------------------
void PartWriter::Internals::EndPartSurvey()
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
    if (this->Agreement)
    {
      this->Agreement->Add(use);
    }
    else
    {
      this->Boundaries.Add(use);
    }
  }
  this->Current.reset();
}

//------------------------------------------------------------------------------
void PartWriter::Internals::EndSurvey()
{
  if (this->IsJoined)
  {
    ThrowInvalid("the survey has been ended before");
  }
  if (this->Exchange)
  {
    this->JoinTogether();
  }
  else
  {
    this->JoinAlone();
  }
}

//------------------------------------------------------------------------------
/** Joins the parts when all have been surveyed, and makes the tables. */
void PartWriter::Internals::JoinAlone()
{
  this->EndPartSurvey();
  this->IsJoined = true;
  this->Boundaries.Join(this->Parts.size(), this->State.Groups);
  this->PlaceParts();
  const WriterOptions& options = this->Options.File;
  if (this->Options.Weights || this->Rounded || options.Boundary)
  {
    const bool keepsCells =
      (options.Levels > 0 || options.Boundary) && HasCellArrays(this->State.Meta);
    this->Values.emplace(this->State, this->GetNumberOfSteps(), keepsCells, this->Folder);
  }
  if (options.Boundary)
  {
    this->Surface.emplace(this->Folder, this->Options.SpillMemory);
  }
  if (this->Options.Weights)
  {
    PartMergeSettings settings;
    settings.TetsOfGroup = this->Options.TetsOfGroup;
    settings.Folder = this->Folder;
    this->Tree.emplace(this->State, *this->Values, *this->Options.Weights,
      this->GetNumberOfSteps() > 0, settings,
      [this](const WriterOptions& ofLevel)
      {
        PartWriterOptions own;
        own.File = ofLevel;
        own.SpillMemory = this->Options.SpillMemory;
        own.JoinByIdsOnly = true;
        return std::make_unique<Internals>(this->State, own, *this->Values);
      });
  }
}

//------------------------------------------------------------------------------
/** The same with the parts of all processes. */
void PartWriter::Internals::JoinTogether()
{
  auto& exchange = *this->Exchange;
  auto& agreement = *this->Agreement;
  exchange.Together([&] { this->EndPartSurvey(); });
  this->IsJoined = true;
  agreement.AgreeOnParts(this->Parts, this->HasIds);
  agreement.JoinPoints(this->Boundaries, this->Parts.size());
  agreement.AgreeOnDomains(this->Domains);
  exchange.Together([&] { this->PlaceParts(); });
  agreement.SetPlaces(this->Places);
  this->SendPoints();
}

//------------------------------------------------------------------------------
/** Tells other processes of the points that they write or number, too. */
void PartWriter::Internals::SendPoints()
{
  auto& agreement = *this->Agreement;
  this->Exchange->Together(
    [&]
    {
      const auto& own = agreement.GetOwn();
      for (auto p = own.FirstPart; p < own.FirstPart + own.Parts; ++p)
      {
        this->Joins.push_back(this->Boundaries.Take(static_cast<std::uint32_t>(p)));
        auto numbers = this->HasNumbers()
          ? this->Numbers.Find(this->Places[p], this->Parts[p].Points, this->Joins.back())
          : std::vector<std::uint64_t>();
        agreement.KeepUnusedNumbers(p - own.FirstPart, this->Places[p].FirstPoint, numbers);
      }
    });
  if (this->HasNumbers())
  {
    agreement.SendNumbers(this->Boundaries, this->Numbers.GetJoined());
  }
  agreement.SendUnused(this->Joins);
}

//------------------------------------------------------------------------------
/** Makes the tables when the points of all parts have been joined. */
void PartWriter::Internals::PlaceParts()
{
  auto& meta = this->State.Meta;
  meta.UnusedPoints -= this->Boundaries.GetCounts().Dropped;
  for (std::size_t p = 0; p < this->Parts.size(); ++p)
  {
    meta.Points -= this->Boundaries.GetCounts().Repeated[p];
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
    place.IsFirstHere = p == this->GetNumber(0);
    this->Places.push_back(place);
    place.FirstChunk = end;
    place.FirstBlock += place.Blocks;
    place.FirstPoint += part.Points - this->Boundaries.GetCounts().Repeated[p];
    place.FirstCell += part.Cells;
  }
  this->Mesh.SetDomains(this->Domains.FinishMesh());
  StepScales before;
  for (std::size_t step = 0; step < this->Domains.GetSteps(); ++step)
  {
    auto domains = this->Domains.FinishStep(step, this->Steps.IsKey(step) ? nullptr : &before);
    before = GetScales(domains);
    this->Steps.SetDomains(step, std::move(domains));
  }
  this->Domains.Clear();
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
  if (!this->IsJoined && this->Exchange)
  {
    ThrowInvalid("the survey has to be ended before the first part is written");
  }
  if (!this->IsJoined)
  {
    this->JoinAlone();
  }
  this->EndPart();
  const auto number = this->GetNumber(this->Written);
  if (this->Written >= this->GetNumberOfOwnParts())
  {
    ThrowInvalid("more parts are to be written than were surveyed");
  }
  this->CheckInput(mesh);
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
  this->IsJoinedPoint =
    this->ApplyJoins(this->Agreement ? std::move(this->Joins[this->Written - 1])
                                     : this->Boundaries.Take(static_cast<std::uint32_t>(number)));
  // With a single step, its values are encoded together with the mesh, chunk by chunk.
  // A hierarchy needs the numbers of the points before that.
  this->IsDeferred = surveyed.StepHashes.size() == 1 && !this->Values;
  if (!this->IsDeferred)
  {
    this->Mesh.Write(*this->Part, progress);
  }
  if (this->Values)
  {
    this->Values->AddPart(*this->Part);
  }
  if (this->Surface)
  {
    this->Surface->Add(*this->Part, this->Values->GetNumbers(), this->IsJoinedPoint);
  }
  if (this->Tree && surveyed.StepHashes.empty())
  {
    this->Tree->AddPart(*this->Part, this->IsJoinedPoint, {});
  }
}

//------------------------------------------------------------------------------
/** Takes the points that other parts have, too, from the layout of the part, and places all shared
 * points. Returns the marks of these points. */
std::vector<std::uint8_t> PartWriter::Internals::ApplyJoins(const PartJoins& joins)
{
  auto& layout = this->Part->Layout;
  if (this->HasNumbers())
  {
    this->Part->PointNumbers =
      this->Numbers.Find(this->Part->Place, this->Part->Mesh.GetMesh().Points, joins);
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
  std::map<ChunkGroup, std::vector<std::uint32_t>> groups;
  for (auto& [users, points] : layout.SharedPoints)
  {
    remove(points);
    if (!points.empty())
    {
      ChunkGroup chunks = users;
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
    groups[this->Boundaries.GetGroup(group)] = points;
  }
  this->Part->PlaceShared(this->State.Table, groups);
  return isJoined;
}

//------------------------------------------------------------------------------
void PartWriter::Internals::WriteStep(std::span<const void* const> values, const FieldData& field,
  bool hasTime, double time, const Progress& progress)
{
  if (!this->Part)
  {
    ThrowInvalid("no part is being written, or all of its surveyed time steps have been written");
  }
  const auto number = this->GetNumber(this->Written - 1);
  const auto& surveyed = this->Parts[number];
  const auto step = this->Steps.GetCount();
  if (step >= surveyed.StepHashes.size())
  {
    ThrowInvalid("more time steps are to be written than were surveyed");
  }
  if (values.size() != this->State.Meta.Arrays.size() ||
    HashValues(this->State.Meta.Arrays, values, surveyed.Points, surveyed.Cells) !=
      surveyed.StepHashes[step])
  {
    ThrowInvalid(
      "the values of part " + std::to_string(number) + " have changed since it was surveyed");
  }
  const StepValues all{ values, &field, hasTime, time,
    this->Rounded ? &(*this->Rounded)[step].Domains : nullptr };
  if (this->IsDeferred)
  {
    this->IsDeferred = false;
    this->Steps.WriteWithMesh(this->Mesh, *this->Part, all, progress);
  }
  else
  {
    const StepInput& input = this->Steps.WriteValues(*this->Part, all, progress);
    if (this->Tree && step == 0)
    {
      this->Tree->AddPart(*this->Part, this->IsJoinedPoint, input.Arrays);
    }
    if (this->Values)
    {
      this->Values->AddStep(step, input, all);
    }
  }
  this->Steps.Finish(*this->Part, all);
  if (step + 1 == surveyed.StepHashes.size())
  {
    this->EndPart(); // before the caller gets the next part
  }
}

//------------------------------------------------------------------------------
void PartWriter::Internals::EndParts()
{
  if (this->Parts.empty() || this->Written < this->GetNumberOfOwnParts() ||
    (this->Exchange && !this->IsJoined))
  {
    ThrowInvalid("not all parts have been written");
  }
  this->EndPart();
}

//------------------------------------------------------------------------------
TreeSection& PartWriter::Internals::BeginTree(MergeTree tree)
{
  this->Merges.emplace(this->State, std::move(tree),
    [this](unsigned axis) { return this->Values->ReadCoordinates(axis); });
  const auto steps = this->GetNumberOfSteps();
  for (std::size_t step = 0; step < steps; ++step)
  {
    this->Merges->AddStep([&](std::size_t array, std::size_t range)
      { return this->Values->ReadRange(step, array, range); },
      steps - 1 - step);
  }
  return *this->Merges;
}

//------------------------------------------------------------------------------
void PartWriter::Internals::WriteHierarchy(const Progress& progress)
{
  const auto stay = [&](double) { return !progress || progress(1); };
  MergeTree tree = this->Tree->Build(progress);
  std::vector<std::uint32_t> all(tree.GetNumberOfPoints());
  std::iota(all.begin(), all.end(), 0u);
  std::vector<MeshOfTree> meshes{ { 0, all,
    [this](MergeTree own) -> TreeSection& { return this->BeginTree(std::move(own)); } } };
  this->Tree->GetLevels().List(meshes);
  TreeParts parts(std::move(tree), std::move(meshes));
  if (this->Options.File.Dependencies && !parts.GetTree().GetMerges().empty())
  {
    parts.WriteDependencies(this->Tree->FindDependencies(parts.GetTree()), stay);
  }
}

//------------------------------------------------------------------------------
/** Writes the boundary, which is in memory, as a file in the file. */
void PartWriter::Internals::WriteBoundary(const Progress& progress)
{
  const auto stay = [&](double) { return !progress || progress(1); };
  const BoundaryMesh mesh = this->Surface->Finish(this->State, *this->Values);
  const auto tree =
    this->Merges ? mesh.MakeTree(this->Merges->GetTree()) : std::optional<MergeTree>();
  FileWriter::Internals file(
    this->State, mesh.GetInput(), MakeBoundaryOptions(this->Options.File, tree ? &*tree : nullptr));
  file.Begin(stay);
  const auto& steps = this->Values->GetSteps();
  for (std::size_t step = 0; step < steps.size(); ++step)
  {
    const auto values = this->Values->GetValues(step, mesh.GetPoints(), mesh.GetCells());
    file.WriteStep(
      ListPointers(values), {}, steps[step].HasTime, steps[step].Time, stay, &steps[step].Domains);
  }
  file.Complete();
  this->State.Statistics.BoundaryBytes =
    this->State.File.AddSection(SectionBoundary, file.GetFile());
}

//------------------------------------------------------------------------------
void PartWriter::Internals::Complete(std::vector<std::uint32_t> levels)
{
  this->State.WriteTables(this->State.File);
  if (this->Merges)
  {
    this->Merges->WriteTable(std::move(levels));
  }
  this->State.File.AddSection(SectionMeta, this->State.Meta.Write());
}

//------------------------------------------------------------------------------
PartStatistics PartWriter::Internals::Finish(const Progress& progress)
{
  if (this->Exchange)
  {
    this->Exchange->Together([this] { this->EndParts(); });
    return this->CountAll(PartAssembly(*this->Exchange, *this->Agreement, this->State, this->Steps,
      this->Common ? &*this->Common : nullptr)
                            .Finish());
  }
  this->EndParts();
  if (this->Tree)
  {
    this->WriteHierarchy(progress);
  }
  if (this->Surface)
  {
    this->WriteBoundary(progress);
  }
  std::vector<std::uint32_t> levels;
  if (this->Tree)
  {
    levels = this->Tree->GetLevels().Embed();
  }
  this->Complete(std::move(levels));
  return this->CountAll(this->State.Commit(this->State.File));
}

//------------------------------------------------------------------------------
PartStatistics PartWriter::Internals::CountAll(const FileStatistics& file) const
{
  PartStatistics statistics;
  statistics.File = file;
  statistics.Points = this->State.Meta.Points;
  statistics.Cells = this->State.NumberOfCells;
  const auto& counts = this->Boundaries.GetCounts();
  for (const auto repeated : counts.Repeated)
  {
    statistics.JoinedPoints += repeated;
  }
  statistics.DifferentPoints = counts.Different;
  statistics.AmbiguousPoints = counts.Ambiguous;
  statistics.SpilledBytes = this->Boundaries.GetSpilledBytes();
  return statistics;
}

//------------------------------------------------------------------------------
PartWriter::PartWriter(const std::string& path, const std::vector<ArrayDescription>& arrays,
  const PartWriterOptions& options, PartExchange* exchange)
{
  const bool isAlone = !exchange || exchange->GetProcesses() == 1;
  CheckOptions(options, arrays, isAlone);
  KeepFreedMemory();
  this->Self = !isAlone ? std::make_unique<Internals>(path, arrays, options, *exchange)
                        : std::make_unique<Internals>(path, arrays, options);
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
void PartWriter::EndSurvey()
{
  this->Self->EndSurvey();
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
PartStatistics PartWriter::Finish(const Progress& progress)
{
  return this->Self->Finish(progress);
}
}
