// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunTetrahedralize.h"

#include "gatunNewArray.h"
#include "gatunTetGen.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkCleanPolyData.h"
#include "vtkErrorCode.h"
#include "vtkFeatureEdges.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataConnectivityFilter.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunTetrahedralize);

namespace
{

using gatun::TetGenError;

void CheckFinite(vtkPolyData* surface)
{
  double p[3];
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    surface->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      throw TetGenError("the surface has a coordinate that is not finite");
    }
  }
}

// Returns triangles without coincident points and without degenerate triangles.
vtkSmartPointer<vtkPolyData> CleanTriangles(vtkPolyData* surface)
{
  vtkNew<vtkPolyData> polygons;
  polygons->SetPoints(surface->GetPoints());
  polygons->SetPolys(surface->GetPolys());
  polygons->SetStrips(surface->GetStrips());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(polygons);
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(triangles->GetOutputPort());
  clean->SetTolerance(0);
  clean->ConvertPolysToLinesOff();
  clean->ConvertStripsToPolysOff();
  clean->SetOutputPointsPrecision(vtkAlgorithm::DEFAULT_PRECISION);
  clean->Update();
  return clean->GetOutput();
}

vtkIdType CountEdges(vtkPolyData* triangles, bool boundary)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(triangles);
  edges->SetBoundaryEdges(boundary);
  edges->SetNonManifoldEdges(!boundary);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

void CheckClosed(vtkPolyData* triangles)
{
  if (triangles->GetNumberOfPolys() == 0)
  {
    throw TetGenError("the surface has no triangles");
  }
  constexpr vtkIdType limit = std::numeric_limits<int>::max() / 8;
  if (triangles->GetNumberOfPoints() > limit || triangles->GetNumberOfPolys() > limit)
  {
    throw TetGenError("the surface is too large for TetGen, which counts with 32 bits");
  }
  if (const vtkIdType open = CountEdges(triangles, true))
  {
    throw TetGenError("the surface is not closed: " + std::to_string(open) +
      (open == 1 ? " edge has" : " edges have") + " one triangle only");
  }
  if (const vtkIdType excess = CountEdges(triangles, false))
  {
    throw TetGenError("the surface is not a manifold: " + std::to_string(excess) +
      (excess == 1 ? " edge has" : " edges have") + " more than two triangles");
  }
}

bool HasSeveralComponents(vtkPolyData* triangles)
{
  vtkNew<vtkPolyDataConnectivityFilter> components;
  components->SetInputData(triangles);
  components->SetExtractionModeToAllRegions();
  components->Update();
  return components->GetNumberOfExtractedRegions() > 1;
}

gatun::TetGenSurface ToTetGen(vtkPolyData* triangles)
{
  gatun::TetGenSurface surface;
  surface.Points.resize(3 * triangles->GetNumberOfPoints());
  for (vtkIdType i = 0; i < triangles->GetNumberOfPoints(); ++i)
  {
    triangles->GetPoint(i, surface.Points.data() + 3 * i);
  }
  surface.Triangles.reserve(triangles->GetNumberOfPolys());
  vtkCellArray* polys = triangles->GetPolys();
  vtkIdType size;
  const vtkIdType* ids;
  for (polys->InitTraversal(); polys->GetNextCell(size, ids);)
  {
    surface.Triangles.push_back(
      { static_cast<int>(ids[0]), static_cast<int>(ids[1]), static_cast<int>(ids[2]) });
  }
  return surface;
}

void FillOutput(const gatun::TetGenMesh& mesh, int pointType, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  gatun::SizePoints(points, static_cast<vtkIdType>(mesh.Points.size() / 3));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, mesh.Points.data() + 3 * i);
  }

  vtkNew<vtkIdTypeArray> connectivity;
  gatun::SizeArray(connectivity, static_cast<vtkIdType>(4 * mesh.Tets.size()));
  vtkIdType* target = connectivity->GetPointer(0);
  for (const auto& tet : mesh.Tets)
  {
    target = std::copy(tet.begin(), tet.end(), target);
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(4, connectivity);
  output->SetPoints(points);
  output->SetCells(VTK_TETRA, cells);
}

// TetGen expects a decimal point in every locale and does not accept exponents everywhere.
std::string ToText(double value)
{
  char text[400];
  const auto end = std::to_chars(text, text + sizeof(text), value, std::chars_format::fixed);
  return { text, end.ptr };
}

void CheckSwitches(std::string_view switches)
{
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                       "0123456789./-+";
  // These read or write files, or change the kind of output.
  constexpr std::string_view refused = "cdfgikmnorswv";
  if (switches.size() > 200 || switches.find_first_not_of(allowed) != switches.npos ||
    switches.find_first_of(refused) != switches.npos)
  {
    throw TetGenError(
      "the switches \"" + std::string(switches.substr(0, 200)) + "\" cannot be used here");
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
vtkGatunTetrahedralize::vtkGatunTetrahedralize() = default;

//------------------------------------------------------------------------------
vtkGatunTetrahedralize::~vtkGatunTetrahedralize()
{
  this->SetSwitches(nullptr);
}

//------------------------------------------------------------------------------
void vtkGatunTetrahedralize::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "MinDihedral: " << this->MinDihedral << "\n";
  os << indent << "MaximumVolume: " << this->MaximumVolume << "\n";
  os << indent << "PreserveSurface: " << (this->PreserveSurface ? "On" : "Off") << "\n";
  os << indent << "Switches: " << (this->Switches ? this->Switches : "(none)") << "\n";
  os << indent << "Quiet: " << (this->Quiet ? "On" : "Off") << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}

//------------------------------------------------------------------------------
int vtkGatunTetrahedralize::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunTetrahedralize::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    if (this->Quality > 0 && this->Quality < 1)
    {
      throw TetGenError("a quality of " + ToText(this->Quality) +
        " cannot be reached; ask for 1 "
        "or more, or for 0 (none)");
    }
    std::string switches = this->Quiet ? "pzQ" : "pz";
    if (this->Quality > 0 || this->MinDihedral > 0)
    {
      switches.append("q").append(ToText(this->Quality > 0 ? this->Quality : 100));
      if (this->MinDihedral > 0)
      {
        switches.append("/").append(ToText(this->MinDihedral));
      }
    }
    if (this->MaximumVolume > 0)
    {
      switches.append("a").append(ToText(this->MaximumVolume));
    }
    if (this->PreserveSurface)
    {
      switches += "YM";
    }
    if (this->Switches)
    {
      CheckSwitches(this->Switches);
      switches += this->Switches;
    }

    CheckFinite(input);
    vtkSmartPointer<vtkPolyData> triangles = CleanTriangles(input);
    CheckClosed(triangles);
    this->UpdateProgress(0.05);
    const gatun::TetGenSurface surface = ToTetGen(triangles);
    // TetGen does not report progress; approach 1 asymptotically.
    double progress = 0.05;
    gatun::TetGenRun run;
    run.Switches = switches;
    run.Quiet = this->Quiet;
    run.KeepGoing = [this, &progress]
    {
      progress += (0.95 - progress) / 300;
      this->UpdateProgress(progress);
      return !this->GetAbortExecute();
    };
    gatun::TetGenHoles holes;
    if (HasSeveralComponents(triangles))
    {
      holes = gatun::FindCavities(surface, run);
    }
    const gatun::TetGenMesh mesh = gatun::RunTetGen(surface, holes, run);
    this->UpdateProgress(0.95);

    int pointType = triangles->GetPoints()->GetDataType() == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT;
    if (this->OutputPointsPrecision != DEFAULT_PRECISION)
    {
      pointType = this->OutputPointsPrecision == DOUBLE_PRECISION ? VTK_DOUBLE : VTK_FLOAT;
    }
    FillOutput(mesh, pointType, output);
    this->UpdateProgress(1);
    return 1;
  }
  catch (const gatun::TetGenStopped&)
  {
    output->Initialize();
    return 1;
  }
  catch (const TetGenError& error)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro(<< error.what() << ".");
  }
  catch (const std::bad_alloc&)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro("Not enough memory to fill the surface.");
  }
  catch (const std::exception& error)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro(<< "The surface cannot be filled: " << error.what() << ".");
  }
  output->Initialize();
  return 0;
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
