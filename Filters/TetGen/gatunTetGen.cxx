// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// TetGen may crash or never return. It is in a program of its own.

#include "gatunTetGen.h"

#include "gatunChildProcess.h"
#include "gatunTetGenStream.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <new>
#include <system_error>

namespace gatun
{
namespace
{
// Runs the program gatun-tetgen. Returns its answer, or nothing if TetGen failed.
Bytes CallTetGen(
  const TetGenSurface& surface, const TetGenHoles& holes, const TetGenRun& run, TetGenTask task)
{
  Bytes input;
  Append<TetGenTask>(input, { task });
  Append(input, std::vector<char>(run.Switches.begin(), run.Switches.end()));
  Append(input, surface.Points);
  Append(input, surface.Triangles);
  Append(input, holes);
  Bytes bytes;
  ChildOutcome outcome = ChildOutcome::Crashed;
  std::string program = "gatun-tetgen";
  try
  {
    program = FindProgram("gatun-tetgen");
    outcome = RunProgram(program, input, run.KeepGoing, run.Quiet, bytes);
  }
  catch (const std::system_error& error)
  {
    throw TetGenError("the program " + program + " cannot be started: " + error.code().message());
  }
  switch (outcome)
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
  const Bytes bytes = CallTetGen(surface, {}, run, TetGenTask::CountFaces);
  std::vector<int> faces;
  if (!bytes.empty())
  {
    std::size_t position = 0;
    Take(bytes, position, faces);
  }
  if (!faces.empty() && faces[0] != 0)
  {
    throw TetGenError("the surface cuts itself" +
      (faces[0] > 0 ? ", at " + std::to_string(faces[0]) + " of its triangles" : ""));
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
  const Bytes bytes = CallTetGen(surface, holes, run, TetGenTask::Mesh);
  if (bytes.empty())
  {
    ThrowReason(surface, run);
  }
  TetGenMesh mesh;
  std::size_t position = 0;
  Take(bytes, position, mesh.Points);
  Take(bytes, position, mesh.Tets);
  Take(bytes, position, mesh.Regions);
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
