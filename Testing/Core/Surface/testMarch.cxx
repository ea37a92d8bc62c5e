// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The triangles of March against sections that are found in another way: the crossed edges sorted
// by their angle around the middle of the section.

#include "gatunError.h"
#include "gatunMarch.h"
#include "gatunTestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <span>

namespace gatun::test
{
namespace
{
using Position = std::array<double, 3>;
using Edge = std::pair<std::uint32_t, std::uint32_t>; // the point below, the point above

Position Subtract(const Position& a, const Position& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Position Cross(const Position& a, const Position& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double Dot(const Position& a, const Position& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** A mesh with a value at each point. */
struct Field
{
  std::vector<Position> Points;
  std::vector<std::array<std::int64_t, 4>> Tets;
  std::vector<double> Values;

  Field() = default;

  explicit Field(const TestMesh& mesh)
  {
    for (std::size_t i = 0; i < mesh.GetPoints(); ++i)
    {
      const double* x = &mesh.Coordinates[3 * i];
      this->Points.push_back({ x[0], x[1], x[2] });
    }
    for (std::size_t i = 0; i < mesh.GetTets(); ++i)
    {
      const auto* ids = &mesh.Ids[4 * i];
      this->Tets.push_back({ ids[0], ids[1], ids[2], ids[3] });
    }
  }

  const Position& At(std::int64_t id) const { return this->Points[static_cast<std::size_t>(id)]; }
  double ValueAt(std::int64_t id) const { return this->Values[static_cast<std::size_t>(id)]; }

  bool IsTurnedOver(std::size_t tet) const
  {
    const auto& ids = this->Tets[tet];
    const Position& a = this->At(ids[0]);
    return Dot(Cross(Subtract(this->At(ids[1]), a), Subtract(this->At(ids[2]), a)),
             Subtract(this->At(ids[3]), a)) < 0;
  }

  /** Whether the isovalue passes through it, and with how many triangles. */
  unsigned CountTriangles(std::size_t tet, double value) const
  {
    unsigned above = 0;
    for (const auto id : this->Tets[tet])
    {
      if (!std::isfinite(this->ValueAt(id)))
      {
        return 0;
      }
      above += this->ValueAt(id) >= value ? 1 : 0;
    }
    return above == 0 || above == 4 ? 0 : above == 2 ? 2 : 1;
  }

  /** The edges that an isovalue crosses, around the section: seen from below counterclockwise, from
   * above if the tetrahedron is turned over. The first is the least of them. */
  std::vector<Edge> GetSection(std::size_t tet, double value) const
  {
    Position below{};
    Position above{};
    std::vector<std::pair<Edge, Position>> crossed;
    double count[2] = { 0, 0 };
    for (const auto id : this->Tets[tet])
    {
      const bool isAbove = this->ValueAt(id) >= value;
      count[isAbove ? 1 : 0] += 1;
      for (unsigned axis = 0; axis < 3; ++axis)
      {
        (isAbove ? above : below)[axis] += this->At(id)[axis];
      }
      for (const auto other : this->Tets[tet])
      {
        if (!isAbove && this->ValueAt(other) >= value)
        {
          // Where on the edge does not change the order around the section.
          Position middle;
          for (unsigned axis = 0; axis < 3; ++axis)
          {
            middle[axis] = (this->At(id)[axis] + this->At(other)[axis]) / 2;
          }
          crossed.push_back(
            { { static_cast<std::uint32_t>(id), static_cast<std::uint32_t>(other) }, middle });
        }
      }
    }
    Position towards;
    Position center{};
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      towards[axis] = below[axis] / count[0] - above[axis] / count[1];
      for (const auto& point : crossed)
      {
        center[axis] += point.second[axis] / static_cast<double>(crossed.size());
      }
    }
    if (this->IsTurnedOver(tet))
    {
      towards = { -towards[0], -towards[1], -towards[2] };
    }
    const Position first = Cross(towards, Subtract(crossed[0].second, center));
    const Position second = Cross(towards, first);
    const double scale = std::sqrt(Dot(towards, towards));
    const auto angle = [&](const Position& x)
    {
      const Position d = Subtract(x, center);
      return std::atan2(Dot(d, second) / scale, Dot(d, first));
    };
    std::sort(crossed.begin(), crossed.end(),
      [&](const auto& a, const auto& b) { return angle(a.second) < angle(b.second); });
    std::vector<Edge> section;
    for (const auto& point : crossed)
    {
      section.push_back(point.first);
    }
    std::rotate(section.begin(), std::min_element(section.begin(), section.end()), section.end());
    return section;
  }
};

/** Runs March on copies of these types. */
template <typename Id, typename Value>
MarchedSurface MarchAs(const Field& field, const std::vector<double>& values,
  std::uint64_t first = 0, std::uint64_t last = ~std::uint64_t{ 0 })
{
  std::vector<Id> ids;
  for (const auto& tet : field.Tets)
  {
    ids.insert(ids.end(), tet.begin(), tet.end());
  }
  const std::vector<Value> pointValues(field.Values.begin(), field.Values.end());
  MarchInput input;
  input.Points = field.Points.size();
  input.Connectivity = ids.data();
  input.WideIds = sizeof(Id) == 8;
  input.Values = pointValues.data();
  input.WideValues = sizeof(Value) == 8;
  return March(input, first, std::min<std::uint64_t>(last, field.Tets.size()), values);
}

/** The edges around some triangles that no two of them have, in their order; the first is the least
 * of them. */
std::vector<Edge> GetBorder(
  const MarchedSurface& surface, std::span<const std::array<std::uint32_t, 3>> triangles)
{
  std::map<std::uint32_t, std::uint32_t> next;
  const auto has = [&](std::uint32_t from, std::uint32_t to)
  {
    return std::any_of(triangles.begin(), triangles.end(),
      [=](const auto& t)
      {
        return (t[0] == from && t[1] == to) || (t[1] == from && t[2] == to) ||
          (t[2] == from && t[0] == to);
      });
  };
  for (const auto& t : triangles)
  {
    for (unsigned i = 0; i < 3; ++i)
    {
      if (!has(t[(i + 1) % 3], t[i]))
      {
        next[t[i]] = t[(i + 1) % 3];
      }
    }
  }
  std::vector<Edge> border;
  std::uint32_t at = triangles[0][0];
  do
  {
    border.push_back({ surface.Points[at].Low, surface.Points[at].High });
    at = next.count(at) ? next[at] : at;
  } while (at != triangles[0][0] && border.size() < 10);
  std::rotate(border.begin(), std::min_element(border.begin(), border.end()), border.end());
  return border;
}

/** Checks all there is to a surface of tetrahedra first to last - 1. */
template <typename Value>
void ExpectRight(const Field& field, const MarchedSurface& surface,
  const std::vector<double>& values, std::size_t first = 0, std::size_t last = ~std::size_t{ 0 })
{
  Field rounded = field;
  for (auto& value : rounded.Values)
  {
    value = static_cast<Value>(value);
  }
  ASSERT_EQ(surface.Triangles.size(), surface.Cells.size());
  std::size_t at = 0;
  std::set<std::pair<Edge, double>> edges;
  std::vector<bool> used(surface.Points.size(), false);
  for (std::size_t tet = first; tet < std::min(last, field.Tets.size()); ++tet)
  {
    const auto& ids = field.Tets[tet];
    const bool isWhole = std::set<std::int64_t>(ids.begin(), ids.end()).size() == 4;
    for (const double value : values)
    {
      const unsigned count = rounded.CountTriangles(tet, value);
      ASSERT_LE(at + count, surface.Triangles.size());
      for (unsigned k = 0; k < count; ++k)
      {
        ASSERT_EQ(surface.Cells[at + k], tet);
        for (const auto place : surface.Triangles[at + k])
        {
          ASSERT_LT(place, surface.Points.size());
          const Crossing& point = surface.Points[place];
          const double low = rounded.Values[point.Low];
          const double high = rounded.Values[point.High];
          ASSERT_LT(low, value);
          ASSERT_GE(high, value);
          const auto part =
            (static_cast<long double>(value) - low) / (static_cast<long double>(high) - low);
          ASSERT_DOUBLE_EQ(point.Part, static_cast<double>(part));
          if (high == value)
          {
            ASSERT_EQ(point.Part, 1);
          }
          if (!used[place])
          {
            const auto edge = std::pair{ Edge{ point.Low, point.High }, value };
            ASSERT_TRUE(edges.insert(edge).second) << "two points on one edge";
            used[place] = true;
          }
        }
      }
      if (count > 0 && isWhole)
      {
        ASSERT_EQ(GetBorder(surface, { surface.Triangles.data() + at, count }),
          rounded.GetSection(tet, value))
          << "tetrahedron " << tet << ", isovalue " << value;
      }
      at += count;
    }
  }
  EXPECT_EQ(at, surface.Triangles.size());
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
}

template <typename Id, typename Value>
MarchedSurface ExpectRight(const Field& field, const std::vector<double>& values)
{
  const auto surface = MarchAs<Id, Value>(field, values);
  ExpectRight<Value>(field, surface, values);
  return surface;
}

/** A tetrahedron that is not turned over, with these values. */
Field MakeTet(const std::array<double, 4>& values)
{
  Field field;
  field.Points = { { 0, 0, 0 }, { 1.1, 0.1, 0 }, { 0.2, 0.9, 0.1 }, { 0.1, 0.2, 1.2 } };
  field.Tets = { { 0, 1, 2, 3 } };
  field.Values.assign(values.begin(), values.end());
  return field;
}

double MarchWave(const Position& x)
{
  return std::sin(1.3 * x[0]) * std::cos(0.9 * x[1]) + 0.4 * x[2];
}
}

//------------------------------------------------------------------------------
TEST(March, EveryCaseInEveryOrderOfTheCorners)
{
  std::array<std::int64_t, 4> order = { 0, 1, 2, 3 };
  int triangles = 0;
  do
  {
    for (unsigned inside = 0; inside < 16; ++inside)
    {
      Field field = MakeTet({});
      field.Tets = { order };
      for (unsigned i = 0; i < 4; ++i)
      {
        field.Values[i] = (inside >> i & 1) != 0 ? 1.5 + 0.25 * i : -2.0 + 0.125 * i;
      }
      triangles +=
        static_cast<int>(ExpectRight<std::int64_t, double>(field, { 0.25 }).Cells.size());
      ExpectRight<std::int32_t, float>(field, { 0.25 });
    }
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(triangles, 24 * (8 * 1 + 6 * 2));
}

//------------------------------------------------------------------------------
TEST(March, FrontsLookTowardsLowerValues)
{
  // The whole value falls along x: seen from the left, corners go round counterclockwise.
  for (const bool turned : { false, true })
  {
    Field field = MakeTet({});
    for (unsigned i = 0; i < 4; ++i)
    {
      field.Values[i] = field.Points[i][0];
    }
    if (turned)
    {
      std::swap(field.Tets[0][0], field.Tets[0][1]);
    }
    for (const double value : { 0.05, 0.15, 0.5 })
    {
      const auto surface = MarchAs<std::int64_t, double>(field, { value });
      ASSERT_FALSE(surface.Triangles.empty());
      for (const auto& triangle : surface.Triangles)
      {
        std::array<Position, 3> x;
        for (unsigned i = 0; i < 3; ++i)
        {
          const Crossing& point = surface.Points[triangle[i]];
          for (unsigned axis = 0; axis < 3; ++axis)
          {
            x[i][axis] = (1 - point.Part) * field.Points[point.Low][axis] +
              point.Part * field.Points[point.High][axis];
          }
          EXPECT_NEAR(x[i][0], value, 1e-15);
        }
        const Position normal = Cross(Subtract(x[1], x[0]), Subtract(x[2], x[0]));
        EXPECT_GT(turned ? normal[0] : -normal[0], 1e-6);
        EXPECT_NEAR(normal[1], 0, 1e-15);
        EXPECT_NEAR(normal[2], 0, 1e-15);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(March, CornersAtTheIsovalueAreAboveIt)
{
  // Each corner below, at or above the isovalue, in every combination.
  for (unsigned code = 0; code < 81; ++code)
  {
    std::array<double, 4> values;
    unsigned rest = code;
    for (double& value : values)
    {
      value = static_cast<double>(rest % 3) + 1; // 2 is the isovalue
      rest /= 3;
    }
    const auto surface = ExpectRight<std::int64_t, double>(MakeTet(values), { 2 });
    ExpectRight<std::int32_t, float>(MakeTet(values), { 2 });
    const auto below = std::count(values.begin(), values.end(), 1.0);
    EXPECT_EQ(surface.Cells.size(), below == 0 || below == 4 ? 0u : below == 2 ? 2u : 1u) << code;
  }
}

//------------------------------------------------------------------------------
TEST(March, CubesAtManyValues)
{
  Field field(MakeCubes(6, 0.2));
  for (const auto& point : field.Points)
  {
    field.Values.push_back(MarchWave(point));
  }
  std::vector<double> values(40);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = -1.5 + 0.11 * static_cast<double>(i); // the first and last are outside
  }
  values.push_back(field.Values[17]); // that of a point, exactly
  values.push_back(static_cast<float>(field.Values[99]));
  std::sort(values.begin(), values.end());
  EXPECT_GT((ExpectRight<std::int64_t, double>(field, values).Cells.size()), 10000u);
  ExpectRight<std::int64_t, float>(field, values);
  ExpectRight<std::int32_t, double>(field, values);
  ExpectRight<std::int32_t, float>(field, values);
  ExpectRight<std::int32_t, float>(field, { 0 });

  // The smallest value is not passed, the largest one is.
  const auto [least, most] = std::minmax_element(field.Values.begin(), field.Values.end());
  EXPECT_TRUE((MarchAs<std::int64_t, double>(field, { *least }).Cells.empty()));
  EXPECT_TRUE((MarchAs<std::int64_t, double>(field, { *least - 1, *most + 1 }).Cells.empty()));
  EXPECT_FALSE((ExpectRight<std::int64_t, double>(field, { *most }).Cells.empty()));
  EXPECT_TRUE((MarchAs<std::int64_t, double>(field, {}).Cells.empty()));
}

//------------------------------------------------------------------------------
TEST(March, WholeNumbersMeetCornersAllTheTime)
{
  Field field(MakeCubes(6, 0));
  for (const auto& point : field.Points)
  {
    field.Values.push_back(std::round(3 * MarchWave(point)));
  }
  ExpectRight<std::int64_t, double>(field, { -3, -2, -1, 0, 1, 2, 3, 4 });
  ExpectRight<std::int32_t, float>(field, { -3, -2.5, 0, 0.5, 1, 2, 5 });
}

//------------------------------------------------------------------------------
TEST(March, SoupWithRepeatedCorners)
{
  Field field(MakeSoup(60, 3000));
  for (const auto& point : field.Points)
  {
    field.Values.push_back(MarchWave(point));
  }
  ExpectRight<std::int64_t, double>(field, { -0.3, 0, 0.05, 0.3 });
  ExpectRight<std::int32_t, float>(field, { -0.3, 0, 0.05, 0.3 });
}

//------------------------------------------------------------------------------
TEST(March, PartsOfAMeshHaveTheirShare)
{
  Field field(MakeCubes(4, 0.2));
  for (const auto& point : field.Points)
  {
    field.Values.push_back(MarchWave(point));
  }
  // With one value, parts of fewer tetrahedra than the mesh has points are searched in another way.
  for (const std::vector<double>& values : { std::vector{ -0.2, 0.4, 0.41 }, std::vector{ 0.4 } })
  {
    const auto whole = ExpectRight<std::int64_t, double>(field, values);
    EXPECT_FALSE(whole.Cells.empty());
    std::vector<std::uint32_t> cells;
    const std::uint64_t cuts[] = { 0, 1, 1, 100, 383, 384 };
    for (std::size_t i = 0; i + 1 < std::size(cuts); ++i)
    {
      const auto part = MarchAs<std::int64_t, double>(field, values, cuts[i], cuts[i + 1]);
      ExpectRight<double>(field, part, values, cuts[i], cuts[i + 1]);
      cells.insert(cells.end(), part.Cells.begin(), part.Cells.end());
    }
    EXPECT_EQ(cells, whole.Cells);
  }
}

//------------------------------------------------------------------------------
TEST(March, ValuesThatAreNotFiniteHaveNoSurface)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : { infinity, -infinity, std::numeric_limits<double>::quiet_NaN() })
  {
    for (unsigned corner = 0; corner < 4; ++corner)
    {
      std::array<double, 4> values = { -1, 1, 2, -2 };
      values[corner] = bad;
      EXPECT_TRUE((MarchAs<std::int64_t, double>(MakeTet(values), { 0 }).Points.empty()));
      EXPECT_TRUE((MarchAs<std::int32_t, float>(MakeTet(values), { 0 }).Points.empty()));
    }
    Field field(MakeCubes(4, 0.1));
    for (std::size_t i = 0; i < field.Points.size(); ++i)
    {
      field.Values.push_back(i % 11 == 5 ? bad : MarchWave(field.Points[i]));
    }
    EXPECT_FALSE((ExpectRight<std::int64_t, double>(field, { 0, 0.5 }).Cells.empty()));
    ExpectRight<std::int64_t, float>(field, { 0, 0.5 });
    EXPECT_FALSE((ExpectRight<std::int64_t, double>(field, { 0 }).Cells.empty()));
    ExpectRight<std::int32_t, float>(field, { 0 });
  }
}

//------------------------------------------------------------------------------
TEST(March, HugeAndTinyDifferences)
{
  const double huge = 0x1p1023; // the difference of two of these is not finite
  const auto surface = ExpectRight<std::int64_t, double>(
    MakeTet({ -huge, huge, huge, huge }), { -huge / 2, 0, huge / 2, huge });
  ASSERT_EQ(surface.Points.size(), 12u);
  const double parts[] = { 0.25, 0.5, 0.75, 1 };
  for (std::size_t i = 0; i < 12; ++i)
  {
    EXPECT_EQ(surface.Points[i].Part, parts[i / 3]);
  }
  ExpectRight<std::int64_t, double>(MakeTet({ -huge, -1, 1, huge }), { -1e300, 0, 1e300 });
  ExpectRight<std::int32_t, float>(MakeTet({ -3e38, 3e38, -3e38, 3e38 }), { -1e38, 0, 3e38f });

  const double tiny = std::numeric_limits<double>::denorm_min();
  ExpectRight<std::int64_t, double>(
    MakeTet({ 0, tiny, 0, 3 * tiny }), { tiny, 2 * tiny, 3 * tiny });
  // So far below the other end that the part of the way is nothing.
  const auto nothing = MarchAs<std::int64_t, double>(MakeTet({ 0, huge, huge, huge }), { tiny });
  ASSERT_EQ(nothing.Points.size(), 3u);
  for (const auto& point : nothing.Points)
  {
    EXPECT_EQ(point, (Crossing{ 0, point.High, 0 }));
  }
}

//------------------------------------------------------------------------------
TEST(March, RefusesPointsThatDoNotExist)
{
  for (const std::int64_t bad :
    { std::int64_t{ 4 }, std::int64_t{ -1 }, std::int64_t{ 1 } << 31, std::int64_t{ 1 } << 32,
      std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min() })
  {
    for (unsigned corner = 0; corner < 4; ++corner)
    {
      Field field = MakeTet({ 0, 1, 0, 1 });
      field.Tets.push_back(field.Tets[0]);
      field.Tets[1][corner] = bad;
      const auto expectThrow = [&](auto&& run)
      {
        try
        {
          run();
          ADD_FAILURE() << bad;
        }
        catch (const Error& error)
        {
          EXPECT_EQ(error.Code, ErrorCode::InvalidInput);
          EXPECT_NE(std::string(error.what()).find("cell 1 "), std::string::npos) << error.what();
        }
      };
      expectThrow([&] { MarchAs<std::int64_t, double>(field, { 0.5 }); });
      if (bad == static_cast<std::int32_t>(bad))
      {
        expectThrow([&] { MarchAs<std::int32_t, float>(field, { 0.5 }); });
      }
    }
  }
}
}
