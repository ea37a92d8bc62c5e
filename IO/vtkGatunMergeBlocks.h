// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunMergeBlocks
 * @brief Makes one vtkUnstructuredGrid of the blocks of a composite dataset, or of several pieces.
 *
 * Input, one or more connections: any vtkDataSet (a piece), any vtkCompositeDataSet (blocks).
 *
 * Output: all points and cells, one input after the other. Points keep their type if all blocks
 * have the same, float or double, else they are double. If there is a composite input:
 *
 *  - the cell array BlockId (int) tells the block: 0 for the first dataset in the order of
 *    traversal, missing datasets not counted; partitions of a vtkPartitionedDataSet are one block;
 *  - the field array BlockNames (string) has the names of the blocks, in the order of BlockId; a
 *    block without a name is called "Block" and its number.
 *
 * Point and cell arrays are known by name, type and number of components. One that some blocks lack
 * is filled up there, with NaN (float, double) or 0, and a warning says so; string arrays are left
 * out then. Field arrays come from the composite dataset, and from the blocks where the name is
 * new.
 *
 * Points: those of different blocks stay apart even where they coincide, unless all blocks have
 * global point ids (vtkDataSetAttributes::GetGlobalIds), by which they are then merged, or unless
 * MergeCoincidentPoints is on. Ghost cells (DUPLICATECELL in vtkGhostType) are left out, and points
 * that only they use.
 *
 * Cost: memory for the output, twice where points are merged; one thread. Time goes through: the
 * filter may stand between vtkExodusIIReader and vtkGatunWriter.
 *
 * *Errors.* Too little memory is reported by vtkErrorMacro; GetErrorCode is then
 * vtkErrorCode::UnknownError, and the output is empty. Nothing is thrown.
 *
 * @warning Blocks with displaced points (vtkExodusIIReader::ApplyDisplacements) change from one
 * time step to the next, so vtkGatunWriter refuses them.
 *
 * @sa vtkGatunWriter vtkAppendFilter
 */

#ifndef vtkGatunMergeBlocks_h
#define vtkGatunMergeBlocks_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

class VTKGATUNIO_EXPORT vtkGatunMergeBlocks : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkGatunMergeBlocks* New();
  vtkTypeMacro(vtkGatunMergeBlocks, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether to make one of points whose coordinates are equal, also within a block; of their values
   * one is kept. Default: off.
   */
  vtkSetMacro(MergeCoincidentPoints, bool);
  vtkGetMacro(MergeCoincidentPoints, bool);
  vtkBooleanMacro(MergeCoincidentPoints, bool);
  ///@}

protected:
  vtkGatunMergeBlocks() = default;
  ~vtkGatunMergeBlocks() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  bool MergeCoincidentPoints = false;

private:
  /** input: that of port 0. */
  void Merge(vtkInformationVector* input, vtkUnstructuredGrid* output);

  vtkGatunMergeBlocks(const vtkGatunMergeBlocks&) = delete;
  void operator=(const vtkGatunMergeBlocks&) = delete;
};

#endif
