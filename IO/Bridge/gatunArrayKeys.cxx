// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunArrayKeys.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationIdTypeKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationIntegerVectorKey.h"
#include "vtkInformationIterator.h"
#include "vtkInformationKeyLookup.h"
#include "vtkInformationQuadratureSchemeDefinitionVectorKey.h"
#include "vtkInformationStringKey.h"
#include "vtkInformationStringVectorKey.h"
#include "vtkInformationUnsignedLongKey.h"
#include "vtkNew.h"
#include "vtkQuadratureSchemeDefinition.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <mutex>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>

namespace gatun
{
namespace
{
using QuadratureKey = vtkInformationQuadratureSchemeDefinitionVectorKey;

/** Whether a key depends on the values, or steers Gatun's writer: it is no part of the data. */
bool IsComputed(std::string_view location, std::string_view name)
{
  constexpr std::array<std::string_view, 7> computed{ "COMPONENT_RANGE", "L2_NORM_RANGE",
    "L2_NORM_FINITE_RANGE", "PER_COMPONENT", "PER_FINITE_COMPONENT", "DISCRETE_VALUES",
    "DISCRETE_VALUE_SAMPLE_PARAMETERS" };
  const bool ofArrays = location == "vtkDataArray" || location == "vtkAbstractArray";
  return location == "vtkGatunWriter" ||
    (ofArrays && std::find(computed.begin(), computed.end(), name) != computed.end());
}

/** Keys that VTK makes on their first use are made before they are looked up. */
void MakeKnownKeys()
{
  vtkAbstractArray::GUI_HIDE();
  vtkDataArray::UNITS_LABEL();
  vtkQuadratureSchemeDefinition::DICTIONARY();
  vtkQuadratureSchemeDefinition::QUADRATURE_OFFSET_ARRAY_NAME();
}

/** A scheme of integration as numbers: its place, the type of cells, the numbers of nodes and of
 * quadrature points, and the weights of both. */
void AddScheme(ArrayKey& to, int place, vtkQuadratureSchemeDefinition* scheme)
{
  const auto add = [&](double number)
  { to.Numbers.push_back(std::bit_cast<std::uint64_t>(number)); };
  const int nodes = scheme->GetNumberOfNodes();
  const int points = scheme->GetNumberOfQuadraturePoints();
  for (const int number : { place, scheme->GetCellType(), nodes, points })
  {
    add(number);
  }
  for (int i = 0; i < nodes * points; ++i)
  {
    add(scheme->GetShapeFunctionWeights()[i]);
  }
  for (int i = 0; i < points; ++i)
  {
    add(scheme->GetQuadratureWeights()[i]);
  }
}

/** Sets schemes of integration as far as the numbers make sense. */
void SetSchemes(vtkInformation* info, QuadratureKey* key, std::span<const std::uint64_t> bits)
{
  constexpr double places = 1024; // more than there are types of cells
  std::vector<double> numbers;
  for (const std::uint64_t number : bits)
  {
    numbers.push_back(std::bit_cast<double>(number));
  }
  std::size_t at = 0;
  const auto take = [&](double limit)
  {
    const double number = at < numbers.size() ? numbers[at] : -1;
    ++at;
    return number >= 0 && number < limit ? static_cast<int>(number) : -1;
  };
  while (at < numbers.size())
  {
    const int place = take(places);
    const int type = take(places);
    const int nodes = take(1 << 15);
    const int points = take(1 << 15);
    const auto weights =
      static_cast<std::size_t>(std::max(nodes, 0)) * static_cast<std::size_t>(std::max(points, 0));
    if (place < 0 || type < 0 || nodes < 1 || points < 1 ||
      numbers.size() - at < weights + static_cast<std::size_t>(points))
    {
      return;
    }
    vtkNew<vtkQuadratureSchemeDefinition> scheme;
    scheme->Initialize(type, nodes, points, &numbers[at], &numbers[at + weights]);
    key->Set(info, scheme, place);
    at += weights + static_cast<std::size_t>(points);
  }
}

/** Reads the value of a key. Returns false if its type is none that a file can hold. */
bool ReadKey(vtkInformation* info, vtkInformationKey* key, ArrayKey& to)
{
  const auto addInteger = [&](KeyKind kind, std::int64_t number)
  {
    to.Kind = kind;
    to.Numbers.push_back(static_cast<std::uint64_t>(number));
  };
  if (auto* one = vtkInformationIntegerKey::SafeDownCast(key))
  {
    addInteger(KeyKind::Integer, one->Get(info));
  }
  else if (auto* id = vtkInformationIdTypeKey::SafeDownCast(key))
  {
    addInteger(KeyKind::Id, id->Get(info));
  }
  else if (auto* natural = vtkInformationUnsignedLongKey::SafeDownCast(key))
  {
    addInteger(KeyKind::Unsigned, static_cast<std::int64_t>(natural->Get(info)));
  }
  else if (auto* real = vtkInformationDoubleKey::SafeDownCast(key))
  {
    addInteger(KeyKind::Double, std::bit_cast<std::int64_t>(real->Get(info)));
  }
  else if (auto* text = vtkInformationStringKey::SafeDownCast(key))
  {
    to.Kind = KeyKind::Text;
    to.Texts.emplace_back(text->Get(info) ? text->Get(info) : "");
  }
  else if (auto* integers = vtkInformationIntegerVectorKey::SafeDownCast(key))
  {
    to.Kind = KeyKind::Integers;
    for (int i = 0; i < integers->Length(info); ++i)
    {
      addInteger(KeyKind::Integers, integers->Get(info, i));
    }
  }
  else if (auto* reals = vtkInformationDoubleVectorKey::SafeDownCast(key))
  {
    to.Kind = KeyKind::Doubles;
    for (int i = 0; i < reals->Length(info); ++i)
    {
      addInteger(KeyKind::Doubles, std::bit_cast<std::int64_t>(reals->Get(info, i)));
    }
  }
  else if (auto* texts = vtkInformationStringVectorKey::SafeDownCast(key))
  {
    to.Kind = KeyKind::Texts;
    for (int i = 0; i < texts->Length(info); ++i)
    {
      to.Texts.emplace_back(texts->Get(info, i) ? texts->Get(info, i) : "");
    }
  }
  else if (auto* schemes = QuadratureKey::SafeDownCast(key))
  {
    to.Kind = KeyKind::Quadrature;
    for (int i = 0; i < schemes->Size(info); ++i)
    {
      if (vtkQuadratureSchemeDefinition* scheme = schemes->Get(info, i))
      {
        AddScheme(to, i, scheme);
      }
    }
  }
  else
  {
    return false;
  }
  return true;
}

/** The key with a name, of a class; made if there is none. Null if there is one of another class.
 */
template <typename Key>
Key* GetKey(const ArrayKey& from)
{
  vtkInformationKey* const known = vtkInformationKeyLookup::Find(from.Name, from.Location);
  return known ? Key::SafeDownCast(known) : Key::MakeKey(from.Name.c_str(), from.Location.c_str());
}

template <typename Key, typename Value>
void SetOne(vtkInformation* info, const ArrayKey& from, Value value)
{
  if (Key* const key = GetKey<Key>(from))
  {
    key->Set(info, value);
  }
}

void SetKey(vtkInformation* info, const ArrayKey& from)
{
  const auto integer = [&](std::size_t i)
  {
    const auto number = static_cast<std::int64_t>(from.Numbers[i]);
    constexpr std::int64_t most = std::numeric_limits<int>::max();
    return static_cast<int>(std::clamp(number, -most - 1, most));
  };
  switch (from.Kind)
  {
    case KeyKind::Integer:
      SetOne<vtkInformationIntegerKey>(info, from, integer(0));
      break;
    case KeyKind::Id:
      SetOne<vtkInformationIdTypeKey>(info, from, static_cast<vtkIdType>(from.Numbers[0]));
      break;
    case KeyKind::Unsigned:
      SetOne<vtkInformationUnsignedLongKey>(
        info, from, static_cast<unsigned long>(from.Numbers[0]));
      break;
    case KeyKind::Double:
      SetOne<vtkInformationDoubleKey>(info, from, std::bit_cast<double>(from.Numbers[0]));
      break;
    case KeyKind::Text:
      SetOne<vtkInformationStringKey>(info, from, from.Texts[0].c_str());
      break;
    case KeyKind::Integers:
      if (auto* key = GetKey<vtkInformationIntegerVectorKey>(from))
      {
        std::vector<int> values;
        for (std::size_t i = 0; i < from.Numbers.size(); ++i)
        {
          values.push_back(integer(i));
        }
        key->Set(info, values.data(), static_cast<int>(values.size()));
      }
      break;
    case KeyKind::Doubles:
      if (auto* key = GetKey<vtkInformationDoubleVectorKey>(from))
      {
        std::vector<double> values;
        for (const std::uint64_t number : from.Numbers)
        {
          values.push_back(std::bit_cast<double>(number));
        }
        key->Set(info, values.data(), static_cast<int>(values.size()));
      }
      break;
    case KeyKind::Texts:
      if (auto* key = GetKey<vtkInformationStringVectorKey>(from))
      {
        for (std::size_t i = 0; i < from.Texts.size(); ++i)
        {
          key->Set(info, from.Texts[i].c_str(), static_cast<int>(i));
        }
      }
      break;
    case KeyKind::Quadrature:
      if (auto* key =
            QuadratureKey::SafeDownCast(vtkInformationKeyLookup::Find(from.Name, from.Location)))
      {
        SetSchemes(info, key, from.Numbers);
      }
      break;
  }
}
}

//------------------------------------------------------------------------------
FoundKeys FindKeys(vtkAbstractArray* array)
{
  FoundKeys found;
  if (!array->HasInformation())
  {
    return found;
  }
  vtkNew<vtkInformationIterator> iterator;
  iterator->SetInformationWeak(array->GetInformation());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkInformationKey* const key = iterator->GetCurrentKey();
    ArrayKey read;
    read.Location = key->GetLocation();
    read.Name = key->GetName();
    if (IsComputed(read.Location, read.Name))
    {
      continue;
    }
    if (!read.Location.empty() && !read.Name.empty() && ReadKey(array->GetInformation(), key, read))
    {
      found.Keys.push_back(std::move(read));
    }
    else
    {
      found.Refused.push_back(read.Location + "::" + read.Name);
    }
  }
  std::sort(found.Keys.begin(), found.Keys.end(),
    [](const ArrayKey& l, const ArrayKey& r)
    { return std::tie(l.Location, l.Name) < std::tie(r.Location, r.Name); });
  return found;
}

//------------------------------------------------------------------------------
void SetKeys(vtkAbstractArray* array, const std::vector<ArrayKey>& keys)
{
  static std::mutex mutex; // VTK's list of keys has none
  const std::lock_guard lock(mutex);
  if (!keys.empty())
  {
    MakeKnownKeys();
  }
  for (const ArrayKey& key : keys)
  {
    if (!IsComputed(key.Location, key.Name))
    {
      SetKey(array->GetInformation(), key);
    }
  }
}
}
