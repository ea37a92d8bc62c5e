// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunBlockArrays.h"

#include "gatunArrayBridge.h"
#include "gatunNewArray.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>

namespace gatun
{
namespace
{
constexpr int Columns = 5;
constexpr const char* ColumnNames[Columns] = { "Block", "Association", "Roles", "Merged", "Name" };

std::string RolesToText(std::uint32_t roles)
{
  std::string text;
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    if (roles >> type & 1u)
    {
      text += (text.empty() ? "" : " ");
      text += vtkDataSetAttributes::GetAttributeTypeAsString(type);
    }
  }
  return text;
}

std::uint32_t RolesFromText(const std::string& text)
{
  std::uint32_t roles = 0;
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
    {
      if (word == vtkDataSetAttributes::GetAttributeTypeAsString(type))
      {
        roles |= 1u << type;
      }
    }
  }
  return roles;
}

/** A block number, or -1. */
int BlockFromText(const std::string& text)
{
  const bool isNumber = !text.empty() && text.size() < 10 &&
    std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  return isNumber ? std::atoi(text.c_str()) : -1;
}

}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAbstractArray> Renamed(vtkAbstractArray* array, const std::string& name)
{
  auto renamed = vtk::TakeSmartPointer(array->NewInstance());
  auto* const numbers = vtkDataArray::SafeDownCast(renamed);
  if (numbers)
  {
    numbers->ShallowCopy(vtkDataArray::SafeDownCast(array));
  }
  else
  {
    renamed->DeepCopy(array);
  }
  renamed->SetName(name.c_str());
  return renamed;
}

//------------------------------------------------------------------------------
std::vector<std::string> NameArrays(vtkDataSetAttributes* attributes, const std::string& where)
{
  std::vector<std::string> messages;
  std::vector<vtkSmartPointer<vtkAbstractArray>> unnamed;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = attributes->GetAbstractArray(i);
    if (!array->GetName() || *array->GetName() == '\0')
    {
      unnamed.emplace_back(array);
    }
  }
  for (const auto& array : unnamed)
  {
    const std::uint32_t roles = AttributeRolesOf(attributes, array);
    std::string own = "Array";
    for (int type = vtkDataSetAttributes::NUM_ATTRIBUTES - 1; type >= 0; --type)
    {
      own = roles >> type & 1u ? vtkDataSetAttributes::GetAttributeTypeAsString(type) : own;
    }
    std::string name = own;
    for (int i = 2; attributes->HasArray(name.c_str()) != 0; ++i)
    {
      name = own + " (" + std::to_string(i) + ")";
    }
    int place = 0;
    while (attributes->GetAbstractArray(place) != array)
    {
      ++place;
    }
    attributes->RemoveArray(place);
    AddWithRoles(attributes, Renamed(array, name), roles);
    messages.push_back("a " + where + " array without a name is called '" + name + "'");
  }
  return messages;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkStringArray> MakeBlockArrays(const std::vector<BlockArray>& arrays)
{
  auto table = vtkSmartPointer<vtkStringArray>::New();
  table->SetName(BlockArraysName);
  table->SetNumberOfComponents(Columns);
  for (int i = 0; i < Columns; ++i)
  {
    table->SetComponentName(i, ColumnNames[i]);
  }
  for (const BlockArray& array : arrays)
  {
    table->InsertNextValue(std::to_string(array.Block));
    table->InsertNextValue(array.Association == vtkDataObject::POINT ? "Point" : "Cell");
    table->InsertNextValue(RolesToText(array.Roles));
    table->InsertNextValue(array.Merged);
    table->InsertNextValue(array.Name);
  }
  return table;
}

//------------------------------------------------------------------------------
std::optional<std::vector<BlockArray>> ReadBlockArrays(vtkFieldData* field)
{
  auto* const table = vtkStringArray::SafeDownCast(field->GetAbstractArray(BlockArraysName));
  if (!table || table->GetNumberOfComponents() != Columns)
  {
    return {};
  }
  std::vector<BlockArray> arrays;
  std::set<std::tuple<int, int, std::string>> seen;
  for (vtkIdType row = 0; row < table->GetNumberOfTuples(); ++row)
  {
    BlockArray array;
    array.Block = BlockFromText(table->GetValue(Columns * row));
    const std::string where = table->GetValue(Columns * row + 1);
    array.Association = where == "Point" ? vtkDataObject::POINT : vtkDataObject::CELL;
    array.Roles = RolesFromText(table->GetValue(Columns * row + 2));
    array.Merged = table->GetValue(Columns * row + 3);
    array.Name = table->GetValue(Columns * row + 4);
    if (array.Block < 0 || (where != "Point" && where != "Cell"))
    {
      return {};
    }
    if (seen.emplace(array.Block, array.Association, array.Merged).second)
    {
      arrays.push_back(std::move(array));
    }
  }
  return arrays;
}

//------------------------------------------------------------------------------
/** Arrays that are one in the merged grid. */
struct ArrayMatcher::Kind
{
  vtkSmartPointer<vtkAbstractArray> First; ///< the first one
  std::string Merged;                      ///< name in the merged grid
  std::vector<std::size_t> Pieces;         ///< those that have it, in order

  bool Matches(vtkAbstractArray* array) const
  {
    return array->GetName() && std::string(this->First->GetName()) == array->GetName() &&
      this->First->GetDataType() == array->GetDataType() &&
      this->First->GetNumberOfComponents() == array->GetNumberOfComponents();
  }
};

//------------------------------------------------------------------------------
ArrayMatcher::ArrayMatcher(const std::vector<vtkSmartPointer<vtkDataSet>>& pieces,
  const std::vector<int>& blocks, bool isComposite, int association)
  : Pieces(pieces)
  , IsComposite(isComposite)
  , Association(association)
  , Lacking(pieces.size())
{
  const std::vector<Kind> kinds = this->FindKinds(blocks);
  this->Rename(kinds);
  this->FillUp(kinds);
}

//------------------------------------------------------------------------------
std::vector<ArrayMatcher::Kind> ArrayMatcher::FindKinds(const std::vector<int>& blocks)
{
  std::vector<Kind> kinds;
  std::map<std::tuple<std::string, int, int>, std::size_t> known;
  std::set<std::pair<int, std::size_t>> ofBlocks;
  std::vector<std::size_t> kindOf; // of Found
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    vtkDataSetAttributes* const attributes = this->Pieces[piece]->GetAttributes(this->Association);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = attributes->GetAbstractArray(i);
      if (!array->GetName())
      {
        continue;
      }
      const auto [at, isNew] = known.try_emplace(
        { array->GetName(), array->GetDataType(), array->GetNumberOfComponents() }, kinds.size());
      if (isNew)
      {
        kinds.push_back({ array, "", {} });
      }
      kinds[at->second].Pieces.push_back(piece);
      if (ofBlocks.emplace(blocks[piece], at->second).second)
      {
        this->Found.push_back({ blocks[piece], this->Association,
          AttributeRolesOf(attributes, array), "", array->GetName() });
        kindOf.push_back(at->second);
      }
    }
  }
  this->ChooseNames(kinds);
  for (std::size_t i = 0; i < kindOf.size(); ++i)
  {
    this->Found[i].Merged = kinds[kindOf[i]].Merged;
  }
  return kinds;
}

//------------------------------------------------------------------------------
void ArrayMatcher::ChooseNames(std::vector<Kind>& kinds) const
{
  std::set<std::string> names;
  for (const Kind& kind : kinds)
  {
    names.insert(kind.First->GetName());
  }
  std::set<std::string> taken;
  if (this->IsComposite)
  {
    taken.insert(BlockIdName);
  }
  for (Kind& kind : kinds)
  {
    const std::string name = kind.First->GetName();
    kind.Merged = name;
    for (int i = 2; taken.count(kind.Merged) > 0; ++i)
    {
      // Names that other arrays have by themselves are theirs.
      const std::string other = name + " (" + std::to_string(i) + ")";
      kind.Merged = names.count(other) > 0 ? name : other;
    }
    taken.insert(kind.Merged);
  }
}

//------------------------------------------------------------------------------
void ArrayMatcher::Rename(const std::vector<Kind>& kinds)
{
  for (const Kind& kind : kinds)
  {
    const std::string name = kind.First->GetName();
    if (kind.Merged == name)
    {
      continue;
    }
    this->Warnings.push_back("The array '" + name + "' is called '" + kind.Merged +
      "' in some blocks: its name is that of another array.");
    for (const std::size_t piece : kind.Pieces)
    {
      vtkDataSetAttributes* const attributes =
        this->Pieces[piece]->GetAttributes(this->Association);
      for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
      {
        vtkSmartPointer<vtkAbstractArray> array = attributes->GetAbstractArray(i);
        if (kind.Matches(array))
        {
          const std::uint32_t roles = AttributeRolesOf(attributes, array);
          attributes->RemoveArray(i);
          AddWithRoles(attributes, Renamed(array, kind.Merged), roles);
          break;
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void ArrayMatcher::FillUp(const std::vector<Kind>& kinds)
{
  for (const Kind& kind : kinds)
  {
    std::vector<bool> has(this->Pieces.size());
    for (const std::size_t piece : kind.Pieces)
    {
      has[piece] = true;
    }
    if (std::find(has.begin(), has.end(), false) == has.end())
    {
      continue;
    }
    this->Filled.push_back(kind.Merged);
    const int type = kind.First->GetDataType();
    const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
    bool isText = false;
    for (std::size_t piece = 0; piece < this->Pieces.size() && !isText; ++piece)
    {
      if (has[piece])
      {
        continue;
      }
      auto fill = vtk::TakeSmartPointer(vtkAbstractArray::CreateArray(type));
      auto* const numbers = vtkDataArray::SafeDownCast(fill);
      isText = !numbers;
      if (numbers)
      {
        numbers->SetNumberOfComponents(kind.First->GetNumberOfComponents());
        SizeArray(numbers, this->Pieces[piece]->GetNumberOfElements(this->Association));
        numbers->SetName(kind.Merged.c_str());
        numbers->CopyComponentNames(kind.First);
        numbers->Fill(isReal ? std::numeric_limits<double>::quiet_NaN() : 0.0);
        this->Pieces[piece]->GetAttributes(this->Association)->AddArray(numbers);
        this->Lacking[piece].push_back(kind.Merged);
      }
    }
    if (isText)
    {
      for (const std::size_t piece : kind.Pieces)
      {
        this->Pieces[piece]->GetAttributes(this->Association)->RemoveArray(kind.Merged.c_str());
      }
    }
    this->Warnings.push_back("The array '" + kind.Merged +
      (isText ? "' is dropped, because some blocks do not have it."
              : "' is filled up in blocks that do not have it."));
  }
}

//------------------------------------------------------------------------------
bool ArrayMatcher::IsFilled(std::size_t piece, const std::string& name) const
{
  const auto& names = this->Lacking[piece];
  return std::find(names.begin(), names.end(), name) != names.end();
}
}
