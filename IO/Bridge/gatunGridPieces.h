// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGridPieces_h
#define gatunGridPieces_h

#include "gatunArrayBridge.h"
#include "gatunBridgedMesh.h"
#include "gatunFieldData.h"
#include "gatunMergeGrid.h"
#include "gatunPartExchange.h"
#include "gatunPartWriter.h"

#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkDataArray;
class vtkInformationIntegerKey;
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/**
 * Writes the pieces of a grid as parts of one file. All pieces come twice in the same order, first
 * for the survey, with all time steps of a piece one after the other.
 *
 * Ghost cells have been removed, and the marks of duplicate points are. Pieces without points and
 * cells are skipped. Points are joined by an array of numbers, if one is marked, by the global ids
 * of their piece, if it has any, or else by their coordinates. All pieces must have the same
 * arrays, in any order.
 *
 * Several processes can write their pieces into one file together: then OpenTogether and EndSurvey
 * are to be called, too.
 *
 * Methods throw gatun::Error.
 */
class GridPieces
{
public:
  /** select: the arrays of a piece to write. joinKey: marks the point array to join points by,
   * which is not written. All pieces with points must have one, or none. */
  GridPieces(const std::string& path, const PartWriterOptions& options,
    std::function<std::vector<BridgedArray>(vtkUnstructuredGrid*)> select,
    vtkInformationIntegerKey* joinKey);
  ~GridPieces();

  /** Tells whether the pieces are those of a surface. To be called before the first one is
   * surveyed, and before OpenTogether. */
  void SetIsSurface(bool isSurface) { this->Options.File.IsSurface = isSurface; }

  /** Asks for a hierarchy. To be called before the first piece is surveyed. */
  void SetHierarchy(const MergeWeights& weights) { this->Weights = weights; }

  /** Opens a file that all processes of an exchange write. To be called before Survey. piece: the
   * first one of this process, which may be empty. steps: the number of time steps. Collective, as
   * are EndSurvey and Finish. */
  void OpenTogether(PartExchange& exchange, vtkUnstructuredGrid* piece, std::size_t steps);

  /** To be called behind the survey of all pieces if the file was opened together. */
  void EndSurvey();

  /** Looks at a step of a piece. isFirst: whether it is the first step of that piece. */
  void Survey(vtkUnstructuredGrid* piece, bool isFirst);

  /** A time step of a piece to write. */
  struct Step
  {
    FieldData Field;
    bool HasTime = false;
    double Time = 0;
    bool IsLast = true; ///< of its piece, which then is not needed any more
  };
  void Write(vtkUnstructuredGrid* piece, bool isFirst, const Step& step,
    const std::function<bool(double)>& progress);

  /** Completes the file. progress: of the hierarchy. */
  PartStatistics Finish(const std::function<bool(double)>& progress);

  /** Whether integer coordinates were converted to double. */
  bool ArePointsConverted() const { return this->PointsConverted; }

private:
  /** A piece as the core takes it. */
  struct Input
  {
    vtkSmartPointer<vtkUnstructuredGrid> Grid;
    std::unique_ptr<BridgedMesh> Mesh;
    std::vector<BridgedArray> Arrays; // in the order of the file
    std::vector<const void*> Values;
    std::vector<std::int64_t> Ids; // global ids of the points, if there are any

    const std::int64_t* GetIds() const { return this->Ids.empty() ? nullptr : this->Ids.data(); }
  };

  Input MakeInput(vtkUnstructuredGrid* piece, std::size_t number) const;
  vtkDataArray* FindMarked(vtkUnstructuredGrid* piece) const;
  std::vector<std::int64_t> FindIds(Input& input, std::size_t number) const;
  void SortArrays(Input& input, std::size_t number) const;
  void Open(const Input& input);
  bool IsEmpty(vtkUnstructuredGrid* piece, bool isFirst, std::size_t number);

  const std::string Path;
  PartWriterOptions Options;
  std::optional<MergeWeights> Weights; // of a hierarchy
  const std::function<std::vector<BridgedArray>(vtkUnstructuredGrid*)> Select;
  vtkInformationIntegerKey* const JoinKey;
  std::unique_ptr<PartWriter> File;
  bool WritesEmpty = false; // whether all pieces of all processes are empty, and this is the first
  std::vector<ArrayDescription> Arrays;
  std::size_t Surveyed = 0; // pieces, empty ones included
  std::size_t Written = 0;
  Fingerprint MeshHash; // of the piece that is being surveyed
  bool WasEmpty = false;
  bool PointsConverted = false;
  Input Current; // the piece that is being written, with the values of its first step
};
}

#endif
