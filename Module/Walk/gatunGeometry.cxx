// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunGeometry.h"

#include "gatunRuleFitter.h"

namespace gatun
{
namespace
{
/** One component of a gate's known vertices. */
std::array<double, GateRecord::Size> GetNumbers(const GateRecord& record, unsigned component,
  std::span<const PointKeys> keys, const PointDomain& domain)
{
  std::array<double, GateRecord::Size> numbers{};
  for (unsigned k = 0; k < GateRecord::Size; ++k)
  {
    numbers[k] = domain[component].ToNumber(keys[record.Known[k]][component]);
  }
  return numbers;
}
}

const PredictionRules& GetGridRules()
{
  // Corners a, b, c of the gate, apex, far corners over the sides opposite to a, b, c.
  static const PredictionRules rules{
    { 0, 0, 256, 0, 0, 0, 0 },        // c: a swept coordinate repeats
    { 256, 0, 0, -256, 256, 0, 0 },   // parallelograms with the far corners
    { 0, 256, 0, -256, 0, 256, 0 },   //
    { 128, 128, 128, -128, 0, 0, 0 }, // the corner of a parallelepiped beside its kernel
    { 256, 0, 256, 0, 0, -256, 0 },   //
    { 0, -256, 0, 0, 256, 0, 256 },   //
    { 0, 256, 256, 0, -256, 0, 0 },   //
    { 0, 0, 512, -256, 0, 0, 0 },     // continuation of a row
    { -256, 0, 0, 0, 0, 256, 256 },   //
    { 0, 0, 256, -256, 0, 0, 256 },   //
    { 0, 0, 0, 0, 0, 0, 256 },        //
    { 256, 256, 0, 0, 0, 0, -256 },   //
  };
  return rules;
}

PredictionRules FitRule(std::span<const GateRecord> records, std::span<const Vertex> ids,
  std::span<const PointKeys> keys, const PointDomain& domain)
{
  // Relative to the gate's third corner.
  RuleFitter<GateRecord::Size, 2> fitter;
  for (std::size_t n = 0; n < records.size(); ++n)
  {
    if (records[n].IsSeed())
    {
      continue;
    }
    for (unsigned i = 0; i < 3; ++i)
    {
      fitter.Add(GetNumbers(records[n], i, keys, domain), domain[i].ToNumber(keys[ids[n]][i]));
    }
  }
  return { fitter.Fit() };
}
}
