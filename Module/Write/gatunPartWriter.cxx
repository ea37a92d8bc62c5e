// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartWriter.h"

#include "gatunBoundaryMerge.h"
#include "gatunError.h"
#include "gatunKeepMemory.h"
#include "gatunMeshSection.h"
#include "gatunPartAgreement.h"
#include "gatunPartAssembly.h"
#include "gatunPartSurvey.h"
#include "gatunPartTree.h"
#include "gatunPaths.h"
#include "gatunPointNumbers.h"
#include "gatunStepSection.h"
#include "gatunWriterCheck.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <algorithm>
#include <cmath>
#include <map>
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
  if (options.Tree || options.Levels > 0)
  {
    ThrowInvalid("base meshes need the whole mesh, which cannot come in parts");
  }
  if (options.Layers)
  {
    ThrowInvalid("layers need the whole mesh, which cannot come in parts");
  }
  if (all.Weights && !isAlone)
  {
    ThrowInvalid("a hierarchy cannot be written by several processes");
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
class PartWriter::Internals
{
public:
  Internals(const std::string& path, const std::vector<ArrayDescription>& arrays,
    const PartWriterOptions& options)
    : Options(options)
    , Folder(GetSpillFolder(path))
    , State(path, arrays, options.File)
    , Boundaries(this->Folder, options.SpillMemory)
  {
  }

  Internals(const std::string& path, const std::vector<ArrayDescription>& arrays,
    const PartWriterOptions& options, PartExchange& exchange)
    : Options(options)
    , Folder(GetSpillFolder(path))
    , State(arrays, options.File, this->Folder)
    , Boundaries(this->Folder, options.SpillMemory)
    , Exchange(&exchange)
  {
    if (exchange.GetProcess() == 0)
    {
      this->Common.emplace(OutputFile::Common(), path);
    }
    this->Agreement.emplace(exchange, this->State, this->Folder, options.SpillMemory);
    this->Steps.KeepTables();
  }

  void Survey(const MeshInput& mesh, const std::int64_t* globalIds, const Progress& progress);
  void SurveyStep(std::span<const void* const> values);
  void EndSurvey();
  void Write(const MeshInput& mesh, const std::int64_t* globalIds, const Progress& progress);
  void WriteStep(std::span<const void* const> values, const FieldData& field, bool hasTime,
    double time, const Progress& progress);
  PartStatistics Finish(const Progress& progress);

private:
  void EndPartSurvey();
  void JoinAlone();
  void JoinTogether();
  void SendPoints();
  void PlaceParts();
  void EndPart();
  std::vector<std::uint8_t> ApplyJoins(const PartJoins& joins);
  bool HasNumbers() const
  {
    return this->Parts.size() > 1 && (this->Options.File.Keep & KeepPoints);
  }

  /** The number of a part of this process in the file. */
  std::size_t GetNumber(std::size_t part) const
  {
    return part + (this->Agreement ? this->Agreement->GetOwn().FirstPart : 0);
  }
  std::size_t GetNumberOfOwnParts() const
  {
    return this->Agreement ? this->Agreement->GetOwn().Parts : this->Parts.size();
  }

  const PartWriterOptions Options;
  const std::string Folder; // of temporary files
  WriterState State;
  MeshSection Mesh{ State };
  StepSection Steps{ State };
  BoundaryMerge Boundaries;
  std::vector<SurveyedPart> Parts;
  std::optional<PartSurvey> Current; // the part that is being surveyed
  PartDomains Domains{ State };
  std::optional<bool> HasIds; // whether the parts with points have global ids
  bool IsJoined = false;

  // While parts are written.
  std::vector<PartPlace> Places;
  std::size_t Written = 0; // parts of this process that were begun
  std::optional<WriterPart> Part;
  std::vector<std::uint8_t> IsJoinedPoint; // whether other parts have a point of the part, too
  bool IsDeferred = false;                 // whether the mesh of the part is not written yet
  PointNumbers Numbers{ Boundaries };
  std::optional<PartTree> Tree;

  // If several processes write the file.
  PartExchange* const Exchange = nullptr;
  std::optional<OutputFile> Common; // in the first process
  std::optional<PartAgreement> Agreement;
  std::vector<PartJoins> Joins; // of the parts of this process
};

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
  CheckWriterInput(mesh, this->State.Meta.Arrays, this->Options.File);
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
  if (this->Options.Weights)
  {
    PartMergeSettings settings;
    settings.Folder = this->Folder;
    this->Tree.emplace(this->State, *this->Options.Weights,
      this->Parts.empty() ? 0 : this->Parts.front().StepHashes.size(), settings);
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
  this->IsJoinedPoint =
    this->ApplyJoins(this->Agreement ? std::move(this->Joins[this->Written - 1])
                                     : this->Boundaries.Take(static_cast<std::uint32_t>(number)));
  // With a single step, its values are encoded together with the mesh, chunk by chunk.
  // A hierarchy needs the numbers of the points before that.
  this->IsDeferred = surveyed.StepHashes.size() == 1 && !this->Tree;
  if (!this->IsDeferred)
  {
    this->Mesh.Write(*this->Part, progress);
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
  const StepValues all{ values, &field, hasTime, time };
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
    if (this->Tree)
    {
      this->Tree->AddStep(step, input.Arrays);
    }
  }
  this->Steps.Finish(*this->Part, all);
  if (step + 1 == surveyed.StepHashes.size())
  {
    this->EndPart(); // before the caller gets the next part
  }
}

//------------------------------------------------------------------------------
PartStatistics PartWriter::Internals::Finish(const Progress& progress)
{
  const auto end = [this]
  {
    if (this->Parts.empty() || this->Written < this->GetNumberOfOwnParts() ||
      (this->Exchange && !this->IsJoined))
    {
      ThrowInvalid("not all parts have been written");
    }
    this->EndPart();
  };
  PartStatistics statistics;
  if (this->Exchange)
  {
    this->Exchange->Together(end);
    statistics.File = PartAssembly(*this->Exchange, *this->Agreement, this->State, this->Steps,
      this->Common ? &*this->Common : nullptr)
                        .Finish();
  }
  else
  {
    end();
    if (this->Tree)
    {
      this->Tree->Write(progress);
    }
    this->State.WriteTables(this->State.File);
    this->State.File.AddSection(SectionMeta, this->State.Meta.Write());
    statistics.File = this->State.Commit(this->State.File);
  }
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
