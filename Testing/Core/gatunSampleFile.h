// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunSampleFile_h
#define gatunSampleFile_h

#include "gatunFileWriter.h"
#include "gatunTestMeshes.h"

#include <array>
#include <cstdint>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

namespace gatun::test
{
/** The value of point i at a step. */
using PointValue = std::function<float(std::size_t i, int step)>;

inline float GetUsualValue(std::size_t i, int step)
{
  return 0.1f * static_cast<float>(i * i) + static_cast<float>(step);
}

/** Writes a mesh with a point array of one component and a cell array of two. */
inline void WriteSample(const std::string& path, const TestMesh& mesh, const WriterOptions& options,
  int steps, const PointValue& valueOf = GetUsualValue, const FieldData& field = {})
{
  std::vector<ArrayDescription> arrays(2);
  arrays[0].Name = std::string("p"); // GCC 12 warns about a plain "p"
  arrays[1].Name = std::string("c");
  arrays[1].Where = Association::Cell;
  arrays[1].Type = ScalarType::Int16;
  arrays[1].Components = 2;
  std::vector<float> pointValues(mesh.GetPoints());
  std::vector<std::int16_t> cellValues(2 * mesh.GetTets());
  FileWriter writer(path, mesh.GetInput(), arrays, options);
  for (int step = 0; step < steps; ++step)
  {
    for (std::size_t i = 0; i < pointValues.size(); ++i)
    {
      pointValues[i] = valueOf(i, step);
    }
    std::iota(cellValues.begin(), cellValues.end(), static_cast<std::int16_t>(step));
    const std::array<const void*, 2> values{ pointValues.data(), cellValues.data() };
    writer.WriteStep(values, field, steps > 1, step);
  }
  writer.Finish();
}
}

#endif
