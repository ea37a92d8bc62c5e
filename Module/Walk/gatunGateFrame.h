// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGateFrame_h
#define gatunGateFrame_h

// The shape of a gate, and where the tetrahedron on it is expected to have its apex, in meshes of
// well-shaped tetrahedra.

#include "gatunDomain.h"
#include "gatunInline.h"
#include "gatunTopology.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace gatun
{
/** Where the apex of a tetrahedron is expected, in units of 1/256. */
struct FrameRule
{
  enum Weight : std::uint8_t
  {
    Height,         ///< over the gate, in lengths of edges
    AcrossOfCenter, ///< of the way from the gate's middle to the center of its circle
    AcrossOfFar,    ///< of the way to a corner if the far corner on the other side is high
    Across,         ///< standard deviation across the normal, in lengths of edges
    Along,          ///< and along it
    Count
  };

  std::array<std::int16_t, Count> Weights{};

  double Get(Weight weight) const { return this->Weights[weight] * (1.0 / 256.0); }
  bool IsValid() const { return this->Weights[Across] > 0 && this->Weights[Along] > 0; }
};

using FrameVector = std::array<double, 3>;

GATUN_INLINE double Dot(const FrameVector& a, const FrameVector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** The shape of a gate and of its surroundings. */
class GateFrame
{
public:
  using Numbers = std::array<double, 4>;

  GATUN_INLINE GateFrame(const GateRecord& record, std::span<const Numbers> numbers)
  {
    const auto get = [&](unsigned k) -> const Numbers& { return numbers[record.Known[k]]; };
    const Numbers& a = get(0);
    const Numbers& b = get(1);
    const Numbers& c = get(2);
    std::array<FrameVector, 3> corners;
    for (unsigned i = 0; i < 3; ++i)
    {
      this->Middle[i] = (a[i] + b[i] + c[i]) * (1.0 / 3.0);
      corners[0][i] = a[i] - this->Middle[i];
      corners[1][i] = b[i] - this->Middle[i];
      corners[2][i] = c[i] - this->Middle[i];
    }
    const FrameVector u = Subtract(b, a);
    const FrameVector v = Subtract(c, a);
    const FrameVector w = Subtract(c, b);
    const double uu = Dot(u, u);
    const double vv = Dot(v, v);
    const double ww = Dot(w, w);
    const FrameVector cross = Cross(u, v);
    const double nn = Dot(cross, cross);
    const double inverse = 1.0 / nn;
    if (nn > 0)
    {
      const double root = std::sqrt(inverse);
      const double unit = Dot(cross, Subtract(a, get(3))) < 0 ? -root : root;
      for (unsigned i = 0; i < 3; ++i)
      {
        this->Normal[i] = cross[i] * unit;
      }
    }
    // The center is far away from a corner with a large angle.
    if (uu * vv * ww * inverse * 0.75 <= uu + vv + ww)
    {
      const FrameVector p = Cross(v, cross);
      const FrameVector q = Cross(cross, u);
      for (unsigned i = 0; i < 3; ++i)
      {
        this->Center[i] = a[i] + (uu * p[i] + vv * q[i]) * (0.5 * inverse) - this->Middle[i];
      }
    }
    double sum = 0;
    for (unsigned k = 0; k < 3; ++k)
    {
      const FrameVector far = Subtract(get(4 + k), this->Middle);
      const double height = Dot(this->Normal, far);
      const FrameVector e = Subtract(far, corners[(k + 1) % 3]);
      const FrameVector f = Subtract(far, corners[(k + 2) % 3]);
      const double ee = Dot(e, e);
      const double ff = Dot(f, f);
      sum += (ee + ff) / (ee * ff);
      const double high = height > 0 ? height : 0;
      for (unsigned i = 0; i < 3; ++i)
      {
        this->Far[i] += high * corners[k][i];
      }
    }
    this->Size = std::sqrt(6.0 / sum);
  }

  FrameVector Middle{};
  FrameVector Normal{}; // away from the apex on the other side
  FrameVector Center{}; // of the circle, from the middle
  FrameVector Far{};    // the corners times the heights of the far corners on their other sides
  double Size = 0;      // a mean of the edges to the far corners, to which short ones count most

private:
  template <typename A, typename B>
  static FrameVector Subtract(const A& a, const B& b)
  {
    return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
  }

  static FrameVector Cross(const FrameVector& a, const FrameVector& b)
  {
    return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  }
};

/** The rule with the least squared errors. Nothing if the numbers are not of a well-shaped mesh. */
std::optional<FrameRule> FitFrame(std::span<const GateRecord> records, std::span<const Vertex> ids,
  std::span<const std::array<Key, 3>> keys, const std::array<Domain, 3>& domain);
}

#endif
