// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunQuadraticLoops_h
#define gatunQuadraticLoops_h

// Compiled once for each instruction set; see gatunSimd.h. The order of all operations is that of
// Documentation/format.md, 10.9: without contraction, every version gives the same weights.

#include "gatunQuadraticLanes.h"
#include "gatunSimd.h"

#include <limits>

namespace gatun
{
namespace GATUN_SIMD
{
/** Makes the mean square of the offsets 1. If that cannot be, all are 0. */
GATUN_INLINE void Normalize(QuadraticLanes& lanes)
{
  for (std::size_t half = 0; half < QuadraticLanes::Count; half += 4)
  {
    const auto offset = [&](unsigned axis, std::size_t i)
    { return Load<Double4>(lanes.Offsets[axis][i] + half); };
    Double4 sum{};
    for (std::size_t i = 0; i < lanes.Neighbors; ++i)
    {
      const auto x = offset(0, i), y = offset(1, i), z = offset(2, i);
      sum += x * x + y * y + z * z;
    }
    const auto zero = SplatD(0);
    const auto mean = sum / __builtin_convertvector(Load<Float4>(lanes.Size + half), Double4);
    const auto isUsable = (mean > zero) & (mean <= SplatD(std::numeric_limits<double>::max()));
    auto root = mean;
    for (unsigned k = 0; k < 4; ++k)
    {
      root[k] = __builtin_sqrt(root[k]);
    }
    const auto scale = SplatD(1) / root;
    for (std::size_t i = 0; i < lanes.Neighbors; ++i)
    {
      const auto store = [&](QuadraticLanes::Lane& lane, Double4 v)
      { Store(lane + half, __builtin_convertvector(isUsable ? v * scale : zero, Float4)); };
      store(lanes.X[i], offset(0, i));
      store(lanes.Y[i], offset(1, i));
      store(lanes.Z[i], offset(2, i));
    }
  }
}

/** Weights of neighbors by their distances before these are changed. */
GATUN_INLINE void FindShares(QuadraticLanes& lanes)
{
  Float8 sum{};
  for (std::size_t i = 0; i < lanes.Neighbors; ++i)
  {
    const auto x = Load<Float8>(lanes.X[i]);
    const auto y = Load<Float8>(lanes.Y[i]);
    const auto z = Load<Float8>(lanes.Z[i]);
    const auto share = Load<Float8>(lanes.Share[i]) / (x * x + y * y + z * z + Splat8(0.3f));
    Store(lanes.Share[i], share);
    sum += share;
  }
  const auto one = Splat8(1.0f);
  const auto whole = sum > Splat8(0.0f) ? sum : one;
  for (std::size_t i = 0; i < lanes.Neighbors; ++i)
  {
    Store(lanes.Share[i], Load<Float8>(lanes.Share[i]) / whole);
  }
}

/** Removes the linear distortion of neighborhoods that are longer in one direction. */
GATUN_INLINE void Whiten(QuadraticLanes& lanes)
{
  Float8 xx{}, xy{}, xz{}, yy{}, yz{}, zz{};
  for (std::size_t i = 0; i < lanes.Neighbors; ++i)
  {
    const auto x = Load<Float8>(lanes.X[i]);
    const auto y = Load<Float8>(lanes.Y[i]);
    const auto z = Load<Float8>(lanes.Z[i]);
    xx += x * x;
    xy += x * y;
    xz += x * z;
    yy += y * y;
    yz += y * z;
    zz += z * z;
  }
  const auto part = Load<Float8>(lanes.PerNeighbor);
  const auto ridge = Splat8(0.01f) * (xx * part + yy * part + zz * part);
  const auto root = [](Float8 v)
  {
    for (std::size_t k = 0; k < 8; ++k)
    {
      v[k] = __builtin_sqrtf(v[k]);
    }
    return v;
  };
  const auto one = Splat8(1.0f);
  const auto a = one / root(xx * part + ridge);
  const auto xyA = xy * part * a;
  const auto xzA = xz * part * a;
  const auto b = one / root(yy * part + ridge - xyA * xyA);
  const auto yzB = (yz * part - xyA * xzA) * b;
  const auto c = one / root(zz * part + ridge - xzA * xzA - yzB * yzB);
  for (std::size_t i = 0; i < lanes.Neighbors; ++i)
  {
    const auto x = Load<Float8>(lanes.X[i]) * a;
    const auto y = (Load<Float8>(lanes.Y[i]) - xyA * x) * b;
    const auto z = (Load<Float8>(lanes.Z[i]) - xzA * x - yzB * y) * c;
    Store(lanes.X[i], x);
    Store(lanes.Y[i], y);
    Store(lanes.Z[i], z);
  }
}

/** Solves a symmetric system with the right side (0, ..., 0, 1). matrix: its lower half. */
template <std::size_t N>
GATUN_INLINE void SolveForLast(Float8 (&matrix)[N][N], Float8 (&result)[N])
{
  const auto one = Splat8(1.0f);
  for (std::size_t j = 0; j < N; ++j)
  {
    // Above the diagonal is row j times the pivots.
    for (std::size_t k = 0; k < j; ++k)
    {
      matrix[j][j] -= matrix[j][k] * matrix[k][j];
    }
    const auto inverse = one / matrix[j][j];
    result[j] = inverse;
    for (std::size_t r = j + 1; r < N; ++r)
    {
      auto v = matrix[r][j];
      for (std::size_t k = 0; k < j; ++k)
      {
        v -= matrix[r][k] * matrix[k][j];
      }
      matrix[j][r] = v;
      matrix[r][j] = v * inverse;
    }
  }
  for (std::size_t j = N - 1; j-- > 0;)
  {
    Float8 v{};
    for (std::size_t k = j + 1; k < N; ++k)
    {
      v -= matrix[k][j] * result[k];
    }
    result[j] = v;
  }
}

/** The sums of a weight times monomials, by the exponents of x, y and z. */
struct QuadraticSums
{
  Float8 One{}, X{}, Y{}, Z{}, XX{}, XY{}, XZ{}, YY{}, YZ{}, ZZ{};
  Float8 XXX{}, XXY{}, XXZ{}, XYY{}, XYZ{}, XZZ{}, YYY{}, YYZ{}, YZZ{}, ZZZ{};
  Float8 XXXX{}, XXXY{}, XXXZ{}, XXYY{}, XXYZ{}, XXZZ{}, XYYY{}, XYYZ{}, XYZZ{}, XZZZ{};
  Float8 YYYY{}, YYYZ{}, YYZZ{}, YZZZ{}, ZZZZ{};

  GATUN_INLINE void Add(Float8 h, Float8 x, Float8 y, Float8 z)
  {
    const auto xx = x * x, xy = x * y, xz = x * z, yy = y * y, yz = y * z, zz = z * z;
    const auto hxx = h * xx, hxy = h * xy, hxz = h * xz, hyy = h * yy, hyz = h * yz, hzz = h * zz;
    this->One += h;
    this->X += h * x;
    this->Y += h * y;
    this->Z += h * z;
    this->XX += hxx;
    this->XY += hxy;
    this->XZ += hxz;
    this->YY += hyy;
    this->YZ += hyz;
    this->ZZ += hzz;
    this->XXX += hxx * x;
    this->XXY += hxx * y;
    this->XXZ += hxx * z;
    this->XYY += hxy * y;
    this->XYZ += hxy * z;
    this->XZZ += hxz * z;
    this->YYY += hyy * y;
    this->YYZ += hyy * z;
    this->YZZ += hyz * z;
    this->ZZZ += hzz * z;
    this->XXXX += hxx * xx;
    this->XXXY += hxx * xy;
    this->XXXZ += hxx * xz;
    this->XXYY += hxx * yy;
    this->XXYZ += hxx * yz;
    this->XXZZ += hxx * zz;
    this->XYYY += hxy * yy;
    this->XYYZ += hxy * yz;
    this->XYZZ += hxy * zz;
    this->XZZZ += hxz * zz;
    this->YYYY += hyy * yy;
    this->YYYZ += hyy * yz;
    this->YYZZ += hyy * zz;
    this->YZZZ += hyz * zz;
    this->ZZZZ += hzz * zz;
  }
};

/** Finds the weights of neighbors by their distances from the center. */
GATUN_INLINE void FindNear(QuadraticLanes& lanes)
{
  const auto sizes = Load<Float8>(lanes.Size);
  for (std::size_t i = 0; i < lanes.Neighbors; ++i)
  {
    const auto x = Load<Float8>(lanes.X[i]);
    const auto y = Load<Float8>(lanes.Y[i]);
    const auto z = Load<Float8>(lanes.Z[i]);
    const auto near = Splat8(1.0f) / (x * x + y * y + z * z + Splat8(1e-3f));
    Store(lanes.Near[i], Splat8(static_cast<float>(i)) < sizes ? near : Splat8(0.0f));
  }
}

GATUN_INLINE void FitQuadratic(QuadraticLanes& lanes)
{
  QuadraticSums s;
  for (std::size_t i = 0; i < lanes.Neighbors; ++i)
  {
    const auto x = Load<Float8>(lanes.X[i]);
    const auto y = Load<Float8>(lanes.Y[i]);
    const auto z = Load<Float8>(lanes.Z[i]);
    const auto near = Load<Float8>(lanes.Near[i]);
    const auto h = near * near * near;
    Store(lanes.Quadratic[i], h);
    s.Add(h, x, y, z);
  }
  // The functions xx, xy, xz, yy, yz, zz, x, y, z, 1, and a little more on the diagonal.
  const auto flat = Splat8(1e-3f);
  const auto level = Splat8(1e-4f);
  Float8 m[10][10] = { { s.XXXX + flat }, { s.XXXY, s.XXYY + flat },
    { s.XXXZ, s.XXYZ, s.XXZZ + flat }, { s.XXYY, s.XYYY, s.XYYZ, s.YYYY + flat },
    { s.XXYZ, s.XYYZ, s.XYZZ, s.YYYZ, s.YYZZ + flat },
    { s.XXZZ, s.XYZZ, s.XZZZ, s.YYZZ, s.YZZZ, s.ZZZZ + flat },
    { s.XXX, s.XXY, s.XXZ, s.XYY, s.XYZ, s.XZZ, s.XX + level },
    { s.XXY, s.XYY, s.XYZ, s.YYY, s.YYZ, s.YZZ, s.XY, s.YY + level },
    { s.XXZ, s.XYZ, s.XZZ, s.YYZ, s.YZZ, s.ZZZ, s.XZ, s.YZ, s.ZZ + level },
    { s.XX, s.XY, s.XZ, s.YY, s.YZ, s.ZZ, s.X, s.Y, s.Z, s.One } };
  Float8 g[10];
  SolveForLast(m, g);
  for (std::size_t i = 0; i < lanes.Neighbors; ++i)
  {
    const auto x = Load<Float8>(lanes.X[i]);
    const auto y = Load<Float8>(lanes.Y[i]);
    const auto z = Load<Float8>(lanes.Z[i]);
    const auto value = g[9] + x * g[6] + y * g[7] + z * g[8] + x * x * g[0] + x * y * g[1] +
      x * z * g[2] + y * y * g[3] + y * z * g[4] + z * z * g[5];
    Store(lanes.Quadratic[i], Load<Float8>(lanes.Quadratic[i]) * value);
  }
}

GATUN_INLINE void FitLinear(QuadraticLanes& lanes)
{
  Float8 one{}, sx{}, sy{}, sz{}, xx{}, xy{}, xz{}, yy{}, yz{}, zz{};
  for (std::size_t i = 0; i < lanes.Neighbors; ++i)
  {
    const auto x = Load<Float8>(lanes.X[i]);
    const auto y = Load<Float8>(lanes.Y[i]);
    const auto z = Load<Float8>(lanes.Z[i]);
    const auto near = Load<Float8>(lanes.Near[i]);
    const auto h = near * near;
    Store(lanes.Linear[i], h);
    const auto hx = h * x, hy = h * y, hz = h * z;
    one += h;
    sx += hx;
    sy += hy;
    sz += hz;
    xx += hx * x;
    xy += hx * y;
    xz += hx * z;
    yy += hy * y;
    yz += hy * z;
    zz += hz * z;
  }
  const auto level = Splat8(1e-3f);
  Float8 m[4][4] = { { xx + level }, { xy, yy + level }, { xz, yz, zz + level },
    { sx, sy, sz, one } };
  Float8 g[4];
  SolveForLast(m, g);
  for (std::size_t i = 0; i < lanes.Neighbors; ++i)
  {
    const auto value = g[3] + Load<Float8>(lanes.X[i]) * g[0] + Load<Float8>(lanes.Y[i]) * g[1] +
      Load<Float8>(lanes.Z[i]) * g[2];
    Store(lanes.Linear[i], Load<Float8>(lanes.Linear[i]) * value);
  }
}

/** Replaces weights by equal ones if they are too large or no numbers. */
GATUN_INLINE void Check(const QuadraticLanes& lanes, QuadraticLanes::Lane* weights)
{
  const auto zero = Splat8(0.0f);
  Float8 sum{};
  for (std::size_t i = 0; i < lanes.Neighbors; ++i)
  {
    const auto w = Load<Float8>(weights[i]);
    sum += w < zero ? -w : w;
  }
  const auto isSmall = sum <= Splat8(1e4f);
  const auto equal = Load<Float8>(lanes.Equal);
  for (std::size_t i = 0; i < lanes.Neighbors; ++i)
  {
    Store(weights[i], isSmall ? Load<Float8>(weights[i]) : equal);
  }
}

inline void FindWeights(QuadraticLanes& lanes)
{
  Normalize(lanes);
  FindShares(lanes);
  Whiten(lanes);
  FindNear(lanes);
  FitQuadratic(lanes);
  FitLinear(lanes);
  Check(lanes, lanes.Quadratic);
  Check(lanes, lanes.Linear);
}
}
}

#endif
