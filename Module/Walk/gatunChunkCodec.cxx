// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunChunkCodec.h"

#include "gatunChunkPlaces.h"
#include "gatunCornerRotation.h"
#include "gatunFaceTable.h"
#include "gatunFloatEnvironment.h"
#include "gatunTetGeometry.h"
#include "gatunTreeChunk.h"
#include "gatunWalk.h"

#include <optional>

namespace gatun
{
namespace
{
constexpr std::uint8_t FlagAngle = 1;
constexpr std::uint8_t FlagPlain = 2;
constexpr std::uint8_t FlagFlips = 4;
constexpr std::uint8_t FlagTree = 8; // alone

using Tets = std::span<const std::array<std::uint32_t, 4>>;

/** Provides the mesh to the walk of the encoder. */
class EncoderSide
{
public:
  EncoderSide(const FaceTable& faces, std::uint32_t shared, std::span<const LatticePoint> ownPlaces)
    : Faces(faces)
    , Visits(faces)
    , Shared(shared)
    , OwnPlaces(ownPlaces)
    , Met(shared + ownPlaces.size(), NoVertex)
  {
    this->OwnOrder.reserve(ownPlaces.size());
    this->TetOrder.reserve(faces.Rows.size());
    this->InputOf.reserve(this->Met.size());
  }

  std::uint32_t FindTet(const Front::Face& gate)
  {
    const auto& parent = this->Faces.Rows[this->TetOrder[gate.Open - 1]];
    const auto face =
      this->Visits.Find(parent.Over[FindCorner(parent.Corners, this->InputOf[gate.Apex])]);
    if (face == FaceTable::None)
    {
      return Topology::NoTet;
    }
    const auto& c = gate.Corners;
    this->Begun = { this->InputOf[c[0]], this->InputOf[c[1]], this->InputOf[c[2]],
      this->Faces.Rows[face / 4].Corners[face % 4] };
    this->Visit(face / 4);
    return face / 4;
  }

  void NextSeed()
  {
    const auto seed = this->Visits.FindFirst();
    this->Begun = this->Faces.Rows[seed].Corners;
    this->Visit(seed);
  }

  Vertex GetTarget(unsigned i) const { return this->Met[this->Begun[i]]; }
  bool IsTargetShared(unsigned i) const { return this->Begun[i] < this->Shared; }
  std::uint32_t GetTargetShared(unsigned i) const
  {
    return this->IsTargetShared(i) ? this->Begun[i] : 0;
  }

  void MeetShared(unsigned corner, std::uint32_t) { this->Meet(corner); }
  LatticePoint MeetOwn(unsigned corner, const GateRecord&)
  {
    this->Meet(corner);
    const auto own = this->Begun[corner] - this->Shared;
    this->OwnOrder.push_back(own);
    return this->OwnPlaces[own];
  }

  std::vector<std::uint32_t> OwnOrder;
  std::vector<std::uint32_t> TetOrder;
  std::vector<std::uint32_t> InputOf; // the input's vertex of each one of the walk

private:
  void Visit(std::uint32_t tet)
  {
    this->Visits.Visit(tet);
    this->TetOrder.push_back(tet);
  }

  void Meet(unsigned corner)
  {
    this->Met[this->Begun[corner]] = static_cast<Vertex>(this->InputOf.size());
    this->InputOf.push_back(this->Begun[corner]);
  }

  const FaceTable& Faces;
  FaceVisits Visits;
  const std::uint32_t Shared;
  std::span<const LatticePoint> OwnPlaces;
  std::vector<Vertex> Met;
  std::array<std::uint32_t, 4> Begun{};
};

/** Receives vertices from the walk of the decoder and decodes their coordinates. */
class DecoderSide
{
public:
  DecoderSide(const ChunkFrame& frame, const Lattice& lattice, EntropyDecoder& geometry,
    const GateRules& rules, ChunkMesh& mesh)
    : Frame(frame)
    , Map(lattice)
    , Geometry(geometry, frame.Domains, GateScheme<EntropyDecoder>(rules))
    , Mesh(mesh)
  {
    this->Geometry.Reserve(std::size_t{ frame.OwnPoints } + frame.SharedKeys.size());
  }

  static Vertex GetTarget(unsigned) { return NoVertex; }
  static bool IsTargetShared(unsigned) { return false; }
  static std::uint32_t GetTargetShared(unsigned) { return 0; }

  void MeetShared(unsigned, std::uint32_t index)
  {
    this->Mesh.Keys.push_back(this->Frame.SharedKeys[index]);
    this->Geometry.Meet(this->Mesh.Keys.back());
  }

  LatticePoint MeetOwn(unsigned, const GateRecord& record)
  {
    std::uint8_t rule = 0;
    const auto keys = this->Geometry.Code(record, this->Mesh.Keys, {}, rule);
    this->Mesh.Keys.push_back(keys);
    this->Geometry.Meet(keys);
    this->Mesh.UsedRules.push_back(rule);
    const auto place = this->Geometry.GetLastPlace(keys);
    return this->Map.Map(place[0], place[1], place[2]);
  }

private:
  const ChunkFrame& Frame;
  const Lattice& Map;
  GeometryCoder<EntropyDecoder> Geometry;
  ChunkMesh& Mesh;
};

/** Codes whether tetrahedra mirror the order of the walk, with those of their parents as context,
 * and mirrors them. */
template <typename Coder>
void CodeFlips(Coder& coder, std::vector<char>& flips, Topology& walk)
{
  std::array<BitModel, 2> models;
  for (std::size_t t = 0; t < flips.size(); ++t)
  {
    const auto parent = walk.Parents[t];
    const bool expected = parent != Topology::NoTet && flips[parent] != 0;
    flips[t] = coder.Bit(models[expected], flips[t] != 0);
    if (flips[t])
    {
      std::swap(walk.Tets[t][2], walk.Tets[t][3]);
    }
  }
}

struct Attempt
{
  Bytes Stream;
  Topology Walk;
  std::vector<std::uint32_t> OwnOrder;
  std::vector<std::uint32_t> TetOrder;
  std::vector<std::uint8_t> Corners;
};

template <Ranking Rule>
Attempt TryWalk(
  const WalkInput& input, const FaceTable& faces, std::span<const LatticePoint> ownPlaces)
{
  const auto count = faces.Rows.size();
  Attempt result;
  EntropyEncoder coder;
  EncoderSide side(faces, static_cast<std::uint32_t>(input.Shared.size()), ownPlaces);
  Walk<Rule, EntropyEncoder, EncoderSide>(coder, side, input, result.Walk).Run();

  std::vector<char> flips(count);
  result.Corners.resize(count);
  bool anyFlip = false;
  for (std::size_t t = 0; t < count; ++t)
  {
    std::array<std::uint32_t, 4> walked{};
    for (unsigned i = 0; i < 4; ++i)
    {
      walked[i] = side.InputOf[result.Walk.Tets[t][i]];
    }
    bool flip = false;
    result.Corners[t] = FindRotation(walked, faces.Rows[side.TetOrder[t]].Corners, flip);
    flips[t] = flip;
    anyFlip = anyFlip || flip;
  }
  if (anyFlip)
  {
    CodeFlips(coder, flips, result.Walk);
  }
  const auto body = coder.Finish();
  result.Stream.push_back(static_cast<std::uint8_t>((Rule == Ranking::Angle ? FlagAngle : 0) |
    (input.Plain ? FlagPlain : 0) | (anyFlip ? FlagFlips : 0)));
  result.Stream.insert(result.Stream.end(), body.begin(), body.end());
  result.Stream.resize(std::max<std::size_t>(result.Stream.size(), count / MaxItemsPerByte + 1), 0);
  result.OwnOrder = std::move(side.OwnOrder);
  faces.RestoreInput(side.TetOrder);
  result.TetOrder = std::move(side.TetOrder);
  return result;
}

/** The number of bits for the beginning of a walk: count tetrahedra. */
template <Ranking Rule>
double SampleWalk(WalkInput input, std::uint32_t count, const FaceTable& faces,
  std::span<const LatticePoint> ownPlaces)
{
  input.Stop = count;
  EntropyEncoder coder;
  EncoderSide side(faces, static_cast<std::uint32_t>(input.Shared.size()), ownPlaces);
  Topology walked;
  Walk<Rule, EntropyEncoder, EncoderSide>(coder, side, input, walked).Run();
  return coder.EstimateBits();
}

/** The ranking with the shorter stream, if a sample shows it. */
std::optional<Ranking> ChooseRanking(
  const WalkInput& input, const FaceTable& faces, std::span<const LatticePoint> ownPlaces)
{
  // A short sample decides only if the streams differ much.
  struct Sample
  {
    std::uint32_t Tets;
    double Sure; // ratio of bits
  };
  for (const auto& sample : { Sample{ std::max(input.Tets / 32, 2048u), 0.7 },
         Sample{ std::max(input.Tets / 8, 8192u), 0.85 } })
  {
    const double sphere = SampleWalk<Ranking::Sphere>(input, sample.Tets, faces, ownPlaces);
    const double angle = SampleWalk<Ranking::Angle>(input, sample.Tets, faces, ownPlaces);
    if (angle < sample.Sure * sphere)
    {
      return Ranking::Angle;
    }
    if (sphere < sample.Sure * angle)
    {
      return Ranking::Sphere;
    }
  }
  return std::nullopt;
}

Attempt EncodeConnectivity(
  const WalkInput& input, Tets tets, std::span<const LatticePoint> ownPlaces)
{
  const FaceTable faces(tets);
  const auto ranking = ChooseRanking(input, faces, ownPlaces);
  Attempt best;
  const auto consider = [&](Attempt attempt)
  {
    if (best.Stream.empty() || attempt.Stream.size() < best.Stream.size())
    {
      best = std::move(attempt);
    }
  };
  if (ranking != Ranking::Angle)
  {
    consider(TryWalk<Ranking::Sphere>(input, faces, ownPlaces));
  }
  if (ranking != Ranking::Sphere)
  {
    consider(TryWalk<Ranking::Angle>(input, faces, ownPlaces));
  }
  if (best.Stream.size() > 3 * tets.size())
  {
    auto plain = input;
    plain.Plain = true;
    consider(TryWalk<Ranking::Sphere>(plain, faces, ownPlaces));
  }
  return best;
}
}

//------------------------------------------------------------------------------
EncodedChunk EncodeChunk(
  const ChunkFrame& frame, Tets tets, std::span<const PointKeys> ownKeys, Profile profile)
{
  const FloatEnvironment guard;
  if (profile == Profile::Fast && FitsTree(frame.SharedKeys.size() + ownKeys.size()))
  {
    auto result = EncodeTreeChunk(frame, tets, ownKeys);
    auto& stream = result.Connectivity;
    stream.insert(stream.begin(), FlagTree);
    stream.resize(std::max<std::size_t>(stream.size(), tets.size() / MaxItemsPerByte + 1), 0);
    return result;
  }
  const Lattice lattice(frame.Box);
  const auto shared = MapShared(lattice, frame.Domains, frame.SharedKeys, frame.SharedUsers);
  std::vector<LatticePoint> ownPlaces(ownKeys.size());
  for (std::size_t i = 0; i < ownKeys.size(); ++i)
  {
    ownPlaces[i] = MapKeys(lattice, frame.Domains, ownKeys[i]);
  }
  auto best = EncodeConnectivity({ frame.Tets, frame.OwnPoints, shared }, tets, ownPlaces);

  EncodedChunk result;
  result.Connectivity = std::move(best.Stream);
  result.OwnOrder = std::move(best.OwnOrder);
  result.TetOrder = std::move(best.TetOrder);
  result.Corners = std::move(best.Corners);
  auto& mesh = result.Mesh;
  mesh.Walk = std::move(best.Walk);
  mesh.Domains = frame.Domains;
  mesh.OwnIds = mesh.Walk.FindOwnIds();
  mesh.Keys.resize(mesh.Walk.Sources.size());
  for (Vertex v = 0; v < mesh.Keys.size(); ++v)
  {
    const auto source = mesh.Walk.Sources[v];
    mesh.Keys[v] = mesh.Walk.IsShared(v) ? frame.SharedKeys[source & ~Topology::SharedFlag]
                                         : ownKeys[result.OwnOrder[source]];
  }
  auto geometry = EncodeTetGeometry({ mesh.Walk, mesh.Keys, mesh.Domains }, mesh.OwnIds);
  result.Geometry = std::move(geometry.Stream);
  mesh.Rules = std::move(geometry.Rules);
  mesh.UsedRules = std::move(geometry.UsedRules);
  return result;
}

ChunkMesh DecodeChunk(const ChunkFrame& frame, std::span<const std::uint8_t> connectivity,
  std::span<const std::uint8_t> geometry)
{
  const FloatEnvironment guard;
  if (connectivity.empty() || connectivity.size() < frame.Tets / MaxItemsPerByte + 1)
  {
    ThrowCorrupt("a chunk claims more tetrahedra than its stream can hold");
  }
  const auto flags = connectivity[0];
  if (flags == FlagTree)
  {
    return DecodeTreeChunk(frame, connectivity.subspan(1), geometry);
  }
  if (flags & ~(FlagAngle | FlagPlain | FlagFlips))
  {
    ThrowCorrupt("a connectivity stream has unknown flags");
  }
  ByteReader in(geometry);
  ChunkMesh mesh;
  mesh.Domains = frame.Domains;
  const auto rules = ReadGateRules(in);
  mesh.Rules = rules.Rules;
  mesh.Keys.reserve(std::size_t{ frame.OwnPoints } + frame.SharedKeys.size());
  mesh.UsedRules.reserve(frame.OwnPoints);

  const Lattice lattice(frame.Box);
  const auto shared = MapShared(lattice, frame.Domains, frame.SharedKeys, frame.SharedUsers);
  const WalkInput input{ frame.Tets, frame.OwnPoints, shared, (flags & FlagPlain) != 0 };
  EntropyDecoder symbols(connectivity.subspan(1));
  EntropyDecoder coordinates(in.GetBytes(in.GetRemaining()));
  DecoderSide side(frame, lattice, coordinates, rules, mesh);
  if (flags & FlagAngle)
  {
    Walk<Ranking::Angle, EntropyDecoder, DecoderSide>(symbols, side, input, mesh.Walk).Run();
  }
  else
  {
    Walk<Ranking::Sphere, EntropyDecoder, DecoderSide>(symbols, side, input, mesh.Walk).Run();
  }
  if (flags & FlagFlips)
  {
    std::vector<char> flips(mesh.Walk.Tets.size());
    CodeFlips(symbols, flips, mesh.Walk);
  }
  mesh.OwnIds = mesh.Walk.FindOwnIds();
  return mesh;
}
}
