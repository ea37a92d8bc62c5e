// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunRuleFitter_h
#define gatunRuleFitter_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace gatun
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

/**
 * Finds the weights of known numbers that predict another one with the least squared error. The
 * weights are in units of 1/256, and their sum is 1. Center: the number that the others are
 * relative to.
 */
template <std::size_t Slots, unsigned Center>
class RuleFitter
{
public:
  void Add(const std::array<double, Slots>& numbers, double actual)
  {
    std::array<double, Unknowns> offset{};
    double square = 0;
    for (unsigned k = 0, u = 0; k < Slots; ++k)
    {
      if (k != Center)
      {
        offset[u] = numbers[k] - numbers[Center];
        square += offset[u] * offset[u];
        ++u;
      }
    }
    const double wanted = actual - numbers[Center];
    const double weight = 1.0 / square;
    if (!std::isfinite(weight) || !std::isfinite(wanted))
    {
      return;
    }
    for (std::size_t r = 0; r < Unknowns; ++r)
    {
      this->Right[r] += weight * offset[r] * wanted;
      for (std::size_t c = 0; c < Unknowns; ++c)
      {
        this->Normal[r][c] += weight * offset[r] * offset[c];
      }
    }
  }

  std::array<std::int16_t, Slots> Fit() const
  {
    auto normal = this->Normal;
    auto right = this->Right;
    for (std::size_t r = 0; r < Unknowns; ++r)
    {
      normal[r][r] += 1e-9 + 1e-6 * normal[r][r];
    }
    std::array<std::int16_t, Slots> rule{};
    rule[Center] = 256;
    if (Solve(normal, right))
    {
      for (unsigned k = 0, u = 0; k < Slots; ++k)
      {
        if (k != Center)
        {
          const double weight = std::floor(256.0 * right[u] + 0.5);
          const auto bounded = std::isfinite(weight) ? std::clamp(weight, -1024.0, 1024.0) : 0.0;
          rule[k] = static_cast<std::int16_t>(bounded);
          rule[Center] = static_cast<std::int16_t>(rule[Center] - rule[k]);
          ++u;
        }
      }
    }
    return rule;
  }

private:
  static constexpr std::size_t Unknowns = Slots - 1;

  std::array<std::array<double, Unknowns>, Unknowns> Normal{};
  std::array<double, Unknowns> Right{};
};
}

#endif
