// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunSplitBlocks.h"

#include "gatunArrayBridge.h"
#include "gatunBlockArrays.h"
#include "gatunCellCheck.h"
#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunGhosts.h"
#include "gatunGridPart.h"
#include "gatunReport.h"
#include "vtkGatunCompat.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkSetGet.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunSplitBlocks);

namespace
{

using Ids = std::vector<vtkIdType>;

//------------------------------------------------------------------------------
// The values of an array BlockId; nothing if there is no such array.
std::optional<std::vector<std::int64_t>> ReadBlockIds(
  vtkDataSetAttributes* attributes, const char* place)
{
  vtkAbstractArray* const array = attributes->GetAbstractArray(gatun::BlockIdName);
  if (!array)
  {
    return {};
  }
  auto* const numbers = vtkDataArray::SafeDownCast(array);
  const int type = array->GetDataType();
  if (!numbers || type == VTK_FLOAT || type == VTK_DOUBLE || numbers->GetNumberOfComponents() != 1)
  {
    gatun::ThrowInvalid(std::string("the array BlockId must have one integer for each ") + place);
  }
  const auto contiguous = gatun::Contiguous(numbers);
  std::vector<std::int64_t> values(static_cast<std::size_t>(contiguous->GetNumberOfValues()));
  if (values.empty())
  {
    return values;
  }
  const void* const from = contiguous->GetVoidPointer(0);
  switch (contiguous->GetDataType())
  {
    vtkTemplateMacro(std::transform(static_cast<const VTK_TT*>(from),
      static_cast<const VTK_TT*>(from) + values.size(), values.begin(),
      [](VTK_TT value) { return static_cast<std::int64_t>(value); }));
  }
  return values;
}

//------------------------------------------------------------------------------
// Numbers of things, grouped by block, in ascending order within a block.
class Groups
{
public:
  Groups() = default;

  // blocks: of each thing; those of negative blocks are left out.
  Groups(const std::vector<int>& blocks, std::size_t count)
    : Begin(count + 1)
  {
    for (const int block : blocks)
    {
      if (block >= 0)
      {
        ++this->Begin[static_cast<std::size_t>(block) + 1];
      }
    }
    std::partial_sum(this->Begin.begin(), this->Begin.end(), this->Begin.begin());
    this->Members.resize(this->Begin.back());
    std::vector<std::size_t> end(this->Begin.begin(), this->Begin.end() - 1);
    for (std::size_t i = 0; i < blocks.size(); ++i)
    {
      if (blocks[i] >= 0)
      {
        this->Members[end[static_cast<std::size_t>(blocks[i])]++] = static_cast<vtkIdType>(i);
      }
    }
  }

  Ids Get(std::size_t block) const
  {
    const auto begin = this->Members.begin();
    return { begin + static_cast<std::ptrdiff_t>(this->Begin[block]),
      begin + static_cast<std::ptrdiff_t>(this->Begin[block + 1]) };
  }

private:
  std::vector<std::size_t> Begin;
  Ids Members;
};

//------------------------------------------------------------------------------
// Which blocks there are, and what belongs to them.
class BlockList
{
public:
  explicit BlockList(vtkUnstructuredGrid* grid)
  {
    const auto cellIds = ReadBlockIds(grid->GetCellData(), "cell");
    this->ReadNames(grid->GetFieldData());
    if (!cellIds && (grid->GetNumberOfCells() > 0 || !this->HasNames))
    {
      if (!this->Names.empty())
      {
        this->Warnings.push_back("There are names of blocks, but no cell array BlockId: all cells "
                                 "are in one block.");
      }
      this->IsWhole = true;
      this->Names = { "" };
      return;
    }
    this->HasIds = true;
    std::vector<int> blocks;
    if (cellIds)
    {
      this->AddUnnamed(*cellIds);
      blocks = this->ToBlocks(*cellIds);
    }
    // A single block has all points.
    this->IsWhole = this->Names.size() == 1;
    this->Cells = Groups(blocks, this->Names.size());
  }

  void AssignUnusedPoints(vtkUnstructuredGrid* grid)
  {
    const auto ids = ReadBlockIds(grid->GetPointData(), "point");
    this->HasPoints = ids && !this->IsWhole;
    if (!this->HasPoints)
    {
      return;
    }
    std::vector<int> blocks = this->ToBlocks(*ids);
    if (grid->GetNumberOfCells() > 0)
    {
      auto iterator = vtk::TakeSmartPointer(grid->GetCells()->NewIterator());
      for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
      {
        vtkIdType size = 0;
        const vtkIdType* points = nullptr;
        iterator->GetCurrentCell(size, points);
        for (vtkIdType i = 0; i < size; ++i)
        {
          blocks[static_cast<std::size_t>(points[i])] = -1;
        }
      }
    }
    this->UnusedPoints = Groups(blocks, this->Names.size());
  }

  std::vector<std::string> Names; // of each block; may be empty
  std::vector<std::string> Warnings;
  bool HasIds = false;    // the blocks of cells are known
  bool IsWhole = false;   // there is one block, which is the grid
  bool HasPoints = false; // UnusedPoints is known
  Groups Cells;
  Groups UnusedPoints;

private:
  void ReadNames(vtkFieldData* field)
  {
    vtkAbstractArray* const array = field->GetAbstractArray(gatun::BlockNamesName);
    auto* const names = vtkStringArray::SafeDownCast(array);
    if (array && !names)
    {
      this->Warnings.push_back("The field array BlockNames is ignored: it has no strings.");
    }
    for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i)
    {
      this->Names.push_back(names->GetValue(i));
    }
    this->HasNames = names != nullptr;
    this->Named = this->Names.size();
  }

  bool HasName(std::int64_t id) const
  {
    return id >= 0 && static_cast<std::uint64_t>(id) < this->Named;
  }

  void AddUnnamed(const std::vector<std::int64_t>& ids)
  {
    std::set<std::int64_t> others;
    for (const std::int64_t id : ids)
    {
      if (!this->HasName(id))
      {
        others.insert(id);
      }
    }
    for (const std::int64_t id : others)
    {
      this->Unnamed[id] = static_cast<int>(this->Names.size());
      this->Names.push_back("Block " + std::to_string(id));
    }
    if (this->Named > 0 && !others.empty())
    {
      this->Warnings.push_back(std::to_string(others.size()) +
        " values of BlockId, the first of which is " + std::to_string(*others.begin()) +
        ", have no name in BlockNames.");
    }
  }

  // -1 for ids that no cell has.
  std::vector<int> ToBlocks(const std::vector<std::int64_t>& ids) const
  {
    std::vector<int> blocks(ids.size());
    std::transform(ids.begin(), ids.end(), blocks.begin(),
      [this](std::int64_t id)
      {
        if (this->HasName(id))
        {
          return static_cast<int>(id);
        }
        const auto at = this->Unnamed.find(id);
        return at == this->Unnamed.end() ? -1 : at->second;
      });
    return blocks;
  }

  bool HasNames = false; // a list of them, which may be empty
  std::size_t Named = 0;
  std::map<std::int64_t, int> Unnamed;
};

//------------------------------------------------------------------------------
// Which arrays of the grid a block has.
class ArrayChooser
{
public:
  ArrayChooser(std::vector<gatun::BlockArray> arrays, std::size_t blocks)
    : OfBlocks(blocks)
  {
    for (gatun::BlockArray& array : arrays)
    {
      this->Listed.emplace(array.Association, array.Merged);
      if (static_cast<std::size_t>(array.Block) < blocks)
      {
        this->OfBlocks[static_cast<std::size_t>(array.Block)].push_back(std::move(array));
      }
    }
  }

  // tuples: those of the block; nullptr: all, without a copy.
  void AddArrays(std::size_t block, int association, vtkDataSetAttributes* from, const Ids* tuples,
    vtkDataSetAttributes* to) const
  {
    for (const gatun::BlockArray& listed : this->OfBlocks[block])
    {
      vtkAbstractArray* const array =
        listed.Association == association ? from->GetAbstractArray(listed.Merged.c_str()) : nullptr;
      if (array)
      {
        Add(array, tuples, &listed.Name, listed.Roles, to);
      }
    }
    for (int i = 0; i < from->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = from->GetAbstractArray(i);
      const std::string name = array->GetName() ? array->GetName() : "";
      if (this->Listed.count({ association, name }) == 0 && !this->IsBlockId(association, name))
      {
        Add(array, tuples, nullptr, gatun::AttributeRolesOf(from, array), to);
      }
    }
    this->AddGhosts(association, from, tuples, to);
  }

  // Whether the array is one that the merge made, not one of a block.
  bool IsBlockId(int association, const std::string& name) const
  {
    return name == gatun::BlockIdName && this->Listed.count({ association, name }) == 0;
  }

private:
  static void Add(vtkAbstractArray* array, const Ids* tuples, const std::string* name,
    std::uint32_t roles, vtkDataSetAttributes* to)
  {
    vtkSmartPointer<vtkAbstractArray> part = array;
    if (tuples)
    {
      part = gatun::Gather(array, *tuples);
    }
    if (name && *name != (array->GetName() ? array->GetName() : ""))
    {
      part = gatun::Renamed(part, *name);
    }
    gatun::AddWithRoles(to, part, roles);
  }

  // A reader of pieces marks ghosts also in blocks that had no such array.
  void AddGhosts(
    int association, vtkDataSetAttributes* from, const Ids* tuples, vtkDataSetAttributes* to) const
  {
    const char* const name = vtkDataSetAttributes::GhostArrayName();
    vtkAbstractArray* const ghosts = from->GetAbstractArray(name);
    if (!ghosts || to->HasArray(name) || this->Listed.count({ association, name }) == 0)
    {
      return;
    }
    Add(ghosts, tuples, nullptr, 0, to);
    if (!gatun::GhostsWith(to, 0xff))
    {
      to->RemoveArray(name);
    }
  }

  std::set<std::pair<int, std::string>> Listed; // for any block
  std::vector<std::vector<gatun::BlockArray>> OfBlocks;
};

//------------------------------------------------------------------------------
// Makes one block after another.
class Splitter
{
public:
  Splitter(vtkUnstructuredGrid* grid, const BlockList& blocks, const ArrayChooser& arrays)
    : Grid(grid)
    , Blocks(blocks)
    , Arrays(arrays)
    , NewIds(blocks.IsWhole ? 0 : static_cast<std::size_t>(grid->GetNumberOfPoints()), -1)
  {
  }

  vtkSmartPointer<vtkUnstructuredGrid> Make(std::size_t block)
  {
    if (this->Blocks.IsWhole)
    {
      auto whole = vtkSmartPointer<vtkUnstructuredGrid>::New();
      whole->CopyStructure(this->Grid);
      this->AddArrays(block, nullptr, whole);
      return whole;
    }
    gatun::GridPart part;
    part.Cells = this->Blocks.Cells.Get(block);
    this->SelectPoints(block, part);
    auto grid = gatun::ExtractPart(this->Grid, part, this->NewIds);
    this->AddArrays(block, &part, grid);
    for (const vtkIdType point : part.Points)
    {
      this->NewIds[static_cast<std::size_t>(point)] = -1;
    }
    return grid;
  }

private:
  void SelectPoints(std::size_t block, gatun::GridPart& part)
  {
    if (this->Blocks.HasPoints)
    {
      part.Points = this->Blocks.UnusedPoints.Get(block);
    }
    if (!part.Cells.empty())
    {
      auto iterator = vtk::TakeSmartPointer(this->Grid->GetCells()->NewIterator());
      for (const vtkIdType cell : part.Cells)
      {
        vtkIdType size = 0;
        const vtkIdType* points = nullptr;
        iterator->GetCellAtId(cell, size, points);
        for (vtkIdType i = 0; i < size; ++i)
        {
          vtkIdType& id = this->NewIds[static_cast<std::size_t>(points[i])];
          if (id < 0)
          {
            id = 0;
            part.Points.push_back(points[i]);
          }
        }
      }
    }
    std::sort(part.Points.begin(), part.Points.end());
    for (std::size_t i = 0; i < part.Points.size(); ++i)
    {
      this->NewIds[static_cast<std::size_t>(part.Points[i])] = static_cast<vtkIdType>(i);
    }
  }

  void AddArrays(std::size_t block, const gatun::GridPart* part, vtkUnstructuredGrid* to)
  {
    this->Arrays.AddArrays(block, vtkDataObject::POINT, this->Grid->GetPointData(),
      part ? &part->Points : nullptr, to->GetPointData());
    this->Arrays.AddArrays(block, vtkDataObject::CELL, this->Grid->GetCellData(),
      part ? &part->Cells : nullptr, to->GetCellData());
  }

  vtkUnstructuredGrid* const Grid;
  const BlockList& Blocks;
  const ArrayChooser& Arrays;
  Ids NewIds; // of all points; -1: not in this block
};

} // anonymous namespace

//------------------------------------------------------------------------------
void vtkGatunSplitBlocks::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
int vtkGatunSplitBlocks::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunSplitBlocks::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  auto* output = vtkPartitionedDataSetCollection::GetData(outputVector);
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    this->Split(input, output);
  }
  catch (...)
  {
    const gatun::VTKFailure failure = gatun::DescribeFailure("The blocks cannot be split");
    this->SetErrorCode(failure.Code);
    gatun::ReportFailure(this, failure, output);
    return failure.Aborted ? 1 : 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkGatunSplitBlocks::Split(vtkUnstructuredGrid* input, vtkPartitionedDataSetCollection* output)
{
  gatun::CheckGrid(input);
  gatun::CheckCells(input);
  auto arrays = gatun::ReadBlockArrays(input->GetFieldData());
  if (!arrays && input->GetFieldData()->HasArray(gatun::BlockArraysName))
  {
    vtkWarningMacro("The field array BlockArrays is ignored: it is not as vtkGatunMergeBlocks "
                    "makes it.");
  }
  BlockList blocks(input);
  if (!arrays || !blocks.HasIds)
  {
    arrays.emplace(); // a list is of no use where blocks are unknown
  }
  const ArrayChooser chooser(std::move(*arrays), blocks.Names.size());
  if (chooser.IsBlockId(vtkDataObject::POINT, gatun::BlockIdName))
  {
    blocks.AssignUnusedPoints(input);
  }
  for (const std::string& warning : blocks.Warnings)
  {
    vtkWarningMacro(<< warning);
  }

  const std::size_t count = blocks.Names.size();
  output->SetNumberOfPartitionedDataSets(static_cast<unsigned int>(count));
  Splitter splitter(input, blocks, chooser);
  for (std::size_t block = 0; block < count; ++block)
  {
    if (gatun::IsAborted(this))
    {
      throw gatun::Error(gatun::ErrorCode::Aborted, "aborted");
    }
    const auto index = static_cast<unsigned int>(block);
    output->SetPartition(index, 0, splitter.Make(block));
    if (!blocks.Names[block].empty())
    {
      output->GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), blocks.Names[block].c_str());
    }
    this->UpdateProgress(static_cast<double>(block + 1) / static_cast<double>(count));
  }

  output->GetFieldData()->ShallowCopy(input->GetFieldData());
  output->GetFieldData()->RemoveArray(gatun::BlockNamesName);
  output->GetFieldData()->RemoveArray(gatun::BlockArraysName);
  if (input->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(),
      input->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()));
  }
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
