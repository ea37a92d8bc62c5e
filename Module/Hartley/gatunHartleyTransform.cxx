// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunHartleyTransform.h"

#include "gatunHartleyLines.h"
#include "gatunParallel.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <vector>

namespace gatun
{
namespace
{
// Blocks of more values than this are transformed by several threads.
constexpr std::size_t ParallelValues = std::size_t{ 1 } << 19;

/** The frequency -k along an axis. k = n / 2 is its own opposite up to the sign, because its cosine
 * is 0 at the center, which is between voxels. */
struct Opposite
{
  std::uint32_t Index = 0;
  double Sign = 1;
};

Opposite GetOpposite(std::uint32_t index, std::uint32_t size)
{
  if (index == 0)
  {
    return { 0, 1 };
  }
  return { size - index, 2 * index == size ? -1.0 : 1.0 };
}
}

//------------------------------------------------------------------------------
/**
 * Transforms lines along x, y and z in one dimension, which gives products of three cas. With
 *
 *   2 cas(a + b + c) = cas(a) cas(b) cas(-c) + cas(a) cas(-b) cas(c) + cas(-a) cas(b) cas(c)
 *                    - cas(-a) cas(-b) cas(-c)
 *
 * the values at a frequency and its reflections are combined to those of the Hartley transform.
 * That step is its own inverse.
 */
struct HartleyTransform::Internals
{
  HartleyLayout::Triple Size;
  std::size_t Count;
  std::array<std::optional<HartleyLines>, 3> Lines;

  /** Calls body(i, memory) for all i below count, in parallel if the block is large. */
  template <typename Memory, typename Body>
  void ForEach(std::size_t count, Memory& memory, Body&& body)
  {
    if (this->Count < ParallelValues || count < 2)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        body(i, memory);
      }
      return;
    }
    const auto parts = std::min<std::size_t>(count, 4 * std::size_t(GetNumberOfThreads()));
    ParallelFor(parts,
      [&](std::size_t part)
      {
        Memory own;
        for (std::size_t i = count * part / parts; i < count * (part + 1) / parts; ++i)
        {
          body(i, own);
        }
      });
  }

  void TransformLines(unsigned axis, bool forward, std::span<double> values);
  void CombineReflections(std::span<double> values);
  void CombineRows(
    std::uint32_t v, std::uint32_t w, std::span<double> values, std::vector<double>& memory) const;

  HartleyLines::Memory OwnMemory;
  std::vector<double> Rows;
};

//------------------------------------------------------------------------------
void HartleyTransform::Internals::TransformLines(
  unsigned axis, bool forward, std::span<double> values)
{
  const auto& lines = this->Lines[axis];
  if (!lines)
  {
    return;
  }
  // Adjacent lines are transformed together.
  const std::size_t inner = axis == 0 ? 1
    : axis == 1                       ? this->Size[0]
                                      : this->Size[0] * std::size_t{ this->Size[1] };
  if (axis == 0)
  {
    const std::size_t together = 16;
    const std::size_t count = this->Count / this->Size[0];
    this->ForEach((count + together - 1) / together, this->OwnMemory,
      [&](std::size_t i, HartleyLines::Memory& memory)
      {
        const auto first = i * together;
        lines->Transform(values.data() + first * this->Size[0], this->Size[0], 1,
          std::min(together, count - first), forward, memory);
      });
    return;
  }
  const std::size_t together = std::min<std::size_t>(inner, 64);
  const std::size_t groups = (inner + together - 1) / together;
  const std::size_t outer = this->Count / (inner * this->Size[axis]);
  this->ForEach(outer * groups, this->OwnMemory,
    [&](std::size_t i, HartleyLines::Memory& memory)
    {
      const auto first = i % groups * together;
      lines->Transform(values.data() + i / groups * inner * this->Size[axis] + first, 1, inner,
        std::min(together, inner - first), forward, memory);
    });
}

//------------------------------------------------------------------------------
void HartleyTransform::Internals::CombineRows(
  std::uint32_t v, std::uint32_t w, std::span<double> values, std::vector<double>& memory) const
{
  const std::size_t n = this->Size[0];
  const auto minusV = GetOpposite(v, this->Size[1]);
  const auto minusW = GetOpposite(w, this->Size[2]);
  const auto getRow = [&](std::uint32_t j, std::uint32_t k)
  { return values.data() + n * (j + std::size_t{ this->Size[1] } * k); };
  // Row 0 is (v, w); bit 0 reflects v, bit 1 reflects w.
  const std::array<double*, 4> rows{ getRow(v, w), getRow(minusV.Index, w), getRow(v, minusW.Index),
    getRow(minusV.Index, minusW.Index) };

  // Each row, and its reflection.
  memory.resize(8 * n);
  const double signU = n % 2 == 0 ? -1.0 : 1.0;
  for (unsigned r = 0; r < 4; ++r)
  {
    double* const plain = memory.data() + 2 * r * n;
    double* const mirrored = plain + n;
    std::copy_n(rows[r], n, plain);
    mirrored[0] = plain[0];
    for (std::size_t u = 1; u < n; ++u)
    {
      mirrored[u] = plain[n - u];
    }
    if (n > 1)
    {
      mirrored[n / 2] *= signU;
      if (n % 2 != 0)
      {
        mirrored[n / 2] = plain[n - n / 2];
      }
    }
  }
  const auto getPlain = [&](unsigned r) { return memory.data() + 2 * r * n; };
  const auto getMirrored = [&](unsigned r) { return memory.data() + (2 * r + 1) * n; };
  for (unsigned r = 0; r < 4; ++r)
  {
    if (std::find(rows.begin(), rows.begin() + r, rows[r]) != rows.begin() + r)
    {
      continue;
    }
    const double* const withV = getPlain(r ^ 1);
    const double* const withW = getPlain(r ^ 2);
    const double* const withU = getMirrored(r);
    const double* const withAll = getMirrored(r ^ 3);
    const double a = 0.5 * minusV.Sign;
    const double b = 0.5 * minusW.Sign;
    const double c = 0.5 * minusV.Sign * minusW.Sign;
    double* const out = rows[r];
    for (std::size_t u = 0; u < n; ++u)
    {
      out[u] = a * withV[u] + b * withW[u] + (0.5 * withU[u] - c * withAll[u]);
    }
  }
}

//------------------------------------------------------------------------------
void HartleyTransform::Internals::CombineReflections(std::span<double> values)
{
  // In fewer than two dimensions, the product is the Hartley transform.
  if ((this->Size[0] > 1) + (this->Size[1] > 1) + (this->Size[2] > 1) < 2)
  {
    return;
  }
  this->ForEach(this->Size[2] / 2 + 1, this->Rows,
    [&](std::size_t w, std::vector<double>& memory)
    {
      for (std::uint32_t v = 0; v <= this->Size[1] / 2; ++v)
      {
        this->CombineRows(v, static_cast<std::uint32_t>(w), values, memory);
      }
    });
}

//------------------------------------------------------------------------------
HartleyTransform::HartleyTransform(const HartleyLayout::Triple& size)
  : Data(std::make_unique<Internals>())
{
  this->Data->Size = size;
  this->Data->Count = std::size_t{ size[0] } * size[1] * size[2];
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    if (size[axis] > 1)
    {
      this->Data->Lines[axis].emplace(size[axis]);
    }
  }
}

//------------------------------------------------------------------------------
HartleyTransform::~HartleyTransform() = default;

//------------------------------------------------------------------------------
void HartleyTransform::Forward(std::span<double> values)
{
  assert(values.size() == this->Data->Count);
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    this->Data->TransformLines(axis, true, values);
  }
  this->Data->CombineReflections(values);
}

//------------------------------------------------------------------------------
void HartleyTransform::Inverse(std::span<double> values)
{
  assert(values.size() == this->Data->Count);
  this->Data->CombineReflections(values);
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    this->Data->TransformLines(axis, false, values);
  }
}
}
