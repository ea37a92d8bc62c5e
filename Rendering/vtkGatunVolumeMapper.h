// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunVolumeMapper
 * @brief Draws a tetrahedral mesh as a volume, from memory, from its file or piece by piece.
 *
 * To be used in place of vtkUnstructuredGridVolumeRayCastMapper. What is drawn, and how, is told at
 * vtkGatunRayCaster, which makes the same picture without a window. In addition, what is outside of
 * the camera's clipping range is left out, and opaque geometry of the same renderer ends the rays.
 * Opacities are over the property's unit distance, as in VTK's mappers for images; its mapper for
 * unstructured grids takes them for densities, so that they come out lower.
 *
 * The input is a vtkUnstructuredGrid with point or cell scalars. What is asked of the pipeline:
 *
 *  - *A vtkGatunReader without a region of interest or a value range is connected*: nothing. Bounds
 *    come from the tables of its file, and of the mesh only the chunks that are seen are read and
 *    decoded, of the array that is drawn and of the time that is asked of the reader. The reader is
 *    never executed; which arrays it is to read does not matter, and GetDataSetInput() is null.
 *  - *NumberOfPieces is more than 1*: each piece once for its bounds and values, before the first
 *    picture and whenever the pipeline has changed. For a picture, from front to back, those pieces
 *    that are seen and are not kept within MemoryBudget. One piece is in memory at a time.
 *    GetDataSetInput() is null. A grid that was given as such counts as one piece.
 *  - *Otherwise*: all of the mesh.
 *
 * Which values are drawn: see the scalar modes of vtkAbstractVolumeMapper, all of which hold but
 * that of field data; and ArrayComponent. Colours and opacities of the vtkVolumeProperty are those
 * of its first component, whichever component of the array is drawn; gradient opacity and
 * IndependentComponents have no influence. Clipping planes are in world coordinates.
 *
 * With the property's Shade on, surfaces of equal values are lit from both sides by the renderer's
 * lights, by Phong's model with the property's ambient, diffuse and specular parts; lights have no
 * cone and do not fade. The gradient is that of each tetrahedron, so that coarse meshes show their
 * cells. What has no gradient, as values of cells, is not shaded, nor are the blend modes but
 * composite and area.
 *
 * *Just in time.* With JustInTime on, a picture during an interaction takes about the time that
 * there is for it: points are merged into others, as vtkGatunSimplify does, until tetrahedra take a
 * quarter of it; then, with AutoAdjustSampleDistances on, rays are cast farther apart. The picture
 * at rest, for which more than 10 seconds are allocated, shows the whole mesh. How a mesh in memory
 * can be simplified is found out by a thread in the background, from the first picture on, in about
 * 5 to 10 seconds for a million tetrahedra, and again when the input changes; meanwhile, only rays
 * get fewer. That takes a copy of the mesh, about 60 bytes a tetrahedron all together, beyond
 * MemoryBudget. Simpler meshes that are likely to be wanted next, and at last the whole one, are
 * made ready in the background, too. Pieces cannot be simplified.
 *
 * *Errors.* What cannot be drawn is reported by vtkErrorMacro and GetErrorCode (as vtkGatunReader
 * has them), the message once for the same cause, and nothing is drawn. A mesh without cells is no
 * error. Pictures can be stopped by vtkRenderWindow::SetAbortRender, as in an observer of
 * vtkCommand::AbortCheckEvent; nothing of them is shown. vtkCommand::ProgressEvent tells how far
 * one is.
 *
 * A program needs VTK::RenderingVolumeOpenGL2, as for other volume mappers.
 *
 * @sa vtkGatunRayCaster vtkGatunReader vtkUnstructuredGridVolumeRayCastMapper
 */

#ifndef vtkGatunVolumeMapper_h
#define vtkGatunVolumeMapper_h

#include "vtkGatunRenderingModule.h" // For export macro
#include "vtkUnstructuredGridVolumeMapper.h"

#include <memory> // For std::unique_ptr

class VTKGATUNRENDERING_EXPORT vtkGatunVolumeMapper : public vtkUnstructuredGridVolumeMapper
{
public:
  static vtkGatunVolumeMapper* New();
  vtkTypeMacro(vtkGatunVolumeMapper, vtkUnstructuredGridVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Blend modes in addition to COMPOSITE_BLEND and MAXIMUM_INTENSITY_BLEND of the superclass, with
   * numbers beyond those of vtkVolumeMapper.
   */
  enum
  {
    AREA_BLEND = 100, ///< composite with one sample for each tetrahedron that a ray crosses
    XRAY_BLEND = 101  ///< sum of the absorption along the ray; colors are averaged
  };

  ///@{
  /**
   * Blend mode: COMPOSITE_BLEND (the default), MAXIMUM_INTENSITY_BLEND, AREA_BLEND or XRAY_BLEND;
   * see vtkGatunRayCaster::BlendModes. Any other value is reported as an error and changes nothing.
   */
  void SetBlendMode(int mode) override;
  void SetBlendModeToArea() { this->SetBlendMode(AREA_BLEND); }
  void SetBlendModeToXRay() { this->SetBlendMode(XRAY_BLEND); }
  ///@}

  ///@{
  /**
   * Distance between the samples of a ray in world units, 0 or more. 0 is the distance of rays at
   * the camera's focal point. Default: 0.
   */
  vtkSetClampMacro(SampleDistance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SampleDistance, double);
  ///@}

  ///@{
  /**
   * Distance of rays in pixels, 1 to 100; between them the picture is interpolated. While
   * AutoAdjustSampleDistances is on, it tells what was used last. Default: 1.
   */
  vtkSetClampMacro(ImageSampleDistance, float, 1.0f, 100.0f);
  vtkGetMacro(ImageSampleDistance, float);
  ///@}

  ///@{
  /**
   * Whether ImageSampleDistance is chosen for each picture, so that it takes the time allocated to
   * the volume (see vtkRenderWindow::SetDesiredUpdateRate), as far as the last one tells. A picture
   * at rest has time for the least distance. Default: on.
   */
  vtkSetMacro(AutoAdjustSampleDistances, bool);
  vtkGetMacro(AutoAdjustSampleDistances, bool);
  vtkBooleanMacro(AutoAdjustSampleDistances, bool);
  ///@}

  ///@{
  /**
   * Least and largest distance that AutoAdjustSampleDistances may choose, 1 to 100. Defaults: 1
   * and 10.
   */
  vtkSetClampMacro(MinimumImageSampleDistance, float, 1.0f, 100.0f);
  vtkGetMacro(MinimumImageSampleDistance, float);
  vtkSetClampMacro(MaximumImageSampleDistance, float, 1.0f, 100.0f);
  vtkGetMacro(MaximumImageSampleDistance, float);
  ///@}

  ///@{
  /**
   * Whether opaque geometry that the renderer has drawn before hides what is behind it. Off: the
   * volume is drawn as if it were a picture at the depth of its centre. Default: on.
   */
  vtkSetMacro(IntermixIntersectingGeometry, bool);
  vtkGetMacro(IntermixIntersectingGeometry, bool);
  vtkBooleanMacro(IntermixIntersectingGeometry, bool);
  ///@}

  ///@{
  /**
   * Component of the array to draw, from 0; -1 for the length of its tuples. Default: 0.
   */
  vtkSetClampMacro(ArrayComponent, int, -1, VTK_INT_MAX);
  vtkGetMacro(ArrayComponent, int);
  ///@}

  ///@{
  /**
   * Once less light than this comes through, what is behind is not drawn: 0 (draw all) to 1.
   * Default: 0.001.
   */
  vtkSetClampMacro(OpacityLimit, double, 0.0, 1.0);
  vtkGetMacro(OpacityLimit, double);
  ///@}

  ///@{
  /**
   * Memory for the parts of the mesh that are kept for the next image, in MiB, 0 or more. What
   * does not fit is converted, decoded or pulled again for each image. Default: 512.
   */
  vtkSetClampMacro(MemoryBudget, int, 0, VTK_INT_MAX);
  vtkGetMacro(MemoryBudget, int);
  ///@}

  ///@{
  /**
   * In how many pieces the mesh is asked for; 1 for all of it at once. The pipeline must be able to
   * make pieces, without duplicate cells. Default: 1.
   */
  vtkSetClampMacro(NumberOfPieces, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfPieces, int);
  ///@}

  ///@{
  /**
   * Whether pictures during an interaction are to be drawn within their time, by simpler meshes;
   * see above. Default: off.
   */
  vtkSetMacro(JustInTime, bool);
  vtkGetMacro(JustInTime, bool);
  vtkBooleanMacro(JustInTime, bool);
  ///@}

  ///@{
  /**
   * Seconds that a picture may take during an interaction, with JustInTime on; 0 for what is
   * allocated to the volume (see vtkRenderWindow::SetDesiredUpdateRate). Default: 0.
   */
  vtkSetClampMacro(TimeBudget, double, 0.0, 1e6);
  vtkGetMacro(TimeBudget, double);
  ///@}

  ///@{
  /**
   * Fraction of points removed in all images, from 0 (none) to 1 (as many as possible). The first
   * image waits for the order of edge collapses. If only the ratio has changed since the last image
   * and JustInTime is off, only those squares of 16 by 16 pixels are drawn again that change.
   * Default: 0.
   */
  vtkSetClampMacro(SimplificationRatio, double, 0.0, 1.0);
  vtkGetMacro(SimplificationRatio, double);
  ///@}

  /**
   * How many points the mesh of the last picture had; 0 if that is not known, as where nothing is
   * simplified.
   */
  vtkIdType GetNumberOfDrawnPoints();

  /**
   * What part of the last picture was drawn anew, 0 to 1; see SimplificationRatio.
   */
  double GetPartDrawn();

  /**
   * Waits until it is known how the input can be simplified, which otherwise is found out while
   * pictures are drawn. False if it cannot be, and while neither JustInTime is on nor
   * SimplificationRatio above 0. AbortExecute stops waiting.
   */
  bool PrepareSimplification();

  /**
   * Bytes that this mapper has read from the file that it draws, since it opened it. 0 if it draws
   * none.
   */
  vtkTypeUInt64 GetBytesRead();

  ///@{
  /**
   * Of the whole mesh; from its file or its pieces where these are drawn.
   */
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  ///@}

  /**
   * The input, if all of it is in memory; otherwise null.
   */
  vtkDataSet* GetDataSetInput() override;

  ///@{
  /**
   * Asks of the pipeline what is needed before a picture is drawn: the mesh, or less, see above.
   * Ports and requests do not matter.
   */
  void Update() override;
  void Update(int port) override;
  vtkTypeBool Update(int port, vtkInformationVector* requests) override;
  vtkTypeBool Update(vtkInformation* requests) override;
  void UpdateWholeExtent() override;
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

  double SampleDistance = 0;
  float ImageSampleDistance = 1;
  bool AutoAdjustSampleDistances = true;
  float MinimumImageSampleDistance = 1;
  float MaximumImageSampleDistance = 10;
  bool IntermixIntersectingGeometry = true;
  int ArrayComponent = 0;
  double OpacityLimit = 0.001;
  int MemoryBudget = 512;
  int NumberOfPieces = 1;
  bool JustInTime = false;
  double TimeBudget = 0;
  double SimplificationRatio = 0;

private:
  vtkGatunVolumeMapper(const vtkGatunVolumeMapper&) = delete;
  void operator=(const vtkGatunVolumeMapper&) = delete;

  void Fail() noexcept;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
