// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnScratch.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cstring>

namespace gtn
{
namespace
{
// In place, since a handler must not touch what is allocated.
struct ScratchSlot
{
  std::atomic<int> State = 0; // 0 free, 1 being written, 2 in use
  std::array<char, 4096> Name{};
};
std::array<ScratchSlot, 8> scratchSlots;
}

//------------------------------------------------------------------------------
ScratchName::ScratchName(const std::string& file)
  : Place(-1)
{
  for (std::size_t i = 0; i < scratchSlots.size() && this->Place < 0; ++i)
  {
    ScratchSlot& slot = scratchSlots[i];
    int free = 0;
    if (file.size() < slot.Name.size() && slot.State.compare_exchange_strong(free, 1))
    {
      std::memcpy(slot.Name.data(), file.c_str(), file.size() + 1);
      slot.State = 2;
      this->Place = static_cast<int>(i);
    }
  }
}

//------------------------------------------------------------------------------
ScratchName::~ScratchName()
{
  if (this->Place >= 0)
  {
    scratchSlots[static_cast<std::size_t>(this->Place)].State = 0;
  }
}

//------------------------------------------------------------------------------
void RemoveScratchFiles() noexcept
{
  for (const ScratchSlot& slot : scratchSlots)
  {
    if (slot.State == 2)
    {
      unlink(slot.Name.data());
    }
  }
}
}
