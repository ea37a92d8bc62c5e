// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnContourInput_h
#define gtnContourInput_h

// What isosurfaces are made of: a .gtn file, of which only those chunks are read that they pass
// through, or any other mesh in memory.

#include "gtnArray.h"
#include "gtnInput.h"
#include "gtnStep.h"
#include "gtnTarget.h"

#include "gatunTypes.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkGatunContour;
class vtkUnstructuredGrid;

namespace gtn
{
struct Settings;

struct ContourInputOptions
{
  std::string File;
  ArrayOptions Array; ///< that of the isovalues
  StepOptions Step;
  TargetOptions Target;
  InputOptions Carried; ///< the arrays that the surface is to have
};

class ContourInput
{
public:
  /** Opens a mesh and chooses the array; of a .gtn file only the directory is read, unless it is to
   * be simplified and does not tell how. Throws Failure. */
  ContourInput(const ContourInputOptions& options, const Settings& settings);
  ~ContourInput();
  ContourInput(const ContourInput&) = delete;
  ContourInput& operator=(const ContourInput&) = delete;

  /** That of the isovalues. */
  const std::string& GetArray() const { return this->Array.Name; }

  /** Of the values, at the time step that is taken, without NaN. Min > Max if there are none. */
  const gatun::Range& GetRange() const { return this->Range; }

  /** Whether it is read while surfaces are made. */
  bool IsFile() const { return this->Reader; }

  /** Of a file: whether it is organized by layers of the values. */
  bool IsLayered() const { return this->Layered; }

  /** Gives the filter its input, and what of it to take. */
  void Connect(vtkGatunContour* contour) const;

  /** Makes the surface. */
  void Run(vtkGatunContour* contour) const;

private:
  void OpenFile(const ContourInputOptions& options, const Settings& settings);
  void Read(const ContourInputOptions& options, const Settings& settings);
  void Choose(const ContourInputOptions& options, const std::vector<ArrayChoice>& choices);
  bool IsCarried(const ContourInputOptions& options, const std::string& name) const;

  const std::string File;
  vtkSmartPointer<vtkAlgorithm> Reader;      // of a .gtn file
  vtkSmartPointer<vtkUnstructuredGrid> Grid; // of others
  std::optional<double> Time;
  ArrayChoice Array;
  int Component = 0;
  bool WithScalars = true;
  bool Layered = false;
  gatun::Range Range;
};
}

#endif
