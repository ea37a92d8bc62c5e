// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunHartleyProjection
 * @brief Renders a volume from its Hartley coefficients.
 *
 * Input: a vtkImageData of any size, spacing and direction. If its information has the key
 * vtkGatunHartleyCoefficients::COEFFICIENTS(), the coefficients of that key are drawn:
 *
 *  - Behind a vtkGatunHartleyReader, the projection draws from the reader's open file and requests
 * no voxels. The reader's output remains empty unless another consumer requests it.
 *  - Behind a vtkGatunHartleyEncoder, it draws the coefficients that the encoder has computed.
 *
 * Other filters do not pass the key on. An input without the key is encoded by this class, with the
 * defaults of vtkGatunHartleyEncoder, when it has changed. It must have a point array of one
 * component and any numeric type except bits, with finite values. SetInputArrayToProcess selects
 * the array; the default is the active point scalars.
 *
 * Output: a vtkImageData of Size. Point (0, 0) is at the lower left. Origin and spacing are in
 * world units, relative to the middle of the image. Point arrays:
 *
 *  - Color (unsigned char, 4 components, active scalars): red, green, blue and opacity, not
 *    premultiplied;
 *
 * and if OutputFloats is on:
 *
 *  - RGBA (float, 4 components): premultiplied, 0 to 1;
 *  - Sum (float), with OPACITY_MODEL_XRAY only: sum of the values along the ray, one for each
 *    SampleDistance;
 *  - Samples (float), with OPACITY_MODEL_XRAY only: number of samples inside the volume. Sum /
 *    Samples is the mean value.
 *
 * *Rays.* The volume is the trilinear interpolation of its voxels, and sums are integrals of it.
 * The result does not depend on the position of samples. With OPACITY_MODEL_EXPONENTIAL, the
 * opacity of a block is exact at the points of a lattice with twice the resolution of the voxels,
 * and interpolated between them. With OPACITY_MODEL_TRANSFER_FUNCTION, the opacity is that of a
 * block with its mean value along the ray. The color is that of the mean value in both models.
 * Smaller blocks reduce these errors.
 *
 * *Pieces.* Each piece is a part of the image. Every process draws the whole image.
 *
 * *Cost.* With blocks of up to 16 voxels, projecting a block takes time in proportion to the number
 * of its nonzero coefficients; compositing takes time in proportion to the number of blocks. With
 * larger blocks, the time depends on the number of voxels. Memory: the nonzero coefficients, 8
 * bytes each (of a file those of several chunks only), and MemoryBudget. Uses all threads of
 * vtkSMPTools.
 *
 * *Errors.* Unsuitable arrays, views, parameters and files are reported by vtkErrorMacro and
 * GetErrorCode, as for vtkGatunReader. The output is then empty.
 *
 * @par Background
 * C. Yang: On-the-fly processing of compressed volume data, 2001, section 3. T. Malzbender: Fourier
 * volume rendering. ACM Transactions on Graphics 12(3), 1993.
 *
 * @warning The projection is parallel. The projection-slice theorem does not apply to perspective
 * projections.
 *
 * @sa vtkGatunHartleyEncoder vtkGatunHartleyReader vtkGatunHartleyMapper
 */

#ifndef vtkGatunHartleyProjection_h
#define vtkGatunHartleyProjection_h

#include "vtkGatunRenderingModule.h" // For export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // For MakeCamera

#include <limits> // For std::numeric_limits
#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkCamera;
class vtkTable;
class vtkVolumeProperty;

class VTKGATUNRENDERING_EXPORT vtkGatunHartleyProjection : public vtkImageAlgorithm
{
public:
  static vtkGatunHartleyProjection* New();
  vtkTypeMacro(vtkGatunHartleyProjection, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The camera, with a parallel projection. If it is in stereo, its current eye is used. The
   * clipping range is not used. A camera with a perspective projection, or one that is sheared or
   * scaled unevenly, is an error. Null: the image shows all of the volume, seen along the z axis
   * from above, with y upwards. Default: null.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  /**
   * Moves a camera without turning it, so that its image shows all of the volume, and turns
   * parallel projection on. Updates the information of the input. Returns false, and leaves the
   * camera unchanged, if there is no volume.
   */
  bool ResetCamera(vtkCamera* camera);

  ///@{
  /**
   * Width and height of the image in pixels, 1 to 32000 each. Default: 512, 512.
   */
  void SetSize(int width, int height);
  void SetSize(const int size[2]) { this->SetSize(size[0], size[1]); }
  vtkGetVector2Macro(Size, int);
  ///@}

  /**
   * How the values along a ray determine the color and opacity of a pixel.
   */
  enum OpacityModelType
  {
    OPACITY_MODEL_XRAY = 0,             ///< gray level by the sum of the values
    OPACITY_MODEL_EXPONENTIAL = 1,      ///< opacity by Extinction, color by the transfer function
    OPACITY_MODEL_TRANSFER_FUNCTION = 2 ///< opacity and color by the transfer functions
  };

  ///@{
  /**
   * See OpacityModelType. Default: OPACITY_MODEL_TRANSFER_FUNCTION.
   */
  vtkSetClampMacro(OpacityModel, int, OPACITY_MODEL_XRAY, OPACITY_MODEL_TRANSFER_FUNCTION);
  vtkGetMacro(OpacityModel, int);
  void SetOpacityModelToXRay() { this->SetOpacityModel(OPACITY_MODEL_XRAY); }
  void SetOpacityModelToExponential() { this->SetOpacityModel(OPACITY_MODEL_EXPONENTIAL); }
  void SetOpacityModelToTransferFunction()
  {
    this->SetOpacityModel(OPACITY_MODEL_TRANSFER_FUNCTION);
  }
  ///@}

  ///@{
  /**
   * Colors and opacities of values: the color function (of one or three channels), the scalar
   * opacity and its unit distance, which must be above 0. Null: gray levels from black to white,
   * and opacities from 0 to 1 for a ray of a thirtieth of the volume's diagonal, from the smallest
   * value of the volume to the largest. Default: null.
   */
  void SetProperty(vtkVolumeProperty* property);
  vtkVolumeProperty* GetProperty();
  ///@}

  ///@{
  /**
   * With OPACITY_MODEL_EXPONENTIAL, a ray of length l through the value v has the opacity
   * 1 - exp(-Extinction (v - Zero) l). 0: the largest value reaches an optical depth of 1 in a
   * tenth of the volume's diagonal. Not negative. Default: 0.
   */
  vtkSetClampMacro(Extinction, double, 0, VTK_DOUBLE_MAX);
  vtkGetMacro(Extinction, double);
  ///@}

  ///@{
  /**
   * With OPACITY_MODEL_EXPONENTIAL, the value that is transparent. A block whose mean value along a
   * ray is lower is transparent, too. NaN: the smallest value of the volume. Default: NaN.
   */
  void SetZero(double value);
  vtkGetMacro(Zero, double);
  ///@}

  ///@{
  /**
   * With OPACITY_MODEL_XRAY, the values of Sum that are drawn black and white. If they are equal,
   * the smallest and the largest sum of the image. Default: 0, 0.
   */
  vtkSetVector2Macro(Window, double);
  vtkGetVector2Macro(Window, double);
  ///@}

  ///@{
  /**
   * Color over which the volume is composited, so that the image is opaque: red, green and blue, 0
   * to 1 each. If one of them is negative, there is no background. Default: -1, -1, -1.
   */
  void SetBackground(double red, double green, double blue);
  void SetBackground(const double color[3]) { this->SetBackground(color[0], color[1], color[2]); }
  vtkGetVector3Macro(Background, double);
  ///@}

  ///@{
  /**
   * Whether the output has the array RGBA and, with OPACITY_MODEL_XRAY, Sum and Samples. Default:
   * off.
   */
  vtkSetMacro(OutputFloats, bool);
  vtkGetMacro(OutputFloats, bool);
  vtkBooleanMacro(OutputFloats, bool);
  ///@}

  ///@{
  /**
   * The unit of sums: the length of a ray that a sample stands for, in world units. 0: the edge of
   * a cube of the same volume as the cell of a voxel. Sum, Samples and Window depend on it;
   * opacities do not. Not negative. Default: 0.
   */
  vtkSetClampMacro(SampleDistance, double, 0, VTK_DOUBLE_MAX);
  vtkGetMacro(SampleDistance, double);
  ///@}

  /**
   * How the image of a block is computed from its coefficients.
   */
  enum MethodType
  {
    METHOD_AUTOMATIC = 0, ///< X-rays of volumes with at least 64 voxels a side by a slice through
                          ///< the spectrum of the whole volume; otherwise METHOD_VOXELS for
                          ///< blocks of up to 64 voxels along each axis and METHOD_SLICE for
                          ///< larger ones
    METHOD_BASIS = 1,     ///< weighted sum of the images of the basis functions
    METHOD_SLICE = 2,     ///< inverse transform of a slice through the block's spectrum
    METHOD_VOXELS = 3     ///< weighted sum of the voxels next to each ray
  };

  ///@{
  /**
   * See MethodType. Default: METHOD_AUTOMATIC.
   */
  vtkSetClampMacro(Method, int, METHOD_AUTOMATIC, METHOD_VOXELS);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * Upper bound of the memory that is kept from one image to the next, in MiB. It holds
   * coefficients of a file's chunks or, with METHOD_SLICE, spectra and, with METHOD_VOXELS, voxels
   * of blocks. The rest is computed again for each image. Not negative. Default: 512.
   */
  vtkSetClampMacro(MemoryBudget, int, 0, VTK_INT_MAX);
  vtkGetMacro(MemoryBudget, int);
  ///@}

  /**
   * Statistics in the columns of a table of one row:
   *
   *  - DrawnBlocks: blocks drawn in the last image
   *  - Coefficients: coefficients summed for the last image
   *  - Method: method of the last image, see MethodType
   *  - Volumes: number of different volumes that this object has drawn
   *
   * The next call returns another table.
   */
  vtkTable* GetStatistics();

  /**
   * Smallest and largest value, before compression, of the volume that was drawn last.
   */
  void GetRange(double range[2]) VTK_SIZEHINT(2);

  /**
   * Includes the camera and the property.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkGatunHartleyProjection();
  ~vtkGatunHartleyProjection() override;

  /**
   * The information that is searched for the key of the coefficients. Default: that of the input.
   */
  virtual vtkInformation* GetCoefficientsInformation();

  /**
   * Returns the camera for a volume with a given center, of which a camera with a given
   * ParallelScale shows all. Default: the camera that was set.
   */
  virtual vtkSmartPointer<vtkCamera> MakeCamera(const double center[3], double parallelScale);

  /**
   * Returns the property for a volume of a given range and diagonal, the latter in world units.
   * Default: the property that was set.
   */
  virtual vtkSmartPointer<vtkVolumeProperty> MakeProperty(const double range[2], double diagonal);

  vtkExecutive* CreateDefaultExecutive() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  int Size[2] = { 512, 512 };
  int OpacityModel = OPACITY_MODEL_TRANSFER_FUNCTION;
  double Extinction = 0;
  double Zero = std::numeric_limits<double>::quiet_NaN();
  double Window[2] = { 0, 0 };
  double Background[3] = { -1, -1, -1 };
  bool OutputFloats = false;
  double SampleDistance = 0;
  int Method = METHOD_AUTOMATIC;
  int MemoryBudget = 512;

private:
  vtkGatunHartleyProjection(const vtkGatunHartleyProjection&) = delete;
  void operator=(const vtkGatunHartleyProjection&) = delete;

  class vtkPipeline;
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
