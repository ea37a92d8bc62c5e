// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunMeshReader.h"

#include "gatunErrorCodes.h"
#include "gatunExactGhosts.h"
#include "gatunFileConsumer.h"
#include "gatunFileReader.h"
#include "gatunReport.h"
#include "vtkGatunCompat.h"
#include "vtkGatunErrorCode.h"
#include "vtkGatunFileHandle.h"
#include "vtkGatunMeshReaderInternals.h"

#include "vtkDataArraySelection.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

static_assert(sizeof(vtkIdType) == sizeof(std::int64_t), "Gatun needs a VTK with 64-bit ids.");

vtkInformationKeyRestrictedMacro(vtkGatunMeshReader, CHUNK_TABLE, ObjectBase, "vtkTable");
vtkInformationKeyMacro(vtkGatunMeshReader, ON_DEMAND, Integer);

//------------------------------------------------------------------------------
vtkGatunMeshReader::vtkGatunMeshReader()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(1);
}

//------------------------------------------------------------------------------
vtkGatunMeshReader::~vtkGatunMeshReader()
{
  this->SetFileName(nullptr);
  this->SetValueRangeArray(nullptr);
}

//------------------------------------------------------------------------------
void vtkGatunMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "RestoreOrder: " << (this->RestoreOrder ? "On" : "Off") << "\n";
  os << indent << "GenerateGlobalIds: " << (this->GenerateGlobalIds ? "On" : "Off") << "\n";
  os << indent << "Box: " << this->Box[0] << " " << this->Box[1] << " " << this->Box[2] << " "
     << this->Box[3] << " " << this->Box[4] << " " << this->Box[5] << "\n";
  os << indent << "ValueRangeArray: " << (this->ValueRangeArray ? this->ValueRangeArray : "(none)")
     << "\n";
  os << indent << "ValueRange: " << this->ValueRange[0] << " " << this->ValueRange[1] << "\n";
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
  os << indent << "PrefetchTimeSteps: " << (this->PrefetchTimeSteps ? "On" : "Off") << "\n";
  os << indent << "LargeMesh: " << this->LargeMesh << "\n";
  vtkInternals::GetProperties(*this).Print(os, indent);
  os << indent << "HasHierarchy: " << (this->GetHasHierarchy() ? "true" : "false") << "\n";
  os << indent << "IsOnDemand: " << (this->GetIsOnDemand() ? "true" : "false") << "\n";
  os << indent << "Statistics:\n";
  this->GetStatistics()->PrintSelf(os, indent.GetNextIndent());
  os << indent << "PointDataArraySelection:\n";
  this->GetPointDataArraySelection()->PrintSelf(os, indent.GetNextIndent());
  os << indent << "CellDataArraySelection:\n";
  this->GetCellDataArraySelection()->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
vtkTypeBool vtkGatunMeshReader::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    return this->RequestData(request, inputVector, outputVector);
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    return this->RequestInformation(request, inputVector, outputVector);
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkGatunMeshReader::GetPointDataArraySelection()
{
  return this->Internals->PointArrays.Selection;
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkGatunMeshReader::GetCellDataArraySelection()
{
  return this->Internals->CellArrays.Selection;
}

//------------------------------------------------------------------------------
int vtkGatunMeshReader::GetNumberOfPointArrays()
{
  return this->GetPointDataArraySelection()->GetNumberOfArrays();
}

//------------------------------------------------------------------------------
const char* vtkGatunMeshReader::GetPointArrayName(int index)
{
  return this->GetPointDataArraySelection()->GetArrayName(index);
}

//------------------------------------------------------------------------------
int vtkGatunMeshReader::GetPointArrayStatus(const char* name)
{
  return this->GetPointDataArraySelection()->ArrayIsEnabled(name);
}

//------------------------------------------------------------------------------
void vtkGatunMeshReader::SetPointArrayStatus(const char* name, int status)
{
  this->GetPointDataArraySelection()->SetArraySetting(name, status);
}

//------------------------------------------------------------------------------
int vtkGatunMeshReader::GetNumberOfCellArrays()
{
  return this->GetCellDataArraySelection()->GetNumberOfArrays();
}

//------------------------------------------------------------------------------
const char* vtkGatunMeshReader::GetCellArrayName(int index)
{
  return this->GetCellDataArraySelection()->GetArrayName(index);
}

//------------------------------------------------------------------------------
int vtkGatunMeshReader::GetCellArrayStatus(const char* name)
{
  return this->GetCellDataArraySelection()->ArrayIsEnabled(name);
}

//------------------------------------------------------------------------------
void vtkGatunMeshReader::SetCellArrayStatus(const char* name, int status)
{
  this->GetCellDataArraySelection()->SetArraySetting(name, status);
}

//------------------------------------------------------------------------------
vtkTable* vtkGatunMeshReader::GetChunkTable()
{
  try
  {
    return this->Internals->GetTable();
  }
  catch (...)
  {
    const gatun::VTKFailure failure = gatun::DescribeFailure(this->FileName);
    this->SetErrorCode(failure.Code);
    gatun::ReportFailure(this, failure, nullptr);
    return nullptr;
  }
}

//------------------------------------------------------------------------------
vtkTable* vtkGatunMeshReader::GetStatistics()
{
  vtkInternals& self = *this->Internals;
  self.Statistics.Clear();
  self.Statistics.Add("BytesRead", self.Series ? self.Series->GetBytesRead() : std::uint64_t{ 0 });
  self.Statistics.Add("DecodedChunks", self.Pieces.GetDecodedChunks());
  self.Statistics.Add(
    "CachedBytes", self.File ? self.File->GetBudget()->GetStatistics().Bytes : std::uint64_t{ 0 });
  return self.Statistics.Get();
}

//------------------------------------------------------------------------------
// The output does not depend on it, so this is no modification.
void vtkGatunMeshReader::SetMemoryBudget(int mebibytes)
{
  this->MemoryBudget = std::max(0, mebibytes);
  if (const auto& file = this->Internals->File)
  {
    file->GetBudget()->SetBytes(vtkInternals::GetBudget(*this));
  }
}

//------------------------------------------------------------------------------
// The output does not depend on it, so this is no modification.
void vtkGatunMeshReader::SetPrefetchTimeSteps(bool prefetch)
{
  this->PrefetchTimeSteps = prefetch;
  if (!prefetch)
  {
    this->Internals->Prefetcher.Stop();
  }
}

//------------------------------------------------------------------------------
bool vtkGatunMeshReader::GetIsOnDemand()
{
  try
  {
    vtkInternals& self = *this->Internals;
    return self.File && self.GetSettings(*this).IsOnDemand(*self.File);
  }
  catch (...)
  {
    return false; // the update reports what is wrong
  }
}

//------------------------------------------------------------------------------
bool vtkGatunMeshReader::GetHasHierarchy()
{
  return this->Internals->File && this->Internals->GetFile().HasMergeTree();
}

//------------------------------------------------------------------------------
vtkMTimeType vtkGatunMeshReader::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->GetPointDataArraySelection()->GetMTime(),
    this->GetCellDataArraySelection()->GetMTime() });
}

//------------------------------------------------------------------------------
int vtkGatunMeshReader::ComputePipelineMTime(vtkInformation* vtkNotUsed(request),
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
// Within a catch block: consumers get the reason why there is no file.
void vtkGatunMeshReader::PublishFailure(vtkInformation* outInfo) noexcept
{
  try
  {
    gatun::PublishedFile contents;
    contents.Path = this->FileName;
    contents.Failure = std::current_exception();
    contents.Reason = gatun::DescribeFailure(this->FileName).Message;
    vtkNew<vtkGatunFileHandle> handle;
    handle->SetContents(std::move(contents));
    outInfo->Set(vtkGatunFileHandle::FILE_HANDLE(), handle);
  }
  catch (const std::bad_alloc&)
  {
    // Without a handle, consumers use the output.
  }
}

//------------------------------------------------------------------------------
// Within a catch block: reports, and leaves nothing of what was read before. What was thrown ends
// here, and nothing else may be thrown if memory has run out: so that is freed first.
void vtkGatunMeshReader::Fail(vtkInformationVector* outputVector) noexcept
{
  this->Internals->Cells = {};
  this->Internals->Pieces.ForgetMesh();
  const gatun::VTKFailure failure =
    gatun::DescribeFailure(this->FileName ? this->FileName : "(no file)");
  if (!failure.Aborted)
  {
    this->Internals->Pieces.ClearCache();
  }
  this->SetErrorCode(failure.Code);
  auto* output = vtkDataObject::GetData(outputVector->GetInformationObject(0));
  if (output)
  {
    output->GetInformation()->Remove(ON_DEMAND());
  }
  gatun::ReportFailure(this, failure, output);
}

//------------------------------------------------------------------------------
int vtkGatunMeshReader::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInternals& self = *this->Internals;
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  outInfo->Remove(CHUNK_TABLE());
  outInfo->Remove(vtkGatunFileHandle::FILE_HANDLE());
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
    self.Open(*this);
    self.TryMesh(outInfo);
    outInfo->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
    outInfo->Set(gatun::ExactGhostLevels(), 1);
    self.PublishTable(outInfo);
    self.Publish(*this, outInfo);
    const gatun::FileReader& file = self.GetFile();
    const std::vector<double> times = self.Series->GetFile()->GetSeriesTimes();
    if (!times.empty())
    {
      const double range[2] = { times.front(), times.back() };
      outInfo->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(),
        static_cast<int>(times.size()));
      outInfo->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    }
    gatun::Bounds box = file.GetBounds(); // at any time
    for (std::size_t step = 1; file.HasMovingPoints() && step < file.GetNumberOfSteps(); ++step)
    {
      box.Include(file.GetBounds(step));
    }
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
    this->PublishFailure(outInfo);
    this->Fail(outputVector);
    return 0;
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunMeshReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInternals& self = *this->Internals;
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkDataObject* output = vtkDataObject::GetData(outInfo);
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
    self.Prefetcher.Stop(); // what it has decoded is in the cache
    output->Initialize();
    output->GetInformation()->Remove(ON_DEMAND());
    this->UpdateProgress(0);
    if (!self.IsOpen(this->FileName))
    {
      self.Open(*this);
    }
    self.UseMesh(outInfo);
    // Again, as a reader of file series may have changed to another file since, and as the mesh may
    // be another one.
    self.Publish(*this, outInfo);
    self.PublishTable(outInfo);
    const gatun::PublishedFile handle = *gatun::GetPublishedFile(outInfo);
    if (handle.Failure)
    {
      std::rethrow_exception(handle.Failure);
    }
    const gatun::PortRequest port(self.GetFile(), outInfo);
    vtkSmartPointer<vtkUnstructuredGrid> grid = vtkUnstructuredGrid::SafeDownCast(output);
    if (!grid)
    {
      grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    }
    const auto progress = [this](double fraction)
    {
      this->UpdateProgress(fraction);
      return !gatun::IsAborted(this);
    };
    const auto ofBoundary =
      handle.OnDemand ? self.FindBoundaryMerges(handle) : std::optional<std::size_t>();
    if (ofBoundary)
    {
      self.ReadBoundary(handle, *ofBoundary, port, grid, progress);
    }
    else if (handle.OnDemand)
    {
      self.MakeOutline(handle, port, grid);
    }
    else
    {
      self.Pieces.Choose(handle, handle.Merges);
      auto request = self.Pieces.MakeRequest(handle, port, self.ChunksOf(*this, port.Step));
      request.WithUnusedPoints = request.WithUnusedPoints && !self.HasRegion(*this);
      self.Pieces.Read(handle, request, this->GenerateGlobalIds || port.Pieces > 1, grid, progress);
      if (this->PrefetchTimeSteps)
      {
        self.Prefetcher.Start(self.Pieces.GetCache(), request);
      }
    }
    if (grid != output)
    {
      self.MakeSurface(grid, vtkPolyData::SafeDownCast(output));
    }
    if (handle.OnDemand)
    {
      output->GetInformation()->Set(
        ON_DEMAND(), ofBoundary ? ON_DEMAND_BOUNDARY : ON_DEMAND_OUTLINE);
    }
    gatun::SetStepTime(self.GetFile(), port.Step, output);
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
