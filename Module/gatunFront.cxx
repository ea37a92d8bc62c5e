// SPDX-License-Identifier: BSD-3-Clause
#include "gatunFront.h"

namespace gatun
{
Front::Front()
  : Faces(1024)
  , Slots(4096)
  , FaceMask(1023)
  , SlotMask(4095)
{
}

void Front::DropEdge(std::uint32_t id)
{
  auto gap = Hash(this->Edges[id].Ends) & this->SlotMask;
  while (this->Slots[gap].Edge != id)
  {
    gap = (gap + 1) & this->SlotMask;
  }
  // Close the gap: move back every later edge of the run that does not lie in its own place.
  for (auto next = (gap + 1) & this->SlotMask; this->Slots[next].Edge != None;
       next = (next + 1) & this->SlotMask)
  {
    const auto home = this->Slots[next].Tag & this->SlotMask;
    if (((next - home) & this->SlotMask) >= ((next - gap) & this->SlotMask))
    {
      this->Slots[gap] = this->Slots[next];
      gap = next;
    }
  }
  this->Slots[gap].Edge = None;
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
  const auto old = std::move(this->Slots);
  this->SlotMask = 2 * this->SlotMask + 1;
  this->Slots.assign(std::size_t{ this->SlotMask } + 1, Slot{});
  for (const auto& slot : old)
  {
    if (slot.Edge != None)
    {
      this->Insert(slot.Tag, slot.Edge);
    }
  }
}
}
