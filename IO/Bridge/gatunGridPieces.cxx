// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunGridPieces.h"

#include "gatunError.h"
#include "gatunGhosts.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace gatun
{
namespace
{
std::string NameOf(std::size_t piece)
{
  return "piece " + std::to_string(piece);
}

/** The numbers of an array with one for each point of a piece; nothing if it is not such an array.
 */
std::vector<std::int64_t> GetIds(vtkUnstructuredGrid* piece, vtkDataArray* ids)
{
  std::vector<std::int64_t> values;
  if (!ids || ids->GetNumberOfComponents() != 1 ||
    ids->GetNumberOfTuples() != piece->GetNumberOfPoints())
  {
    return values;
  }
  const BridgedArray array = Bridge(ids, Association::Point);
  values.resize(static_cast<std::size_t>(ids->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    switch (array.Description.Type)
    {
      case ScalarType::Int64:
      case ScalarType::UInt64:
        values[i] = static_cast<const std::int64_t*>(array.Values)[i];
        break;
      case ScalarType::Int32:
        values[i] = static_cast<const std::int32_t*>(array.Values)[i];
        break;
      case ScalarType::UInt32:
        values[i] = static_cast<const std::uint32_t*>(array.Values)[i];
        break;
      default:
        return {}; // not ids
    }
  }
  return values;
}
}

//------------------------------------------------------------------------------
GridPieces::GridPieces(const std::string& path, const PartWriterOptions& options,
  std::function<std::vector<BridgedArray>(vtkUnstructuredGrid*)> select,
  vtkInformationIntegerKey* joinKey)
  : Path(path)
  , Options(options)
  , Select(std::move(select))
  , JoinKey(joinKey)
{
}

GridPieces::~GridPieces() = default;

//------------------------------------------------------------------------------
GridPieces::Input GridPieces::MakeInput(vtkUnstructuredGrid* piece, std::size_t number) const
{
  Input input;
  input.Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  input.Grid->ShallowCopy(piece);
  ClearGhosts(input.Grid);
  input.Mesh = std::make_unique<BridgedMesh>(input.Grid);
  input.Arrays = this->Select(input.Grid);
  input.Ids = this->FindIds(input, number);
  if (this->File)
  {
    this->SortArrays(input, number);
  }
  for (const auto& array : input.Arrays)
  {
    input.Values.push_back(array.Values);
  }
  return input;
}

//------------------------------------------------------------------------------
/** The array that points are joined by in place of global ids or coordinates, or null. */
vtkDataArray* GridPieces::FindMarked(vtkUnstructuredGrid* piece) const
{
  vtkPointData* const data = piece->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = data->GetArray(i);
    if (array && array->HasInformation() && array->GetInformation()->Get(this->JoinKey) == 1)
    {
      return array;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
/** The numbers that points are joined by, if there are any. A marked array is removed from those to
 * write. */
std::vector<std::int64_t> GridPieces::FindIds(Input& input, std::size_t number) const
{
  vtkDataArray* const marked = this->FindMarked(input.Grid);
  if (this->File && this->Options.JoinByIdsOnly != (marked != nullptr))
  {
    ThrowInvalid(NameOf(number) +
      (marked ? " has a point array to join by, and the pieces before have none"
              : " has no point array to join by, and the pieces before have one"));
  }
  if (!marked)
  {
    return GetIds(input.Grid, input.Grid->GetPointData()->GetGlobalIds());
  }
  auto ids = GetIds(input.Grid, marked);
  const std::string name = marked->GetName() ? marked->GetName() : "";
  if (ids.empty() && input.Grid->GetNumberOfPoints() > 0)
  {
    ThrowInvalid("the point array '" + name + "' of " + NameOf(number) +
      " has no integers to join by, one for each point");
  }
  std::erase_if(input.Arrays,
    [&](const BridgedArray& array)
    { return array.Description.Where == Association::Point && array.Description.Name == name; });
  return ids;
}

//------------------------------------------------------------------------------
/** Puts the arrays of a piece into the order of those of the first piece. */
void GridPieces::SortArrays(Input& input, std::size_t number) const
{
  std::vector<BridgedArray> sorted;
  for (const auto& description : this->Arrays)
  {
    const auto found = std::find_if(input.Arrays.begin(), input.Arrays.end(),
      [&](const BridgedArray& array)
      {
        // Roles and names of components are those of the first piece.
        ArrayDescription own = array.Description;
        own.AttributeRoles = description.AttributeRoles;
        own.ComponentNames = description.ComponentNames;
        return own == description;
      });
    if (found == input.Arrays.end())
    {
      ThrowInvalid(NameOf(number) + " has no " +
        (description.Where == Association::Point ? "point" : "cell") + " array '" +
        description.Name + "' of the type that it has in the pieces before");
    }
    sorted.push_back(std::move(*found));
    input.Arrays.erase(found);
  }
  if (!input.Arrays.empty())
  {
    ThrowInvalid(NameOf(number) + " has an array '" + input.Arrays.front().Description.Name +
      "' that the pieces before do not have");
  }
  input.Arrays = std::move(sorted);
}

//------------------------------------------------------------------------------
void GridPieces::Open(const Input& input)
{
  for (const auto& array : input.Arrays)
  {
    this->Arrays.push_back(array.Description);
  }
  this->Options.JoinByIdsOnly = this->FindMarked(input.Grid) != nullptr;
  if (this->Weights)
  {
    this->Options.Weights = this->Weights->Find(this->Arrays);
  }
  this->File = std::make_unique<PartWriter>(this->Path, this->Arrays, this->Options);
}

//------------------------------------------------------------------------------
void GridPieces::OpenTogether(PartExchange& exchange, vtkUnstructuredGrid* piece, std::size_t steps)
{
  const bool isEmpty = piece->GetNumberOfPoints() == 0 && piece->GetNumberOfCells() == 0;
  std::optional<std::vector<ArrayDescription>> own;
  exchange.Together(
    [&]
    {
      if (!isEmpty)
      {
        own.emplace();
        for (const auto& array : this->MakeInput(piece, 0).Arrays)
        {
          own->push_back(array.Description);
        }
      }
    });
  this->Options.JoinByIdsOnly = exchange.IsAny(!isEmpty && this->FindMarked(piece) != nullptr);
  const auto arrays = exchange.TakeArrays(own);
  const auto* number = reinterpret_cast<const std::uint8_t*>(&steps);
  const auto numbers = exchange.Gather({ number, number + sizeof(steps) });
  exchange.Together(
    [&]
    {
      if (std::adjacent_find(numbers.begin(), numbers.end(), std::not_equal_to<>()) !=
        numbers.end())
      {
        ThrowInvalid("the processes have different numbers of time steps");
      }
      this->Arrays = arrays.value_or(std::vector<ArrayDescription>());
      this->File = std::make_unique<PartWriter>(this->Path, this->Arrays, this->Options, &exchange);
    });
  this->WritesEmpty = !arrays && exchange.GetProcess() == 0;
}

//------------------------------------------------------------------------------
void GridPieces::EndSurvey()
{
  if (this->WritesEmpty)
  {
    this->File->Survey({});
  }
  this->File->EndSurvey();
}

//------------------------------------------------------------------------------
/** Whether a piece is to be skipped. It must have no points at all steps then. */
bool GridPieces::IsEmpty(vtkUnstructuredGrid* piece, bool isFirst, std::size_t number)
{
  const bool isEmpty = piece->GetNumberOfPoints() == 0 && piece->GetNumberOfCells() == 0;
  if (!isFirst && isEmpty != this->WasEmpty)
  {
    ThrowInvalid("the points or the cells of " + NameOf(number) + " change with time");
  }
  this->WasEmpty = isEmpty;
  return isEmpty;
}

//------------------------------------------------------------------------------
void GridPieces::Survey(vtkUnstructuredGrid* piece, bool isFirst)
{
  this->Surveyed += isFirst;
  const auto number = this->Surveyed - 1;
  if (this->IsEmpty(piece, isFirst, number))
  {
    return;
  }
  const Input input = this->MakeInput(piece, number);
  if (isFirst)
  {
    if (!this->File)
    {
      this->Open(input);
    }
    this->PointsConverted = this->PointsConverted || input.Mesh->PointsConverted;
    this->MeshHash = input.Mesh->Hash();
    this->File->Survey(input.Mesh->Mesh, input.GetIds());
  }
  else if (input.Mesh->Hash() != this->MeshHash)
  {
    ThrowInvalid("the points or the cells of " + NameOf(number) +
      " change with time; points that move need the whole mesh in one piece and one process");
  }
  this->File->SurveyStep(input.Values);
}

//------------------------------------------------------------------------------
void GridPieces::Write(vtkUnstructuredGrid* piece, bool isFirst, const Step& step,
  const std::function<bool(double)>& progress)
{
  this->Written += isFirst;
  if (this->IsEmpty(piece, isFirst, this->Written - 1))
  {
    return;
  }
  if (!this->File)
  {
    ThrowInvalid(NameOf(this->Written - 1) + " has changed since it was surveyed");
  }
  Input input = this->MakeInput(piece, this->Written - 1);
  const auto values = input.Values;
  const auto arrays = input.Arrays;
  if (isFirst)
  {
    // The mesh has to exist until the last step of the piece is written.
    this->Current = std::move(input);
    this->Current.Arrays = {};
    this->File->Write(this->Current.Mesh->Mesh, this->Current.GetIds(), progress);
  }
  this->File->WriteStep(values, step.Field, step.HasTime, step.Time, progress);
  if (step.IsLast)
  {
    this->Current = {};
  }
}

//------------------------------------------------------------------------------
PartStatistics GridPieces::Finish(const std::function<bool(double)>& progress)
{
  if (!this->File)
  {
    // All pieces are empty.
    this->File =
      std::make_unique<PartWriter>(this->Path, std::vector<ArrayDescription>(), this->Options);
    this->File->Survey({});
    this->File->Write({});
  }
  else if (this->WritesEmpty)
  {
    this->File->Write({});
  }
  auto statistics = this->File->Finish(progress);
  this->File.reset();
  this->Current = {};
  return statistics;
}
}
