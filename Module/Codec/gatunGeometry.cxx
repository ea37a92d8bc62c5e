// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunGeometry.h"

namespace gatun
{
namespace
{
/** Solves a * x = b in place by elimination with pivoting. Returns false if a is singular. */
template <std::size_t N>
bool Solve(std::array<std::array<double, N>, N>& a, std::array<double, N>& b)
{
  for (std::size_t i = 0; i < N; ++i)
  {
    std::size_t pivot = i;
    for (std::size_t r = i + 1; r < N; ++r)
    {
      pivot = std::abs(a[r][i]) > std::abs(a[pivot][i]) ? r : pivot;
    }
    if (!(std::abs(a[pivot][i]) > 0))
    {
      return false;
    }
    std::swap(a[i], a[pivot]);
    std::swap(b[i], b[pivot]);
    for (std::size_t r = i + 1; r < N; ++r)
    {
      const double factor = a[r][i] / a[i][i];
      for (std::size_t c = i; c < N; ++c)
      {
        a[r][c] -= factor * a[i][c];
      }
      b[r] -= factor * b[i];
    }
  }
  for (std::size_t i = N; i-- > 0;)
  {
    for (std::size_t c = i + 1; c < N; ++c)
    {
      b[i] -= a[i][c] * b[c];
    }
    b[i] /= a[i][i];
  }
  return true;
}

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
  // Offsets from the gate's third corner, whose weight is 1 minus the sum of the others.
  constexpr std::size_t unknowns = GateRecord::Size - 1;
  constexpr unsigned center = 2;
  std::array<std::array<double, unknowns>, unknowns> normal{};
  std::array<double, unknowns> right{};
  for (std::size_t n = 0; n < records.size(); ++n)
  {
    if (records[n].IsSeed())
    {
      continue;
    }
    for (unsigned i = 0; i < 3; ++i)
    {
      const auto numbers = GetNumbers(records[n], i, keys, domain);
      std::array<double, unknowns> offset{};
      double square = 0;
      for (unsigned k = 0, u = 0; k < GateRecord::Size; ++k)
      {
        if (k != center)
        {
          offset[u] = numbers[k] - numbers[center];
          square += offset[u] * offset[u];
          ++u;
        }
      }
      const double wanted = domain[i].ToNumber(keys[ids[n]][i]) - numbers[center];
      const double weight = 1.0 / square;
      if (!std::isfinite(weight) || !std::isfinite(wanted))
      {
        continue;
      }
      for (std::size_t r = 0; r < unknowns; ++r)
      {
        right[r] += weight * offset[r] * wanted;
        for (std::size_t c = 0; c < unknowns; ++c)
        {
          normal[r][c] += weight * offset[r] * offset[c];
        }
      }
    }
  }
  for (std::size_t r = 0; r < unknowns; ++r)
  {
    normal[r][r] += 1e-9 + 1e-6 * normal[r][r];
  }
  PredictionRule rule{ 0, 0, 256, 0, 0, 0, 0 };
  if (Solve(normal, right))
  {
    for (unsigned k = 0, u = 0; k < GateRecord::Size; ++k)
    {
      if (k != center)
      {
        const double weight = std::floor(256.0 * right[u] + 0.5);
        const auto bounded = std::isfinite(weight) ? std::clamp(weight, -1024.0, 1024.0) : 0.0;
        rule[k] = static_cast<std::int16_t>(bounded);
        rule[center] = static_cast<std::int16_t>(rule[center] - rule[k]);
        ++u;
      }
    }
  }
  return { rule };
}
}
