// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFastArrays_h
#define gatunFastArrays_h

// Streams of values in the mode SpatialMode::Fast.

#include "gatunBytes.h"
#include "gatunDomain.h"
#include "gatunGateLanes.h"
#include "gatunGateValues.h"
#include "gatunPointContext.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
/** Whether all components have the values before. */
inline bool HaveBefore(std::span<const ComponentKeys> components)
{
  return std::all_of(components.begin(), components.end(),
    [](const ComponentKeys& keys) { return keys.Before.size() == keys.Now.size(); });
}

/** Whether values have bounds of errors. */
inline bool AreRounded(std::span<const Domain> domains)
{
  return std::any_of(domains.begin(), domains.end(),
    [](const Domain& domain) { return static_cast<bool>(domain.GetQuantizer()); });
}

inline GateKeys GetGateKeys(ComponentKeys& keys, TemporalMode temporal)
{
  static_assert(static_cast<int>(BeforeUse::Repeat) == static_cast<int>(TemporalMode::Repeat) &&
    static_cast<int>(BeforeUse::Change) == static_cast<int>(TemporalMode::Change));
  return { keys.Now, keys.Before, static_cast<BeforeUse>(temporal) };
}

/** Encodes in the fast mode. put(out, domain, keys) appends a component, whose keys become those
 * that readers will have. */
template <typename Put>
Bytes EncodeFast(std::span<const Domain> domains, std::span<ComponentKeys> components, Put&& put)
{
  // The values that readers will have depend on the mode if they are rounded.
  const bool areRounded = AreRounded(domains);
  std::vector<TemporalMode> temporal{ TemporalMode::None };
  if (HaveBefore(components))
  {
    temporal.insert(temporal.end(), { TemporalMode::Change, TemporalMode::Repeat });
  }
  Bytes best;
  std::vector<ComponentKeys> trial, rounded;
  for (const auto mode : temporal)
  {
    if (areRounded)
    {
      trial.assign(components.begin(), components.end());
    }
    const auto tried = areRounded ? std::span<ComponentKeys>(trial) : components;
    ByteWriter out;
    out.Put(static_cast<std::uint8_t>(SpatialMode::Fast));
    out.Put(static_cast<std::uint8_t>(mode));
    for (std::size_t c = 0; c < tried.size(); ++c)
    {
      put(out, domains[c], GetGateKeys(tried[c], mode));
    }
    if (best.empty() || out.Data.size() < best.size())
    {
      best = std::move(out.Data);
      rounded.swap(trial);
    }
  }
  std::move(rounded.begin(), rounded.end(), components.begin());
  return best;
}

/** Whether GetVertexLanes takes values of these domains. */
inline bool HaveLanes(std::span<const Domain> domains)
{
  return !AreRounded(domains) &&
    std::all_of(domains.begin(), domains.end(), Float32Domain::Matches);
}

/** Decodes the components of a stream of EncodeFast at the vertices of a tree, where HaveLanes. Not
 * for TemporalMode::Repeat. */
inline void DecodeLanes(std::span<const std::uint8_t> stream, TemporalMode temporal,
  const GateVertices& vertices, std::span<ComponentKeys> components)
{
  ByteReader in(stream.subspan(2));
  while (!components.empty())
  {
    const auto some = components.first(std::min(MostGateLanes, components.size()));
    std::array<KeyColumn, MostGateLanes> columns{};
    std::transform(some.begin(), some.end(), columns.begin(),
      [temporal](ComponentKeys& keys) -> KeyColumn
      {
        return { keys.Now.data(), 1,
          temporal == TemporalMode::Change ? keys.Before.data() : nullptr };
      });
    GetVertexLanes(in, vertices, std::span(columns).first(some.size()));
    components = components.subspan(some.size());
  }
}

/** Decodes a stream of EncodeFast. get(in, domain, keys) reads a component. */
template <typename Get>
void DecodeFast(std::span<const std::uint8_t> stream, TemporalMode temporal,
  std::span<const Domain> domains, std::span<ComponentKeys> components, Get&& get)
{
  ByteReader in(stream.subspan(2));
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    get(in, domains[c], GetGateKeys(components[c], temporal));
  }
}
}

#endif
