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
 * Blocks of the volume are transformed independently, and their coefficients are quantized, as the
 * Encoding says.
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
 * @warning The values change unless the encoding uses RATE_CONTROL_RMS_ERROR with an RMSError of 0.
 *
 * @sa vtkGatunHartleyEncoding vtkGatunHartleyReader vtkGatunHartleyEncoder
 * vtkGatunHartleyProjection
 */

#ifndef vtkGatunHartleyWriter_h
#define vtkGatunHartleyWriter_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkGatunUpdateResult.h"
#include "vtkWriter.h"

#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkGatunHartleyEncoding;
class vtkImageData;
class vtkTable;

class VTKGATUNIO_EXPORT vtkGatunHartleyWriter : public vtkWriter
{
public:
  static vtkGatunHartleyWriter* New();
  vtkTypeMacro(vtkGatunHartleyWriter, vtkWriter);
  using vtkAlgorithm::Update;
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the file to write. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * How the volume is encoded: block size and rate control. Its changes modify the writer. Null
   * sets a new one.
   */
  void SetEncoding(vtkGatunHartleyEncoding* encoding);
  vtkGatunHartleyEncoding* GetEncoding();
  ///@}

  /**
   * Updates the input and writes the file. Returns 1, or 0 and sets an error code.
   */
  int Write() override;

  ///@{
  /**
   * Same as Write.
   */
  VTK_GATUN_UPDATE_RESULT Update() override;
  VTK_GATUN_UPDATE_RESULT Update(int port) override;
  ///@}

  /**
   * Statistics of the file that was written last, in the columns of a table of one row:
   *
   *  - FileBytes: size of the file
   *  - RMSError: root mean square error of the voxels
   *  - MaximumError: largest error of the voxels
   *
   * The next call returns another table.
   */
  vtkTable* GetStatistics();

  /**
   * Includes the encoding.
   */
  vtkMTimeType GetMTime() override;

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

private:
  vtkGatunHartleyWriter(const vtkGatunHartleyWriter&) = delete;
  void operator=(const vtkGatunHartleyWriter&) = delete;

  void WriteVolume(vtkImageData* image);
  void HandleFailure() noexcept;

  class vtkInternals;
  const std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
