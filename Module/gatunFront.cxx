// SPDX-License-Identifier: BSD-3-Clause
#include "gatunFront.h"

namespace gatun
{
Front::Front()
  : Faces(1024)
  , Slots(2048, None)
  , FaceMask(1023)
  , SlotMask(2047)
{
}

std::uint32_t Front::AddEdge(Vertex a, Vertex b)
{
  if (2 * (this->LiveEdges + 1) > this->Slots.size())
  {
    this->GrowSlots();
  }
  std::uint32_t id;
  if (this->FreeEdges.empty())
  {
    id = static_cast<std::uint32_t>(this->Edges.size());
    this->Edges.emplace_back();
  }
  else
  {
    id = this->FreeEdges.back();
    this->FreeEdges.pop_back();
  }
  auto& edge = this->Edges[id];
  edge.Ends = Sorted(a, b);
  edge.BorderFar = None;
  edge.Tets = 0;
  edge.Listed = 0;
  edge.Open = 0;
  auto slot = Hash(edge.Ends) & this->SlotMask;
  while (this->Slots[slot] != None)
  {
    slot = (slot + 1) & this->SlotMask;
  }
  this->Slots[slot] = id;
  ++this->LiveEdges;
  return id;
}

void Front::AddFace(const std::array<Vertex, 3>& corners, Vertex apex,
  const std::array<std::uint32_t, 3>& edges, std::uint32_t tet)
{
  if (this->Tail - this->Head == this->Faces.size())
  {
    this->GrowFaces();
  }
  const auto id = this->Tail++;
  this->GetFace(id) = { corners, apex, edges, tet + 1 };
  for (const auto e : edges)
  {
    auto& edge = this->Edges[e];
    ++edge.Open;
    if (edge.Listed < MaxFacesOnEdge)
    {
      edge.Faces[edge.Listed] = id;
      ++edge.Listed;
    }
  }
}

void Front::DropEdge(std::uint32_t id)
{
  auto slot = Hash(this->Edges[id].Ends) & this->SlotMask;
  while (this->Slots[slot] != id)
  {
    slot = (slot + 1) & this->SlotMask;
  }
  // Close the gap: move back every later edge of the run that does not lie in its own place.
  for (auto next = slot;;)
  {
    next = (next + 1) & this->SlotMask;
    const auto moved = this->Slots[next];
    if (moved == None)
    {
      break;
    }
    const auto home = Hash(this->Edges[moved].Ends) & this->SlotMask;
    if (((next - home) & this->SlotMask) >= ((next - slot) & this->SlotMask))
    {
      this->Slots[slot] = moved;
      slot = next;
    }
  }
  this->Slots[slot] = None;
  this->Edges[id].Ends = { None, None };
  this->FreeEdges.push_back(id);
  --this->LiveEdges;
}

void Front::GrowFaces()
{
  std::vector<Face> larger(2 * this->Faces.size());
  const auto mask = static_cast<std::uint32_t>(larger.size() - 1);
  for (auto id = this->Head; id != this->Tail; ++id)
  {
    larger[id & mask] = this->GetFace(id);
  }
  this->Faces.swap(larger);
  this->FaceMask = mask;
}

void Front::GrowSlots()
{
  this->SlotMask = 2 * this->SlotMask + 1;
  this->Slots.assign(std::size_t{ this->SlotMask } + 1, None);
  for (std::uint32_t id = 0; id < this->Edges.size(); ++id)
  {
    if (this->Edges[id].Ends[1] == None)
    {
      continue;
    }
    auto slot = Hash(this->Edges[id].Ends) & this->SlotMask;
    while (this->Slots[slot] != None)
    {
      slot = (slot + 1) & this->SlotMask;
    }
    this->Slots[slot] = id;
  }
}
}
