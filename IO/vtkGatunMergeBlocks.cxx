// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunMergeBlocks.h"

#include "gatunBlockArrays.h"
#include "gatunCellCheck.h"
#include "gatunErrorCodes.h"
#include "gatunGhosts.h"
#include "gatunReport.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <new>
#include <string>
#include <utility>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunMergeBlocks);

namespace
{

//------------------------------------------------------------------------------
// The datasets to merge.
struct Blocks
{
  std::vector<vtkSmartPointer<vtkDataSet>> Pieces; ///< shallow copies
  std::vector<int> Block;                          ///< block index of each piece
  std::vector<std::string> Names;                  ///< of each block
  bool Composite = false;
  vtkNew<vtkFieldData> Field;

  void AddField(vtkFieldData* field)
  {
    for (int i = 0; i < field->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = field->GetAbstractArray(i);
      if (!array->GetName() || !this->Field->HasArray(array->GetName()))
      {
        this->Field->AddArray(array);
      }
    }
  }

  void AddPiece(vtkDataSet* data, int block)
  {
    auto copy = vtk::TakeSmartPointer(data->NewInstance());
    copy->ShallowCopy(data);
    auto* grid = vtkUnstructuredGrid::SafeDownCast(copy);
    if (grid && gatun::GhostsWith(grid->GetCellData(), vtkDataSetAttributes::DUPLICATECELL))
    {
      grid->RemoveGhostCells();
      gatun::ClearGhosts(grid->GetCellData(), vtkDataSetAttributes::DUPLICATECELL);
      gatun::ClearGhosts(grid->GetPointData(), vtkDataSetAttributes::DUPLICATEPOINT);
    }
    this->Pieces.push_back(copy);
    this->Block.push_back(block);
    this->AddField(data->GetFieldData());
  }

  int AddBlock(const char* name)
  {
    const auto block = static_cast<int>(this->Names.size());
    this->Names.push_back(name ? name : "Block " + std::to_string(block));
    return block;
  }

  void Add(vtkDataObject* data)
  {
    if (auto* set = vtkDataSet::SafeDownCast(data))
    {
      this->AddPiece(set, this->Composite ? this->AddBlock(nullptr) : 0);
      return;
    }
    auto* tree = vtkDataObjectTree::SafeDownCast(data);
    if (!tree)
    {
      return;
    }
    this->AddField(tree->GetFieldData());
    auto iterator = vtk::TakeSmartPointer(tree->NewTreeIterator());
    iterator->TraverseSubTreeOff();
    iterator->VisitOnlyLeavesOff();
    iterator->SkipEmptyNodesOn();
    int partitions = -1;
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      vtkDataObject* child = iterator->GetCurrentDataObject();
      auto* set = vtkDataSet::SafeDownCast(child);
      auto* parts = vtkPartitionedDataSet::SafeDownCast(child);
      if (!set && !parts)
      {
        this->Add(child);
        continue;
      }
      const char* name = nullptr;
      if (iterator->HasCurrentMetaData())
      {
        name = iterator->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME());
      }
      if (parts)
      {
        const int block = this->AddBlock(name);
        for (unsigned int i = 0; i < parts->GetNumberOfPartitions(); ++i)
        {
          if (parts->GetPartition(i))
          {
            this->AddPiece(parts->GetPartition(i), block);
          }
        }
      }
      else if (vtkPartitionedDataSet::SafeDownCast(tree))
      {
        partitions = partitions < 0 ? this->AddBlock(nullptr) : partitions;
        this->AddPiece(set, partitions);
      }
      else
      {
        this->AddPiece(set, this->AddBlock(name));
      }
    }
  }
};

//------------------------------------------------------------------------------
// Returns the point type that represents the points of all pieces without loss.
int PointType(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces)
{
  bool single = true;
  for (const auto& piece : pieces)
  {
    auto* set = vtkPointSet::SafeDownCast(piece);
    single = single && set && (!set->GetPoints() || set->GetPoints()->GetDataType() == VTK_FLOAT);
  }
  return single ? vtkAlgorithm::SINGLE_PRECISION : vtkAlgorithm::DOUBLE_PRECISION;
}

//------------------------------------------------------------------------------
bool HaveGlobalPointIds(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces)
{
  return std::all_of(pieces.begin(), pieces.end(),
    [](const vtkSmartPointer<vtkDataSet>& piece)
    { return piece->GetNumberOfPoints() == 0 || piece->GetPointData()->GetGlobalIds(); });
}

//------------------------------------------------------------------------------
// Calls visit(cell, corner, point) for the points of all cells.
template <typename Visitor>
void VisitCorners(vtkDataSet* piece, Visitor&& visit)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < piece->GetNumberOfCells(); ++cell)
  {
    piece->GetCellPoints(cell, ids);
    for (vtkIdType corner = 0; corner < ids->GetNumberOfIds(); ++corner)
    {
      visit(cell, corner, ids->GetId(corner));
    }
  }
}

//------------------------------------------------------------------------------
bool HasUnusedPoints(vtkDataSet* piece)
{
  if (piece->GetNumberOfCells() == 0)
  {
    return piece->GetNumberOfPoints() > 0;
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(piece))
  {
    gatun::CheckGrid(grid);
    gatun::CheckCells(grid);
  }
  std::vector<bool> used(static_cast<std::size_t>(piece->GetNumberOfPoints()));
  VisitCorners(piece,
    [&](vtkIdType, vtkIdType, vtkIdType point) { used[static_cast<std::size_t>(point)] = true; });
  return std::find(used.begin(), used.end(), false) != used.end();
}

//------------------------------------------------------------------------------
// Adds the array BlockId to the cells, and to the points if there are some that no cell uses, of
// which nothing else tells the block.
void AddBlockIds(
  const std::vector<vtkSmartPointer<vtkDataSet>>& pieces, const std::vector<int>& blocks)
{
  const bool forPoints = std::any_of(pieces.begin(), pieces.end(),
    [](const vtkSmartPointer<vtkDataSet>& piece) { return HasUnusedPoints(piece); });
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    for (const int association : { vtkDataObject::CELL, vtkDataObject::POINT })
    {
      if (association == vtkDataObject::CELL || forPoints)
      {
        vtkNew<vtkIntArray> ids;
        ids->SetName(gatun::BlockIdName);
        ids->SetNumberOfValues(pieces[i]->GetNumberOfElements(association));
        ids->FillValue(blocks[i]);
        pieces[i]->GetAttributes(association)->AddArray(ids);
      }
    }
  }
}

//------------------------------------------------------------------------------
// A point that is merged from several pieces may have the values of one that was filled up. It gets
// those of a piece that has the array.
void RestoreValues(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces,
  const gatun::ArrayMatcher& matcher, vtkUnstructuredGrid* merged)
{
  vtkIdType firstCell = 0;
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
  {
    std::vector<std::pair<vtkAbstractArray*, vtkAbstractArray*>> arrays;
    for (const std::string& name : matcher.GetFilled())
    {
      vtkAbstractArray* from = pieces[piece]->GetPointData()->GetAbstractArray(name.c_str());
      vtkAbstractArray* to = merged->GetPointData()->GetAbstractArray(name.c_str());
      if (from && to && !matcher.IsFilled(piece, name))
      {
        arrays.emplace_back(from, to);
      }
    }
    vtkIdType count = 0;
    vtkIdType known = -1;
    const vtkIdType* ids = nullptr;
    const auto copy = [&](vtkIdType cell, vtkIdType corner, vtkIdType point)
    {
      if (cell != known)
      {
        merged->GetCellPoints(firstCell + cell, count, ids);
        known = cell;
      }
      for (const auto& [from, to] : arrays)
      {
        to->SetTuple(ids[corner], point, from);
      }
    };
    if (!arrays.empty())
    {
      VisitCorners(pieces[piece], copy);
    }
    firstCell += pieces[piece]->GetNumberOfCells();
  }
}

//------------------------------------------------------------------------------
// The active attributes of pieces. vtkAppendFilter treats some of them in its own way (it drops
// global ids that are not vtkIdType), so they are plain arrays while it works.
class ActiveAttributes
{
public:
  ActiveAttributes(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces, int association)
    : Association(association)
  {
    for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
    {
      bool agree = true;
      for (const auto& piece : pieces)
      {
        vtkDataSetAttributes* attributes = piece->GetAttributes(association);
        vtkAbstractArray* array = attributes->GetAbstractAttribute(type);
        const std::string name = array && array->GetName() ? array->GetName() : "";
        agree = agree && (piece == pieces.front() || name == this->Names[type]);
        this->Names[type] = name;
        attributes->SetActiveAttribute(-1, type);
      }
      this->Names[type] = agree ? this->Names[type] : "";
    }
  }

  // Those that the pieces agree about.
  void Restore(vtkDataSet* merged) const
  {
    for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
    {
      if (!this->Names[type].empty())
      {
        merged->GetAttributes(this->Association)
          ->SetActiveAttribute(this->Names[type].c_str(), type);
      }
    }
  }

private:
  const int Association;
  std::string Names[vtkDataSetAttributes::NUM_ATTRIBUTES];
};

//------------------------------------------------------------------------------
constexpr const char* MergeIdsName = "vtkGatunMergeBlocks: ids";

// The ids that points are merged by, one array per piece, with the type that vtkAppendFilter needs.
void AddMergeIds(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces,
  const std::vector<vtkSmartPointer<vtkDataArray>>& ids)
{
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    vtkNew<vtkIdTypeArray> copy;
    if (ids[i]) // otherwise there are no points
    {
      copy->DeepCopy(ids[i]);
    }
    copy->SetName(MergeIdsName);
    pieces[i]->GetPointData()->SetGlobalIds(copy);
  }
}

//------------------------------------------------------------------------------
// Appends the pieces; mergePoints: those with equal global ids, if there are any, or else with
// equal coordinates.
void Append(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces, bool mergePoints,
  vtkUnstructuredGrid* output)
{
  std::vector<vtkSmartPointer<vtkDataArray>> ids;
  if (mergePoints && HaveGlobalPointIds(pieces))
  {
    for (const auto& piece : pieces)
    {
      ids.push_back(piece->GetPointData()->GetGlobalIds());
    }
  }
  const ActiveAttributes points(pieces, vtkDataObject::POINT);
  const ActiveAttributes cells(pieces, vtkDataObject::CELL);
  AddMergeIds(pieces, ids);
  vtkNew<vtkAppendFilter> append;
  append->SetOutputPointsPrecision(PointType(pieces));
  append->SetMergePoints(mergePoints);
  append->SetTolerance(0);
  for (const auto& piece : pieces)
  {
    append->AddInputData(piece);
  }
  append->Update();
  // Preserves the time of the output.
  output->CopyStructure(append->GetOutput());
  output->GetPointData()->ShallowCopy(append->GetOutput()->GetPointData());
  output->GetCellData()->ShallowCopy(append->GetOutput()->GetCellData());
  output->GetPointData()->RemoveArray(MergeIdsName);
  points.Restore(output);
  cells.Restore(output);
}

} // anonymous namespace

//------------------------------------------------------------------------------
void vtkGatunMergeBlocks::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergeCoincidentPoints: " << (this->MergeCoincidentPoints ? "On" : "Off") << "\n";
}

//------------------------------------------------------------------------------
int vtkGatunMergeBlocks::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunMergeBlocks::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    this->Merge(inputVector[0], output);
  }
  catch (...)
  {
    // The exception stops here, whether or not there is memory for the message.
    const gatun::VTKFailure failure = gatun::DescribeFailure("The blocks cannot be merged");
    this->SetErrorCode(failure.Code);
    gatun::ReportFailure(this, failure, output);
    return 0;
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkGatunMergeBlocks::Merge(vtkInformationVector* input, vtkUnstructuredGrid* output)
{
  const int inputs = input->GetNumberOfInformationObjects();
  Blocks blocks;
  for (int i = 0; i < inputs; ++i)
  {
    blocks.Composite = blocks.Composite || vtkCompositeDataSet::GetData(input, i) != nullptr;
  }
  for (int i = 0; i < inputs; ++i)
  {
    if (vtkDataObject* data = vtkDataObject::GetData(input, i))
    {
      blocks.Add(data);
      if (data->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
      {
        output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(),
          data->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()));
      }
    }
  }

  // Empty pieces do not determine which arrays exist, unless all pieces are empty.
  std::vector<vtkSmartPointer<vtkDataSet>> pieces;
  std::vector<int> blockOf;
  for (std::size_t i = 0; i < blocks.Pieces.size(); ++i)
  {
    const auto& piece = blocks.Pieces[i];
    if (piece->GetNumberOfPoints() > 0 || piece->GetNumberOfCells() > 0)
    {
      pieces.push_back(piece);
      blockOf.push_back(blocks.Block[i]);
    }
  }
  if (pieces.empty() && !blocks.Pieces.empty())
  {
    pieces.push_back(blocks.Pieces.front());
    blockOf.push_back(blocks.Block.front());
  }

  const gatun::ArrayMatcher points(pieces, blockOf, blocks.Composite, vtkDataObject::POINT);
  const gatun::ArrayMatcher cells(pieces, blockOf, blocks.Composite, vtkDataObject::CELL);
  for (const gatun::ArrayMatcher* matcher : { &points, &cells })
  {
    for (const std::string& warning : matcher->GetWarnings())
    {
      vtkWarningMacro(<< warning);
    }
  }
  if (blocks.Composite)
  {
    AddBlockIds(pieces, blockOf);
  }

  const bool merge =
    this->MergeCoincidentPoints || (pieces.size() > 1 && HaveGlobalPointIds(pieces));
  if (pieces.size() == 1 && !merge && vtkUnstructuredGrid::SafeDownCast(pieces.front()))
  {
    output->ShallowCopy(pieces.front());
  }
  else if (!pieces.empty())
  {
    Append(pieces, merge, output);
    if (merge && !points.GetFilled().empty())
    {
      RestoreValues(pieces, points, output);
    }
  }

  output->GetFieldData()->ShallowCopy(blocks.Field);
  if (blocks.Composite)
  {
    vtkNew<vtkStringArray> names;
    names->SetName(gatun::BlockNamesName);
    for (const std::string& name : blocks.Names)
    {
      names->InsertNextValue(name);
    }
    output->GetFieldData()->AddArray(names);
    std::vector<gatun::BlockArray> arrays = points.GetBlockArrays();
    arrays.insert(arrays.end(), cells.GetBlockArrays().begin(), cells.GetBlockArrays().end());
    output->GetFieldData()->AddArray(gatun::MakeBlockArrays(arrays));
  }
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
