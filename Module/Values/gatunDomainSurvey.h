// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunDomainSurvey_h
#define gatunDomainSurvey_h

#include "gatunDomain.h"
#include "gatunPalette.h"
#include "gatunScaleSurvey.h"

#include <cstddef>
#include <cstdint>

namespace gatun
{
/** The user's requirements for a component. */
struct RoundingRequest
{
  ErrorBound Bound;
  bool OnLattice = false; // see Quantizer
};

/** Finds the domain with the fewest keys, or the quantizer that is wanted, for a component whose
 * tuples come in parts. */
class DomainSurvey
{
public:
  /** most: the number of different values beyond which there is no palette. */
  explicit DomainSurvey(
    ScalarType type, std::size_t most = MaxPalette, const RoundingRequest& rounding = {})
    : Type(type)
    , Rounding(rounding)
    , Palettes(type, most)
    , Scales(type)
  {
  }

  void Add(const void* values, std::size_t count, std::size_t components, std::size_t component)
  {
    const auto kind = this->Rounding.Bound.Kind;
    if (kind == ErrorKind::Relative)
    {
      this->Range.Add(this->Type, values, count, components, component);
    }
    else if (kind != ErrorKind::None && MakeQuantizer(this->Type, this->Rounding.Bound, {}))
    {
      return; // whatever the values are
    }
    this->Palettes.Add(values, count, components, component);
    this->Scales.Add(values, count, components, component);
  }

  /** Keeps what is known in little memory. */
  void Compress() { this->Palettes.Compress(); }

  /** Serializes the survey for another process, and adds such a message. */
  void Put(ByteWriter& out)
  {
    this->Palettes.Put(out);
    this->Scales.Put(out);
    out.Put(this->Range.Low);
    out.Put(this->Range.High);
  }
  void Add(ByteReader& in)
  {
    this->Palettes.Add(in);
    this->Scales.Add(in);
    FiniteRange range;
    range.Low = in.Get<double>();
    range.High = in.Get<double>();
    if (!range.IsEmpty())
    {
      this->Range.Include(range.Low);
      this->Range.Include(range.High);
    }
  }

  /**
   * The domain for the given number of tuples. before: the scale of the same component at the time
   * step before if values may be predicted from it, otherwise null. It is kept if it has all
   * values, because they could not be predicted with another one.
   */
  Domain Finish(std::uint64_t count, PaletteUse use, const Scale* before = nullptr)
  {
    if (auto rounding = MakeQuantizer(this->Type, this->Rounding.Bound, this->Range))
    {
      rounding.OnLattice = this->Rounding.OnLattice;
      return Domain(this->Type, rounding);
    }
    auto palette = this->Palettes.Finish(count, use);
    if (palette)
    {
      return Domain(this->Type, std::move(palette));
    }
    constexpr std::uint64_t leastCount = 32; // what tells a scale takes a few bytes
    return Domain(this->Type,
      before && this->Scales.Holds(*before) ? *before
        : count < leastCount                ? Scale()
                                            : this->Scales.Choose());
  }

private:
  ScalarType Type;
  RoundingRequest Rounding;
  FiniteRange Range; // if the request needs it
  PaletteBuilder Palettes;
  ScaleSurvey Scales;
};

/** The domain of a component of tuples that are all there. */
inline Domain FindDomain(ScalarType type, const void* values, std::size_t count,
  std::size_t components, std::size_t component, PaletteUse use, const Scale* before = nullptr,
  const RoundingRequest& rounding = {})
{
  DomainSurvey survey(type, PaletteBuilder::GetMost(count, use), rounding);
  survey.Add(values, count, components, component);
  return survey.Finish(count, use, before);
}
}

#endif
