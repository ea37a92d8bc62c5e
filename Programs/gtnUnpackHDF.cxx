// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnUnpackHDF.h"

#include "gtnFailure.h"
#include "gtnFormats.h"
#include "gtnInput.h"
#include "gtnMessages.h"
#include "gtnOutput.h"
#include "gtnProgress.h"
#include "gtnSettings.h"
#include "gtnText.h"

#include "gatunArrayKeys.h"
#include "gatunCellArrays.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataObjectAlgorithm.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace gtn
{
namespace
{

// HDF5 has no '.' and '/' in names; VTK's writer puts '_' in their place.
std::string NameInHDF(std::string name)
{
  std::replace(name.begin(), name.end(), '.', '_');
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

/** Finds what a .vtkhdf file does not hold, or VTK does not write: its writer itself crashes, or
 * leaves it out. */
class HDFCheck
{
public:
  explicit HDFCheck(std::string name)
    : Name(std::move(name))
  {
  }

  /** Checks a time step. Throws Failure. */
  void Check(vtkDataSet* mesh)
  {
    const std::vector<std::string> arrays = ListArrays(mesh);
    const std::vector<vtkSmartPointer<vtkDataArray>> cells = ListCells(mesh);
    if (this->Arrays.empty())
    {
      this->Arrays = arrays;
      this->Cells = cells;
      this->Points = mesh->GetNumberOfPoints();
    }
    if (arrays != this->Arrays)
    {
      throw Failure(this->Name,
        "has other arrays at a later time step, which a .vtkhdf file cannot hold; choose arrays by "
        "--arrays, or write a .pvd file");
    }
    if (mesh->GetNumberOfPoints() != this->Points ||
      !std::equal(
        cells.begin(), cells.end(), this->Cells.begin(), this->Cells.end(), HaveSameBytes))
    {
      throw Failure(this->Name,
        "has other cells at a later time step, which VTK does not write correctly to .vtkhdf "
        "files; "
        "write a .pvd file");
    }
    this->CheckMesh(mesh);
  }

  std::string ListLost() const { return Join({ this->Lost.begin(), this->Lost.end() }); }

private:
  // "point pressure, float, 1"
  static std::vector<std::string> ListArrays(vtkDataSet* mesh)
  {
    std::vector<std::string> arrays{ mesh->GetClassName() };
    for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::FIELD })
    {
      vtkFieldData* const data = mesh->GetAttributesAsFieldData(kind);
      for (int i = 0; i < data->GetNumberOfArrays(); ++i)
      {
        vtkAbstractArray* const array = data->GetAbstractArray(i);
        arrays.push_back(
          fmt::format("{} {}, {}, {}", kind, array->GetName() ? array->GetName() : "",
            array->GetDataTypeAsString(), array->GetNumberOfComponents()));
      }
    }
    return arrays;
  }

  // The types, offsets and point ids of all cells.
  static std::vector<vtkSmartPointer<vtkDataArray>> ListCells(vtkDataSet* mesh)
  {
    std::vector<vtkSmartPointer<vtkDataArray>> arrays;
    const auto add = [&](vtkCellArray* cells)
    {
      arrays.push_back(cells ? gatun::GetOffsets(cells) : nullptr);
      arrays.push_back(cells ? gatun::GetPointIds(cells) : nullptr);
    };
    if (auto* const grid = vtkUnstructuredGrid::SafeDownCast(mesh))
    {
      arrays.emplace_back(gatun::GetCellTypes(grid));
      add(grid->GetCells());
    }
    if (auto* const surface = vtkPolyData::SafeDownCast(mesh))
    {
      for (vtkCellArray* const cells :
        { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
      {
        add(cells);
      }
    }
    return arrays;
  }

  static bool HaveSameBytes(vtkDataArray* first, vtkDataArray* second)
  {
    const auto bytes = [](vtkDataArray* array)
    {
      return array ? std::string_view(static_cast<const char*>(array->GetVoidPointer(0)),
                       static_cast<std::size_t>(array->GetNumberOfValues()) *
                         static_cast<std::size_t>(array->GetDataTypeSize()))
                   : std::string_view();
    };
    return bytes(first) == bytes(second);
  }

  void CheckMesh(vtkDataSet* mesh)
  {
    auto* const grid = vtkUnstructuredGrid::SafeDownCast(mesh);
    const auto types = grid ? gatun::GetCellTypes(grid) : nullptr;
    if (types && types->LookupValue(VTK_POLYHEDRON) >= 0)
    {
      throw Failure(this->Name,
        "has polyhedra, which this VTK does not write to .vtkhdf files; write a .pvd "
        "or .vtu file");
    }
    this->CheckArrays(mesh->GetPointData());
    this->CheckArrays(mesh->GetCellData());
    this->CheckNames(mesh->GetFieldData());
  }

  void CheckNames(vtkFieldData* data)
  {
    std::set<std::string> names;
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = data->GetAbstractArray(i);
      const std::string name = array->GetName() ? array->GetName() : "";
      const std::string shown = MakePrintableLine(name);
      if (name.empty() || !names.insert(NameInHDF(name)).second)
      {
        throw Failure(this->Name,
          fmt::format(
            "has an array '{}' without a name of its own in HDF5; leave it out by --arrays",
            shown));
      }
      if (name != NameInHDF(name))
      {
        this->Lost.insert(fmt::format("the name of array '{}' ({})", shown, NameInHDF(shown)));
      }
      if (array->HasAComponentName())
      {
        this->Lost.insert(fmt::format("the component names of array '{}'", shown));
      }
      const gatun::FoundKeys keys = gatun::FindKeys(array);
      if (!keys.Keys.empty() || !keys.Refused.empty())
      {
        this->Lost.insert(fmt::format("the information keys of array '{}'", shown));
      }
    }
  }

  void CheckArrays(vtkDataSetAttributes* data)
  {
    this->CheckNames(data);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      if (!vtkDataArray::SafeDownCast(data->GetAbstractArray(i)))
      {
        throw Failure(this->Name,
          fmt::format("has an array '{}' that is not numeric, which VTK does not write "
                      "to .vtkhdf files; leave it out by --arrays",
            MakePrintableLine(data->GetAbstractArray(i)->GetName())));
      }
    }
    for (int role = 0; role < vtkDataSetAttributes::NUM_ATTRIBUTES; ++role)
    {
      if (data->GetAbstractAttribute(role))
      {
        this->Lost.insert("which arrays are active");
      }
    }
  }

  std::string Name;                                 // of the input
  std::vector<std::string> Arrays;                  // of the first step
  std::vector<vtkSmartPointer<vtkDataArray>> Cells; // of the first step
  vtkIdType Points = 0;                             // of the first step
  std::set<std::string> Lost;
};

/** The time steps of an input as a source that never fails: the pipeline would ask for the step
 * without end. After a failure, the step before stands for the others. */
class HDFSource : public vtkDataObjectAlgorithm
{
public:
  static HDFSource* New();
  vtkTypeMacro(HDFSource, vtkDataObjectAlgorithm);

  /** Reads the first step. Throws Failure. */
  void Open(Input& input, const Settings& settings)
  {
    this->From = &input;
    this->How = &settings;
    this->Checks.emplace(input.GetName());
    this->Read(0);
  }

  /** Throws what failed. */
  void Finish() const
  {
    if (this->Failed)
    {
      std::rethrow_exception(this->Failed);
    }
  }

  std::string ListLost() const { return this->Checks->ListLost(); }

protected:
  HDFSource() { this->SetNumberOfInputPorts(0); }

  int RequestDataObject(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    const auto output = vtk::TakeSmartPointer(this->Mesh->NewInstance());
    outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), output);
    return 1;
  }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    const std::vector<double>& times = this->From->GetTimes();
    const double range[2] = { times.front(), times.back() };
    vtkInformation* const info = outputVector->GetInformationObject(0);
    info->Set(
      vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override
  {
    const std::vector<double>& times = this->From->GetTimes();
    const double time = outputVector->GetInformationObject(0)->Get(
      vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    const auto step = std::find(times.begin(), times.end(), time) - times.begin();
    try
    {
      if (!this->Failed && !TakeErrors().empty())
      {
        throw Failure("cannot be written"); // the writer failed at the step before
      }
      if (!this->Failed)
      {
        this->Read(static_cast<std::size_t>(step));
      }
    }
    catch (...)
    {
      this->Failed = std::current_exception();
    }
    vtkDataObject::GetData(outputVector)->ShallowCopy(this->Mesh);
    return 1;
  }

private:
  void Read(std::size_t step)
  {
    gtn::Progress progress(
      fmt::format("writing step {} of {}", step + 1, this->From->GetTimes().size()),
      this->How->ShowProgress);
    auto* const mesh = vtkDataSet::SafeDownCast(this->From->Read(step, progress));
    this->Checks->Check(mesh);
    this->Mesh.TakeReference(mesh->NewInstance());
    this->Mesh->ShallowCopy(mesh);
  }

  Input* From = nullptr;
  const Settings* How = nullptr;
  std::optional<HDFCheck> Checks;
  vtkSmartPointer<vtkDataObject> Mesh; // of the last step that was read
  std::exception_ptr Failed;
};

vtkStandardNewMacro(HDFSource);

} // anonymous namespace

//------------------------------------------------------------------------------
std::string WriteHDF(Input& input, const std::string& file, bool compress, const Settings& settings)
{
  const auto write = GetFormatFunctions().WriteHDF;
  if (!write)
  {
    throw Failure(file,
      "this gtn was built with a VTK that does not write VTKHDF files (9.4 and later do); write a "
      ".pvd file");
  }
  vtkNew<HDFSource> source;
  source->Open(input, settings);
  TemporaryFile temporary(file);
  try
  {
    const bool good = write(source, temporary.GetName(), compress);
    CheckInterrupt();
    CheckWritten(source, good, temporary.GetName());
  }
  catch (const Failure& failure)
  {
    source->Finish();
    throw Failure(file, failure.what());
  }
  source->Finish();
  temporary.Commit();
  return source->ListLost();
}
}
