// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunTestCells_h
#define gatunTestCells_h

// Chunks of cells of any type for tests, and their round trip.

#include "gatunArrayCodec.h"
#include "gatunArrayContext.h"
#include "gatunCellCodec.h"
#include "gatunCellShapes.h"
#include "gatunCellTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace gatun::test
{
using Ids = std::vector<std::uint32_t>;
using Faces = std::vector<Ids>;

struct TestCells
{
  std::vector<std::array<double, 3>> Points;
  CellList Cells;

  std::uint32_t AddPoint(double x, double y, double z)
  {
    this->Points.push_back({ x, y, z });
    return static_cast<std::uint32_t>(this->Points.size() - 1);
  }

  void Add(int type, const Ids& corners)
  {
    this->Cells.Types.push_back(static_cast<std::uint8_t>(type));
    this->Cells.Corners.insert(this->Cells.Corners.end(), corners.begin(), corners.end());
    this->Cells.Starts.push_back(static_cast<std::uint32_t>(this->Cells.Corners.size()));
    if (!this->Cells.FaceStarts.empty())
    {
      this->Cells.FaceStarts.push_back(static_cast<std::uint32_t>(this->Cells.Faces.size()));
    }
  }

  void AddPolyhedron(const Ids& corners, const Faces& faces)
  {
    if (this->Cells.FaceStarts.empty())
    {
      this->Cells.FaceStarts.assign(this->Cells.Starts.size(), 0);
    }
    for (const auto& face : faces)
    {
      this->Cells.Faces.push_back(static_cast<std::uint32_t>(face.size()));
      this->Cells.Faces.insert(this->Cells.Faces.end(), face.begin(), face.end());
    }
    this->Add(42, corners);
  }
};

struct CellCase
{
  ChunkFrame Frame;
  CellList Cells;
  std::vector<PointKeys> OwnKeys;
};

struct CellCaseOptions
{
  ScalarType Type = ScalarType::Float64;
  bool Palettes = false;
  std::function<bool(const std::array<double, 3>&)> IsShared = [](const std::array<double, 3>&)
  { return false; };
};

inline PointDomain MakeDomains(const TestCells& mesh, const CellCaseOptions& options)
{
  PointDomain domains;
  for (unsigned i = 0; i < 3; ++i)
  {
    std::set<Key> keys;
    for (const auto& point : mesh.Points)
    {
      keys.insert(Domain(options.Type).FromNumber(point[i]));
    }
    domains[i] = options.Palettes
      ? Domain(options.Type, std::make_shared<const Palette>(keys.begin(), keys.end()))
      : Domain(options.Type);
  }
  return domains;
}

/** A chunk as the writer would hand it to the codec. Points that no cell uses are left out. */
inline CellCase MakeCellCase(const TestCells& mesh, const CellCaseOptions& options = {})
{
  CellCase result;
  auto& frame = result.Frame;
  frame.Domains = MakeDomains(mesh, options);
  result.Cells = mesh.Cells;
  std::vector<std::uint32_t*> uses;
  for (auto& corner : result.Cells.Corners)
  {
    uses.push_back(&corner);
  }
  auto& faces = result.Cells.Faces;
  for (std::size_t at = 0; at < faces.size(); at += 1 + faces[at])
  {
    for (std::size_t i = 1; i <= faces[at]; ++i)
    {
      uses.push_back(&faces[at + i]);
    }
  }
  std::vector<char> used(mesh.Points.size(), 0);
  for (const auto* use : uses)
  {
    used[*use] = 1;
  }
  Ids local(mesh.Points.size(), 0);
  std::uint32_t count = 0;
  for (const bool shared : { true, false })
  {
    for (std::size_t p = 0; p < mesh.Points.size(); ++p)
    {
      if (!used[p] || options.IsShared(mesh.Points[p]) != shared)
      {
        continue;
      }
      local[p] = count++;
      PointKeys keys{};
      std::array<double, 3> place{};
      for (unsigned i = 0; i < 3; ++i)
      {
        const auto plain = Domain(options.Type).FromNumber(mesh.Points[p][i]);
        std::array<std::uint64_t, 1> raw{};
        Domain::WritePlain(options.Type, plain, raw.data());
        keys[i] = frame.Domains[i].Read(raw.data());
        place[i] = frame.Domains[i].ToValue(keys[i]);
      }
      frame.Box.Include(place);
      (shared ? frame.SharedKeys : result.OwnKeys).push_back(keys);
    }
  }
  for (auto* use : uses)
  {
    *use = local[*use];
  }
  frame.SharedUsers.assign(frame.SharedKeys.size(), 1);
  frame.OwnPoints = static_cast<std::uint32_t>(result.OwnKeys.size());
  frame.Cells = { static_cast<std::uint32_t>(result.Cells.GetNumber()),
    static_cast<std::uint32_t>(result.Cells.Corners.size()),
    static_cast<std::uint32_t>(result.Cells.Faces.size()) };
  return result;
}

/** Faces from their least corner, in ascending order: what polyhedra keep. */
inline Faces MakePlain(std::span<const std::uint32_t> stream)
{
  Faces faces;
  for (std::size_t at = 0; at < stream.size(); at += 1 + stream[at])
  {
    const auto face = stream.subspan(at + 1, stream[at]);
    Ids least(face.begin(), face.end());
    for (std::size_t turn = 1; turn < face.size(); ++turn)
    {
      Ids other(face.begin(), face.end());
      std::rotate(other.begin(), other.begin() + static_cast<std::ptrdiff_t>(turn), other.end());
      least = std::min(least, other);
    }
    faces.push_back(least);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/** Whether a cell has what must be kept without an order of corners. */
inline bool IsSameCell(
  const CellList& a, std::size_t cell, const CellList& b, std::size_t other, bool exactly)
{
  const auto one = a.GetCorners(cell);
  const auto two = b.GetCorners(other);
  if (a.Types[cell] != b.Types[other] || one.size() != two.size())
  {
    return false;
  }
  const bool same = std::equal(one.begin(), one.end(), two.begin());
  if (exactly)
  {
    const auto f = a.GetFaces(cell);
    const auto g = b.GetFaces(other);
    return same && std::equal(f.begin(), f.end(), g.begin(), g.end());
  }
  if (a.Types[cell] == 42)
  {
    return std::is_permutation(one.begin(), one.end(), two.begin()) &&
      MakePlain(a.GetFaces(cell)) == MakePlain(b.GetFaces(other));
  }
  if (a.Types[cell] == 5 && one.size() == 3)
  {
    const std::array turned{ two[0], two[1], two[2], two[0], two[1] };
    return std::search(turned.begin(), turned.end(), one.begin(), one.end()) != turned.end();
  }
  if (a.Types[cell] == 10 && one.size() == 4)
  {
    for (unsigned r = 0; r < 12; ++r)
    {
      if (RotateCorners(std::array{ one[0], one[1], one[2], one[3] }, r) ==
        std::array{ two[0], two[1], two[2], two[3] })
      {
        return true;
      }
    }
    return false;
  }
  return same;
}

/** Encodes and decodes values on points and cells with every mode. */
inline void ExpectArrays(const EncodedCells& encoded, const ChunkMesh& decoded)
{
  const bool isFast = decoded.Walk.HasTree();
  const auto fits = isFast ? ContextFits::None : ContextFits::All;
  const ArrayContext ofEncoded(encoded.Mesh, fits);
  const ArrayContext ofDecoded(decoded, fits);
  const Domain domain(ScalarType::Float32);
  std::vector<ComponentKeys> actual(1);
  for (const auto& place : decoded.GetPlaces())
  {
    actual[0].Now.push_back(domain.FromNumber(place[0] * 3 - place[1] + std::sin(place[2])));
  }
  std::vector<SpatialMode> modes{ SpatialMode::Fit, SpatialMode::Gate };
  for (const auto& fit : { true, false })
  {
    auto context = ofEncoded.GetPoints();
    context.Fit = fit ? context.Fit : nullptr;
    const auto stream = EncodePointValues(context, { &domain, 1 }, actual);
    auto found = actual;
    for (Vertex v = 0; v < found[0].Now.size(); ++v)
    {
      found[0].Now[v] = decoded.Walk.IsShared(v) ? found[0].Now[v] : 0;
    }
    DecodePointValues(stream, ofDecoded.GetPoints(), { &domain, 1 }, found);
    EXPECT_EQ(found[0].Now, actual[0].Now);
  }
  actual[0].Now.clear();
  for (const auto cell : encoded.CellOrder)
  {
    actual[0].Now.push_back(domain.FromNumber(static_cast<double>(cell)));
  }
  const CellContext cells{ encoded.Mesh.Walk.Parents, nullptr,
    isFast ? Profile::Fast : Profile::Small };
  const auto stream = EncodeCellValues(cells, { &domain, 1 }, actual);
  auto found = actual;
  std::fill(found[0].Now.begin(), found[0].Now.end(), 0);
  DecodeCellValues(stream, { decoded.Walk.Parents }, { &domain, 1 }, found);
  EXPECT_EQ(found[0].Now, actual[0].Now);
}

/** The mesh of a chunk in the fast profile, or in the small one. */
inline void ExpectGates(const ChunkMesh& mesh, Profile profile)
{
  const auto& gates = mesh.Walk.Gates;
  EXPECT_EQ(mesh.Walk.HasTree(),
    profile == Profile::Fast && FitsCellTree(mesh.Cells.GetNumber(), mesh.Keys.size()));
  for (Vertex v = 0; v < gates.size(); ++v)
  {
    for (unsigned k = 0; k < 4; ++k)
    {
      EXPECT_TRUE(GetCorner(gates[v], k) < v || v == 0);
    }
  }
}

/** Encodes, decodes, and compares everything. */
inline EncodedCells ExpectRoundTripOf(
  const CellCase& chunk, const ShapeTable& shapes, Profile profile)
{
  auto encoded = EncodeCells(chunk.Frame, chunk.Cells, shapes, chunk.OwnKeys, true, profile);
  auto mesh = DecodeCells(chunk.Frame, shapes, encoded.Connectivity, encoded.Geometry);
  const auto& walk = mesh.Walk;
  EXPECT_EQ(mesh.Cells, encoded.Mesh.Cells);
  EXPECT_EQ(walk.Parents, encoded.Mesh.Walk.Parents);
  EXPECT_EQ(walk.Sources, encoded.Mesh.Walk.Sources);
  EXPECT_EQ(walk.EdgeLog, encoded.Mesh.Walk.EdgeLog);
  EXPECT_EQ(mesh.Keys, encoded.Mesh.Keys);
  EXPECT_EQ(mesh.CellRules, encoded.Mesh.CellRules);
  EXPECT_EQ(mesh.UsedRules, encoded.Mesh.UsedRules);
  EXPECT_EQ(walk.Gates, encoded.Mesh.Walk.Gates);
  ExpectGates(mesh, profile);

  EXPECT_EQ(mesh.Cells.GetNumber(), chunk.Cells.GetNumber());
  for (std::size_t c = 0; c < mesh.Cells.GetNumber(); ++c)
  {
    EXPECT_TRUE(walk.Parents[c] < c || walk.Parents[c] == Topology::NoTet);
  }
  for (const auto& edge : walk.EdgeLog)
  {
    EXPECT_NE(edge[0], edge[1]);
  }
  const auto shared = static_cast<std::uint32_t>(chunk.Frame.SharedKeys.size());
  const auto getInputOf = [&](const EncodedCells& coded)
  {
    return [&](Vertex v)
    {
      const auto source = coded.Mesh.Walk.Sources[v];
      return coded.Mesh.Walk.IsShared(v) ? source & ~Topology::SharedFlag
                                         : shared + coded.OwnOrder[source];
    };
  };
  const auto expectKeys = [&](const ChunkMesh& decoded, const EncodedCells& coded)
  {
    for (Vertex v = 0; v < decoded.Keys.size(); ++v)
    {
      const auto input = getInputOf(coded)(v);
      EXPECT_EQ(decoded.Keys[v],
        input < shared ? chunk.Frame.SharedKeys[input] : chunk.OwnKeys[input - shared]);
    }
  };
  expectKeys(mesh, encoded);
  const auto restoreNumbers = [&](CellList& cells, const EncodedCells& coded)
  {
    const auto inputOf = getInputOf(coded);
    std::transform(cells.Corners.begin(), cells.Corners.end(), cells.Corners.begin(), inputOf);
    for (std::size_t at = 0; at < cells.Faces.size(); at += 1 + cells.Faces[at])
    {
      const auto begin = cells.Faces.begin() + static_cast<std::ptrdiff_t>(at + 1);
      std::transform(begin, begin + cells.Faces[at], begin, inputOf);
    }
  };
  auto turned = mesh.Cells;
  restoreNumbers(turned, encoded);
  auto restored = mesh.Cells;
  RestoreCorners(restored, encoded.Corners);
  restoreNumbers(restored, encoded);
  std::vector<char> seen(chunk.Cells.GetNumber(), 0);
  for (std::size_t c = 0; c < restored.GetNumber(); ++c)
  {
    const auto input = encoded.CellOrder[c];
    EXPECT_EQ(seen[input]++, 0);
    EXPECT_TRUE(IsSameCell(turned, c, chunk.Cells, input, false));
    EXPECT_TRUE(IsSameCell(restored, c, chunk.Cells, input, true));
  }
  ExpectArrays(encoded, mesh);
  const auto again = EncodeCells(chunk.Frame, chunk.Cells, shapes, chunk.OwnKeys, false, profile);
  EXPECT_EQ(again.CellOrder, encoded.CellOrder);
  if (profile == Profile::Small)
  {
    // In the fast one, turned triangles meet their points in another order.
    EXPECT_EQ(again.Geometry, encoded.Geometry);
    EXPECT_LE(again.Connectivity.size(), encoded.Connectivity.size() + 16);
  }
  EXPECT_TRUE(again.Corners.empty());
  const auto decoded = DecodeCells(chunk.Frame, shapes, again.Connectivity, again.Geometry);
  expectKeys(decoded, again);
  auto free = decoded.Cells;
  restoreNumbers(free, again);
  for (std::size_t c = 0; c < free.GetNumber(); ++c)
  {
    EXPECT_TRUE(IsSameCell(free, c, chunk.Cells, again.CellOrder[c], false));
  }
  return encoded;
}

/** The same in both profiles. Returns the chunk in the small one. */
inline EncodedCells ExpectRoundTrip(const CellCase& chunk, const ShapeTable& shapes = {})
{
  ExpectRoundTripOf(chunk, shapes, Profile::Fast);
  return ExpectRoundTripOf(chunk, shapes, Profile::Small);
}

/** The bits of a stream for each cell. */
inline double GetBits(const Bytes& stream, const EncodedCells& cells)
{
  return 8.0 * static_cast<double>(stream.size()) / static_cast<double>(cells.CellOrder.size());
}

//------------------------------------------------------------------------------
// Meshes

/** n * n * n hexahedra, points moved by up to jitter. keep: which of them are there. */
inline TestCells MakeHexes(
  int n, double jitter, const std::function<bool(int, int, int)>& keep = {}, int type = 12)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> move(-jitter, jitter);
  TestCells mesh;
  for (int z = 0; z <= n; ++z)
  {
    for (int y = 0; y <= n; ++y)
    {
      for (int x = 0; x <= n; ++x)
      {
        const double dx = move(random), dy = move(random), dz = move(random);
        mesh.AddPoint(x + dx, y + dy, z + dz);
      }
    }
  }
  const auto id = [n](int x, int y, int z)
  { return static_cast<std::uint32_t>((z * (n + 1) + y) * (n + 1) + x); };
  for (int z = 0; z < n; ++z)
  {
    for (int y = 0; y < n; ++y)
    {
      for (int x = 0; x < n; ++x)
      {
        if (keep && !keep(x, y, z))
        {
          continue;
        }
        Ids corners{ id(x, y, z), id(x + 1, y, z), id(x + 1, y + 1, z), id(x, y + 1, z),
          id(x, y, z + 1), id(x + 1, y, z + 1), id(x + 1, y + 1, z + 1), id(x, y + 1, z + 1) };
        if (type == 11)
        {
          std::swap(corners[2], corners[3]);
          std::swap(corners[6], corners[7]);
        }
        mesh.Add(type, corners);
      }
    }
  }
  return mesh;
}

/** Puts the cells into a random order. */
inline void ShuffleCells(TestCells& mesh, unsigned seed = 5)
{
  Ids order(mesh.Cells.GetNumber());
  for (std::uint32_t i = 0; i < order.size(); ++i)
  {
    order[i] = i;
  }
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  TestCells shuffled;
  shuffled.Points = mesh.Points;
  for (const auto cell : order)
  {
    const auto corners = mesh.Cells.GetCorners(cell);
    if (mesh.Cells.Types[cell] == 42)
    {
      Faces faces;
      const auto stream = mesh.Cells.GetFaces(cell);
      for (std::size_t at = 0; at < stream.size(); at += 1 + stream[at])
      {
        const auto face = stream.subspan(at + 1, stream[at]);
        faces.emplace_back(face.begin(), face.end());
      }
      shuffled.AddPolyhedron({ corners.begin(), corners.end() }, faces);
    }
    else
    {
      shuffled.Add(mesh.Cells.Types[cell], { corners.begin(), corners.end() });
    }
  }
  mesh = std::move(shuffled);
}

inline TestCells MakePoints(std::size_t count)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-1, 1);
  TestCells mesh;
  for (std::size_t i = 0; i < count; ++i)
  {
    mesh.AddPoint(place(random), place(random), place(random));
  }
  return mesh;
}

/** Cells of all types with random corners, some with a number that their type does not allow, and
 * polyhedra whose faces are anything. */
inline TestCells MakeZoo(std::size_t points, std::size_t cells, unsigned seed)
{
  auto mesh = MakePoints(points);
  std::mt19937 random(seed);
  const auto below = [&](std::size_t count)
  { return static_cast<std::uint32_t>(random() % count); };
  const auto pick = [&](std::size_t count)
  {
    Ids ids(count);
    for (auto& id : ids)
    {
      id = below(points);
    }
    return ids;
  };
  for (std::size_t i = 0; i < cells; ++i)
  {
    const auto type = below(4) == 0 ? 42u : below(256);
    if (type == 42)
    {
      Faces faces;
      for (std::uint32_t f = below(8); f > 0; --f)
      {
        faces.push_back(pick(below(7)));
      }
      mesh.AddPolyhedron(pick(below(9)), faces);
    }
    else
    {
      const auto usual = GetCellKind(static_cast<int>(type)).Points;
      mesh.Add(static_cast<int>(type), pick(usual > 0 && below(3) > 0 ? usual : below(40)));
    }
  }
  return mesh;
}
}

#endif
