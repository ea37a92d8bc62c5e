// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSeriesArrays_h
#define gatunSeriesArrays_h

#include "gatunArrayBridge.h"

#include "vtkGatunIOModule.h" // For export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkDataArray;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** Values for an array that a step does not have: NaN, or 0 for integers and ghosts. */
VTKGATUNIO_EXPORT vtkSmartPointer<vtkDataArray> MakeMissingArray(
  int vtkType, int components, vtkIdType tuples);

/**
 * The point and cell arrays of a time series. All steps of a file have the same arrays, and steps
 * may differ in their order, roles and component names, in vtkGhostType, and in arrays without
 * tuples. Arrays have the order and the roles of the first step with values, and the first names of
 * components that occur.
 */
class SeriesArrays
{
public:
  /** A step: its numbers of tuples, and its name for messages. */
  struct Step
  {
    std::size_t Points = 0;
    std::size_t Cells = 0;
    std::string Name;
  };

  /** fill: whether arrays may come and go. warn: receives what is not kept, once. */
  void Begin(bool fill, std::function<void(const std::string&)> warn);

  /** Lets the steps come after those of a file, to which no arrays are added. */
  void Continue(const std::vector<ArrayDescription>& arrays);

  /** Adds the arrays of a step. Returns whether they were known: if not, steps before have to be
   * written with more arrays. Throws Error(InvalidInput) if they do not fit those before. */
  bool Learn(const std::vector<BridgedArray>& arrays, const Step& step);

  /** The arrays of a step that was learned, in order, and with those that it does not have. */
  std::vector<BridgedArray> Arrange(
    const std::vector<BridgedArray>& arrays, const Step& step) const;

private:
  struct Known
  {
    ArrayDescription Description;
    bool HasTuples = false;
  };

  bool Add(const BridgedArray& array, const Step& step);
  bool Compare(Known& known, const BridgedArray& array, const Step& step);

  std::vector<Known> Arrays;
  std::function<void(const std::string&)> Warn;
  bool Fill = false;
  bool IsContinued = false;
  bool HadTuples[2] = { false, false }; // whether a step had any, by association
};
}

#endif
