// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunHartleyEncoding
 * @brief How volumes are encoded as Hartley coefficients.
 *
 * vtkGatunHartleyWriter and vtkGatunHartleyEncoder own one each, and may share one. A volume is
 * divided into blocks, which are transformed independently. The coefficients are quantized with a
 * step that is determined by RateControl and the property that belongs to it.
 *
 * Values beyond a range are set to its nearest limit. A value that is not a number is an error of
 * the writer or encoder.
 *
 * @sa vtkGatunHartleyWriter vtkGatunHartleyEncoder
 */

#ifndef vtkGatunHartleyEncoding_h
#define vtkGatunHartleyEncoding_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkObject.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKGATUNIO_EXPORT vtkGatunHartleyEncoding : public vtkObject
{
public:
  static vtkGatunHartleyEncoding* New();
  vtkTypeMacro(vtkGatunHartleyEncoding, vtkObject);
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

protected:
  vtkGatunHartleyEncoding() = default;
  ~vtkGatunHartleyEncoding() override = default;

  int BlockSize = 8;
  int RateControl = RATE_CONTROL_QUALITY;
  double Quality = 60;
  double RMSError = 0;
  double PSNR = 50;
  double BitsPerVoxel = 1;
  double FrequencyWeight = 0;

private:
  vtkGatunHartleyEncoding(const vtkGatunHartleyEncoding&) = delete;
  void operator=(const vtkGatunHartleyEncoding&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
