// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunSurfaceModels_h
#define gatunSurfaceModels_h

// The adaptive probabilities of a walk over a surface, and their contexts.

#include "gatunEntropy.h"
#include "gatunNumberModel.h"
#include "gatunPolygonModels.h"
#include "gatunSharedNames.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace gatun
{
/** Context of one end of a gate. */
struct GateEnd
{
  static constexpr unsigned NoAngle = 15;     // where the front is unknown
  static constexpr unsigned BorderAngle = 16; // where it ends at the border
  static constexpr unsigned Angles = 17;

  std::uint32_t Link = 0;   // the edge beyond, if its angle is less than NoAngle
  unsigned Angle = NoAngle; // see GradeCorner
  unsigned Cells = 0;       // around the vertex
  std::uint32_t Degree = 0; // of the polygon behind the link, or 0
};

class SurfaceModels
{
public:
  SurfaceModels()
    : Interfaces(3 * GateEnd::Angles * GateEnd::Angles)
    , Borders(3 * GateEnd::Angles * GateEnd::Angles)
    , Degrees(std::size_t{ 3 } * 4 * 4 * 5 * 5)
    , Corners(std::size_t{ 3 } * 2 * GateEnd::Angles * 8 * 5)
    , News(3 * 4)
    , Turns(1u << 10)
    , LongTurns(1u << 10)
    , Types(1u << 8)
  {
  }

  BitModel& Border(bool isInterface, std::uint32_t degree, const GateEnd& begin, const GateEnd& end)
  {
    auto& models = isInterface ? this->Interfaces : this->Borders;
    return models[(GradeDegree(degree) * GateEnd::Angles + begin.Angle) * GateEnd::Angles +
      end.Angle];
  }

  /** The number of corners of a polygon. parent: that of the polygon behind the gate, or 0. */
  template <typename Coder>
  std::uint32_t CodeDegree(Coder& coder, std::uint32_t parent, const GateEnd& begin,
    const GateEnd& end, std::uint32_t degree)
  {
    const auto context =
      (((GradeDegree(parent) * 4 + GradeLinked(begin)) * 4 + GradeLinked(end)) * 5 +
        GradeAngle(begin)) *
        5 +
      GradeAngle(end);
    auto& models = this->Degrees[context];
    if (coder.Bit(models[0], degree == 3))
    {
      return 3;
    }
    if (coder.Bit(models[1], degree == 4))
    {
      return 4;
    }
    const auto size =
      this->SizeTree[std::min(parent, 15u)].Code(coder, std::min(degree, MostSize) - 5u);
    return size < MostSize - 5 ? size + 5 : this->LargeSize.Code(coder, degree);
  }

  /** Whether the next corner of a polygon is the next vertex along the front. ahead, back: the end
   * where it is and the other one. further: whether it is not the first one there. */
  BitModel& IsNext(std::uint32_t degree, bool further, const GateEnd& ahead, const GateEnd& back)
  {
    return this
      ->Corners[(((GradeDegree(degree) * 2 + further) * GateEnd::Angles + ahead.Angle) * 8 +
                  ahead.Cells) *
          5 +
        GradeAngle(back)];
  }

  /** ends: at how many ends of the gate the front was followed. */
  BitModel& New(std::uint32_t degree, unsigned ends)
  {
    return this->News[GradeDegree(degree) * 4 + ends];
  }

  template <typename Coder>
  std::uint8_t CodeType(
    Coder& coder, std::uint32_t degree, std::uint8_t parentType, std::uint8_t type)
  {
    return CodeLast(
      coder, this->Types[MixContext<8>(std::min(degree, 5u), parentType, 1)], this->TypeTree, type);
  }

  /** The turn of a polygon; see GetMarkPlace. parentFrame: of the gate. */
  template <typename Coder>
  std::uint32_t CodeTurn(Coder& coder, std::uint8_t type, std::uint32_t degree,
    std::uint32_t parentDegree, std::uint32_t parentFrame, std::uint32_t turn)
  {
    if (degree <= 4)
    {
      return this->Turns[MixContext<10>(type, parentDegree, parentFrame)].Code(coder, turn);
    }
    auto& last = this->LongTurns[MixContext<10>(degree, parentDegree, parentFrame)];
    std::uint32_t coded =
      last.Code(coder, static_cast<std::uint16_t>(turn), [](std::uint16_t) { return false; });
    if (coded == LastTwo::None)
    {
      coded = CodeIndex(coder, turn, std::size_t{ 2 } * degree);
    }
    last.Add(static_cast<std::uint16_t>(coded));
    return coded;
  }

  std::array<BitModel, 9> IsShared; // by the shared ones of the gate, and of the front beyond
  SharedNames Shared;
  BitModel OnFront;
  std::array<BitModel, 2> Listed;
  std::array<BitModel, std::size_t{ 2 } * 6> Ranks;
  BitModel MoreSeeds, SeedNew, SeedShared;

private:
  static constexpr std::uint32_t MostSize = 20;

  static unsigned GradeDegree(std::uint32_t degree) { return std::clamp(degree, 3u, 5u) - 3; }

  static unsigned GradeLinked(const GateEnd& end)
  {
    return end.Degree == 0 ? 0 : GradeDegree(end.Degree) + 1;
  }

  /** Sharp, square, wide, straight or more, none. */
  static unsigned GradeAngle(const GateEnd& end)
  {
    return end.Angle < 4 ? 0 : end.Angle < 5 ? 1 : end.Angle < 8 ? 2 : end.Angle < 15 ? 3 : 4;
  }

  std::vector<BitModel> Interfaces, Borders;
  std::vector<std::array<BitModel, 2>> Degrees;
  std::array<BitTree<4>, 16> SizeTree; // by the size of the polygon before
  NumberModel LargeSize;
  std::vector<BitModel> Corners, News;
  std::vector<BitTree<3>> Turns;
  std::vector<LastTwo> LongTurns;
  std::vector<LastTwo> Types;
  BitTree<8> TypeTree;
};
}

#endif
