// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnRenderInput_h
#define gtnRenderInput_h

// What is drawn: a .gtn file, of which no more is read than is seen, or any other mesh in memory.

#include "gtnArray.h"
#include "gtnStep.h"

#include "gatunTypes.h"

#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

class vtkGatunDefaults;
class vtkGatunReader;
class vtkGatunRayCaster;
class vtkUnstructuredGrid;

namespace gtn
{
class Progress;

struct RenderInputOptions
{
  std::string File;
  ArrayOptions Array;
  StepOptions Step;
  bool Quiet = false;
};

class RenderInput
{
public:
  /** Opens a mesh and chooses the array; of a .gtn file only the directory is read. Throws
   * Failure. */
  RenderInput(const RenderInputOptions& options, Progress& progress);
  ~RenderInput();
  RenderInput(const RenderInput&) = delete;
  RenderInput& operator=(const RenderInput&) = delete;

  /** Of all finite coordinates. */
  const gatun::Bounds& GetBounds() const { return this->Bounds; }

  /** Of the values that are drawn, without NaN. Min > Max if there are none. */
  const gatun::Range& GetRange() const { return this->Range; }

  const std::string& GetArray() const { return this->Array.Name; }
  int GetComponent() const { return this->Component; }
  std::uint64_t GetNumberOfTets() const { return this->Tets; }

  /** Gives the caster its input and the array to draw. Memory: of decoded parts of a file, in MiB.
   */
  void Connect(vtkGatunRayCaster* caster, int memory) const;

  /** Gives the defaults the mesh and the array to draw. Memory: as above. */
  void Connect(vtkGatunDefaults* defaults, int memory) const;

  /** Makes the caster draw. */
  void Draw(vtkGatunRayCaster* caster) const;

private:
  template <typename Consumer>
  void ConnectTo(Consumer* consumer, int memory) const;
  void OpenFile(const RenderInputOptions& options);
  void Read(const RenderInputOptions& options, Progress& progress);
  void Choose(const RenderInputOptions& options, const std::vector<ArrayChoice>& choices);
  void RequireContent() const;

  const std::string File;
  vtkSmartPointer<vtkGatunReader> Reader;    // of a .gtn file
  vtkSmartPointer<vtkUnstructuredGrid> Grid; // of others
  std::optional<double> Time;
  ArrayChoice Array;
  int Component = 0;
  gatun::Bounds Bounds;
  gatun::Range Range;
  std::uint64_t Tets = 0;
};
}

#endif
