// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnRangedSeries_h
#define gtnRangedSeries_h

// Meshes in several files as the time steps of one mesh.

#include "gtnRangedMesh.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace gtn
{
/** Files with the same mesh and the same arrays, which is checked. One file at a time is open
 * beside the first one. */
class RangedSeries : public RangedMesh
{
public:
  using Open = std::function<std::unique_ptr<RangedMesh>(const std::string&)>;

  /** files: one for each time. open: makes a mesh of a file. Throws Failure. */
  RangedSeries(
    const std::vector<std::string>& files, const std::vector<double>& times, const Open& open);

  std::uint64_t GetNumberOfPoints() const override { return this->First->GetNumberOfPoints(); }
  std::uint64_t GetNumberOfCells() const override { return this->First->GetNumberOfCells(); }
  bool HasPolyhedra() const override { return this->First->HasPolyhedra(); }
  bool HasWideIds() const override { return this->First->HasWideIds(); }
  std::vector<double> GetTimes() const override { return this->Times; }
  vtkUnstructuredGrid* GetTemplate(std::size_t step) const override;
  void ReadPoints(std::uint64_t begin, std::size_t count, void* values) override;
  void ReadCells(std::uint64_t begin, std::size_t count, RangedCells& cells) override;
  void ReadArray(int association, int array, std::size_t step, std::uint64_t begin,
    std::size_t count, void* values) override;
  void CheckUnchanged() const override;

private:
  struct Step
  {
    vtkSmartPointer<vtkUnstructuredGrid> Template;
    std::vector<int> Arrays[2]; // their numbers in this step, by those in the first one
    bool IsChecked = false;     // whether its mesh is that of the first step
  };

  RangedMesh& GetMesh(std::size_t step);
  void MatchArrays(std::size_t step);
  void CheckMesh(std::size_t step, RangedMesh& mesh);
  [[noreturn]] void Fail(std::size_t step, const std::string& problem) const;

  const std::vector<std::string> Files;
  const std::vector<double> Times;
  const Open OpenFile;
  std::unique_ptr<RangedMesh> First;
  std::unique_ptr<RangedMesh> Current;
  std::size_t CurrentStep = 0;
  std::vector<Step> Steps;
};
}

#endif
