// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunWriterInternals.h"

#include "gatunErrorBound.h"

#include "gatunCellInput.h"
#include "gatunDescriptionText.h"
#include "gatunError.h"
#include "gatunPointRounding.h"
#include "gatunReport.h"
#include "gatunRoundedGrid.h"
#include "gatunSurfaceGrid.h"
#include "gatunWriterArrays.h"
#include "vtkGatunCompat.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"
#include "vtksys/SystemTools.hxx"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

namespace
{

// Building a hierarchy takes about nine times as long as writing the rest.
constexpr double PartOfTree = 0.9;

} // anonymous namespace

//------------------------------------------------------------------------------
// Reports a warning once for each file.
void vtkGatunWriter::vtkInternals::Warn(const std::string& what)
{
  if (this->Warned.insert(what).second)
  {
    vtkWarningWithObjectMacro(this->Owner, << this->Owner->FileName << ": " << what);
  }
}

//------------------------------------------------------------------------------
// Reports progress of a part of the work. Part 0 is the mesh, part i + 1 is time step i.
std::function<bool(double)> vtkGatunWriter::vtkInternals::MakeProgress(std::size_t part)
{
  const double parts = static_cast<double>(this->GetNumberOfSteps()) + 1;
  return [this, part, parts](double fraction)
  {
    const double forTree = this->Owner->Hierarchy ? PartOfTree : 0;
    const double done = (static_cast<double>(part) + fraction) / parts;
    this->Owner->UpdateProgress(forTree + (1 - forTree) * done);
    return !gatun::IsAborted(this->Owner);
  };
}

//------------------------------------------------------------------------------
// The part of the progress that surveying and writing all pieces make.
double vtkGatunWriter::vtkInternals::GetPartOfPieces() const
{
  return this->Owner->Hierarchy ? 0.4 : 1;
}

//------------------------------------------------------------------------------
// The input as a grid that can be written, with warnings of what has changed.
vtkSmartPointer<vtkUnstructuredGrid> vtkGatunWriter::vtkInternals::MakeGrid(vtkDataObject* input)
{
  auto* const surface = vtkPolyData::SafeDownCast(input);
  vtkSmartPointer<vtkUnstructuredGrid> grid = vtkUnstructuredGrid::SafeDownCast(input);
  if (!surface && !grid)
  {
    gatun::ThrowInvalid("the input is neither a vtkUnstructuredGrid nor a vtkPolyData");
  }
  if (this->IsSurface.value_or(surface != nullptr) != (surface != nullptr))
  {
    gatun::ThrowInvalid("some of the input is a surface, and some is not");
  }
  this->IsSurface = surface != nullptr;
  if (surface)
  {
    if (this->Owner->SplitCells)
    {
      gatun::ThrowInvalid("a surface (vtkPolyData) has no 3D cells to split");
    }
    if (this->Owner->WriteBoundary)
    {
      gatun::ThrowInvalid("surfaces (vtkPolyData) have no boundary to write");
    }
    grid = gatun::MakeSurfaceGrid(surface);
  }
  // Pieces that are put together overlap in their ghost cells.
  const gatun::CellInput cells = gatun::MakeCellInput(grid, this->Owner->SplitCells,
    this->Pieces ? gatun::GhostCells::Remove : gatun::GhostCells::Keep);
  if (this->Pieces)
  {
    this->LostGhosts += this->Surveying && this->Step == 0 ? cells.GhostCells : 0;
  }
  else if (cells.GhostCells > 0)
  {
    this->Warn(gatun::DescribeLostGhosts(cells.GhostCells));
  }
  for (const std::string& warning : cells.Warnings)
  {
    this->Warn(warning);
  }
  return gatun::RoundGrid(
    cells.Grid, this->GetPointBound(), this->PieceCount == 1, this->PointError);
}

//------------------------------------------------------------------------------
// The arrays to write, with warnings of what a file cannot hold of them.
std::vector<gatun::BridgedArray> vtkGatunWriter::vtkInternals::SelectArrays(
  vtkUnstructuredGrid* grid)
{
  auto arrays = gatun::BridgeSelected(grid, this->PointSelection, this->CellSelection);
  for (const gatun::BridgedArray& array : arrays)
  {
    for (const std::string& key : array.RefusedKeys)
    {
      this->Warn("the key " + key + " of the array '" + array.Description.Name +
        "' is left out, because its type cannot be written");
    }
  }
  return arrays;
}

//------------------------------------------------------------------------------
gatun::ErrorBound vtkGatunWriter::vtkInternals::GetPointBound() const
{
  const gatun::ErrorBound bound{ ToErrorKind(this->Owner->PointToleranceKind),
    this->Owner->PointTolerance };
  gatun::CheckPointBound(bound);
  return bound;
}

//------------------------------------------------------------------------------
// tree: the hierarchy if it is there; receives it otherwise, if it is wanted. Null: without one.
gatun::WriterOptions vtkGatunWriter::vtkInternals::MakeOptions(vtkUnstructuredGrid* grid,
  const std::vector<gatun::BridgedArray>& arrays, std::unique_ptr<gatun::MergeTree>* tree)
{
  gatun::WriterOptions options;
  options.Keep = static_cast<std::uint8_t>(this->Owner->KeepOrder);
  options.ChunkSize = static_cast<std::uint32_t>(this->Owner->ChunkSize);
  options.Parts = static_cast<std::uint32_t>(this->PieceCount);
  options.KeyStepInterval = static_cast<std::uint32_t>(this->Owner->KeyStepInterval);
  options.IsSurface = this->IsSurface.value_or(false);
  options.PointsMove = this->PointsMove;
  options.Errors = this->Tolerances;
  options.Coding =
    this->Owner->Profile == PROFILE_FAST ? gatun::Profile::Fast : gatun::Profile::Small;
  options.Boundary = this->Owner->WriteBoundary;
  if (!this->Owner->LayerArray.empty())
  {
    options.Layers =
      gatun::FindLayerArray(arrays, this->Owner->LayerArray, this->Owner->LayerComponent);
    options.Layers->Count = static_cast<std::uint32_t>(this->Owner->NumberOfLayers);
    options.Layers->Spacing = static_cast<gatun::LayerSpacing>(this->Owner->LayerSpacing);
  }
  if (this->Owner->Hierarchy && tree)
  {
    if (!*tree)
    {
      *tree = std::make_unique<gatun::MergeTree>(this->BuildTree(grid, options.IsSurface));
    }
    options.Tree = tree->get();
    options.Dependencies = this->Owner->Hierarchy == vtkGatunWriter::HIERARCHY_WITH_DEPENDENCIES;
    options.Levels = static_cast<unsigned>(this->Owner->Levels);
  }
  return options;
}

//------------------------------------------------------------------------------
gatun::MergeTree vtkGatunWriter::vtkInternals::BuildTree(vtkUnstructuredGrid* grid, bool isSurface)
{
  const auto progress = [this](double fraction)
  {
    if (this->Meshes.empty()) // progress does not go back for other meshes
    {
      this->Owner->UpdateProgress(PartOfTree * fraction);
    }
    return !gatun::IsAborted(this->Owner);
  };
  return isSurface ? gatun::BuildSurfaceMergeTree(grid, this->Weights, {}, progress)
                   : gatun::BuildMergeTree(grid, this->Weights, {}, progress);
}

//------------------------------------------------------------------------------
bool vtkGatunWriter::vtkInternals::WrittenMesh::HasCells(
  const gatun::BridgedMesh& other, const gatun::Fingerprint& hash) const
{
  const gatun::MeshInput& mine = this->Mesh->Mesh;
  const gatun::MeshInput& others = other.Mesh;
  return others.Points == mine.Points && others.Cells == mine.Cells &&
    others.CoordinateType == mine.CoordinateType && others.WideIds == mine.WideIds &&
    hash == this->CellHash;
}

//------------------------------------------------------------------------------
// Whether the input has changed its arrays in place.
bool vtkGatunWriter::vtkInternals::WrittenMesh::SharesMemory(const gatun::BridgedMesh& other) const
{
  const gatun::MeshInput& mine = this->Mesh->Mesh;
  const gatun::MeshInput& others = other.Mesh;
  return (mine.Coordinates && mine.Coordinates == others.Coordinates) ||
    (mine.Connectivity && mine.Connectivity == others.Connectivity);
}

//------------------------------------------------------------------------------
vtkGatunWriter::vtkInternals::WrittenMesh vtkGatunWriter::vtkInternals::MakeMesh(
  std::unique_ptr<gatun::BridgedMesh> mesh, const gatun::Fingerprint& cellHash) const
{
  WrittenMesh written;
  written.CellHash = cellHash;
  if (this->GetNumberOfSteps() > 1)
  {
    written.PointHash = mesh->HashPoints();
  }
  written.Mesh = std::move(mesh);
  if (this->PointsMove && written.Mesh->Coordinates)
  {
    // The input may change its points in place, and the first ones are needed until the end.
    auto points = vtk::TakeSmartPointer(written.Mesh->Coordinates->NewInstance());
    points->DeepCopy(written.Mesh->Coordinates);
    written.Mesh->Coordinates = points;
    written.Mesh->Mesh.Coordinates = points->GetVoidPointer(0);
  }
  return written;
}

//------------------------------------------------------------------------------
bool vtkGatunWriter::vtkInternals::UseMesh(vtkUnstructuredGrid* grid,
  std::unique_ptr<gatun::BridgedMesh>& mesh, const std::vector<gatun::BridgedArray>& arrays)
{
  this->Remaining.reset();
  const auto cellHash = this->GetNumberOfSteps() > 1 ? mesh->HashCells() : gatun::Fingerprint();
  for (const WrittenMesh& written : this->Meshes)
  {
    if (!written.IsOverwritten && written.HasCells(*mesh, cellHash))
    {
      if (!this->PointsMove && mesh->HashPoints() != written.PointHash)
      {
        this->PointsMove = true;
        return false;
      }
      this->File->UseMesh(written.Number);
      return true;
    }
  }
  if (this->UseRemaining(*mesh))
  {
    const bool isRead = this->PointsMove || !this->Remaining->HaveMoved;
    this->PointsMove = this->PointsMove || this->Remaining->HaveMoved;
    return isRead;
  }
  for (WrittenMesh& written : this->Meshes)
  {
    written.IsOverwritten = written.IsOverwritten || written.SharesMemory(*mesh);
  }
  this->Points += mesh->Mesh.Points;
  this->Cells += mesh->Mesh.Cells;
  WrittenMesh added = this->MakeMesh(std::move(mesh), cellHash);
  if (this->Meshes.empty())
  {
    added.Tree = std::move(this->FirstTree);
  }
  const gatun::WriterOptions options = this->MakeOptions(grid, arrays, &added.Tree);
  const auto progress = this->MakeProgress(this->Step);
  if (!this->File)
  {
    std::vector<gatun::ArrayDescription> descriptions;
    for (const gatun::BridgedArray& array : arrays)
    {
      descriptions.push_back(array.Description);
    }
    this->File = std::make_unique<gatun::FileWriter>(
      this->Owner->FileName, added.Mesh->Mesh, descriptions, options, progress);
  }
  else
  {
    added.Number = this->File->AddMesh(added.Mesh->Mesh, options, progress);
    // The mesh that was added before is complete, and so are those of a file.
    this->Meshes.resize(this->IsAppending ? 0 : 1);
  }
  this->Meshes.push_back(std::move(added));
  return true;
}

//------------------------------------------------------------------------------
bool vtkGatunWriter::vtkInternals::UseRemaining(const gatun::BridgedMesh& mesh)
{
  if (this->Owner->Hierarchy || this->Owner->WriteBoundary)
  {
    return false; // they are those of a mesh with all cells
  }
  for (const WrittenMesh& written : this->Meshes)
  {
    // The input may have changed the arrays of an earlier step in place.
    const bool isIntact = !written.IsOverwritten && mesh.Mesh.Cells < written.Mesh->Mesh.Cells &&
      written.Mesh->HashCells() == written.CellHash &&
      written.Mesh->HashPoints() == written.PointHash;
    this->Remaining = isIntact ? gatun::FindCells(written.Mesh->Mesh, mesh.Mesh) : std::nullopt;
    if (this->Remaining)
    {
      this->File->UseMesh(written.Number);
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkGatunWriter::vtkInternals::BeginAppending()
{
  if (!this->Owner->Append || this->File || !vtksys::SystemTools::FileExists(this->Owner->FileName))
  {
    return;
  }
  this->File =
    std::make_unique<gatun::FileWriter>(gatun::FileWriter::Append(), this->Owner->FileName);
  this->Arrays.Continue(this->File->GetArrays());
  this->IsAppending = true;
}

//------------------------------------------------------------------------------
bool vtkGatunWriter::vtkInternals::ArrangeArrays(
  vtkUnstructuredGrid* grid, vtkDataObject* input, std::vector<gatun::BridgedArray>& arrays)
{
  gatun::SeriesArrays::Step step;
  step.Points = static_cast<std::size_t>(grid->GetNumberOfPoints());
  step.Cells = static_cast<std::size_t>(grid->GetNumberOfCells());
  if (!this->Times.empty())
  {
    vtkInformation* const info = input->GetInformation();
    const char* const name = info->Get(vtkCompositeDataSet::NAME()); // such as that of a file
    step.Name = "time step " + std::to_string(this->Step) + " (time " +
      gatun::DescribeNumber(this->Times[this->Step]) +
      (name ? ", " + gatun::MakePrintableLine(name) : "") + ")";
  }
  const bool areKnown = this->Arrays.Learn(arrays, step) || !this->File;
  if (this->LooksAhead || !areKnown)
  {
    this->LooksAhead = true;
    return false;
  }
  arrays = this->Arrays.Arrange(arrays, step);
  return true;
}

//------------------------------------------------------------------------------
void vtkGatunWriter::vtkInternals::Restart()
{
  this->File.reset();
  this->FirstTree = std::move(this->Meshes.front().Tree);
  this->Meshes.clear();
  this->Remaining.reset();
  this->Points = 0;
  this->Cells = 0;
  this->Step = 0;
  this->LooksAhead = false;
  this->IsRestarted = true;
}

//------------------------------------------------------------------------------
void vtkGatunWriter::vtkInternals::PublishStatistics(
  const gatun::FileStatistics& statistics, std::uint64_t points, std::uint64_t cells)
{
  std::uint64_t arrayBytes = 0;
  for (const std::uint64_t bytes : statistics.ArrayBytes)
  {
    arrayBytes += bytes;
  }
  const bool isWritten = statistics.FileBytes > 0;
  gatun::Statistics& table = this->Statistics;
  table.Clear();
  table.Add("Points", points);
  table.Add("Cells", cells);
  table.Add(
    "Meshes", std::uint64_t{ this->Meshes.empty() ? isWritten : this->Meshes.back().Number + 1 });
  table.Add("TimeSteps", std::uint64_t{ isWritten ? this->GetNumberOfSteps() : 0 });
  table.Add("FileBytes", statistics.FileBytes);
  table.Add("ConnectivityBytes", statistics.ConnectivityBytes);
  table.Add("GeometryBytes",
    statistics.GeometryBytes + statistics.SharedGeometryBytes + statistics.MotionBytes);
  table.Add("OrderBytes", statistics.OrderBytes);
  table.Add("ArrayBytes", arrayBytes);
  table.Add("FieldDataBytes", statistics.FieldDataBytes);
  table.Add("HierarchyBytes", statistics.TreeBytes);
  table.Add("DependencyBytes", statistics.DependencyBytes);
  table.Add("LevelBytes", statistics.LevelBytes);
  table.Add("BoundaryBytes", statistics.BoundaryBytes);
  table.Add("OtherMeshBytes", statistics.OtherMeshBytes);
  table.Add("DirectoryBytes", statistics.DirectoryBytes);
  table.Add("PointError", this->PointError);
  table.Add("JoinedPoints", this->JoinedPoints);
  table.Add("BytesSent", this->BytesSent);
}

//------------------------------------------------------------------------------
gatun::GridPieces::Step vtkGatunWriter::vtkInternals::DescribeStep(
  vtkDataObject* input, vtkFieldData* fieldData)
{
  gatun::GridPieces::Step step;
  std::vector<std::string> refused;
  step.Field = gatun::BridgeFieldData(fieldData, refused);
  for (const std::string& what : refused)
  {
    this->Warn(what + " is left out, because its type cannot be written");
  }
  vtkInformation* info = input->GetInformation();
  const bool hasSteps = !this->Times.empty();
  step.HasTime = hasSteps || info->Has(vtkDataObject::DATA_TIME_STEP());
  step.Time = hasSteps ? this->Times[this->Step]
    : step.HasTime     ? info->Get(vtkDataObject::DATA_TIME_STEP())
                       : 0.0;
  step.IsLast = this->Step + 1 == this->GetNumberOfSteps();
  return step;
}

//------------------------------------------------------------------------------
void vtkGatunWriter::vtkInternals::BeginPieces(int pieces)
{
  this->PieceCount = pieces;
  const vtkGatunWriter* owner = this->Owner;
  if (owner->Append)
  {
    gatun::ThrowInvalid("steps are added to a file from the whole mesh, in one piece and one "
                        "process");
  }
  if (!owner->LayerArray.empty())
  {
    gatun::ThrowInvalid("layers need the whole mesh in one piece and one process; write the file "
                        "without them, and add them with 'gtn pack --layers'");
  }
  if (owner->Hierarchy && this->IsTogether)
  {
    gatun::ThrowInvalid("a hierarchy needs all pieces in one process; write the file without it, "
                        "and add it with 'gtn pack --hierarchy'");
  }
  if (owner->WriteBoundary && this->IsTogether)
  {
    gatun::ThrowInvalid("the boundary needs all pieces in one process; write the file without it, "
                        "and add it with 'gtn pack --boundary'");
  }
  const gatun::ErrorKind rounding = this->GetPointBound().Kind;
  if (rounding == gatun::ErrorKind::Relative || rounding == gatun::ErrorKind::Bits)
  {
    gatun::ThrowInvalid(
      "a number of bits, or a relative tolerance of coordinates, needs the bounds "
      "of the whole mesh, in one piece and one process; give an absolute one");
  }
  gatun::PartWriterOptions options;
  options.File = this->MakeOptions(nullptr, {});
  options.File.Levels = owner->Hierarchy ? static_cast<unsigned>(owner->Levels) : 0;
  options.File.Dependencies = owner->Hierarchy == vtkGatunWriter::HIERARCHY_WITH_DEPENDENCIES;
  this->Pieces = std::make_unique<gatun::GridPieces>(
    owner->FileName ? owner->FileName : "", options,
    [this](vtkUnstructuredGrid* piece) { return this->SelectArrays(piece); },
    vtkGatunWriter::JOIN_POINTS());
  if (owner->Hierarchy)
  {
    this->Pieces->SetHierarchy(this->Weights);
  }
}

//------------------------------------------------------------------------------
void vtkGatunWriter::vtkInternals::FinishPieces(const gatun::ProcessExchange* exchange)
{
  const gatun::PartStatistics statistics = this->Pieces->Finish(
    [this](double fraction)
    {
      const double before = this->GetPartOfPieces();
      this->Owner->UpdateProgress(before + (1 - before) * fraction);
      return !gatun::IsAborted(this->Owner);
    });
  this->BytesSent = exchange ? exchange->GetBytesSent() : 0;
  if (this->Pieces->ArePointsConverted())
  {
    this->Warn("integer coordinates are written as double");
  }
  const bool isFirst = !this->IsTogether || this->Piece == 0; // all processes know the numbers
  if (this->LostGhosts > 0)                                   // of the pieces of this process
  {
    this->Warn(gatun::DescribeLostGhosts(this->LostGhosts));
  }
  if (isFirst && statistics.DifferentPoints > 0)
  {
    this->Warn(std::to_string(statistics.DifferentPoints) +
      " points of a piece are where another piece has one with other values, or have its global "
      "id elsewhere, and are kept apart");
  }
  if (isFirst && statistics.AmbiguousPoints > 0)
  {
    this->Warn(std::to_string(statistics.AmbiguousPoints) +
      " points are kept apart, because several points of a piece are where another piece has one; "
      "with global ids they would be joined");
  }
  this->JoinedPoints = statistics.JoinedPoints;
  this->PublishStatistics(statistics.File, statistics.Points, statistics.Cells);
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
