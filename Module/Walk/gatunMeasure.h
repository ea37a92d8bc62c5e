// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunMeasure_h
#define gatunMeasure_h

// Geometric ranking of candidates for the fourth corner of the tetrahedron behind a gate.
//
// Every value affects the decoder's decisions, so encoder and decoder must agree bit for bit: IEEE
// binary32 with + - * / and sqrt in the order written, without contraction. The specification
// repeats each formula; never change only one of them.

#include "gatunInline.h"
#include "gatunLanes.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace gatun
{
/** A vertex on the lattice of its chunk: multiples of 1/256 from 0 to 255 + 255/256. */
struct alignas(16) LatticePoint
{
  float X = 0, Y = 0, Z = 0;

  /** Bit i is set if the i-th neighbor chunk uses the vertex, bit 31 for all further chunks. 0 for
   * own vertices. */
  std::uint32_t Users = 0;
};

/** A vector in the first three lanes. The last lane is unused: 0, or a result of 0. */
struct Vec3
{
  Float4 Lanes;

  GATUN_INLINE float operator[](std::size_t i) const { return this->Lanes[i]; }
};

/** Four vectors, one in each lane. */
struct Vec3x4
{
  Float4 X, Y, Z;
};

GATUN_INLINE Vec3 ToVector(const LatticePoint& p)
{
  return { KeepThree(std::bit_cast<Float4>(p)) };
}

GATUN_INLINE Vec3 operator-(const Vec3& a, const Vec3& b)
{
  return { a.Lanes - b.Lanes };
}

GATUN_INLINE Vec3x4 operator-(const Vec3x4& a, const Vec3x4& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}

GATUN_INLINE float Dot(const Vec3& a, const Vec3& b)
{
  const Float4 product = a.Lanes * b.Lanes;
  return product[0] + product[1] + product[2];
}

GATUN_INLINE Float4 Dot(const Vec3x4& a, const Vec3x4& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}

GATUN_INLINE Vec3 Cross(const Vec3& a, const Vec3& b)
{
  return { Rotate(a.Lanes * Rotate(b.Lanes) - Rotate(a.Lanes) * b.Lanes) };
}

GATUN_INLINE Vec3x4 Cross(const Vec3x4& a, const Vec3x4& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}

GATUN_INLINE Vec3x4 Gather(Float4 a, Float4 b, Float4 c, Float4 d)
{
  const auto ab = Interleave(a, b);
  const auto cd = Interleave(c, d);
  return { JoinLow(ab, cd), JoinHigh(ab, cd), JoinLow(InterleaveHigh(a, b), InterleaveHigh(c, d)) };
}

GATUN_INLINE Vec3x4 Gather(
  const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d)
{
  return Gather(std::bit_cast<Float4>(a), std::bit_cast<Float4>(b), std::bit_cast<Float4>(c),
    std::bit_cast<Float4>(d));
}

GATUN_INLINE Vec3x4 Splat(const Vec3& v)
{
  return { Splat(v[0]), Splat(v[1]), Splat(v[2]) };
}

GATUN_INLINE Vec3x4 Splat(const LatticePoint& p)
{
  return { Splat(p.X), Splat(p.Y), Splat(p.Z) };
}

/** The ranking of candidates. The encoder chooses one for each chunk. */
enum class Ranking : std::uint8_t
{
  Sphere = 0, ///< least signed distance of the circumsphere's center: Delaunay meshes
  Angle = 1   ///< least dihedral angle over the shared edge: split hexahedra
};

/** The rank of vertices that are not in front of the gate. */
constexpr float NeverRank = std::numeric_limits<float>::infinity();

/** The plane of a gate. */
class GatePlane
{
public:
  GATUN_INLINE GatePlane(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c)
    : A(a)
    , B(b)
    , C(c)
    , U(ToVector(b) - ToVector(a))
    , V(ToVector(c) - ToVector(a))
    , Normal(Cross(U, V))
    , NormalSquared(Dot(Normal, Normal))
  {
  }

  /**
   * Ranks the far vertices over the edges opposite to the corners a, b, c: minus the squared cosine
   * of the dihedral angle at the edge, with the sign of the cosine. -1 for 0 degrees, 1 for 180.
   */
  GATUN_INLINE Float4 GetAngles(const Vec3x4& far) const
  {
    const auto start = Gather(this->B, this->C, this->A, this->A);
    const auto edge = Gather(this->C, this->A, this->B, this->A) - start;
    const auto normal = Splat(this->Normal);
    const auto p = far - start;
    const auto height = Dot(p, normal);
    const auto inward = Dot(p, Cross(normal, edge));
    const auto square = inward * inward;
    const auto angle = square / (square + height * height * Dot(edge, edge));
    const auto zero = Splat(0.0F);
    return SelectGreater(
      height, zero, SelectGreater(zero, inward, angle, zero - angle), Splat(NeverRank));
  }

  /** Keeps the ranks of places in front of the gate. */
  GATUN_INLINE Float4 SelectInFront(const Vec3x4& places, Float4 ranks) const
  {
    const auto height = Dot(places - Splat(this->A), Splat(this->Normal));
    return SelectGreater(height, Splat(0.0F), ranks, Splat(NeverRank));
  }

  /** Whether d is within about 6 degrees of the plane, seen from the gate's corner s. */
  bool IsCoplanar(const LatticePoint& d, const LatticePoint& s) const
  {
    const Vec3 p = ToVector(d) - ToVector(s);
    const float height = Dot(p, this->Normal);
    return height * height < 0.01F * (this->NormalSquared * Dot(p, p));
  }

  const LatticePoint& A;
  const LatticePoint& B;
  const LatticePoint& C;
  const Vec3 U, V, Normal;
  const float NormalSquared;
};

/** The circumcircle of a gate. It is not finite only if heights are 0. */
class GateCircle
{
public:
  GATUN_INLINE explicit GateCircle(const GatePlane& plane)
  {
    const Vec3 w = plane.V - plane.U;
    const Float4 wSquares = w.Lanes * w.Lanes;
    const auto squares =
      Gather(plane.U.Lanes * plane.U.Lanes, plane.V.Lanes * plane.V.Lanes, wSquares, wSquares);
    const Float4 dots = squares.X + squares.Y + squares.Z; // u . u, v . v, w . w
    const float sides = dots[0] * dots[1] * dots[2];
    const float inverse = 1.0F / plane.NormalSquared;
    const Vec3 p = Cross(plane.V, plane.Normal);
    const Vec3 q = Cross(plane.Normal, plane.U);
    this->Center = { (Splat(dots[0]) * p.Lanes + Splat(dots[1]) * q.Lanes) * Splat(inverse) };
    this->Unit = plane.NormalSquared / std::sqrt(sides);
    this->FourRadiusSquared = sides * inverse;
  }

  /**
   * Twice the signed distance from the gate's circumcenter to the center of the sphere through the
   * gate and each of four places, divided by the length of the normal.
   */
  GATUN_INLINE Float4 GetSpheres(const GatePlane& plane, const Vec3x4& places) const
  {
    const auto p = places - Splat(plane.A);
    const auto height = Dot(p, Splat(plane.Normal));
    const auto distance = Dot(p, p) - Dot(p, Splat(this->Center));
    return SelectGreater(height, Splat(0.0F), distance / height, Splat(NeverRank));
  }

  /** Twice the vector from the gate's first corner to the circumcenter. */
  Vec3 Center;

  /** Converts a rank of GetSpheres to a multiple of the radius. */
  float Unit;
  float FourRadiusSquared;
};

/** The exponent of a positive number: 2^result <= value < 2^(result + 1). */
inline int GetExponent(float value)
{
  return static_cast<int>(std::bit_cast<std::uint32_t>(value) >> 23 & 0xff) - 127;
}
}

#endif
