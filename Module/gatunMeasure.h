// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunMeasure_h
#define gatunMeasure_h

// How likely a vertex is the fourth corner of the tetrahedron behind a gate, judged by geometry.
//
// Every value here steers what the decoder does next, so encoder and decoder must agree to the
// last bit: IEEE binary64 with + - * / and sqrt in the order written, no contraction. The
// specification repeats each formula; change both or neither.

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace gatun
{
/** A point on the 16-bit lattice of its chunk; the coordinates are whole numbers. */
struct LatticePoint
{
  float X = 0, Y = 0, Z = 0;
};

struct Vec3
{
  double X, Y, Z;
};

inline Vec3 operator-(const LatticePoint& a, const LatticePoint& b)
{
  return { static_cast<double>(a.X) - b.X, static_cast<double>(a.Y) - b.Y,
    static_cast<double>(a.Z) - b.Z };
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

/** The plane and the circumcircle of a gate, made once for all its candidates. */
class GateMeasure
{
public:
  static constexpr double Never = std::numeric_limits<double>::infinity();

  GateMeasure(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c)
    : A(a)
    , U(b - a)
    , V(c - a)
    , Normal(Cross(U, V))
    , NormalSquared(Dot(Normal, Normal))
    , Centre{ 0, 0, 0 }
  {
    if (this->NormalSquared > 0)
    {
      const Vec3 p = Cross(this->V, this->Normal);
      const Vec3 q = Cross(this->Normal, this->U);
      const double uu = Dot(this->U, this->U);
      const double vv = Dot(this->V, this->V);
      const double scale = 1.0 / (2.0 * this->NormalSquared);
      this->Centre = { (uu * p.X + vv * q.X) * scale, (uu * p.Y + vv * q.Y) * scale,
        (uu * p.Z + vv * q.Z) * scale };
    }
  }

  /**
   * Twice the signed distance from the gate's circumcentre to the centre of the sphere through the
   * gate and d, over the length of the normal; Never when d is not in front of the gate.
   */
  double GetSphere(const LatticePoint& d) const
  {
    const Vec3 p = d - this->A;
    const double height = Dot(p, this->Normal);
    if (!(height > 0))
    {
      return Never;
    }
    return (Dot(p, p) - 2.0 * Dot(p, this->Centre)) / height;
  }

  /** Minus the cotangent of the dihedral angle at the gate's edge from s to e, up to a factor. */
  double GetAngle(const LatticePoint& d, const LatticePoint& s, const LatticePoint& e) const
  {
    const Vec3 p = d - s;
    const double height = Dot(p, this->Normal);
    if (!(height > 0))
    {
      return Never;
    }
    const Vec3 edge = e - s;
    const Vec3 inward = Cross(this->Normal, edge);
    return -Dot(p, inward) / (height * std::sqrt(Dot(edge, edge)));
  }

  /** Makes a value of GetSphere independent of size: the distance over the circumcircle's radius. */
  double GetRelativeSphere(double sphere) const
  {
    return sphere * std::sqrt(this->NormalSquared / (4.0 * Dot(this->Centre, this->Centre)));
  }

  /** Makes a value of GetAngle a true cotangent (with its sign changed). */
  double GetRelativeAngle(double angle) const { return angle / std::sqrt(this->NormalSquared); }

  /** Whether d lies within about 6 degrees of the gate's plane, as seen from its corner s. */
  bool IsCoplanar(const LatticePoint& d, const LatticePoint& s) const
  {
    const Vec3 p = d - s;
    const double height = Dot(p, this->Normal);
    return height * height < 0.01 * (this->NormalSquared * Dot(p, p));
  }

  const LatticePoint A;
  const Vec3 U, V, Normal;
  const double NormalSquared;
  Vec3 Centre;
};
}

#endif
