// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunHartleyWriter
 * @brief Writes a vtkImageData as quantized Hartley coefficients (`.ghv`).
 *
 * Input: a vtkImageData of any size with a point array of one component and any numeric type except
 * bits. SetInputArrayToProcess selects the array; the default is the active point scalars. Values
 * must be finite. The extent, origin, spacing, direction, array name and type are stored. Other
 * arrays and field data are not stored, and blanking is ignored.
 *
 * The volume is divided into blocks, which are transformed independently. The coefficients are
 * quantized with a step that is determined by RateControl and the property that belongs to it.
 *
 * The file appears under its name when it is complete. After an error or an abort, an existing file
 * is unchanged. A read-only file is not replaced.
 *
 * *Cost.* Memory: the nonzero coefficients, 8 bytes each. Uses all threads; the
 * bytes of the file do not depend on their number.
 *
 * *Errors.* Reported by vtkErrorMacro with a message that begins with the file's name. Write then
 * returns 0, and GetErrorCode is set as for vtkGatunWriter.
 *
 * @par Background
 * C. Yang: On-the-fly processing of compressed volume data, 2001, section 3.
 *
 * @warning The values change unless RATE_CONTROL_RMS_ERROR is used with an RMSError of 0.
 *
 * @sa vtkGatunHartleyReader vtkGatunHartleyEncoder vtkGatunHartleyProjection
 */

#ifndef vtkGatunHartleyWriter_h
#define vtkGatunHartleyWriter_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkWriter.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkImageData;

class VTKGATUNIO_EXPORT vtkGatunHartleyWriter : public vtkWriter
{
public:
  static vtkGatunHartleyWriter* New();
  vtkTypeMacro(vtkGatunHartleyWriter, vtkWriter);
  using vtkAlgorithm::Update;
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
   * Name of the file to write. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

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
   * Size of the file in bits per voxel, 0.001 to 64, met within 1 % unless fewer bits suffice.
   * Default: 1.
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

  /**
   * Updates the input and writes the file. Returns 1, or 0 and sets an error code.
   */
  int Write() override;

  ///@{
  /**
   * Same as Write.
   */
  void Update() override;
  void Update(int port) override;
  ///@}

  ///@{
  /**
   * Statistics of the file that was written last: its size, and the root mean square and the
   * largest error of its voxels.
   */
  vtkGetMacro(FileBytes, vtkTypeUInt64);
  vtkGetMacro(MeasuredRMSError, double);
  vtkGetMacro(MaximumError, double);
  ///@}

protected:
  vtkGatunHartleyWriter();
  ~vtkGatunHartleyWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * Not used: RequestData writes.
   */
  void WriteData() override {}

  char* FileName = nullptr;
  int BlockSize = 8;
  int RateControl = RATE_CONTROL_QUALITY;
  double Quality = 60;
  double RMSError = 0;
  double PSNR = 50;
  double BitsPerVoxel = 1;
  double FrequencyWeight = 0;

  vtkTypeUInt64 FileBytes = 0;
  double MeasuredRMSError = 0;
  double MaximumError = 0;

private:
  vtkGatunHartleyWriter(const vtkGatunHartleyWriter&) = delete;
  void operator=(const vtkGatunHartleyWriter&) = delete;

  void WriteVolume(vtkImageData* image);
  void HandleFailure() noexcept;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
