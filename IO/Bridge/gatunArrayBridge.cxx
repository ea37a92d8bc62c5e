// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunArrayBridge.h"

#include "gatunArrayKeys.h"
#include "gatunError.h"
#include "gatunNewArray.h"

#include "vtkAbstractArray.h"
#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <bit>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>

static_assert(std::endian::native == std::endian::little, "Field data are stored little-endian.");

namespace
{

using gatun::ScalarType;

//------------------------------------------------------------------------------
template <typename T>
constexpr ScalarType IntegerType()
{
  constexpr bool isSigned = std::numeric_limits<T>::is_signed;
  switch (sizeof(T))
  {
    case 1:
      return isSigned ? ScalarType::Int8 : ScalarType::UInt8;
    case 2:
      return isSigned ? ScalarType::Int16 : ScalarType::UInt16;
    case 4:
      return isSigned ? ScalarType::Int32 : ScalarType::UInt32;
    default:
      return isSigned ? ScalarType::Int64 : ScalarType::UInt64;
  }
}

//------------------------------------------------------------------------------
// How the values of a VTK type are stored; none for types that are not numeric.
std::optional<ScalarType> StoredType(int vtkType)
{
  switch (vtkType)
  {
    case VTK_BIT:
      return ScalarType::UInt8;
    case VTK_CHAR:
      return IntegerType<char>();
    case VTK_SIGNED_CHAR:
      return IntegerType<signed char>();
    case VTK_UNSIGNED_CHAR:
      return IntegerType<unsigned char>();
    case VTK_SHORT:
      return IntegerType<short>();
    case VTK_UNSIGNED_SHORT:
      return IntegerType<unsigned short>();
    case VTK_INT:
      return IntegerType<int>();
    case VTK_UNSIGNED_INT:
      return IntegerType<unsigned int>();
    case VTK_LONG:
      return IntegerType<long>();
    case VTK_UNSIGNED_LONG:
      return IntegerType<unsigned long>();
    case VTK_LONG_LONG:
      return IntegerType<long long>();
    case VTK_UNSIGNED_LONG_LONG:
      return IntegerType<unsigned long long>();
    case VTK_ID_TYPE:
      return IntegerType<vtkIdType>();
    case VTK_FLOAT:
      return ScalarType::Float32;
    case VTK_DOUBLE:
      return ScalarType::Float64;
    default:
      return {};
  }
}

//------------------------------------------------------------------------------
int FixedSizeType(ScalarType type)
{
  switch (type)
  {
    case ScalarType::Int8:
      return VTK_TYPE_INT8;
    case ScalarType::UInt8:
      return VTK_TYPE_UINT8;
    case ScalarType::Int16:
      return VTK_TYPE_INT16;
    case ScalarType::UInt16:
      return VTK_TYPE_UINT16;
    case ScalarType::Int32:
      return VTK_TYPE_INT32;
    case ScalarType::UInt32:
      return VTK_TYPE_UINT32;
    case ScalarType::Int64:
      return VTK_TYPE_INT64;
    case ScalarType::UInt64:
      return VTK_TYPE_UINT64;
    case ScalarType::Float32:
      return VTK_TYPE_FLOAT32;
    case ScalarType::Float64:
      break;
  }
  return VTK_TYPE_FLOAT64;
}

//------------------------------------------------------------------------------
std::vector<std::string> ComponentNamesOf(vtkAbstractArray* array)
{
  std::vector<std::string> names;
  if (array->HasAComponentName())
  {
    for (int component = 0; component < array->GetNumberOfComponents(); ++component)
    {
      const char* name = array->GetComponentName(component);
      names.emplace_back(name ? name : "");
    }
  }
  return names;
}

//------------------------------------------------------------------------------
void SetNames(
  vtkAbstractArray* array, const std::string& name, const std::vector<std::string>& components)
{
  array->SetName(name.empty() ? nullptr : name.c_str());
  for (std::size_t component = 0; component < components.size(); ++component)
  {
    if (!components[component].empty())
    {
      array->SetComponentName(static_cast<vtkIdType>(component), components[component].c_str());
    }
  }
}

//------------------------------------------------------------------------------
std::string NameOf(vtkAbstractArray* array)
{
  return array->GetName() ? array->GetName() : "";
}

} // anonymous namespace

namespace gatun
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> Contiguous(vtkDataArray* array)
{
  if (auto* bits = vtkBitArray::SafeDownCast(array))
  {
    auto bytes = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(VTK_UNSIGNED_CHAR));
    bytes->SetNumberOfComponents(bits->GetNumberOfComponents());
    SizeArray(bytes, bits->GetNumberOfTuples());
    auto* to = static_cast<unsigned char*>(bytes->GetVoidPointer(0));
    for (vtkIdType i = 0; i < bits->GetNumberOfValues(); ++i)
    {
      to[i] = static_cast<unsigned char>(bits->GetValue(i));
    }
    return bytes;
  }
  if (array->HasStandardMemoryLayout())
  {
    return array;
  }
  // Not by DeepCopy, which may go through double.
  auto copy = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(array->GetDataType()));
  copy->SetNumberOfComponents(array->GetNumberOfComponents());
  SizeArray(copy, array->GetNumberOfTuples());
  if (array->GetNumberOfValues() == 1)
  {
    // VTK 9.6 does not export a single value of an implicit array.
    std::memcpy(copy->GetVoidPointer(0), array->GetVoidPointer(0),
      static_cast<std::size_t>(array->GetDataTypeSize()));
  }
  else if (array->GetNumberOfValues() > 0)
  {
    array->ExportToVoidPointer(copy->GetVoidPointer(0));
  }
  return copy;
}

//------------------------------------------------------------------------------
PointsDescription DescribePoints(vtkDataArray* points)
{
  return { NameOf(points), ComponentNamesOf(points), FindKeys(points).Keys };
}

//------------------------------------------------------------------------------
void SetDescription(vtkDataArray* points, const PointsDescription& description)
{
  SetNames(points, description.Name, description.ComponentNames);
  SetKeys(points, description.Keys);
}

//------------------------------------------------------------------------------
void CopyNames(vtkAbstractArray* from, vtkAbstractArray* to)
{
  SetNames(to, NameOf(from), ComponentNamesOf(from));
  if (from->HasInformation())
  {
    to->CopyInformation(from->GetInformation());
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAbstractArray> Gather(
  vtkAbstractArray* array, const std::vector<vtkIdType>& tuples)
{
  const auto size = static_cast<vtkIdType>(tuples.size());
  auto gathered = vtk::TakeSmartPointer(vtkAbstractArray::CreateArray(array->GetDataType()));
  gathered->SetNumberOfComponents(array->GetNumberOfComponents());
  SizeArray(gathered, size);
  CopyNames(array, gathered);
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (numbers && array->GetDataType() != VTK_BIT)
  {
    const auto values = Contiguous(numbers);
    const auto bytes = static_cast<std::size_t>(values->GetDataTypeSize()) *
      static_cast<std::size_t>(values->GetNumberOfComponents());
    const auto* from = static_cast<const unsigned char*>(values->GetVoidPointer(0));
    auto* to = static_cast<unsigned char*>(gathered->GetVoidPointer(0));
    for (const vtkIdType tuple : tuples)
    {
      std::memcpy(to, from + static_cast<std::size_t>(tuple) * bytes, bytes);
      to += bytes;
    }
  }
  else
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      gathered->SetTuple(i, tuples[static_cast<std::size_t>(i)], array);
    }
  }
  return gathered;
}

//------------------------------------------------------------------------------
BridgedArray Bridge(vtkAbstractArray* array, Association where)
{
  const std::string place = where == Association::Point ? "point" : "cell";
  const auto type = StoredType(array->GetDataType());
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers || !type)
  {
    throw Error(ErrorCode::InvalidInput,
      "the " + place + " array '" + NameOf(array) + "' is a " + array->GetClassName() +
        ", which a .gtn file cannot hold; deselect it (gtn pack --skip)");
  }
  BridgedArray bridged;
  bridged.Description.Name = NameOf(array);
  bridged.Description.Where = where;
  bridged.Description.Type = *type;
  bridged.Description.Components = static_cast<std::uint32_t>(array->GetNumberOfComponents());
  bridged.Description.VTKType = array->GetDataType();
  bridged.Description.ComponentNames = ComponentNamesOf(array);
  FoundKeys found = FindKeys(array);
  bridged.Description.Keys = std::move(found.Keys);
  bridged.RefusedKeys = std::move(found.Refused);
  bridged.Owner = Contiguous(numbers);
  bridged.Values = bridged.Owner->GetVoidPointer(0);
  return bridged;
}

//------------------------------------------------------------------------------
void GatherAll(
  vtkDataSetAttributes* from, const std::vector<vtkIdType>& tuples, vtkDataSetAttributes* to)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = from->GetAbstractArray(i);
    AddWithRoles(to, Gather(array, tuples), AttributeRolesOf(from, array));
  }
}

//------------------------------------------------------------------------------
std::uint32_t AttributeRolesOf(vtkDataSetAttributes* attributes, vtkAbstractArray* array)
{
  std::uint32_t roles = 0;
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    if (attributes->GetAbstractAttribute(type) == array)
    {
      roles |= 1u << type;
    }
  }
  return roles;
}

//------------------------------------------------------------------------------
ArrayFiller::ArrayFiller(const ArrayDescription& description, vtkIdType tuples)
{
  const bool known = StoredType(description.VTKType) == description.Type;
  const int type = known ? description.VTKType : FixedSizeType(description.Type);
  this->Array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  this->Array->SetNumberOfComponents(static_cast<int>(description.Components));
  SizeArray(this->Array, tuples);
  SetNames(this->Array, description.Name, description.ComponentNames);
  SetKeys(this->Array, description.Keys);
  this->Bits = type == VTK_BIT;
  if (this->Bits)
  {
    this->Bytes.resize(static_cast<std::size_t>(this->Array->GetNumberOfValues()));
  }
}

//------------------------------------------------------------------------------
void* ArrayFiller::GetBuffer()
{
  return this->Bits ? this->Bytes.data() : this->Array->GetVoidPointer(0);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> ArrayFiller::Finish()
{
  if (auto* bits = vtkBitArray::SafeDownCast(this->Array))
  {
    for (std::size_t i = 0; i < this->Bytes.size(); ++i)
    {
      bits->SetValue(static_cast<vtkIdType>(i), this->Bytes[i]);
    }
    this->Bytes = {};
  }
  return this->Array;
}

//------------------------------------------------------------------------------
void AddWithRoles(
  vtkDataSetAttributes* attributes, vtkAbstractArray* array, std::uint32_t attributeRoles)
{
  const std::string name = NameOf(array);
  const bool taken = !name.empty() && attributes->HasArray(name.c_str());
  if (taken)
  {
    // AddArray would put it in the other's place.
    array->SetName(nullptr);
  }
  const int index = attributes->AddArray(array);
  if (taken)
  {
    array->SetName(name.c_str());
  }
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    if (attributeRoles >> type & 1u)
    {
      attributes->SetActiveAttribute(index, type);
    }
  }
}

//------------------------------------------------------------------------------
FieldData BridgeFieldData(vtkFieldData* field, std::vector<std::string>& refused)
{
  FieldData arrays;
  for (int i = 0; i < field->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = field->GetAbstractArray(i);
    FieldArray stored;
    stored.Name = NameOf(array);
    stored.VTKType = array->GetDataType();
    stored.Components = static_cast<std::uint32_t>(array->GetNumberOfComponents());
    stored.ComponentNames = ComponentNamesOf(array);
    FoundKeys found = FindKeys(array);
    stored.Keys = std::move(found.Keys);
    for (const std::string& key : found.Refused)
    {
      refused.push_back("the key " + key + " of the field array '" + stored.Name + "'");
    }
    if (auto* texts = vtkStringArray::SafeDownCast(array))
    {
      stored.IsText = true;
      for (vtkIdType value = 0; value < texts->GetNumberOfValues(); ++value)
      {
        stored.Texts.emplace_back(texts->GetValue(value));
      }
    }
    else
    {
      const auto type = StoredType(array->GetDataType());
      auto* numbers = vtkDataArray::SafeDownCast(array);
      if (!numbers || !type)
      {
        refused.push_back("the field array '" + stored.Name + "'");
        continue;
      }
      stored.Type = *type;
      const auto values = Contiguous(numbers);
      stored.Values.resize(
        static_cast<std::size_t>(values->GetNumberOfValues()) * SizeOf(stored.Type));
      if (!stored.Values.empty())
      {
        std::memcpy(stored.Values.data(), values->GetVoidPointer(0), stored.Values.size());
      }
    }
    arrays.push_back(std::move(stored));
  }
  return arrays;
}

//------------------------------------------------------------------------------
bool AreEqual(vtkAbstractArray* a, vtkAbstractArray* b)
{
  const auto describe = [](vtkAbstractArray* array)
  {
    vtkNew<vtkFieldData> field;
    field->AddArray(array);
    std::vector<std::string> refused;
    return BridgeFieldData(field, refused);
  };
  const FieldData first = describe(a);
  return a == b || (!first.empty() && first == describe(b));
}

//------------------------------------------------------------------------------
void AddFieldData(vtkFieldData* field, const FieldData& arrays)
{
  for (const FieldArray& stored : arrays)
  {
    const std::size_t tupleBytes = stored.Components * SizeOf(stored.Type);
    const bool fits = stored.IsText
      ? stored.Components > 0 && stored.Texts.size() % stored.Components == 0
      : tupleBytes > 0 && stored.Values.size() % tupleBytes == 0;
    if (!fits)
    {
      ThrowCorrupt("the field array '" + stored.Name + "' is not a whole number of tuples");
    }
    vtkSmartPointer<vtkAbstractArray> array;
    if (stored.IsText)
    {
      vtkNew<vtkStringArray> texts;
      texts->SetNumberOfComponents(static_cast<int>(stored.Components));
      texts->SetNumberOfValues(static_cast<vtkIdType>(stored.Texts.size()));
      for (std::size_t i = 0; i < stored.Texts.size(); ++i)
      {
        texts->SetValue(static_cast<vtkIdType>(i), stored.Texts[i]);
      }
      SetNames(texts, stored.Name, stored.ComponentNames);
      SetKeys(texts, stored.Keys);
      array = texts;
    }
    else
    {
      ArrayDescription description;
      description.Name = stored.Name;
      description.Type = stored.Type;
      description.VTKType = stored.VTKType;
      description.Components = stored.Components;
      description.ComponentNames = stored.ComponentNames;
      description.Keys = stored.Keys;
      ArrayFiller filler(description, static_cast<vtkIdType>(stored.Values.size() / tupleBytes));
      if (!stored.Values.empty())
      {
        std::memcpy(filler.GetBuffer(), stored.Values.data(), stored.Values.size());
      }
      array = filler.Finish();
    }
    // As in AddWithRoles: a name may come twice.
    const bool taken = !stored.Name.empty() && field->HasArray(stored.Name.c_str());
    if (taken)
    {
      array->SetName(nullptr);
    }
    field->AddArray(array);
    if (taken)
    {
      array->SetName(stored.Name.c_str());
    }
  }
}

}
