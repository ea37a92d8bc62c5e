// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// The program gatun-tetgen, which vtkGatunTetrahedralize starts: runs TetGen on what comes from the
// socket that is its standard input, and answers there. TetGen's messages go to standard output.
// TetGen 1.5 throws an integer when it fails, but frees memory twice during unwinding. It also has
// assertions, and may not terminate.

#include "gatunTetGenStream.h"

#include <tetgen.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <limits>
#include <new>
#include <string>

namespace
{
using gatun::Bytes;

Bytes ReadInput()
{
  constexpr std::size_t step = std::size_t(1) << 20;
  Bytes bytes;
  for (;;)
  {
    const std::size_t size = bytes.size();
    bytes.resize(size + step);
    const ssize_t count = read(STDIN_FILENO, bytes.data() + size, step);
    bytes.resize(size + (count > 0 ? count : 0));
    if (count == 0)
    {
      return bytes;
    }
    if (count < 0 && errno != EINTR)
    {
      throw std::runtime_error("cannot read");
    }
  }
}

void WriteOutput(const Bytes& bytes)
{
  for (std::size_t done = 0; done < bytes.size();)
  {
    const ssize_t count = write(STDIN_FILENO, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno != EINTR)
    {
      throw std::runtime_error("cannot write");
    }
    done += count > 0 ? count : 0;
  }
}

// tetgenio releases its members with delete[].
void FillInput(tetgenio& in, const std::vector<double>& points,
  const std::vector<std::array<int, 3>>& triangles, const std::vector<std::array<double, 3>>& holes)
{
  if (points.size() / 3 > std::size_t(std::numeric_limits<int>::max()))
  {
    throw std::runtime_error("too many points");
  }
  in.firstnumber = 0;
  in.pointlist = new double[points.size()];
  in.numberofpoints = static_cast<int>(points.size() / 3);
  std::copy(points.begin(), points.end(), in.pointlist);

  in.facetlist = new tetgenio::facet[triangles.size()];
  for (const auto& triangle : triangles)
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

void AppendMesh(const tetgenio& out, Bytes& bytes)
{
  gatun::Append(
    bytes, std::vector<double>(out.pointlist, out.pointlist + 3 * std::size_t(out.numberofpoints)));
  std::vector<std::array<int, 4>> tets(out.numberoftetrahedra);
  for (std::size_t i = 0; i < tets.size(); ++i)
  {
    const int* corners = out.tetrahedronlist + 4 * i;
    tets[i] = { corners[0], corners[1], corners[2], corners[3] };
  }
  gatun::Append(bytes, tets);
  std::vector<int> regions;
  if (out.numberoftetrahedronattributes > 0)
  {
    const int stride = out.numberoftetrahedronattributes;
    regions.resize(tets.size());
    for (std::size_t i = 0; i < regions.size(); ++i)
    {
      regions[i] = static_cast<int>(out.tetrahedronattributelist[i * stride + stride - 1]);
    }
  }
  gatun::Append(bytes, regions);
}

// The number of faces that cut each other, or -1 if TetGen does not tell: 1.6 only throws.
int CountFaces(std::string& switches, tetgenio& in, tetgenio& out)
{
  constexpr int cuts = 3;
  try
  {
    tetrahedralize(switches.data(), &in, &out);
  }
  catch (int code)
  {
    return code == cuts ? -1 : 0;
  }
  return out.numberoftrifaces;
}

void Run()
{
  std::vector<gatun::TetGenTask> task;
  std::vector<char> switches;
  std::vector<double> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::array<double, 3>> holes;
  {
    const Bytes input = ReadInput();
    std::size_t position = 0;
    gatun::Take(input, position, task);
    gatun::Take(input, position, switches);
    gatun::Take(input, position, points);
    gatun::Take(input, position, triangles);
    gatun::Take(input, position, holes);
  }
  tetgenio in;
  tetgenio out;
  FillInput(in, points, triangles, holes);
  std::string text(switches.begin(), switches.end());
  Bytes output;
  if (!task.empty() && task[0] == gatun::TetGenTask::CountFaces)
  {
    gatun::Append<int>(output, { CountFaces(text, in, out) });
  }
  else
  {
    tetrahedralize(text.data(), &in, &out);
    AppendMesh(out, output);
  }
  WriteOutput(output);
}
} // anonymous namespace

int main()
{
  // Without destructors, which crash after some failures.
  try
  {
    Run();
    std::fflush(stdout);
    _exit(gatun::TetGenDone);
  }
  catch (const std::bad_alloc&)
  {
    _exit(gatun::TetGenNoMemory);
  }
  catch (...)
  {
    _exit(gatun::TetGenFailed);
  }
}
