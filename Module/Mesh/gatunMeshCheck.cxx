// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunMeshCheck.h"

#include "gatunCellCodec.h"
#include "gatunCellShapes.h"
#include "gatunError.h"
#include "gatunParallel.h"

#include <string>

namespace gatun
{
namespace
{
constexpr std::uint64_t CellsPerTask = 1u << 16;

[[noreturn]] void ThrowCell(std::uint64_t cell, const std::string& what)
{
  ThrowInvalid("cell " + std::to_string(cell) + " " + what);
}

/** Checks one cell after the other. */
class CellChecker
{
public:
  explicit CellChecker(const MeshAccess& mesh)
    : Mesh(mesh)
    , Input(mesh.GetMesh())
  {
  }

  void Check(std::uint64_t cell) const
  {
    const std::uint64_t begin = this->Mesh.GetBegin(cell);
    const std::uint64_t end = this->Mesh.GetEnd(cell);
    if (begin > end)
    {
      ThrowCell(cell, "ends before it begins in the list of point ids");
    }
    std::uint64_t size = end - begin;
    if (size <= MaxChunkCorners)
    {
      for (std::uint64_t i = begin; i < end; ++i)
      {
        this->CheckPoint(cell, this->Mesh.GetId(i));
      }
      size += this->CheckFaces(cell);
    }
    if (size > MaxChunkCorners)
    {
      ThrowCell(cell, "has more than " + std::to_string(MaxChunkCorners) + " points");
    }
  }

private:
  void CheckPoint(std::uint64_t cell, std::uint64_t id) const
  {
    if (id >= this->Input.Points)
    {
      ThrowCell(cell,
        "uses point " + std::to_string(static_cast<std::int64_t>(id)) + ", but the mesh has only " +
          std::to_string(this->Input.Points) + " points");
    }
  }

  /** Checks the faces of a polyhedron. Returns the number of their values. */
  std::uint64_t CheckFaces(std::uint64_t cell) const
  {
    if (this->Mesh.GetType(cell) != PolyhedronType)
    {
      return 0;
    }
    if (!this->Input.FaceLocations || this->Input.FaceLocations[cell] < 0)
    {
      ThrowCell(cell, "is a polyhedron without faces");
    }
    auto at = static_cast<std::uint64_t>(this->Input.FaceLocations[cell]);
    const auto next = [&]
    {
      if (at >= this->Input.FacesSize)
      {
        ThrowCell(cell, "has faces beyond the end of the list of faces");
      }
      return this->Input.Faces[at++];
    };
    const auto faces = next();
    if (faces < 0)
    {
      ThrowCell(cell, "has " + std::to_string(faces) + " faces");
    }
    const std::uint64_t begin = at;
    for (std::int64_t face = 0; face < faces; ++face)
    {
      const auto points = next();
      if (points < 0)
      {
        ThrowCell(cell, "has a face of " + std::to_string(points) + " points");
      }
      for (std::int64_t i = 0; i < points; ++i)
      {
        this->CheckPoint(cell, static_cast<std::uint64_t>(next()));
      }
    }
    return at - begin;
  }

  const MeshAccess& Mesh;
  const MeshInput& Input;
};
}

//------------------------------------------------------------------------------
namespace
{
/** Whether tetrahedra have points that there are. Has no branch for each. */
bool AreRight(const MeshAccess& mesh, std::uint64_t begin, std::uint64_t end)
{
  const auto points = mesh.GetMesh().Points;
  bool areRight = true;
  for (auto i = 4 * begin; i < 4 * end; ++i)
  {
    areRight &= mesh.GetId(i) < points;
  }
  return areRight;
}
}

//------------------------------------------------------------------------------
void CheckCells(const MeshAccess& mesh)
{
  const MeshInput& input = mesh.GetMesh();
  constexpr std::uint64_t most = 0xfffffff0u;
  if (input.Points > most || input.Cells > most)
  {
    ThrowInvalid("a mesh of more than 2^32 points or cells is too large");
  }
  const CellChecker checker(mesh);
  ParallelFor(static_cast<std::size_t>((input.Cells + CellsPerTask - 1) / CellsPerTask),
    [&](std::size_t task)
    {
      const auto end = std::min<std::uint64_t>(input.Cells, (task + 1) * CellsPerTask);
      if (mesh.IsTetrahedral() && AreRight(mesh, task * CellsPerTask, end))
      {
        return;
      }
      for (std::uint64_t cell = task * CellsPerTask; cell < end; ++cell)
      {
        checker.Check(cell);
      }
    });
}

//------------------------------------------------------------------------------
void CheckCellSize(std::uint64_t cell, int type, std::uint64_t size)
{
  const CellKind kind = GetCellKind(type);
  const std::uint64_t least = kind.Points > 0 ? kind.Points : kind.Shape ? kind.Shape->Corners : 0;
  if (size < least || (kind.Points > 0 && size > least))
  {
    ThrowCell(cell,
      "(type " + std::to_string(type) + ", " + GetCellTypeName(type) + ") has " +
        std::to_string(size) + " points, not " + std::to_string(least) +
        (kind.Points > 0 ? "" : " or more"));
  }
}

//------------------------------------------------------------------------------
void CheckCellSizes(const MeshAccess& mesh)
{
  for (std::uint64_t cell = 0; !mesh.IsTetrahedral() && cell < mesh.GetMesh().Cells; ++cell)
  {
    CheckCellSize(cell, mesh.GetType(cell), mesh.GetEnd(cell) - mesh.GetBegin(cell));
  }
}
}
