// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellGeometry.h"

#include "gatunRuleFitter.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>

namespace gatun
{
namespace
{
using Fitter = RuleFitter<CellRecord::Size, CellRecord::N1>;

/** A coordinate of a vertex and of the vertices that it is predicted from. */
struct RuleSample
{
  std::array<double, CellRecord::Size> Numbers;
  double ActualNumber;
  Key Actual;
  unsigned Axis;
};

/** The bits of the differences that a rule leaves in samples. */
std::uint64_t CountBits(
  const CellRule& rule, std::span<const RuleSample> samples, const PointDomain& domains)
{
  std::uint64_t bits = 0;
  for (const auto& sample : samples)
  {
    const auto predicted =
      ApplyRule<1>(rule, [&](unsigned k) { return std::array{ sample.Numbers[k] }; })[0];
    const auto key = domains[sample.Axis].FromNumber(predicted);
    bits += static_cast<std::uint64_t>(
      std::bit_width(key > sample.Actual ? key - sample.Actual : sample.Actual - key));
  }
  return bits;
}

/** The rule for two of the vertices that most samples agree with. */
CellRule FitPair(std::span<const RuleSample> samples, unsigned one, unsigned other)
{
  std::vector<double> weights;
  for (const auto& sample : samples)
  {
    const double weight =
      (sample.ActualNumber - sample.Numbers[one]) / (sample.Numbers[other] - sample.Numbers[one]);
    if (std::isfinite(weight))
    {
      weights.push_back(weight);
    }
  }
  CellRule rule{};
  if (!weights.empty())
  {
    const auto middle = weights.begin() + static_cast<std::ptrdiff_t>(weights.size() / 2);
    std::nth_element(weights.begin(), middle, weights.end());
    rule[other] =
      static_cast<std::int16_t>(std::clamp(std::floor(256.0 * *middle + 0.5), -1024.0, 1024.0));
  }
  rule[one] = static_cast<std::int16_t>(256 - rule[other]);
  return rule;
}

/**
 * Returns the best rule for records with a mask: a fitted one, a common one, or one for two of the
 * vertices. The latter ones are exact in straight cells, where vertices are on lines and there is
 * no single fit.
 */
CellRule SelectRule(const CellRule& fitted, unsigned mask, std::span<const RuleSample> samples,
  const PointDomain& domains)
{
  auto best = fitted;
  auto least = CountBits(fitted, samples, domains);
  const auto consider = [&](const CellRule& rule)
  {
    const auto bits = CountBits(rule, samples, domains);
    best = bits < least ? rule : best;
    least = std::min(least, bits);
  };
  for (const auto& rule : GetCellRules())
  {
    if ((GetMask(rule) & ~mask) == 0)
    {
      consider(rule);
    }
  }
  for (unsigned other = 1; other < CellRecord::Size; ++other)
  {
    for (unsigned one = 0; one < other; ++one)
    {
      if ((mask >> one & mask >> other & 1) != 0)
      {
        consider(FitPair(samples, one, other));
      }
    }
  }
  return best;
}

/** Rules for the sets of known vertices that occur often enough. */
CellRuleTable FitCellRules(const ChunkMesh& mesh)
{
  constexpr std::size_t samplesPerWeight = 40;
  constexpr std::size_t mostSelecting = 120; // samples that a rule is selected by
  struct Set
  {
    Fitter Fit;
    std::size_t Samples = 0;
    std::vector<RuleSample> First;
  };
  std::map<unsigned, Set> sets;
  for (Vertex v = 0; v < mesh.Keys.size(); ++v)
  {
    if (mesh.Walk.IsShared(v))
    {
      continue;
    }
    const auto& record = mesh.Walk.CellRecords[mesh.Walk.Sources[v]];
    const auto mask = record.GetMask();
    if (record.IsSeed() || std::popcount(mask) < 2)
    {
      continue;
    }
    auto& set = sets[mask];
    ++set.Samples;
    for (unsigned i = 0; i < 3; ++i)
    {
      const auto& domain = mesh.Domains[i];
      std::array<double, CellRecord::Size> numbers{};
      for (unsigned k = 0; k < CellRecord::Size; ++k)
      {
        // Missing vertices are like the first one: they get no weight.
        const auto known = record.Known[k] != NoVertex ? record.Known[k] : record.Known[0];
        numbers[k] = domain.ToNumber(mesh.Keys[known][i]);
      }
      set.Fit.Add(numbers, domain.ToNumber(mesh.Keys[v][i]));
      if (set.First.size() < mostSelecting)
      {
        const auto key = mesh.Keys[v][i];
        set.First.push_back({ numbers, domain.ToNumber(key), key, i });
      }
    }
  }
  std::erase_if(sets,
    [](const auto& item)
    {
      return item.second.Samples <
        samplesPerWeight * static_cast<std::size_t>(std::popcount(item.first));
    });
  while (sets.size() > CellRuleTable::MaxFitted)
  {
    sets.erase(std::min_element(sets.begin(), sets.end(),
      [](const auto& a, const auto& b) { return a.second.Samples < b.second.Samples; }));
  }
  CellRuleTable table;
  table.Mode = CellRuleMode::Fitted;
  for (const auto& [mask, set] : sets)
  {
    auto rule = set.Fit.Fit();
    for (unsigned k = 0; k < CellRecord::Size; ++k)
    {
      if ((mask >> k & 1) == 0)
      {
        rule[CellRecord::N1] = static_cast<std::int16_t>(rule[CellRecord::N1] + rule[k]);
        rule[k] = 0;
      }
    }
    table.FittedMasks.push_back(static_cast<std::uint16_t>(mask));
    table.Rules.push_back(SelectRule(rule, mask, set.First, mesh.Domains));
  }
  return table;
}

/** Whether a chunk has many vertices that PlaneCoder can code, as surfaces have. */
bool HasPlanes(const ChunkMesh& mesh)
{
  const auto& records = mesh.Walk.CellRecords;
  const auto isOn = [](const CellRecord& record) {
    return PlaneCoder<EntropyEncoder>::CanCode(record) && record.Known[CellRecord::N3] == NoVertex;
  };
  return 4 * std::count_if(records.begin(), records.end(), isOn) >
    static_cast<std::ptrdiff_t>(records.size());
}

/** Codes the first own vertices of a mesh. */
void CodeGeometry(EntropyEncoder& coder, const ChunkMesh& mesh, const CellRuleTable& table,
  std::size_t ownVertices, std::vector<std::uint8_t>& usedRules)
{
  CellGeometryCoder<EntropyEncoder> geometry(
    coder, mesh.Domains, CellScheme<EntropyEncoder>(table));
  geometry.Reserve(mesh.Keys.size());
  usedRules.resize(mesh.Walk.CellRecords.size());
  std::size_t count = 0;
  for (Vertex v = 0; v < mesh.Keys.size() && count < ownVertices; ++v)
  {
    if (!mesh.Walk.IsShared(v))
    {
      const auto own = mesh.Walk.Sources[v];
      geometry.Code(mesh.Walk.CellRecords[own], mesh.Keys, mesh.Keys[v], usedRules[own]);
      ++count;
    }
    geometry.Meet(mesh.Keys[v]);
  }
}

/** Estimates the bits of a stream from the beginning of a mesh. */
double SampleGeometry(const ChunkMesh& mesh, const CellRuleTable& table)
{
  // Large enough that the adaptation of the models does not dominate.
  constexpr std::size_t least = 2048;
  const auto count = mesh.Walk.CellRecords.size();
  const auto sample = std::min(count, std::max(count / 8, least));
  EntropyEncoder coder;
  std::vector<std::uint8_t> used;
  CodeGeometry(coder, mesh, table, sample, used);
  ByteWriter rules;
  table.Write(rules);
  const double scale = sample > 0 ? static_cast<double>(count) / static_cast<double>(sample) : 0.0;
  return scale * coder.EstimateBits() + 8.0 * static_cast<double>(rules.Data.size());
}
}

//------------------------------------------------------------------------------
const std::vector<CellRule>& GetCellRules()
{
  // N1 N2 N3, D12 D13 D23, O, B1 B2 B3.
  static const std::vector<CellRule> rules{
    { 256, 256, 256, -256, -256, -256, 256, 0, 0, 0 }, // parallelepiped
    { 256, 256, 0, -256, 0, 0, 0, 0, 0, 0 },           // parallelograms
    { 256, 0, 256, 0, -256, 0, 0, 0, 0, 0 },           //
    { 0, 256, 256, 0, 0, -256, 0, 0, 0, 0 },           //
    { 512, 0, 0, 0, 0, 0, 0, -256, 0, 0 },             // continuations of rows
    { 0, 512, 0, 0, 0, 0, 0, 0, -256, 0 },             //
    { 0, 0, 512, 0, 0, 0, 0, 0, 0, -256 },             //
    { 171, 171, 170, -85, -85, -86, 0, 0, 0, 0 },      // means of the above
    { 256, 128, 128, -128, -128, 0, 0, 0, 0, 0 },      //
    { 128, 128, 0, 0, 0, 0, 0, 0, 0, 0 },              //
    { 64, 0, 0, 64, 64, 64, 0, 0, 0, 0 },              // nodes between corners
    { 86, 0, 0, 85, 85, 0, 0, 0, 0, 0 },               //
    { 128, 0, 0, 128, 0, 0, 0, 0, 0, 0 },              //
    { 0, 0, 256, 0, 0, 0, 0, 0, 0, 0 },                // a swept coordinate repeats
    { 0, 256, 0, 0, 0, 0, 0, 0, 0, 0 },                //
    { 256, 0, 0, 0, 0, 0, 0, 0, 0, 0 },                //
  };
  return rules;
}

const std::array<std::uint8_t, 1u << CellRecord::Size>& GetFirstRules()
{
  static const auto first = []
  {
    const auto& rules = GetCellRules();
    std::array<std::uint8_t, 1u << CellRecord::Size> result{};
    for (unsigned mask = 0; mask < result.size(); ++mask)
    {
      std::uint8_t rule = 0;
      while (rule + 1u < rules.size() && (GetMask(rules[rule]) & ~mask) != 0)
      {
        ++rule;
      }
      result[mask] = rule;
    }
    return result;
  }();
  return first;
}

CellRuleTable::CellRuleTable()
  : Rules(GetCellRules())
{
}

void CellRuleTable::Write(ByteWriter& out) const
{
  out.Put(static_cast<std::uint8_t>(
    static_cast<unsigned>(this->Mode) | static_cast<unsigned>(this->Planes) << 2));
  if (this->Mode != CellRuleMode::Fitted)
  {
    return;
  }
  out.Put(static_cast<std::uint8_t>(this->FittedMasks.size()));
  const auto builtIn = this->Rules.size() - this->FittedMasks.size();
  for (std::size_t i = 0; i < this->FittedMasks.size(); ++i)
  {
    out.Put(this->FittedMasks[i]);
    for (unsigned k = 0; k < CellRecord::Size; ++k)
    {
      if (this->FittedMasks[i] >> k & 1)
      {
        out.Put(this->Rules[builtIn + i][k]);
      }
    }
  }
}

CellRuleTable CellRuleTable::Read(ByteReader& in)
{
  CellRuleTable table;
  const auto modes = in.Get<std::uint8_t>();
  const unsigned mode = modes & 3u;
  const unsigned planes = modes >> 2;
  if (mode > static_cast<unsigned>(CellRuleMode::Fitted) || (planes > 1 && planes != 3))
  {
    ThrowCorrupt("a geometry stream has an unknown mode");
  }
  table.Mode = static_cast<CellRuleMode>(mode);
  table.Planes = static_cast<PlaneMode>(planes);
  const unsigned count = table.Mode == CellRuleMode::Fitted ? in.Get<std::uint8_t>() : 0u;
  if (count > MaxFitted)
  {
    ThrowCorrupt("a geometry stream has an impossible number of prediction rules");
  }
  for (unsigned i = 0; i < count; ++i)
  {
    const auto mask = in.Get<std::uint16_t>();
    const unsigned before = i > 0 ? table.FittedMasks.back() : 0u;
    if (mask <= before || mask >> CellRecord::Size != 0 || (mask & 1) == 0)
    {
      ThrowCorrupt("a prediction rule is for impossible vertices");
    }
    CellRule rule{};
    for (unsigned k = 0; k < CellRecord::Size; ++k)
    {
      rule[k] = (mask >> k & 1) != 0 ? in.Get<std::int16_t>() : std::int16_t{ 0 };
    }
    table.FittedMasks.push_back(mask);
    table.Rules.push_back(rule);
  }
  return table;
}

Bytes EncodeCellGeometry(ChunkMesh& mesh)
{
  constexpr double sure = 1.1; // ratio of the samples' bits that decides without a full encoding
  std::array<CellRuleTable, 3> tables{ FitCellRules(mesh), CellRuleTable(), CellRuleTable() };
  tables[1].Mode = CellRuleMode::Named;
  tables[2].Mode = CellRuleMode::First;
  std::array<double, 3> bits{ SampleGeometry(mesh, tables[0]) };
  if (HasPlanes(mesh))
  {
    for (const auto planes : { PlaneMode::Planes, PlaneMode::Repeats })
    {
      auto table = tables[0];
      table.Planes = planes;
      const double sampled = SampleGeometry(mesh, table);
      if (sampled < bits[0])
      {
        bits[0] = sampled;
        tables[0] = table;
      }
    }
  }
  for (std::size_t i = 1; i < tables.size(); ++i)
  {
    tables[i].Planes = tables[0].Planes;
    bits[i] = SampleGeometry(mesh, tables[i]);
  }
  const double least = *std::min_element(bits.begin(), bits.end());
  Bytes best;
  for (std::size_t i = 0; i < tables.size(); ++i)
  {
    if (bits[i] > sure * least)
    {
      continue;
    }
    EntropyEncoder coder;
    std::vector<std::uint8_t> used;
    CodeGeometry(coder, mesh, tables[i], mesh.Walk.CellRecords.size(), used);
    ByteWriter out;
    tables[i].Write(out);
    out.PutBytes(coder.Finish());
    if (best.empty() || out.Data.size() < best.size())
    {
      best = std::move(out.Data);
      mesh.CellRules = tables[i].Rules;
      mesh.UsedRules = std::move(used);
    }
  }
  return best;
}
}
