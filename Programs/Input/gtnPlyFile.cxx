// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnPlyFile.h"

#include "gtnFailure.h"
#include "gtnText.h"
#include "gtnWords.h"

#include "vtkDataArray.h"
#include "vtkType.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace gtn
{
namespace
{
constexpr const char* ShortPly = "is truncated: it ends before the values that its header declares";

int PlyTypeOf(std::string_view name)
{
  constexpr std::array<std::pair<std::string_view, int>, 16> types{ { { "char", VTK_SIGNED_CHAR },
    { "int8", VTK_SIGNED_CHAR }, { "uchar", VTK_UNSIGNED_CHAR }, { "uint8", VTK_UNSIGNED_CHAR },
    { "short", VTK_SHORT }, { "int16", VTK_SHORT }, { "ushort", VTK_UNSIGNED_SHORT },
    { "uint16", VTK_UNSIGNED_SHORT }, { "int", VTK_INT }, { "int32", VTK_INT },
    { "uint", VTK_UNSIGNED_INT }, { "uint32", VTK_UNSIGNED_INT }, { "float", VTK_FLOAT },
    { "float32", VTK_FLOAT }, { "double", VTK_DOUBLE }, { "float64", VTK_DOUBLE } } };
  const auto* const found =
    std::find_if(types.begin(), types.end(), [&](const auto& type) { return type.first == name; });
  if (found == types.end())
  {
    throw Failure(fmt::format("its header has the unknown type '{}'", MakePrintableLine(name)));
  }
  return found->second;
}

template <typename T>
double TakeBinary(const char* bytes, bool isSwapped)
{
  std::array<char, sizeof(T)> ordered;
  std::copy_n(bytes, sizeof(T), ordered.begin());
  if (isSwapped)
  {
    std::reverse(ordered.begin(), ordered.end());
  }
  return static_cast<double>(std::bit_cast<T>(ordered));
}

double TakeText(std::string_view word, int type)
{
  float single = 0;
  double value = 0;
  if (type == VTK_FLOAT && ParseWord(word, single))
  {
    return single; // rounded once
  }
  if (!ParseWord(word, value))
  {
    throw Failure(fmt::format("'{}' is not a number", MakePrintableLine(word)));
  }
  const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
  if (!isReal &&
    !(std::floor(value) == value && value >= vtkDataArray::GetDataTypeMin(type) &&
      value <= vtkDataArray::GetDataTypeMax(type)))
  {
    throw Failure(fmt::format("{} is not a value of the type that its header declares", word));
  }
  return value;
}

/** Takes a line off, with its end. */
std::string_view TakeLine(std::string_view& text)
{
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  text.remove_prefix(line.size());
  text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, text.size()));
  return line;
}
}

//------------------------------------------------------------------------------
PlyFile::PlyFile(std::string_view bytes)
  : Rest(bytes)
{
  this->ReadHeader();
  this->CheckSize();
}

//------------------------------------------------------------------------------
void PlyFile::ReadHeader()
{
  if (TakeLine(this->Rest) != "ply")
  {
    throw Failure("is not a .ply file: it does not begin with 'ply'");
  }
  bool hasFormat = false;
  while (!this->Rest.empty())
  {
    std::string_view line = TakeLine(this->Rest);
    const std::string_view whole = line;
    const std::string_view what = TakeWord(line);
    if (what == "format")
    {
      const std::string_view format = TakeWord(line);
      const bool isBig = format == "binary_big_endian";
      this->Text = format == "ascii";
      this->Swapped = isBig != (std::endian::native == std::endian::big);
      hasFormat = this->Text || isBig || format == "binary_little_endian";
    }
    else if (what == "element")
    {
      const std::string name(TakeWord(line));
      const auto isSame = [&](const PlyElement& other) { return other.Name == name; };
      if (std::any_of(this->Elements.begin(), this->Elements.end(), isSame))
      {
        throw Failure(
          fmt::format("its header has the element '{}' twice", MakePrintableLine(name)));
      }
      PlyElement& element = this->Elements.emplace_back();
      element.Name = name;
      if (!ParseWord(TakeWord(line), element.Count))
      {
        throw Failure(fmt::format("its header has no number in '{}'", MakePrintableLine(whole)));
      }
    }
    else if (what == "property")
    {
      this->AddProperty(line);
    }
    else if (what == "end_header")
    {
      if (!hasFormat)
      {
        throw Failure("its header tells no format that is known");
      }
      return;
    }
    else if (!what.empty() && what != "comment" && what != "obj_info")
    {
      throw Failure(fmt::format("its header has the unknown line '{}'", MakePrintableLine(whole)));
    }
  }
  throw Failure("its header has no end");
}

//------------------------------------------------------------------------------
void PlyFile::AddProperty(std::string_view words)
{
  if (this->Elements.empty())
  {
    throw Failure("its header has a property before all elements");
  }
  PlyProperty property;
  std::string_view type = TakeWord(words);
  if (type == "list")
  {
    property.CountType = PlyTypeOf(TakeWord(words));
    type = TakeWord(words);
  }
  property.Type = PlyTypeOf(type);
  property.Name = TakeWord(words);
  if (property.Name.empty() || property.CountType == VTK_FLOAT || property.CountType == VTK_DOUBLE)
  {
    throw Failure("its header has a property without a name, or a list of a broken length");
  }
  this->Elements.back().Properties.push_back(property);
}

//------------------------------------------------------------------------------
// How many values of a type there may be in the rest.
std::uint64_t PlyFile::GetRoom(int type) const
{
  const std::size_t size = this->Rest.size();
  return this->Text ? (size + 1) / 2
                    : size / static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(type));
}

//------------------------------------------------------------------------------
// The elements that the header declares must fit into the file; their lists may be empty.
void PlyFile::CheckSize() const
{
  std::uint64_t room = this->GetRoom(VTK_UNSIGNED_CHAR);
  for (const PlyElement& element : this->Elements)
  {
    std::uint64_t size = 0;
    for (const PlyProperty& property : element.Properties)
    {
      const int type = property.CountType != 0 ? property.CountType : property.Type;
      size += this->Text ? 1 : static_cast<std::uint64_t>(vtkDataArray::GetDataTypeSize(type));
    }
    if (size > 0 && element.Count > room / size)
    {
      throw Failure(fmt::format("is truncated: it has no room for the {} of '{}' that its header "
                                "declares",
        element.Count, MakePrintableLine(element.Name)));
    }
    room -= size * element.Count;
  }
}

//------------------------------------------------------------------------------
double PlyFile::Take(int type)
{
  if (this->Text)
  {
    const std::string_view word = TakeWord(this->Rest);
    if (word.empty())
    {
      throw Failure(ShortPly);
    }
    return TakeText(word, type);
  }
  if (this->GetRoom(type) == 0)
  {
    throw Failure(ShortPly);
  }
  const char* const bytes = this->Rest.data();
  this->Rest.remove_prefix(static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(type)));
  switch (type)
  {
    vtkTemplateMacro(return TakeBinary<VTK_TT>(bytes, this->Swapped));
    default:
      return 0;
  }
}

//------------------------------------------------------------------------------
std::uint64_t PlyFile::TakeCount(const PlyProperty& list)
{
  const double count = this->Take(list.CountType);
  if (count < 0)
  {
    throw Failure(fmt::format("has a list of {} values", count));
  }
  const auto values = static_cast<std::uint64_t>(count);
  if (values > this->GetRoom(list.Type))
  {
    throw Failure(ShortPly);
  }
  return values;
}
}
