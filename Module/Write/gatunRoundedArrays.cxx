// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunRoundedArrays.h"

#include "gatunError.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace gatun
{
namespace
{
// As VTK numbers them.
constexpr std::uint32_t RolesOfIds = 1u << 5 | 1u << 6; // global ids, pedigree ids
constexpr std::int32_t IdType = 12;

bool IsIdentity(const ArrayDescription& array)
{
  return (array.AttributeRoles & RolesOfIds) != 0 || array.VTKType == IdType ||
    array.Name == "vtkGhostType";
}

void CheckBoundOf(const ArrayError& error, const ArrayDescription& array)
{
  const auto fail = [&](const std::string& what)
  { ThrowInvalid("array '" + error.Array + "' cannot have an error: " + what); };
  if (IsIdentity(array))
  {
    fail("it has ids or marks of ghosts");
  }
  if (!IsFloating(array.Type) && error.Bound.Kind >= ErrorKind::Pointwise)
  {
    fail("it has integers, which can have absolute and relative bounds only");
  }
  if (error.Bound.Kind == ErrorKind::Absolute && array.Type == ScalarType::Float32 &&
    error.Bound.Bound > static_cast<double>(std::numeric_limits<float>::max()))
  {
    fail("the bound is larger than all numbers of its type");
  }
}
}

//------------------------------------------------------------------------------
ErrorBound FindBound(const std::vector<ArrayError>& errors, const ArrayDescription& array)
{
  if (IsIdentity(array))
  {
    return {};
  }
  const auto find = [&](const std::string& name)
  {
    return std::find_if(
      errors.begin(), errors.end(), [&](const ArrayError& error) { return error.Array == name; });
  };
  auto found = find(array.Name);
  if (found == errors.end() && IsFloating(array.Type))
  {
    found = find("*");
  }
  return found == errors.end() ? ErrorBound() : found->Bound;
}

//------------------------------------------------------------------------------
RoundingRequest GetRoundingRequest(const WriterOptions& options, const ArrayDescription& array)
{
  return { FindBound(options.Errors, array),
    options.Levels > 0 || options.Boundary || options.Layers.has_value() };
}

//------------------------------------------------------------------------------
void CheckErrors(const std::vector<ArrayDescription>& arrays, const std::vector<ArrayError>& errors)
{
  for (std::size_t i = 0; i < errors.size(); ++i)
  {
    const auto& error = errors[i];
    CheckError(error);
    if (std::any_of(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(i),
          [&](const ArrayError& other) { return other.Array == error.Array; }))
    {
      ThrowInvalid("array '" + error.Array + "' has two bounds of errors");
    }
    bool isThere = error.Array == "*";
    for (const auto& array : arrays)
    {
      if (array.Name == error.Array)
      {
        CheckBoundOf(error, array);
        isThere = true;
      }
    }
    if (!isThere)
    {
      ThrowInvalid("there is no array '" + error.Array + "' that could have an error");
    }
  }
}

//------------------------------------------------------------------------------
RoundedArray::RoundedArray(const ArrayDescription& array, const void* original, std::size_t tuples)
  : Array(array)
  , Original(static_cast<const std::uint8_t*>(original))
  , Tuples(tuples)
  , Errors(array.Components, 0)
{
  this->Values.assign(this->Original, this->Original + this->Place(tuples, 0));
}

//------------------------------------------------------------------------------
void RoundedArray::PutOnLattice(std::span<const Domain> domains,
  std::span<const std::uint32_t> shared, std::span<const std::uint32_t> unused)
{
  for (std::size_t c = 0; c < domains.size(); ++c)
  {
    const auto& rounding = domains[c].GetQuantizer();
    if (!rounding)
    {
      continue;
    }
    const auto round = [&](std::size_t tuple)
    {
      const Key key = domains[c].Read(this->Original + this->Place(tuple, c));
      this->Take(domains[c], tuple, c, rounding.ToLattice(this->Array.Type, key));
    };
    for (std::size_t i = 0; rounding.OnLattice && i < this->Tuples; ++i)
    {
      round(i);
    }
    if (!rounding.OnLattice)
    {
      std::for_each(shared.begin(), shared.end(), round);
      std::for_each(unused.begin(), unused.end(), round);
    }
  }
}

//------------------------------------------------------------------------------
void RoundedArray::Take(const Domain& domain, std::size_t tuple, std::size_t component, Key key)
{
  const auto& rounding = domain.GetQuantizer();
  if (!rounding)
  {
    return;
  }
  const auto type = this->Array.Type;
  const auto place = this->Place(tuple, component);
  const Key original = domain.Read(this->Original + place);
  if (!rounding.IsWithin(type, original, key))
  {
    ThrowInvalid("a value of array '" + this->Array.Name + "' has too large an error");
  }
  domain.Write(key, this->Values.data() + place);
  if (const double error = rounding.Measure(type, original, key); error > 0)
  {
    const std::lock_guard lock(this->ErrorsMutex);
    this->Errors[component] = std::max(this->Errors[component], error);
  }
}

//------------------------------------------------------------------------------
void RoundedArray::Copy(const RoundedArray& source, std::span<const std::uint32_t> components,
  std::span<const std::uint32_t> tuples)
{
  const auto size = SizeOf(this->Array.Type);
  for (const auto tuple : tuples)
  {
    for (std::size_t c = 0; c < components.size(); ++c)
    {
      std::memcpy(this->Values.data() + this->Place(tuple, c),
        source.Values.data() + source.Place(tuple, components[c]), size);
    }
  }
}
}
