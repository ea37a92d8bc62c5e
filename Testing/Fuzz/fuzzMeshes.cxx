// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzzMeshes.h"

#include "gatunCellNodes.h"
#include "gatunCellShapes.h"
#include "gatunChunkTets.h"
#include "gatunExactBound.h"
#include "gatunFloatEnvironment.h"
#include "gatunWithType.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

namespace gatun::fuzz
{
namespace
{
double TakeBound(Input& in)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr std::array special{ 0.0, 1.0, -1.0, 1e308, -1e308, 1e-310, infinity, -infinity,
    std::numeric_limits<double>::quiet_NaN(), 65535.0, 1e300, -1e300 };
  const auto which = in.Take<std::uint8_t>();
  return which < 128 ? special[which % special.size()] : in.Take<float>();
}

[[noreturn]] void Stop()
{
  std::abort();
}

void Require(bool right)
{
  if (!right)
  {
    Stop();
  }
}
}

Key TakeKey(Input& in, const Domain& domain)
{
  const auto how = in.Take<std::uint8_t>();
  Key key = 0;
  if (domain.GetPalette())
  {
    key = how % domain.GetPalette()->size();
  }
  else if (how < 160)
  {
    key = domain.FromNumber(static_cast<double>(how % 16) * (how & 16 ? 0.25 : 1.0));
  }
  else if (how < 176)
  {
    key = (how & 1) ? 0 : ~Key{ 0 };
  }
  else
  {
    key = in.Take<std::uint64_t>();
  }
  key = domain.GetBits() == 64 ? key : key & ((Key{ 1 } << domain.GetBits()) - 1);
  return domain.IsValid(key) ? key : domain.FromNumber(0);
}

/** Any scale, or none. */
Scale TakeScale(Input& in, ScalarType type)
{
  const Scale scale{ static_cast<ScaleKind>(1 + in.Take<std::uint8_t>() % 4),
    static_cast<std::uint8_t>(in.Take<std::uint8_t>() % 64),
    static_cast<std::int8_t>(in.Take<std::int8_t>() % 32) };
  return scale.IsValid(type) ? scale : Scale();
}

namespace
{
Domain MakeDomain(Input& in, ScalarType type, std::uint8_t count)
{
  if (count >= 100 && count < 160)
  {
    return Domain(type, TakeScale(in, type));
  }
  if (count < 160 || !IsFloating(type))
  {
    return Domain(type);
  }
  const Domain plain(type);
  std::set<Key> keys;
  for (unsigned i = 0; i <= count % 9u; ++i)
  {
    keys.insert(TakeKey(in, plain));
  }
  return Domain(type, std::make_shared<Palette>(keys.begin(), keys.end()));
}

/** Any valid quantizer, or none. */
Quantizer TakeQuantizer(Input& in, ScalarType type)
{
  constexpr std::array special{ 1.0, 0.5, 0.1, 1e-3, 1e-20, 3.0,
    std::numeric_limits<double>::denorm_min(), 1e300 };
  const auto how = in.Take<std::uint8_t>();
  const auto number = in.Take<std::uint8_t>();
  ErrorBound bound{ static_cast<ErrorKind>(1 + how % 4), 0, (how & 16) != 0 };
  bound.Bound = bound.Kind == ErrorKind::Bits ? 1 + number % 52
    : number < 128                            ? special[number % special.size()]
                                              : std::abs(in.Take<float>());
  FiniteRange range;
  for (int i = 0; i < 2 && bound.Kind == ErrorKind::Relative; ++i)
  {
    const double end = TakeBound(in);
    range.Include(std::isfinite(end) ? end : 1);
  }
  auto quantizer = MakeQuantizer(type, bound, range);
  if (how >= 224)
  {
    quantizer.Bound = bound;
    quantizer.Step = number;
  }
  quantizer.OnLattice = (how & 32) != 0;
  return quantizer.IsValid(type) ? quantizer : Quantizer();
}
}

Domain TakeDomain(Input& in, ScalarType type)
{
  return MakeDomain(in, type, in.Take<std::uint8_t>());
}

Domain TakeValueDomain(Input& in, ScalarType type, bool hasBefore)
{
  const auto count = in.Take<std::uint8_t>();
  if (count >= 40 && count < 100)
  {
    const auto quantizer = TakeQuantizer(in, type);
    return quantizer ? Domain(type, quantizer) : Domain(type);
  }
  return hasBefore ? Domain(type) : MakeDomain(in, type, count);
}

void CheckBound(const Domain& domain, Key original, Key found)
{
  const auto& quantizer = domain.GetQuantizer();
  if (!quantizer)
  {
    Require(original == found);
    return;
  }
  // The range is anything: what counts is the step that follows from it.
  ErrorBound bound = quantizer.Bound;
  if (bound.Kind <= ErrorKind::Relative)
  {
    bound.Kind = ErrorKind::Absolute;
    bound.Bound =
      IsFloating(domain.GetType()) ? quantizer.Step : std::floor((quantizer.Step - 1) / 2);
  }
  std::array<std::uint64_t, 2> values{};
  domain.Write(original, &values[0]);
  domain.Write(found, &values[1]);
  WithType(domain.GetType(), static_cast<const void*>(values.data()),
    [&](const auto* typed)
    {
      const auto step = sizeof(values[0]) / sizeof(*typed);
      Require(test::ExactBound(bound, typed, 0).IsWithin(typed[0], typed[step]));
    });
}

const QuadraticFit& GetTupleFit()
{
  static const QuadraticFit fit = []
  {
    const FloatEnvironment guard;
    std::vector<std::array<double, 3>> places;
    for (std::uint32_t i = 0; i < MostTuples; ++i)
    {
      const auto number = static_cast<double>(i);
      places.push_back({ i % 7 + 0.01 * number, i / 7 % 6 - 0.3 * (i % 3), number / 42 });
    }
    return QuadraticFit(places);
  }();
  return fit;
}

ChunkFrame TakeFrame(Input& in, std::uint32_t mostTets)
{
  ChunkFrame frame;
  frame.Tets = in.TakeUpTo(mostTets);
  frame.OwnPoints = in.TakeUpTo(4 * mostTets);
  const auto type = in.TakeBool() ? ScalarType::Float32 : ScalarType::Float64;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    frame.Box[axis] = { TakeBound(in), TakeBound(in) };
    frame.Domains[axis] = TakeDomain(in, type);
  }
  const auto shared = in.TakeUpTo(in.TakeBool() ? 255 : 12);
  const auto seed = in.Take<std::uint8_t>();
  for (std::uint32_t i = 0; i < shared; ++i)
  {
    PointKeys keys{};
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      keys[axis] = TakeKey(in, frame.Domains[axis]);
    }
    frame.SharedKeys.push_back(keys);
    frame.SharedUsers.push_back(seed * (i + 1));
  }
  return frame;
}

std::vector<Tet> TakeTets(Input& in, std::uint32_t mostTets, std::uint32_t& points)
{
  std::vector<Tet> tets;
  points = 0;
  const auto count = in.TakeUpTo(mostTets);
  while (tets.size() < count)
  {
    const auto how = in.Take<std::uint8_t>();
    Tet tet{};
    if (tets.empty() || how >= 250)
    {
      for (auto& corner : tet)
      {
        corner = points++;
      }
    }
    else if (how >= 240)
    {
      // Four of any: soup, doubles, corners that repeat.
      for (auto& corner : tet)
      {
        corner = in.TakeUpTo(points - 1);
      }
    }
    else
    {
      // On a face of one of the last tetrahedra.
      const auto back = std::min<std::size_t>(how / 16 + 1u, tets.size());
      tet = tets[tets.size() - back];
      const unsigned corner = how % 4u;
      tet[corner] = (how & 4) ? points++ : in.TakeUpTo(points - 1);
      std::swap(tet[(corner + 1) % 4], tet[(corner + (how & 8 ? 2u : 3u)) % 4]);
    }
    tets.push_back(tet);
  }
  return tets;
}

namespace
{
/** Polygons that have edges in common. */
class Surface
{
public:
  /** Appends a triangle, quadrilateral or polygon, linear or with nodes. */
  void TakeCell(Input& in, unsigned kind, CellList& cells, std::uint32_t& points)
  {
    static constexpr std::array<std::uint8_t, 8> types{ 5, 9, 7, 5, 8, 22, 28, 9 };
    const auto type = types[kind];
    const auto& nodes = GetCellNodes(type);
    const std::uint32_t degree = type == 7 ? 3 + in.TakeUpTo(9)
      : nodes.Corners > 0                  ? static_cast<std::uint32_t>(nodes.Corners)
      : type == 5                          ? 3
                                           : 4;
    std::vector<std::uint32_t> corners;
    if (!this->Edges.empty())
    {
      corners = this->TakeEdge(in);
    }
    const auto size = std::max(degree, static_cast<std::uint32_t>(nodes.Points));
    while (corners.size() < size)
    {
      // A vertex of another edge, or any, or a new one.
      const auto choice = in.Take<std::uint8_t>();
      corners.push_back(choice >= 250 && points > 0 ? in.TakeUpTo(points - 1)
          : choice >= 160 && !this->Edges.empty()   ? this->TakeEdge(in)[0]
                                                    : points++);
    }
    for (std::uint32_t i = 0; i < degree; ++i)
    {
      this->Edges.push_back({ corners[i], corners[(i + 1) % degree] });
    }
    cells.Types.push_back(type);
    cells.Corners.insert(cells.Corners.end(), corners.begin(), corners.end());
    cells.Starts.push_back(static_cast<std::uint32_t>(cells.Corners.size()));
    if (!cells.FaceStarts.empty())
    {
      cells.FaceStarts.push_back(static_cast<std::uint32_t>(cells.Faces.size()));
    }
  }

private:
  /** One of the last edges, mostly against its direction. */
  std::vector<std::uint32_t> TakeEdge(Input& in) const
  {
    const auto choice = in.Take<std::uint8_t>();
    const auto& edge = this->Edges[this->Edges.size() - 1 - choice / 4 % this->Edges.size()];
    return choice % 4 == 0 ? edge : std::vector{ edge[1], edge[0] };
  }

  std::vector<std::vector<std::uint32_t>> Edges;
};
}

namespace
{
/** The points of a Lagrange or Bezier cell. */
std::uint32_t CountNodes(int type, unsigned order)
{
  return static_cast<std::uint32_t>(GetNodesOfOrder(type, order).Points);
}
}

CellList TakeCells(Input& in, std::uint32_t mostCells, std::uint32_t& points)
{
  constexpr std::array usual{ 12, 12, 12, 42, 13, 14, 10, 11, 25, 24 };
  CellList cells;
  points = 0;
  std::vector<std::uint32_t> last;
  Surface surface;
  for (auto count = in.TakeUpTo(mostCells); count > 0; --count)
  {
    const auto how = in.Take<std::uint8_t>();
    if (how >= 200 && how < 232)
    {
      surface.TakeCell(in, how % 8, cells, points);
      continue;
    }
    const int type = how < 200 ? usual[how % usual.size()] : in.Take<std::uint8_t>();
    const auto fixed = GetCellKind(type).Points;
    const bool isUsual = how < 240;
    const auto size = type == 42      ? 8u
      : isUsual && HasNodeOrder(type) ? CountNodes(type, 1u + how % 3u)
      : isUsual && fixed > 0          ? fixed
                                      : in.TakeUpTo(12);
    const auto pick = [&](std::uint32_t i)
    {
      // The far corners of the cell before, then new ones.
      const auto choice = in.Take<std::uint8_t>();
      const auto half = static_cast<std::uint32_t>(last.size() / 2);
      return points > 0 && choice >= 240           ? in.TakeUpTo(points - 1)
        : i < half && choice < 230 && how % 16 > 0 ? last[half + i]
                                                   : points++;
    };
    last.clear();
    std::vector<std::uint32_t> corners;
    const auto begin = cells.Corners.size();
    for (std::uint32_t i = 0; i < size; ++i)
    {
      corners.push_back(pick(i));
    }
    cells.Types.push_back(static_cast<std::uint8_t>(type));
    cells.Corners.insert(cells.Corners.end(), corners.begin(), corners.end());
    cells.Starts.push_back(static_cast<std::uint32_t>(cells.Corners.size()));
    if (type == 42 && cells.FaceStarts.empty())
    {
      cells.FaceStarts.assign(cells.Types.size(), 0);
    }
    if (type == 42)
    {
      const auto* const hexahedron = GetCellKind(12).Shape;
      const auto damage = in.Take<std::uint8_t>();
      for (std::size_t at = 0; at < hexahedron->Faces.size(); at += 1u + hexahedron->Faces[at])
      {
        if (damage >= 230 && in.TakeBool())
        {
          continue;
        }
        const auto face = hexahedron->Faces.subspan(at + 1, hexahedron->Faces[at]);
        cells.Faces.push_back(static_cast<std::uint32_t>(face.size()));
        for (const auto corner : face)
        {
          cells.Faces.push_back(
            damage >= 245 ? in.TakeUpTo(points - 1) : cells.Corners[begin + corner]);
        }
      }
    }
    if (!cells.FaceStarts.empty())
    {
      cells.FaceStarts.push_back(static_cast<std::uint32_t>(cells.Faces.size()));
    }
    last = std::move(corners);
  }
  return cells;
}

ArrayFrame TakePointArray(Input& in, const SmallChunk& chunk)
{
  ArrayFrame array;
  const auto type = static_cast<ScalarType>(1 + in.TakeUpTo(9));
  array.Keys.resize(1 + in.TakeUpTo(2));
  const bool hasBefore = in.TakeBool();
  const auto vertices = chunk.Mesh.Keys.size();
  for (auto& component : array.Keys)
  {
    array.Domains.push_back(TakeValueDomain(in, type, hasBefore));
    component.Now.resize(vertices);
    for (const auto v : chunk.SharedIds)
    {
      component.Now[v] = TakeKey(in, array.Domains.back());
    }
    for (std::size_t v = 0; hasBefore && v < vertices; ++v)
    {
      component.Before.push_back(TakeKey(in, array.Domains.back()));
    }
  }
  return array;
}

ArrayFrame TakeCellArray(Input& in)
{
  ArrayFrame array;
  const auto type = static_cast<ScalarType>(1 + in.TakeUpTo(9));
  const auto tuples = in.TakeUpTo(MostTuples);
  if (in.TakeBool())
  {
    // As a walk leaves them: a tetrahedron before this one, or none.
    array.Parents.resize(tuples, Topology::NoTet);
    for (std::uint32_t t = 1; t < tuples; ++t)
    {
      const auto back = in.Take<std::uint8_t>();
      array.Parents[t] = back == 0 ? Topology::NoTet : t - std::min<std::uint32_t>(back, t);
    }
  }
  array.Keys.resize(1 + in.TakeUpTo(2));
  const bool hasBefore = in.TakeBool();
  for (auto& component : array.Keys)
  {
    array.Domains.push_back(TakeValueDomain(in, type, hasBefore));
    component.Now.resize(tuples);
    for (std::uint32_t t = 0; hasBefore && t < tuples; ++t)
    {
      component.Before.push_back(TakeKey(in, array.Domains.back()));
    }
  }
  return array;
}

void CheckKeys(const ArrayFrame& array)
{
  for (std::size_t c = 0; c < array.Keys.size(); ++c)
  {
    for (const auto key : array.Keys[c].Now)
    {
      Require(array.Domains[c].IsValid(key));
    }
  }
}

/** What arrays need: the gates of all vertices, or a record and a rule for each own one. */
void CheckPredictions(const ChunkMesh& mesh, std::size_t records, std::size_t own)
{
  const auto& gates = mesh.Walk.Gates;
  Require(mesh.Walk.HasTree() ? gates.size() == mesh.Keys.size()
                              : records == own && mesh.UsedRules.size() == own);
  for (std::uint32_t v = 1; v < gates.size(); ++v)
  {
    for (unsigned k = 0; k < 4; ++k)
    {
      Require(GetCorner(gates[v], k) < v);
    }
  }
}

namespace
{
/** Aborts unless each vertex is one of the chunk's, and every one is there. */
void CheckVertices(const ChunkFrame& frame, const ChunkMesh& mesh)
{
  const auto& walk = mesh.Walk;
  const auto vertices = frame.OwnPoints + frame.SharedKeys.size();
  std::vector<char> met(vertices, 0);
  for (Vertex v = 0; v < vertices; ++v)
  {
    const auto source = walk.Sources[v] & ~Topology::SharedFlag;
    const auto index = walk.IsShared(v) ? frame.OwnPoints + std::size_t{ source } : source;
    Require(index < vertices && !met[index]);
    met[index] = 1;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      Require(mesh.Domains[axis].IsValid(mesh.Keys[v][axis]));
    }
  }
}
}

void CheckCells(const ChunkFrame& frame, const ChunkMesh& mesh)
{
  const auto& walk = mesh.Walk;
  const auto& cells = mesh.Cells;
  const auto vertices = frame.OwnPoints + frame.SharedKeys.size();
  Require(cells.GetNumber() == frame.Cells.Cells && walk.Parents.size() == frame.Cells.Cells &&
    cells.Starts.size() == cells.GetNumber() + 1 && cells.Starts.back() == frame.Cells.Corners &&
    cells.Corners.size() == frame.Cells.Corners && cells.Faces.size() == frame.Cells.FaceValues &&
    walk.Sources.size() == vertices && mesh.Keys.size() == vertices);
  CheckPredictions(mesh, walk.CellRecords.size(), frame.OwnPoints);
  for (std::size_t c = 0; c < cells.GetNumber(); ++c)
  {
    Require(walk.Parents[c] == Topology::NoTet || walk.Parents[c] < c);
    Require(cells.Starts[c] <= cells.Starts[c + 1]);
    const auto faces = cells.GetFaces(c);
    for (std::size_t at = 0; at < faces.size(); at += 1 + faces[at])
    {
      Require(faces[at] < faces.size() - at);
      for (const auto v : faces.subspan(at + 1, faces[at]))
      {
        Require(v < vertices);
      }
    }
  }
  for (const auto v : cells.Corners)
  {
    Require(v < vertices);
  }
  CheckVertices(frame, mesh);
}

void CheckTets(const ChunkMesh& mesh)
{
  const auto tets = SplitCells(mesh);
  Require(tets.Tets.size() == tets.Cells.size());
  for (std::size_t t = 0; t < tets.Tets.size(); ++t)
  {
    Require(tets.Cells[t] < mesh.Cells.GetNumber());
    for (const auto v : tets.Tets[t])
    {
      Require(v < mesh.Keys.size());
    }
  }
}

void CheckChunk(const ChunkFrame& frame, const ChunkMesh& mesh)
{
  const auto& walk = mesh.Walk;
  const auto vertices = frame.OwnPoints + frame.SharedKeys.size();
  const auto tets = walk.CopyTets();
  Require(tets.size() == frame.Tets && walk.Parents.size() == frame.Tets &&
    walk.Sources.size() == vertices && mesh.Keys.size() == vertices);
  CheckPredictions(mesh, walk.Records.size(), frame.OwnPoints);
  for (std::size_t t = 0; t < tets.size(); ++t)
  {
    for (const auto v : tets[t])
    {
      Require(v < vertices);
    }
    Require(walk.Parents[t] == Topology::NoTet || walk.Parents[t] < t);
  }
  CheckVertices(frame, mesh);
}

ContextFits GetFits(const ChunkMesh& mesh)
{
  return mesh.Walk.HasTree() ? ContextFits::None : ContextFits::All;
}

SmallChunk::SmallChunk(Profile profile)
{
  // A fan of tetrahedra around an edge, with another one that has a part of its own.
  std::vector<Tet> tets;
  for (std::uint32_t i = 2; i < 12; ++i)
  {
    tets.push_back({ 0, 1, i, i + 1 });
    tets.push_back({ 1, i, i + 1, i + 11 });
  }
  tets.push_back({ 23, 24, 25, 26 });
  constexpr std::uint32_t shared = 5;
  constexpr std::uint32_t vertices = 27;
  ChunkFrame frame;
  frame.Tets = static_cast<std::uint32_t>(tets.size());
  frame.OwnPoints = vertices - shared;
  frame.Box = { Range{ 0, 30 }, Range{ 0, 30 }, Range{ 0, 30 } };
  std::vector<PointKeys> keys;
  const Domain domain(ScalarType::Float32);
  frame.Domains = { domain, domain, domain };
  for (std::uint32_t v = 0; v < vertices; ++v)
  {
    keys.push_back(
      { domain.FromNumber(v), domain.FromNumber(v * v % 31), domain.FromNumber(v * v * v % 29) });
  }
  frame.SharedKeys.assign(keys.begin(), keys.begin() + shared);
  frame.SharedUsers.assign(shared, 1);
  const std::vector<PointKeys> own(keys.begin() + shared, keys.end());
  this->Mesh = EncodeChunk(frame, tets, own, profile).Mesh;
  this->Context.emplace(this->Mesh, GetFits(this->Mesh));
  for (Vertex v = 0; v < vertices; ++v)
  {
    if (this->Mesh.Walk.IsShared(v))
    {
      this->SharedIds.push_back(v);
    }
  }
}
}
