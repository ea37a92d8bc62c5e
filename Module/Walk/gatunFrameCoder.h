// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFrameCoder_h
#define gatunFrameCoder_h

// Coordinates of vertices in meshes of well-shaped tetrahedra, as Delaunay meshers make them. A
// vertex is expected above the circumcenter of its gate, and it is closer to that place along the
// normal than across it. Each coordinate is also predicted from the previous ones, as in a normal
// distribution with two variances. Encoder and decoder compute alike: IEEE binary64 in the order
// written.

#include "gatunError.h"
#include "gatunGateFrame.h"
#include "gatunResidual.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

namespace gatun
{
/** Codes vertices by a FrameRule. */
template <typename Coder>
class FrameCoder
{
public:
  using Keys = std::array<Key, 3>;
  using Numbers = GateFrame::Numbers;

  /** The rule must be valid. */
  explicit FrameCoder(const FrameRule& rule)
    : Height(rule.Get(FrameRule::Height))
    , OfCenter(rule.Get(FrameRule::AcrossOfCenter))
    , OfFar(rule.Get(FrameRule::AcrossOfFar))
    , Across(rule.Get(FrameRule::Across))
  {
    const double along = rule.Get(FrameRule::Along);
    this->Stretch = along * along / (this->Across * this->Across) - 1.0;
  }

  static void Meet() {}

  /** Codes the vertex on a gate. numbers: of all vertices met. Other rules are not used. */
  template <typename DomainType, typename Predict>
  Keys Code(Coder& coder, const std::array<DomainType, 3>& domains, const GateRecord& record,
    unsigned, Predict&&, std::span<const Numbers> numbers, std::span<const Keys>,
    const Keys& actual)
  {
    Keys result{};
    this->ForEachAxis({ record, numbers },
      [&](unsigned i, double number, double deviation)
      {
        result[i] = this->CodeAxis(coder, domains[i], number, deviation, actual[i]);
        return domains[i].ToNumber(result[i]);
      });
    return result;
  }

  /** Residuals of a vertex that is coded. */
  std::array<std::int64_t, 3> GetResiduals(const std::array<Domain, 3>& domains,
    const GateRecord& record, std::span<const Numbers> numbers, const Keys& actual) const
  {
    std::array<std::int64_t, 3> residuals{};
    this->ForEachAxis({ record, numbers },
      [&](unsigned i, double number, double)
      {
        residuals[i] = domains[i].Subtract(actual[i], domains[i].FromNumber(number));
        return domains[i].ToNumber(actual[i]);
      });
    return residuals;
  }

private:
  /** code(axis, number, deviation) returns the number of the coordinate that is predicted like
   * this. */
  template <typename CodeNumber>
  GATUN_INLINE void ForEachAxis(const GateFrame& frame, CodeNumber&& code) const
  {
    const double height = this->Height * frame.Size;
    const double ofFar = this->OfFar / frame.Size;
    const double deviation = this->Across * frame.Size;
    // Of the previous axes: the distance along the normal, and their part of the variance.
    double way = 0;
    double variance = 1;
    for (unsigned i = 0; i < 3; ++i)
    {
      const double n = frame.Normal[i];
      const double place =
        frame.Middle[i] + height * n + this->OfCenter * frame.Center[i] + ofFar * frame.Far[i];
      const double inverse = 1.0 / variance;
      variance += this->Stretch * (n * n);
      const double number = code(
        i, place + this->Stretch * n * inverse * way, deviation * std::sqrt(variance * inverse));
      way += n * (number - place);
    }
  }

  template <typename DomainType>
  GATUN_INLINE Key CodeAxis(
    Coder& coder, const DomainType& domain, double number, double deviation, Key actual)
  {
    const Key predicted = domain.FromNumber(number);
    // Away from zero, where keys are further apart.
    const Key beyond = domain.FromNumber(number < 0 ? number - deviation : number + deviation);
    const std::uint64_t distance = beyond > predicted ? beyond - predicted : predicted - beyond;
    const auto spread = static_cast<unsigned>(std::bit_width(distance));
    // The two bits behind the first one.
    const auto fraction = spread < 3 ? 0 : distance >> (spread - 3) & 3;
    const auto residual = this->Models[fraction].Code(
      coder, spread, Coder::Encoding ? domain.Subtract(actual, predicted) : 0);
    const Key key = domain.Add(predicted, residual);
    if (!Coder::Encoding && !domain.IsValid(key))
    {
      ThrowCorrupt("a coordinate is not in the palette");
    }
    return key;
  }

  const double Height, OfCenter, OfFar, Across;
  double Stretch; // the variance along the normal over that across, less 1
  std::array<ResidualModel, 4> Models;
};
}

#endif
