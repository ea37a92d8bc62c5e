// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGeometry_h
#define gatunGeometry_h

// Encoding of own vertices' coordinates, predicted from the gates on which the vertices were met.

#include "gatunDomain.h"
#include "gatunFrameCoder.h"
#include "gatunMeasure.h"
#include "gatunResidual.h"
#include "gatunTopology.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gatun
{
using PointKeys = std::array<Key, 3>;
using PointDomain = std::array<Domain, 3>;

/** Maps coordinates to the 16-bit lattice of a chunk. Deterministic. Coordinates that are not
 * finite map to the lowest place. */
class Lattice
{
public:
  Lattice() = default;

  /** box: the finite coordinates of the chunk. */
  explicit Lattice(const Bounds& box)
  {
    double extent = 0;
    for (unsigned i = 0; i < 3; ++i)
    {
      const double length = box[i].Max - box[i].Min;
      this->Low[i] = box[i].Min;
      extent = length > extent ? length : extent;
    }
    const double scale = 65535.0 / extent;
    this->Scale = std::isfinite(scale) ? scale : 0;
  }

  LatticePoint Map(double x, double y, double z, std::uint32_t users = 0) const
  {
    return { this->Map(x, 0), this->Map(y, 1), this->Map(z, 2), users };
  }

private:
  float Map(double value, unsigned axis) const
  {
    const double place = (value - this->Low[axis]) * this->Scale;
    // The comparisons map NaN to 0.
    const double bounded = place > 0 ? (place < 65535.0 ? place : 65535.0) : 0.0;
    return static_cast<float>(static_cast<std::int32_t>(bounded)) * (1.0F / 256.0F);
  }

  std::array<double, 3> Low{ 0, 0, 0 };
  double Scale = 0;
};

/** Weights of a gate's seven known vertices, in units of 1/256. */
using PredictionRule = std::array<std::int16_t, GateRecord::Size>;

/**
 * The prediction rules of a chunk. A single rule is fitted to the chunk. With several rules, each
 * vertex selects the best one, which suits vertices in rows, as in grids of hexahedra.
 */
using PredictionRules = std::vector<PredictionRule>;

constexpr std::size_t MaxRules = 16;

/** How the geometry of a chunk of tetrahedra is predicted. */
struct GateRules
{
  PredictionRules Rules;
  std::optional<FrameRule> Frame; ///< takes the place of the last rule for coordinates
};

/** Rules that extrapolate the rows, parallelograms and parallelepipeds of split hexahedra. */
const PredictionRules& GetGridRules();

/** The single rule with the least squared error, for irregular meshes. */
PredictionRules FitRule(std::span<const GateRecord> records, std::span<const Vertex> ids,
  std::span<const PointKeys> keys, const PointDomain& domain);

/**
 * Predicts several components by a rule. getNumbers(k) returns those of known vertex k.
 */
template <std::size_t N, std::size_t Slots, typename GetNumbers>
GATUN_INLINE std::array<double, N> ApplyRule(
  const std::array<std::int16_t, Slots>& rule, GetNumbers&& getNumbers)
{
  // The records of cells have vertices that are missing, and rules without weights for them.
  constexpr bool isSparse = Slots == CellRecord::Size;
  std::array<double, N> result{};
  for (unsigned k = 0; k < Slots; ++k)
  {
    if (isSparse && rule[k] == 0)
    {
      continue;
    }
    // Vertices without weight may be NaN. They are replaced by +0, which does not change the sum.
    const auto mask = std::uint64_t{ 0 } - (rule[k] != 0);
    const double weight = rule[k];
    const std::array<double, N> numbers = getNumbers(k);
    for (std::size_t i = 0; i < N; ++i)
    {
      const auto product = std::bit_cast<std::uint64_t>(weight * numbers[i]);
      result[i] += std::bit_cast<double>(product & mask);
    }
  }
  for (auto& number : result)
  {
    number *= 1.0 / 256.0;
  }
  return result;
}

/** The range of the keys of some points. */
struct KeyRange
{
  GATUN_INLINE void Add(const PointKeys& keys)
  {
    for (unsigned i = 0; i < 3; ++i)
    {
      this->Low[i] = std::min(this->Low[i], keys[i]);
      this->High[i] = std::max(this->High[i], keys[i]);
    }
  }

  GATUN_INLINE std::array<unsigned, 3> GetBits() const
  {
    std::array<unsigned, 3> bits{};
    for (unsigned i = 0; i < 3; ++i)
    {
      bits[i] = static_cast<unsigned>(std::bit_width(this->High[i] - this->Low[i]));
    }
    return bits;
  }

  PointKeys Low{ ~Key{ 0 }, ~Key{ 0 }, ~Key{ 0 } };
  PointKeys High{};
};

/** Predicts from the gates of tetrahedra: a scheme of GeometryCoder. */
template <typename Coder>
class GateScheme
{
public:
  using Record = GateRecord;
  static constexpr unsigned Groups = static_cast<unsigned>(MaxRules) + 1; // the last is of seeds
  static constexpr bool HasLocalRule = true; // that of Local is a rule among others

  explicit GateScheme(const GateRules& rules)
    : Rules(rules.Rules)
    , RuleModels(this->Rules.size() > 1 ? 27 * 4 * MaxRules : 0)
  {
    if (rules.Frame)
    {
      this->Local.emplace(*rules.Frame);
    }
  }

  const PredictionRule& GetRule(unsigned rule) const { return this->Rules[rule]; }
  std::size_t GetNumberOfRules() const { return this->Rules.size(); }
  static constexpr bool CanApply(unsigned, const GateRecord&) { return true; }

  unsigned GetGroup(const GateRecord& record, unsigned rule) const
  {
    return this->Rules.size() > 1 ? rule : record.CandidateGrade;
  }

  /** findBest() returns the best rule for the vertex that is being encoded. */
  template <typename FindBest>
  unsigned CodeRule(Coder& coder, const GateRecord& record, FindBest&& findBest)
  {
    if (this->Rules.size() == 1)
    {
      return 0;
    }
    const unsigned best = Coder::Encoding ? findBest() : 0;
    BitModel* models =
      &this->RuleModels[(record.EdgeGrade * 4u + record.CandidateGrade) * MaxRules];
    unsigned node = 1;
    for (int level = 3; level >= 0; --level)
    {
      node = 2 * node + coder.Bit(models[node], (best >> level) & 1);
    }
    const unsigned rule = node - static_cast<unsigned>(MaxRules);
    if (rule >= this->Rules.size())
    {
      ThrowCorrupt("a vertex names a prediction rule that is not there");
    }
    return rule;
  }

  /** The numbers of bits of the ranges of the keys of gate and apex. */
  GATUN_INLINE static std::array<unsigned, 3> GetSpreads(
    const GateRecord& record, std::span<const PointKeys> keys)
  {
    KeyRange range;
    for (unsigned k = 0; k < 4; ++k)
    {
      range.Add(keys[record.Known[k]]);
    }
    return range.GetBits();
  }

  /** Whether Local codes a vertex. */
  GATUN_INLINE bool IsLocal(const GateRecord& record, unsigned rule) const
  {
    return this->Local && rule + 1 == this->Rules.size() && !record.IsSeed();
  }

  std::optional<FrameCoder<Coder>> Local;

private:
  const PredictionRules Rules;
  std::vector<BitModel> RuleModels;
};

/** Codes the coordinates of own vertices in the order of the walk. Scheme: how they are predicted.
 */
template <typename Coder, typename Scheme = GateScheme<Coder>>
class GeometryCoder
{
public:
  using Record = typename Scheme::Record;

  GeometryCoder(Coder& coder, const PointDomain& domain, Scheme scheme)
    : Symbols(coder)
    , Components(domain)
    , IsFloat32(std::all_of(domain.begin(), domain.end(), Float32Domain::Matches))
    , Predictor(std::move(scheme))
    , Residuals(std::size_t{ 3 } * Scheme::Groups * 4)
  {
  }

  /** Registers the next vertex of the walk, shared or own, for the prediction of others. */
  void Meet(const PointKeys& keys)
  {
    if (this->Predictor.Local)
    {
      this->Predictor.Local->Meet();
    }
    auto& numbers = this->Numbers.emplace_back();
    for (unsigned i = 0; i < 3; ++i)
    {
      numbers[i] =
        this->IsFloat32 ? Float32Domain::ToNumber(keys[i]) : this->Components[i].ToNumber(keys[i]);
    }
  }

  /** Makes room for all vertices of a walk. */
  void Reserve(std::size_t vertices) { this->Numbers.reserve(vertices); }

  /** The coordinates of the vertex that was registered last. */
  std::array<double, 3> GetLastPlace(const PointKeys& keys) const
  {
    const auto& numbers = this->Numbers.back();
    return this->IsFloat32
      ? std::array{ numbers[0], numbers[1], numbers[2] }
      : std::array{ this->Components[0].ToValue(keys[0]), this->Components[1].ToValue(keys[1]),
          this->Components[2].ToValue(keys[2]) };
  }

  /**
   * Codes the next own vertex. keys contains those of all vertices met so far. Returns the keys of
   * the vertex; usedRule receives its rule.
   */
  PointKeys Code(const Record& record, std::span<const PointKeys> keys, const PointKeys& actual,
    std::uint8_t& usedRule)
  {
    static constexpr std::array<Float32Domain, 3> float32{};
    return this->IsFloat32 ? this->CodeAs(float32, record, keys, actual, usedRule)
                           : this->CodeAs(this->Components, record, keys, actual, usedRule);
  }

private:
  using PointNumbers = std::array<double, 4>; // three, and one more because pairs are faster

  template <typename DomainType>
  PointKeys CodeAs(const std::array<DomainType, 3>& domains, const Record& record,
    std::span<const PointKeys> keys, const PointKeys& actual, std::uint8_t& usedRule)
  {
    PointKeys result{};
    unsigned group = Scheme::Groups - 1;
    unsigned rule = 0;
    if (!record.IsSeed())
    {
      rule = this->Predictor.CodeRule(
        this->Symbols, record, [&] { return this->FindBestRule(record, actual); });
      group = this->Predictor.GetGroup(record, rule);
    }
    usedRule = static_cast<std::uint8_t>(rule);
    if (this->Predictor.IsLocal(record, rule))
    {
      this->Previous = this->Predictor.Local->Code(
        this->Symbols, domains, record, group, [&] { return this->Predict(rule, record); },
        std::span<const PointNumbers>(this->Numbers), keys, actual);
      return this->Previous;
    }
    const auto predictions = record.IsSeed() ? PointNumbers{} : this->Predict(rule, record);
    const auto spreads =
      record.IsSeed() ? std::array<unsigned, 3>{} : this->Predictor.GetSpreads(record, keys);
    unsigned grade = 0;
    for (unsigned i = 0; i < 3; ++i)
    {
      const DomainType& domain = domains[i];
      Key predicted = this->Previous[i];
      unsigned spread = domain.GetBits();
      if (!record.IsSeed())
      {
        predicted = domain.FromNumber(predictions[i]);
        spread = spreads[i];
      }
      auto& model = this->Residuals[(i * Scheme::Groups + group) * 4 + grade];
      const auto residual = model.Code(
        this->Symbols, spread, Coder::Encoding ? domain.Subtract(actual[i], predicted) : 0);
      result[i] = domain.Add(predicted, residual);
      if (!Coder::Encoding && !domain.IsValid(result[i]))
      {
        ThrowCorrupt("a coordinate is not in the palette");
      }
      grade = model.Grade;
    }
    this->Previous = result;
    return result;
  }

  GATUN_INLINE PointNumbers Predict(unsigned rule, const Record& record) const
  {
    return ApplyRule<std::tuple_size_v<PointNumbers>>(this->Predictor.GetRule(rule),
      [&](unsigned k) -> const PointNumbers& { return this->Numbers[record.Known[k]]; });
  }

  unsigned FindBestRule(const Record& record, const PointKeys& actual) const
  {
    unsigned best = 0;
    int least = 1 << 30;
    for (unsigned rule = 0; rule < this->Predictor.GetNumberOfRules(); ++rule)
    {
      if (!this->Predictor.CanApply(rule, record))
      {
        continue;
      }
      int bits = 0;
      for (const auto residual : this->GetResiduals(rule, record, actual))
      {
        const auto size = static_cast<std::uint64_t>(residual < 0 ? -(residual + 1) : residual);
        bits += 2 * std::bit_width(size) + (residual != 0);
      }
      if (bits < least)
      {
        least = bits;
        best = rule;
      }
    }
    return best;
  }

  std::array<std::int64_t, 3> GetResiduals(
    unsigned rule, const Record& record, const PointKeys& actual) const
  {
    if constexpr (Scheme::HasLocalRule)
    {
      if (this->Predictor.IsLocal(record, rule))
      {
        return this->Predictor.Local->GetResiduals(
          this->Components, record, std::span<const PointNumbers>(this->Numbers), actual);
      }
    }
    const auto predictions = this->Predict(rule, record);
    std::array<std::int64_t, 3> residuals{};
    for (unsigned i = 0; i < 3; ++i)
    {
      const Domain& domain = this->Components[i];
      residuals[i] = domain.Subtract(actual[i], domain.FromNumber(predictions[i]));
    }
    return residuals;
  }

  Coder& Symbols;
  const PointDomain& Components;
  const bool IsFloat32; // without palettes
  Scheme Predictor;
  std::vector<ResidualModel> Residuals;
  std::vector<PointNumbers> Numbers; // of all vertices met
  PointKeys Previous{};
};
}

#endif
