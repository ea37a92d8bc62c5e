// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// TetGen 1.5 throws an integer when it fails, but frees memory twice during unwinding. It also has
// assertions, prints messages, and may not terminate. Therefore it runs in a child process.

#include "gatunTetGen.h"

#include "gatunChildProcess.h"

#include <tetgen.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <new>

namespace gatun
{
namespace
{

// tetgenio releases its members with delete[].
void FillInput(tetgenio& in, const TetGenSurface& surface, const TetGenHoles& holes)
{
  in.firstnumber = 0;
  in.pointlist = new double[surface.Points.size()];
  in.numberofpoints = static_cast<int>(surface.Points.size() / 3);
  std::copy(surface.Points.begin(), surface.Points.end(), in.pointlist);

  in.facetlist = new tetgenio::facet[surface.Triangles.size()];
  for (const auto& triangle : surface.Triangles)
  {
    tetgenio::facet& facet = in.facetlist[in.numberoffacets];
    tetgenio::init(&facet);
    ++in.numberoffacets;
    facet.polygonlist = new tetgenio::polygon[1];
    facet.numberofpolygons = 1;
    tetgenio::polygon& polygon = facet.polygonlist[0];
    tetgenio::init(&polygon);
    polygon.vertexlist = new int[3];
    polygon.numberofvertices = 3;
    std::copy(triangle.begin(), triangle.end(), polygon.vertexlist);
  }

  if (!holes.empty())
  {
    in.holelist = new double[3 * holes.size()];
    in.numberofholes = static_cast<int>(holes.size());
    double* target = in.holelist;
    for (const auto& hole : holes)
    {
      target = std::copy(hole.begin(), hole.end(), target);
    }
  }
}

TetGenMesh TakeOutput(const tetgenio& out)
{
  TetGenMesh mesh;
  mesh.Points.assign(out.pointlist, out.pointlist + 3 * std::size_t(out.numberofpoints));
  mesh.Tets.resize(out.numberoftetrahedra);
  for (std::size_t i = 0; i < mesh.Tets.size(); ++i)
  {
    const int* corners = out.tetrahedronlist + 4 * i;
    mesh.Tets[i] = { corners[0], corners[1], corners[2], corners[3] };
  }
  if (out.numberoftetrahedronattributes > 0)
  {
    const int stride = out.numberoftetrahedronattributes;
    mesh.Regions.resize(mesh.Tets.size());
    for (std::size_t i = 0; i < mesh.Tets.size(); ++i)
    {
      mesh.Regions[i] = static_cast<int>(out.tetrahedronattributelist[i * stride + stride - 1]);
    }
  }
  return mesh;
}

template <typename T>
void Append(Bytes& bytes, const std::vector<T>& values)
{
  const std::size_t count = values.size();
  const auto* size = reinterpret_cast<const unsigned char*>(&count);
  bytes.insert(bytes.end(), size, size + sizeof(count));
  const auto* first = reinterpret_cast<const unsigned char*>(values.data());
  bytes.insert(bytes.end(), first, first + count * sizeof(T));
}

template <typename T>
void Take(const unsigned char*& bytes, std::vector<T>& values)
{
  std::size_t count;
  std::memcpy(&count, bytes, sizeof(count));
  bytes += sizeof(count);
  values.resize(count);
  if (count > 0)
  {
    std::memcpy(values.data(), bytes, count * sizeof(T));
  }
  bytes += count * sizeof(T);
}

// Calls TetGen in a child process and passes its output to use.
Bytes CallTetGen(const TetGenSurface& surface, const TetGenHoles& holes, const TetGenRun& run,
  const std::function<void(const tetgenio&, Bytes&)>& use)
{
  Bytes bytes;
  const auto work = [&](Bytes& result)
  {
    tetgenio in;
    tetgenio out;
    FillInput(in, surface, holes);
    std::string modifiable = run.Switches;
    tetrahedralize(modifiable.data(), &in, &out);
    use(out, result);
  };
  switch (RunInChild(work, run.KeepGoing, run.Quiet, bytes))
  {
    case ChildOutcome::Stopped:
      throw TetGenStopped();
    case ChildOutcome::OutOfMemory:
      throw std::bad_alloc();
    case ChildOutcome::Crashed:
      bytes.clear();
      break;
    case ChildOutcome::Done:
      break;
  }
  return bytes;
}

// Determines why TetGen failed, as far as possible.
[[noreturn]] void ThrowReason(const TetGenSurface& surface, TetGenRun run)
{
  // With the switch d, TetGen only detects and returns intersecting faces.
  run.Switches = "pzdQ";
  const Bytes bytes = CallTetGen(surface, {}, run,
    [](const tetgenio& out, Bytes& result) { Append<int>(result, { out.numberoftrifaces }); });
  std::vector<int> faces;
  if (!bytes.empty())
  {
    const unsigned char* position = bytes.data();
    Take(position, faces);
  }
  if (!faces.empty() && faces[0] > 0)
  {
    throw TetGenError(
      "the surface cuts itself, at " + std::to_string(faces[0]) + " of its triangles");
  }
  throw TetGenError("TetGen failed on this surface; parts of it may nearly touch, or the switches "
                    "may be wrong");
}

using Point = std::array<double, 3>;

Point PointAt(const TetGenMesh& mesh, int id)
{
  const double* p = mesh.Points.data() + 3 * std::size_t(id);
  return { p[0], p[1], p[2] };
}

double Volume(const TetGenMesh& mesh, const std::array<int, 4>& tet)
{
  const Point o = PointAt(mesh, tet[0]);
  double e[3][3];
  for (int i = 0; i < 3; ++i)
  {
    const Point p = PointAt(mesh, tet[i + 1]);
    for (int j = 0; j < 3; ++j)
    {
      e[i][j] = p[j] - o[j];
    }
  }
  return std::abs(e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
    e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
    e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]));
}

// Counts the surface components between the outside and each region. A region is solid if the count
// is odd.
std::map<int, int> DepthOfRegions(const TetGenMesh& mesh)
{
  constexpr int outside = -1;
  std::map<std::array<int, 3>, int> open; // faces seen once so far, and the region seen there
  std::map<int, std::vector<int>> neighbors;
  const auto connect = [&neighbors](int a, int b)
  {
    auto& list = neighbors[a];
    if (std::find(list.begin(), list.end(), b) == list.end())
    {
      list.push_back(b);
      neighbors[b].push_back(a);
    }
  };
  for (std::size_t i = 0; i < mesh.Tets.size(); ++i)
  {
    for (int skip = 0; skip < 4; ++skip)
    {
      std::array<int, 3> face;
      for (int j = 0, k = 0; j < 4; ++j)
      {
        if (j != skip)
        {
          face[k++] = mesh.Tets[i][j];
        }
      }
      std::sort(face.begin(), face.end());
      const auto [entry, isNew] = open.try_emplace(face, mesh.Regions[i]);
      if (!isNew)
      {
        if (entry->second != mesh.Regions[i])
        {
          connect(entry->second, mesh.Regions[i]);
        }
        open.erase(entry);
      }
    }
  }
  for (const auto& [face, region] : open)
  {
    connect(outside, region);
  }

  std::map<int, int> depth{ { outside, 0 } };
  std::vector<int> queue{ outside };
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    for (const int neighbor : neighbors[queue[i]])
    {
      if (depth.try_emplace(neighbor, depth[queue[i]] + 1).second)
      {
        queue.push_back(neighbor);
      }
    }
  }
  depth.erase(outside);
  return depth;
}

} // anonymous namespace

//------------------------------------------------------------------------------
TetGenMesh RunTetGen(const TetGenSurface& surface, const TetGenHoles& holes, const TetGenRun& run)
{
  const Bytes bytes = CallTetGen(surface, holes, run,
    [](const tetgenio& out, Bytes& result)
    {
      const TetGenMesh mesh = TakeOutput(out);
      Append(result, mesh.Points);
      Append(result, mesh.Tets);
      Append(result, mesh.Regions);
    });
  if (bytes.empty())
  {
    ThrowReason(surface, run);
  }
  TetGenMesh mesh;
  const unsigned char* position = bytes.data();
  Take(position, mesh.Points);
  Take(position, mesh.Tets);
  Take(position, mesh.Regions);
  return mesh;
}

//------------------------------------------------------------------------------
TetGenHoles FindCavities(const TetGenSurface& surface, TetGenRun run)
{
  // This is fast without quality bounds; the switch A labels the regions.
  run.Switches = run.Quiet ? "pzAQ" : "pzA";
  const TetGenMesh mesh = RunTetGen(surface, {}, run);
  struct Largest
  {
    double Volume = -1;
    std::size_t Tet = 0;
  };
  std::map<int, Largest> cavities;
  for (const auto& [region, depth] : DepthOfRegions(mesh))
  {
    if (depth % 2 == 0)
    {
      cavities[region] = {};
    }
  }
  for (std::size_t i = 0; i < mesh.Tets.size(); ++i)
  {
    const auto cavity = cavities.find(mesh.Regions[i]);
    if (cavity != cavities.end())
    {
      const double volume = Volume(mesh, mesh.Tets[i]);
      if (volume > cavity->second.Volume)
      {
        cavity->second = { volume, i };
      }
    }
  }

  TetGenHoles holes;
  for (const auto& [region, largest] : cavities)
  {
    Point center{};
    for (const int id : mesh.Tets[largest.Tet])
    {
      const Point p = PointAt(mesh, id);
      for (int j = 0; j < 3; ++j)
      {
        center[j] += p[j] / 4;
      }
    }
    holes.push_back(center);
  }
  return holes;
}
}
