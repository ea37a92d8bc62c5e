// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRayLoops_h
#define gatunRayLoops_h

// The loops of a RayKernel. Included by one source for each instruction set, which it names with
// GATUN_SIMD. Functions of the standard library that are not always inlined must not be used here;
// see gatunSimd.h.

#include "gatunRayDrawer.h"
#include "gatunRayKernel.h"
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
// Planes of the faces

/** For each set of faces through which rays enter: these faces first, then the others. */
struct EntriesFirst
{
  constexpr EntriesFirst()
  {
    for (unsigned bits = 0; bits < 16; ++bits)
    {
      unsigned n = 0;
      for (const bool entry : { true, false })
      {
        for (unsigned face = 0; face < 4; ++face)
        {
          if (((bits >> face & 1) != 0) == entry)
          {
            this->Faces[bits][n++] = static_cast<std::int32_t>(face);
          }
        }
      }
    }
  }
  alignas(16) std::int32_t Faces[16][4] = {};
};
constexpr EntriesFirst InOrder;

GATUN_INLINE Float4 Reorder(Double4 v, Int4 order)
{
  return Permute(__builtin_convertvector(v, Float4), order);
}

GATUN_INLINE double Sum(Double4 v)
{
  return (v[0] + v[1]) + (v[2] + v[3]);
}

GATUN_INLINE Double4 Absolute(Double4 v)
{
  return v < SplatD(0) ? -v : v;
}

void SetUp(const SetUpContext& context, const RayPoint* points, const Tet* tets,
  const double* cellValues, const SeenTet* seen, const std::uint32_t* chosen, std::size_t count,
  std::uint32_t* places, TetItem* items, std::uint32_t* origins)
{
  const bool perspective = context.View->Perspective;
  const auto lastCell = static_cast<float>(context.TableSize);
  constexpr std::size_t ahead = 8;
  for (std::size_t i = 0; i < count; ++i)
  {
    // The tetrahedra are in the order of release, not of memory.
    if (i + 2 * ahead < count)
    {
      __builtin_prefetch(&tets[chosen[i + 2 * ahead]]);
      __builtin_prefetch(&seen[chosen[i + 2 * ahead]]);
    }
    if (i + ahead < count)
    {
      for (const auto corner : tets[chosen[i + ahead]])
      {
        __builtin_prefetch(&points[corner]);
      }
    }
    const Tet& tet = tets[chosen[i]];
    const auto p0 = Load<Double4>(&points[tet[0]]);
    const auto p1 = Load<Double4>(&points[tet[1]]);
    const auto p2 = Load<Double4>(&points[tet[2]]);
    const auto p3 = Load<Double4>(&points[tet[3]]);
    const auto xy01 = __builtin_shufflevector(p0, p1, 0, 4, 1, 5);
    const auto zv01 = __builtin_shufflevector(p0, p1, 2, 6, 3, 7);
    const auto xy23 = __builtin_shufflevector(p2, p3, 0, 4, 1, 5);
    const auto zv23 = __builtin_shufflevector(p2, p3, 2, 6, 3, 7);
    const auto x = __builtin_shufflevector(xy01, xy23, 0, 1, 4, 5);
    const auto y = __builtin_shufflevector(xy01, xy23, 2, 3, 6, 7);
    const auto z = __builtin_shufflevector(zv01, zv23, 0, 1, 4, 5);
    const auto t = cellValues ? SplatD((cellValues[chosen[i]] - context.Low) * context.Scale)
                              : __builtin_shufflevector(zv01, zv23, 2, 3, 6, 7);

    // Lane f is the face opposite to vertex f. Its corners a, b, c are in the order of the
    // vertices, which is the same in the neighbor, so that both compute the same plane bit for bit.
    const auto ax = FirstCorners(x);
    const auto ay = FirstCorners(y);
    const auto az = FirstCorners(z);
    const auto ux = SecondCorners(x) - ax;
    const auto uy = SecondCorners(y) - ay;
    const auto uz = SecondCorners(z) - az;
    const auto vx = ThirdCorners(x) - ax;
    const auto vy = ThirdCorners(y) - ay;
    const auto vz = ThirdCorners(z) - az;
    const auto nx = uy * vz - uz * vy;
    const auto ny = uz * vx - ux * vz;
    const auto nz = ux * vy - uy * vx;

    // Six times the signed volume, with the opposite sign for faces of the other orientation.
    const double volume = nx[3] * (x[3] - x[0]) + ny[3] * (y[3] - y[0]) + nz[3] * (z[3] - z[0]);
    const Double4 volumes = { -volume, volume, -volume, volume };

    // Depth along the ray is a quotient. If the plane (nearly) contains the ray, its divisor is
    // kept away from zero.
    Double4 divisor = nz;
    Double4 least = (Absolute(nx) + Absolute(ny)) * SplatD(1e-12);
    if (perspective)
    {
      const auto cx = nx * ax;
      const auto cy = ny * ay;
      const auto cz = nz * az;
      divisor = cx + cy + cz;
      // The second term is for an eye at a corner, where the first term is zero.
      least = (Absolute(cx) + Absolute(cy) + Absolute(cz)) * SplatD(1e-14) +
        (Absolute(nx) + Absolute(ny) + Absolute(nz)) * SplatD(1e-30);
    }
    divisor = divisor < SplatD(0) ? Smaller(divisor, -least) : Larger(divisor, least);
    const auto perDivisor = SplatD(-1) / divisor;
    const auto stepX = nx * perDivisor;
    const auto stepY = ny * perDivisor;
    const auto base = perspective ? nz * perDivisor : az - stepX * ax - stepY * ay;
    const auto entries =
      15u ^ ToBits(Long4(volumes > SplatD(0))) ^ ToBits(Long4(divisor > SplatD(0)));

    // The value's gradient, from barycentric coordinates; relative to vertex 0.
    const auto weights = (t - SplatD(t[0])) / volumes;
    const double tx = Sum(weights * nx);
    const double ty = Sum(weights * ny);
    const double tz = Sum(weights * nz);
    const double t0 = t[0] - tx * x[0] - ty * y[0] - tz * z[0];

    const auto order = Load<Int4>(InOrder.Faces[entries]);
    const auto stepsX = Reorder(stepX, order);
    const auto stepsY = Reorder(stepY, order);
    TetItem item;
    Store(item.StepX.data(), stepsX);
    Store(item.StepY.data(), stepsY);
    item.Entries = static_cast<std::uint8_t>(__builtin_popcount(entries));
    item.TX = static_cast<float>(tx);
    item.TY = static_cast<float>(ty);
    const bool hasNaN = !IsFinite(Sum(t));
    const double tMin = Smaller(Smaller(t[0], t[1]), Smaller(t[2], t[3]));
    const double tMax = Larger(Larger(t[0], t[1]), Larger(t[2], t[3]));
    item.TMin = hasNaN ? 0 : Clamp(static_cast<float>(tMin), 0, lastCell);
    item.TMax = hasNaN ? 0 : Clamp(static_cast<float>(tMax), 0, lastCell);
    item.Transparent = hasNaN ||
      context.VisibleCells[static_cast<int>(item.TMax) + 1] ==
        context.VisibleCells[static_cast<int>(item.TMin)];
    // Flat tetrahedra contain no sample. Nor do those whose numbers have overflowed.
    const bool isHollow = !IsFinite(volume) || volume == 0 || !IsFinite(Sum(base + stepX + stepY));

    const SeenTet& where = seen[chosen[i]];
    ForEachTile(where, context.TilesX, context.Limits,
      [&](int tile)
      {
        const int x0 = tile % context.TilesX * RayTile::Size;
        const int y0 = tile / context.TilesX * RayTile::Size;
        Store(item.Base.data(), Reorder(base + stepX * SplatD(x0) + stepY * SplatD(y0), order));
        const double shift = tx * x0 + ty * y0;
        item.T = static_cast<float>(perspective ? t0 : t0 + shift);
        item.TK = static_cast<float>(perspective ? tz + shift : tz);
        if (isHollow) [[unlikely]]
        {
          item.Base = item.StepX = item.StepY = {};
          item.Entries = 2;
        }
        if (hasNaN) [[unlikely]]
        {
          item.T = item.TX = item.TY = item.TK = 0;
        }
        constexpr int last = RayTile::Size - 1;
        item.FirstX = static_cast<std::uint8_t>(where.FirstX > x0 ? where.FirstX - x0 : 0);
        item.FirstY = static_cast<std::uint8_t>(where.FirstY > y0 ? where.FirstY - y0 : 0);
        item.LastX = static_cast<std::uint8_t>(where.LastX < x0 + last ? where.LastX - x0 : last);
        item.LastY = static_cast<std::uint8_t>(where.LastY < y0 + last ? where.LastY - y0 : last);
        const auto place = places[tile]++;
        items[place] = item;
        if (origins)
        {
          origins[place] = static_cast<std::uint32_t>(i);
        }
      });
  }
}

//------------------------------------------------------------------------------
template <RayMode Mode, bool Shaded>
void DrawIn(const DrawContext& context, const TetItems& items, RayTile& tile)
{
  if (context.View->Perspective)
  {
    RayDrawer<true, Mode, Shaded>(context, tile).Draw(items);
  }
  else
  {
    RayDrawer<false, Mode, Shaded>(context, tile).Draw(items);
  }
}

void Draw(RayMode mode, const DrawContext& context, const TetItems& items, RayTile& tile)
{
  const bool shaded = items.Shades != nullptr;
  switch (mode)
  {
    case RayMode::Composite:
      return shaded ? DrawIn<RayMode::Composite, true>(context, items, tile)
                    : DrawIn<RayMode::Composite, false>(context, items, tile);
    case RayMode::Area:
      return shaded ? DrawIn<RayMode::Area, true>(context, items, tile)
                    : DrawIn<RayMode::Area, false>(context, items, tile);
    case RayMode::Maximum:
      return DrawIn<RayMode::Maximum, false>(context, items, tile);
    case RayMode::XRay:
      return DrawIn<RayMode::XRay, false>(context, items, tile);
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
