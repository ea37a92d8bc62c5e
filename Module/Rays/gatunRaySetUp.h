// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunRaySetUp_h
#define gatunRaySetUp_h

// The planes and values of tetrahedra. Part of gatunRayLoops.h, see there.

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

GATUN_INLINE Double4 Absolute(Double4 v)
{
  return v < SplatD(0) ? -v : v;
}

/** Lane i of vector j becomes lane j of vector i. */
GATUN_INLINE void Transpose(Double4& a, Double4& b, Double4& c, Double4& d)
{
  const auto ab02 = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const auto ab13 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const auto cd02 = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const auto cd13 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab02, cd02, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab13, cd13, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab02, cd02, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab13, cd13, 2, 3, 6, 7);
}

/** Vectors of four tetrahedra, one in each lane. */
struct Vectors
{
  Double4 X, Y, Z;
};

GATUN_INLINE Vectors operator-(const Vectors& a, const Vectors& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}

GATUN_INLINE Vectors Cross(const Vectors& a, const Vectors& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}

/** The faces and values of four tetrahedra. */
class FourTets
{
public:
  static constexpr std::size_t Count = 4;

  /** These: the indices of the tetrahedra. */
  GATUN_INLINE FourTets(const SetUpContext& context, const RayPoint* points,
    const RayKernel::Tet* tets, const double* cellValues, const std::uint32_t* these)
    : Perspective(context.View->Perspective)
  {
    Vectors p[4];
    Double4 t[4];
    for (unsigned corner = 0; corner < 4; ++corner)
    {
      p[corner].X = Load<Double4>(&points[tets[these[0]][corner]]);
      p[corner].Y = Load<Double4>(&points[tets[these[1]][corner]]);
      p[corner].Z = Load<Double4>(&points[tets[these[2]][corner]]);
      t[corner] = Load<Double4>(&points[tets[these[3]][corner]]);
      Transpose(p[corner].X, p[corner].Y, p[corner].Z, t[corner]);
    }
    if (cellValues)
    {
      const Double4 values = { cellValues[these[0]], cellValues[these[1]], cellValues[these[2]],
        cellValues[these[3]] };
      t[0] = t[1] = t[2] = t[3] = (values - SplatD(context.Low)) * SplatD(context.Scale);
    }

    // Face f is opposite to corner f. Its corners are in the order of the tetrahedron, which is the
    // same in the neighbor, so that both compute the same plane bit for bit.
    Vectors normals[4];
    normals[0] = this->SetFace(0, p[1], p[2], p[3]);
    normals[1] = this->SetFace(1, p[0], p[2], p[3]);
    normals[2] = this->SetFace(2, p[0], p[1], p[3]);
    normals[3] = this->SetFace(3, p[0], p[1], p[2]);

    // Six times the signed volume, with the opposite sign for faces of the other orientation.
    const Vectors& n3 = normals[3];
    const Vectors edge = p[3] - p[0];
    const auto volume = n3.X * edge.X + n3.Y * edge.Y + n3.Z * edge.Z;
    const unsigned positive = ToBits(Long4(volume > SplatD(0)));
    const unsigned negative = ToBits(Long4(volume < SplatD(0)));
    for (unsigned face = 0; face < 4; ++face)
    {
      this->Entries[face] ^= 15u ^ (face % 2 == 0 ? negative : positive);
    }

    // The value's gradient, from barycentric coordinates; relative to corner 0.
    const auto perVolume = SplatD(1) / volume;
    const auto w1 = (t[1] - t[0]) * perVolume;
    const auto w2 = (t[0] - t[2]) * perVolume;
    const auto w3 = (t[3] - t[0]) * perVolume;
    this->TX = w1 * normals[1].X + w2 * normals[2].X + w3 * n3.X;
    this->TY = w1 * normals[1].Y + w2 * normals[2].Y + w3 * n3.Y;
    this->TZ = w1 * normals[1].Z + w2 * normals[2].Z + w3 * n3.Z;
    this->T0 = t[0] - this->TX * p[0].X - this->TY * p[0].Y - this->TZ * p[0].Z;
    const auto sum = (t[0] + t[1]) + (t[2] + t[3]);
    this->Valued = ToBits(Long4(sum * SplatD(0) == SplatD(0)));
    const auto inTable = [&](Double4 v)
    {
      return Smaller(Larger(__builtin_convertvector(v, Float4), Splat4(0)),
        Splat4(static_cast<float>(context.TableSize)));
    };
    const auto tMin = Smaller(Smaller(t[0], t[1]), Smaller(t[2], t[3]));
    const auto tMax = Larger(Larger(t[0], t[1]), Larger(t[2], t[3]));
    this->TMin = inTable(tMin);
    this->TMax = inTable(tMax);
    this->Below = ToBits(Long4(tMin < SplatD(0)));
    this->Above = ToBits(Long4(tMax > SplatD(context.TableSize)));

    // Flat tetrahedra contain nothing. Nor do those whose numbers have overflowed.
    Double4 check = volume;
    for (unsigned face = 0; face < 4; ++face)
    {
      check += this->Base[face] + this->StepX[face] + this->StepY[face];
    }
    this->Solid = ToBits(Long4(check * SplatD(0) == SplatD(0))) & (positive | negative);

    // From now on, vector i is tetrahedron i, and lane f is face f.
    Transpose(this->Base[0], this->Base[1], this->Base[2], this->Base[3]);
    Transpose(this->StepX[0], this->StepX[1], this->StepX[2], this->StepX[3]);
    Transpose(this->StepY[0], this->StepY[1], this->StepY[2], this->StepY[3]);
  }

  /** Makes the items of tetrahedron i. Use(tile, item) gets each of them. */
  template <typename Use>
  GATUN_INLINE void MakeItems(
    const SetUpContext& context, std::size_t i, const SeenTet& where, Use&& use) const
  {
    unsigned entries = 0;
    for (unsigned face = 0; face < 4; ++face)
    {
      entries |= (this->Entries[face] >> i & 1) << face;
    }
    const auto order = Load<Int4>(InOrder.Faces[entries]);
    const bool hasValue = (this->Valued >> i & 1) != 0;
    const bool isSolid = (this->Solid >> i & 1) != 0;
    TetItem item;
    Store(item.StepX.data(), Reorder(this->StepX[i], order));
    Store(item.StepY.data(), Reorder(this->StepY[i], order));
    item.Entries = static_cast<std::uint8_t>(__builtin_popcount(entries));
    item.TX = static_cast<float>(this->TX[i]);
    item.TY = static_cast<float>(this->TY[i]);
    item.TMin = hasValue ? this->TMin[i] : 0;
    item.TMax = hasValue ? this->TMax[i] : 0;
    item.Transparent = !hasValue ||
      context.VisibleCells[static_cast<int>(item.TMax) + 1] ==
        context.VisibleCells[static_cast<int>(item.TMin)];
    this->SetPieces(context, i, item);
    ForEachTile(where, context.TilesX, context.Limits,
      [&](int tile)
      {
        const int x0 = tile % context.TilesX * RayTile::Size;
        const int y0 = tile / context.TilesX * RayTile::Size;
        Store(item.Base.data(),
          Reorder(
            this->Base[i] + this->StepX[i] * SplatD(x0) + this->StepY[i] * SplatD(y0), order));
        const double shift = this->TX[i] * x0 + this->TY[i] * y0;
        item.T = static_cast<float>(this->Perspective ? this->T0[i] : this->T0[i] + shift);
        item.TK = static_cast<float>(this->Perspective ? this->TZ[i] + shift : this->TZ[i]);
        if (!isSolid) [[unlikely]]
        {
          item.Base = item.StepX = item.StepY = {};
          item.Entries = 2;
        }
        if (!hasValue) [[unlikely]]
        {
          item.T = item.TX = item.TY = item.TK = 0;
        }
        constexpr int last = RayTile::Size - 1;
        item.FirstX = static_cast<std::uint8_t>(where.FirstX > x0 ? where.FirstX - x0 : 0);
        item.FirstY = static_cast<std::uint8_t>(where.FirstY > y0 ? where.FirstY - y0 : 0);
        item.LastX = static_cast<std::uint8_t>(where.LastX < x0 + last ? where.LastX - x0 : last);
        item.LastY = static_cast<std::uint8_t>(where.LastY < y0 + last ? where.LastY - y0 : last);
        use(tile, item);
      });
  }

private:
  /** Computes the plane of a face with corners a, b and c. Returns its normal. */
  GATUN_INLINE Vectors SetFace(unsigned face, const Vectors& a, const Vectors& b, const Vectors& c)
  {
    const Vectors n = Cross(b - a, c - a);
    // Depth along the ray is a quotient. If the plane (nearly) contains the ray, its divisor is
    // kept away from zero.
    Double4 divisor = n.Z;
    Double4 least = (Absolute(n.X) + Absolute(n.Y)) * SplatD(1e-12);
    if (this->Perspective)
    {
      const auto cx = n.X * a.X;
      const auto cy = n.Y * a.Y;
      const auto cz = n.Z * a.Z;
      divisor = cx + cy + cz;
      // The second term is for an eye at a corner, where the first term is zero.
      least = (Absolute(cx) + Absolute(cy) + Absolute(cz)) * SplatD(1e-14) +
        (Absolute(n.X) + Absolute(n.Y) + Absolute(n.Z)) * SplatD(1e-30);
    }
    divisor = divisor < SplatD(0) ? Smaller(divisor, -least) : Larger(divisor, least);
    const auto perDivisor = SplatD(-1) / divisor;
    this->StepX[face] = n.X * perDivisor;
    this->StepY[face] = n.Y * perDivisor;
    this->Base[face] = this->Perspective ? n.Z * perDivisor
                                         : a.Z - this->StepX[face] * a.X - this->StepY[face] * a.Y;
    this->Entries[face] = ToBits(Long4(divisor > SplatD(0)));
    return n;
  }

  /** Finds the pieces of the transfer function from the smallest to the largest value. */
  GATUN_INLINE void SetPieces(const SetUpContext& context, std::size_t i, TetItem& item) const
  {
    item.FirstPiece = item.LastPiece = 0;
    if (!context.PiecesOf)
    {
      return;
    }
    const auto first = static_cast<int>(item.TMin);
    const auto last = static_cast<int>(item.TMax);
    // A largest value between two cells belongs to the lower one, if it is not the only value.
    const bool isBetween = last > first && static_cast<float>(last) == item.TMax;
    const unsigned firstPiece = context.PiecesOf[first][0];
    const unsigned lastPiece = context.PiecesOf[isBetween ? last - 1 : last][1];
    const bool below = (this->Below >> i & 1) != 0;
    const bool above = (this->Above >> i & 1) != 0;
    item.FirstPiece = static_cast<std::uint16_t>(firstPiece - (below ? 1 : 0));
    item.LastPiece = static_cast<std::uint16_t>(lastPiece + (above ? 1 : 0));
    // Values beyond the table only.
    item.LastPiece = below && item.TMax == 0 ? item.FirstPiece : item.LastPiece;
    item.FirstPiece = above && first == context.TableSize ? item.LastPiece : item.FirstPiece;
  }

  bool Perspective;
  unsigned Entries[4]; // of each face, the tetrahedra that rays enter through it
  unsigned Valued;     // those without NaN
  unsigned Solid;      // those that have a volume
  unsigned Below;      // those with values below the table
  unsigned Above;      // those with values above it
  Double4 Base[4], StepX[4], StepY[4];
  Double4 T0, TX, TY, TZ;
  Float4 TMin, TMax;
};

void SetUp(const SetUpContext& context, const RayPoint* points, const RayKernel::Tet* tets,
  const double* cellValues, const SeenTet* seen, const std::uint32_t* chosen, std::size_t count,
  std::uint32_t* places, TetItem* items, std::uint32_t* origins)
{
  constexpr std::size_t ahead = 8;
  for (std::size_t first = 0; first < count; first += FourTets::Count)
  {
    std::uint32_t these[FourTets::Count];
    for (std::size_t i = 0; i < FourTets::Count; ++i)
    {
      these[i] = chosen[first + i < count ? first + i : count - 1];
      // The tetrahedra are in the order of release, not of memory.
      if (const auto next = first + i + 2 * ahead; next < count)
      {
        __builtin_prefetch(&tets[chosen[next]]);
        __builtin_prefetch(&seen[chosen[next]]);
        for (const auto corner : tets[chosen[next - ahead]])
        {
          __builtin_prefetch(&points[corner]);
        }
      }
    }
    const FourTets four(context, points, tets, cellValues, these);
    for (std::size_t i = 0; i < FourTets::Count && first + i < count; ++i)
    {
      four.MakeItems(context, i, seen[these[i]],
        [&](int tile, const TetItem& item)
        {
          const auto place = places[tile]++;
          items[place] = item;
          if (origins)
          {
            origins[place] = static_cast<std::uint32_t>(first + i);
          }
        });
    }
  }
}
}
}
}

#endif
