// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunWalkModels_h
#define gatunWalkModels_h

// The adaptive probabilities of a walk and their contexts.

#include "gatunEntropy.h"
#include "gatunGate.h"
#include "gatunSharedSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace gatun
{
/** Decisions that do not depend on the ranking. */
struct CommonWalkModels
{
  std::array<BitModel, 4 * 27 * 2> Interface;
  std::array<BitModel, 8> Shared;
  std::array<BitModel, SharedSearch::Most> SharedRank;
  std::array<BitModel, 2> Next;
  std::array<BitModel, 6> RingRank;
  BitModel RingListed;
  BitModel SeedNew;
  BitModel SeedShared;
};

template <Ranking Rule>
class WalkModels;

/** Contexts for Delaunay meshes: large empty spheres are unlikely. */
template <>
class WalkModels<Ranking::Sphere> : public CommonWalkModels
{
public:
  WalkModels()
    : HitModels(Grades * 4 * Radii)
    , BorderModels(10 * Radii)
    , NewModels(Grades * 2 * Radii)
  {
  }

  BitModel& Hit(const Gate<Ranking::Sphere>& gate)
  {
    return this->HitModels[(GetGrade(gate, gate.GetBestRank()) * 4 + gate.CountBest()) * Radii +
      GetRadius(gate)];
  }

  BitModel& Border(const Gate<Ranking::Sphere>& gate, std::span<const LatticePoint> places)
  {
    return this->BorderModels[gate.GetBorderGrade(places) * Radii + GetRadius(gate)];
  }

  BitModel& New(
    const Gate<Ranking::Sphere>& gate, const Front& front, std::span<const LatticePoint> places)
  {
    const float rank = gate.GetRingRank(front, places);
    const unsigned nearer = rank < gate.GetBestRank();
    return this->NewModels[(GetGrade(gate, rank) * 2 + nearer) * Radii + GetRadius(gate)];
  }

private:
  static constexpr unsigned Grades = 33;
  static constexpr unsigned Radii = 32;

  /** Grades the position of the sphere's center, 0 to 31. 32: not in front of the gate. */
  static unsigned GetGrade(const Gate<Ranking::Sphere>& gate, float rank)
  {
    if (rank == NeverRank)
    {
      return 32;
    }
    const float t = rank * gate.Ring.Unit;
    const float place = 16.0F + 16.0F * (t / (1.0F + std::abs(t)));
    return place < 31.0F ? static_cast<unsigned>(place) : 31;
  }

  /** Grades the circumcircle's radius in half octaves, 0 to 31. */
  static unsigned GetRadius(const Gate<Ranking::Sphere>& gate)
  {
    return static_cast<unsigned>(
      std::clamp(GetExponent(gate.Ring.FourRadiusSquared) + 10, 0, static_cast<int>(Radii) - 1));
  }

  std::vector<BitModel> HitModels;
  std::vector<BitModel> BorderModels;
  std::vector<BitModel> NewModels;
};

/** Contexts for split hexahedra, which have few different angles. */
template <>
class WalkModels<Ranking::Angle> : public CommonWalkModels
{
public:
  WalkModels()
    : HitModels(Grades * 8 * 4)
    , BorderModels(10 * Grades * 8)
    , NewModels(Grades * Grades * 27)
  {
  }

  BitModel& Hit(const Gate<Ranking::Angle>& gate)
  {
    return this->HitModels[(GetFirst(gate) * 8 + gate.GetBestTets()) * 4 + gate.CountBest()];
  }

  BitModel& Border(const Gate<Ranking::Angle>& gate, std::span<const LatticePoint> places)
  {
    return this->BorderModels[(gate.GetBorderGrade(places) * Grades + GetFirst(gate)) * 8 +
      gate.GetBestTets()];
  }

  BitModel& New(const Gate<Ranking::Angle>& gate, const Front&, std::span<const LatticePoint>)
  {
    return this->NewModels[(GetFirst(gate) * Grades + GetSecond(gate)) * 27 + GradeTets(gate.Face)];
  }

private:
  static constexpr unsigned Grades = 18;

  /** Grades the angle, 0 to 15. 16: not in front of the gate. 17: no candidate. */
  static unsigned GetGrade(float rank)
  {
    if (rank == NeverRank)
    {
      return 16;
    }
    const float place = 8.0F + 8.0F * rank;
    return place < 15.0F ? static_cast<unsigned>(place) : 15;
  }

  static unsigned GetFirst(const Gate<Ranking::Angle>& gate)
  {
    return gate.HasCandidate() ? GetGrade(gate.GetBestRank()) : 17;
  }

  static unsigned GetSecond(const Gate<Ranking::Angle>& gate)
  {
    return gate.CountCandidates() > 1 ? GetGrade(gate.GetSecondRank()) : 17;
  }

  std::vector<BitModel> HitModels;
  std::vector<BitModel> BorderModels;
  std::vector<BitModel> NewModels;
};
}

#endif
