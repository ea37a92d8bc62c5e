// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMeasure_h
#define gatunMeasure_h

// How likely a vertex is the fourth corner of the tetrahedron behind a gate, judged by geometry.
//
// Every value here steers what the decoder does next, so encoder and decoder must agree to the
// last bit: IEEE binary64 with + - * / and sqrt in the order written, no contraction. The
// specification repeats each formula; change both or neither.

#include "gatunInline.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace gatun
{
/** A point on the 16-bit lattice of its chunk; the coordinates are whole numbers. */
struct alignas(32) LatticePoint
{
  double X = 0, Y = 0, Z = 0;
};

struct Vec3
{
  double X, Y, Z;
};

inline Vec3 operator-(const LatticePoint& a, const LatticePoint& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}

inline double Dot(const Vec3& a, const Vec3& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}

inline Vec3 Cross(const Vec3& a, const Vec3& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}

/** The rules by which candidates are ranked; the encoder chooses one for a chunk. */
enum class Ranking : std::uint8_t
{
  Sphere = 0, ///< least signed distance of the circumsphere's centre: Delaunay meshes
  Angle = 1   ///< least dihedral angle over the shared edge: split hexahedra
};

/** The rank of what is not in front of the gate. */
constexpr double NeverRank = std::numeric_limits<double>::infinity();

/** The plane of a gate. */
class GatePlane
{
public:
  GatePlane(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c)
    : A(a)
    , U(b - a)
    , V(c - a)
    , Normal(Cross(U, V))
    , NormalSquared(Dot(Normal, Normal))
  {
  }

  /** Times the length of the normal; exact, as lattice coordinates have 16 bits. */
  double GetHeight(const LatticePoint& d) const { return Dot(d - this->A, this->Normal); }

  /**
   * Minus the squared cosine of the dihedral angle at the gate's edge from s to e, with the sign of
   * the cosine: -1 for an angle of 0, 1 for 180 degrees.
   */
  double GetAngle(const LatticePoint& d, const LatticePoint& s, const LatticePoint& e) const
  {
    const Vec3 p = d - s;
    const double height = Dot(p, this->Normal);
    if (!(height > 0))
    {
      return NeverRank;
    }
    const Vec3 edge = e - s;
    const double inward = Dot(p, Cross(this->Normal, edge));
    const double square = inward * inward;
    const double angle = square / (square + height * height * Dot(edge, edge));
    return inward < 0 ? angle : -angle;
  }

  /** Whether d lies within about 6 degrees of the plane, as seen from the gate's corner s. */
  bool IsCoplanar(const LatticePoint& d, const LatticePoint& s) const
  {
    const Vec3 p = d - s;
    const double height = Dot(p, this->Normal);
    return height * height < 0.01 * (this->NormalSquared * Dot(p, p));
  }

  const LatticePoint A;
  const Vec3 U, V, Normal;
  const double NormalSquared;
};

/** The circumcircle of a gate. All that is not finite in here comes with heights of 0. */
class GateCircle
{
public:
  GATUN_INLINE explicit GateCircle(const GatePlane& plane)
  {
    const Vec3 w{ plane.V.X - plane.U.X, plane.V.Y - plane.U.Y, plane.V.Z - plane.U.Z };
    const double uu = Dot(plane.U, plane.U);
    const double vv = Dot(plane.V, plane.V);
    const double sides = uu * vv * Dot(w, w);
    const double inverse = 1.0 / plane.NormalSquared;
    const Vec3 p = Cross(plane.V, plane.Normal);
    const Vec3 q = Cross(plane.Normal, plane.U);
    this->Centre = { (uu * p.X + vv * q.X) * inverse, (uu * p.Y + vv * q.Y) * inverse,
      (uu * p.Z + vv * q.Z) * inverse };
    this->Unit = plane.NormalSquared / std::sqrt(sides);
    this->FourRadiusSquared = sides * inverse;
  }

  /**
   * Twice the signed distance from the gate's circumcentre to the centre of the sphere through the
   * gate and d, over the length of the normal.
   */
  GATUN_INLINE double GetSphere(const GatePlane& plane, const LatticePoint& d) const
  {
    const Vec3 p = d - plane.A;
    const double height = Dot(p, plane.Normal);
    const double distance = Dot(p, p) - Dot(p, this->Centre);
    return height > 0 ? distance / height : NeverRank;
  }

  /** Twice the vector from the gate's first corner to the circumcentre. */
  Vec3 Centre;

  /** Makes a rank of GetSphere a multiple of the radius. */
  double Unit;
  double FourRadiusSquared;
};

/** The exponent of a positive number: 2^result <= value < 2^(result + 1). */
inline int GetExponent(double value)
{
  return static_cast<int>(std::bit_cast<std::uint64_t>(value) >> 52 & 0x7ff) - 1023;
}
}

#endif
