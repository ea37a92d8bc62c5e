// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayLoops_h
#define gatunRayLoops_h

// The loops of a RayKernel. Included by one source for each instruction set, which it names with
// GATUN_SIMD. Functions of the standard library that are not always inlined must not be used here;
// see gatunSimd.h.

#include "gatunRayDrawer.h"
#include "gatunRayKernel.h"
#include "gatunRaySetUp.h"
#include "gatunSimd.h"

#include <cstddef>
#include <cstdint>

namespace gatun
{
namespace GATUN_SIMD
{
namespace
{
using Tet = RayKernel::Tet;

//------------------------------------------------------------------------------
// Lane i belongs to corner i of a tetrahedron, and to the three corners of the opposite face.

template <typename Vector>
GATUN_INLINE Vector FirstCorners(Vector v)
{
  return __builtin_shufflevector(v, v, 1, 0, 0, 0);
}

template <typename Vector>
GATUN_INLINE Vector SecondCorners(Vector v)
{
  return __builtin_shufflevector(v, v, 2, 2, 1, 1);
}

template <typename Vector>
GATUN_INLINE Vector ThirdCorners(Vector v)
{
  return __builtin_shufflevector(v, v, 3, 3, 3, 2);
}

//------------------------------------------------------------------------------
// Points

/** The length of the ray of a pixel from the eye to depth 1, in a perspective projection. */
GATUN_INLINE double GetLengthPerDepth(const RayView& view, double x, double y)
{
  const double u = (x - view.CenterX) * view.ScaleX;
  const double v = (y - view.CenterY) * view.ScaleY;
  return __builtin_sqrt(1 + u * u + v * v);
}

GATUN_INLINE bool IsFinite(double v)
{
  return v - v == 0;
}

void Transform(const RayView& view, double low, double scale, const RayPoint* points,
  std::size_t count, RayPoint* rayPoints, SeenPoint* seenPoints)
{
  const auto& m = view.ToRays;
  const Double4 columns[4] = { { m[0][0], m[1][0], m[2][0], 0 }, { m[0][1], m[1][1], m[2][1], 0 },
    { m[0][2], m[1][2], m[2][2], 0 }, { m[0][3], m[1][3], m[2][3], 0 } };
  constexpr float none = __builtin_nanf("");
  for (std::size_t i = 0; i < count; ++i)
  {
    const RayPoint& p = points[i];
    // The value is separate: NaN must not spread from values to coordinates or back.
    Double4 r =
      columns[0] * SplatD(p.X) + columns[1] * SplatD(p.Y) + columns[2] * SplatD(p.Z) + columns[3];
    r[3] = (p.Value - low) * scale;
    Store(&rayPoints[i], r);

    SeenPoint seen{ static_cast<float>(r[0]), static_cast<float>(r[1]), static_cast<float>(r[2]),
      static_cast<float>(r[3]) };
    if (!IsFinite(r[0] + r[1] + r[2]))
    {
      seen.X = none;
      seen.Samples = none;
    }
    else if (view.Perspective)
    {
      const double perDepth = 1 / r[2];
      const double x = r[0] * perDepth;
      const double y = r[1] * perDepth;
      const double samples = r[2] * GetLengthPerDepth(view, x, y) / view.SampleDistance;
      const bool inFront = r[2] > 0;
      seen.X = inFront ? static_cast<float>(x) : 0;
      seen.Y = inFront ? static_cast<float>(y) : 0;
      seen.Samples = inFront ? static_cast<float>(samples) : none;
    }
    seenPoints[i] = seen;
  }
}

//------------------------------------------------------------------------------
// Visible tetrahedra

GATUN_INLINE float Clamp(float v, float low, float high)
{
  return v < low ? low : v > high ? high : v;
}

/** The next integers above and below small numbers. */
GATUN_INLINE int Up(float v)
{
  const int i = static_cast<int>(v);
  return i + (static_cast<float>(i) < v ? 1 : 0);
}

GATUN_INLINE int Down(float v)
{
  const int i = static_cast<int>(v);
  return i - (static_cast<float>(i) > v ? 1 : 0);
}

void Look(const RayView& view, RayFilter filter, const SeenPoint* points, const Tet* tets,
  const std::uint8_t* turned, std::size_t count, SeenTet* seen, std::uint8_t* facing)
{
  // Margins for single precision, in pixels and in samples.
  constexpr float margin = 1.0f / 512;
  constexpr float relative = 1e-6f;
  const auto lastX = static_cast<float>(view.Width - 1);
  const auto lastY = static_cast<float>(view.Height - 1);
  const auto scaleX = static_cast<float>(view.ScaleX);
  const auto scaleY = static_cast<float>(view.ScaleY);
  const auto& m = view.ToRays;
  const double volume = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
    m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  const Float4 outwards = volume < 0 ? Float4{ 1, -1, 1, -1 } : Float4{ -1, 1, -1, 1 };
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto a = Load<Float4>(&points[tets[i][0]]);
    const auto b = Load<Float4>(&points[tets[i][1]]);
    const auto c = Load<Float4>(&points[tets[i][2]]);
    const auto d = Load<Float4>(&points[tets[i][3]]);

    // The projected area of each face. Its sign is the side of the face.
    const auto ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    const auto cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    const auto x = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
    const auto y = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
    const auto ax = FirstCorners(x);
    const auto ay = FirstCorners(y);
    const auto areas = ((SecondCorners(x) - ax) * (ThirdCorners(y) - ay) -
                         (SecondCorners(y) - ay) * (ThirdCorners(x) - ax)) *
      (turned[i] ? -outwards : outwards);
    facing[i] =
      static_cast<std::uint8_t>(ToBits(areas > Splat4(0)) | ToBits(areas < Splat4(0)) << 4);

    Float4 low = Smaller(Smaller(a, b), Smaller(c, d));
    Float4 high = Larger(Larger(a, b), Larger(c, d));
    const auto sum = (a + b) + (c + d);
    float nearest = low[2];
    bool mayOwn = true;
    if (!(sum[2] - sum[2] == 0)) [[unlikely]]
    {
      // With a point that is not finite or not in front of the eye, any pixel may be covered.
      const bool finite = sum[0] == sum[0];
      const bool behind = a[2] != a[2] && b[2] != b[2] && c[2] != c[2] && d[2] != d[2];
      mayOwn = finite && !behind;
      low = Float4{ 0, 0, 0, 0 };
      high = Float4{ lastX, lastY, 0, 0 };
      nearest = 0;
      facing[i] = 0;
    }
    else if (filter == RayFilter::Samples)
    {
      if (view.Perspective)
      {
        // The nearest point may lie within a face; it is not farther in than the tetrahedron's
        // corners are from their middle.
        const float far = high[2];
        const float u = (high[0] - low[0]) * scaleX * far;
        const float v = (high[1] - low[1]) * scaleY * far;
        const float w = far - nearest;
        nearest -= 0.375f * (u * u + v * v + w * w) / nearest;
      }
      const float slack = margin + relative * high[2];
      const float first = Clamp(nearest - slack, -1e9f, 1e9f);
      const float last = Clamp(high[2] + slack, -1e9f, 1e9f);
      mayOwn = Up(first) < Up(last);
    }
    const float outset = filter == RayFilter::None ? 1 : margin;
    const int x0 = Up(Clamp(low[0] - outset, 0, lastX + 1));
    const int y0 = Up(Clamp(low[1] - outset, 0, lastY + 1));
    const int x1 = Down(Clamp(high[0] + outset, -1, lastX));
    const int y1 = Down(Clamp(high[1] + outset, -1, lastY));
    const bool empty = !mayOwn | (x1 < x0) | (y1 < y0);
    seen[i] = { nearest, static_cast<std::int16_t>(x0), static_cast<std::int16_t>(y0),
      static_cast<std::int16_t>(empty ? x0 - 1 : x1), static_cast<std::int16_t>(y1) };
  }
}

//------------------------------------------------------------------------------
template <RayMode Mode, RayLook Look>
void DrawIn(const DrawContext& context, const TetItems& items, RayTile& tile)
{
  if (context.Perspective)
  {
    RayDrawer<true, Mode, Look>(context, tile).Draw(items);
  }
  else
  {
    RayDrawer<false, Mode, Look>(context, tile).Draw(items);
  }
}

template <RayMode Mode>
void DrawWithLook(const DrawContext& context, const TetItems& items, RayTile& tile)
{
  if (items.Hues)
  {
    DrawIn<Mode, RayLook::Hued>(context, items, tile);
  }
  else if (Mode == RayMode::XRay || !items.Shades)
  {
    DrawIn<Mode, RayLook::Plain>(context, items, tile);
  }
  else if constexpr (Mode != RayMode::XRay)
  {
    DrawIn<Mode, RayLook::Shaded>(context, items, tile);
  }
}

void Draw(RayMode mode, const DrawContext& context, const TetItems& items, RayTile& tile)
{
  switch (mode)
  {
    case RayMode::Composite:
      return DrawWithLook<RayMode::Composite>(context, items, tile);
    case RayMode::Sampled:
      return DrawWithLook<RayMode::Sampled>(context, items, tile);
    case RayMode::Maximum:
      return DrawIn<RayMode::Maximum, RayLook::Plain>(context, items, tile);
    case RayMode::XRay:
      return DrawWithLook<RayMode::XRay>(context, items, tile);
  }
}
}

constexpr RayKernel MakeKernel(const char* name)
{
  return { name, Transform, Look, SetUp, Draw };
}
}
}

#endif
