// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunRayCaster
 * @brief Volume rendering of a tetrahedral mesh into an image, without a window.
 *
 * Input: a vtkUnstructuredGrid with point or cell scalars of any numeric type. Tetrahedra are drawn
 * as they are, other linear 3D cells are split, and quadratic tetrahedra are linearized. Cells of
 * other types are an error. Hidden, refined and duplicate cells (vtkGhostType) are left out.
 * Tetrahedra with a coordinate or value that is NaN or infinite are not visible.
 *
 * *From a file.* If the input is the output of a vtkGatunReader without a region of interest, the
 * filter finds a vtkGatunFileHandle in the information of its input and draws directly from the
 * file, chunk by chunk from front to back. Chunks outside of the view, transparent or hidden ones
 * are not even read. The filter shares the reader's open file and memory budget, and the reader is
 * not asked for the mesh. Other inputs must be in memory as a whole.
 *
 * Output: a vtkImageData of Size with these point arrays:
 *
 *  - RGBA (float, 4 components, the active scalars): red, green and blue, premultiplied by opacity,
 *    and opacity, 0 to 1;
 *  - Depth (float): the distance of the first visible sample, in world units, from the eye along
 * the ray, or from the plane of the camera in a parallel projection; infinity where nothing is
 *    visible, and in the modes maximum and X-ray.
 *
 * Point (0, 0) is at the lower left.
 *
 * Samples are SampleDistance apart, at integer multiples of it, measured as Depth is. Values are
 * interpolated linearly. Color and opacity are then looked up in tables of 4096 entries. The image
 * does not depend on the order of the cells, on chunks or on the number of threads, except for
 * rounding (below 1/255). Where tetrahedra overlap, the order of their colors is undefined.
 *
 * *Cost.* Memory of about 75 bytes for each pixel that is reached and 20 MB for each thread, in
 * addition to MemoryBudget, or for a file the budget of the reader. Time in proportion to the
 * visible tetrahedra and to the samples. All threads of vtkSMPTools are used.
 *
 * *Errors.* A mesh, array, parameter or file that cannot be drawn is reported by vtkErrorMacro and
 * GetErrorCode (with the codes of vtkGatunReader). The output is then empty.
 *
 * @par Background
 * C. Yang, T. Mitra, T. Chiueh: On-the-fly rendering of losslessly compressed irregular volume
 * data. IEEE Visualization 2000. P. Bunyk, A. Kaufman, C. Silva: Simple, fast and robust ray
 * casting of irregular grids. Dagstuhl 1997.
 *
 * @sa vtkGatunReader vtkGatunFileHandle vtkUnstructuredGridVolumeRayCastMapper
 */

#ifndef vtkGatunRayCaster_h
#define vtkGatunRayCaster_h

#include "vtkGatunRenderingModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For std::unique_ptr

class vtkCamera;
class vtkMatrix4x4;
class vtkPlaneCollection;
class vtkVolumeProperty;

class VTKGATUNRENDERING_EXPORT vtkGatunRayCaster : public vtkImageAlgorithm
{
public:
  static vtkGatunRayCaster* New();
  vtkTypeMacro(vtkGatunRayCaster, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What becomes of the samples of a ray.
   */
  enum ModeType
  {
    Composite = 0, ///< colour and opacity, front to back
    Area = 1,    ///< the same, but one sample for all that a tetrahedron has of a ray: the mean of
                 ///< the values at the two faces, with the length in between
    Maximum = 2, ///< the colour and opacity of the largest value
    XRay = 3     ///< absorption adds up whatever lies in front; colours are averaged
  };

  ///@{
  /**
   * See ModeType. Default: Composite.
   */
  vtkSetClampMacro(Mode, int, Composite, XRay);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /**
   * Who looks. Its clipping range is not used. Default: none, which is an error.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /**
   * Colours and opacities. Of it count: the colour function (of one or three channels), the scalar
   * opacity and its unit distance; and Shade with its parts, see vtkGatunVolumeMapper, by a light
   * at the camera. Default: none, which is an error.
   */
  void SetProperty(vtkVolumeProperty* property);
  vtkVolumeProperty* GetProperty();
  ///@}

  ///@{
  /**
   * Where the mesh is in the world; affine. Default: none, it is where its coordinates say.
   */
  void SetVolumeMatrix(vtkMatrix4x4* matrix);
  vtkMatrix4x4* GetVolumeMatrix();
  ///@}

  ///@{
  /**
   * Only what is on the positive side of all planes is drawn; in world coordinates. Default: none.
   */
  void SetClippingPlanes(vtkPlaneCollection* planes);
  vtkPlaneCollection* GetClippingPlanes();
  ///@}

  ///@{
  /**
   * Width and height of the image in pixels, 1 to 32000 each. Default: 512, 512.
   */
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /**
   * Distance of samples in world units; 0: the size of a pixel at the camera's focal point.
   * Default: 0.
   */
  vtkSetMacro(SampleDistance, double);
  vtkGetMacro(SampleDistance, double);
  ///@}

  ///@{
  /**
   * Name of the array to draw; none for the active scalars, of the points or else of the cells.
   * Default: none.
   */
  vtkSetStringMacro(ArrayName);
  vtkGetStringMacro(ArrayName);
  ///@}

  ///@{
  /**
   * Whether the array is of the points (0), of the cells (1), or of either (-1), points first.
   * Default: -1.
   */
  vtkSetClampMacro(ArrayAssociation, int, -1, 1);
  vtkGetMacro(ArrayAssociation, int);
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
   * How much of the mesh is kept ready for the next image, in MiB. Beyond it, it is made or decoded
   * anew each time. Default: 512.
   */
  vtkSetClampMacro(MemoryBudget, int, 0, VTK_INT_MAX);
  vtkGetMacro(MemoryBudget, int);
  ///@}

  ///@{
  /**
   * Part of the mesh's points that is merged away, 0 to 1, as far as that is possible; others are
   * an error. A file must have been written with a hierarchy (vtkGatunWriter::Hierarchy) for it; of
   * a mesh in memory, it is first found out how to simplify it (see vtkGatunSimplify), which is
   * kept for the next image. Default: 0.
   */
  vtkSetMacro(SimplificationRatio, double);
  vtkGetMacro(SimplificationRatio, double);
  ///@}

  ///@{
  /**
   * Seconds that an image may take, without decoding and simplifying: as many points are merged
   * away as that needs, by what the images before took. 0 for all that it needs. Default: 0.
   */
  vtkSetClampMacro(TimeBudget, double, 0.0, 1e6);
  vtkGetMacro(TimeBudget, double);
  ///@}

  ///@{
  /**
   * Whether to use only instructions that every processor has. Default: off.
   */
  vtkSetMacro(PortableInstructions, bool);
  vtkGetMacro(PortableInstructions, bool);
  vtkBooleanMacro(PortableInstructions, bool);
  ///@}

  ///@{
  /**
   * Whether tetrahedra are also released from behind, so that rays grow from both ends: fewer
   * tetrahedra wait for others, but less is hidden early. Default: off.
   */
  vtkSetMacro(FromBothEnds, bool);
  vtkGetMacro(FromBothEnds, bool);
  vtkBooleanMacro(FromBothEnds, bool);
  ///@}

  /**
   * What is known of the last image. Times are of all threads together, in seconds.
   */
  enum StatisticType
  {
    FetchTime = 0,          ///< making or decoding chunks
    OrderTime,              ///< projecting and ordering tetrahedra
    SetUpTime,              ///< planes of their faces
    DrawTime,               ///< samples
    FinishTime,             ///< fragments into pixels
    NumberOfTetrahedra,     ///< of chunks that were drawn
    NumberOfSeenTetrahedra, ///< of those, that may own a sample
    NumberOfChunks,         ///< drawn
    NumberOfSkippedChunks,  ///< outside, transparent or hidden
    MostWaitingTetrahedra,  ///< for others to be drawn, in a chunk
    MostFragments,          ///< of rays, in all pixels together
    MostBytes               ///< of image and chunks at work, without those kept ready
  };
  double GetStatistic(int which);

  vtkMTimeType GetMTime() override;

protected:
  vtkGatunRayCaster();
  ~vtkGatunRayCaster() override;

  vtkExecutive* CreateDefaultExecutive() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int Mode = Composite;
  int Size[2] = { 512, 512 };
  double SampleDistance = 0;
  char* ArrayName = nullptr;
  int ArrayAssociation = -1;
  int ArrayComponent = 0;
  double OpacityLimit = 0.001;
  int MemoryBudget = 512;
  double SimplificationRatio = 0;
  double TimeBudget = 0;
  bool PortableInstructions = false;
  bool FromBothEnds = false;

private:
  vtkGatunRayCaster(const vtkGatunRayCaster&) = delete;
  void operator=(const vtkGatunRayCaster&) = delete;

  class vtkPipeline;
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
