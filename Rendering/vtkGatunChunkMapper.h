// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef vtkGatunChunkMapper_h
#define vtkGatunChunkMapper_h

#include "gatunTypes.h"

#include "vtkOpenGLPolyDataMapper.h"

#include "vtkSmartPointer.h"

#include <cstdint>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkDataArray;

/**
 * Draws a chunk of a surface for vtkGatunSurfaceMapper. Once the buffers of the graphics are made,
 * the mesh can be freed.
 */
class vtkGatunChunkMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkGatunChunkMapper* New();
  vtkTypeMacro(vtkGatunChunkMapper, vtkOpenGLPolyDataMapper);

  /** Takes what a user can set of the mapper of the whole surface, except its input. */
  void CopySettings(vtkOpenGLPolyDataMapper* whole);

  /** The array that gives colors; null for none. Must be called after CopySettings, which resets
   * it. */
  void SelectScalars(const char* name);

  /** Places coordinates in buffers as VTK does for the whole surface, so that points that chunks
   * share are at one place. */
  void SetWholeBounds(const gatun::Bounds& box);

  /** Whether an image needs the mesh, as it was freed and the buffers do not fit the image. */
  bool NeedsMesh(vtkRenderer* renderer, vtkActor* actor);

  /** Makes the buffers without drawing, where an image would make them. */
  void Transfer(vtkRenderer* renderer, vtkActor* actor);

  /** Frees the mesh; the buffers stay. */
  void FreeMesh();
  bool HasMesh() const { return !this->IsFreed; }

  /** Whether the mesh has the numbers of points and cells within the surface. */
  void SetHasIds(bool has) { this->HasIds = has; }

  /** The number by which a selection tells chunks from each other, from 1. */
  void SetNumber(unsigned number) { this->Number = number; }

  /** Bytes of the mesh, if it is there, and of the buffers. */
  std::uint64_t GetBytes();

  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGatunChunkMapper();
  ~vtkGatunChunkMapper() override;

  bool GetNeedToRebuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;

private:
  vtkGatunChunkMapper(const vtkGatunChunkMapper&) = delete;
  void operator=(const vtkGatunChunkMapper&) = delete;

  std::vector<vtkSmartPointer<vtkDataArray>> Arrays; // of the mesh that was freed, empty
  double Shift[3] = { 0, 0, 0 };
  double Scale[3] = { 1, 1, 1 };
  unsigned Number = 1;
  bool IsShifted = false;
  bool IsFreed = false;
  bool IsReleased = false;
  bool IsTransferring = false;
  bool HasIds = false;
  vtkTimeStamp CopyTime;
  vtkTimeStamp FreeTime;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
// VTK-HeaderTest-Exclude: vtkGatunChunkMapper.h
