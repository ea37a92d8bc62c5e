// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBlockList_h
#define gatunBlockList_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkDataObject;
class vtkDataSet;
class vtkFieldData;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
class PartExchange;

/**
 * The datasets that vtkGatunMergeBlocks merges, and the blocks that they belong to.
 *
 * Several processes can have the blocks of a dataset. A block has the same place in the tree in all
 * processes that have a part of it; missing datasets take a place. Agree numbers the blocks of all
 * processes in the order of their places.
 */
class BlockList
{
public:
  /** isComposite: whether any input of any process is a composite dataset. */
  explicit BlockList(bool isComposite);
  ~BlockList();

  /** Adds the data of an input: a dataset, or the blocks of a tree. */
  void Add(int input, vtkDataObject* data);

  /** To be called when all inputs are added. Numbers the blocks and leaves the empty pieces out,
   * unless all are empty. Collective. Pieces of other processes are added, without points and cells
   * but with arrays, so that all processes have the same list. isSingle: whether all points of this
   * process are float. hasUnused: whether it has points that no cell uses. */
  void Agree(PartExchange& exchange, bool isSingle, bool hasUnused);

  /** What all processes have, known after Agree. */
  ///@{
  const std::vector<vtkSmartPointer<vtkDataSet>>& GetPieces() const { return this->Pieces; }
  const std::vector<int>& GetBlocks() const { return this->Blocks; } ///< of the pieces
  const std::vector<std::string>& GetNames() const { return this->Names; }
  bool IsComposite() const { return this->Composite; }
  bool IsSingle() const { return this->Single; }
  bool HasUnused() const { return this->Unused; }
  ///@}

  /** Whether this process has a piece, and not another one. */
  bool IsOwn(std::size_t piece) const { return this->Own[piece]; }

  /** Shallow copies of the pieces of this process. Before Agree, empty ones included. */
  std::vector<vtkSmartPointer<vtkDataSet>> GetOwnPieces() const;

  /** The field arrays of this process, known after Agree. Of those of trees, the first one of a
   * name counts. Those of datasets that differ have the names of their blocks behind their own. */
  vtkFieldData* GetField() const { return this->Field; }

  /** What was changed of the arrays of this process. */
  const std::set<std::string>& GetMessages() const { return this->Messages; }

private:
  /** The index of the input, of its child, of the child of that, and so on. */
  using Place = std::vector<int>;

  struct Entry
  {
    Place Where;
    std::optional<std::string> Name;
  };

  /** The field arrays of a piece. */
  struct PieceField
  {
    vtkSmartPointer<vtkFieldData> Arrays;
    std::string Label; ///< the name of the block
    int Block = 0;     ///< of the entries
  };

  int AddBlock(const Place& place, const char* name);
  void AddPiece(vtkDataSet* data, int block);
  void AddField(vtkFieldData* field);
  void JoinFields();
  void AddTo(const Place& place, vtkDataObject* data);
  void DropEmpty();
  std::vector<std::uint8_t> Describe(bool isSingle, bool hasUnused) const;

  const bool Composite;
  bool Single = true;
  bool Unused = false;
  std::vector<vtkSmartPointer<vtkDataSet>> Pieces;
  std::vector<int> Blocks;
  std::vector<bool> Own;
  std::vector<Entry> Entries; // of this process
  std::vector<std::string> Names;
  vtkNew<vtkFieldData> Field;
  std::vector<PieceField> PieceFields;
  std::set<std::string> Messages;
};
}

#endif
