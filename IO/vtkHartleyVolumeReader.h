// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHartleyVolumeReader
 * @brief Reads a volume that is stored as Hartley coefficients (`.ghv`), as voxels.
 *
 * Output: a vtkImageData with the extent, origin, spacing and direction that vtkHartleyVolumeWriter
 * was given, and one point array of the name and type of then, which are the active scalars. Values
 * are rounded to the type, and stay within the volume's range of before.
 *
 * Any part of the extent can be asked for (vtkAlgorithm::UpdateExtent): only the chunks of up to
 * 64^3 voxels that it touches are read and decoded.
 *
 * vtkHartleyProjection behind this reader draws the file itself, and no voxel is made for it.
 *
 * Each update looks whether the file was replaced or rewritten since, and then reads it anew.
 *
 * *Cost.* Memory: the output, and a chunk for each thread. Nothing decoded is kept.
 *
 * *Errors.* Reported by vtkErrorMacro with a message that begins with the file's name; GetErrorCode
 * is as vtkGatunReader has it. The output is then empty.
 *
 * @sa vtkHartleyVolumeWriter vtkHartleyProjection
 */

#ifndef vtkHartleyVolumeReader_h
#define vtkHartleyVolumeReader_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkImageAlgorithm.h"

#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKGATUNIO_EXPORT vtkHartleyVolumeReader : public vtkImageAlgorithm
{
public:
  static vtkHartleyVolumeReader* New();
  vtkTypeMacro(vtkHartleyVolumeReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the file to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Whether the file begins as a `.ghv` file does, of whatever version: 1 or 0.
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
   * What the file tells of itself, after UpdateInformation; zeros without a readable file. Block
   * size: voxels along each axis; 0 for one block of the whole volume. Goal: of
   * vtkHartleyVolumeWriter::GoalType, and the value that belongs to it. Lossless: whether it was
   * written with an error of 0.
   */
  int GetBlockSize();
  int GetGoal();
  double GetGoalValue();
  bool GetLossless();
  vtkIdType GetNumberOfBlocks();
  vtkIdType GetNumberOfChunks();
  vtkTypeUInt64 GetFileBytes();
  double GetBitsPerVoxel();
  ///@}

  /**
   * The range of the values before they were compressed, after UpdateInformation.
   */
  void GetRange(double range[2]) VTK_SIZEHINT(2);

  /**
   * Bytes read from the file since this reader opened it. 0 without an open file.
   */
  vtkTypeUInt64 GetBytesRead();

  /**
   * Looks, too, whether the file has changed on disk.
   */
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inInfoVec,
    vtkInformationVector* outInfoVec, int requestFromOutputPort, vtkMTimeType* mtime) override;

protected:
  vtkHartleyVolumeReader();
  ~vtkHartleyVolumeReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* FileName = nullptr;

private:
  vtkHartleyVolumeReader(const vtkHartleyVolumeReader&) = delete;
  void operator=(const vtkHartleyVolumeReader&) = delete;

  void Fail(vtkInformationVector* outputVector) noexcept;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
