// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnSpooledMesh_h
#define gtnSpooledMesh_h

// A mesh that is read by ranges, as compact pieces on the disk.

#include "gtnPieceRouter.h"
#include "gtnRangedMesh.h"
#include "gtnSpool.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkCellArray;
class vtkDataArray;
class vtkUnsignedCharArray;
class vtkUnstructuredGrid;

namespace gtn
{
class SpoolCursor;

/** How a mesh is divided. */
struct SpoolSettings
{
  std::string Name;             ///< of the mesh, for messages
  std::string Folder;           ///< of the temporary file
  std::uint64_t Memory = 0;     ///< for the work, in bytes
  std::uint64_t Reserved = 0;   ///< what the program takes beside, for messages
  std::uint64_t PieceBytes = 0; ///< about the largest piece in memory with a time step
  std::size_t Pieces = 1;       ///< the least number of them

  /** Whether cells shall be split into tetrahedra. If any is none, pieces have the array
   * OriginalCellIds of vtkGatunWriter, with numbers of cells of the whole mesh. */
  bool Split = false;
};

/** The name of the point array by which pieces are joined (vtkGatunWriter::JOIN_POINTS): the
 * numbers of points in the whole mesh, or -1 if no other piece has the point. */
inline constexpr const char* JoinArrayName = "gtn: point of the whole mesh";

/**
 * Divides a mesh into pieces that are compact in space, and writes them into a temporary file of
 * about the size of the mesh with all time steps. The order of points and cells of the mesh may be
 * any: it is only read from its begin to its end. Points are read twice, cells twice, and values
 * once.
 *
 * Memory: 2 bytes for each point and some 10 MiB, and for single pieces 8 bytes for each point of
 * their cells.
 */
class SpooledMesh
{
public:
  /** progress: as that of gatun::FileWriter. Throws Failure, gatun::Error, Interrupted. */
  SpooledMesh(std::shared_ptr<RangedMesh> mesh, const SpoolSettings& settings,
    const std::function<bool(double)>& progress);
  ~SpooledMesh();

  std::size_t GetNumberOfPieces() const { return this->Pieces.size(); }
  const std::vector<double>& GetTimes() const { return this->Times; }

  /** The bytes of the largest piece in memory with a time step. */
  std::uint64_t GetLargestPiece() const;

  /** The bytes of points that no cell uses. They are pieces of their own. */
  std::uint64_t GetUnusedBytes() const { return this->UnusedBytes; }

  /** Reads a piece. If there are several, points have an array JoinArrayName. Throws gatun::Error.
   */
  vtkSmartPointer<vtkUnstructuredGrid> MakePiece(std::size_t piece, std::size_t step) const;

private:
  struct Piece
  {
    std::uint64_t Bytes = 0;
    std::size_t Points = 0;
    std::size_t Cells = 0;
  };

  /** Values of all pieces, a stream each. */
  struct SpooledArray
  {
    std::size_t FirstStream = 0;
    std::size_t TupleBytes = 0;
  };

  class Work;

  void MeasureTuples();
  void CheckMemory();
  void CheckStreams(std::size_t streams) const;
  [[noreturn]] void FailForMemory(std::uint64_t needed) const;
  PointTree MakeTree(Work& work);
  void FindLeaves(PieceRouter& router, const PointTree& tree, Work& work);
  void WeighCells(PieceRouter& router, Work& work);
  void SpoolCells(PieceRouter& router, Work& work);
  void SpoolUnused(const PieceRouter& router);
  void SpoolArrays(int association, Work& work);
  void SpoolCellNumbers(Work& work);
  void MakeLocal();
  void MarkShared();
  std::vector<SpoolCursor> MakeCursors() const;
  void MakePieceLocal(std::size_t piece);

  /** Distributes the tuples of an array over the pieces. read(begin, count, values). */
  template <typename Read>
  SpooledArray Distribute(int association, std::size_t tupleBytes, Work& work, Read&& read);

  /** The stream of the numbers of the points of a piece. */
  std::size_t GetNumbers(std::size_t piece) const
  {
    return piece < this->FirstUnused ? this->Numbers + piece
                                     : this->UnusedNumbers + piece - this->FirstUnused;
  }

  template <typename Array>
  void FillCells(vtkUnstructuredGrid* grid, std::size_t piece) const;
  void FillFaces(vtkUnstructuredGrid* grid, std::size_t piece, vtkUnsignedCharArray* types,
    vtkCellArray* cells) const;
  void FillJoinArray(vtkUnstructuredGrid* grid, std::size_t piece) const;
  void FillCellNumbers(vtkUnstructuredGrid* grid, std::size_t piece) const;
  void FillArray(vtkDataArray* array, const SpooledArray& from, std::size_t piece) const;

  const std::shared_ptr<RangedMesh> Mesh;
  const SpoolSettings Settings;
  const std::vector<double> Times;
  std::size_t Steps = 1;
  Spool File;
  std::vector<Piece> Pieces;
  std::uint64_t UnusedBytes = 0;
  std::size_t TupleBytes[2] = { 0, 0 }; // of all arrays of a step, of points and cells
  std::size_t CoordinateBytes = 0;      // of a point
  std::size_t PointBytes = 0;           // with all arrays, in memory
  std::size_t StreamBytes = 0;          // for buffers
  std::size_t FirstUnused = 0;          // the first piece of points without cells

  // Streams. There is one of each kind for each piece, but of routes.
  std::size_t Routes = 0; // the piece of each cell
  std::size_t Types = 0;
  std::size_t Sizes = 0;
  std::size_t Corners = 0;
  std::size_t FaceSizes = 0;
  std::size_t Faces = 0;
  std::size_t Numbers = 0; // of points, ascending; of pieces with cells
  std::size_t UnusedNumbers = 0;
  std::size_t Shared = 0; // a byte for each point of a piece: whether others have it
  SpooledArray Coordinates;
  SpooledArray CellNumbers; // if HasCellNumbers
  bool HasCellNumbers = false;
  std::vector<SpooledArray> Arrays[2]; // of points and cells, step after step
};
}

#endif
