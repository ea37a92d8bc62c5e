// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunChunkMapper.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectCache.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunChunkMapper);

namespace
{
// Of the buffers that VTK makes of points.
constexpr const char* BufferNames[] = { "vertexMC", "normalMC", "tcoord", "scalarColor",
  "colorTCoord" };
}

vtkGatunChunkMapper::vtkGatunChunkMapper()
{
  this->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
}

vtkGatunChunkMapper::~vtkGatunChunkMapper() = default;

//------------------------------------------------------------------------------
void vtkGatunChunkMapper::CopySettings(vtkOpenGLPolyDataMapper* whole)
{
  if (this->CopyTime > whole->GetMTime())
  {
    return;
  }
  // Not that of vtkPolyDataMapper, which copies the input, too.
  this->vtkMapper::ShallowCopy(whole); // NOLINT(bugprone-parent-virtual-call)
  this->SetFieldDataTupleId(whole->GetFieldDataTupleId());
  this->SetSeamlessU(whole->GetSeamlessU());
  this->SetSeamlessV(whole->GetSeamlessV());
  double factor = 0;
  double units = 0;
  whole->GetRelativeCoincidentTopologyPolygonOffsetParameters(factor, units);
  this->SetRelativeCoincidentTopologyPolygonOffsetParameters(factor, units);
  whole->GetRelativeCoincidentTopologyLineOffsetParameters(factor, units);
  this->SetRelativeCoincidentTopologyLineOffsetParameters(factor, units);
  whole->GetRelativeCoincidentTopologyPointOffsetParameter(units);
  this->SetRelativeCoincidentTopologyPointOffsetParameter(units);
  this->SetPopulateSelectionSettings(whole->GetPopulateSelectionSettings());
  this->SetPointIdArrayName("GlobalPointIds");
  this->SetCellIdArrayName("GlobalCellIds");
  this->CopyTime.Modified();
}

//------------------------------------------------------------------------------
void vtkGatunChunkMapper::SelectScalars(const char* name)
{
  if (name && this->ArrayAccessMode == VTK_GET_ARRAY_BY_ID)
  {
    // A chunk has only the arrays that are drawn.
    this->SetArrayAccessMode(VTK_GET_ARRAY_BY_NAME);
    this->SetArrayName(name);
  }
}

//------------------------------------------------------------------------------
void vtkGatunChunkMapper::SetWholeBounds(const gatun::Bounds& box)
{
  // The rule of VTK, for the whole surface: coordinates are moved to the unit cube if the surface
  // is far from the origin, or very large or small.
  double size = 0;
  double distance = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const gatun::Range& range = box[static_cast<std::size_t>(axis)];
    const double length = range.Max - range.Min;
    this->Shift[axis] = 0.5 * (range.Max + range.Min);
    this->Scale[axis] = length > 0 ? 1 / length : 1;
    size += length * length;
    distance += this->Shift[axis] * this->Shift[axis];
  }
  this->IsShifted =
    size > 0 ? distance / size > 1e6 || std::abs(std::log10(size)) > 3 : distance > 1e6;
  this->SetVBOShiftScaleMethod(this->IsShifted ? vtkOpenGLVertexBufferObject::MANUAL_SHIFT_SCALE
                                               : vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
}

//------------------------------------------------------------------------------
bool vtkGatunChunkMapper::NeedsMesh(vtkRenderer* renderer, vtkActor* actor)
{
  if (renderer->GetSelector() && !this->HasIds)
  {
    return true;
  }
  if (!this->IsFreed)
  {
    return false;
  }
  this->CurrentInput = this->GetInput();
  // A new place of the actor needs none.
  vtkMTimeType changed = std::max(this->GetMTime(), actor->GetProperty()->GetMTime());
  for (vtkObject* const part :
    std::initializer_list<vtkObject*>{ actor->GetBackfaceProperty(), actor->GetTexture() })
  {
    changed = std::max(changed, part ? part->GetMTime() : 0);
  }
  return this->IsReleased || renderer->GetSelector() || this->FreeTime < changed ||
    this->Superclass::GetNeedToRebuildBufferObjects(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkGatunChunkMapper::Transfer(vtkRenderer* renderer, vtkActor* actor)
{
  this->IsTransferring = true;
  this->RenderPiece(renderer, actor);
  this->IsTransferring = false;
}

//------------------------------------------------------------------------------
void vtkGatunChunkMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->IsTransferring)
  {
    this->Superclass::RenderPieceDraw(renderer, actor);
  }
}

//------------------------------------------------------------------------------
void vtkGatunChunkMapper::FreeMesh()
{
  // VTK finds buffers by the addresses of arrays, which therefore must not be given to others.
  vtkPolyData* const mesh = this->GetInput();
  this->Arrays.push_back(mesh->GetPoints()->GetData());
  for (int i = 0; i < mesh->GetPointData()->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* const array = mesh->GetPointData()->GetArray(i))
    {
      this->Arrays.push_back(array);
    }
  }
  for (const auto& array : this->Arrays)
  {
    array->Initialize();
  }
  for (const char* name : BufferNames)
  {
    if (auto* const buffer = this->VBOs->GetVBO(name))
    {
      // What was copied to the graphics.
      std::vector<float>().swap(buffer->GetPackedVBO());
    }
  }
  // VTK draws nothing without points.
  vtkNew<vtkPolyData> freed;
  vtkNew<vtkPoints> points;
  freed->SetPoints(points);
  this->SetInputData(freed);
  this->IsFreed = true;
  this->HasIds = false;
  this->VBOBuildTime.Modified();
  this->FreeTime.Modified();
}

//------------------------------------------------------------------------------
std::uint64_t vtkGatunChunkMapper::GetBytes()
{
  std::uint64_t bytes = 0;
  vtkPolyData* const mesh = this->GetInput();
  if (mesh && !this->IsFreed)
  {
    bytes += std::uint64_t{ 1024 } * mesh->GetActualMemorySize();
  }
  for (const char* name : BufferNames)
  {
    if (auto* const buffer = this->VBOs->GetVBO(name))
    {
      bytes += sizeof(float) * static_cast<std::uint64_t>(buffer->GetStride()) / sizeof(float) *
        static_cast<std::uint64_t>(buffer->GetNumberOfTuples());
    }
  }
  for (auto& primitive : this->Primitives)
  {
    bytes += sizeof(unsigned) * static_cast<std::uint64_t>(primitive.IBO->IndexCount);
  }
  const auto triangles =
    static_cast<std::uint64_t>(this->Primitives[PrimitiveTris].IBO->IndexCount / 3);
  if (this->HaveCellScalars || this->HaveCellNormals)
  {
    // Colors, normals, and VTK's map from triangles to cells.
    bytes += triangles *
      (sizeof(vtkIdType) + (this->HaveCellScalars ? 4 : 0) + (this->HaveCellNormals ? 16 : 0));
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkGatunChunkMapper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::RenderPieceStart(renderer, actor);
  if (vtkHardwareSelector* const selector = renderer->GetSelector())
  {
    // In place of the 1 of the superclass.
    selector->RenderCompositeIndex(this->Number);
  }
}

//------------------------------------------------------------------------------
void vtkGatunChunkMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->IsReleased = true;
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
bool vtkGatunChunkMapper::GetNeedToRebuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  return !this->IsFreed && this->Superclass::GetNeedToRebuildBufferObjects(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkGatunChunkMapper::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  vtkPolyData* const mesh = this->CurrentInput;
  if (this->IsShifted && mesh && mesh->GetPoints())
  {
    this->VBOs->CacheDataArray("vertexMC", mesh->GetPoints()->GetData(), renderer, VTK_FLOAT);
    if (auto* const buffer = this->VBOs->GetVBO("vertexMC"))
    {
      buffer->SetCoordShiftAndScaleMethod(vtkOpenGLVertexBufferObject::MANUAL_SHIFT_SCALE);
      buffer->SetShift(this->Shift[0], this->Shift[1], this->Shift[2]);
      buffer->SetScale(this->Scale[0], this->Scale[1], this->Scale[2]);
    }
  }
  this->Superclass::BuildBufferObjects(renderer, actor);
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
