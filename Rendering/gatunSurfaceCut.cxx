// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSurfaceCut.h"

#include "gatunParallel.h"

#include "vtkPolyData.h"

#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
SurfaceCut::SurfaceCut(
  std::shared_ptr<const SurfaceBase> base, MergeCut cut, const SurfaceCut* before)
  : Base(std::move(base))
  , Cut(std::move(cut))
  , Blocks(this->Base->GetNumberOfBlocks())
{
  const bool isKnown = before && before->Base == this->Base;
  std::vector<bool> isChanged;
  if (isKnown)
  {
    isChanged.resize(this->Cut.GetAncestors().size());
    for (const std::uint32_t point : FindChanges(before->Cut, this->Cut))
    {
      isChanged[point] = true;
    }
  }
  ParallelFor(this->Blocks.size(),
    [&](std::size_t i)
    {
      if (isKnown && !this->Base->Touches(i, isChanged))
      {
        this->Blocks[i] = before->Blocks[i];
        return;
      }
      auto block =
        std::make_shared<SurfaceBlock>(this->Base->Simplify(i, this->Cut.GetAncestors()));
      // Changes among triangles that vanish do not count.
      const bool isSame = isKnown && before->Blocks[i]->Cells == block->Cells &&
        before->Blocks[i]->Corners == block->Corners;
      this->Blocks[i] = isSame ? before->Blocks[i] : std::move(block);
    });
}

//------------------------------------------------------------------------------
SurfacePart SurfaceCut::Decode(
  std::uint32_t chunk, bool /*withIds*/, const Progress& /*progress*/) const
{
  SurfacePart part;
  try
  {
    part.Mesh = this->Base->MakeMesh(*this->Blocks[chunk]);
    part.Cone = FindNormalCone(part.Mesh);
  }
  catch (...)
  {
    part.Failure = std::current_exception();
  }
  return part;
}
}
