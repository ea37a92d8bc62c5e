// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFront.h"

namespace gatun
{
void Front::Grow()
{
  const std::uint32_t mask = 2 * this->Mask + 1;
  std::vector<Face> larger(std::size_t{ mask } + 2);
  for (auto id = this->Head; id != this->Tail; ++id)
  {
    larger[id & mask] = this->GetFace(id);
  }
  this->Faces.swap(larger);
  this->Mask = mask;
}
}
