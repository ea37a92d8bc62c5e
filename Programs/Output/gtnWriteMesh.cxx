// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnWriteMesh.h"

#include "gtnFailure.h"
#include "gtnProgress.h"
#include "gtnSettings.h"
#include "gtnText.h"
#include "gtnWriteGatun.h"

#include "vtkUnstructuredGrid.h"

#include <fmt/core.h>

#include <filesystem>

namespace gtn
{
const char* const MeshFormats = ".gtn .vtu .vtk";

//------------------------------------------------------------------------------
void CheckMeshName(const std::string& file)
{
  const std::string extension = ExtensionOf(file);
  if (extension != ".gtn" && extension != ".vtu" && extension != ".vtk")
  {
    throw UsageError(file + ": the name must end in .gtn, .vtu or .vtk");
  }
}

//------------------------------------------------------------------------------
void WriteMesh(vtkUnstructuredGrid* grid, const std::string& file, const Settings& settings,
  Compressor compressor)
{
  {
    Progress progress("writing", settings.ShowProgress);
    if (ExtensionOf(file) == ".gtn")
    {
      WriteGatun(grid, file, progress);
    }
    else
    {
      WriteGrid(grid, file, compressor, progress);
    }
  }
  if (!settings.Quiet)
  {
    fmt::print("{}: {} tetrahedra, {} points, {}\n", file, GroupDigits(grid->GetNumberOfCells()),
      GroupDigits(grid->GetNumberOfPoints()), DescribeByteSize(std::filesystem::file_size(file)));
  }
}
}
