// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunMergeBlocks
 * @brief Merges the blocks of a composite dataset, or several pieces, into one vtkUnstructuredGrid.
 *
 * Input, one or more connections: any vtkDataSet (a piece), any vtkCompositeDataSet (blocks).
 *
 * Output: all points and cells, one input after the other. Points keep their type, float or double,
 * if all blocks have the same type; otherwise they are double. With a composite input there are
 * also
 *
 *  - the cell array BlockId (int): the number of the block, from 0 in the order of traversal,
 * missing datasets not counted; the partitions of a vtkPartitionedDataSet are one block;
 *  - the field array BlockNames (string): the names of the blocks in the order of BlockId; a block
 *    without a name is called "Block" and its number.
 *
 * Point and cell arrays are identified by name, type and number of components. If some blocks lack
 * an array, its values there are NaN (float, double) or 0, with a warning; string arrays are left
 * out in that case. Field arrays come from the composite dataset and, with new names, from the
 * blocks.
 *
 * Points of different blocks stay separate even if they coincide, unless all blocks have global
 * point ids (vtkDataSetAttributes::GetGlobalIds), by which they are then merged, or
 * MergeCoincidentPoints is on. Ghost cells (DUPLICATECELL in vtkGhostType) are left out, with the
 * points that only they use.
 *
 * *Cost.* Memory for the output, twice if points are merged; one thread. Time requests are passed
 * on: the filter may stand between vtkExodusIIReader and vtkGatunWriter.
 *
 * *Errors.* Lack of memory is reported by vtkErrorMacro; GetErrorCode is then
 * vtkErrorCode::UnknownError, and the output is empty. No exception is thrown.
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

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKGATUNIO_EXPORT vtkGatunMergeBlocks : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkGatunMergeBlocks* New();
  vtkTypeMacro(vtkGatunMergeBlocks, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether to merge points with equal coordinates, also within a block. The merged point keeps the
   * values of one of them. Default: off.
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
  /** input: the information of port 0. */
  void Merge(vtkInformationVector* input, vtkUnstructuredGrid* output);

  vtkGatunMergeBlocks(const vtkGatunMergeBlocks&) = delete;
  void operator=(const vtkGatunMergeBlocks&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
