// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnPartReader.h"

#include "gtnFailure.h"
#include "gtnFileList.h"
#include "gtnMessages.h"
#include "gtnReadable.h"
#include "gtnReaders.h"
#include "gtnSpooledMesh.h"
#include "gtnText.h"

#include "gatunArrayBridge.h"
#include "gatunSurfaceGrid.h"
#include "vtkGatunWriter.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkAppendFilter.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPPolyDataReader.h"
#include "vtkXMLPUnstructuredGridReader.h"

#include <algorithm>
#include <exception>

namespace gtn
{
vtkStandardNewMacro(PartReader);

namespace
{

using Grids = std::vector<vtkSmartPointer<vtkUnstructuredGrid>>;

// The array with this name in the attributes of the first part that has it, or null.
vtkAbstractArray* FindInParts(const Grids& parts, int association, const char* name)
{
  for (const auto& part : parts)
  {
    if (auto* array = part->GetAttributes(association)->GetAbstractArray(name))
    {
      return array;
    }
  }
  return nullptr;
}

// An array of all parts. Takes it out of them. Parts without it, which are those without ghosts,
// get zeros.
vtkSmartPointer<vtkAbstractArray> AppendArray(
  const Grids& parts, int association, const std::string& name)
{
  vtkAbstractArray* const form = FindInParts(parts, association, name.c_str());
  auto all = vtk::TakeSmartPointer(form->NewInstance());
  all->SetName(name.c_str());
  all->SetNumberOfComponents(form->GetNumberOfComponents());
  all->CopyComponentNames(form);
  if (form->HasInformation())
  {
    all->CopyInformation(form->GetInformation(), 1);
  }
  vtkIdType count = 0;
  for (const auto& part : parts)
  {
    count += part->GetNumberOfElements(association);
  }
  all->SetNumberOfTuples(count);
  vtkIdType next = 0;
  for (const auto& part : parts)
  {
    const vtkIdType tuples = part->GetNumberOfElements(association);
    vtkDataSetAttributes* data = part->GetAttributes(association);
    vtkAbstractArray* const array = data->GetAbstractArray(name.c_str());
    if (array && array->GetNumberOfTuples() >= tuples)
    {
      all->InsertTuples(next, tuples, 0, array);
    }
    else if (auto* numbers = vtkDataArray::SafeDownCast(all); numbers && !array)
    {
      for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
      {
        for (vtkIdType i = next; i < next + tuples; ++i)
        {
          numbers->SetComponent(i, c, 0);
        }
      }
    }
    else
    {
      throw Failure("the array '" + MakePrintableLine(name) + "' has too few values");
    }
    data->RemoveArray(name.c_str());
    next += tuples;
  }
  return all;
}

// The names of the active attributes that all parts agree about.
std::vector<std::string> FindActive(const Grids& parts, int association)
{
  std::vector<std::string> names(vtkDataSetAttributes::NUM_ATTRIBUTES);
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    const auto nameOf = [&](const vtkSmartPointer<vtkUnstructuredGrid>& part) -> std::string
    {
      auto* array = part->GetAttributes(association)->GetAbstractAttribute(type);
      return array && array->GetName() ? array->GetName() : "";
    };
    const std::string name = nameOf(parts.front());
    const bool agree = std::all_of(parts.begin(), parts.end(),
      [&](const vtkSmartPointer<vtkUnstructuredGrid>& part) { return nameOf(part) == name; });
    names[static_cast<std::size_t>(type)] = agree ? name : "";
  }
  return names;
}

// Moves the arrays of all parts to the grid that the parts become.
void AppendArrays(const Grids& parts, int association, vtkUnstructuredGrid* whole)
{
  const std::vector<std::string> active = FindActive(parts, association);
  std::vector<std::string> names;
  for (const auto& part : parts)
  {
    vtkDataSetAttributes* data = part->GetAttributes(association);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      const char* name = data->GetAbstractArray(i)->GetName();
      if (!name)
      {
        throw Failure("has an array without a name in several files");
      }
      if (std::find(names.begin(), names.end(), name) == names.end())
      {
        names.emplace_back(name);
      }
    }
  }
  vtkDataSetAttributes* to = whole->GetAttributes(association);
  for (const std::string& name : names)
  {
    to->AddArray(AppendArray(parts, association, name));
  }
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    const std::string& name = active[static_cast<std::size_t>(type)];
    if (!name.empty())
    {
      to->SetActiveAttribute(name.c_str(), type);
    }
  }
}

// Adds field arrays that are not there yet, and names those that are others than these.
void AddFieldData(
  vtkFieldData* from, const std::string& file, const InputOptions& options, vtkFieldData* to)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = from->GetAbstractArray(i);
    vtkAbstractArray* const known =
      array->GetName() ? to->GetAbstractArray(array->GetName()) : nullptr;
    if (array->GetName() && !known)
    {
      to->AddArray(array);
    }
    else if (known && !gatun::AreEqual(array, known))
    {
      const std::string lost = "the field array '" + MakePrintableLine(array->GetName()) +
        "' differs between pieces; only that of the first one is kept";
      if (options.Lost)
      {
        options.Lost->insert(lost);
      }
      else
      {
        SayOnce(file, lost, options.Quiet);
      }
    }
  }
}

// Makes one grid of parts, which lose their arrays.
vtkSmartPointer<vtkUnstructuredGrid> AppendGrids(const Grids& parts)
{
  vtkNew<vtkUnstructuredGrid> arrays;
  AppendArrays(parts, vtkDataObject::POINT, arrays);
  AppendArrays(parts, vtkDataObject::CELL, arrays);
  const bool isDouble = std::any_of(parts.begin(), parts.end(),
    [](const vtkSmartPointer<vtkUnstructuredGrid>& part)
    { return part->GetPoints() && part->GetPoints()->GetDataType() != VTK_FLOAT; });
  vtkNew<vtkAppendFilter> append;
  append->SetOutputPointsPrecision(
    isDouble ? vtkAlgorithm::DOUBLE_PRECISION : vtkAlgorithm::SINGLE_PRECISION);
  for (const auto& part : parts)
  {
    append->AddInputData(part);
  }
  append->Update();
  vtkNew<vtkUnstructuredGrid> whole;
  whole->CopyStructure(append->GetOutput());
  if (parts.front()->GetPoints() && whole->GetPoints())
  {
    gatun::CopyNames(parts.front()->GetPoints()->GetData(), whole->GetPoints()->GetData());
  }
  whole->GetPointData()->ShallowCopy(arrays->GetPointData());
  whole->GetAttributes(vtkDataObject::CELL)
    ->ShallowCopy(arrays->GetAttributes(vtkDataObject::CELL));
  return whole;
}

bool IsEmptyPart(vtkDataSet* part)
{
  return part->GetNumberOfPoints() == 0 && part->GetNumberOfCells() == 0;
}

} // anonymous namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkAlgorithm> OpenFile(const std::string& file, const InputOptions& options)
{
  CheckReadable(file);
  if (IsFileList(file))
  {
    throw Failure(file, "a list of files cannot be part of another");
  }
  vtkSmartPointer<vtkAlgorithm> reader;
  if (IsPartList(file))
  {
    vtkNew<PartReader> parts;
    parts->SetFile(file, options);
    reader = parts;
  }
  else
  {
    reader = MakeReader(file, options.Sets);
  }
  if (!reader)
  {
    throw Failure(file, "no reader for this extension");
  }
  reader->UpdateInformation();
  CheckMessages(file, false);
  vtkInformation* info = reader->GetOutputInformation(0);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (info->Has(Pipeline::TIME_STEPS()) && info->Length(Pipeline::TIME_STEPS()) > 1)
  {
    throw Failure(file, "has several time steps itself, and cannot be a step of a series");
  }
  return reader;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadPart(
  const std::string& file, const PartForm& form, const InputOptions& options)
{
  vtkSmartPointer<vtkAlgorithm> reader = OpenFile(file, options);
  reader->Update();
  CheckMessages(file, options.Quiet);
  vtkSmartPointer<vtkDataObject> data = reader->GetOutputDataObject(0);
  if (auto* const set = vtkDataSet::SafeDownCast(data))
  {
    form.Apply(set);
  }
  return data;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadParts(
  const std::vector<std::string>& files, const PartForm& form, const InputOptions& options)
{
  Grids grids;
  vtkNew<vtkFieldData> field;
  vtkSmartPointer<vtkDataObject> empty; // the first part
  std::size_t surfaces = 0;
  for (const std::string& file : files)
  {
    const vtkSmartPointer<vtkDataObject> data = ReadPart(file, form, options);
    auto* const set = vtkDataSet::SafeDownCast(data);
    if (!set)
    {
      throw Failure(file, "does not hold a mesh that could be a part of another");
    }
    AddFieldData(set->GetFieldData(), file, options, field);
    if (IsEmptyPart(set))
    {
      empty = empty ? empty : data;
      continue;
    }
    auto* const surface = vtkPolyData::SafeDownCast(set);
    vtkSmartPointer<vtkUnstructuredGrid> grid = vtkUnstructuredGrid::SafeDownCast(set);
    if (surface)
    {
      grid = gatun::MakeSurfaceGrid(surface);
      ++surfaces;
    }
    if (!grid)
    {
      vtkNew<vtkAppendFilter> append;
      append->AddInputData(set);
      append->Update();
      grid = append->GetOutput();
    }
    grids.push_back(grid);
    if (grids.size() > 1 && surfaces > 0 && surfaces != grids.size())
    {
      throw Failure(
        file, surface ? "is a surface, and others are not" : "is not a surface, and others are");
    }
  }
  if (grids.empty())
  {
    return empty;
  }
  const auto whole = grids.size() > 1 ? AppendGrids(grids) : grids.front();
  vtkSmartPointer<vtkDataObject> output = whole;
  if (surfaces > 0)
  {
    vtkNew<vtkPolyData> surface;
    gatun::MakeSurface(whole, gatun::FindSurfaceCells(whole), surface);
    output = surface;
  }
  output->GetFieldData()->Initialize();
  AddFieldData(field, files.front(), options, output->GetFieldData());
  return output;
}

//------------------------------------------------------------------------------
void AddJoinArray(vtkPointSet* piece, vtkDataArray* values)
{
  vtkNew<vtkTypeInt64Array> numbers;
  numbers->SetNumberOfValues(piece->GetNumberOfPoints());
  numbers->FillValue(-1);
  if (values)
  {
    numbers->DeepCopy(values);
  }
  numbers->SetName(JoinArrayName);
  numbers->GetInformation()->Set(vtkGatunWriter::JOIN_POINTS(), 1);
  piece->GetPointData()->AddArray(numbers);
}

//------------------------------------------------------------------------------
PartReader::PartReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
void PartReader::SetFile(const std::string& file, const InputOptions& options)
{
  this->File = file;
  this->Options = options;
  this->Parts = FindParts(file, options);
  if (IsSurfaceFile(file))
  {
    vtkNew<vtkXMLPPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    this->List = reader;
  }
  else
  {
    vtkNew<vtkXMLPUnstructuredGridReader> reader;
    reader->SetFileName(file.c_str());
    this->List = reader;
  }
  this->Modified();
}

//------------------------------------------------------------------------------
int PartReader::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  return this->SetOutputDataObject(
    IsSurfaceFile(this->File) ? VTK_POLY_DATA : VTK_UNSTRUCTURED_GRID,
    outputVector->GetInformationObject(0), true);
}

//------------------------------------------------------------------------------
int PartReader::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = outputVector->GetInformationObject(0);
  this->List->UpdateInformation();
  vtkInformation* const own = this->List->GetOutputInformation(0);
  for (vtkInformationDoubleVectorKey* key : { Pipeline::TIME_STEPS(), Pipeline::TIME_RANGE() })
  {
    if (own->Has(key))
    {
      info->CopyEntry(own, key);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int PartReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  try
  {
    this->Read(output);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< ReasonOf(error));
    return 0;
  }
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = outputVector->GetInformationObject(0);
  if (info->Has(Pipeline::TIME_STEPS()) && info->Length(Pipeline::TIME_STEPS()) > 0)
  {
    output->GetInformation()->Set(
      vtkDataObject::DATA_TIME_STEP(), info->Get(Pipeline::TIME_STEPS())[0]);
  }
  return 1;
}

//------------------------------------------------------------------------------
void PartReader::Read(vtkDataObject* output)
{
  const PartForm form(this->File, this->Parts, this->Options);
  const vtkSmartPointer<vtkDataObject> whole = ReadParts(this->Parts, form, this->Options);
  if (!whole->IsA(output->GetClassName()))
  {
    throw Failure(this->File, "the pieces hold " + std::string(whole->GetClassName()));
  }
  output->ShallowCopy(whole);
  // The list itself, of which a piece that does not exist has nothing else.
  constexpr int pieces = 1 << 24;
  this->List->UpdatePiece(pieces, pieces + 1, 0);
  AddFieldData(this->List->GetOutputDataObject(0)->GetFieldData(), this->File, this->Options,
    output->GetFieldData());
}
}
