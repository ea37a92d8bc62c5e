// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBlockList.h"

#include "gatunArrayBridge.h"
#include "gatunBlockArrays.h"
#include "gatunBytes.h"
#include "gatunGhosts.h"
#include "gatunPartExchange.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <map>
#include <utility>

namespace gatun
{
namespace
{
//------------------------------------------------------------------------------
bool IsEmpty(vtkDataSet* piece)
{
  return piece->GetNumberOfPoints() == 0 && piece->GetNumberOfCells() == 0;
}

//------------------------------------------------------------------------------
/** Describes arrays, without their values. */
void PutArrays(ByteWriter& out, vtkDataSetAttributes* attributes)
{
  out.PutVarint(static_cast<std::uint64_t>(attributes->GetNumberOfArrays()));
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = attributes->GetAbstractArray(i);
    out.Put<std::uint8_t>(array->GetName() != nullptr);
    out.PutString(array->GetName() ? array->GetName() : "");
    out.Put<std::int32_t>(array->GetDataType());
    out.Put<std::int32_t>(array->GetNumberOfComponents());
    out.Put<std::uint32_t>(AttributeRolesOf(attributes, array));
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      const char* const name = array->HasAComponentName() ? array->GetComponentName(c) : nullptr;
      out.Put<std::uint8_t>(name != nullptr);
      out.PutString(name ? name : "");
    }
  }
}

//------------------------------------------------------------------------------
/** Adds arrays without values. */
void AddArrays(ByteReader& in, vtkDataSetAttributes* attributes)
{
  for (auto count = in.GetVarint(); count > 0; --count)
  {
    const bool hasName = in.Get<std::uint8_t>() != 0;
    const std::string name = in.GetString();
    auto array = vtk::TakeSmartPointer(vtkAbstractArray::CreateArray(in.Get<std::int32_t>()));
    if (hasName)
    {
      array->SetName(name.c_str());
    }
    array->SetNumberOfComponents(in.Get<std::int32_t>());
    const auto roles = in.Get<std::uint32_t>();
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      const bool isNamed = in.Get<std::uint8_t>() != 0;
      const std::string component = in.GetString();
      if (isNamed)
      {
        array->SetComponentName(c, component.c_str());
      }
    }
    AddWithRoles(attributes, array, roles);
  }
}
}

//------------------------------------------------------------------------------
BlockList::BlockList(bool isComposite)
  : Composite(isComposite)
{
}

BlockList::~BlockList() = default;

//------------------------------------------------------------------------------
void BlockList::AddField(vtkFieldData* field)
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

//------------------------------------------------------------------------------
/** Adds the field arrays of the pieces to those of the trees: once what is equal in all, and
 * otherwise each with the name of its block behind its own. */
void BlockList::JoinFields()
{
  std::vector<std::string> names; // in order
  std::map<std::string, std::vector<std::pair<vtkAbstractArray*, std::string>>> found;
  for (const auto& [field, label, block] : this->PieceFields)
  {
    for (int i = 0; i < field->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = field->GetAbstractArray(i);
      if (!array->GetName())
      {
        this->Field->AddArray(array);
        continue;
      }
      auto& arrays = found[array->GetName()];
      if (arrays.empty())
      {
        names.emplace_back(array->GetName());
      }
      arrays.emplace_back(array, label);
    }
  }
  for (const std::string& name : names)
  {
    const auto& arrays = found[name];
    vtkAbstractArray* const known = this->Field->GetAbstractArray(name.c_str());
    vtkAbstractArray* const first = known ? known : arrays.front().first;
    const auto isEqual = [first](const auto& other) { return AreEqual(first, other.first); };
    if (std::all_of(arrays.begin(), arrays.end(), isEqual))
    {
      this->Field->AddArray(first);
      continue;
    }
    for (const auto& array : arrays)
    {
      if (known && isEqual(array))
      {
        continue;
      }
      const std::string own = name + " (" + array.second + ")";
      std::string free = own;
      for (int i = 2; this->Field->HasArray(free.c_str()) || found.count(free) > 0; ++i)
      {
        free = own + " (" + std::to_string(i) + ")";
      }
      this->Field->AddArray(Renamed(array.first, free));
    }
  }
}

//------------------------------------------------------------------------------
void BlockList::AddPiece(vtkDataSet* data, int block)
{
  auto copy = vtk::TakeSmartPointer(data->NewInstance());
  copy->ShallowCopy(data);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(copy);
  if (grid && GhostsWith(grid->GetCellData(), vtkDataSetAttributes::DUPLICATECELL))
  {
    grid->RemoveGhostCells();
    ClearGhosts(grid->GetCellData(), vtkDataSetAttributes::DUPLICATECELL);
    ClearGhosts(grid->GetPointData(), vtkDataSetAttributes::DUPLICATEPOINT);
  }
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    for (const std::string& message : NameArrays(copy->GetAttributes(association),
           association == vtkDataObject::POINT ? "point" : "cell"))
    {
      this->Messages.insert(message);
    }
  }
  this->Pieces.push_back(copy);
  this->Blocks.push_back(block);
  this->Own.push_back(true);
  this->PieceFields.push_back({ data->GetFieldData(), "", block });
}

//------------------------------------------------------------------------------
int BlockList::AddBlock(const Place& place, const char* name)
{
  this->Entries.push_back({ place, {} });
  if (name)
  {
    this->Entries.back().Name = name;
  }
  return static_cast<int>(this->Entries.size()) - 1;
}

//------------------------------------------------------------------------------
void BlockList::Add(int input, vtkDataObject* data)
{
  this->AddTo({ input }, data);
}

//------------------------------------------------------------------------------
void BlockList::AddTo(const Place& place, vtkDataObject* data)
{
  if (auto* set = vtkDataSet::SafeDownCast(data))
  {
    this->AddPiece(set, this->Composite ? this->AddBlock(place, nullptr) : 0);
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
  iterator->SkipEmptyNodesOff(); // what is missing here may be in another process
  int partitions = -1;
  Place child = place;
  child.push_back(-1);
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    ++child.back();
    vtkDataObject* const object = iterator->GetCurrentDataObject();
    auto* const set = vtkDataSet::SafeDownCast(object);
    auto* const parts = vtkPartitionedDataSet::SafeDownCast(object);
    if (!set && !parts)
    {
      this->AddTo(child, object);
      continue;
    }
    const char* name = nullptr;
    if (iterator->HasCurrentMetaData())
    {
      name = iterator->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME());
    }
    if (parts)
    {
      const int block = this->AddBlock(child, name);
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
      partitions = partitions < 0 ? this->AddBlock(place, nullptr) : partitions;
      this->AddPiece(set, partitions);
    }
    else
    {
      this->AddPiece(set, this->AddBlock(child, name));
    }
  }
}

//------------------------------------------------------------------------------
/** Empty pieces do not determine which arrays exist. */
void BlockList::DropEmpty()
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < this->Pieces.size(); ++i)
  {
    if (!IsEmpty(this->Pieces[i]))
    {
      this->Pieces[kept] = this->Pieces[i];
      this->Blocks[kept++] = this->Blocks[i];
    }
  }
  this->Pieces.resize(kept);
  this->Blocks.resize(kept);
  this->Own.resize(kept);
}

//------------------------------------------------------------------------------
std::vector<std::uint8_t> BlockList::Describe(bool isSingle, bool hasUnused) const
{
  ByteWriter out;
  out.Put<std::uint8_t>(isSingle);
  out.Put<std::uint8_t>(hasUnused);
  out.PutVarint(this->Entries.size());
  for (const auto& entry : this->Entries)
  {
    out.PutVarint(entry.Where.size());
    for (const int index : entry.Where)
    {
      out.Put<std::int32_t>(index);
    }
    out.Put<std::uint8_t>(entry.Name.has_value());
    out.PutString(entry.Name.value_or(""));
  }
  out.PutVarint(this->Pieces.size());
  for (std::size_t i = 0; i < this->Pieces.size(); ++i)
  {
    out.PutVarint(static_cast<std::uint64_t>(this->Blocks[i]));
    PutArrays(out, this->Pieces[i]->GetPointData());
    PutArrays(out, this->Pieces[i]->GetCellData());
  }
  return out.Data;
}

//------------------------------------------------------------------------------
void BlockList::Agree(PartExchange& exchange, bool isSingle, bool hasUnused)
{
  PartExchange::Message description;
  const auto first = this->Pieces.empty() ? nullptr : this->Pieces.front();
  const int blockOfFirst = this->Blocks.empty() ? 0 : this->Blocks.front();
  exchange.Together(
    [&]
    {
      this->DropEmpty();
      description = this->Describe(isSingle, hasUnused);
    });
  const auto messages = exchange.Gather(description);

  struct Described
  {
    vtkSmartPointer<vtkDataSet> Piece;
    bool IsOwn = false;
  };
  std::map<Place, std::optional<std::string>> names;
  std::map<Place, std::vector<Described>> pieces; // of each block, by process
  for (std::size_t process = 0; process < messages.size(); ++process)
  {
    const bool isOwn = static_cast<int>(process) == exchange.GetProcess();
    ByteReader in(messages[process]);
    this->Single = in.Get<std::uint8_t>() != 0 && this->Single;
    this->Unused = in.Get<std::uint8_t>() != 0 || this->Unused;
    std::vector<Place> places(static_cast<std::size_t>(in.GetVarint()));
    for (auto& place : places)
    {
      place.resize(static_cast<std::size_t>(in.GetVarint()));
      for (int& index : place)
      {
        index = in.Get<std::int32_t>();
      }
      const bool hasName = in.Get<std::uint8_t>() != 0;
      const std::string name = in.GetString();
      auto& known = names[place];
      if (hasName && !known)
      {
        known = name;
      }
    }
    const auto count = static_cast<std::size_t>(in.GetVarint());
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto block = static_cast<std::size_t>(in.GetVarint());
      auto& added = pieces[this->Composite ? places[block] : Place()];
      vtkNew<vtkUnstructuredGrid> described;
      AddArrays(in, described->GetPointData());
      AddArrays(in, described->GetCellData());
      vtkDataSet* const piece = isOwn ? this->Pieces[i].Get() : described.Get();
      added.push_back({ piece, isOwn });
    }
  }

  this->Pieces.clear();
  this->Blocks.clear();
  this->Own.clear();
  std::map<Place, int> numbers;
  for (const auto& [place, name] : names)
  {
    const auto number = static_cast<int>(this->Names.size());
    numbers.emplace(place, number);
    this->Names.push_back(name ? *name : "Block " + std::to_string(number));
  }
  for (auto& [field, label, block] : this->PieceFields)
  {
    const auto number = numbers.find(
      this->Composite ? this->Entries[static_cast<std::size_t>(block)].Where : Place());
    label =
      number != numbers.end() ? this->Names[static_cast<std::size_t>(number->second)] : "piece";
  }
  exchange.Together([this] { this->JoinFields(); });
  for (const auto& [place, ofBlock] : pieces)
  {
    for (const auto& described : ofBlock)
    {
      this->Pieces.push_back(described.Piece);
      this->Blocks.push_back(this->Composite ? numbers[place] : 0);
      this->Own.push_back(described.IsOwn);
    }
  }
  if (this->Pieces.empty() && first)
  {
    this->Pieces.push_back(first);
    this->Blocks.push_back(
      this->Composite ? numbers[this->Entries[static_cast<std::size_t>(blockOfFirst)].Where] : 0);
    this->Own.push_back(true);
  }
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkDataSet>> BlockList::GetOwnPieces() const
{
  std::vector<vtkSmartPointer<vtkDataSet>> own;
  for (std::size_t i = 0; i < this->Pieces.size(); ++i)
  {
    if (this->Own[i])
    {
      own.push_back(this->Pieces[i]);
    }
  }
  return own;
}
}
