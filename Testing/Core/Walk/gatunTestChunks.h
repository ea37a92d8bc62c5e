// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunTestChunks_h
#define gatunTestChunks_h

// Chunks of tetrahedra for tests of the codec.

#include "gatunChunkCodec.h"
#include "gatunTestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <vector>

namespace gatun::test
{
using Tets = std::vector<std::array<std::uint32_t, 4>>;

/** A chunk as the writer would hand it to the codec. */
struct ChunkCase
{
  ChunkFrame Frame;
  Tets Elements;
  std::vector<PointKeys> OwnKeys;
};

struct CaseOptions
{
  ScalarType Type = ScalarType::Float64;
  bool Palettes = false;
  std::function<bool(const double*)> IsShared = [](const double*) { return false; };
};

inline PointKeys ReadKeys(const PointDomain& domains, ScalarType type, const double* point)
{
  PointKeys keys{};
  for (unsigned i = 0; i < 3; ++i)
  {
    // Two, as GCC 12 believes that eight bytes might be read.
    const std::array<float, 2> narrow{ static_cast<float>(point[i]), 0 };
    keys[i] =
      type == ScalarType::Float32 ? domains[i].Read(narrow.data()) : domains[i].Read(&point[i]);
  }
  return keys;
}

inline PointDomain MakeDomains(const TestMesh& mesh, const CaseOptions& options)
{
  PointDomain domains;
  for (unsigned i = 0; i < 3; ++i)
  {
    domains[i] = Domain(options.Type);
    if (options.Palettes)
    {
      std::set<Key> keys;
      for (std::size_t p = 0; p < mesh.GetPoints(); ++p)
      {
        keys.insert(ReadKeys(domains, options.Type, &mesh.Coordinates[3 * p])[i]);
      }
      domains[i] = Domain(options.Type, std::make_shared<const Palette>(keys.begin(), keys.end()));
    }
  }
  return domains;
}

inline ChunkCase MakeCase(const TestMesh& mesh, const CaseOptions& options = {})
{
  ChunkCase result;
  auto& frame = result.Frame;
  frame.Domains = MakeDomains(mesh, options);
  std::vector<char> used(mesh.GetPoints(), 0);
  for (const auto id : mesh.Ids)
  {
    used[static_cast<std::size_t>(id)] = 1;
  }
  std::vector<std::uint32_t> local(mesh.GetPoints(), 0);
  std::uint32_t count = 0;
  for (const bool shared : { true, false })
  {
    for (std::size_t p = 0; p < mesh.GetPoints(); ++p)
    {
      const double* point = &mesh.Coordinates[3 * p];
      if (!used[p] || options.IsShared(point) != shared)
      {
        continue;
      }
      local[p] = count++;
      const auto keys = ReadKeys(frame.Domains, options.Type, point);
      (shared ? frame.SharedKeys : result.OwnKeys).push_back(keys);
      for (unsigned i = 0; i < 3; ++i)
      {
        const double value = frame.Domains[i].ToValue(keys[i]);
        if (std::isfinite(value))
        {
          frame.Box[i].Min = std::min(frame.Box[i].Min, value);
          frame.Box[i].Max = std::max(frame.Box[i].Max, value);
        }
      }
    }
  }
  frame.SharedUsers.assign(frame.SharedKeys.size(), 1);
  for (std::size_t t = 0; t < mesh.GetTets(); ++t)
  {
    std::array<std::uint32_t, 4> tet{};
    for (std::size_t i = 0; i < 4; ++i)
    {
      tet[i] = local[static_cast<std::size_t>(mesh.Ids[4 * t + i])];
    }
    result.Elements.push_back(tet);
  }
  frame.Tets = static_cast<std::uint32_t>(result.Elements.size());
  frame.OwnPoints = static_cast<std::uint32_t>(result.OwnKeys.size());
  return result;
}

/** Encodes, decodes, and compares every tetrahedron, corner for corner, and every key. */
inline EncodedChunk ExpectRoundTripOf(const ChunkCase& chunk, Profile profile)
{
  auto encoded = EncodeChunk(chunk.Frame, chunk.Elements, chunk.OwnKeys, profile);
  const auto mesh = DecodeChunk(chunk.Frame, encoded.Connectivity, encoded.Geometry);
  const auto walked = mesh.Walk.CopyTets();
  EXPECT_EQ(walked, encoded.Mesh.Walk.CopyTets());
  EXPECT_EQ(mesh.Walk.Parents, encoded.Mesh.Walk.Parents);
  EXPECT_EQ(mesh.Walk.EdgeLog, encoded.Mesh.Walk.EdgeLog);
  EXPECT_EQ(mesh.Keys, encoded.Mesh.Keys);
  EXPECT_EQ(mesh.UsedRules, encoded.Mesh.UsedRules);
  EXPECT_EQ(mesh.Rules, encoded.Mesh.Rules);

  const auto shared = static_cast<std::uint32_t>(chunk.Frame.SharedKeys.size());
  const auto inputOf = [&](Vertex v)
  {
    const auto source = mesh.Walk.Sources[v];
    return mesh.Walk.IsShared(v) ? source & ~Topology::SharedFlag
                                 : shared + encoded.OwnOrder[source];
  };
  EXPECT_EQ(walked.size(), chunk.Elements.size());
  std::vector<char> seen(chunk.Elements.size(), 0);
  for (std::size_t t = 0; t < walked.size(); ++t)
  {
    std::array<std::uint32_t, 4> tet{};
    std::transform(walked[t].begin(), walked[t].end(), tet.begin(), inputOf);
    EXPECT_EQ(RotateCorners(tet, encoded.Corners[t]), chunk.Elements[encoded.TetOrder[t]]);
    EXPECT_EQ(seen[encoded.TetOrder[t]]++, 0);
  }
  for (Vertex v = 0; v < mesh.Keys.size(); ++v)
  {
    const auto input = inputOf(v);
    EXPECT_EQ(
      mesh.Keys[v], input < shared ? chunk.Frame.SharedKeys[input] : chunk.OwnKeys[input - shared]);
  }
  EXPECT_EQ(mesh.Walk.Gates, encoded.Mesh.Walk.Gates);
  EXPECT_EQ(mesh.Walk.HasTree(), profile == Profile::Fast && FitsTree(mesh.Keys.size()));
  return encoded;
}

/** The same in both profiles. Returns the chunk in the small one. */
inline EncodedChunk ExpectRoundTrip(const ChunkCase& chunk)
{
  ExpectRoundTripOf(chunk, Profile::Fast);
  return ExpectRoundTripOf(chunk, Profile::Small);
}
}

#endif
