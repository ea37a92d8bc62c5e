// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnInput_h
#define gtnInput_h

// Meshes of any format as one grid or surface, with time steps if there are any.

#include "gtnFileList.h"
#include "gtnInputOptions.h"

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace gtn
{
class Progress;
class SpooledMesh;
struct SpoolSettings;

/** The formats that can be read, for help texts. */
extern const char* const InputFormats;
extern const char* const SurfaceInputFormats;

class Input
{
public:
  /** Opens a file, or several files as the time steps of one mesh, in the given order. Reads only
   * the time values. Throws Failure. */
  Input(const std::vector<std::string>& files, const InputOptions& options);
  ~Input();
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

  /** Returns the name of the first file. */
  const std::string& GetName() const { return this->Name; }

  /** Returns the end of a pipeline that produces vtkUnstructuredGrid, or vtkPolyData of a surface,
   * for any time step. */
  vtkAlgorithm* GetAlgorithm() const { return this->Algorithm; }

  /** Returns the reader at its beginning. */
  vtkAlgorithm* GetSource() const;

  /** Whether the mesh is in one file that can be divided into pieces on the disk, or one for each
   * time step. */
  bool CanSpool() const;

  /** Divides the mesh into pieces on the disk, which the algorithm makes from then on. Throws
   * Failure, gatun::Error and Interrupted. */
  void Spool(SpoolSettings settings, Progress& progress);

  /** Whether the points of several files of a mesh are joined where it is packed in pieces. */
  bool JoinsFiles() const { return this->Options.InPieces && !this->Spooled && !this->HasBlocks; }

  /** Whether a step consists of several files that are no blocks. */
  bool IsInFiles() const;

  bool IsSpooled() const { return this->Spooled != nullptr; }

  /** Returns the number of pieces, or else of files of each step. Throws Failure if the steps
   * differ in it. */
  std::size_t GetNumberOfParts() const;

  /** Returns about the number of bytes of the largest piece or file as a mesh in memory. Reads only
   * what comes before the values. Throws Failure. */
  std::uint64_t EstimateLargestPart() const;

  /** Returns the number of bytes that stay in memory while a mesh in pieces is written. */
  std::uint64_t GetBytesForAll() const;

  /** Returns the times in ascending order, or nothing without time. */
  const std::vector<double>& GetTimes() const { return this->Times; }

  /** Reads a step, 0 without time: a grid or a surface, which lives until the next call. Throws
   * Failure. */
  vtkDataObject* Read(std::size_t step, Progress& progress);

  /** The same, but throws Failure for a surface. */
  vtkUnstructuredGrid* ReadGrid(std::size_t step, Progress& progress);

private:
  void FindTimes();
  void NameSets() const;
  void ChooseListed();
  void ChooseOwn();

  std::string Name;
  InputOptions Options;
  bool HasTime = true;    // if there are Steps
  bool HasBlocks = false; // whether the files of each step are blocks
  vtkSmartPointer<vtkAlgorithm> Algorithm;
  std::vector<double> Times;
  std::vector<SeriesStep> Steps; // empty if a single reader makes them
  std::shared_ptr<const SpooledMesh> Spooled;
};

/** Reads a surface from a file: .stl .ply .obj .vtp .vtk .gtn. Throws Failure. */
vtkSmartPointer<vtkPolyData> ReadSurface(const std::string& file, Progress& progress, bool quiet);
}

#endif
