// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFront.h"

namespace gatun
{
void Front::Grow()
{
  std::vector<Face> larger(2 * this->Faces.size());
  const auto mask = static_cast<std::uint32_t>(larger.size() - 1);
  for (auto id = this->Head; id != this->Tail; ++id)
  {
    larger[id & mask] = this->GetFace(id);
  }
  this->Faces.swap(larger);
  this->Mask = mask;
}
}
