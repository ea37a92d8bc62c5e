// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunFileRayDetail.h"

#include "gatunCoarseRaySource.h"
#include "gatunError.h"
#include "gatunRaySourceInternals.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
FileRayDetail::FileRayDetail(std::shared_ptr<const FileReader> file, const RayValues& values)
  : Values(values)
{
  CheckRayValues(*file, values);
  if (!file->HasMergeTree())
  {
    ThrowInvalid(
      file->GetPath() + ": there is no hierarchy in the file; make one with gtn pack --hierarchy");
  }
  this->Levels.push_back({ 0, file, nullptr });
  for (std::size_t i = 0; i < file->GetLevels().size(); ++i)
  {
    this->Levels.push_back({ file->GetLevels()[i], file->OpenLevel(i), nullptr });
  }
}

FileRayDetail::~FileRayDetail() = default;

//------------------------------------------------------------------------------
std::uint64_t FileRayDetail::GetNumberOfPoints() const
{
  return this->Levels.front().File->GetNumberOfPoints();
}

//------------------------------------------------------------------------------
std::uint64_t FileRayDetail::GetFewestPoints() const
{
  return this->GetNumberOfPoints() - this->Levels.front().File->GetNumberOfMerges();
}

//------------------------------------------------------------------------------
std::shared_ptr<RaySource> FileRayDetail::MakeSource(std::uint64_t points, std::uint64_t budget)
{
  const auto all = this->GetNumberOfPoints();
  const auto merges = all - std::clamp(points, this->GetFewestPoints(), all);
  const auto next = std::partition_point(this->Levels.begin(), this->Levels.end(),
    [=](const Level& level) { return level.Merges <= merges; });
  Level& level = *std::prev(next);
  const auto more = static_cast<std::size_t>(merges - level.Merges);
  if (more == 0)
  {
    return std::make_shared<FileRaySource>(level.File, this->Values, budget);
  }
  if (!level.Tree)
  {
    level.Tree = std::make_shared<const MergeTree>(level.File->GetMergeTree());
  }
  return std::make_shared<CoarseRaySource>(level.File, *level.Tree, more, this->Values, budget);
}

//------------------------------------------------------------------------------
std::uint64_t FileRayDetail::EstimateTets(std::uint64_t points) const
{
  // Of the simplest mesh that is not simpler, the part that its points are.
  const FileReader* from = this->Levels.front().File.get();
  for (const Level& level : this->Levels)
  {
    from = level.File->GetNumberOfPoints() >= points ? level.File.get() : from;
  }
  const auto ofAll = static_cast<double>(std::max<std::uint64_t>(1, from->GetNumberOfPoints()));
  const double part = std::min(1.0, static_cast<double>(points) / ofAll);
  return static_cast<std::uint64_t>(part * static_cast<double>(from->GetNumberOfTets()));
}
}
