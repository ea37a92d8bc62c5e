// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunOrientation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gatun
{
namespace
{
/** A sum of two numbers without rounding: Low is what High lacks. */
struct Pair
{
  double High = 0;
  double Low = 0;
};

// Volatile, so that no compiler simplifies what is left over by rounding.
Pair Add(double a, double b)
{
  const volatile double sum = a + b;
  const volatile double ofB = sum - a;
  const volatile double ofA = sum - ofB;
  const volatile double lackB = b - ofB;
  const volatile double lackA = a - ofA;
  return { sum, lackA + lackB };
}

Pair Multiply(double a, double b)
{
  const double product = a * b;
  return { product, std::fma(a, b, -product) };
}

/** A sum of numbers without rounding, as numbers that do not overlap, the largest one last
 * (Shewchuk: Adaptive Precision Floating-Point Arithmetic, 1997). */
class ExactSum
{
public:
  void Add(double number)
  {
    std::size_t kept = 0;
    for (const double part : this->Parts)
    {
      const Pair sum = gatun::Add(number, part);
      number = sum.High;
      if (sum.Low != 0)
      {
        this->Parts[kept] = sum.Low;
        ++kept;
      }
    }
    this->Parts.resize(kept);
    if (number != 0)
    {
      this->Parts.push_back(number);
    }
  }

  /** Adds a * b * c. */
  void AddProduct(const Pair& a, const Pair& b, const Pair& c, double sign)
  {
    for (const double x : { a.High, a.Low })
    {
      for (const double y : { b.High, b.Low })
      {
        const Pair xy = Multiply(x, y);
        for (const double z : { c.High, c.Low })
        {
          for (const double w : { xy.High, xy.Low })
          {
            const Pair product = Multiply(w, z);
            this->Add(sign * product.High);
            this->Add(sign * product.Low);
          }
        }
      }
    }
  }

  int GetSign() const { return this->Parts.empty() ? 0 : this->Parts.back() > 0 ? 1 : -1; }

private:
  std::vector<double> Parts;
};

using Rows = std::array<std::array<double, 3>, 3>;

/** The sign of a determinant, or 2 if rounding may have changed it. */
int GetLikelySign(const Rows& m)
{
  const double x = m[1][1] * m[2][2] - m[1][2] * m[2][1];
  const double y = m[1][2] * m[2][0] - m[1][0] * m[2][2];
  const double z = m[1][0] * m[2][1] - m[1][1] * m[2][0];
  const double determinant = m[0][0] * x + m[0][1] * y + m[0][2] * z;
  const double size =
    std::abs(m[0][0]) * (std::abs(m[1][1] * m[2][2]) + std::abs(m[1][2] * m[2][1])) +
    std::abs(m[0][1]) * (std::abs(m[1][2] * m[2][0]) + std::abs(m[1][0] * m[2][2])) +
    std::abs(m[0][2]) * (std::abs(m[1][0] * m[2][1]) + std::abs(m[1][1] * m[2][0]));
  // Each of about ten roundings, those of the differences among them, changes it by less than this.
  const double bound = 16 * std::numeric_limits<double>::epsilon() * size;
  constexpr double least = 1e-280; // below, numbers lose digits
  return std::abs(determinant) > bound && size > least ? (determinant > 0 ? 1 : -1) : 2;
}
}

//------------------------------------------------------------------------------
int GetOrientation(const std::array<double, 3>& a, const std::array<double, 3>& b,
  const std::array<double, 3>& c, const std::array<double, 3>& d)
{
  const std::array others{ &b, &c, &d };
  double largest = 0;
  for (const auto* point : { &a, &b, &c, &d })
  {
    for (const double x : *point)
    {
      if (!std::isfinite(x))
      {
        return 0;
      }
      largest = std::max(largest, std::abs(x));
    }
  }
  if (largest == 0)
  {
    return 0;
  }
  // Powers of two change no digits, and products neither overflow nor lose digits.
  const int exponent = -std::ilogb(largest) - 2;
  Rows rows;
  std::array<std::array<Pair, 3>, 3> exact;
  for (std::size_t row = 0; row < 3; ++row)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      exact[row][k] = Add(std::ldexp((*others[row])[k], exponent), -std::ldexp(a[k], exponent));
      rows[row][k] = exact[row][k].High;
    }
  }
  const int likely = GetLikelySign(rows);
  if (likely != 2)
  {
    return likely;
  }
  ExactSum sum;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t next = (k + 1) % 3;
    const std::size_t last = (k + 2) % 3;
    sum.AddProduct(exact[0][k], exact[1][next], exact[2][last], 1);
    sum.AddProduct(exact[0][k], exact[1][last], exact[2][next], -1);
  }
  return sum.GetSign();
}
}
