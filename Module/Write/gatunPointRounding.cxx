// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPointRounding.h"

#include "gatunError.h"
#include "gatunParallel.h"
#include "gatunTurnedCells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iomanip>
#include <limits>
#include <span>
#include <sstream>
#include <vector>

namespace gatun
{
namespace
{
constexpr int MostBits = 31;
constexpr std::size_t PointsPerTask = 1 << 16;
constexpr unsigned MaxFineness = 32;

/** The number of points that may be on finer lattices. */
std::size_t GetMostFine(std::size_t points)
{
  constexpr std::size_t always = 16;
  return std::max(points / 100, always);
}

std::size_t CountFine(const std::vector<std::uint8_t>& fineness)
{
  return fineness.size() -
    static_cast<std::size_t>(std::count(fineness.begin(), fineness.end(), std::uint8_t{ 0 }));
}

/** Places that coordinates are rounded to. */
struct Lattice
{
  std::array<double, 3> Origin{};
  double Step = 0;
  double MostError = 0; // what is farther away stays

  /** fineness: how often the step is halved; MaxFineness leaves the value as it is. */
  template <typename T>
  T Round(T value, std::size_t axis, unsigned fineness) const
  {
    // Beyond this, all numbers are multiples of the step.
    constexpr double large = 4503599627370496.0; // 2^52
    const double step = std::ldexp(this->Step, -static_cast<int>(fineness));
    const double place = (static_cast<double>(value) - this->Origin[axis]) / step;
    if (fineness >= MaxFineness)
    {
      return value;
    }
    if (!(std::abs(place) < large))
    {
      return value; // infinity and NaN, too
    }
    const double rounded = this->Origin[axis] + std::nearbyint(place) * step;
    const auto result = std::abs(rounded) <= std::numeric_limits<T>::max() && rounded != 0
      ? static_cast<T>(rounded)
      : T{ 0 };
    const double error = std::abs(static_cast<double>(result) - static_cast<double>(value));
    return error <= this->MostError ? result : value; // -0 becomes 0
  }
};

/** The box of the coordinates that are finite. */
struct Box
{
  template <typename T>
  explicit Box(std::span<const T> values)
  {
    std::array<double, 3> largest;
    this->Least.fill(std::numeric_limits<double>::infinity());
    largest.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const auto axis = i % 3;
      const auto value = static_cast<double>(values[i]);
      if (std::isfinite(value))
      {
        this->Least[axis] = std::min(this->Least[axis], value);
        largest[axis] = std::max(largest[axis], value);
      }
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (this->Least[axis] <= largest[axis])
      {
        this->Side = std::max(this->Side, largest[axis] - this->Least[axis]);
      }
      else
      {
        this->Least[axis] = 0;
      }
    }
  }

  std::array<double, 3> Least;
  double Side = 0; // the longest
};

//------------------------------------------------------------------------------
Lattice MakeLattice(double error)
{
  // Multiples of a power of two are exact as floating-point numbers.
  constexpr int mostExponent = 1023;
  Lattice lattice;
  lattice.Step = error > 0 ? std::ldexp(1.0, std::min(std::ilogb(error) + 1, mostExponent)) : 0;
  lattice.MostError = error;
  return lattice;
}

//------------------------------------------------------------------------------
Lattice MakeLattice(const Box& box, int bits)
{
  Lattice lattice;
  lattice.Origin = box.Least;
  lattice.Step = box.Side / (std::ldexp(1.0, bits) - 1);
  lattice.MostError = lattice.Step;
  return lattice;
}

//------------------------------------------------------------------------------
/** Rounds coordinates. Returns the largest difference. fineness: of each point. */
template <typename T>
double RoundValues(
  std::span<const T> from, const Lattice& lattice, const std::vector<std::uint8_t>& fineness, T* to)
{
  const auto count = fineness.size();
  std::vector<double> errors(count / PointsPerTask + 1);
  ParallelFor(errors.size(),
    [&](std::size_t task)
    {
      const std::size_t end = 3 * std::min(count, (task + 1) * PointsPerTask);
      for (std::size_t i = 3 * task * PointsPerTask; i < end; ++i)
      {
        to[i] = lattice.Round(from[i], i % 3, fineness[i / 3]);
        const double error = std::abs(static_cast<double>(to[i]) - static_cast<double>(from[i]));
        errors[task] = std::max(errors[task], std::isfinite(error) ? error : 0.0);
      }
    });
  return *std::max_element(errors.begin(), errors.end());
}

//------------------------------------------------------------------------------
template <typename T>
CornerTets::PlaceOf GetPlaces(const T* points)
{
  return [points](std::uint64_t point)
  {
    const auto* const p = points + 3 * point;
    return std::array{ static_cast<double>(p[0]), static_cast<double>(p[1]),
      static_cast<double>(p[2]) };
  };
}

//------------------------------------------------------------------------------
/** Throws that too many points need finer lattices, and suggests a tolerance that works. */
template <typename T>
[[noreturn]] void RefuseTurned(
  std::span<const T> from, const CornerTets& tets, double error, bool isWhole, std::size_t turned)
{
  const auto points = from.size() / 3;
  const std::size_t most = isWhole ? GetMostFine(points) : 0;
  std::vector<T> to(from.size());
  const std::vector<std::uint8_t> coarse(points);
  std::ostringstream message;
  message << "with this tolerance of coordinates, cells turn over at " << turned
          << " corners, and ";
  message << (isWhole ? "more than 1 % of the points would have to be finer"
                      : "points of several pieces cannot be finer than others");
  constexpr unsigned decades = 12;
  unsigned i = 0;
  for (; i < decades; ++i)
  {
    error /= 10;
    RoundValues(from, MakeLattice(error), coarse, to.data());
    std::vector<std::uint8_t> marks(points);
    tets.MarkTurned(GetPlaces(to.data()), marks);
    if (CountFine(marks) <= most)
    {
      message << "; a tolerance of " << std::setprecision(2) << error << " works";
      break;
    }
  }
  ThrowInvalid(message.str() + (i == decades ? "; write them without a tolerance" : ""));
}

//------------------------------------------------------------------------------
/** Rounds coordinates so that no cell turns over. Returns the largest difference. */
template <typename T>
double RoundUpright(
  const MeshInput& mesh, std::span<const T> from, const Lattice& lattice, bool isWhole, T* to)
{
  const CornerTets tets(MeshAccess(mesh), GetPlaces(from.data()));
  const auto points = from.size() / 3;
  std::vector<std::uint8_t> fineness(points);
  for (;;)
  {
    const double error = RoundValues(from, lattice, fineness, to);
    const std::size_t turned = tets.MarkTurned(GetPlaces(to), fineness);
    if (turned == 0)
    {
      return error;
    }
    if (!isWhole || CountFine(fineness) > GetMostFine(points))
    {
      RefuseTurned(from, tets, lattice.MostError, isWhole, turned);
    }
  }
}

//------------------------------------------------------------------------------
template <typename T>
double RoundAs(const MeshInput& mesh, const ErrorBound& bound, bool isWhole, void* to)
{
  const std::span from(
    static_cast<const T*>(mesh.Coordinates), 3 * static_cast<std::size_t>(mesh.Points));
  const Box box(from);
  const Lattice lattice = bound.Kind == ErrorKind::Bits
    ? MakeLattice(box, static_cast<int>(bound.Bound))
    : MakeLattice(bound.Bound * (bound.Kind == ErrorKind::Relative ? box.Side : 1));
  const double error =
    lattice.Step > 0 ? RoundUpright(mesh, from, lattice, isWhole, static_cast<T*>(to)) : 0;
  if (error == 0 && !from.empty())
  {
    std::memcpy(to, from.data(), from.size_bytes()); // -0 stays
  }
  return error;
}
}

//------------------------------------------------------------------------------
void CheckPointBound(const ErrorBound& bound)
{
  if (bound.KeepZeros)
  {
    ThrowInvalid("a tolerance of coordinates cannot keep zeros");
  }
  const double value = bound.Bound;
  switch (bound.Kind)
  {
    case ErrorKind::None:
      return;
    case ErrorKind::Absolute:
      if (!(value > 0 && std::isfinite(value)))
      {
        ThrowInvalid("the tolerance of coordinates must be a finite number above 0");
      }
      return;
    case ErrorKind::Relative:
      if (!(value > 0 && value < 1))
      {
        ThrowInvalid("the tolerance of coordinates, relative to the longest side of the bounding "
                     "box, must be a number above 0 and below 1");
      }
      return;
    case ErrorKind::Bits:
      if (!(value >= 1 && value <= MostBits && value == std::floor(value)))
      {
        ThrowInvalid("coordinates must have a whole number of bits from 1 to 31");
      }
      return;
    default:
      ThrowInvalid("the tolerance of coordinates must be absolute, relative to the longest side of "
                   "the bounding box, or a number of bits");
  }
}

//------------------------------------------------------------------------------
double RoundPoints(const MeshInput& mesh, const ErrorBound& bound, bool isWhole, void* to)
{
  return mesh.CoordinateType == ScalarType::Float32 ? RoundAs<float>(mesh, bound, isWhole, to)
                                                    : RoundAs<double>(mesh, bound, isWhole, to);
}
}
