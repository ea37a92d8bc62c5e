// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunReader.h"

#include "gatunArrayBridge.h"
#include "gatunChunkCache.h"
#include "gatunChunkTable.h"
#include "gatunError.h"
#include "gatunErrorCodes.h"
#include "gatunExactGhosts.h"
#include "gatunFileInput.h"
#include "gatunFileReader.h"
#include "gatunFileSignature.h"
#include "gatunOutline.h"
#include "gatunParallel.h"
#include "gatunPieceDecoder.h"
#include "gatunSimplifiedFile.h"
#include "gatunSimplifyTarget.h"
#include "vtkGatunCompat.h"
#include "vtkGatunErrorCode.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArraySelection.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkTimeStamp.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <new>
#include <string>
#include <utility>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

static_assert(sizeof(vtkIdType) == sizeof(std::int64_t), "Gatun needs a VTK with 64-bit ids.");

namespace
{

using gatun::Association;

//------------------------------------------------------------------------------
// A vtkDataArraySelection that remembers arrays which the file at hand does not have, so that a
// series of files with differing arrays keeps what was chosen.
class ArrayChoice
{
public:
  void SetArrays(const std::vector<std::string>& names)
  {
    for (int i = 0; i < this->Selection->GetNumberOfArrays(); ++i)
    {
      this->Remembered[this->Selection->GetArrayName(i)] = this->Selection->GetArraySetting(i) != 0;
    }
    std::vector<const char*> pointers;
    pointers.reserve(names.size());
    for (const std::string& name : names)
    {
      pointers.push_back(name.c_str());
    }
    // None of these touches the modification time, as the arrays of a file are not a choice.
    this->Selection->SetArrays(pointers.data(), static_cast<int>(pointers.size()));
    for (const std::string& name : names)
    {
      const auto known = this->Remembered.find(name);
      if (known != this->Remembered.end() &&
        known->second != (this->Selection->ArrayIsEnabled(name.c_str()) != 0))
      {
        this->Selection->RemoveArrayByName(name.c_str());
        this->Selection->AddArray(name.c_str(), known->second);
      }
    }
  }

  bool Wants(const std::string& name) const
  {
    return name.empty() || this->Selection->ArrayIsEnabled(name.c_str());
  }

  vtkNew<vtkDataArraySelection> Selection;

private:
  std::map<std::string, bool> Remembered;
};

//------------------------------------------------------------------------------
std::uint64_t MebibytesToBytes(int mebibytes)
{
  return static_cast<std::uint64_t>(mebibytes) << 20;
}

//------------------------------------------------------------------------------
bool Touches(const gatun::Range& range, double low, double high)
{
  return range.Min <= range.Max && range.Min <= high && range.Max >= low;
}

//------------------------------------------------------------------------------
// Offsets 0, 4, 8, ... of tetrahedra.
template <typename ArrayT>
vtkSmartPointer<ArrayT> MakeOffsets(vtkIdType tets)
{
  using ValueT = typename ArrayT::ValueType;
  auto offsets = vtkSmartPointer<ArrayT>::New();
  offsets->SetNumberOfValues(tets + 1);
  ValueT* values = offsets->GetPointer(0);
  constexpr vtkIdType block = 1 << 20;
  gatun::ParallelFor(static_cast<std::size_t>(tets / block + 1),
    [values, tets](std::size_t part)
    {
      const auto begin = static_cast<vtkIdType>(part) * block;
      const vtkIdType end = std::min(begin + block, tets + 1);
      for (vtkIdType i = begin; i < end; ++i)
      {
        values[i] = static_cast<ValueT>(4 * i);
      }
    });
  return offsets;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkIdTypeArray> MakeIds(const char* name, vtkIdType values)
{
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(name);
  ids->SetNumberOfValues(values);
  return ids;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnsignedCharArray> MakeGhosts(vtkIdType values)
{
  auto ghosts = vtkSmartPointer<vtkUnsignedCharArray>::New();
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(values);
  return ghosts;
}

//------------------------------------------------------------------------------
std::int64_t* PointerTo(vtkIdTypeArray* ids)
{
  return reinterpret_cast<std::int64_t*>(ids->GetPointer(0));
}

//------------------------------------------------------------------------------
// Adds ghost flags; those that the file holds (of hidden points, say) stay.
void AddGhosts(vtkDataSetAttributes* attributes, vtkUnsignedCharArray* ghosts)
{
  if (!ghosts)
  {
    return;
  }
  auto* stored = vtkUnsignedCharArray::SafeDownCast(attributes->GetArray(ghosts->GetName()));
  if (!stored || stored->GetNumberOfValues() != ghosts->GetNumberOfValues())
  {
    attributes->AddArray(ghosts);
    return;
  }
  for (vtkIdType i = 0; i < ghosts->GetNumberOfValues(); ++i)
  {
    stored->SetValue(i, static_cast<unsigned char>(stored->GetValue(i) | ghosts->GetValue(i)));
  }
}

} // anonymous namespace

//------------------------------------------------------------------------------
class vtkGatunReader::vtkInternals
{
public:
  // The file, as it was when opened.
  std::string Path;
  gatun::FileSignature Signature;
  std::shared_ptr<const gatun::FileReader> File;
  vtkSmartPointer<vtkTable> Table;

  // Bumped when the file changed on disk, or when what was read last must not be kept.
  vtkTimeStamp FileTime;
  bool ReadAgain = false;

  ArrayChoice PointArrays;
  ArrayChoice CellArrays;

  // What was decoded of the file, or of the base mesh that is read.
  std::shared_ptr<gatun::ChunkCache> Cache;
  std::uint64_t DecodedBefore = 0; ///< chunks, with other caches

  // How the mesh becomes simpler, once that was needed.
  std::unique_ptr<gatun::SimplifiedFile> Simplified;

  // The mesh last read, which other steps and arrays share.
  std::unique_ptr<gatun::PieceDecoder> Decoder;
  gatun::PieceRequest MeshRequest;
  vtkSmartPointer<vtkUnstructuredGrid> Mesh;
  vtkSmartPointer<vtkIdTypeArray> PointIds;
  vtkSmartPointer<vtkIdTypeArray> CellIds;
  vtkSmartPointer<vtkUnsignedCharArray> PointGhosts;
  vtkSmartPointer<vtkUnsignedCharArray> CellGhosts;

  void ForgetMesh()
  {
    this->Decoder.reset();
    this->Mesh = nullptr;
    this->PointIds = nullptr;
    this->CellIds = nullptr;
    this->PointGhosts = nullptr;
    this->CellGhosts = nullptr;
  }

  void Close()
  {
    this->ForgetMesh();
    this->Simplified.reset();
    this->Cache.reset();
    this->DecodedBefore = 0;
    this->File.reset();
    this->Table = nullptr;
  }

  bool IsOpen(const std::string& path) const { return this->File && this->Path == path; }

  /** Opens the file unless it is open and unchanged; a file opened anew has a new cache. */
  void Open(const std::string& path, std::uint64_t cacheBytes)
  {
    const gatun::FileSignature signature = gatun::SignatureOf(path);
    if (this->IsOpen(path) && signature == this->Signature)
    {
      return;
    }
    this->Close();
    this->Path = path;
    this->Signature = signature;
    auto file = std::make_shared<const gatun::FileReader>(path);
    this->Table = gatun::MakeChunkTable(*file);
    this->Cache = std::make_shared<gatun::ChunkCache>(file, cacheBytes);
    this->File = std::move(file);
    this->PointArrays.SetArrays(this->NamesOf(Association::Point));
    this->CellArrays.SetArrays(this->NamesOf(Association::Cell));
  }

  static gatun::SimplifyProperties Target(const vtkGatunReader& reader)
  {
    static_assert(int{ TARGET_RATIO } == gatun::SimplifyTarget::Ratio);
    static_assert(int{ TARGET_NUMBER_OF_POINTS } == gatun::SimplifyTarget::NumberOfPoints);
    static_assert(int{ TARGET_RMS_ERROR } == gatun::SimplifyTarget::RMSError);
    return { reader.SimplificationTarget, reader.SimplificationRatio,
      reader.SimplificationNumberOfPoints, reader.SimplificationRMSError };
  }

  /** Whether a simplification is asked for, possible or not. */
  static bool Simplifies(const vtkGatunReader& reader)
  {
    return !Target(reader).GetTarget().IsWholeMesh();
  }

  std::size_t CountMerges(const vtkGatunReader& reader)
  {
    if (!Simplifies(reader))
    {
      return 0;
    }
    if (!this->Simplified)
    {
      this->Simplified = std::make_unique<gatun::SimplifiedFile>(this->File);
    }
    return gatun::CountMerges(Target(reader).GetTarget(), this->File->GetNumberOfPoints(),
      this->File->GetNumberOfMerges(),
      [this]() -> const gatun::MergeTree& { return this->Simplified->GetTree(); });
  }

  /** Decides which mesh in the file is read, and what becomes of it. */
  void Choose(const vtkGatunReader& reader, gatun::PieceRequest& request)
  {
    const std::size_t merges = this->CountMerges(reader);
    gatun::SimplifiedFile::Place place{ this->File, nullptr, 0 };
    if (merges > 0)
    {
      const bool keepsOrder = reader.RestoreOrder && this->File->GetKeptOrder() != gatun::KeepNone;
      place = this->Simplified->Find(merges, !keepsOrder);
    }
    if (place.File != this->Cache->GetFile())
    {
      this->ForgetMesh();
      this->DecodedBefore += this->Cache->GetStatistics().MeshesDecoded;
      this->Cache =
        std::make_shared<gatun::ChunkCache>(place.File, MebibytesToBytes(reader.MemoryBudget));
    }
    request.Merges = place.Merges;
    request.Tree = place.Tree;
  }

  /** The mesh that is read. */
  const gatun::FileReader& GetUsed() const { return *this->Cache->GetFile(); }

  std::vector<std::string> NamesOf(Association where) const
  {
    std::vector<std::string> names;
    for (const gatun::ArrayDescription& array : this->File->GetArrays())
    {
      if (array.Where == where && !array.Name.empty() &&
        std::find(names.begin(), names.end(), array.Name) == names.end())
      {
        names.push_back(array.Name);
      }
    }
    return names;
  }

  bool Wants(const gatun::ArrayDescription& array) const
  {
    return array.Where == Association::Point ? this->PointArrays.Wants(array.Name)
                                             : this->CellArrays.Wants(array.Name);
  }

  /** Which values of an array to look at: index of it and of the range. */
  std::pair<std::size_t, std::size_t> FindRange(
    const std::string& name, Association where, int component) const
  {
    const auto& arrays = this->File->GetArrays();
    const auto found = std::find_if(arrays.begin(), arrays.end(),
      [&](const gatun::ArrayDescription& array)
      { return array.Where == where && array.Name == name; });
    const std::string place = where == Association::Point ? "point" : "cell";
    if (found == arrays.end())
    {
      throw gatun::Error(gatun::ErrorCode::InvalidInput,
        this->Path + ": there is no " + place + " array '" + name + "' for the value range");
    }
    if (component >= static_cast<int>(found->Components))
    {
      throw gatun::Error(gatun::ErrorCode::InvalidInput,
        this->Path + ": the " + place + " array '" + name + "' has no component " +
          std::to_string(component) + " for the value range");
    }
    const std::size_t length = found->Components > 1 ? found->Components : 0;
    return { static_cast<std::size_t>(found - arrays.begin()),
      component < 0 ? length : static_cast<std::size_t>(component) };
  }

  /** The chunks that the region of interest leaves: the universe of a request. */
  std::vector<std::uint32_t> ChunksOf(
    const vtkGatunReader& reader, std::size_t step, std::size_t merges) const
  {
    const gatun::FileReader& file = this->GetUsed();
    const std::size_t chunks = file.GetChunks().size();
    const bool byValue = reader.UseValueRange && reader.ValueRangeArray && *reader.ValueRangeArray;
    std::pair<std::size_t, std::size_t> range;
    if (byValue)
    {
      range = this->FindRange(reader.ValueRangeArray,
        reader.ValueRangeAssociation == vtkDataObject::FIELD_ASSOCIATION_CELLS ? Association::Cell
                                                                               : Association::Point,
        reader.ValueRangeComponent);
    }
    std::vector<std::uint32_t> chosen;
    for (std::size_t chunk = 0; chunk < chunks; ++chunk)
    {
      bool inside = true;
      for (std::size_t axis = 0; reader.UseBox && axis < 3; ++axis)
      {
        inside = inside &&
          Touches(file.GetChunkBounds(chunk, merges)[axis], reader.Box[2 * axis],
            reader.Box[2 * axis + 1]);
      }
      if (inside && byValue)
      {
        inside = step < file.GetNumberOfSteps() &&
          Touches(file.GetChunkRanges(range.first, step, chunk, merges)[range.second],
            reader.ValueRange[0], reader.ValueRange[1]);
      }
      if (inside)
      {
        chosen.push_back(static_cast<std::uint32_t>(chunk));
      }
    }
    return chosen;
  }

  /** Whether the output is an outline. */
  bool IsOnDemand(const vtkGatunReader& reader)
  {
    if (!this->File || reader.UseBox || reader.UseValueRange)
    {
      return false;
    }
    if (reader.OnDemand != ON_DEMAND_LARGE)
    {
      return reader.OnDemand == ON_DEMAND_ALWAYS;
    }
    const std::size_t merges = this->CountMerges(reader);
    const std::uint64_t tets =
      merges > 0 ? this->Simplified->EstimateTets(merges) : this->File->GetNumberOfTets();
    return tets > static_cast<std::uint64_t>(reader.LargeMesh);
  }

  /** Makes the outline, or what is the same without points and cells. */
  void MakeOutline(const gatun::PieceRequest& request, bool isEmpty, vtkUnstructuredGrid* output)
  {
    this->ForgetMesh();
    this->Cache->Clear();
    gatun::MakeOutline(*this->File, request.Arrays, request.Step, isEmpty, output);
    this->AddFieldData(request.Step, output);
    output->GetInformation()->Set(ON_DEMAND(), 1);
  }

  void AddFieldData(std::size_t step, vtkUnstructuredGrid* output) const
  {
    if (step < this->File->GetNumberOfSteps())
    {
      gatun::AddFieldData(output->GetFieldData(), this->File->GetFieldData(step));
    }
  }

  bool HasMeshOf(const gatun::PieceRequest& request) const
  {
    gatun::PieceRequest mesh = request;
    mesh.Arrays = this->MeshRequest.Arrays;
    mesh.Step = this->MeshRequest.Step;
    return this->Mesh && mesh == this->MeshRequest;
  }

  /** Makes a mesh with room for the request that the decoder has; tells where the room is. */
  void MakeMesh(gatun::PieceTarget& target)
  {
    const auto points = static_cast<vtkIdType>(this->Decoder->GetNumberOfPoints());
    const auto tets = static_cast<vtkIdType>(this->Decoder->GetNumberOfTets());

    vtkNew<vtkPoints> coordinates;
    coordinates->SetDataType(
      this->File->GetCoordinateType() == gatun::ScalarType::Float64 ? VTK_DOUBLE : VTK_FLOAT);
    coordinates->SetNumberOfPoints(points);
    target.Points = coordinates->GetVoidPointer(0);

    vtkNew<vtkCellArray> cells;
    target.WideIds =
      this->File->HasWideIds() || tets >= std::numeric_limits<vtkTypeInt32>::max() / 4;
    if (target.WideIds)
    {
      vtkNew<vtkTypeInt64Array> connectivity;
      connectivity->SetNumberOfValues(4 * tets);
      target.Connectivity = connectivity->GetPointer(0);
      cells->SetData(MakeOffsets<vtkTypeInt64Array>(tets), connectivity);
    }
    else
    {
      vtkNew<vtkTypeInt32Array> connectivity;
      connectivity->SetNumberOfValues(4 * tets);
      target.Connectivity = connectivity->GetPointer(0);
      cells->SetData(MakeOffsets<vtkTypeInt32Array>(tets), connectivity);
    }
    this->Mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
    this->Mesh->SetPoints(coordinates);
    this->Mesh->SetCells(VTK_TETRA, cells);
  }

  /** Reads a piece; ids: whether to make global ids where the output has none. */
  void Read(const gatun::PieceRequest& request, bool ids, vtkUnstructuredGrid* output,
    const std::function<bool(double)>& progress)
  {
    const bool meshIsThere = this->HasMeshOf(request);
    if (!meshIsThere)
    {
      this->ForgetMesh();
    }
    if (!this->Decoder)
    {
      this->Decoder = std::make_unique<gatun::PieceDecoder>(this->Cache);
    }
    const double share = request.GhostLevels > 0 && !meshIsThere ? 0.5 : 0.0;
    this->Decoder->SetRequest(
      request, [&progress, share](double fraction) { return progress(share * fraction); });
    const auto points = static_cast<vtkIdType>(this->Decoder->GetNumberOfPoints());
    const auto tets = static_cast<vtkIdType>(this->Decoder->GetNumberOfTets());

    gatun::PieceTarget target;
    if (!meshIsThere)
    {
      this->MakeMesh(target);
      this->MeshRequest = request;
      if (request.GhostLevels > 0)
      {
        this->PointGhosts = MakeGhosts(points);
        this->CellGhosts = MakeGhosts(tets);
        target.PointGhosts = this->PointGhosts->GetPointer(0);
        target.CellGhosts = this->CellGhosts->GetPointer(0);
      }
    }
    const bool pointIds = ids && !this->HasGlobalIds(request, Association::Point);
    const bool cellIds = ids && !this->HasGlobalIds(request, Association::Cell);
    if (pointIds && !this->PointIds)
    {
      this->PointIds = MakeIds("GlobalPointIds", points);
      target.GlobalPointIds = PointerTo(this->PointIds);
    }
    if (cellIds && !this->CellIds)
    {
      this->CellIds = MakeIds("GlobalCellIds", tets);
      target.GlobalCellIds = PointerTo(this->CellIds);
    }
    std::vector<gatun::ArrayFiller> fillers;
    for (const std::uint32_t array : request.Arrays)
    {
      const gatun::ArrayDescription& description = this->File->GetArrays()[array];
      fillers.emplace_back(description, description.Where == Association::Point ? points : tets);
      target.Arrays.push_back(fillers.back().GetBuffer());
    }
    this->Decoder->Fill(target,
      [&progress, share](double fraction) { return progress(share + (1 - share) * fraction); });

    output->CopyStructure(this->Mesh);
    for (std::size_t i = 0; i < fillers.size(); ++i)
    {
      const gatun::ArrayDescription& description = this->File->GetArrays()[request.Arrays[i]];
      gatun::AddWithRoles(
        AttributesOf(output, description.Where), fillers[i].Finish(), description.AttributeRoles);
    }
    if (pointIds)
    {
      output->GetPointData()->SetGlobalIds(this->PointIds);
    }
    if (cellIds)
    {
      output->GetCellData()->SetGlobalIds(this->CellIds);
    }
    AddGhosts(output->GetPointData(), this->PointGhosts);
    AddGhosts(output->GetCellData(), this->CellGhosts);
    this->AddFieldData(request.Step, output);
  }

private:
  static vtkDataSetAttributes* AttributesOf(vtkUnstructuredGrid* grid, Association where)
  {
    if (where == Association::Point)
    {
      return grid->GetPointData();
    }
    return grid->GetCellData();
  }

  // Whether an array of the request is, or is named like, global ids.
  bool HasGlobalIds(const gatun::PieceRequest& request, Association where) const
  {
    const char* name = where == Association::Point ? "GlobalPointIds" : "GlobalCellIds";
    return std::any_of(request.Arrays.begin(), request.Arrays.end(),
      [&](std::uint32_t index)
      {
        const gatun::ArrayDescription& array = this->File->GetArrays()[index];
        return array.Where == where &&
          (array.Name == name ||
            (array.AttributeRoles >> vtkDataSetAttributes::GLOBALIDS & 1u) != 0);
      });
  }
};

vtkStandardNewMacro(vtkGatunReader);
vtkInformationKeyRestrictedMacro(vtkGatunReader, CHUNK_TABLE, ObjectBase, "vtkTable");
vtkInformationKeyMacro(vtkGatunReader, ON_DEMAND, Integer);

//------------------------------------------------------------------------------
vtkGatunReader::vtkGatunReader()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkGatunReader::~vtkGatunReader()
{
  this->SetFileName(nullptr);
  this->SetValueRangeArray(nullptr);
}

//------------------------------------------------------------------------------
void vtkGatunReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "RestoreOrder: " << (this->RestoreOrder ? "On" : "Off") << "\n";
  os << indent << "GenerateGlobalIds: " << (this->GenerateGlobalIds ? "On" : "Off") << "\n";
  os << indent << "UseBox: " << (this->UseBox ? "On" : "Off") << "\n";
  os << indent << "Box: " << this->Box[0] << " " << this->Box[1] << " " << this->Box[2] << " "
     << this->Box[3] << " " << this->Box[4] << " " << this->Box[5] << "\n";
  os << indent << "UseValueRange: " << (this->UseValueRange ? "On" : "Off") << "\n";
  os << indent << "ValueRangeArray: " << (this->ValueRangeArray ? this->ValueRangeArray : "(none)")
     << "\n";
  os << indent << "ValueRangeAssociation: "
     << (this->ValueRangeAssociation == vtkDataObject::FIELD_ASSOCIATION_CELLS ? "Cells" : "Points")
     << "\n";
  os << indent << "ValueRangeComponent: " << this->ValueRangeComponent << "\n";
  os << indent << "ValueRange: " << this->ValueRange[0] << " " << this->ValueRange[1] << "\n";
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
  const char* const modes[] = { "Never", "Always", "Large" };
  os << indent << "OnDemand: " << modes[this->OnDemand] << "\n";
  os << indent << "LargeMesh: " << this->LargeMesh << "\n";
  vtkInternals::Target(*this).Print(os, indent);
  os << indent << "HasHierarchy: " << (this->GetHasHierarchy() ? "true" : "false") << "\n";
  os << indent << "IsOnDemand: " << (this->GetIsOnDemand() ? "true" : "false") << "\n";
  os << indent << "CachedBytes: " << this->GetCachedBytes() << "\n";
  os << indent << "DecodedChunks: " << this->GetDecodedChunks() << "\n";
  os << indent << "BytesRead: " << this->GetBytesRead() << "\n";
  os << indent << "PointDataArraySelection:\n";
  this->GetPointDataArraySelection()->PrintSelf(os, indent.GetNextIndent());
  os << indent << "CellDataArraySelection:\n";
  this->GetCellDataArraySelection()->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
int vtkGatunReader::CanReadFile(const char* name)
{
  try
  {
    return name && gatun::FileReader::CanRead(name) ? 1 : 0;
  }
  catch (const std::bad_alloc&)
  {
    return 0; // there is not even memory for the name
  }
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkGatunReader::GetPointDataArraySelection()
{
  return this->Internals->PointArrays.Selection;
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkGatunReader::GetCellDataArraySelection()
{
  return this->Internals->CellArrays.Selection;
}

//------------------------------------------------------------------------------
int vtkGatunReader::GetNumberOfPointArrays()
{
  return this->GetPointDataArraySelection()->GetNumberOfArrays();
}

//------------------------------------------------------------------------------
const char* vtkGatunReader::GetPointArrayName(int index)
{
  return this->GetPointDataArraySelection()->GetArrayName(index);
}

//------------------------------------------------------------------------------
int vtkGatunReader::GetPointArrayStatus(const char* name)
{
  return this->GetPointDataArraySelection()->ArrayIsEnabled(name);
}

//------------------------------------------------------------------------------
void vtkGatunReader::SetPointArrayStatus(const char* name, int status)
{
  this->GetPointDataArraySelection()->SetArraySetting(name, status);
}

//------------------------------------------------------------------------------
int vtkGatunReader::GetNumberOfCellArrays()
{
  return this->GetCellDataArraySelection()->GetNumberOfArrays();
}

//------------------------------------------------------------------------------
const char* vtkGatunReader::GetCellArrayName(int index)
{
  return this->GetCellDataArraySelection()->GetArrayName(index);
}

//------------------------------------------------------------------------------
int vtkGatunReader::GetCellArrayStatus(const char* name)
{
  return this->GetCellDataArraySelection()->ArrayIsEnabled(name);
}

//------------------------------------------------------------------------------
void vtkGatunReader::SetCellArrayStatus(const char* name, int status)
{
  this->GetCellDataArraySelection()->SetArraySetting(name, status);
}

//------------------------------------------------------------------------------
vtkTable* vtkGatunReader::GetChunkTable()
{
  return this->Internals->Table;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkGatunReader::GetBytesRead()
{
  const vtkInternals& self = *this->Internals;
  return self.Simplified ? self.Simplified->GetBytesRead()
    : self.File          ? self.File->GetBytesRead()
                         : 0;
}

//------------------------------------------------------------------------------
// The output does not depend on it, so this is no modification.
void vtkGatunReader::SetMemoryBudget(int mebibytes)
{
  this->MemoryBudget = std::max(0, mebibytes);
  if (this->Internals->Cache)
  {
    this->Internals->Cache->SetBudget(MebibytesToBytes(this->MemoryBudget));
  }
}

//------------------------------------------------------------------------------
bool vtkGatunReader::GetIsOnDemand()
{
  try
  {
    return this->Internals->IsOnDemand(*this);
  }
  catch (...)
  {
    return false; // the update tells what is wrong
  }
}

//------------------------------------------------------------------------------
double vtkGatunReader::GetSimplification()
{
  vtkInternals& self = *this->Internals;
  if (!vtkInternals::Simplifies(*this))
  {
    return 0;
  }
  try
  {
    this->UpdateInformation();
    if (!self.File)
    {
      return -1;
    }
    const auto merges = static_cast<double>(self.CountMerges(*this));
    const auto points = static_cast<double>(self.File->GetNumberOfPoints());
    // Half a point more, so that rounding does not matter.
    return merges > 0 ? std::min(1.0, (merges + 0.5) / points) : 0;
  }
  catch (...)
  {
    return -1;
  }
}

//------------------------------------------------------------------------------
bool vtkGatunReader::GetHasHierarchy()
{
  return this->Internals->File && this->Internals->File->HasMergeTree();
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkGatunReader::GetCachedBytes()
{
  return this->Internals->Cache ? this->Internals->Cache->GetStatistics().Bytes : 0;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkGatunReader::GetDecodedChunks()
{
  const vtkInternals& self = *this->Internals;
  return self.Cache ? self.DecodedBefore + self.Cache->GetStatistics().MeshesDecoded : 0;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkGatunReader::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->GetPointDataArraySelection()->GetMTime(),
    this->GetCellDataArraySelection()->GetMTime() });
}

//------------------------------------------------------------------------------
int vtkGatunReader::ComputePipelineMTime(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inInfoVec), vtkInformationVector* vtkNotUsed(outInfoVec),
  int vtkNotUsed(requestFromOutputPort), vtkMTimeType* mtime)
{
  // Here and not in GetMTime: there it would change in the middle of a request.
  vtkInternals& self = *this->Internals;
  if (self.ReadAgain ||
    (this->FileName && self.Path == this->FileName &&
      gatun::SignatureOf(self.Path) != self.Signature))
  {
    self.FileTime.Modified();
    self.ReadAgain = false;
  }
  *mtime = std::max(this->GetMTime(), self.FileTime.GetMTime());
  return 1;
}

//------------------------------------------------------------------------------
// Within a catch block: reports, and leaves nothing of what was read before. What was thrown ends
// here, and nothing else may be thrown if memory has run out: so that is freed first.
void vtkGatunReader::Fail(vtkInformationVector* outputVector) noexcept
{
  this->Internals->ForgetMesh();
  const gatun::VTKFailure failure =
    gatun::DescribeFailure(this->FileName ? this->FileName : "(no file)");
  if (this->Internals->Cache && !failure.Aborted)
  {
    this->Internals->Cache->Clear();
  }
  this->SetErrorCode(failure.Code);
  try
  {
    vtkInformation* outInfo = outputVector->GetInformationObject(0);
    if (auto* output = vtkDataObject::GetData(outInfo))
    {
      output->Initialize();
      output->GetInformation()->Remove(ON_DEMAND());
    }
    if (!failure.Aborted)
    {
      vtkErrorMacro(<< failure.Message);
    }
  }
  catch (const std::bad_alloc&)
  {
    // The error code tells it.
  }
}

//------------------------------------------------------------------------------
int vtkGatunReader::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInternals& self = *this->Internals;
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  outInfo->Remove(CHUNK_TABLE());
  outInfo->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  outInfo->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  outInfo->Remove(vtkStreamingDemandDrivenPipeline::BOUNDS());
  outInfo->Remove(vtkDataObject::BOUNDING_BOX());
  if (!this->FileName || !*this->FileName)
  {
    if (auto* output = vtkDataObject::GetData(outInfo))
    {
      output->Initialize();
    }
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("No FileName was set.");
    return 0;
  }
  try
  {
    self.Open(this->FileName, MebibytesToBytes(this->MemoryBudget));
    outInfo->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
    outInfo->Set(gatun::ExactGhostLevels(), 1);
    outInfo->Set(CHUNK_TABLE(), self.Table);
    if (self.File->HasTime() && !self.File->GetTimes().empty())
    {
      const std::vector<double>& times = self.File->GetTimes();
      const double range[2] = { times.front(), times.back() };
      outInfo->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(),
        static_cast<int>(times.size()));
      outInfo->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    }
    const gatun::Bounds& box = self.File->GetBounds();
    if (box[0].Min <= box[0].Max && box[1].Min <= box[1].Max && box[2].Min <= box[2].Max)
    {
      const double bounds[6] = { box[0].Min, box[0].Max, box[1].Min, box[1].Max, box[2].Min,
        box[2].Max };
      outInfo->Set(vtkStreamingDemandDrivenPipeline::BOUNDS(), bounds, 6);
      outInfo->Set(vtkDataObject::BOUNDING_BOX(), bounds, 6);
    }
  }
  catch (...)
  {
    self.Close();
    this->Fail(outputVector);
    return 0;
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInternals& self = *this->Internals;
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outInfo);
  if (!this->FileName || !*this->FileName)
  {
    output->Initialize();
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("No FileName was set.");
    return 0;
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    output->Initialize();
    output->GetInformation()->Remove(ON_DEMAND());
    this->UpdateProgress(0);
    const int pieces =
      std::max(1, vtkStreamingDemandDrivenPipeline::GetUpdateNumberOfPieces(outInfo));
    const int piece = vtkStreamingDemandDrivenPipeline::GetUpdatePiece(outInfo);
    if (!self.IsOpen(this->FileName))
    {
      self.Open(this->FileName, MebibytesToBytes(this->MemoryBudget));
    }
    gatun::PieceRequest request;
    if (self.File->HasTime() && outInfo->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
    {
      request.Step = gatun::FindStep(
        *self.File, outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()));
    }
    self.Choose(*this, request);
    const std::vector<std::uint32_t> chunks = self.ChunksOf(*this, request.Step, request.Merges);
    const bool exists = piece >= 0 && piece < pieces;
    if (exists)
    {
      const std::size_t begin = chunks.size() * static_cast<std::size_t>(piece) / pieces;
      const std::size_t end = chunks.size() * (static_cast<std::size_t>(piece) + 1) / pieces;
      request.Chunks.assign(chunks.begin() + static_cast<std::ptrdiff_t>(begin),
        chunks.begin() + static_cast<std::ptrdiff_t>(end));
    }
    for (std::uint32_t array = 0; array < self.File->GetArrays().size(); ++array)
    {
      if (self.Wants(self.File->GetArrays()[array]))
      {
        request.Arrays.push_back(array);
      }
    }
    if (self.File->GetNumberOfSteps() == 0)
    {
      // Arrays without any values.
      request.Arrays.clear();
    }
    if (self.IsOnDemand(*this))
    {
      self.MakeOutline(request, piece != 0, output);
    }
    else
    {
      if (pieces > 1)
      {
        request.GhostLevels = static_cast<unsigned>(
          std::max(0, vtkStreamingDemandDrivenPipeline::GetUpdateGhostLevel(outInfo)));
      }
      if (request.GhostLevels > 0 && chunks.size() < self.GetUsed().GetChunks().size())
      {
        request.Universe = chunks;
      }
      request.WithUnusedPoints = exists && piece == 0 && !this->UseBox && !this->UseValueRange;
      request.RestoreOrder = this->RestoreOrder;

      self.Read(request, this->GenerateGlobalIds || pieces > 1, output,
        [this](double fraction)
        {
          this->UpdateProgress(fraction);
          return !gatun::IsAborted(this);
        });
    }
    if (self.File->HasTime() && request.Step < self.File->GetTimes().size())
    {
      output->GetInformation()->Set(
        vtkDataObject::DATA_TIME_STEP(), self.File->GetTimes()[request.Step]);
    }
    this->UpdateProgress(1);
  }
  catch (...)
  {
    this->Fail(outputVector);
    // An aborted update is none; the next one starts anew.
    self.ReadAgain = true;
    return this->GetErrorCode() == vtkGatunErrorCode::AbortedError ? 1 : 0;
  }
  return 1;
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
