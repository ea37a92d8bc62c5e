// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFileSettings.h"

#include "gatunReport.h"

#include <algorithm>
#include <exception>

namespace gatun
{
//------------------------------------------------------------------------------
std::size_t FileSettings::CountMerges(SharedFile& mesh) const
{
  if (!this->Simplifies())
  {
    return 0;
  }
  mesh.RequireHierarchy();
  return gatun::CountMerges(this->Simplification.GetTarget(), mesh.GetFile()->GetNumberOfPoints(),
    mesh.GetFile()->GetNumberOfMerges(), [&mesh]() -> const MergeTree& { return mesh.GetTree(); });
}

//------------------------------------------------------------------------------
bool FileSettings::IsOnDemand(SharedFile& mesh) const
{
  if (this->HasRegion || !this->LargeMesh)
  {
    return false;
  }
  if (*this->LargeMesh == 0)
  {
    return true; // without cells, too
  }
  return mesh.EstimateCells(this->CountMerges(mesh)) > *this->LargeMesh;
}

//------------------------------------------------------------------------------
PublishedFile FileSettings::Describe(const std::shared_ptr<SharedFile>& mesh) const
{
  PublishedFile handle;
  handle.Path = this->Path;
  handle.File = mesh;
  handle.Selected = this->Selected;
  handle.RestoreOrder = this->RestoreOrder;
  handle.SplitCells = this->SplitCells;
  handle.GenerateGlobalIds = this->GenerateGlobalIds;
  if (this->HasRegion)
  {
    handle.Reason = "the reader is restricted to a region of interest";
  }
  try
  {
    handle.Merges = this->CountMerges(*mesh);
    handle.OnDemand = this->IsOnDemand(*mesh);
  }
  catch (...)
  {
    // The reader reports it when it is asked for data.
    handle.Failure = std::current_exception();
    handle.Reason = DescribeFailure(this->Path.c_str()).Message;
  }
  return handle;
}

//------------------------------------------------------------------------------
std::size_t FindMesh(const FileReader& file, double time)
{
  const auto& series = file.GetSeries();
  if (series.empty())
  {
    return 0;
  }
  const auto next = std::upper_bound(series.begin(), series.end(), time,
    [](double t, const SeriesStep& step) { return t < step.Time; });
  return next == series.begin() ? series.front().Mesh : std::prev(next)->Mesh;
}
}
