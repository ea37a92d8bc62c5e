// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef vtkGatunWriterInternals_h
#define vtkGatunWriterInternals_h

#include "gatunArrayBridge.h"
#include "gatunBridgedMesh.h"
#include "gatunError.h"
#include "gatunErrorBound.h"
#include "gatunFileWriter.h"
#include "gatunFindCells.h"
#include "gatunGridPieces.h"
#include "gatunMergeGrid.h"
#include "gatunProcessExchange.h"
#include "gatunSeriesArrays.h"
#include "gatunStatistics.h"
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
    this->PointSelection->SetUnknownArraySetting(1);
    this->CellSelection->SetUnknownArraySetting(1);
    this->PublishStatistics({}, 0, 0);
  }

  void Warn(const std::string& what);
  std::function<bool(double)> MakeProgress(std::size_t part);
  double GetPartOfPieces() const;
  gatun::WriterOptions MakeOptions(vtkUnstructuredGrid* grid,
    const std::vector<gatun::BridgedArray>& arrays,
    std::unique_ptr<gatun::MergeTree>* tree = nullptr);

  // Lets the current time step have a mesh: one that was written, if it has the same cells, or a
  // new one, which takes the mesh over. Returns false if the points move, and the file is one whose
  // points do not.
  bool UseMesh(vtkUnstructuredGrid* grid, std::unique_ptr<gatun::BridgedMesh>& mesh,
    const std::vector<gatun::BridgedArray>& arrays);

  // The mesh as some of the cells of one that was written, with the file prepared for it.
  bool UseRemaining(const gatun::BridgedMesh& mesh);

  // Opens the file that steps are added to, if there is one.
  void BeginAppending();

  // Puts the arrays of a step into the order of the file. Returns false if the file has to have
  // more, and will be begun once more; the rest of the steps is then looked at before.
  bool ArrangeArrays(
    vtkUnstructuredGrid* grid, vtkDataObject* input, std::vector<gatun::BridgedArray>& arrays);

  // Begins the file once more, because the points of a step differ from those of the first one, or
  // because it has other arrays.
  void Restart();
  // One that is refused when the file is written if there is no such kind.
  static gatun::ErrorKind ToErrorKind(int kind)
  {
    return static_cast<gatun::ErrorKind>(
      kind >= 0 && kind <= TOLERANCE_BITS ? kind : TOLERANCE_BITS + 1);
  }

  gatun::ErrorBound GetPointBound() const;
  gatun::MergeTree BuildTree(vtkUnstructuredGrid* grid, bool isSurface);
  void PublishStatistics(
    const gatun::FileStatistics& statistics, std::uint64_t points, std::uint64_t cells);
  void BeginPieces(int pieces);
  // exchange: between the processes that write together, or null.
  void FinishPieces(const gatun::ProcessExchange* exchange);
  vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(vtkDataObject* input);
  std::vector<gatun::BridgedArray> SelectArrays(vtkUnstructuredGrid* grid);
  gatun::GridPieces::Step DescribeStep(vtkDataObject* input, vtkFieldData* fieldData);

  vtkGatunWriter* const Owner;
  vtkNew<vtkDataArraySelection> PointSelection;
  vtkNew<vtkDataArraySelection> CellSelection;
  gatun::MergeWeights Weights;
  std::vector<gatun::ArrayError> Tolerances; // as given

  // The times to write, if all time steps of the input are wanted, and the next one of them.
  std::vector<double> Times;
  std::size_t Step = 0;
  bool Writing = false; // whether Write is running

  // A mesh that more time steps can have.
  struct WrittenMesh
  {
    std::uint32_t Number = 0;
    gatun::Fingerprint CellHash; // the input may overwrite the memory of an earlier step
    gatun::Fingerprint PointHash;
    std::unique_ptr<gatun::BridgedMesh> Mesh;
    std::unique_ptr<gatun::MergeTree> Tree; // null without hierarchy
    bool IsOverwritten = false;             // its memory has another mesh now

    bool HasCells(const gatun::BridgedMesh& other, const gatun::Fingerprint& hash) const;
    bool SharesMemory(const gatun::BridgedMesh& other) const;
  };
  WrittenMesh MakeMesh(
    std::unique_ptr<gatun::BridgedMesh> mesh, const gatun::Fingerprint& cellHash) const;

  // While a file is being written.
  std::vector<WrittenMesh> Meshes;            // the first one and the one that was added last
  std::optional<gatun::FoundCells> Remaining; // if the step has some cells of one of them only
  std::unique_ptr<gatun::FileWriter> File;
  bool IsAppending = false;
  gatun::SeriesArrays Arrays;
  bool LooksAhead = false;                     // for more arrays in the steps to come
  bool PointsMove = false;                     // as a step has told
  bool IsRestarted = false;                    // for this reason, and not read again yet
  std::unique_ptr<gatun::MergeTree> FirstTree; // that of the first mesh, then
  std::uint64_t Points = 0;                    // of all meshes
  std::uint64_t Cells = 0;
  double PointError = 0;          // largest difference of a coordinate
  std::uint64_t JoinedPoints = 0; // points of pieces that are those of other pieces
  std::uint64_t BytesSent = 0;
  std::size_t LostGhosts = 0;   // of pieces
  gatun::Statistics Statistics; // of the last file
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
    this->IsAppending = false;
    this->Meshes.clear();
    this->Remaining.reset();
    this->FirstTree.reset();
    this->Arrays.Begin(
      this->Owner->FillMissingArrays, [this](const std::string& what) { this->Warn(what); });
    this->LooksAhead = false;
    this->Points = 0;
    this->Cells = 0;
    this->Warned.clear();
    this->LostGhosts = 0;
    this->IsSurface.reset();
    this->Step = 0;
    this->PointsMove = false;
    this->IsRestarted = false;
  }

  std::size_t GetNumberOfSteps() const { return std::max<std::size_t>(1, this->Times.size()); }
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
