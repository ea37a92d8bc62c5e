// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnInput_h
#define gtnInput_h

// Meshes of whatever format, as one tetrahedral grid, with time steps where there are any.

#include "gtnInputOptions.h"

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace gtn
{
class Progress;

/** What help texts say of readable formats. */
extern const char* const InputFormats;

class Input
{
public:
  /** Opens a file, or several: the time steps of one mesh, in the order given. Nothing but what
   * the formats tell about time is read. Throws Failure. */
  Input(const std::vector<std::string>& files, const InputOptions& options);
  ~Input();
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

  /** The file's name, or the first one's. */
  const std::string& GetName() const { return this->Name; }

  /** The end of a pipeline that makes vtkUnstructuredGrid and answers requests for time. */
  vtkAlgorithm* GetAlgorithm() const { return this->Algorithm; }

  /** The reader at its beginning. */
  vtkAlgorithm* GetSource() const;

  /** Ascending; empty without time. */
  const std::vector<double>& GetTimes() const { return this->Times; }

  /** Reads a step, 0 without time. The grid lives until the next call. Throws Failure. */
  vtkUnstructuredGrid* Read(std::size_t step, Progress& progress);

private:
  std::string Name;
  bool Quiet;
  vtkSmartPointer<vtkAlgorithm> Algorithm;
  std::vector<double> Times;
};

/** A surface from .stl .ply .obj .vtp .vtk. Throws Failure. */
vtkSmartPointer<vtkPolyData> ReadSurface(const std::string& file, Progress& progress, bool quiet);
}

#endif
