// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPieceReader_h
#define gatunPieceReader_h

#include "gatunFaceStream.h"
#include "gatunPieceDecoder.h"
#include "gatunPublishedFile.h"
#include "vtkGatunIOModule.h" // For export macro

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkCellArray;
class vtkDataObject;
class vtkIdTypeArray;
class vtkInformation;
class vtkPoints;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** A request of a pipeline. */
struct PortRequest
{
  int Piece = 0;
  int Pieces = 1;
  unsigned GhostLevels = 0;
  std::size_t Step = 0;

  /** Takes it from the information of an output. */
  VTKGATUNIO_EXPORT PortRequest(const FileReader& file, vtkInformation* outInfo);
};

/**
 * Reads pieces of an open file into grids. It keeps the mesh that was read last, which other arrays
 * and time steps share. Methods throw Error. Exported for the filters.
 */
class VTKGATUNIO_EXPORT PieceReader
{
public:
  using Progress = std::function<bool(double)>;

  /** The types and faces of cells that are not all tetrahedra. */
  struct OriginalCells
  {
    vtkSmartPointer<vtkUnsignedCharArray> Types;
    FaceStream Faces;
  };

  PieceReader();
  ~PieceReader();
  PieceReader(const PieceReader&) = delete;
  PieceReader& operator=(const PieceReader&) = delete;

  /** Chooses the mesh in the file that is decoded for a number of merges: the whole mesh or a base
   * mesh. KeepsChunks: whether decoded chunks stay in the cache of the file. */
  void Choose(const PublishedFile& handle, std::size_t merges, bool keepsChunks = true)
  {
    this->Choose(handle, FindPlace(handle, merges), nullptr, keepsChunks);
  }
  static SharedFile::Place FindPlace(const PublishedFile& handle, std::size_t merges);

  /** The same for such a mesh. Layout: of its merges, if it is known, or of those of a cut. */
  void Choose(const PublishedFile& handle, const SharedFile::Place& place,
    std::shared_ptr<const CoarseLayout> layout, bool keepsChunks);

  /** Chooses the boundary in the file after some of its merges. Requests for it are made by
   * MakeBoundaryRequest. */
  void ChooseBoundary(const PublishedFile& handle, std::size_t merges);

  /** The mesh that was chosen, and the number of merges from there. */
  const FileReader& GetMesh() const { return *this->Parts->GetFile(); }
  std::size_t GetMerges() const { return this->Merges; }

  /** Its decoded parts. */
  const std::shared_ptr<ChunkCache>& GetCache() const { return this->Parts; }

  /** The request for the part of the chosen mesh that a port is asked for. Chunks: those of the
   * region of interest, ascending. */
  PieceRequest MakeRequest(const PublishedFile& handle, const PortRequest& port,
    const std::vector<std::uint32_t>& chunks) const;

  /** The request for the part of the boundary that a port is asked for. */
  PieceRequest MakeBoundaryRequest(const PublishedFile& handle, const PortRequest& port) const;

  /** Reads. GlobalIds: whether to make global ids where the output has none; they are marked as
   * hidden unless the handle's reader was told to make them. */
  void Read(const PublishedFile& handle, const PieceRequest& request, bool globalIds,
    vtkUnstructuredGrid* output, const Progress& progress);

  bool HasMesh() const { return this->Mesh != nullptr; }

  /** Frees the mesh that was read last. */
  void ForgetMesh();

  /** Removes the decoded parts of the mesh that was chosen last from the cache, for all consumers.
   */
  void ClearCache();

  /** Lets go of the file. */
  void Close();

  /** Meshes of chunks that were decoded for this object. */
  std::uint64_t GetDecodedChunks() const;

private:
  void SetMesh(
    const PublishedFile& handle, const std::shared_ptr<const FileReader>& mesh, bool keepsChunks);
  bool HasMeshOf(const PieceRequest& request) const;
  vtkSmartPointer<vtkPoints> MakePoints(const FileReader& file, PieceTarget& target) const;
  void MakeMesh(const FileReader& file, PieceTarget& target);
  void FinishMesh();
  void MakeGhosts(PieceTarget& target);

  // The mesh that is decoded.
  std::shared_ptr<ChunkCache> Parts;
  std::shared_ptr<const MergeTree> Tree;
  std::shared_ptr<const CoarseLayout> Layout; // null: none, or not known
  std::size_t Merges = 0;
  bool KeepsChunks = true;
  std::uint64_t DecodedBefore = 0; // by other views

  // The mesh last read, which other steps and arrays share.
  std::unique_ptr<PieceDecoder> Decoder;
  PieceRequest MeshRequest;
  std::optional<std::size_t> PointStep; // that has the points of the mesh
  vtkSmartPointer<vtkUnstructuredGrid> Mesh;
  vtkSmartPointer<vtkCellArray> Cells; // until they are complete
  OriginalCells Original;
  vtkSmartPointer<vtkIdTypeArray> PointIds;
  vtkSmartPointer<vtkIdTypeArray> CellIds;
  vtkSmartPointer<vtkUnsignedCharArray> PointGhosts;
  vtkSmartPointer<vtkUnsignedCharArray> CellGhosts;
};

/** Adds the field data of a step of a file to a grid. */
void AddStepFieldData(const FileReader& file, std::size_t step, vtkUnstructuredGrid* output);

/** Sets the time of a step of a file in the information of an output. */
VTKGATUNIO_EXPORT void SetStepTime(const FileReader& file, std::size_t step, vtkDataObject* output);
}

#endif
