// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunMergeBlocks.h"

#include "gatunArrayBridge.h"
#include "gatunBlockArrays.h"
#include "gatunBlockList.h"
#include "gatunCellCheck.h"
#include "gatunErrorCodes.h"
#include "gatunNewArray.h"
#include "gatunProcessExchange.h"
#include "gatunReport.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <new>
#include <numeric>
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
// Whether float represents the points of all pieces without loss.
bool IsSingle(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces)
{
  return std::all_of(pieces.begin(), pieces.end(),
    [](const vtkSmartPointer<vtkDataSet>& piece)
    {
      auto* set = vtkPointSet::SafeDownCast(piece);
      return (piece->GetNumberOfPoints() == 0 && piece->GetNumberOfCells() == 0) ||
        (set && (!set->GetPoints() || set->GetPoints()->GetDataType() == VTK_FLOAT));
    });
}

//------------------------------------------------------------------------------
// Whether all pieces that have points have global ids of them. Those of other processes have
// points.
bool HaveGlobalPointIds(const gatun::BlockList& blocks)
{
  for (std::size_t i = 0; i < blocks.GetPieces().size(); ++i)
  {
    vtkDataSet* const piece = blocks.GetPieces()[i];
    const bool hasPoints = !blocks.IsOwn(i) || piece->GetNumberOfPoints() > 0;
    if (hasPoints && !piece->GetPointData()->GetGlobalIds())
    {
      return false;
    }
  }
  return true;
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
void AddBlockIds(const gatun::BlockList& blocks)
{
  for (std::size_t i = 0; i < blocks.GetPieces().size(); ++i)
  {
    vtkDataSet* const piece = blocks.GetPieces()[i];
    for (const int association : { vtkDataObject::CELL, vtkDataObject::POINT })
    {
      if (association == vtkDataObject::CELL || blocks.HasUnused())
      {
        vtkNew<vtkIntArray> ids;
        ids->SetName(gatun::BlockIdName);
        gatun::SizeArray(ids, piece->GetNumberOfElements(association));
        ids->FillValue(blocks.GetBlocks()[i]);
        piece->GetAttributes(association)->AddArray(ids);
      }
    }
  }
}

//------------------------------------------------------------------------------
// A point that is merged from several pieces may have the values of one that was filled up. It gets
// those of a piece that has the array.
void RestoreValues(
  const gatun::BlockList& blocks, const gatun::ArrayMatcher& matcher, vtkUnstructuredGrid* merged)
{
  const auto& pieces = blocks.GetPieces();
  vtkIdType firstCell = 0;
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
  {
    if (!blocks.IsOwn(piece))
    {
      continue;
    }
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
// Appends the pieces of this process; mergePoints: those with equal global ids, if there are any,
// or else with equal coordinates.
void Append(const gatun::BlockList& blocks, bool mergePoints, vtkUnstructuredGrid* output)
{
  const auto pieces = blocks.GetOwnPieces();
  std::vector<vtkSmartPointer<vtkDataArray>> ids;
  if (mergePoints && HaveGlobalPointIds(blocks))
  {
    for (const auto& piece : pieces)
    {
      ids.push_back(piece->GetPointData()->GetGlobalIds());
    }
  }
  const ActiveAttributes points(blocks.GetPieces(), vtkDataObject::POINT);
  const ActiveAttributes cells(blocks.GetPieces(), vtkDataObject::CELL);
  AddMergeIds(pieces, ids);
  vtkNew<vtkAppendFilter> append;
  append->SetOutputPointsPrecision(
    blocks.IsSingle() ? vtkAlgorithm::SINGLE_PRECISION : vtkAlgorithm::DOUBLE_PRECISION);
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
  auto* const first = pieces.empty() ? nullptr : vtkPointSet::SafeDownCast(pieces.front());
  if (first && first->GetPoints() && output->GetPoints())
  {
    gatun::CopyNames(first->GetPoints()->GetData(), output->GetPoints()->GetData());
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
vtkGatunMergeBlocks::vtkGatunMergeBlocks() = default;

vtkGatunMergeBlocks::~vtkGatunMergeBlocks()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
vtkCxxSetObjectMacro(vtkGatunMergeBlocks, Controller, vtkMultiProcessController);

//------------------------------------------------------------------------------
void vtkGatunMergeBlocks::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
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
// What may fail in one process runs in PartExchange::Together, so that all fail.
void vtkGatunMergeBlocks::Merge(vtkInformationVector* input, vtkUnstructuredGrid* output)
{
  gatun::ProcessExchange exchange(this->Controller);
  const int inputs = input->GetNumberOfInformationObjects();
  bool isComposite = false;
  for (int i = 0; i < inputs; ++i)
  {
    isComposite = isComposite || vtkCompositeDataSet::GetData(input, i) != nullptr;
  }
  gatun::BlockList blocks(exchange.IsAny(isComposite));
  bool isSingle = true;
  bool hasUnused = false;
  exchange.Together(
    [&]
    {
      for (int i = 0; i < inputs; ++i)
      {
        if (vtkDataObject* data = vtkDataObject::GetData(input, i))
        {
          blocks.Add(i, data);
          if (data->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
          {
            output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(),
              data->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()));
          }
        }
      }
      const auto pieces = blocks.GetOwnPieces();
      isSingle = IsSingle(pieces);
      hasUnused = blocks.IsComposite() &&
        std::any_of(pieces.begin(), pieces.end(),
          [](const vtkSmartPointer<vtkDataSet>& piece) { return HasUnusedPoints(piece); });
    });
  blocks.Agree(exchange, isSingle, hasUnused);
  exchange.Together([&] { this->Merge(blocks, output); });
}

//------------------------------------------------------------------------------
void vtkGatunMergeBlocks::Merge(const gatun::BlockList& blocks, vtkUnstructuredGrid* output)
{
  const auto& pieces = blocks.GetPieces();
  const gatun::ArrayMatcher points(
    pieces, blocks.GetBlocks(), blocks.IsComposite(), vtkDataObject::POINT);
  const gatun::ArrayMatcher cells(
    pieces, blocks.GetBlocks(), blocks.IsComposite(), vtkDataObject::CELL);
  const bool isFirst = !this->Controller || this->Controller->GetLocalProcessId() == 0;
  for (const gatun::ArrayMatcher* matcher : { &points, &cells })
  {
    for (const std::string& warning : matcher->GetWarnings())
    {
      if (isFirst) // all processes have the same ones
      {
        vtkWarningMacro(<< warning);
      }
    }
  }
  for (const std::string& message : blocks.GetMessages())
  {
    vtkWarningMacro(<< message);
  }
  if (blocks.IsComposite())
  {
    AddBlockIds(blocks);
  }

  const auto own = blocks.GetOwnPieces();
  const bool merge = this->MergeCoincidentPoints || (own.size() > 1 && HaveGlobalPointIds(blocks));
  auto* const single = own.size() == 1 ? vtkUnstructuredGrid::SafeDownCast(own.front()) : nullptr;
  if (single && !merge && pieces.size() == 1)
  {
    output->ShallowCopy(single);
  }
  else if (!own.empty())
  {
    Append(blocks, merge, output);
    if (merge && !points.GetFilled().empty())
    {
      RestoreValues(blocks, points, output);
    }
    const vtkIdType joined = std::accumulate(own.begin(), own.end(), -output->GetNumberOfPoints(),
      [](vtkIdType sum, vtkDataSet* piece) { return sum + piece->GetNumberOfPoints(); });
    if (joined > 0 && !this->MergeCoincidentPoints)
    {
      vtkWarningMacro(<< joined
                      << " points of blocks were joined with others that have the same "
                         "global id");
    }
  }

  output->GetFieldData()->ShallowCopy(blocks.GetField());
  if (blocks.IsComposite())
  {
    vtkNew<vtkStringArray> names;
    names->SetName(gatun::BlockNamesName);
    for (const std::string& name : blocks.GetNames())
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
