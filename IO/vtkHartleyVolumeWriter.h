// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHartleyVolumeWriter
 * @brief Writes a vtkImageData as quantised Hartley coefficients (`.ghv`).
 *
 * Input: a vtkImageData, of whatever size, with a point array of one component of any numeric type
 * but bits. Which array: SetInputArrayToProcess, by default the active point scalars. Values must
 * be finite. Extent, origin, spacing, direction, and the array's name and type are kept; other
 * arrays and field data are not, and blanked points are points like others.
 *
 * The volume is cut into blocks, each of which is transformed by itself, and the coefficients are
 * quantised: how finely, Goal and the property of the same name tell. See HartleyQuality.
 *
 * The file appears under its name once it is complete; after an error or an abort, a file that was
 * there before is as it was. One that is read-only is replaced with ReplaceReadOnly only.
 *
 * *Cost.* Memory: the coefficients that are not zero, 8 bytes each. All threads of vtkSMPTools are
 * used; the bytes written do not depend on their number.
 *
 * *Errors.* Reported by vtkErrorMacro with a message that begins with the file's name; Write then
 * returns 0, and GetErrorCode is as vtkGatunWriter has it.
 *
 * @par Background
 * C. Yang: On-the-fly processing of compressed volume data, 2001, section 3.
 *
 * @warning Unless GOAL_ERROR is used with an error of 0, the values that come back differ.
 *
 * @sa vtkHartleyVolumeReader vtkHartleyProjection
 */

#ifndef vtkHartleyVolumeWriter_h
#define vtkHartleyVolumeWriter_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkWriter.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkImageData;

class VTKGATUNIO_EXPORT vtkHartleyVolumeWriter : public vtkWriter
{
public:
  static vtkHartleyVolumeWriter* New();
  vtkTypeMacro(vtkHartleyVolumeWriter, vtkWriter);
  using vtkAlgorithm::Update;
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What tells how well the volume is kept.
   */
  enum GoalType
  {
    GOAL_QUALITY = 0, ///< Quality
    GOAL_ERROR = 1,   ///< MaximumError
    GOAL_PSNR = 2,    ///< PSNR
    GOAL_RATE = 3     ///< Rate
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
   * Voxels of a block along each axis, 2 to 64, or 0: one block for the whole volume. Others are an
   * error. Small blocks are drawn with better opacities, larger ones take fewer bits. Default: 8.
   */
  vtkSetMacro(BlockSize, int);
  vtkGetMacro(BlockSize, int);
  ///@}

  ///@{
  /**
   * See GoalType. Default: GOAL_QUALITY.
   */
  vtkSetClampMacro(Goal, int, GOAL_QUALITY, GOAL_RATE);
  vtkGetMacro(Goal, int);
  void SetGoalToQuality() { this->SetGoal(GOAL_QUALITY); }
  void SetGoalToError() { this->SetGoal(GOAL_ERROR); }
  void SetGoalToPSNR() { this->SetGoal(GOAL_PSNR); }
  void SetGoalToRate() { this->SetGoal(GOAL_RATE); }
  ///@}

  ///@{
  /**
   * Quality, 1 to 100: ten more make the steps of the quantiser half as wide. Default: 60.
   */
  vtkSetMacro(Quality, double);
  vtkGetMacro(Quality, double);
  ///@}

  ///@{
  /**
   * Root mean square error of the voxels, at most, in their unit; 0: without loss, as far as a
   * transform in floating-point numbers can be. Default: 0.
   */
  vtkSetMacro(MaximumError, double);
  vtkGetMacro(MaximumError, double);
  ///@}

  ///@{
  /**
   * Peak signal to noise ratio, at least, in dB: 20 log10(range / root mean square error). Default:
   * 50.
   */
  vtkSetMacro(PSNR, double);
  vtkGetMacro(PSNR, double);
  ///@}

  ///@{
  /**
   * Bits a voxel of the whole file, within 1 %, or fewer where that is all it takes. Default: 1.
   */
  vtkSetMacro(Rate, double);
  vtkGetMacro(Rate, double);
  ///@}

  ///@{
  /**
   * How much coarser the highest frequencies are quantised than the lowest, 0 (not at all) to 4.
   * Default: 0.
   */
  vtkSetMacro(FrequencyWeight, double);
  vtkGetMacro(FrequencyWeight, double);
  ///@}

  ///@{
  /**
   * Whether to replace a file that is read-only. Default: off.
   */
  vtkSetMacro(ReplaceReadOnly, bool);
  vtkGetMacro(ReplaceReadOnly, bool);
  vtkBooleanMacro(ReplaceReadOnly, bool);
  ///@}

  /**
   * Updates the input and writes the file. Returns 1, or 0 and an error code.
   */
  int Write() override;

  ///@{
  /**
   * The same as Write.
   */
  void Update() override;
  void Update(int port) override;
  ///@}

  ///@{
  /**
   * What was written last: bytes of the file, and root mean square and largest error of the voxels
   * that it gives back.
   */
  vtkGetMacro(FileBytes, vtkTypeUInt64);
  vtkGetMacro(RootMeanSquareError, double);
  vtkGetMacro(LargestError, double);
  ///@}

protected:
  vtkHartleyVolumeWriter();
  ~vtkHartleyVolumeWriter() override;

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
  int Goal = GOAL_QUALITY;
  double Quality = 60;
  double MaximumError = 0;
  double PSNR = 50;
  double Rate = 1;
  double FrequencyWeight = 0;
  bool ReplaceReadOnly = false;

  vtkTypeUInt64 FileBytes = 0;
  double RootMeanSquareError = 0;
  double LargestError = 0;

private:
  vtkHartleyVolumeWriter(const vtkHartleyVolumeWriter&) = delete;
  void operator=(const vtkHartleyVolumeWriter&) = delete;

  void WriteVolume(vtkImageData* image);
  void HandleFailure() noexcept;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
