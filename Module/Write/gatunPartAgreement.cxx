// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPartAgreement.h"

#include "gatunError.h"
#include "gatunTableParts.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace gatun
{
namespace
{
/** The process that joins the points with a key. */
std::size_t FindJoiner(const BoundaryRecord& use, std::size_t processes)
{
  std::uint64_t hash = 0;
  for (const auto word : use.Key)
  {
    hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash % processes);
}

void PutChunks(ByteWriter& out, const ChunkGroup& chunks)
{
  out.PutVarint(chunks.size());
  for (const auto chunk : chunks)
  {
    out.PutVarint(chunk);
  }
}

ChunkGroup GetChunks(ByteReader& in)
{
  ChunkGroup chunks(static_cast<std::size_t>(in.GetCount(1)));
  for (auto& chunk : chunks)
  {
    chunk = static_cast<std::uint32_t>(in.GetVarint());
  }
  return chunks;
}

void PutSized(ByteWriter& out, const Bytes& bytes)
{
  out.PutVarint(bytes.size());
  out.PutBytes(bytes);
}

void AppendSized(Bytes& to, ByteReader& in)
{
  const auto bytes = in.GetBytes(in.GetCount(1));
  to.insert(to.end(), bytes.begin(), bytes.end());
}
}

//------------------------------------------------------------------------------
PartAgreement::PartAgreement(
  PartExchange& exchange, WriterState& state, const std::string& folder, std::size_t memory)
  : Exchange(exchange)
  , State(state)
  , Folder(folder)
  , Memory(memory)
  , Uses(folder, memory)
{
}

//------------------------------------------------------------------------------
std::size_t PartAgreement::GetRoundBytes() const
{
  return std::clamp<std::size_t>(this->Memory, std::size_t{ 1 } << 16, std::size_t{ 1 } << 26);
}

//------------------------------------------------------------------------------
void PartAgreement::AddUnused(const WriterPart& part)
{
  const auto& mesh = part.Mesh.GetMesh();
  const auto size = 3 * SizeOf(mesh.CoordinateType);
  auto& unused = this->Unused.emplace_back();
  unused.Points = part.Layout.UnusedPoints;
  for (const auto point : unused.Points)
  {
    const auto* from = static_cast<const std::uint8_t*>(mesh.Coordinates) + size * point;
    unused.Coordinates.insert(unused.Coordinates.end(), from, from + size);
  }
}

//------------------------------------------------------------------------------
void PartAgreement::AddUnusedValues(std::span<const void* const> values)
{
  auto& unused = this->Unused.back();
  auto& step = unused.Values.emplace_back(values.size());
  for (std::size_t a = 0; a < values.size(); ++a)
  {
    const auto& array = this->State.Meta.Arrays[a];
    const auto size = array.Components * SizeOf(array.Type);
    for (std::size_t i = 0; array.Where == Association::Point && i < unused.Points.size(); ++i)
    {
      const auto* from = static_cast<const std::uint8_t*>(values[a]) + size * unused.Points[i];
      step[a].insert(step[a].end(), from, from + size);
    }
  }
}

//------------------------------------------------------------------------------
void PartAgreement::PutSurvey(
  ByteWriter& out, const std::vector<SurveyedPart>& parts, const std::optional<bool>& hasIds) const
{
  MetaTable settings = this->State.Meta; // arrays and options
  settings.Points = settings.UnusedPoints = 0;
  settings.ChunkSize = 0;
  settings.CoordinateType = {};
  settings.PointArray = {};
  settings.WideIds = false;
  PutSized(out, settings.Write());
  const auto& meta = this->State.Meta;
  out.PutVarint(parts.size());
  for (const auto& part : parts)
  {
    out.PutVarint(part.Chunks);
    out.PutVarint(part.Points);
    out.PutVarint(part.Cells);
  }
  out.PutVarint(parts.empty() ? 0 : parts[0].StepHashes.size());
  out.Put<std::uint8_t>(hasIds ? *hasIds : 2);
  PutPoints(out, meta.PointArray);
  out.Put(static_cast<std::uint8_t>(meta.CoordinateType));
  out.Put<std::uint8_t>(meta.WideIds);
  out.Put<std::uint8_t>(this->State.HasCells);
  out.Put(meta.ChunkSize);
  out.PutVarint(meta.Points);
  out.PutVarint(meta.UnusedPoints);
  out.PutVarint(this->State.NumberOfCells);
  for (const auto count : this->State.TypeCounts)
  {
    out.PutVarint(count);
  }
  this->State.Shapes.PutUses(out);
}

//------------------------------------------------------------------------------
void PartAgreement::AgreeOnParts(
  std::vector<SurveyedPart>& parts, const std::optional<bool>& hasIds)
{
  ByteWriter own;
  this->PutSurvey(own, parts, hasIds);
  const auto surveys = this->Exchange.Gather(own.Data);
  auto& state = this->State;
  auto& meta = state.Meta;
  meta.Points = meta.UnusedPoints = state.NumberOfCells = 0;
  state.TypeCounts = {};
  state.Shapes = {};
  std::vector<SurveyedPart> all;
  std::size_t steps = 0;
  std::uint8_t ids = 2;
  std::size_t chunks = 0;
  PointsDescription pointArray;
  Bytes settings;
  for (std::size_t p = 0; p < surveys.size(); ++p)
  {
    ByteReader in(surveys[p]);
    Bytes described;
    AppendSized(described, in);
    settings = p == 0 ? described : settings;
    if (described != settings)
    {
      ThrowInvalid("the processes have different arrays or options");
    }
    ProcessShare share{ all.size(), static_cast<std::size_t>(in.GetCount(3)), chunks, 0, 0, 0 };
    for (std::size_t i = 0; i < share.Parts; ++i)
    {
      SurveyedPart part;
      part.Chunks = static_cast<std::size_t>(in.GetVarint());
      part.Points = in.GetVarint();
      part.Cells = in.GetVarint();
      share.Chunks += part.Chunks;
      all.push_back(part);
    }
    chunks += share.Chunks;
    const auto count = static_cast<std::size_t>(in.GetVarint());
    const auto itsIds = in.Get<std::uint8_t>();
    const auto points = GetPoints(in);
    const auto type = static_cast<ScalarType>(in.Get<std::uint8_t>());
    pointArray = pointArray == PointsDescription() ? points : pointArray;
    if (share.Parts > 0)
    {
      const bool isFirst = share.FirstPart == 0;
      if (!isFirst && count != steps)
      {
        ThrowInvalid("parts have different numbers of time steps");
      }
      if (!isFirst && type != meta.CoordinateType)
      {
        ThrowInvalid("parts have coordinates of different types");
      }
      if (ids != 2 && itsIds != 2 && ids != itsIds)
      {
        ThrowInvalid("some parts have global ids of points, and some do not");
      }
      steps = count;
      meta.CoordinateType = type;
      ids = itsIds != 2 ? itsIds : ids;
    }
    meta.WideIds = (in.Get<std::uint8_t>() != 0) || meta.WideIds;
    state.HasCells = (in.Get<std::uint8_t>() != 0) || state.HasCells;
    meta.ChunkSize = std::max(meta.ChunkSize, in.Get<std::uint32_t>());
    meta.Points += in.GetVarint();
    meta.UnusedPoints += in.GetVarint();
    state.NumberOfCells += in.GetVarint();
    for (auto& number : state.TypeCounts)
    {
      number += in.GetVarint();
    }
    state.Shapes.AddUses(in);
    this->Shares.push_back(share);
  }
  meta.PointArray = pointArray;
  if (all.empty())
  {
    ThrowInvalid("no process has a part");
  }
  if (chunks >= BoundaryRecord::NoChunk)
  {
    ThrowInvalid("the file has too many chunks; make chunks larger");
  }
  std::move(parts.begin(), parts.end(),
    all.begin() + static_cast<std::ptrdiff_t>(this->GetOwn().FirstPart));
  parts = std::move(all);
  this->PlaceChunks();
}

//------------------------------------------------------------------------------
/** Gives the chunks of this process their numbers in the file. */
void PartAgreement::PlaceChunks()
{
  const auto place = [&](auto& chunks)
  {
    const auto own = std::move(chunks);
    chunks.clear();
    chunks.resize(this->Shares.back().FirstChunk + this->Shares.back().Chunks);
    std::copy(own.begin(), own.end(),
      chunks.begin() + static_cast<std::ptrdiff_t>(this->GetOwn().FirstChunk));
  };
  place(this->State.Table.Chunks);
  place(this->State.Cells.Chunks);
}

//------------------------------------------------------------------------------
void PartAgreement::JoinPoints(BoundaryMerge& boundaries, std::size_t parts)
{
  BoundaryMerge merge(this->Folder, this->Memory);
  const auto own = this->GetOwn();
  this->Exchange.Together([&] { this->Uses.Sort(); });
  this->Exchange.ExchangeInRounds(
    [&](std::vector<PartExchange::Message>& messages)
    {
      std::size_t bytes = 0;
      const auto* next = this->Uses.Get();
      for (; next && bytes < this->GetRoundBytes(); next = this->Uses.Get())
      {
        BoundaryRecord use = *next;
        use.Part += static_cast<std::uint32_t>(own.FirstPart);
        use.Chunk +=
          use.Chunk == BoundaryRecord::NoChunk ? 0 : static_cast<std::uint32_t>(own.FirstChunk);
        const auto* begin = reinterpret_cast<const std::uint8_t*>(&use);
        auto& message = messages[FindJoiner(use, messages.size())];
        message.insert(message.end(), begin, begin + sizeof(use));
        bytes += sizeof(use);
        this->Uses.Next();
      }
      return next != nullptr;
    },
    [&](const PartExchange::Message& message)
    {
      for (std::size_t at = 0; at + sizeof(BoundaryRecord) <= message.size();
           at += sizeof(BoundaryRecord))
      {
        BoundaryRecord use;
        std::memcpy(&use, message.data() + at, sizeof(use));
        merge.Add(use);
      }
    });
  SharedGroups changes;
  this->Exchange.Together([&] { merge.Join(parts, changes); });
  const auto counts = this->AgreeOnGroups(merge.GetCounts(), changes, parts);
  this->ReturnJoins(merge, boundaries);
  this->Exchange.Together([&] { boundaries.SetJoined(counts); });
}

//------------------------------------------------------------------------------
JoinCounts PartAgreement::AgreeOnGroups(
  const JoinCounts& own, const SharedGroups& changes, std::size_t parts)
{
  ByteWriter out;
  this->State.Groups.Put(out, static_cast<std::uint32_t>(this->GetOwn().FirstChunk));
  changes.Put(out, 0);
  for (const auto count : own.Repeated)
  {
    out.PutVarint(count);
  }
  out.PutVarint(own.Dropped);
  out.PutVarint(own.Different);
  out.PutVarint(own.Ambiguous);
  this->State.Groups = {};
  JoinCounts counts;
  counts.Repeated.resize(parts);
  for (const auto& message : this->Exchange.Gather(out.Data))
  {
    ByteReader in(message);
    this->State.Groups.Add(in);
    this->State.Groups.Add(in);
    for (auto& count : counts.Repeated)
    {
      count += in.GetVarint();
    }
    counts.Dropped += in.GetVarint();
    counts.Different += in.GetVarint();
    counts.Ambiguous += in.GetVarint();
  }
  return counts;
}

//------------------------------------------------------------------------------
/** Sends joined points to the processes that have them. */
void PartAgreement::ReturnJoins(BoundaryMerge& merge, BoundaryMerge& boundaries)
{
  this->Exchange.ExchangeInRounds(
    [&](std::vector<PartExchange::Message>& messages)
    {
      std::size_t bytes = 0;
      std::size_t owner = 0;
      const auto* join = merge.GetJoin();
      for (; join && bytes < this->GetRoundBytes(); join = merge.GetJoin())
      {
        while (join->Part >= this->Shares[owner].FirstPart + this->Shares[owner].Parts)
        {
          ++owner; // joins ascend by part
        }
        ByteWriter out;
        out.Put(join->Part);
        out.Put(join->Morton);
        out.Put(join->First);
        out.Put(join->Point);
        PutChunks(
          out, join->Group == JoinRecord::Dropped ? ChunkGroup() : merge.GetGroup(join->Group));
        messages[owner].insert(messages[owner].end(), out.Data.begin(), out.Data.end());
        bytes += out.Data.size();
        merge.NextJoin();
      }
      return join != nullptr;
    },
    [&](const PartExchange::Message& message)
    {
      for (ByteReader in(message); in.GetRemaining() > 0;)
      {
        JoinRecord join;
        join.Part = in.Get<std::uint32_t>();
        join.Morton = in.Get<std::uint64_t>();
        join.First = in.Get<std::uint32_t>();
        join.Point = in.Get<std::uint32_t>();
        const auto chunks = GetChunks(in);
        join.Group = chunks.empty() ? JoinRecord::Dropped : boundaries.FindGroup(chunks);
        boundaries.AddJoin(join);
      }
    });
}

//------------------------------------------------------------------------------
void PartAgreement::AgreeOnDomains(PartDomains& domains)
{
  ByteWriter own;
  domains.Put(own);
  const bool isFirst = this->Exchange.GetProcess() == 0;
  const auto others = this->Exchange.GatherInFirst(std::move(own.Data));
  ByteWriter all;
  if (isFirst)
  {
    for (std::size_t p = 1; p < others.size(); ++p)
    {
      ByteReader in(others[p]);
      domains.Add(in);
    }
    domains.Put(all);
  }
  const auto agreed = this->Exchange.TakeFirst(all.Data);
  domains.Clear(); // what is known here is in the message
  ByteReader in(agreed);
  domains.Add(in);
}

//------------------------------------------------------------------------------
void PartAgreement::SetPlaces(const std::vector<PartPlace>& places)
{
  std::size_t block = 0;
  for (auto& share : this->Shares)
  {
    share.FirstBlock = block;
    for (std::size_t p = share.FirstPart; p < share.FirstPart + share.Parts; ++p)
    {
      share.Blocks += places[p].Blocks;
    }
    block += share.Blocks;
  }
}

//------------------------------------------------------------------------------
std::size_t PartAgreement::FindOwner(std::uint32_t chunk) const
{
  const auto next = std::upper_bound(this->Shares.begin(), this->Shares.end(), chunk,
    [](std::uint32_t number, const ProcessShare& share)
    { return number < share.FirstChunk + share.Chunks; });
  return static_cast<std::size_t>(next - this->Shares.begin());
}

//------------------------------------------------------------------------------
std::size_t PartAgreement::GetLast() const
{
  std::size_t last = this->Shares.size() - 1;
  while (last > 0 && this->Shares[last].Parts == 0)
  {
    --last;
  }
  return last;
}

//------------------------------------------------------------------------------
void PartAgreement::SendNumbers(
  BoundaryMerge& boundaries, std::vector<std::vector<std::uint64_t>>& numbers)
{
  const auto self = static_cast<std::size_t>(this->Exchange.GetProcess());
  std::vector<ByteWriter> messages(this->Shares.size());
  for (std::uint32_t group = 0; group < numbers.size(); ++group)
  {
    const auto& chunks = boundaries.GetGroup(group);
    if (numbers[group].empty() || this->FindOwner(chunks.front()) != self)
    {
      continue;
    }
    auto last = self;
    for (const auto chunk : chunks)
    {
      const auto owner = this->FindOwner(chunk);
      if (owner != last) // owners ascend
      {
        last = owner;
        auto& out = messages[owner];
        PutChunks(out, chunks);
        out.PutVarint(numbers[group].size());
        for (const auto number : numbers[group])
        {
          out.PutVarint(number);
        }
      }
    }
  }
  std::vector<PartExchange::Message> sent(messages.size());
  std::transform(messages.begin(), messages.end(), sent.begin(),
    [](ByteWriter& message) { return std::move(message.Data); });
  for (const auto& message : this->Exchange.Exchange(std::move(sent)))
  {
    for (ByteReader in(message); in.GetRemaining() > 0;)
    {
      const auto group = boundaries.FindGroup(GetChunks(in));
      numbers.resize(std::max<std::size_t>(numbers.size(), std::size_t{ group } + 1));
      numbers[group].resize(static_cast<std::size_t>(in.GetCount(1)));
      for (auto& number : numbers[group])
      {
        number = in.GetVarint();
      }
    }
  }
}

//------------------------------------------------------------------------------
void PartAgreement::KeepUnusedNumbers(
  std::size_t part, std::uint64_t first, const std::vector<std::uint64_t>& numbers)
{
  for (const auto point : this->Unused[part].Points)
  {
    this->Unused[part].Numbers.push_back(numbers.empty() ? first + point : numbers[point]);
  }
}

//------------------------------------------------------------------------------
void PartAgreement::SendUnused(const std::vector<PartJoins>& joins)
{
  UnusedPoints own;
  const auto& arrays = this->State.Meta.Arrays;
  const auto take = [](Bytes& to, const Bytes& from, std::size_t size, std::size_t i)
  {
    const auto begin = from.begin() + static_cast<std::ptrdiff_t>(size * i);
    to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(size));
  };
  const auto size = 3 * SizeOf(this->State.Meta.CoordinateType);
  for (std::size_t p = 0; p < this->Unused.size(); ++p)
  {
    auto& part = this->Unused[p];
    own.Values.resize(
      std::max(own.Values.size(), part.Values.size()), std::vector<Bytes>(arrays.size()));
    auto dropped = joins[p].Dropped;
    std::sort(dropped.begin(), dropped.end());
    for (std::size_t i = 0; i < part.Points.size(); ++i)
    {
      if (std::binary_search(dropped.begin(), dropped.end(), part.Points[i]))
      {
        continue;
      }
      take(own.Coordinates, part.Coordinates, size, i);
      if (this->State.Options.Keep & KeepPoints)
      {
        own.Numbers.push_back(part.Numbers[i]);
      }
      for (std::size_t step = 0; step < part.Values.size(); ++step)
      {
        for (std::size_t a = 0; a < arrays.size(); ++a)
        {
          if (arrays[a].Where == Association::Point)
          {
            take(own.Values[step][a], part.Values[step][a],
              arrays[a].Components * SizeOf(arrays[a].Type), i);
          }
        }
      }
    }
    part = {};
  }
  std::vector<PartExchange::Message> messages(this->Shares.size());
  const auto last = this->GetLast();
  if (static_cast<std::size_t>(this->Exchange.GetProcess()) != last)
  {
    ByteWriter out;
    PutSized(out, own.Coordinates);
    out.PutVarint(own.Numbers.size());
    for (const auto number : own.Numbers)
    {
      out.PutVarint(number);
    }
    out.PutVarint(own.Values.size());
    for (const auto& step : own.Values)
    {
      for (const auto& values : step)
      {
        PutSized(out, values);
      }
    }
    messages[last] = std::move(out.Data);
  }
  // The process that writes them takes its own ones when it writes its parts.
  auto& all = this->State.Unused;
  for (const auto& message : this->Exchange.Exchange(std::move(messages)))
  {
    if (message.empty())
    {
      continue;
    }
    ByteReader in(message);
    AppendSized(all.Coordinates, in);
    for (auto count = in.GetCount(1); count > 0; --count)
    {
      all.Numbers.push_back(in.GetVarint());
    }
    const auto steps = static_cast<std::size_t>(in.GetVarint());
    all.Values.resize(std::max(all.Values.size(), steps), std::vector<Bytes>(arrays.size()));
    for (std::size_t step = 0; step < steps; ++step)
    {
      for (auto& values : all.Values[step])
      {
        AppendSized(values, in);
      }
    }
  }
}
}
