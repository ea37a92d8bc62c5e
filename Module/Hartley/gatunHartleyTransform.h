// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunHartleyTransform_h
#define gatunHartleyTransform_h

#include "gatunExport.h"
#include "gatunHartleyLayout.h"

#include <memory>
#include <span>

namespace gatun
{
/**
 * The discrete Hartley transform of a block of voxels in three dimensions, about its center:
 *
 *   H(u) = 1 / sqrt(N) * sum over x of f(x) cas(2 pi sum over axes of k(u) (x - c) / n),
 *   cas(a) = cos(a) + sin(a),
 *
 * where n are the block's sizes, N their product, c = (n - 1) / 2, k(u) = u for u <= n / 2, and
 * k(u) = u - n for larger u. This is not the product of three one-dimensional transforms, for which
 * the projection-slice theorem does not hold. The basis is orthonormal: sums of squares are
 * preserved (Parseval), and f(x) = 1 / sqrt(N) * sum over u of H(u) cas(the same argument).
 *
 * R. N. Bracewell: The fast Hartley transform. Proceedings of the IEEE 72(8), 1984.
 *
 * An object has working memory of its own. Each thread needs one.
 */
class GATUN_EXPORT HartleyTransform
{
public:
  explicit HartleyTransform(const HartleyLayout::Triple& size);
  ~HartleyTransform();
  HartleyTransform(const HartleyTransform&) = delete;
  HartleyTransform& operator=(const HartleyTransform&) = delete;

  /** In place. The index along x is the fastest. */
  void Forward(std::span<double> values);
  void Inverse(std::span<double> values);

private:
  struct Internals;
  std::unique_ptr<Internals> Data;
};
}

#endif
