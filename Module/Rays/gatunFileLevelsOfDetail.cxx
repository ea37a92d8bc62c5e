// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunFileLevelsOfDetail.h"

#include "gatunCoarseRaySource.h"
#include "gatunFileRaySource.h"

#include <algorithm>

namespace gatun
{
//------------------------------------------------------------------------------
FileLevelsOfDetail::FileLevelsOfDetail(
  std::shared_ptr<const FileReader> file, const RayValues& values)
  : Own(std::make_shared<SimplifiedFile>(std::move(file)))
  , File(*this->Own)
  , Values(values)
{
  CheckRayValues(*this->File.GetFile(), values);
}

FileLevelsOfDetail::FileLevelsOfDetail(std::shared_ptr<SharedFile> shared, const RayValues& values)
  : Shared(std::move(shared))
  , File(this->Shared->GetHierarchy())
  , Values(values)
{
  CheckRayValues(*this->File.GetFile(), values);
}

FileLevelsOfDetail::~FileLevelsOfDetail() = default;

//------------------------------------------------------------------------------
std::uint64_t FileLevelsOfDetail::GetNumberOfPoints() const
{
  return this->File.GetFile()->GetNumberOfPoints();
}

//------------------------------------------------------------------------------
std::uint64_t FileLevelsOfDetail::GetFewestPoints() const
{
  return this->GetNumberOfPoints() - this->File.GetFile()->GetNumberOfMerges();
}

//------------------------------------------------------------------------------
std::uint64_t FileLevelsOfDetail::CountMerges(std::uint64_t points) const
{
  const auto all = this->GetNumberOfPoints();
  return all - std::clamp(points, this->GetFewestPoints(), all);
}

//------------------------------------------------------------------------------
std::shared_ptr<RaySource> FileLevelsOfDetail::MakeSource(
  std::uint64_t points, std::uint64_t budget)
{
  const auto place = this->File.Find(this->CountMerges(points));
  if (this->Shared)
  {
    auto parts = this->Shared->MakeView(place.File, false);
    if (place.Merges == 0)
    {
      return std::make_shared<FileRaySource>(std::move(parts), this->Values);
    }
    return std::make_shared<CoarseRaySource>(
      std::move(parts), *place.Tree, place.Merges, this->Values);
  }
  if (place.Merges == 0)
  {
    return std::make_shared<FileRaySource>(place.File, this->Values, budget);
  }
  return std::make_shared<CoarseRaySource>(
    place.File, *place.Tree, place.Merges, this->Values, budget);
}

//------------------------------------------------------------------------------
std::uint64_t FileLevelsOfDetail::EstimateTets(std::uint64_t points) const
{
  return this->File.EstimateCells(this->CountMerges(points));
}
}
