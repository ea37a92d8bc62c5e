// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunHartleyReader
 * @brief Reads a volume that is stored as Hartley coefficients (`.ghv`).
 *
 * Output: a vtkImageData with the extent, origin, spacing and direction that vtkGatunHartleyWriter
 * was given, and one point array of the original name and type, which is the active scalars. Values
 * are rounded to that type and clamped to the range of the original values.
 *
 * Any part of the extent can be requested (vtkAlgorithm::UpdateExtent). The reader then decodes the
 * chunks of up to 64^3 voxels that intersect it.
 *
 * The reader publishes its open file under vtkGatunHartleyCoefficients::COEFFICIENTS() in the
 * information of its output port. vtkGatunHartleyProjection draws these coefficients without
 * requesting voxels.
 *
 * Each update checks whether the file has changed on disk and, if so, reads it again.
 *
 * *Cost.* Memory: the output, and one chunk for each thread. Decoded chunks are not kept.
 *
 * *Errors.* Reported by vtkErrorMacro with a message that begins with the file's name, and by
 * GetErrorCode, as for vtkGatunReader. The output is then empty.
 *
 * @sa vtkGatunHartleyWriter vtkGatunHartleyProjection
 */

#ifndef vtkGatunHartleyReader_h
#define vtkGatunHartleyReader_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkTable;

class VTKGATUNIO_EXPORT vtkGatunHartleyReader : public vtkImageAlgorithm
{
public:
  static vtkGatunHartleyReader* New();
  vtkTypeMacro(vtkGatunHartleyReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the file to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Returns 1 if the file has the signature of a `.ghv` file of any version, otherwise 0.
   */
  virtual int CanReadFile(VTK_FILEPATH const char* name);

  ///@{
  /**
   * Extension and name of the file type, for lists of readers.
   */
  virtual const char* GetFileExtensions() { return ".ghv"; }
  virtual const char* GetDescriptiveName() { return "Hartley volume"; }
  ///@}

  ///@{
  /**
   * Properties of the file, after UpdateInformation; zeros if there is no readable file. Block
   * size: voxels along each axis, or 0 for one block of the whole volume. Rate control: the mode,
   * see vtkGatunHartleyEncoding::RateControlType, and its value. Lossless: whether it was written
   * with an RMS error of 0.
   */
  int GetBlockSize();
  int GetRateControl();
  double GetRateControlValue();
  bool GetLossless();
  vtkIdType GetNumberOfBlocks();
  vtkIdType GetNumberOfChunks();
  vtkTypeUInt64 GetFileBytes();
  double GetBitsPerVoxel();
  ///@}

  ///@{
  /**
   * Root mean square and largest error of the voxels, measured when the file was written. After
   * UpdateInformation.
   */
  double GetMeasuredRMSError();
  double GetMaximumError();
  ///@}

  /**
   * Smallest and largest value before compression, after UpdateInformation.
   */
  void GetRange(double range[2]) VTK_SIZEHINT(2);

  /**
   * Statistics in the columns of a table of one row:
   *
   *  - BytesRead: bytes read since the file was opened, also for those who draw its coefficients; 0
   *    without an open file.
   *
   * The next call returns another table.
   */
  vtkTable* GetStatistics();

  /**
   * Also checks whether the file has changed on disk.
   */
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inInfoVec,
    vtkInformationVector* outInfoVec, int requestFromOutputPort, vtkMTimeType* mtime) override;

protected:
  vtkGatunHartleyReader();
  ~vtkGatunHartleyReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* FileName = nullptr;

private:
  vtkGatunHartleyReader(const vtkGatunHartleyReader&) = delete;
  void operator=(const vtkGatunHartleyReader&) = delete;

  void Fail(vtkInformationVector* outputVector) noexcept;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
