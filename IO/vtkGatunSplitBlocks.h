// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunSplitBlocks
 * @brief Splits a grid into the blocks that vtkGatunMergeBlocks merged.
 *
 * Input: a vtkUnstructuredGrid with cells of any type. These arrays describe its blocks:
 *
 *  - the cell array BlockId: one integer per cell, the index of its block. Without it, all cells
 * are in one block;
 *  - the point array BlockId (optional): the blocks of points that no cell uses;
 *  - the field array BlockNames (string): a name per block;
 *  - the field array BlockArrays (string, five components): the arrays that each block has. Its
 *    components are described in vtkGatunMergeBlocks.
 *
 * Output: a vtkPartitionedDataSetCollection with one vtkPartitionedDataSet per block, which
 * consists of one vtkUnstructuredGrid and has its name in its metadata
 * (vtkCompositeDataSet::NAME()). A block has
 *
 *  - its cells in the order of the input;
 *  - the points that its cells use, in the order of the input, and the unused points that the point
 *    array assigns to it. A point that several blocks use is in each of them. If the input is one
 *    block, all points are in it;
 *  - the point and cell arrays that BlockArrays lists for the block, with their names, order and
 *    active attributes. Arrays that BlockArrays lists for other blocks only, and which are filled
 * up in this one, are left out. Arrays that it does not list at all, such as global ids from a
 *    reader, follow behind. The arrays BlockId are left out.
 *
 * The collection has the field arrays of the input except BlockNames and BlockArrays. A nested
 * composite dataset that was merged comes back as a flat collection of its blocks.
 *
 * Each named block exists, even if it has no cells, so that in parallel all processes have the same
 * blocks. Ghost cells stay ghost cells of their block. Cells whose BlockId has no name, including
 * negative values, form further blocks in the order of these values, called "Block" followed by the
 * value. There is a warning if other blocks have names. In parallel, the processes may have
 * different blocks then.
 *
 * Cost: memory for the output; one thread; time proportional to the size of the grid, apart from
 * sorting point ids within each block.
 *
 * *Errors.* Errors are reported by vtkErrorMacro and GetErrorCode; the output is then empty. A
 * BlockId that is not an integer array of one component, arrays of a wrong length, and cells that
 * name missing points or have a wrong size: vtkGatunErrorCode::InvalidInputError. No memory:
 * vtkErrorCode::UnknownError. BlockNames and BlockArrays of a wrong type are ignored with a
 * warning. No exception is thrown.
 *
 * *Abort.* AbortExecute is checked after each block. The output is then empty and GetErrorCode is
 * vtkGatunErrorCode::AbortedError.
 *
 * @sa vtkGatunMergeBlocks vtkGatunReader
 */

#ifndef vtkGatunSplitBlocks_h
#define vtkGatunSplitBlocks_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkPartitionedDataSetCollectionAlgorithm.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkUnstructuredGrid;

class VTKGATUNIO_EXPORT vtkGatunSplitBlocks : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  static vtkGatunSplitBlocks* New();
  vtkTypeMacro(vtkGatunSplitBlocks, vtkPartitionedDataSetCollectionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkGatunSplitBlocks() = default;
  ~vtkGatunSplitBlocks() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  void Split(vtkUnstructuredGrid* input, vtkPartitionedDataSetCollection* output);

  vtkGatunSplitBlocks(const vtkGatunSplitBlocks&) = delete;
  void operator=(const vtkGatunSplitBlocks&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
