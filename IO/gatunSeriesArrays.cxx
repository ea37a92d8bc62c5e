// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunSeriesArrays.h"

#include "gatunDescriptionText.h"
#include "gatunError.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace
{

using gatun::ArrayDescription;
using gatun::BridgedArray;

const char* const HowToFill = "; FillMissingArrays (gtn pack --fill-missing) writes NaN, or 0 for "
                              "integers, where a step does not have an array";

// "point array 'pressure'".
std::string TitleOf(const ArrayDescription& array)
{
  return (array.Where == gatun::Association::Point ? "point array '" : "cell array '") +
    gatun::MakePrintableLine(array.Name) + "'";
}

// "float with 3 components".
std::string KindOf(const ArrayDescription& array)
{
  return std::string(vtkImageScalarTypeNameMacro(array.VTKType)) + " with " +
    std::to_string(array.Components) + (array.Components == 1 ? " component" : " components");
}

bool IsOfKind(const ArrayDescription& one, const ArrayDescription& other)
{
  return one.Type == other.Type && one.VTKType == other.VTKType &&
    one.Components == other.Components;
}

bool IsGhosts(const ArrayDescription& array)
{
  return array.Name == vtkDataSetAttributes::GhostArrayName() && array.Components == 1 &&
    array.VTKType == VTK_UNSIGNED_CHAR;
}

bool HasTuplesOf(const BridgedArray& array)
{
  return array.Owner->GetNumberOfTuples() > 0;
}

std::size_t IndexOf(gatun::Association where)
{
  return where == gatun::Association::Point ? 0 : 1;
}

// The array of the same name, and as many of this name before it: names need not be unique.
template <typename List, typename Get>
auto FindNamesake(List& list, std::size_t count, const ArrayDescription& wanted,
  std::size_t namesakes, const Get& get)
{
  const auto end = list.begin() + static_cast<std::ptrdiff_t>(count);
  return std::find_if(list.begin(), end,
    [&](const auto& entry)
    {
      const ArrayDescription& array = get(entry);
      return array.Where == wanted.Where && array.Name == wanted.Name && namesakes-- == 0;
    });
}

template <typename List, typename Get>
std::size_t CountNamesakes(const List& list, std::size_t number, const Get& get)
{
  const ArrayDescription& array = get(list[number]);
  return static_cast<std::size_t>(
    std::count_if(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(number),
      [&](const auto& entry)
      { return get(entry).Where == array.Where && get(entry).Name == array.Name; }));
}

constexpr auto DescriptionOf = [](const auto& entry) -> const ArrayDescription&
{ return entry.Description; };

} // anonymous namespace

namespace gatun
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> MakeMissingArray(int vtkType, int components, vtkIdType tuples)
{
  auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(vtkType));
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  const bool isReal = vtkType == VTK_FLOAT || vtkType == VTK_DOUBLE;
  array->Fill(isReal ? std::numeric_limits<double>::quiet_NaN() : 0.);
  return array;
}

//------------------------------------------------------------------------------
void SeriesArrays::Begin(bool fill, std::function<void(const std::string&)> warn)
{
  *this = {};
  this->Fill = fill;
  this->Warn = std::move(warn);
}

//------------------------------------------------------------------------------
void SeriesArrays::Continue(const std::vector<ArrayDescription>& arrays)
{
  this->IsContinued = true;
  this->Arrays.clear();
  for (const ArrayDescription& array : arrays)
  {
    this->Arrays.push_back({ array, true });
    this->HadTuples[IndexOf(array.Where)] = true;
  }
}

//------------------------------------------------------------------------------
bool SeriesArrays::Learn(const std::vector<BridgedArray>& arrays, const Step& step)
{
  bool isKnown = true;
  const std::size_t before = this->Arrays.size();
  std::vector<bool> isThere(before, false);
  for (std::size_t i = 0; i < arrays.size(); ++i)
  {
    const auto known = FindNamesake(this->Arrays, before, arrays[i].Description,
      CountNamesakes(arrays, i, DescriptionOf), DescriptionOf);
    const auto number = static_cast<std::size_t>(known - this->Arrays.begin());
    if (number == before)
    {
      isKnown = !this->Add(arrays[i], step) && isKnown;
      continue;
    }
    isThere[number] = true;
    isKnown = !this->Compare(*known, arrays[i], step) && isKnown;
  }
  const std::size_t tuples[] = { step.Points, step.Cells };
  for (std::size_t i = 0; i < before; ++i)
  {
    const ArrayDescription& array = this->Arrays[i].Description;
    if (!isThere[i] && tuples[IndexOf(array.Where)] > 0 && !this->Fill && !IsGhosts(array))
    {
      ThrowInvalid("in " + step.Name + " the " + TitleOf(array) + " (" + KindOf(array) +
        ") of the steps before is missing" + HowToFill);
    }
  }
  this->HadTuples[0] = this->HadTuples[0] || step.Points > 0;
  this->HadTuples[1] = this->HadTuples[1] || step.Cells > 0;
  return isKnown;
}

//------------------------------------------------------------------------------
// Adds an array that the steps before do not have. Returns whether it has to be written.
bool SeriesArrays::Add(const BridgedArray& array, const Step& step)
{
  Known added{ array.Description, HasTuplesOf(array) };
  if (this->HadTuples[IndexOf(array.Description.Where)] || this->IsContinued)
  {
    if (!added.HasTuples)
    {
      return false;
    }
    if (this->IsContinued)
    {
      ThrowInvalid("in " + step.Name + " the " + TitleOf(array.Description) + " (" +
        KindOf(array.Description) +
        ") appears, which the file does not have; gtn pack --skip leaves it out");
    }
    if (!this->Fill && !IsGhosts(array.Description))
    {
      ThrowInvalid("in " + step.Name + " the " + TitleOf(array.Description) + " (" +
        KindOf(array.Description) + ") appears, which the steps before do not have" + HowToFill);
    }
  }
  for (const Known& known : this->Arrays)
  {
    if (known.Description.Where == added.Description.Where)
    {
      added.Description.AttributeRoles &= ~known.Description.AttributeRoles;
    }
  }
  this->Arrays.push_back(std::move(added));
  return true;
}

//------------------------------------------------------------------------------
// Compares an array with that of the steps before. Returns whether more has to be written than
// before.
bool SeriesArrays::Compare(Known& known, const BridgedArray& array, const Step& step)
{
  if (!HasTuplesOf(array))
  {
    return false;
  }
  ArrayDescription& mine = known.Description;
  const ArrayDescription& other = array.Description;
  if (!std::exchange(known.HasTuples, true) && mine != other)
  {
    mine = other;
    return true;
  }
  if (!IsOfKind(mine, other))
  {
    ThrowInvalid("in " + step.Name + " the " + TitleOf(other) + " is " + KindOf(other) +
      ", and in the steps before " + KindOf(mine) +
      "; an array has one type in all steps of a file (gtn pack --arrays takes the others)");
  }
  if (mine.AttributeRoles != other.AttributeRoles)
  {
    this->Warn("the active arrays (scalars, vectors, ids and the like) are those of the first step "
               "at all steps; other ones of later steps are not kept");
  }
  if (mine.Keys != other.Keys)
  {
    this->Warn("the keys of the " + TitleOf(mine) +
      " change with time, and are those of the first step at all steps");
  }
  if (mine.ComponentNames == other.ComponentNames || other.ComponentNames.empty())
  {
    return false;
  }
  if (mine.ComponentNames.empty() && !this->IsContinued)
  {
    mine.ComponentNames = other.ComponentNames;
    return true;
  }
  this->Warn("the names of components of the " + TitleOf(mine) +
    " change with time, and are those of the first step at all steps");
  return false;
}

//------------------------------------------------------------------------------
std::vector<BridgedArray> SeriesArrays::Arrange(
  const std::vector<BridgedArray>& arrays, const Step& step) const
{
  std::vector<BridgedArray> arranged;
  for (std::size_t i = 0; i < this->Arrays.size(); ++i)
  {
    const ArrayDescription& description = this->Arrays[i].Description;
    const auto found = FindNamesake(arrays, arrays.size(), description,
      CountNamesakes(this->Arrays, i, DescriptionOf), DescriptionOf);
    if (found != arrays.end() && IsOfKind(found->Description, description))
    {
      arranged.push_back(*found);
    }
    else
    {
      const bool ofPoints = description.Where == Association::Point;
      arranged.push_back(
        Bridge(MakeMissingArray(description.VTKType, static_cast<int>(description.Components),
                 static_cast<vtkIdType>(ofPoints ? step.Points : step.Cells)),
          description.Where));
    }
    arranged.back().Description = description;
  }
  return arranged;
}
}
