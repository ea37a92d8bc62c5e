// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunMergeBlocks
 * @brief Merges the blocks of a composite dataset, or several pieces, into one unstructured grid.
 *
 * Input: one or more connections, each a vtkDataSet (a piece) or a vtkCompositeDataSet (blocks).
 *
 * Output: a vtkUnstructuredGrid with the points and cells of all inputs, in their order. Points are
 * float if they are float in all blocks, otherwise double. If an input is composite, the output
 * also has:
 *
 *  - the cell array BlockId (int), the index of the block in traversal order, starting at 0.
 *    Missing datasets are not counted. The partitions of a vtkPartitionedDataSet form one block;
 *  - the point array BlockId, only if there are points that no cell uses;
 *  - the field array BlockNames (string), the names of the blocks in the order of BlockId. Unnamed
 *    blocks are called "Block" followed by their index;
 *  - the field array BlockArrays (string, five components), one tuple for each array of each block:
 *    the block, "Point" or "Cell", the attributes that it is active as (such as "Scalars"), its
 * name in the output, and its name in the block. vtkGatunSplitBlocks gives the blocks back.
 *
 * Blocks may have cells of any dimension, such as side sets and boundary patches. Point and cell
 * arrays are matched by name, type and number of components. Where a block lacks an array, its
 * values are filled with NaN (float, double) or 0 and a warning is issued; string arrays that some
 * blocks lack are dropped, with a warning. Arrays of one name that differ in type or number of
 * components stay apart: all but the first get a number behind their name, with a warning, and so
 * do arrays of blocks that are called BlockId. Arrays without a name get that of the attribute
 * that they are active as, or else Array, with a warning. Field arrays that are equal in all blocks
 * that have them are there once. Others are called "NAME (BLOCK)".
 *
 * Points of different blocks stay separate even where they coincide, except in two cases: if all
 * blocks have global point ids (vtkDataSetAttributes::GetGlobalIds), points are merged by these
 * ids, with a warning that counts them; if MergeCoincidentPoints is on, they are merged by
 * coordinates. A merged point has the values of one of the blocks that have the array. Ghost cells
 * (DUPLICATECELL in vtkGhostType) are dropped together with the points that only they use.
 *
 * Processes: with Controller, each process gets the blocks that it has as one grid. Blocks have the
 * same place in the tree everywhere and may be missing or in parts. Numbers, names and arrays of
 * blocks are global, as in a serial run. Points of different processes are
 * not merged; vtkGatunWriter does that. Field arrays are those of the process's own blocks. An
 * error of one process is one of all.
 *
 * Cost: memory for the output, twice that where points are merged; one thread. Time steps pass
 * through, so that the filter can connect a vtkExodusIIReader to a vtkGatunWriter.
 *
 * *Errors.* Errors are reported by vtkErrorMacro and GetErrorCode; the output is then empty. Cells
 * of blocks that name missing points or have a wrong size: vtkGatunErrorCode::InvalidInputError. No
 * memory: vtkErrorCode::UnknownError. No exception is thrown.
 *
 * @warning Blocks with displaced points (vtkExodusIIReader::ApplyDisplacements) move from one time
 * step to the next; vtkGatunWriter then writes points that move.
 *
 * @sa vtkGatunSplitBlocks vtkGatunWriter vtkAppendFilter
 */

#ifndef vtkGatunMergeBlocks_h
#define vtkGatunMergeBlocks_h

#include "vtkGatunIOModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

namespace gatun
{
class BlockList;
}

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkMultiProcessController;

class VTKGATUNIO_EXPORT vtkGatunMergeBlocks : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkGatunMergeBlocks* New();
  vtkTypeMacro(vtkGatunMergeBlocks, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Merge points with equal coordinates, also within a block. The merged point keeps the values of
   * one of them. Default: off.
   */
  vtkSetMacro(MergeCoincidentPoints, bool);
  vtkGetMacro(MergeCoincidentPoints, bool);
  vtkBooleanMacro(MergeCoincidentPoints, bool);
  ///@}

  ///@{
  /**
   * The processes that have the blocks. All must have the same inputs and update the filter at the
   * same time. Null: this process alone. Default: null.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkGatunMergeBlocks();
  ~vtkGatunMergeBlocks() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  bool MergeCoincidentPoints = false;
  vtkMultiProcessController* Controller = nullptr;

private:
  /** Merges the connections of port 0. */
  void Merge(vtkInformationVector* input, vtkUnstructuredGrid* output);

  /** Merges the blocks of this process, when all processes know all blocks. */
  void Merge(const gatun::BlockList& blocks, vtkUnstructuredGrid* output);

  vtkGatunMergeBlocks(const vtkGatunMergeBlocks&) = delete;
  void operator=(const vtkGatunMergeBlocks&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
