// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellSplitter_h
#define gatunCellSplitter_h

#include "gatunCellShapes.h"
#include "gatunPointSet.h"
#include "gatunSimplices.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace gatun
{
/** Splits cells of any VTK type into tetrahedra, one after the other: see SplitCell. */
template <typename Id, typename IsLess>
class CellSplitter
{
public:
  explicit CellSplitter(IsLess isLess)
    : Less(isLess)
  {
  }

  /**
   * Calls use with the corners of each tetrahedron of a cell. Nonlinear cells are taken for linear
   * ones, and convex point sets for their hull (see FindHullFaces). Tetrahedra do not change. Cells
   * of a lower dimension, of a wrong size and of unknown types have no tetrahedra.
   *
   * faces: of a polyhedron, for each face the number of its points and their ids.
   */
  template <typename FaceId, typename Use>
  void Split(int type, std::span<const Id> corners, std::span<const FaceId> faces, Use&& use)
  {
    const CellKind kind = GetCellKind(type);
    if (kind.Shape && corners.size() >= kind.Shape->Corners)
    {
      if (kind.Shape->Corners == 4)
      {
        use(std::array<Id, 4>{ corners[0], corners[1], corners[2], corners[3] });
        return;
      }
      this->Faces.Set(*kind.Shape, corners.data());
    }
    else if (type == PolyhedronType)
    {
      this->Faces.Clear();
      for (std::size_t at = 0; at < faces.size();)
      {
        const auto size = static_cast<std::size_t>(faces[at]);
        this->Faces.Add(faces.subspan(at + 1, size), [](FaceId id) { return static_cast<Id>(id); });
        at += 1 + size;
      }
      this->Faces.Align();
    }
    else if (type == ConvexPointSetType)
    {
      SetHullFaces(this->Faces, corners, this->Less);
    }
    else
    {
      return;
    }
    SplitCell(this->Faces, this->Less, this->Space, use);
  }

private:
  IsLess Less;
  CellFaces<Id> Faces;
  SplitSpace<Id> Space;
};
}

#endif
