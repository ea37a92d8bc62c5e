// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef vtkGatunWriterInternals_h
#define vtkGatunWriterInternals_h

#include "gatunArrayBridge.h"
#include "gatunBridgedMesh.h"
#include "gatunError.h"
#include "gatunFileWriter.h"
#include "gatunGridPieces.h"
#include "gatunMergeGrid.h"
#include "vtkGatunWriter.h"

#include "vtkDataArraySelection.h"
#include "vtkNew.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkFieldData;

class vtkGatunWriter::vtkInternals
{
public:
  explicit vtkInternals(vtkGatunWriter* owner)
    : Owner(owner)
  {
  }

  void Warn(const std::string& what);
  std::function<bool(double)> MakeProgress(std::size_t part);
  gatun::WriterOptions MakeOptions(
    vtkUnstructuredGrid* grid, const std::vector<gatun::BridgedArray>& arrays);
  void PublishStatistics(
    const gatun::FileStatistics& statistics, std::uint64_t points, std::uint64_t cells);
  void BeginPieces(int pieces);
  void FinishPieces();
  vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(vtkDataObject* input);
  gatun::GridPieces::Step DescribeStep(vtkDataObject* input, vtkFieldData* fieldData);

  vtkGatunWriter* const Owner;
  vtkNew<vtkDataArraySelection> PointSelection;
  vtkNew<vtkDataArraySelection> CellSelection;
  gatun::MergeWeights Weights;
  std::vector<std::string> Errors; // of arrays, as given

  // The times to write, if all time steps of the input are wanted, and the next one of them.
  std::vector<double> Times;
  std::size_t Step = 0;
  bool Writing = false; // whether Write is running

  // While a file is being written.
  std::unique_ptr<gatun::FileWriter> File;
  std::unique_ptr<gatun::BridgedMesh> Mesh;
  std::size_t CellHash = 0;
  std::size_t PointHash = 0;
  bool PointsMove = false; // as a step has told
  bool IsRestarted = false;
  std::vector<gatun::ArrayDescription> Arrays;
  gatun::MergeTree Tree;
  std::set<std::string> Warned;
  std::optional<bool> IsSurface; // once there is an input

  // While pieces are being written.
  std::unique_ptr<gatun::GridPieces> Pieces;
  int Piece = 0;
  int PieceCount = 1;
  bool Surveying = false;
  bool AreTimesKnown = false;

  // If several processes write the file: the input of this one, or the failure to get it.
  bool IsTogether = false;
  vtkSmartPointer<vtkDataObject> Input;

  void Discard()
  {
    this->Pieces.reset();
    this->AreTimesKnown = false;
    this->Piece = 0;
    this->PieceCount = 1;
    this->IsTogether = false;
    this->Input = nullptr;
    this->File.reset();
    this->Mesh.reset();
    this->Arrays.clear();
    this->Tree = {};
    this->Warned.clear();
    this->IsSurface.reset();
    this->Step = 0;
    this->PointsMove = false;
    this->IsRestarted = false;
  }

  std::size_t GetNumberOfSteps() const { return std::max<std::size_t>(1, this->Times.size()); }

  // Begins the file once more, because the points of a step differ from those of the first one.
  void Restart()
  {
    this->File.reset();
    this->Mesh.reset();
    this->Step = 0;
    this->PointsMove = true;
    this->IsRestarted = true;
  }

  // Throws unless a time step has the cells and the arrays of the first one.
  void CheckUnchanged(
    const gatun::BridgedMesh& mesh, const std::vector<gatun::ArrayDescription>& arrays) const
  {
    const std::string step = " in time step " + std::to_string(this->Step) + " (time " +
      std::to_string(this->Times[this->Step]) + ")";
    const gatun::MeshInput& first = this->Mesh->Mesh;
    const gatun::MeshInput& now = mesh.Mesh;
    if (now.Points != first.Points || now.Cells != first.Cells ||
      now.CoordinateType != first.CoordinateType || now.WideIds != first.WideIds ||
      mesh.HashCells() != this->CellHash)
    {
      gatun::ThrowInvalid("the number of points or the cells change" + step +
        "; one file has the same cells at all time steps, so write such steps as a series of "
        "files");
    }
    if (arrays != this->Arrays)
    {
      gatun::ThrowInvalid("the point or cell arrays change" + step);
    }
  }
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
