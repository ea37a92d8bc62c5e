// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunVolumeMapper
 * @brief Draws a tetrahedral mesh as a volume, from memory, from its file or piece by piece.
 *
 * Use it in place of vtkUnstructuredGridVolumeRayCastMapper. It draws the image that
 * vtkGatunRayCaster computes without a window; see there for the method. In addition, the camera's
 * clipping range cuts the volume, and opaque geometry in the same renderer ends the rays. Opacities
 * refer to the property's unit distance, as in VTK's mappers for images. VTK's mappers for
 * unstructured grids take them as densities, so that their images are more transparent.
 *
 * The input is a vtkUnstructuredGrid with point or cell scalars. There are three modes:
 *
 *  - *The input is a vtkGatunReader without a region of interest or a value range.* The mapper
 * finds a vtkGatunFileHandle in the information of its input and draws the file. It shares the open
 * file and the memory budget of the reader. The bounds come from the tables of the file. Only the
 * visible chunks are read and decoded, for the array that is drawn and the time that the reader is
 * asked for. The reader never executes, its array selection does not matter, and GetDataSetInput()
 * is null.
 *  - *NumberOfPieces is more than 1.* The mapper asks for each piece once, before the first image
 * and whenever the pipeline has changed, to learn its bounds and values. For an image it asks for
 *    those visible pieces, from front to back, that are not kept within MemoryBudget. One piece is
 * in memory at a time. GetDataSetInput() is null. A grid set as data counts as one piece.
 *  - *Otherwise* the whole mesh is in memory.
 *
 * The scalar modes of vtkAbstractVolumeMapper, except field data, and ArrayComponent select the
 * values to draw. The first component of the vtkVolumeProperty gives colors and opacities,
 * whichever component of the array is drawn. Gradient opacity and IndependentComponents have no
 * effect. Clipping planes are in world coordinates.
 *
 * If the property's Shade is on, isosurfaces are lit from both sides by the renderer's lights, with
 * Phong's model and the property's ambient, diffuse and specular coefficients. Lights have no cone
 * and no attenuation. The gradient is constant in each tetrahedron, so coarse meshes look faceted.
 * Cell values have no gradient and are not shaded. Only the blend mode composite shades.
 *
 * *Just in time.* If JustInTime of the DetailPolicy is on, a frame during an interaction takes
 * about the time allowed for it. Points are merged into others, as in vtkGatunSimplify, until
 * tetrahedra take a quarter of that time. If that does not suffice and AutoAdjustSampleDistances is
 * on, rays are cast farther apart. Where points are merged follows the view, unless ViewDependent
 * is off: the mesh stays fine near the eye, and gets coarse where it is far away, out of sight or
 * transparent. The image at rest, for which more than 10 seconds are allocated, shows the whole
 * mesh. For a mesh in memory, a background thread computes the order of merges from the first image
 * on, in about 2 to 3 seconds for a million tetrahedra, and again when the input changes. Until
 * then only the number of rays is reduced. This takes a copy of the mesh, about 60 bytes a
 * tetrahedron in all, in addition to MemoryBudget. The background thread also prepares the levels
 * of detail that are likely to be needed next and finally the whole mesh. Pieces cannot be
 * simplified.
 *
 * *Several processes.* With a Controller, each process has a part of the cells: any part, which
 * need not be compact, or none. The processes exchange the segments of rays that their cells make
 * and merge them, so that the image is the one of a single process with all cells. Opaque geometry
 * of any process ends the rays of all. Each pixel is drawn by one process, over what it has drawn
 * before; see ImageProcess. If processes have the same file as input, each draws every n-th chunk
 * of it; of other pipelines, each asks for its own pieces. Transfer functions and all properties of
 * the mapper must agree. Rays and simplification are chosen by the first process. Only files are
 * simplified. Each process must draw each image, also if its part is empty: remove the cullers of
 * the renderer, or call ReduceBounds. An error in one process is reported by all of them, and none
 * draws anything.
 *
 * *Errors.* What cannot be drawn is reported by vtkErrorMacro, once for each cause, and by
 * GetErrorCode (see vtkGatunReader); nothing is drawn then. A mesh without cells is not an error.
 * vtkRenderWindow::SetAbortRender stops an image, as in an observer of
 * vtkCommand::AbortCheckEvent; nothing of that image is shown. vtkCommand::ProgressEvent reports
 * the progress of an image.
 *
 * A program needs VTK::RenderingVolumeOpenGL2, as for other volume mappers.
 *
 * @sa vtkGatunDetailPolicy vtkGatunRayCaster vtkGatunReader vtkGatunFileHandle
 * vtkUnstructuredGridVolumeRayCastMapper
 */

#ifndef vtkGatunVolumeMapper_h
#define vtkGatunVolumeMapper_h

#include "vtkGatunRenderingModule.h" // For export macro
#include "vtkGatunUpdateResult.h"
#include "vtkUnstructuredGridVolumeMapper.h"

#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkGatunDetailPolicy;
class vtkMultiProcessController;
class vtkTable;

class VTKGATUNRENDERING_EXPORT vtkGatunVolumeMapper : public vtkUnstructuredGridVolumeMapper
{
public:
  static vtkGatunVolumeMapper* New();
  vtkTypeMacro(vtkGatunVolumeMapper, vtkUnstructuredGridVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Blend mode in addition to COMPOSITE_BLEND and MAXIMUM_INTENSITY_BLEND of the superclass, with a
   * number beyond those of vtkVolumeMapper.
   */
  enum
  {
    XRAY_BLEND = 101 ///< integral of the absorption along the ray; colors are averaged
  };

  ///@{
  /**
   * Blend mode: COMPOSITE_BLEND (the default), MAXIMUM_INTENSITY_BLEND or
   * XRAY_BLEND; see vtkGatunRayCaster::BlendModes. Any other value is reported as an error and
   * changes nothing.
   */
  void SetBlendMode(int mode) override;
  void SetBlendModeToXRay() { this->SetBlendMode(XRAY_BLEND); }
  ///@}

  ///@{
  /**
   * Distance between rays in pixels, 1 to 100. The image is interpolated between rays. If
   * AutoAdjustSampleDistances is on, this is the distance in the last image. Default: 1.
   */
  vtkSetClampMacro(ImageSampleDistance, float, 1.0f, 100.0f);
  vtkGetMacro(ImageSampleDistance, float);
  ///@}

  ///@{
  /**
   * Whether ImageSampleDistance is chosen for each image from the time of the last one, so that the
   * image takes the time allocated to the volume (see vtkRenderWindow::SetDesiredUpdateRate). An
   * image at rest has the least distance. Default: on.
   */
  vtkSetMacro(AutoAdjustSampleDistances, bool);
  vtkGetMacro(AutoAdjustSampleDistances, bool);
  vtkBooleanMacro(AutoAdjustSampleDistances, bool);
  ///@}

  ///@{
  /**
   * Limits for AutoAdjustSampleDistances, 1 to 100. Defaults: 1 and 10.
   */
  vtkSetClampMacro(MinimumImageSampleDistance, float, 1.0f, 100.0f);
  vtkGetMacro(MinimumImageSampleDistance, float);
  vtkSetClampMacro(MaximumImageSampleDistance, float, 1.0f, 100.0f);
  vtkGetMacro(MaximumImageSampleDistance, float);
  ///@}

  ///@{
  /**
   * Whether opaque geometry drawn before by the renderer hides the parts of the volume behind it.
   * Off: the volume is drawn as an image at the depth of its center. Default: on.
   */
  vtkSetMacro(IntermixIntersectingGeometry, bool);
  vtkGetMacro(IntermixIntersectingGeometry, bool);
  vtkBooleanMacro(IntermixIntersectingGeometry, bool);
  ///@}

  ///@{
  /**
   * Component of the array to draw, from 0. -1 is the length of the tuple, or the value of an array
   * of one component. Default: -1.
   */
  vtkSetClampMacro(ArrayComponent, int, -1, VTK_INT_MAX);
  vtkGetMacro(ArrayComponent, int);
  ///@}

  ///@{
  /**
   * Transparency at which a ray ends, from 0 (never) to 1. Default: 0.001.
   */
  vtkSetClampMacro(OpacityLimit, double, 0.0, 1.0);
  vtkGetMacro(OpacityLimit, double);
  ///@}

  ///@{
  /**
   * Memory for the parts of a mesh in memory, or of pieces, that are kept for the next image, in
   * MiB, 0 or more. What does not fit is converted or pulled again for each image. For a file, the
   * budget is that of the reader. Default: 512.
   */
  vtkSetClampMacro(MemoryBudget, int, 0, VTK_INT_MAX);
  vtkGetMacro(MemoryBudget, int);
  ///@}

  ///@{
  /**
   * Number of pieces in which the mapper asks for the mesh, 1 or more. The pipeline must be able to
   * produce pieces without duplicate cells. Default: 1.
   */
  vtkSetClampMacro(NumberOfPieces, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfPieces, int);
  ///@}

  ///@{
  /**
   * How far the mesh is simplified; see above. Its changes modify the mapper. Null sets a new
   * policy, which draws the whole mesh. With a ratio or an error, the first image of a mesh in
   * memory waits for the order of edge collapses. If only the ratio has changed since the last
   * image and JustInTime is off, only those squares of 32 by 32 pixels are drawn again that change.
   */
  void SetDetailPolicy(vtkGatunDetailPolicy* policy);
  vtkGatunDetailPolicy* GetDetailPolicy();
  ///@}

  ///@{
  /**
   * The processes that have parts of the mesh; see above. Null, or a controller with one process:
   * all of the mesh is here. Default: null.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  ///@{
  /**
   * The process that draws the image of several processes, or -1: each pixel is drawn by the
   * process with the nearest opaque geometry, at a depth slightly smaller than that, so that
   * compositing by depth keeps it. Give the number of the frontmost process if images are blended
   * in the order of processes. That of the first process counts. Default: -1.
   */
  vtkSetClampMacro(ImageProcess, int, -1, VTK_INT_MAX);
  vtkGetMacro(ImageProcess, int);
  ///@}

  /**
   * Makes GetBounds return the bounds of the parts of all processes, until it is called again or
   * the controller changes. All processes must call it. Does nothing with one process.
   */
  void ReduceBounds();

  /**
   * Statistics of the last image, in the columns of a table of one row:
   *
   *  - BytesRead: bytes read from the file that is drawn since it was opened, by all consumers of
   *    its reader; 0 without a file.
   *  - BytesSent: bytes that all processes together have sent to each other; 0 for one process.
   *  - DrawnPoints: points of the mesh; 0 if they are unknown, as without simplification.
   *  - RedrawnFraction: the part of the image that was drawn again, 0 to 1; see SetDetailPolicy.
   *
   * The next call returns another table.
   */
  vtkTable* GetStatistics();

  /**
   * Computes the order of merges for the input now instead of in the background, and waits for it.
   * Returns false if the input cannot be simplified, or if the policy does not simplify it.
   * AbortExecute ends the wait.
   */
  bool PrepareSimplification();

  /**
   * Includes the policy.
   */
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * Bounds of the whole mesh, from the file or the pieces if these are drawn.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  ///@}

  /**
   * The input if all of it is in memory, otherwise null.
   */
  vtkDataSet* GetDataSetInput() override;

  ///@{
  /**
   * Updates the part of the pipeline that is needed before an image is drawn; see above. Ports and
   * requests have no effect.
   */
  VTK_GATUN_UPDATE_RESULT Update() override;
  VTK_GATUN_UPDATE_RESULT Update(int port) override;
  vtkTypeBool Update(int port, vtkInformationVector* requests) override;
  vtkTypeBool Update(vtkInformation* requests) override;
  VTK_GATUN_UPDATE_RESULT UpdateWholeExtent() override;
  ///@}

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   * DO NOT USE THIS METHOD OUTSIDE OF THE RENDERING PROCESS
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkGatunVolumeMapper();
  ~vtkGatunVolumeMapper() override;

  float ImageSampleDistance = 1;
  bool AutoAdjustSampleDistances = true;
  float MinimumImageSampleDistance = 1;
  float MaximumImageSampleDistance = 10;
  bool IntermixIntersectingGeometry = true;
  int ArrayComponent = -1;
  double OpacityLimit = 0.001;
  int MemoryBudget = 512;
  int NumberOfPieces = 1;
  vtkMultiProcessController* Controller = nullptr;
  int ImageProcess = -1;

private:
  vtkGatunVolumeMapper(const vtkGatunVolumeMapper&) = delete;
  void operator=(const vtkGatunVolumeMapper&) = delete;

  void Fail() noexcept;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
