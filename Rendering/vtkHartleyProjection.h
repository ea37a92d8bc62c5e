// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHartleyProjection
 * @brief Draws a regular volume from its Hartley coefficients, without going back to voxels.
 *
 * Input: a vtkImageData, of whatever size, spacing and direction, with a point array of one
 * component of any numeric type but bits. Which array: SetInputArrayToProcess, by default the
 * active point scalars. Values must be finite. It is compressed, as vtkHartleyVolumeWriter would,
 * when it or a property of the compression has changed, and what comes of that is drawn.
 *
 * If the input is the output of a vtkHartleyVolumeReader, its file is drawn instead, and the reader
 * is never asked for voxels: unless it has them already, its output is empty afterwards, until
 * somebody asks for them (vtkAlgorithm::UpdateWholeExtent). The properties of the compression are
 * then those of the file.
 *
 * Output: a vtkImageData of Size. Point (0, 0) is at the lower left; origin and spacing are in
 * world units, the camera's focal point being at (0, 0). Its point arrays are
 *
 *  - Color (unsigned char, 4 components, the active scalars): red, green, blue and opacity, which
 *    is not multiplied in;
 *
 * and with OutputFloats besides
 *
 *  - RGBA (float, 4 components): the same with opacity multiplied in, 0 to 1;
 *  - Sum (float), under LAW_XRAY: what the values along the ray add up to, one a SampleDistance,
 * counted from 0;
 *  - Samples (float), under LAW_XRAY: how many of them lie in the volume. Sum / Samples is the mean
 * value.
 *
 * *Rays.* The volume is the trilinear one of its voxels, and sums are integrals over it: nothing is
 * missed between samples, and nothing depends on where they lie. Under LAW_EXPONENTIAL a block's
 * opacity is exact; under LAW_TRANSFER_FUNCTION it is as if the block had its mean value along the
 * ray everywhere, and so are colours under both. Smaller blocks are nearer to the truth.
 *
 * *Pieces.* Each draws the whole picture and keeps its part.
 *
 * *Cost.* With blocks of up to 16 voxels the time grows with the number of coefficients that are
 * not zero; with larger blocks with that of the voxels. Memory: the coefficients that are not zero,
 * 8 bytes each, of a file only some chunks at a time, and MemoryBudget. All threads of vtkSMPTools
 * are used.
 *
 * *Errors.* An array, parameter, camera or file that cannot be used is reported by vtkErrorMacro
 * and GetErrorCode (as vtkGatunReader has them); the output is then empty.
 *
 * @par Background
 * C. Yang: On-the-fly processing of compressed volume data, 2001, section 3. T. Malzbender: Fourier
 * volume rendering. ACM Transactions on Graphics 12(3), 1993.
 *
 * @warning There is no perspective: all rays must have one direction for the projection-slice
 * theorem to hold. Such a camera is an error.
 *
 * @sa vtkHartleyVolumeReader vtkHartleyVolumeWriter
 */

#ifndef vtkHartleyProjection_h
#define vtkHartleyProjection_h

#include "vtkGatunRenderingModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkCamera;
class vtkVolumeProperty;

class VTKGATUNRENDERING_EXPORT vtkHartleyProjection : public vtkImageAlgorithm
{
public:
  static vtkHartleyProjection* New();
  vtkTypeMacro(vtkHartleyProjection, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Who looks, in a parallel projection. Its clipping range is not used. Without one, all of the
   * volume is seen from where ViewDirection, ViewUp and Zoom tell. Default: none.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  /**
   * Moves the camera, without turning it, so that all of the volume is in the picture, and makes
   * its projection parallel. Updates the information of the input. Without a camera, or a volume,
   * nothing happens.
   */
  void ResetCamera();

  ///@{
  /**
   * Without a camera: the way that rays go, in world coordinates, of whatever length. Default: 0,
   * 0, -1.
   */
  vtkSetVector3Macro(ViewDirection, double);
  vtkGetVector3Macro(ViewDirection, double);
  ///@}

  ///@{
  /**
   * Without a camera: what points up in the picture, at least partly; not along ViewDirection.
   * Default: 0, 1, 0.
   */
  vtkSetVector3Macro(ViewUp, double);
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * Without a camera: more than 1 shows less of the volume, and larger. Above 0. Default: 1.
   */
  vtkSetMacro(Zoom, double);
  vtkGetMacro(Zoom, double);
  ///@}

  ///@{
  /**
   * Width and height of the picture in pixels, 1 to 32000 each. Default: 512, 512.
   */
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

  /**
   * How the values along a ray become a colour.
   */
  enum LawType
  {
    LAW_XRAY = 0,             ///< grey, by their sum
    LAW_EXPONENTIAL = 1,      ///< opacity by Extinction, colour by the property
    LAW_TRANSFER_FUNCTION = 2 ///< opacity and colour by the property
  };

  ///@{
  /**
   * See LawType. Default: LAW_TRANSFER_FUNCTION.
   */
  vtkSetClampMacro(Law, int, LAW_XRAY, LAW_TRANSFER_FUNCTION);
  vtkGetMacro(Law, int);
  void SetLawToXRay() { this->SetLaw(LAW_XRAY); }
  void SetLawToExponential() { this->SetLaw(LAW_EXPONENTIAL); }
  void SetLawToTransferFunction() { this->SetLaw(LAW_TRANSFER_FUNCTION); }
  ///@}

  ///@{
  /**
   * Colours and opacities. Of it count the colour function (of one or three channels), the scalar
   * opacity and its unit distance. Without one, grey: the smallest value is black and transparent,
   * the largest is white and opaque in a thirtieth of the volume's diagonal. Default: none.
   */
  void SetProperty(vtkVolumeProperty* property);
  vtkVolumeProperty* GetProperty();
  ///@}

  ///@{
  /**
   * LAW_EXPONENTIAL: a length l of ray through the value v has the opacity
   * 1 - exp(-Extinction (v - Zero) l). 0 or less: so much that the largest value has an extinction
   * of 1 in a tenth of the volume's diagonal. Default: 0.
   */
  vtkSetMacro(Extinction, double);
  vtkGetMacro(Extinction, double);
  ///@}

  ///@{
  /**
   * Whether values count from Zero on, for LAW_EXPONENTIAL, and not from the smallest one of the
   * volume. Default: off.
   */
  vtkSetMacro(UseZero, bool);
  vtkGetMacro(UseZero, bool);
  vtkBooleanMacro(UseZero, bool);
  ///@}

  ///@{
  /**
   * The value up to which there is nothing, if UseZero is on; lower ones do not make up for others.
   * Default: 0.
   */
  vtkSetMacro(Zero, double);
  vtkGetMacro(Zero, double);
  ///@}

  ///@{
  /**
   * LAW_XRAY: the values of Sum that are black and white. If they are equal, they are the smallest
   * and the largest of the picture. Default: 0, 0.
   */
  vtkSetVector2Macro(Window, double);
  vtkGetVector2Macro(Window, double);
  ///@}

  ///@{
  /**
   * Whether Background is behind the volume; Color is then opaque. Default: off.
   */
  vtkSetMacro(UseBackground, bool);
  vtkGetMacro(UseBackground, bool);
  vtkBooleanMacro(UseBackground, bool);
  ///@}

  ///@{
  /**
   * Red, green and blue, 0 to 1. Default: 0, 0, 0.
   */
  vtkSetVector3Macro(Background, double);
  vtkGetVector3Macro(Background, double);
  ///@}

  ///@{
  /**
   * Whether the output has more than Color: RGBA, and under LAW_XRAY Sum and Samples. Default: off.
   */
  vtkSetMacro(OutputFloats, bool);
  vtkGetMacro(OutputFloats, bool);
  vtkBooleanMacro(OutputFloats, bool);
  ///@}

  ///@{
  /**
   * The length of ray that a sample stands for, in world units; 0: the edge of a cube as large as
   * what a voxel takes. Pictures do not depend on it, but Sum, Samples and Window do. Default: 0.
   */
  vtkSetMacro(SampleDistance, double);
  vtkGetMacro(SampleDistance, double);
  ///@}

  ///@{
  /**
   * How a vtkImageData is compressed; see the properties of vtkHartleyVolumeWriter, with the same
   * defaults. Goal: of vtkHartleyVolumeWriter::GoalType. Without effect on files.
   */
  vtkSetMacro(BlockSize, int);
  vtkGetMacro(BlockSize, int);
  vtkSetClampMacro(Goal, int, 0, 3);
  vtkGetMacro(Goal, int);
  vtkSetMacro(Quality, double);
  vtkGetMacro(Quality, double);
  vtkSetMacro(MaximumError, double);
  vtkGetMacro(MaximumError, double);
  vtkSetMacro(PSNR, double);
  vtkGetMacro(PSNR, double);
  vtkSetMacro(Rate, double);
  vtkGetMacro(Rate, double);
  vtkSetMacro(FrequencyWeight, double);
  vtkGetMacro(FrequencyWeight, double);
  ///@}

  /**
   * By which way the picture of a block is made of its coefficients.
   */
  enum MethodType
  {
    METHOD_AUTOMATIC = 0, ///< METHOD_BASIS for blocks of up to 16 voxels along each axis, else
                          ///< METHOD_SLICE
    METHOD_BASIS = 1,     ///< the sum of the pictures of its basis functions, shared by all blocks
    METHOD_SLICE = 2      ///< a slice through its spectrum, transformed back in two dimensions
  };

  ///@{
  /**
   * See MethodType. Default: METHOD_AUTOMATIC.
   */
  vtkSetClampMacro(Method, int, METHOD_AUTOMATIC, METHOD_SLICE);
  vtkGetMacro(Method, int);
  ///@}

  /**
   * How values between the points of a spectrum are found, by METHOD_SLICE.
   */
  enum KernelType
  {
    KERNEL_KAISER_BESSEL = 0, ///< nearly exact
    KERNEL_TRILINEAR = 1      ///< as in Yang's dissertation, for comparison
  };

  ///@{
  /**
   * See KernelType. Default: KERNEL_KAISER_BESSEL.
   */
  vtkSetClampMacro(Kernel, int, KERNEL_KAISER_BESSEL, KERNEL_TRILINEAR);
  vtkGetMacro(Kernel, int);
  ///@}

  ///@{
  /**
   * Size of a block with the zeros around it, for METHOD_SLICE, in sizes of the block: 1 to 8.
   * Default: 2.
   */
  vtkSetMacro(Padding, double);
  vtkGetMacro(Padding, double);
  ///@}

  ///@{
  /**
   * How much memory may be kept from one picture to the next, in MiB: the coefficients of a file's
   * chunks, or, by METHOD_SLICE, spectra of blocks. What does not fit is decoded, or made, anew for
   * each picture. Default: 1024.
   */
  vtkSetClampMacro(MemoryBudget, int, 0, VTK_INT_MAX);
  vtkGetMacro(MemoryBudget, int);
  ///@}

  ///@{
  /**
   * What it took to draw the last picture: blocks, coefficients that were added up, and the method
   * (of MethodType).
   */
  vtkIdType GetNumberOfBlocksDrawn();
  vtkTypeUInt64 GetNumberOfTerms();
  int GetMethodUsed();
  ///@}

  /**
   * How often a vtkImageData was compressed or a file opened, since this object was made.
   */
  vtkGetMacro(NumberOfVolumes, vtkTypeUInt64);

  /**
   * Bytes read from the input's file since it was opened; 0 for other inputs.
   */
  vtkTypeUInt64 GetBytesRead();

  /**
   * Range of the volume that was drawn last, before it was compressed.
   */
  void GetRange(double range[2]) VTK_SIZEHINT(2);

  /**
   * Modified, too, when the camera or the property is.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkHartleyProjection();
  ~vtkHartleyProjection() override;

  /**
   * The algorithm whose file is drawn if it is a vtkHartleyVolumeReader.
   */
  virtual vtkAlgorithm* FindProducer();

  /**
   * Gives colours and opacities to a property that is used where none was set, as SetProperty
   * describes it. Range: of the volume; diagonal: its own, in world units, above 0.
   */
  virtual void FillDefaultProperty(
    vtkVolumeProperty* property, const double range[2], double diagonal);

  vtkExecutive* CreateDefaultExecutive() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  double ViewDirection[3] = { 0, 0, -1 };
  double ViewUp[3] = { 0, 1, 0 };
  double Zoom = 1;
  int Size[2] = { 512, 512 };
  int Law = LAW_TRANSFER_FUNCTION;
  double Extinction = 0;
  bool UseZero = false;
  double Zero = 0;
  double Window[2] = { 0, 0 };
  bool UseBackground = false;
  double Background[3] = { 0, 0, 0 };
  bool OutputFloats = false;
  double SampleDistance = 0;
  int BlockSize = 8;
  int Goal = 0;
  double Quality = 60;
  double MaximumError = 0;
  double PSNR = 50;
  double Rate = 1;
  double FrequencyWeight = 0;
  int Method = METHOD_AUTOMATIC;
  int Kernel = KERNEL_KAISER_BESSEL;
  double Padding = 2;
  int MemoryBudget = 1024;
  vtkTypeUInt64 NumberOfVolumes = 0;

private:
  vtkHartleyProjection(const vtkHartleyProjection&) = delete;
  void operator=(const vtkHartleyProjection&) = delete;

  class vtkPipeline;
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
