// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnGridView.h"

#include "gtnFailure.h"
#include "gtnText.h"

#include "gatunArrayKeys.h"
#include "gatunCellArrays.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include <fmt/core.h>

#include <bit>
#include <cmath>
#include <cstring>

namespace gtn
{
namespace
{

constexpr const char* CoordinatesTitle = "the coordinates";

template <typename Float, typename Bits>
std::string TextOfFloat(const unsigned char* bytes)
{
  Float value;
  Bits bits;
  std::memcpy(&value, bytes, sizeof(value));
  std::memcpy(&bits, bytes, sizeof(bits));
  return std::isnan(value) ? fmt::format("nan(0x{:0{}x})", bits, 2 * sizeof(bits))
                           : fmt::format("{}", value);
}

void AddViews(std::vector<ArrayView>& views, vtkDataSetAttributes* attributes,
  const std::string& kind, std::size_t tuples)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = attributes->GetAbstractArray(i);
    ArrayView& view = views.emplace_back(array, kind);
    if (static_cast<std::size_t>(array->GetNumberOfTuples()) != tuples)
    {
      throw Failure(
        fmt::format("{} has {} values, not {}", view.Title, array->GetNumberOfTuples(), tuples));
    }
    for (int role = 0; role < vtkDataSetAttributes::NUM_ATTRIBUTES; ++role)
    {
      if (attributes->GetAbstractAttribute(role) == array)
      {
        view.Roles += std::string(", active ") + attributes->GetAttributeTypeAsString(role);
      }
    }
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
std::vector<std::string> KeyTexts(vtkAbstractArray* array)
{
  const gatun::FoundKeys found = gatun::FindKeys(array);
  std::vector<std::string> texts;
  for (const std::string& key : found.Refused)
  {
    texts.push_back(MakePrintableLine(key));
  }
  for (const gatun::ArrayKey& key : found.Keys)
  {
    const bool isReal = key.Kind == gatun::KeyKind::Double || key.Kind == gatun::KeyKind::Doubles ||
      key.Kind == gatun::KeyKind::Quadrature;
    std::vector<std::string> values = key.Texts;
    for (const std::uint64_t bits : key.Numbers)
    {
      values.push_back(isReal ? fmt::format("{}", std::bit_cast<double>(bits))
                              : std::to_string(static_cast<std::int64_t>(bits)));
    }
    texts.push_back(
      MakePrintableLine(fmt::format("{}::{} = {}", key.Location, key.Name, Join(values))));
  }
  return texts;
}

//------------------------------------------------------------------------------
ArrayView::ArrayView(vtkAbstractArray* array, const std::string& kind)
  : Title(fmt::format("{} '{}'", kind, MakePrintableLine(array->GetName() ? array->GetName() : "")))
  , Owner(vtkDataArray::SafeDownCast(array))
{
  if (!this->Owner)
  {
    throw Failure(this->Title + " is not numeric");
  }
  std::vector<std::string> names;
  for (int i = 0; array->HasAComponentName() && i < array->GetNumberOfComponents(); ++i)
  {
    const char* const name = array->GetComponentName(i);
    names.emplace_back(name ? name : "");
  }
  this->Kind = fmt::format(
    "{}, {} component(s)", array->GetDataTypeAsString(), array->GetNumberOfComponents());
  this->Roles = names.empty() ? "" : fmt::format(" ({})", MakePrintableLine(Join(names)));
  this->Keys = KeyTexts(array);
  if (array->GetDataType() == VTK_BIT)
  {
    auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
    bytes->DeepCopy(this->Owner);
    this->Owner = bytes;
  }
  // Arrays that are not stored tuple by tuple are copied by this call.
  this->Bytes = static_cast<const unsigned char*>(this->Owner->GetVoidPointer(0));
  this->TupleBytes =
    static_cast<std::size_t>(this->Owner->GetDataTypeSize()) * this->Owner->GetNumberOfComponents();
}

//------------------------------------------------------------------------------
std::string ArrayView::Text(std::size_t i) const
{
  const auto components = static_cast<std::size_t>(this->Owner->GetNumberOfComponents());
  std::vector<std::string> texts;
  for (std::size_t j = 0; j < components; ++j)
  {
    const unsigned char* const value = this->Tuple(i) + j * (this->TupleBytes / components);
    const vtkVariant variant =
      this->Owner->GetVariantValue(static_cast<vtkIdType>(i * components + j));
    texts.push_back(variant.IsFloat()       ? TextOfFloat<float, std::uint32_t>(value)
        : variant.IsDouble()                ? TextOfFloat<double, std::uint64_t>(value)
        : this->Owner->GetDataTypeMin() < 0 ? std::to_string(variant.ToTypeInt64())
                                            : std::to_string(variant.ToTypeUInt64()));
  }
  return components == 1 ? texts[0] : fmt::format("({})", Join(texts));
}

//------------------------------------------------------------------------------
GridView::GridView(vtkUnstructuredGrid* grid)
  : Grid(grid)
  , Points(static_cast<std::size_t>(grid->GetNumberOfPoints()))
  , Cells(static_cast<std::size_t>(grid->GetNumberOfCells()))
{
  if (this->Points > 0)
  {
    vtkDataArray* const points = grid->GetPoints()->GetData();
    ArrayView& view = this->PointArrays.emplace_back(points, "");
    view.Title = CoordinatesTitle;
    view.Roles = fmt::format(
      " '{}'{}", MakePrintableLine(points->GetName() ? points->GetName() : ""), view.Roles);
  }
  AddViews(this->PointArrays, grid->GetPointData(), "point array", this->Points);
  AddViews(this->CellArrays, grid->GetCellData(), "cell array", this->Cells);
  if (this->Cells == 0)
  {
    return;
  }
  this->Faces = gatun::GetFaceStream(grid);
  this->TypeArray = gatun::GetCellTypes(grid);
  this->Types = this->TypeArray->GetPointer(0);
  gatun::UseCellArrays(grid->GetCells(),
    [this](const auto* offsets, const auto* ids, vtkIdType size)
    {
      this->Starts.assign(offsets, offsets + this->Cells + 1);
      this->Ids.assign(ids, ids + size);
    });
}

//------------------------------------------------------------------------------
bool GridView::HasCoordinates() const
{
  return !this->PointArrays.empty() && this->PointArrays.front().Title == CoordinatesTitle;
}

//------------------------------------------------------------------------------
std::span<const std::int64_t> GridView::GetFaces(std::size_t cell) const
{
  vtkIdTypeArray* const faces = this->Faces.Values;
  const vtkIdType place = faces && this->GetType(cell) == VTK_POLYHEDRON
    ? this->Faces.Locations->GetValue(static_cast<vtkIdType>(cell))
    : -1;
  if (place < 0)
  {
    return {};
  }
  static_assert(sizeof(vtkIdType) == sizeof(std::int64_t));
  const auto* const begin = reinterpret_cast<const std::int64_t*>(faces->GetPointer(place)) + 1;
  const std::int64_t* end = begin;
  for (auto count = begin[-1]; count > 0; --count)
  {
    end += 1 + *end;
  }
  return { begin, end };
}
}
