// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunTetGeometry.h"

#include "gatunEntropy.h"
#include "gatunError.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
/** The number of rules is in the bits below. */
constexpr std::uint8_t FlagFrame = 0x80;

/** Codes the first own vertices of a mesh. */
void CodeGeometry(EntropyEncoder& coder, const TetVertices& mesh, const GateRules& rules,
  std::size_t ownVertices, std::vector<std::uint8_t>& usedRules)
{
  GeometryCoder<EntropyEncoder> geometry(coder, mesh.Domains, GateScheme<EntropyEncoder>(rules));
  geometry.Reserve(mesh.Keys.size());
  usedRules.resize(mesh.Walk.Records.size());
  std::size_t own = 0;
  for (Vertex v = 0; v < mesh.Keys.size() && own < ownVertices; ++v)
  {
    if (!mesh.Walk.IsShared(v))
    {
      geometry.Code(mesh.Walk.Records[own], mesh.Keys, mesh.Keys[v], usedRules[own]);
      ++own;
    }
    geometry.Meet(mesh.Keys[v]);
  }
}

void WriteRules(ByteWriter& out, const GateRules& rules)
{
  out.Put(static_cast<std::uint8_t>(rules.Rules.size() | (rules.Frame ? FlagFrame : 0)));
  for (const auto& rule : rules.Rules)
  {
    for (const auto weight : rule)
    {
      out.Put(weight);
    }
  }
  if (rules.Frame)
  {
    for (const auto weight : rules.Frame->Weights)
    {
      out.Put(weight);
    }
  }
}

/** Estimates the bits of a geometry stream with these rules, including the rules. */
double SampleGeometry(const TetVertices& mesh, const GateRules& rules)
{
  // Large enough that the adaptation of the models does not dominate.
  constexpr std::size_t least = 1024;
  const auto count = mesh.Walk.Records.size();
  const auto sample = std::min(count, std::max(count / 32, least));
  EntropyEncoder coder;
  std::vector<std::uint8_t> used;
  CodeGeometry(coder, mesh, rules, sample, used);
  ByteWriter head;
  WriteRules(head, rules);
  const double scale = sample > 0 ? static_cast<double>(count) / static_cast<double>(sample) : 0.0;
  return scale * coder.EstimateBits() + 8.0 * static_cast<double>(head.Data.size());
}
}

//------------------------------------------------------------------------------
EncodedGeometry EncodeTetGeometry(const TetVertices& vertices, std::span<const Vertex> ids)
{
  constexpr double sure = 0.95; // ratio of the samples' bits that decides without a full encoding
  constexpr std::size_t part = 256; // frames are slower, and must save this part of a stream
  // The first of equally good ones is used.
  std::vector<GateRules> attempts;
  const auto fitted = FitRule(vertices.Walk.Records, ids, vertices.Keys, vertices.Domains);
  attempts.push_back({ fitted, {} });
  attempts.push_back({ GetGridRules(), {} });
  if (const auto frame = FitFrame(vertices.Walk.Records, ids, vertices.Keys, vertices.Domains))
  {
    attempts.push_back({ fitted, frame });
    auto all = GetGridRules();
    all.insert(all.end(), fitted.begin(), fitted.end());
    attempts.push_back({ std::move(all), frame });
  }
  std::vector<double> bits;
  for (const auto& rules : attempts)
  {
    bits.push_back(SampleGeometry(vertices, rules));
  }
  const double least = *std::min_element(bits.begin(), bits.end());
  EncodedGeometry best;
  std::size_t leastSize = 0;
  for (std::size_t i = 0; i < attempts.size(); ++i)
  {
    if (least < sure * bits[i])
    {
      continue;
    }
    EntropyEncoder coder;
    std::vector<std::uint8_t> used;
    CodeGeometry(coder, vertices, attempts[i], vertices.Walk.Records.size(), used);
    ByteWriter out;
    WriteRules(out, attempts[i]);
    out.PutBytes(coder.Finish());
    const auto size = out.Data.size() + (attempts[i].Frame ? out.Data.size() / part : 0);
    if (best.Stream.empty() || size < leastSize)
    {
      leastSize = size;
      best = { std::move(out.Data), std::move(attempts[i].Rules), std::move(used) };
    }
  }
  return best;
}

//------------------------------------------------------------------------------
GateRules ReadGateRules(ByteReader& in)
{
  const auto head = in.Get<std::uint8_t>();
  const bool hasFrame = (head & FlagFrame) != 0;
  const std::size_t count = head & ~FlagFrame;
  if (count < 1 || count > MaxRules)
  {
    ThrowCorrupt("a geometry stream has an impossible number of prediction rules");
  }
  GateRules result;
  result.Rules.resize(count);
  for (auto& rule : result.Rules)
  {
    for (auto& weight : rule)
    {
      weight = in.Get<std::int16_t>();
    }
  }
  if (hasFrame)
  {
    for (auto& weight : result.Frame.emplace().Weights)
    {
      weight = in.Get<std::int16_t>();
    }
    if (!result.Frame->IsValid())
    {
      ThrowCorrupt("a geometry stream has a frame without size");
    }
  }
  return result;
}
}
