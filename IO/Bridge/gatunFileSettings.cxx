// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFileSettings.h"

#include "gatunFileReader.h"
#include "gatunReport.h"

#include "vtkDataSetAttributes.h"

#include <algorithm>
#include <cstddef>
#include <exception>

namespace gatun
{
namespace
{
/** Whether some cells of a file are not to be drawn: ghost cells and hidden ones. */
bool HasMarkedCells(const FileReader& file)
{
  const auto& arrays = file.GetArrays();
  for (std::size_t a = 0; a < arrays.size(); ++a)
  {
    if (arrays[a].Where == Association::Cell &&
      arrays[a].Name == vtkDataSetAttributes::GhostArrayName())
    {
      for (std::size_t step = 0; step < file.GetNumberOfSteps(); ++step)
      {
        if (file.GetRanges(a, step).front().Max > 0)
        {
          return true;
        }
      }
    }
  }
  return false;
}
}

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
  if (this->HasRegion || !this->LargeMesh || HasMarkedCells(*mesh.GetFile()))
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
    if (!this->HasRegion && HasMarkedCells(*mesh->GetFile()))
    {
      handle.Reason = "the file has ghost cells or hidden cells (vtkGhostType)";
    }
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
