// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunTetGen_h
#define gatunTetGen_h

// TetGen's tetrahedralize() on vectors, without its types and its ways to fail.

#include <array>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace gatun
{
/** Why TetGen gave up; what() is a sentence without a full stop. */
class TetGenError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** KeepGoing returned false. */
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
  std::vector<int> Regions; ///< one a tetrahedron, if the switches have A
};

/** A point strictly inside each part of space to be left empty. */
using TetGenHoles = std::vector<std::array<double, 3>>;

/** How to run TetGen. */
struct TetGenRun
{
  std::string Switches; ///< to which p and z belong
  bool Quiet = true;
  std::function<bool()> KeepGoing; ///< called now and then; false ends it all
};

/** Runs TetGen on a surface. Throws TetGenError, TetGenStopped and std::bad_alloc. Not safe to call
 * from two threads at once. */
TetGenMesh RunTetGen(const TetGenSurface& surface, const TetGenHoles& holes, const TetGenRun& run);

/** Finds the cavities of a surface of several components: a point inside each. Coming from
 * outside, one is in a solid behind the first component, in a cavity behind the second, and so on.
 * The switches of the run are not used. Throws like RunTetGen. */
TetGenHoles FindCavities(const TetGenSurface& surface, TetGenRun run);
}

#endif
