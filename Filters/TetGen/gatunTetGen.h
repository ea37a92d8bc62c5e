// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunTetGen_h
#define gatunTetGen_h

// TetGen's tetrahedralize(), in the program gatun-tetgen, with vectors and exceptions.

#include <array>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace gatun
{
/** The reason why TetGen failed. what() is a sentence without a period. */
class TetGenError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** Thrown after KeepGoing returned false. */
struct TetGenStopped
{
};

struct TetGenSurface
{
  std::vector<double> Points;                ///< x, y, z of each point
  std::vector<std::array<int, 3>> Triangles; ///< closed and manifold
};

struct TetGenMesh
{
  std::vector<double> Points; ///< those of the surface come first
  std::vector<std::array<int, 4>> Tets;
  std::vector<int> Regions; ///< one for each tetrahedron, if the switches contain A
};

/** One point strictly inside each cavity. */
using TetGenHoles = std::vector<std::array<double, 3>>;

/** How to run TetGen. */
struct TetGenRun
{
  std::string Switches; ///< must contain p and z
  bool Quiet = true;
  std::function<bool()> KeepGoing; ///< polled while TetGen runs; returns false to stop it
};

/** Runs TetGen on a surface. Throws TetGenError, also if the program cannot be started,
 * TetGenStopped and std::bad_alloc. */
TetGenMesh RunTetGen(const TetGenSurface& surface, const TetGenHoles& holes, const TetGenRun& run);

/** Finds the cavities of a surface with several components and returns a point inside each. Regions
 * alternate with nesting depth: the outermost component bounds a solid, a component inside it
 * bounds a cavity, and so on. The switches of the run are ignored. Throws like RunTetGen. */
TetGenHoles FindCavities(const TetGenSurface& surface, TetGenRun run);
}

#endif
