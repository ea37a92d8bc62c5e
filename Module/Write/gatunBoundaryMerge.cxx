// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBoundaryMerge.h"

#include "gatunError.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
void BoundaryMerge::Join(std::size_t parts, SharedGroups& groups)
{
  this->Counts.Repeated.assign(parts, 0);
  this->Boundaries.Sort();
  std::vector<Member> members;
  while (const auto* first = this->Boundaries.Get())
  {
    // All points with a key, and those of them that have the same values.
    const auto key = first->Key;
    const auto part = first->Part;
    bool isOfSeveralParts = false;
    std::uint64_t different = 0;
    std::uint64_t ambiguous = 0;
    while (first && first->Key == key)
    {
      const auto values = first->Values;
      members.clear();
      for (; first && first->Key == key && first->Values == values; first = this->Boundaries.Get())
      {
        isOfSeveralParts = isOfSeveralParts || first->Part != part;
        if (members.empty() || members.back().Part != first->Part ||
          members.back().Point != first->Point)
        {
          members.push_back({ first->Part, first->Point, first->Morton, {} });
        }
        if (first->Chunk != BoundaryRecord::NoChunk)
        {
          members.back().Chunks.push_back(first->Chunk);
        }
        this->Boundaries.Next();
      }
      const bool isAmbiguous =
        std::adjacent_find(members.begin(), members.end(),
          [](const Member& l, const Member& r) { return l.Part == r.Part; }) != members.end();
      if (isAmbiguous)
      {
        ambiguous += members.size();
      }
      else if (members.size() == 1)
      {
        ++different;
      }
      else
      {
        this->JoinEqual(members, groups);
      }
    }
    this->Counts.Different += isOfSeveralParts ? different : 0;
    this->Counts.Ambiguous += isOfSeveralParts ? ambiguous : 0;
  }
  this->Joins.Sort();
}

//------------------------------------------------------------------------------
/** Joins points of different parts, in the order of the parts. */
void BoundaryMerge::JoinEqual(const std::vector<Member>& members, SharedGroups& groups)
{
  ChunkGroup chunks; // ascending, because those of each part follow those of the parts before
  const Member* first = nullptr;
  bool isOfSeveralParts = false;
  for (const auto& member : members)
  {
    chunks.insert(chunks.end(), member.Chunks.begin(), member.Chunks.end());
    isOfSeveralParts = isOfSeveralParts || (first && !member.Chunks.empty());
    first = first || member.Chunks.empty() ? first : &member;
  }
  // An unused point is that of a part with cells, or else that of the first part.
  const Member* const kept = first ? first : &members.front();
  const auto group = isOfSeveralParts ? this->FindGroup(chunks) : 0;
  for (const auto& member : members)
  {
    this->Counts.Repeated[member.Part] += &member != kept;
    if (member.Chunks.empty())
    {
      if (&member != kept)
      {
        this->Drop(member);
      }
    }
    else if (isOfSeveralParts)
    {
      this->Joins.Add({ member.Part, group, first->Morton, first->Point, member.Point });
      if (member.Chunks.size() > 1)
      {
        groups.Add(member.Chunks, -1);
      }
    }
  }
  if (isOfSeveralParts)
  {
    groups.Add(chunks, 1);
  }
}

//------------------------------------------------------------------------------
void BoundaryMerge::Drop(const Member& member)
{
  this->Joins.Add({ member.Part, JoinRecord::Dropped, 0, 0, member.Point });
  ++this->Counts.Dropped;
}

//------------------------------------------------------------------------------
std::uint32_t BoundaryMerge::FindGroup(const ChunkGroup& chunks)
{
  const auto [found, isNew] =
    this->GroupNumbers.try_emplace(chunks, static_cast<std::uint32_t>(this->Groups.size()));
  if (isNew)
  {
    if (found->second == JoinRecord::Dropped)
    {
      ThrowInvalid("the parts share too many groups of points; make chunks larger");
    }
    this->Groups.push_back(&found->first);
  }
  return found->second;
}

//------------------------------------------------------------------------------
PartJoins BoundaryMerge::Take(std::uint32_t part)
{
  PartJoins joins;
  for (const auto* join = this->Joins.Get(); join && join->Part == part; join = this->Joins.Get())
  {
    if (join->Group == JoinRecord::Dropped)
    {
      joins.Dropped.push_back(join->Point);
    }
    else
    {
      joins.Groups[join->Group].push_back(join->Point);
    }
    this->Joins.Next();
  }
  return joins;
}
}
