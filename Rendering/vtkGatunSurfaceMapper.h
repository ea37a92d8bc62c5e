// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunSurfaceMapper
 * @brief Draws a surface, from memory or chunk by chunk from its file.
 *
 * Use it in place of vtkPolyDataMapper. There are two modes:
 *
 *  - *The input is a vtkGatunSurfaceReader whose output is an outline*
 * (vtkGatunMeshReader::OnDemand). The mapper finds a vtkGatunFileHandle in the information of its
 * input and draws the file. It shares the open file of the reader and its settings: selected
 * arrays, and the time that the pipeline asks for.
 *  - *Otherwise* it is a vtkOpenGLPolyDataMapper.
 *
 * *Drawing a file.* Each chunk of the file has vertex and index buffers of its own. Chunks are
 * drawn from front to back, or from back to front if the actor is translucent. Those that are
 * outside of the view are not read. Missing chunks are decoded by all threads, a few at a time, and
 * drawn as soon as they are there. Only the coordinates, normals, and the array that is drawn are
 * decoded, and texture coordinates where there is a texture. If the actor's property culls back or
 * front faces, chunks of triangles that are all culled are skipped; this is known of chunks that
 * were decoded before. Buffers are kept up to MemoryBudget. Chunks beyond it are decoded again for
 * each image. Most buffers are kept without their meshes, so that a change of the mapper, the actor
 * or its property decodes chunks again.
 *
 * *Just in time.* If JustInTime of the DetailPolicy is on, an image during an interaction takes
 * about the time allowed for it: the mapper draws the finest base mesh of the file that fits, or
 * the surface itself. This needs a file with a hierarchy (vtkGatunWriter::Hierarchy); without base
 * meshes (vtkGatunWriter::Levels), halves, quarters and so on of the points are made by merges,
 * which takes longer. A thread decodes the chunks of the level that the time allows, in the
 * background. Until they are there, and transferred to the graphics in the time that images leave,
 * the finest coarser level that is ready is drawn. The image at rest, for which more than 10
 * seconds are allocated, shows the whole surface and is the same as without JustInTime.
 *
 * *View-dependent.* With ViewDependent, the default, the surface is then simplified as far as the
 * view allows, with as many points as the time does: fine where the eye is near and at the
 * silhouette, and coarse elsewhere. The base mesh with about eight times these points is kept in
 * memory, which takes up to half of MemoryBudget in addition to it. A thread chooses the points
 * while the camera moves; only chunks that change are transferred again, and they appear together.
 * While the camera moves, the surface may lag by a few frames. PixelError sets an error instead of
 * a time.
 *
 * *Appearance.* The pixels are those that vtkPolyDataMapper draws of the reader's output, with
 * lighting, color maps, textures, clipping planes, and all representations. Translucent surfaces
 * without depth peeling are an exception, because their image depends on the order of cells. Vertex
 * attributes (MapDataArrayToVertexAttribute) are not supported with files.
 *
 * *Selection.* vtkHardwareSelector gives the ids of points and cells that the reader's output has
 * without OnDemand. If a file holds cells of several lists (vertices, lines, polygons, strips) and
 * does not keep the order of cells, cells are counted in the order of the file. A selection keeps
 * the meshes of all visible chunks until the next image, in addition to MemoryBudget. Pickers that
 * intersect a ray with the input of the mapper, such as vtkCellPicker, find only the outline.
 *
 * *Several processes or pieces.* As with the reader, piece i of n has the i-th part of the chunks.
 * With JustInTime, mappers of all pieces have to draw the same level of detail, or pieces would not
 * fit together: see ProposeLevels.
 *
 * *Errors.* A chunk that cannot be decoded is reported by vtkErrorMacro, once for each cause until
 * an image succeeds, and by GetErrorCode (see vtkGatunMeshReader). The other chunks are drawn.
 * vtkRenderWindow::SetAbortRender ends an image, as in an observer of vtkCommand::AbortCheckEvent;
 * what was drawn before remains. vtkCommand::ProgressEvent reports the progress while chunks are
 * decoded.
 *
 * @sa vtkGatunDetailPolicy vtkGatunSurfaceReader vtkGatunFileHandle vtkPolyDataMapper
 */

#ifndef vtkGatunSurfaceMapper_h
#define vtkGatunSurfaceMapper_h

#include "vtkGatunRenderingModule.h" // For export macro
#include "vtkOpenGLPolyDataMapper.h"

#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkGatunDetailPolicy;
class vtkTable;

class VTKGATUNRENDERING_EXPORT vtkGatunSurfaceMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkGatunSurfaceMapper* New();
  vtkTypeMacro(vtkGatunSurfaceMapper, vtkOpenGLPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Memory for the buffers of chunks, in MiB, 0 or more. Meshes that are kept for changes take up
   * to a quarter of it. A change does not modify the mapper; it takes effect with the next image.
   * Default: 512.
   */
  void SetMemoryBudget(int mebibytes);
  vtkGetMacro(MemoryBudget, int);
  ///@}

  ///@{
  /**
   * How far surfaces of files are simplified; see above. Null sets a new policy, which draws the
   * whole surface. If the reader simplifies the surface, too, the policy counts where it removes
   * more. After a change of the ratio only those chunks are decoded and transferred again that
   * change, unless another base mesh is used. If the base mesh that a PixelError needs does not fit
   * into half of MemoryBudget, all of the surface is drawn. The policy and its changes do not
   * modify the mapper, as buffers would be made again; they take effect with the next image.
   */
  void SetDetailPolicy(vtkGatunDetailPolicy* policy);
  vtkGatunDetailPolicy* GetDetailPolicy();
  ///@}

  ///@{
  /**
   * For several processes that draw pieces of a surface: the levels of detail of the next image in
   * motion. Before each image, each process proposes the level that it would choose, and the one
   * that it could draw at once, both -1 for an image at rest or an input that is not a file. The
   * largest of all proposals is then set in all processes. ViewDependent has no influence on images
   * with levels that were set. ResetLevels makes the mapper choose by itself again, which is the
   * default.
   */
  void ProposeLevels(vtkRenderer* renderer, vtkActor* actor, int levels[2]);
  void SetLevels(const int levels[2]);
  void ResetLevels();
  ///@}

  /**
   * Waits until the background thread has decoded what was requested for the next images. Only for
   * measurements and tests.
   */
  void WaitForPreparation();

  /**
   * Whether the last image was drawn from a file.
   */
  bool GetIsDrawingFile();

  /**
   * Statistics in the columns of a table of one row. With translucency, each pass over the geometry
   * counts as an image.
   *
   *  - DrawnPoints: points of the surface in the last image; 0 if it was not simplified.
   *  - DrawnChunks: chunks drawn in the last image; 0 without a file.
   *  - CulledChunks: chunks in the view that the last image skipped, as all their triangles are
   *    culled.
   *  - DecodedChunks: chunks that were decoded for this mapper since it exists.
   *  - BufferBytes: bytes that are kept for chunks now, estimated from the sizes of buffers and
   *    arrays. Not more than MemoryBudget after an image, except for a selection.
   *
   * The next call returns another table.
   */
  vtkTable* GetStatistics();

  ///@{
  /**
   * Bounds of the whole surface, from the tables of the file if a file is drawn.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  ///@}

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   * DO NOT USE THIS METHOD OUTSIDE OF THE RENDERING PROCESS
   */
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   */
  void ProcessSelectorPixelBuffers(
    vtkHardwareSelector* selector, std::vector<unsigned int>& pixels, vtkProp* prop) override;

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGatunSurfaceMapper();
  ~vtkGatunSurfaceMapper() override;

  int MemoryBudget = 512;

private:
  vtkGatunSurfaceMapper(const vtkGatunSurfaceMapper&) = delete;
  void operator=(const vtkGatunSurfaceMapper&) = delete;

  void Fail() noexcept;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
