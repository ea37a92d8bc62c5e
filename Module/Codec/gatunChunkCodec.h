// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunChunkCodec_h
#define gatunChunkCodec_h

// The mesh of one chunk: connectivity and geometry streams.

#include "gatunArrayCodec.h"
#include "gatunBytes.h"
#include "gatunGeometry.h"
#include "gatunTopology.h"
#include "gatunTypes.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gatun
{
/** No chunk has more tetrahedra; all numbers inside of one fit 32 bits with room to spare. */
constexpr std::uint32_t MaxChunkTets = 1u << 20;

/** A chunk's connectivity stream has at least one byte for so many tetrahedra (and a shared block
 * one byte for so many points), so that a short file cannot ask for much memory. */
constexpr std::uint32_t MaxItemsPerByte = 256;

/** What is needed of a chunk before its streams are decoded. */
struct ChunkFrame
{
  std::uint32_t Tets = 0;
  std::uint32_t OwnPoints = 0;
  Bounds Box;
  std::vector<PointKeys> SharedKeys;
  std::vector<std::uint32_t> SharedUsers; // as LatticePoint::Users
  PointDomain Domains;
};

/** A mesh in the order of its walk, which arrays are coded in. */
struct ChunkMesh
{
  Topology Walk;
  std::vector<PointKeys> Keys; // of every vertex in the order of the walk
  PredictionRules Rules;
  std::vector<std::uint8_t> UsedRules; // one an own vertex
  PointDomain Domains;

  /** What point arrays need; with the neighbours' weights if withFit. */
  void MakeContext(bool withFit);
  PointContext Context;
  std::optional<NeighbourFit> Fit;
};

struct EncodedChunk
{
  Bytes Connectivity;
  Bytes Geometry;
  ChunkMesh Mesh;
  std::vector<std::uint32_t> OwnOrder; // own vertex -> own vertex of the input
  std::vector<std::uint32_t> TetOrder; // tetrahedron -> tetrahedron of the input

  /** Of each tetrahedron the rotation that gives the input's corners: see RotateCorners. */
  std::vector<std::uint8_t> Corners;
};

/**
 * Encodes a chunk. Vertices of tets: shared ones first, in the order of the frame, then own ones,
 * with their keys in ownKeys. Every vertex must be used. Same input, same bytes.
 */
EncodedChunk EncodeChunk(const ChunkFrame& frame,
  std::span<const std::array<std::uint32_t, 4>> tets, std::span<const PointKeys> ownKeys);

/** Decodes what EncodeChunk made. Safe on hostile input. */
ChunkMesh DecodeChunk(const ChunkFrame& frame, std::span<const std::uint8_t> connectivity,
  std::span<const std::uint8_t> geometry);

/** The even permutation number rotation, 0 to 11, of four corners; 0 leaves them. */
template <typename T>
std::array<T, 4> RotateCorners(const std::array<T, 4>& corners, unsigned rotation)
{
  static constexpr std::uint8_t orders[12][4] = { { 0, 1, 2, 3 }, { 0, 2, 3, 1 }, { 0, 3, 1, 2 },
    { 1, 0, 3, 2 }, { 1, 3, 2, 0 }, { 1, 2, 0, 3 }, { 2, 3, 0, 1 }, { 2, 0, 1, 3 }, { 2, 1, 3, 0 },
    { 3, 2, 1, 0 }, { 3, 1, 0, 2 }, { 3, 0, 2, 1 } };
  const auto* order = orders[rotation];
  return { corners[order[0]], corners[order[1]], corners[order[2]], corners[order[3]] };
}
}

#endif
