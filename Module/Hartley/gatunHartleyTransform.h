// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyTransform_h
#define gatunHartleyTransform_h

#include "gatunHartleyLayout.h"
#include "vtkGatunCoreModule.h"

#include <memory>
#include <span>

namespace gatun
{
/**
 * The discrete Hartley transform of a block of voxels in three dimensions, about its centre:
 *
 *   H(u) = 1 / sqrt(N) * sum over x of f(x) cas(2 pi sum over axes of k(u) (x - c) / n),
 *   cas(a) = cos(a) + sin(a),
 *
 * where n are the block's sizes, N their product, c = (n - 1) / 2, and k(u) = u for u <= n / 2, and
 * u - n for larger u. Not the product of three transforms in one dimension: only this one has the
 * projection-slice theorem. The basis is orthonormal, so that sums of squares are kept (Parseval),
 * and f(x) = 1 / sqrt(N) * sum over u of H(u) cas(the same).
 *
 * R. N. Bracewell: The fast Hartley transform. Proceedings of the IEEE 72(8), 1984.
 *
 * An object keeps working memory: one a thread.
 */
class VTKGATUNCORE_EXPORT HartleyTransform
{
public:
  explicit HartleyTransform(const HartleyLayout::Triple& size);
  ~HartleyTransform();
  HartleyTransform(const HartleyTransform&) = delete;
  HartleyTransform& operator=(const HartleyTransform&) = delete;

  /** In place; x, and u along x, fastest. */
  void Forward(std::span<double> values);
  void Inverse(std::span<double> values);

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};
}

#endif
