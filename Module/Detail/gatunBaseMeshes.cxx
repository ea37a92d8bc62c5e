// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBaseMeshes.h"

#include "gatunSharedFile.h"

namespace gatun
{
//------------------------------------------------------------------------------
bool IsFineEnough(SharedFile& file, std::size_t level, const BaseNeeds& needs)
{
  const auto points = file.GetFile()->GetNumberOfPoints() - file.GetMergesOfLevel(level);
  if (points / FinestToUniform >= needs.Points)
  {
    return true;
  }
  // The error of the merges that lead to a level is at most that of the next one.
  const auto tree = file.GetLevel(level).Tree;
  return !tree->GetMerges().empty() &&
    tree->GetMerges().front().Error * needs.Weight <= needs.PixelError;
}

//------------------------------------------------------------------------------
std::size_t FindBaseMesh(
  SharedFile& file, std::size_t coarsest, std::size_t finest, const BaseNeeds& needs)
{
  auto level = coarsest;
  while (level > finest && !IsFineEnough(file, level, needs))
  {
    --level;
  }
  return level;
}
}
