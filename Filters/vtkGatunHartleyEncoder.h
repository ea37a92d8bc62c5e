// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunHartleyEncoder
 * @brief Encodes a vtkImageData as quantized Hartley coefficients in memory.
 *
 * Input: a vtkImageData of any size with a point array of one component and any numeric type except
 * bits. SetInputArrayToProcess selects the array; the default is the active point scalars. Values
 * must be finite.
 *
 * Output: the input, passed by reference; a copy of a part of it if a part is requested. The
 * coefficients of the whole volume are published under vtkGatunHartleyCoefficients::COEFFICIENTS()
 * in the information of the output port, where vtkGatunHartleyProjection finds them. They are valid
 * after Update, until the input or a property changes.
 *
 * The volume is divided into blocks, which are transformed independently. The coefficients are
 * quantized with a step that is determined by RateControl and the property that belongs to it, with
 * the same results as vtkGatunHartleyWriter.
 *
 * *Pieces.* The whole input is requested and encoded, whatever part of the output is requested.
 *
 * *Cost.* Memory: the nonzero coefficients, 8 bytes each; while encoding also all coefficients of
 * volumes of up to 2^27 voxels, 8 bytes each. Uses all threads.
 *
 * *Errors.* Unsuitable arrays and values are reported by vtkErrorMacro and GetErrorCode, as for
 * vtkGatunHartleyWriter. The output is then empty and has no coefficients.
 *
 * @par Background
 * C. Yang: On-the-fly processing of compressed volume data, 2001, section 3.
 *
 * @sa vtkGatunHartleyProjection vtkGatunHartleyWriter
 */

#ifndef vtkGatunHartleyEncoder_h
#define vtkGatunHartleyEncoder_h

#include "vtkGatunFiltersModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class VTKGATUNFILTERS_EXPORT vtkGatunHartleyEncoder : public vtkImageAlgorithm
{
public:
  static vtkGatunHartleyEncoder* New();
  vtkTypeMacro(vtkGatunHartleyEncoder, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Quantity that determines how accurately the volume is stored.
   */
  enum RateControlType
  {
    RATE_CONTROL_QUALITY = 0,       ///< Quality
    RATE_CONTROL_RMS_ERROR = 1,     ///< RMSError
    RATE_CONTROL_PSNR = 2,          ///< PSNR
    RATE_CONTROL_BITS_PER_VOXEL = 3 ///< BitsPerVoxel
  };

  ///@{
  /**
   * Voxels of a block along each axis: 2 to 64, or 0 for one block of the whole volume. Small
   * blocks give more accurate opacities, large blocks need fewer bits. Default: 8.
   */
  void SetBlockSize(int size);
  vtkGetMacro(BlockSize, int);
  ///@}

  ///@{
  /**
   * See RateControlType. Default: RATE_CONTROL_QUALITY.
   */
  vtkSetClampMacro(RateControl, int, RATE_CONTROL_QUALITY, RATE_CONTROL_BITS_PER_VOXEL);
  vtkGetMacro(RateControl, int);
  void SetRateControlToQuality() { this->SetRateControl(RATE_CONTROL_QUALITY); }
  void SetRateControlToRMSError() { this->SetRateControl(RATE_CONTROL_RMS_ERROR); }
  void SetRateControlToPSNR() { this->SetRateControl(RATE_CONTROL_PSNR); }
  void SetRateControlToBitsPerVoxel() { this->SetRateControl(RATE_CONTROL_BITS_PER_VOXEL); }
  ///@}

  ///@{
  /**
   * Quality, 1 to 100. An increase of 10 halves the quantizer's step. Default: 60.
   */
  vtkSetClampMacro(Quality, double, 1, 100);
  vtkGetMacro(Quality, double);
  ///@}

  ///@{
  /**
   * Upper bound of the root mean square error of the voxels, in their unit. 0: lossless; integers
   * are then restored exactly and floating-point numbers up to rounding. Not negative. Default: 0.
   */
  vtkSetClampMacro(RMSError, double, 0, VTK_DOUBLE_MAX);
  vtkGetMacro(RMSError, double);
  ///@}

  ///@{
  /**
   * Lower bound of the peak signal-to-noise ratio, 20 log10(range / root mean square error), in dB:
   * 1 to 200. Default: 50.
   */
  vtkSetClampMacro(PSNR, double, 1, 200);
  vtkGetMacro(PSNR, double);
  ///@}

  ///@{
  /**
   * Size of the coefficients as a file in bits per voxel, 0.001 to 64, met within 1 % unless fewer
   * bits suffice. Default: 1.
   */
  vtkSetClampMacro(BitsPerVoxel, double, 0.001, 64);
  vtkGetMacro(BitsPerVoxel, double);
  ///@}

  ///@{
  /**
   * How much coarser the highest frequencies are quantized than the lowest, 0 (not at all) to 4.
   * Default: 0.
   */
  vtkSetClampMacro(FrequencyWeight, double, 0, 4);
  vtkGetMacro(FrequencyWeight, double);
  ///@}

  ///@{
  /**
   * Statistics of the last update: number of blocks and of nonzero coefficients.
   */
  vtkIdType GetNumberOfBlocks();
  vtkTypeUInt64 GetNumberOfCoefficients();
  ///@}

  /**
   * Smallest and largest voxel of the volume that was encoded last.
   */
  void GetRange(double range[2]) VTK_SIZEHINT(2);

  /**
   * Number of times that this object has encoded a volume.
   */
  vtkGetMacro(NumberOfEncodings, vtkTypeUInt64);

protected:
  vtkGatunHartleyEncoder();
  ~vtkGatunHartleyEncoder() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int BlockSize = 8;
  int RateControl = RATE_CONTROL_QUALITY;
  double Quality = 60;
  double RMSError = 0;
  double PSNR = 50;
  double BitsPerVoxel = 1;
  double FrequencyWeight = 0;
  vtkTypeUInt64 NumberOfEncodings = 0;

private:
  vtkGatunHartleyEncoder(const vtkGatunHartleyEncoder&) = delete;
  void operator=(const vtkGatunHartleyEncoder&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
