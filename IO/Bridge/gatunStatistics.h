// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunStatistics_h
#define gatunStatistics_h

#include "vtkGatunIOModule.h" // For export macro

#include "vtkSmartPointer.h"

#include <cstdint>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkTable;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/**
 * The table that GetStatistics of public classes returns: one row, with a column for each number.
 * Columns are named by their contents, with the unit if it is not obvious, such as "BytesRead" or
 * "FetchSeconds".
 */
class VTKGATUNIO_EXPORT Statistics
{
public:
  Statistics();
  ~Statistics();
  Statistics(const Statistics&) = delete;
  Statistics& operator=(const Statistics&) = delete;

  /** Starts a new table. Those that were returned before stay as they are. */
  void Clear();

  /** Counts and bytes, in a vtkTypeUInt64Array. */
  void Add(const char* name, std::uint64_t value);

  /** Times and fractions, in a vtkDoubleArray. */
  void Add(const char* name, double value);

  /** The table, which is kept until the next Clear. */
  vtkTable* Get() const;

private:
  vtkSmartPointer<vtkTable> Table;
};
}

#endif
