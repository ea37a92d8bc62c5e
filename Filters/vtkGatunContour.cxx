// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunContour.h"

#include "gatunArrayBridge.h"
#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunFileInput.h"
#include "gatunFileReader.h"
#include "gatunFileSurface.h"
#include "gatunSimplifiedFile.h"
#include "gatunSimplifyTarget.h"
#include "gatunSurfaceOutput.h"
#include "gatunTetInput.h"
#include "gatunTetMesh.h"
#include "vtkGatunCompat.h"
#include "vtkGatunReader.h"

#include "vtkCellData.h"
#include "vtkContourValues.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <optional>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunContour);

namespace
{
//------------------------------------------------------------------------------
/** Isovalues as the core takes them. */
std::vector<double> SortValues(vtkContourValues* values)
{
  const double* const first = values->GetValues();
  std::vector<double> sorted(first, first + values->GetNumberOfContours());
  if (!std::all_of(sorted.begin(), sorted.end(), [](double v) { return std::isfinite(v); }))
  {
    gatun::ThrowInvalid("an isovalue is not a finite number");
  }
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  return sorted;
}

//------------------------------------------------------------------------------
gatun::ScalarType ChooseType(int precision, gatun::ScalarType input)
{
  switch (precision)
  {
    case vtkAlgorithm::SINGLE_PRECISION:
      return gatun::ScalarType::Float32;
    case vtkAlgorithm::DOUBLE_PRECISION:
      return gatun::ScalarType::Float64;
    default:
      return input;
  }
}

//------------------------------------------------------------------------------
constexpr std::uint32_t Role(int attribute)
{
  return 1u << attribute;
}

/** Whether VTK interpolates an array along edges, or copies it from cells: ids of things that are
 * not in the output say nothing there. Nor do flags of ghosts, which cannot be interpolated. */
bool IsCarried(const gatun::ArrayDescription& array)
{
  if (array.Name == vtkDataSetAttributes::GhostArrayName())
  {
    return false;
  }
  if (array.Where == gatun::Association::Cell)
  {
    return (array.AttributeRoles & Role(vtkDataSetAttributes::GLOBALIDS)) == 0;
  }
  const std::uint32_t ids =
    Role(vtkDataSetAttributes::GLOBALIDS) | Role(vtkDataSetAttributes::PEDIGREEIDS);
  return (array.AttributeRoles & ids) == 0 && array.VTKType != VTK_ID_TYPE;
}

//------------------------------------------------------------------------------
/** As the core takes it: the number of components stands for their length, too. */
int ChooseComponent(int wanted, const gatun::ArrayDescription& array)
{
  return wanted == static_cast<int>(array.Components) ? -1 : wanted;
}

//------------------------------------------------------------------------------
/** The array of the isovalues becomes the active scalars. */
void SetScalarsRole(gatun::ArrayDescription& array, bool isContoured)
{
  if (array.Where == gatun::Association::Point)
  {
    array.AttributeRoles &= ~Role(vtkDataSetAttributes::SCALARS);
    array.AttributeRoles |= isContoured ? Role(vtkDataSetAttributes::SCALARS) : 0;
  }
}

//------------------------------------------------------------------------------
/** Which point array isosurfaces are of: by its name, or by its role. */
struct Wanted
{
  std::string Name;
  int Attribute = vtkDataSetAttributes::SCALARS;

  explicit Wanted(vtkInformation* info)
  {
    const int where = info->Has(vtkDataObject::FIELD_ASSOCIATION())
      ? info->Get(vtkDataObject::FIELD_ASSOCIATION())
      : vtkDataObject::FIELD_ASSOCIATION_POINTS;
    if (where != vtkDataObject::FIELD_ASSOCIATION_POINTS &&
      where != vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS)
    {
      gatun::ThrowInvalid("isosurfaces need an array on the points; vtkCellDataToPointData makes "
                          "one of an array on the cells");
    }
    if (info->Has(vtkDataObject::FIELD_NAME()))
    {
      this->Name = info->Get(vtkDataObject::FIELD_NAME());
    }
    else if (info->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
    {
      this->Attribute = info->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
    }
  }

  bool IsThis(const std::string& name, std::uint32_t roles) const
  {
    return this->Name.empty() ? (roles & Role(this->Attribute)) != 0 : name == this->Name;
  }

  [[noreturn]] void Fail() const
  {
    gatun::ThrowInvalid(this->Name.empty() ? "there are no active point scalars"
                                           : "there is no point array '" + this->Name + "'");
  }
};
}

//------------------------------------------------------------------------------
class vtkGatunContour::vtkInternals
{
public:
  using Progress = gatun::FileSurface::Progress;

  vtkNew<vtkContourValues> Values;

  // The file that surfaces were made from last, and with how many merges.
  gatun::CurrentFile File;
  std::unique_ptr<gatun::SimplifiedFile> Simplified;
  std::unique_ptr<gatun::FileSurface> Extractor;
  std::size_t Merges = 0;
  gatun::FileSurfaceStatistics Statistics;

  void Open(vtkGatunReader* reader, std::uint64_t cacheBudget);
  void FillFromFile(vtkGatunContour* self, vtkGatunReader* reader, vtkInformation* inInfo,
    vtkInformation* outInfo, const Progress& progress, vtkPolyData* output);
  void FillFromGrid(vtkGatunContour* self, vtkUnstructuredGrid* grid, const Progress& progress,
    vtkPolyData* output);
};

//------------------------------------------------------------------------------
void vtkGatunContour::vtkInternals::Open(vtkGatunReader* reader, std::uint64_t cacheBudget)
{
  const std::string path = reader->GetFileName();
  if (this->File.IsNew(path))
  {
    this->Extractor.reset();
    this->Simplified.reset();
  }
  const auto& file = this->File.Get(path);
  const std::size_t merges =
    gatun::CountMerges({ gatun::SimplifyTarget::Ratio, reader->GetSimplification() },
      file->GetNumberOfPoints(), file->GetNumberOfMerges(), {});
  if (!this->Extractor || merges != this->Merges)
  {
    this->Extractor.reset();
    if (merges == 0)
    {
      this->Extractor = std::make_unique<gatun::FileSurface>(file, cacheBudget);
    }
    else
    {
      if (!this->Simplified)
      {
        this->Simplified = std::make_unique<gatun::SimplifiedFile>(file);
      }
      const auto place = this->Simplified->Find(merges);
      this->Extractor =
        std::make_unique<gatun::FileSurface>(place.File, cacheBudget, place.Tree, place.Merges);
    }
    this->Merges = merges;
  }
  this->Extractor->SetCacheBudget(cacheBudget);
}

//------------------------------------------------------------------------------
void vtkGatunContour::vtkInternals::FillFromFile(vtkGatunContour* self, vtkGatunReader* reader,
  vtkInformation* inInfo, vtkInformation* outInfo, const Progress& progress, vtkPolyData* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  gatun::FileSurfaceRequest request;
  request.Options.Values = SortValues(this->Values);
  this->Open(reader, static_cast<std::uint64_t>(self->MemoryBudget) << 20);
  const gatun::FileReader& file = *this->Extractor->GetFile();
  if (inInfo->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    request.Step =
      gatun::FindStep(*this->File.GetLast(), inInfo->Get(Pipeline::UPDATE_TIME_STEP()));
  }

  // The arrays that the reader would give, as those of any other input.
  const Wanted wanted(self->GetInputArrayInformation(0));
  gatun::SurfaceOutput content;
  const auto& arrays = file.GetArrays();
  std::optional<std::uint32_t> scalars;
  for (std::uint32_t i = 0; i < arrays.size() && file.GetNumberOfSteps() > 0; ++i)
  {
    gatun::ArrayDescription array = arrays[i];
    const bool ofPoints = array.Where == gatun::Association::Point;
    const char* const name = array.Name.c_str();
    if (!array.Name.empty() &&
      (ofPoints ? reader->GetPointArrayStatus(name) : reader->GetCellArrayStatus(name)) == 0)
    {
      continue;
    }
    const bool isWanted = ofPoints && !scalars && wanted.IsThis(array.Name, array.AttributeRoles);
    scalars = isWanted ? i : scalars;
    if (IsCarried(array) && (!isWanted || self->ComputeScalars))
    {
      SetScalarsRole(array, isWanted);
      request.Arrays.push_back(i);
      content.Arrays.push_back(std::move(array));
    }
  }
  if (!scalars)
  {
    wanted.Fail();
  }
  request.Array = *scalars;
  request.Component = ChooseComponent(self->ArrayComponent, arrays[*scalars]);
  request.Options.CoordinateType =
    ChooseType(self->OutputPointsPrecision, file.GetCoordinateType());
  request.Options.Normals = self->ComputeNormals;
  const int pieces = std::max(1, Pipeline::GetUpdateNumberOfPieces(outInfo));
  const int piece = Pipeline::GetUpdatePiece(outInfo);
  if (piece >= 0 && piece < pieces)
  {
    request.Piece = static_cast<unsigned>(piece);
    request.Pieces = static_cast<unsigned>(pieces);
    const auto surface = this->Extractor->Extract(request, progress);
    this->Statistics = this->Extractor->GetStatistics();
    content.CoordinateType = request.Options.CoordinateType;
    content.Normals = self->ComputeNormals;
    content.Strips = self->OutputStrips;
    gatun::FillPolyData(surface, content, output);
  }
  const auto& times = this->File.GetLast()->GetTimes();
  if (this->File.GetLast()->HasTime() && request.Step < times.size())
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), times[request.Step]);
  }
}

//------------------------------------------------------------------------------
void vtkGatunContour::vtkInternals::FillFromGrid(
  vtkGatunContour* self, vtkUnstructuredGrid* grid, const Progress& progress, vtkPolyData* output)
{
  gatun::SurfaceOptions options;
  options.Values = SortValues(this->Values);
  const Wanted wanted(self->GetInputArrayInformation(0));
  if (grid->GetNumberOfCells() == 0)
  {
    return; // such as a piece that is empty, which need not have any arrays
  }
  const auto tets = gatun::MakeTetInput(grid, true);
  for (const auto& warning : tets.Warnings)
  {
    vtkWarningWithObjectMacro(self, << warning);
  }
  const gatun::TetMesh mesh(tets.Grid);
  if (mesh.Mesh.Points >= 0xffffffffu || mesh.Mesh.Tets >= 0xffffffffu)
  {
    gatun::ThrowInvalid("a mesh of more than 2^32 points or cells is too large");
  }

  gatun::SurfaceInput input;
  input.Mesh.Points = mesh.Mesh.Points;
  input.Mesh.Connectivity = mesh.Mesh.Connectivity;
  input.Mesh.WideIds = mesh.Mesh.WideIds;
  input.Points = { mesh.Mesh.Coordinates, mesh.Mesh.CoordinateType, 3 };
  gatun::SurfaceOutput content;
  std::vector<gatun::BridgedArray> owners;
  std::vector<double> converted;
  bool found = false;
  for (const auto where : { gatun::Association::Point, gatun::Association::Cell })
  {
    const bool ofPoints = where == gatun::Association::Point;
    vtkDataSetAttributes* const attributes = ofPoints
      ? static_cast<vtkDataSetAttributes*>(tets.Grid->GetPointData())
      : tets.Grid->GetCellData();
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* const array = attributes->GetArray(i);
      if (!array)
      {
        continue; // texts cannot be interpolated
      }
      gatun::BridgedArray& bridged = owners.emplace_back(gatun::Bridge(array, where));
      gatun::ArrayDescription& description = bridged.Description;
      description.AttributeRoles = gatun::AttributeRolesOf(attributes, array);
      const gatun::TupleView view{ bridged.Values, description.Type, description.Components };
      const bool isWanted =
        ofPoints && !found && wanted.IsThis(description.Name, description.AttributeRoles);
      if (isWanted)
      {
        found = true;
        const int component = ChooseComponent(self->ArrayComponent, description);
        if (component >= static_cast<int>(description.Components))
        {
          gatun::ThrowInvalid("array '" + description.Name + "' has no component " +
            std::to_string(self->ArrayComponent));
        }
        gatun::SetMarchValues(
          input.Mesh, view, static_cast<std::size_t>(mesh.Mesh.Points), component, converted);
      }
      if (IsCarried(description) && (!isWanted || self->ComputeScalars))
      {
        SetScalarsRole(description, isWanted);
        (ofPoints ? input.PointArrays : input.CellArrays).push_back(view);
        content.Arrays.push_back(description);
      }
    }
  }
  if (!found)
  {
    wanted.Fail();
  }
  options.CoordinateType = ChooseType(self->OutputPointsPrecision, mesh.Mesh.CoordinateType);
  options.Normals = self->ComputeNormals;
  auto parts = gatun::MakeSurfaceParts(input, options, mesh.Mesh.Tets, progress);
  content.CoordinateType = options.CoordinateType;
  content.Normals = self->ComputeNormals;
  content.Strips = self->OutputStrips;
  gatun::FillPolyData(gatun::Surface(std::move(parts), options.CoordinateType), content, output);
}

//------------------------------------------------------------------------------
vtkGatunContour::vtkGatunContour()
  : Internals(std::make_unique<vtkInternals>())
{
  this->Internals->Values->SetNumberOfContours(0);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkGatunContour::~vtkGatunContour() = default;

//------------------------------------------------------------------------------
void vtkGatunContour::SetValue(int i, double value)
{
  this->Internals->Values->SetValue(i, value);
}

//------------------------------------------------------------------------------
double vtkGatunContour::GetValue(int i)
{
  return this->Internals->Values->GetValue(i);
}

//------------------------------------------------------------------------------
double* vtkGatunContour::GetValues()
{
  return this->Internals->Values->GetValues();
}

//------------------------------------------------------------------------------
void vtkGatunContour::GetValues(double* values)
{
  this->Internals->Values->GetValues(values);
}

//------------------------------------------------------------------------------
void vtkGatunContour::SetNumberOfContours(int number)
{
  this->Internals->Values->SetNumberOfContours(number);
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunContour::GetNumberOfContours()
{
  return this->Internals->Values->GetNumberOfContours();
}

//------------------------------------------------------------------------------
void vtkGatunContour::GenerateValues(int number, double range[2])
{
  this->Internals->Values->GenerateValues(number, range);
}

//------------------------------------------------------------------------------
void vtkGatunContour::GenerateValues(int number, double first, double last)
{
  this->Internals->Values->GenerateValues(number, first, last);
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunContour::GetNumberOfChunks()
{
  const auto& self = *this->Internals;
  return self.Extractor ? static_cast<vtkIdType>(self.Extractor->GetFile()->GetChunks().size()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunContour::GetNumberOfChunksUsed()
{
  return static_cast<vtkIdType>(this->Internals->Statistics.Chunks);
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunContour::GetNumberOfTetrahedraUsed()
{
  return static_cast<vtkIdType>(this->Internals->Statistics.Tets);
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkGatunContour::GetBytesRead()
{
  const auto& self = *this->Internals;
  return self.Simplified ? self.Simplified->GetBytesRead()
    : self.Extractor     ? self.Extractor->GetFile()->GetBytesRead()
                         : 0;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkGatunContour::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Internals->Values->GetMTime());
}

//------------------------------------------------------------------------------
int vtkGatunContour::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
vtkAlgorithm* vtkGatunContour::FindProducer()
{
  return this->GetInputAlgorithm();
}

//------------------------------------------------------------------------------
int vtkGatunContour::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  if (vtkGatunReader* const reader = gatun::GetFileReader(this->GetInputAlgorithm()))
  {
    gatun::RequestNothing(reader, inputVector[0]->GetInformationObject(0));
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunContour::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* const output = vtkPolyData::GetData(outputVector, 0);
  output->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);
  auto& self = *this->Internals;
  self.Statistics = {};
  const auto progress = [this](double fraction)
  {
    this->UpdateProgress(fraction);
    return !gatun::IsAborted(this);
  };
  vtkGatunReader* const reader = gatun::GetFileReader(this->FindProducer());
  try
  {
    if (reader)
    {
      self.FillFromFile(this, reader, inputVector[0]->GetInformationObject(0),
        outputVector->GetInformationObject(0), progress, output);
    }
    else
    {
      self.Extractor.reset();
      self.Simplified.reset();
      self.File.Close();
      self.FillFromGrid(this, vtkUnstructuredGrid::GetData(inputVector[0], 0), progress, output);
    }
    this->UpdateProgress(1);
    return 1;
  }
  catch (...)
  {
    output->Initialize();
    const gatun::VTKFailure failure =
      gatun::DescribeFailure(reader ? reader->GetFileName() : "The isosurface cannot be made");
    this->SetErrorCode(failure.Code);
    if (!failure.Aborted)
    {
      vtkErrorMacro(<< failure.Message);
    }
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkGatunContour::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto tell = [](bool value) { return value ? "On" : "Off"; };
  os << indent << "Values:\n";
  this->Internals->Values->PrintSelf(os, indent.GetNextIndent());
  os << indent << "ArrayComponent: " << this->ArrayComponent << "\n";
  os << indent << "ComputeNormals: " << tell(this->ComputeNormals) << "\n";
  os << indent << "ComputeScalars: " << tell(this->ComputeScalars) << "\n";
  os << indent << "OutputStrips: " << tell(this->OutputStrips) << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
