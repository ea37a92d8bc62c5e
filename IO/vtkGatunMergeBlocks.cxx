// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunMergeBlocks.h"

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
#include <limits>
#include <map>
#include <new>
#include <set>
#include <string>
#include <tuple>
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
// Adds to each piece the arrays that only other pieces have. Returns their names.
std::set<std::string> FillUp(
  const std::vector<vtkSmartPointer<vtkDataSet>>& pieces, int association)
{
  using Key = std::tuple<std::string, int, int>;
  std::map<Key, vtkAbstractArray*> known;
  const auto keyOf = [](vtkAbstractArray* array)
  { return Key(array->GetName(), array->GetDataType(), array->GetNumberOfComponents()); };
  for (const auto& piece : pieces)
  {
    vtkDataSetAttributes* attributes = piece->GetAttributes(association);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      if (attributes->GetAbstractArray(i)->GetName())
      {
        known.emplace(keyOf(attributes->GetAbstractArray(i)), attributes->GetAbstractArray(i));
      }
    }
  }
  std::set<std::string> filled;
  for (const auto& [key, array] : known)
  {
    const std::string& name = std::get<0>(key);
    for (const auto& piece : pieces)
    {
      vtkDataSetAttributes* attributes = piece->GetAttributes(association);
      if (attributes->HasArray(name.c_str()))
      {
        continue;
      }
      auto fill = vtk::TakeSmartPointer(vtkAbstractArray::CreateArray(array->GetDataType()));
      fill->SetNumberOfComponents(array->GetNumberOfComponents());
      fill->SetNumberOfTuples(piece->GetNumberOfElements(association));
      fill->SetName(name.c_str());
      if (auto* numbers = vtkDataArray::SafeDownCast(fill))
      {
        const bool real = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
        numbers->Fill(real ? std::numeric_limits<double>::quiet_NaN() : 0.0);
        attributes->AddArray(numbers);
      }
      filled.insert(name);
    }
  }
  return filled;
}

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

  std::set<std::string> filled = FillUp(pieces, vtkDataObject::POINT);
  filled.merge(FillUp(pieces, vtkDataObject::CELL));
  for (const std::string& name : filled)
  {
    vtkWarningMacro("The array '" << name << "' is filled up in blocks that do not have it.");
  }
  for (std::size_t i = 0; blocks.Composite && i < pieces.size(); ++i)
  {
    vtkNew<vtkIntArray> ids;
    ids->SetName("BlockId");
    ids->SetNumberOfValues(pieces[i]->GetNumberOfCells());
    ids->FillValue(blockOf[i]);
    pieces[i]->GetCellData()->AddArray(ids);
  }

  const bool merge =
    this->MergeCoincidentPoints || (pieces.size() > 1 && HaveGlobalPointIds(pieces));
  if (pieces.size() == 1 && !merge && vtkUnstructuredGrid::SafeDownCast(pieces.front()))
  {
    output->ShallowCopy(pieces.front());
  }
  else if (!pieces.empty())
  {
    vtkNew<vtkAppendFilter> append;
    append->SetOutputPointsPrecision(PointType(pieces));
    append->SetMergePoints(merge);
    append->SetTolerance(0);
    for (const auto& piece : pieces)
    {
      append->AddInputData(piece);
    }
    append->Update();
    // Preserves the time set above.
    output->CopyStructure(append->GetOutput());
    output->GetPointData()->ShallowCopy(append->GetOutput()->GetPointData());
    output->GetCellData()->ShallowCopy(append->GetOutput()->GetCellData());
  }

  output->GetFieldData()->ShallowCopy(blocks.Field);
  if (blocks.Composite)
  {
    vtkNew<vtkStringArray> names;
    names->SetName("BlockNames");
    for (const std::string& name : blocks.Names)
    {
      names->InsertNextValue(name);
    }
    output->GetFieldData()->AddArray(names);
  }
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
