// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Isosurfaces assembled from parts, and their normals.

#include "gatunError.h"
#include "gatunParallel.h"
#include "gatunSurfaceSamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <set>

namespace gatun::test
{
//------------------------------------------------------------------------------
TEST(Surface, IsThatOfEveryTetrahedronPutTogether)
{
  // More tetrahedra than there are in a part.
  Sample sample(MakeCubes(24, 0.2));
  sample.Fill(Wave);
  sample.Values[4000] = 0.5; // met exactly
  SurfaceOptions options;
  options.Values = { -0.5, 0.5, 1.25 };
  for (const auto type : { ScalarType::Float64, ScalarType::Float32 })
  {
    options.CoordinateType = type;
    const auto parts = MakeSurfaceParts(sample.Get(), options, sample.Mesh.GetTets());
    ASSERT_EQ(parts.size(), 2u);
    ASSERT_FALSE(parts[1].Triangles.empty());
    const auto check = [&]<typename T>(T)
    {
      using Corners = std::array<std::array<T, 3>, 3>;
      // The first way: one tetrahedron after the other.
      std::vector<std::pair<Corners, std::int32_t>> expected;
      const auto marched = March(sample.Get().Mesh, 0, sample.Mesh.GetTets(), options.Values);
      for (std::size_t i = 0; i < marched.Triangles.size(); ++i)
      {
        Corners corners;
        for (unsigned k = 0; k < 3; ++k)
        {
          const Crossing& point = marched.Points[marched.Triangles[i][k]];
          const Vector low = sample.Point(point.Low);
          const Vector high = sample.Point(point.High);
          for (unsigned axis = 0; axis < 3; ++axis)
          {
            corners[k][axis] = static_cast<T>(
              point.Part == 1 ? high[axis] : low[axis] + point.Part * (high[axis] - low[axis]));
          }
        }
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
        {
          expected.push_back({ corners, sample.Cells[marched.Cells[i]] });
        }
      }
      EXPECT_LT(expected.size(), marched.Triangles.size()); // some have no area

      const Content<T> content{ Surface(parts, type) };
      std::vector<std::pair<Corners, std::int32_t>> found;
      for (std::size_t i = 0; i < content.Triangles.size(); ++i)
      {
        const auto& t = content.Triangles[i];
        found.push_back(
          { { content.Point(t[0]), content.Point(t[1]), content.Point(t[2]) }, content.Cells[i] });
      }
      EXPECT_EQ(found, expected); // in the same order, too
      std::set<std::array<T, 3>> different;
      std::vector<bool> used(content.Points.size() / 3, false);
      for (const auto& t : content.Triangles)
      {
        used[t[0]] = used[t[1]] = used[t[2]] = true;
      }
      for (std::size_t i = 0; i < used.size(); ++i)
      {
        EXPECT_TRUE(used[i]);
        EXPECT_TRUE(different.insert(content.Point(i)).second);
        // What is interpolated is what belongs there.
        EXPECT_TRUE(std::any_of(options.Values.begin(), options.Values.end(),
          [&](double v) { return std::abs(v - content.Values[i]) < 1e-12; }));
        for (unsigned axis = 0; axis < 3; ++axis)
        {
          EXPECT_NEAR(content.Vectors[3 * i + axis], content.Points[3 * i + axis], 4e-6);
        }
      }
    };
    type == ScalarType::Float64 ? check(double{}) : check(float{});
  }
}

//------------------------------------------------------------------------------
TEST(Surface, DoesNotDependOnTheNumberOfThreads)
{
  Sample sample(MakeCubes(24, 0.2));
  sample.Fill(Wave);
  SurfaceOptions options;
  options.Values = { -0.5, 0, 0.5, 1.25 };
  options.Normals = true;
  const Content<float> expected(Make(sample, options), true, true);
  ASSERT_FALSE(expected.Triangles.empty());
  // Within a body of ParallelFor, all runs on one thread.
  ParallelFor(1,
    [&](std::size_t) { EXPECT_EQ(Content<float>(Make(sample, options), true, true), expected); });
  EXPECT_EQ(Content<float>(Make(sample, options), true, true), expected);
}

//------------------------------------------------------------------------------
TEST(Surface, PointsWithTheSameCoordinatesAreTheFirstOfThem)
{
  const auto check = [](auto zero, ScalarType type)
  {
    using T = decltype(zero);
    using Point = std::array<T, 3>;
    const T minus = -zero;
    const std::vector<Point> one = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 5, 5, 5 } };
    const std::vector<Point> other = { { minus, minus, 0 }, { 2, 0, 0 }, { 1, minus, minus },
      { 0, minus, minus }, { 0, 0, 1 } };
    // Of the second part, the second triangle loses a side, and the point that it alone has.
    std::vector<SurfacePart> parts;
    parts.push_back(MakePart<T>(one, { { 0, 1, 2 } }, 10));
    parts.push_back(MakePart<T>({}, {}, 20));
    parts.push_back(MakePart<T>(other, { { 1, 2, 0 }, { 0, 3, 4 } }, 30));
    const Surface surface(std::move(parts), type);
    const Content<T> content(surface);
    EXPECT_EQ(content.Triangles, (std::vector<Triangle>{ { 0, 1, 2 }, { 3, 1, 0 } }));
    EXPECT_EQ(content.Points, (std::vector<T>{ 0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0 }));
    EXPECT_FALSE(std::signbit(content.Points[1]));
    EXPECT_EQ(content.Values, (std::vector<double>{ 10, 11, 12, 31 }));
    EXPECT_EQ(content.Cells, (std::vector<std::int32_t>{ 10, 30 }));
  };
  check(0.0f, ScalarType::Float32);
  check(0.0, ScalarType::Float64);
}

//------------------------------------------------------------------------------
TEST(Surface, GhostsGiveNothingButTheirGradients)
{
  using Point = std::array<double, 3>;
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  const std::vector<Point> around = { { 9, 9, 9 }, { 1, 0, 0 }, { 0, 0, 0 } };
  for (const std::size_t place : { 0, 1, 2 })
  {
    std::vector<SurfacePart> parts;
    for (std::size_t i = 0; i < 3; ++i)
    {
      parts.push_back(i == place ? MakePart<double>(points, { { 0, 1, 2 } }, 10, { 0, 0, 3 })
                                 : MakePart<double>(around, { { 0, 1, 2 } }, 10, { 0, -2, 0 }));
    }
    std::vector<std::size_t> ghosts = { 0, 1, 2 };
    ghosts.erase(ghosts.begin() + static_cast<std::ptrdiff_t>(place));
    const Surface surface(std::move(parts), ScalarType::Float64, ghosts);
    const Content<double> content(surface, true, true);
    ASSERT_EQ(content.Triangles.size(), 1u);
    ASSERT_EQ(content.Points.size(), 9u);
    EXPECT_EQ(content.Cells, std::vector<std::int32_t>{ 10 });
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto& point = content.Point(content.Triangles[0][i]);
      EXPECT_EQ(point, points[i]);
      // The sum is (0, -4, 3) where the ghosts have the point.
      const Vector expected = i == 2 ? Vector{ 0, 0, -1 } : Vector{ 0, 0.8f, -0.6f };
      EXPECT_EQ(content.Normal(content.Triangles[0][i]), expected);
    }
  }
}

//------------------------------------------------------------------------------
TEST(Surface, NothingIsNothing)
{
  const Surface empty({}, ScalarType::Float32);
  EXPECT_EQ(empty.GetNumberOfPoints(), 0u);
  EXPECT_EQ(empty.GetNumberOfTriangles(), 0u);
  empty.FillPoints(nullptr);
  empty.FillNormals(nullptr);
  Sample sample(MakeCubes(2, 0));
  sample.Fill([](const Vector&) { return 1; });
  SurfaceOptions options;
  options.Values = { 1 }; // all of the mesh is there, and nothing below
  EXPECT_EQ(Make(sample, options).GetNumberOfPoints(), 0u);
  // All of a corner: every triangle has its corners in one point.
  sample.Values.assign(sample.Values.size(), 0);
  sample.Values[13] = 1; // in the middle
  const auto parts = MakeSurfaceParts(sample.Get(), options, sample.Mesh.GetTets());
  EXPECT_GT(parts[0].Triangles.size(), 10u);
  const Surface point(parts, options.CoordinateType);
  EXPECT_EQ(point.GetNumberOfTriangles(), 0u);
  EXPECT_EQ(point.GetNumberOfPoints(), 0u);
}

//------------------------------------------------------------------------------
TEST(Surface, StopsWhenAsked)
{
  Sample sample(MakeCubes(24, 0.2));
  sample.Fill(Wave);
  SurfaceOptions options;
  options.Values = { 0 };
  try
  {
    MakeSurfaceParts(sample.Get(), options, sample.Mesh.GetTets(), [](double) { return false; });
    ADD_FAILURE();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Aborted);
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceNormals, OfALinearFieldAreExact)
{
  Sample sample(MakeCubes(5, 0));
  sample.Fill([](const Vector& x) { return x[0] + 2 * x[1] - 2 * x[2]; });
  SurfaceOptions options;
  options.Values = { -3.5, 0.25, 1, 7.5 };
  options.Normals = true;
  for (const bool turned : { false, true })
  {
    if (turned) // the gradient does not change with the orientation
    {
      for (std::size_t t = 0; t < sample.Mesh.Ids.size(); t += 8)
      {
        std::swap(sample.Mesh.Ids[t], sample.Mesh.Ids[t + 1]);
      }
    }
    const Content<float> content(Make(sample, options), false, true);
    ASSERT_GT(content.Normals.size(), 100u);
    for (std::size_t i = 0; i < content.Normals.size() / 3; ++i)
    {
      const Vector expected = { static_cast<float>(-1 / 3.0), static_cast<float>(-2 / 3.0),
        static_cast<float>(2 / 3.0) };
      ASSERT_EQ(content.Normal(i), expected);
    }
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceNormals, FrontsLookTheSameWayWhateverTheOrientation)
{
  Sample sample(MakeCubes(5, 0.1));
  const Vector slope = { 1, 2, -2 };
  sample.Fill([&](const Vector& x) { return slope[0] * x[0] + slope[1] * x[1] + slope[2] * x[2]; });
  SurfaceOptions options;
  options.Values = { -3.5, 0.25, 1, 7.5 };
  const std::size_t expected = Make(sample, options).GetNumberOfTriangles();
  for (const std::size_t turned : { 1, 2, 3 }) // all, every second and every third tetrahedron
  {
    Sample mixed(sample);
    for (std::size_t t = 0; t < mixed.Mesh.Ids.size(); t += 4 * turned)
    {
      std::swap(mixed.Mesh.Ids[t + 2], mixed.Mesh.Ids[t + 3]);
    }
    const Content<double> content(
      [&]
      {
        options.CoordinateType = ScalarType::Float64;
        return Make(mixed, options);
      }());
    EXPECT_EQ(content.Triangles.size(), expected);
    for (const Triangle& triangle : content.Triangles)
    {
      const Vector a = content.Point(triangle[0]);
      const Vector b = content.Point(triangle[1]);
      const Vector c = content.Point(triangle[2]);
      double along = 0; // the front's normal along the slope of the values
      double area = 0;
      for (unsigned i = 0; i < 3; ++i)
      {
        const unsigned j = (i + 1) % 3;
        const unsigned k = (i + 2) % 3;
        const double normal = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
        along += normal * slope[i];
        area += normal * normal;
      }
      ASSERT_LT(along, -2.99 * std::sqrt(area) + 1e-9);
    }
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceNormals, AreMeansOfGradientsWeightedByVolume)
{
  Sample sample(MakeCubes(5, 0.25));
  sample.Fill([](const Vector& x) { return Wave({ 3 * x[0], 3 * x[1], 5 * x[2] }); });
  SurfaceOptions options;
  options.Values = { -0.31, 0.42 };
  options.CoordinateType = ScalarType::Float64;
  options.Normals = true;
  // Of each edge that is crossed, the gradients of the tetrahedra around it, by Cramer's rule.
  std::map<Vector, Vector> sums;
  const auto determinant = [](const Vector& a, const Vector& b, const Vector& c)
  {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
      a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  for (std::size_t t = 0; t < sample.Mesh.GetTets(); ++t)
  {
    const auto* const ids = &sample.Mesh.Ids[4 * t];
    std::array<Vector, 3> edges;
    Vector rise;
    for (unsigned i = 0; i < 3; ++i)
    {
      for (unsigned axis = 0; axis < 3; ++axis)
      {
        edges[i][axis] = sample.Point(static_cast<std::size_t>(ids[i + 1]))[axis] -
          sample.Point(static_cast<std::size_t>(ids[0]))[axis];
      }
      rise[i] = sample.Values[static_cast<std::size_t>(ids[i + 1])] -
        sample.Values[static_cast<std::size_t>(ids[0])];
    }
    const double volume = determinant(edges[0], edges[1], edges[2]);
    Vector gradient;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      auto columns = edges;
      for (unsigned i = 0; i < 3; ++i)
      {
        columns[i][axis] = rise[i];
      }
      gradient[axis] = determinant(columns[0], columns[1], columns[2]) / volume;
    }
    for (const double value : options.Values)
    {
      for (unsigned i = 0; i < 4; ++i)
      {
        for (unsigned j = 0; j < 4; ++j)
        {
          const auto low = static_cast<std::size_t>(ids[i]);
          const auto high = static_cast<std::size_t>(ids[j]);
          if (sample.Values[low] < value && sample.Values[high] >= value)
          {
            const double part =
              (value - sample.Values[low]) / (sample.Values[high] - sample.Values[low]);
            Vector x;
            for (unsigned axis = 0; axis < 3; ++axis)
            {
              x[axis] = sample.Point(low)[axis] +
                part * (sample.Point(high)[axis] - sample.Point(low)[axis]);
            }
            for (unsigned axis = 0; axis < 3; ++axis)
            {
              sums[x][axis] += std::abs(volume) * gradient[axis];
            }
          }
        }
      }
    }
  }
  const Content<double> content(Make(sample, options), false, true);
  ASSERT_EQ(content.Points.size() / 3, sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    ASSERT_TRUE(sums.count(content.Point(i)));
    const Vector sum = sums[content.Point(i)];
    const double length = std::hypot(sum[0], sum[1], sum[2]);
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(content.Normal(i)[axis], -sum[axis] / length, 1e-6);
    }
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceNormals, OfASphereLookInwards)
{
  // The value is the distance from the middle: lower values are inside.
  for (const double jitter : { 0.0, 0.15 })
  {
    const double longest = std::sqrt(3) * (1 + 2 * jitter); // edge
    double last = 0;
    for (const std::int64_t n : { 10, 20, 40 })
    {
      Sample sample(MakeCubes(n, jitter));
      const double middle = 0.5 * static_cast<double>(n);
      const double radius = 0.5 * middle; // many points of the lattice are at that distance
      const auto distance = [=](const auto& x)
      { return std::hypot(x[0] - middle, x[1] - middle, x[2] - middle); };
      sample.Fill(distance);
      SurfaceOptions options;
      options.Values = { radius };
      options.Normals = true;
      const Content<float> content(Make(sample, options), false, true);
      double mean = 0;
      const std::size_t count = content.Points.size() / 3;
      ASSERT_GT(count, 200u);
      for (std::size_t i = 0; i < count; ++i)
      {
        const auto x = content.Point(i);
        const Vector normal = content.Normal(i);
        EXPECT_NEAR(std::hypot(normal[0], normal[1], normal[2]), 1, 1e-6);
        double cosine = 0;
        for (unsigned axis = 0; axis < 3; ++axis)
        {
          cosine -= normal[axis] * (x[axis] - middle) / distance(x);
        }
        const double angle = std::acos(std::min(1.0, cosine));
        mean += angle / static_cast<double>(count);
        EXPECT_LT(angle, longest / radius); // what the true normal turns by along it
      }
      EXPECT_LT(mean, n == 10 ? longest / (4 * radius) : 0.6 * last); // half, with half the edges
      last = mean;
    }
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceNormals, AreNothingWhereThereIsNoGradient)
{
  // Flat tetrahedra: no volume, no gradient.
  Sample sample(TestMesh{ { 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0 }, { 0, 1, 2, 3 } });
  sample.Values = { 0, 1, 2.5, 4 };
  SurfaceOptions options;
  options.Values = { 1.5 };
  options.Normals = true;
  EXPECT_GT(Make(sample, options).GetNumberOfTriangles(), 0u);
  Content<float> content(Make(sample, options), false, true);
  for (std::size_t i = 0; i < content.Normals.size() / 3; ++i)
  {
    // In the plane there is one, times no volume: what is left has no part in it.
    const Vector n = content.Normal(i);
    EXPECT_EQ(n[0], 0);
    EXPECT_EQ(n[1], 0);
  }
  sample.Mesh.Coordinates.assign(12, 0);
  sample.Mesh.Coordinates[3] = NotANumber;
  content = Content<float>(Make(sample, options), false, true);
  for (const float n : content.Normals)
  {
    EXPECT_EQ(n, 0);
  }
}
}
