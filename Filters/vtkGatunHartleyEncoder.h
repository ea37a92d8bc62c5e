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
 * Blocks of the volume are transformed independently, and their coefficients are quantized, as the
 * Encoding says, with the same results as vtkGatunHartleyWriter.
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
 * @sa vtkGatunHartleyEncoding vtkGatunHartleyProjection vtkGatunHartleyWriter
 */

#ifndef vtkGatunHartleyEncoder_h
#define vtkGatunHartleyEncoder_h

#include "vtkGatunFiltersModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkGatunHartleyEncoding;
class vtkTable;

class VTKGATUNFILTERS_EXPORT vtkGatunHartleyEncoder : public vtkImageAlgorithm
{
public:
  static vtkGatunHartleyEncoder* New();
  vtkTypeMacro(vtkGatunHartleyEncoder, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How the volume is encoded: block size and rate control. Its changes modify the filter. Null
   * sets a new one.
   */
  void SetEncoding(vtkGatunHartleyEncoding* encoding);
  vtkGatunHartleyEncoding* GetEncoding();
  ///@}

  /**
   * Statistics in the columns of a table of one row:
   *
   *  - Blocks: blocks of the volume that was encoded last
   *  - Coefficients: its nonzero coefficients
   *  - Encodings: number of times that this object has encoded a volume
   *
   * The next call returns another table.
   */
  vtkTable* GetStatistics();

  /**
   * Smallest and largest voxel of the volume that was encoded last.
   */
  void GetRange(double range[2]) VTK_SIZEHINT(2);

  /**
   * Includes the encoding.
   */
  vtkMTimeType GetMTime() override;

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
