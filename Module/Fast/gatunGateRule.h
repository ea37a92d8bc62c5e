// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGateRule_h
#define gatunGateRule_h

// How the values of a vertex are predicted from its gate. See Documentation/format.md, 10.12.

#include "gatunBytes.h"
#include "gatunDomain.h"
#include "gatunError.h"
#include "gatunTetTree.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace gatun
{
constexpr unsigned GateSize = 4;

/** Weights of the four vertices of a gate in units of 1/256. Their sum is 256. */
using GateWeights = std::array<std::int16_t, GateSize>;

template <typename Number>
std::array<Number, GateSize> ScaleWeights(const GateWeights& weights)
{
  std::array<Number, GateSize> scaled{};
  std::transform(weights.begin(), weights.end(), scaled.begin(),
    [](std::int16_t weight) { return static_cast<Number>(weight) * Number{ 0.00390625 }; });
  return scaled;
}

struct VertexRule
{
  GateWeights Weights{};
  bool Copies = false; ///< whether keys may be copies of those of the gate

  void Write(ByteWriter& out) const
  {
    out.Put<std::uint8_t>(this->Copies ? 1 : 0);
    for (unsigned k = 0; k + 1 < GateSize; ++k)
    {
      out.Put(this->Weights[k]);
    }
  }

  /** Throws Error(Corrupt). */
  static VertexRule Read(ByteReader& in)
  {
    VertexRule rule;
    const auto copies = in.Get<std::uint8_t>();
    if (copies > 1)
    {
      ThrowCorrupt("an array's stream has unknown flags");
    }
    rule.Copies = copies != 0;
    int last = 256;
    for (unsigned k = 0; k + 1 < GateSize; ++k)
    {
      rule.Weights[k] = in.Get<std::int16_t>();
      last -= rule.Weights[k];
    }
    rule.Weights[GateSize - 1] = static_cast<std::int16_t>(last);
    if (rule.Weights[GateSize - 1] != last)
    {
      ThrowCorrupt("an array's stream has impossible weights");
    }
    return rule;
  }
};

/** The vertices of a chunk with a TetTree. */
struct GateVertices
{
  std::span<const PackedTet> Gates;
  std::span<const std::uint32_t> Sources; ///< as in TetTree
};

/** How values before help. */
enum class BeforeUse : std::uint8_t
{
  None,
  Repeat, ///< the value before is the prediction
  Change  ///< the change since then is predicted
};

/** The keys of a component now, and before if they are used. */
struct GateKeys
{
  std::span<Key> Now;
  std::span<const Key> Before{};
  BeforeUse Use = BeforeUse::None;
};
}

#endif
