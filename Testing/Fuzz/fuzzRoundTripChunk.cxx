// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A chunk and arrays on it, encoded and decoded: what comes back must be what went in.

#include "fuzzMeshes.h"
#include "gatunArrayCodec.h"

#include <cstdlib>

namespace
{
using namespace gatun;

void Require(bool right)
{
  if (!right)
  {
    std::abort();
  }
}

/** Puts values on the lattices of their domains: those of shared vertices, or all. */
void Round(
  std::vector<ComponentKeys>& keys, const std::vector<Domain>& domains, const Topology* mesh)
{
  for (std::size_t c = 0; c < keys.size(); ++c)
  {
    const auto& rounding = domains[c].GetQuantizer();
    for (Vertex v = 0; rounding && v < keys[c].Now.size(); ++v)
    {
      if (rounding.OnLattice || (mesh && mesh->IsShared(v)))
      {
        keys[c].Now[v] = rounding.ToLattice(domains[c].GetType(), keys[c].Now[v]);
      }
    }
  }
}

/** Requires that decoded values are those of the encoder, which are within the bounds. */
void Compare(const std::vector<ComponentKeys>& decoded, const std::vector<ComponentKeys>& encoded,
  const std::vector<ComponentKeys>& right, const std::vector<Domain>& domains)
{
  for (std::size_t c = 0; c < decoded.size(); ++c)
  {
    Require(decoded[c].Now == encoded[c].Now);
    for (std::size_t i = 0; i < decoded[c].Now.size(); ++i)
    {
      fuzz::CheckBound(domains[c], right[c].Now[i], decoded[c].Now[i]);
    }
  }
}

/** Values for vertices or tetrahedra, in the order of the walk. */
std::vector<ComponentKeys> TakeValues(
  fuzz::Input& in, std::size_t count, bool hasBefore, std::vector<Domain>& domains)
{
  const auto type = static_cast<ScalarType>(1 + in.TakeUpTo(9));
  std::vector<ComponentKeys> keys(1 + in.TakeUpTo(1));
  for (auto& component : keys)
  {
    domains.push_back(fuzz::TakeValueDomain(in, type, hasBefore));
    for (std::size_t i = 0; i < count; ++i)
    {
      component.Now.push_back(fuzz::TakeKey(in, domains.back()));
      if (hasBefore)
      {
        component.Before.push_back(
          in.TakeBool() ? component.Now.back() : fuzz::TakeKey(in, domains.back()));
      }
    }
  }
  return keys;
}

void TryValues(fuzz::Input& in, const EncodedChunk& encoded, const ChunkMesh& decoded)
{
  const bool hasBefore = in.TakeBool();
  {
    std::vector<Domain> domains;
    auto keys = TakeValues(in, decoded.Keys.size(), hasBefore, domains);
    const auto right = keys;
    Round(keys, domains, &decoded.Walk);
    const auto stream = EncodePointValues(
      ArrayContext(encoded.Mesh, fuzz::GetFits(decoded)).GetPoints(), domains, keys);
    const auto rounded = keys;
    for (std::size_t c = 0; c < keys.size(); ++c)
    {
      for (Vertex v = 0; v < keys[c].Now.size(); ++v)
      {
        keys[c].Now[v] = decoded.Walk.IsShared(v) ? rounded[c].Now[v] : 0;
      }
    }
    DecodePointValues(
      fuzz::Copy(stream), ArrayContext(decoded, fuzz::GetFits(decoded)).GetPoints(), domains, keys);
    Compare(keys, rounded, right, domains);
  }
  std::vector<Domain> domains;
  auto keys = TakeValues(in, decoded.Walk.Parents.size(), hasBefore, domains);
  const auto right = keys;
  Round(keys, domains, nullptr);
  const CellContext context{ decoded.Walk.Parents, &fuzz::GetTupleFit(),
    decoded.Walk.HasTree() ? Profile::Fast : Profile::Small };
  const auto stream = EncodeCellValues(context, domains, keys);
  const auto rounded = keys;
  for (auto& component : keys)
  {
    std::fill(component.Now.begin(), component.Now.end(), 0);
  }
  DecodeCellValues(fuzz::Copy(stream), context, domains, keys);
  Compare(keys, rounded, right, domains);
}

/** Encodes and decodes a chunk and values on it. */
void TryChunk(fuzz::Input in, const ChunkFrame& frame, const std::vector<fuzz::Tet>& tets,
  const std::vector<PointKeys>& own, Profile profile)
{
  const auto shared = frame.SharedKeys.size();
  const auto encoded = EncodeChunk(frame, tets, own, profile);
  const auto decoded =
    DecodeChunk(frame, fuzz::Copy(encoded.Connectivity), fuzz::Copy(encoded.Geometry));
  fuzz::CheckChunk(frame, decoded);
  const auto walked = decoded.Walk.CopyTets();
  Require(decoded.Keys == encoded.Mesh.Keys && walked == encoded.Mesh.Walk.CopyTets());
  for (std::size_t t = 0; t < tets.size(); ++t)
  {
    // Each corner's point, found through the decoder's numbers, is the input's.
    const auto corners = RotateCorners(walked[t], encoded.Corners[t]);
    for (unsigned i = 0; i < 4; ++i)
    {
      const auto source = decoded.Walk.Sources[corners[i]];
      const auto point = decoded.Walk.IsShared(corners[i])
        ? source & ~Topology::SharedFlag
        : static_cast<std::uint32_t>(shared) + encoded.OwnOrder[source];
      Require(point == tets[encoded.TetOrder[t]][i]);
      const auto& right = point < shared ? frame.SharedKeys[point] : own[point - shared];
      Require(decoded.Keys[corners[i]] == right);
    }
  }
  TryValues(in, encoded, decoded);
}
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Input in(data, size);
  std::uint32_t points = 0;
  const auto tets = fuzz::TakeTets(in, 40, points);
  if (tets.empty())
  {
    return 0;
  }
  auto frame = fuzz::TakeFrame(in, 0);
  const auto shared = std::min<std::size_t>(frame.SharedKeys.size(), points);
  frame.Tets = static_cast<std::uint32_t>(tets.size());
  frame.OwnPoints = points - static_cast<std::uint32_t>(shared);
  frame.SharedKeys.resize(shared);
  frame.SharedUsers.resize(shared);
  std::vector<PointKeys> own(frame.OwnPoints);
  for (auto& keys : own)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      keys[axis] = fuzz::TakeKey(in, frame.Domains[axis]);
    }
  }

  for (const auto profile : { Profile::Small, Profile::Fast })
  {
    TryChunk(in, frame, tets, own, profile);
  }
  return 0;
}
