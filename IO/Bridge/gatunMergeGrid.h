// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMergeGrid_h
#define gatunMergeGrid_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkIndent.h"

#include "gatunMergeBuilder.h"
#include "gatunMergeTree.h"

#include <functional>
#include <map>
#include <ostream>
#include <string>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkUnstructuredGrid;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** How much each point array counts when a mesh is simplified. */
class VTKGATUNIO_EXPORT MergeWeights
{
public:
  /** These return whether anything has changed. */
  bool Set(const char* name, double weight);
  bool Clear();

  double Get(const char* name) const; ///< 0 if none was set
  const std::map<std::string, double>& GetAll() const { return this->Weights; }
  void Print(std::ostream& os, vtkIndent indent) const;

  bool operator==(const MergeWeights&) const = default;

private:
  std::map<std::string, double> Weights;
};

/**
 * Finds how a grid of nothing but tetrahedra becomes simpler. Without any weights the active
 * scalars count, or, if there are none, all point arrays alike. Throws gatun::Error (InvalidInput)
 * for cells with points that do not exist and for weights of arrays that do not. Exported for the
 * filters.
 */
VTKGATUNIO_EXPORT MergeTree BuildMergeTree(vtkUnstructuredGrid* tets, const MergeWeights& weights,
  const MergeSettings& settings, const std::function<bool(double)>& progress);
}

#endif
