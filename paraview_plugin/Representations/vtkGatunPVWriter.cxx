// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunPVWriter.h"

#include "gatunErrorBound.h"
#include "vtkGatunReader.h"
#include "vtkGatunSurfaceReader.h"

#include "vtkAlgorithm.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <filesystem>
#include <system_error>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunPVWriter);

//------------------------------------------------------------------------------
vtkGatunPVWriter::vtkGatunPVWriter()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkGatunPVWriter::~vtkGatunPVWriter() = default;

//------------------------------------------------------------------------------
void vtkGatunPVWriter::SetLayerArray(const char* name)
{
  const char* const array = name && std::strcmp(name, "(none)") == 0 ? nullptr : name;
  this->SetLayers(array, this->LayerComponent, this->NumberOfLayers, this->LayerSpacing);
}

//------------------------------------------------------------------------------
void vtkGatunPVWriter::SetLayerComponent(int component)
{
  this->SetLayers(this->GetLayerArray(), component, this->NumberOfLayers, this->LayerSpacing);
}

//------------------------------------------------------------------------------
void vtkGatunPVWriter::SetNumberOfLayers(int number)
{
  this->SetLayers(this->GetLayerArray(), this->LayerComponent, number, this->LayerSpacing);
}

//------------------------------------------------------------------------------
void vtkGatunPVWriter::SetLayerSpacing(int spacing)
{
  this->SetLayers(this->GetLayerArray(), this->LayerComponent, this->NumberOfLayers, spacing);
}

//------------------------------------------------------------------------------
void vtkGatunPVWriter::AddArrayToleranceText(const char* text)
{
  if (!text || !*text)
  {
    return;
  }
  try
  {
    const gatun::ArrayError error = gatun::ParseError(text);
    this->SetArrayTolerance(error.Array.c_str(), static_cast<int>(error.Bound.Kind),
      error.Bound.Bound, error.Bound.KeepZeros);
  }
  catch (const std::exception& e)
  {
    vtkErrorMacro(<< e.what());
  }
}

//------------------------------------------------------------------------------
void vtkGatunPVWriter::SetPointToleranceText(const char* text)
{
  const std::string given = text && std::strcmp(text, "none") != 0 ? text : "";
  const auto bound = gatun::ParseBound(given);
  if (!given.empty() && (!bound || bound->KeepZeros))
  {
    vtkErrorMacro(<< "the tolerance of coordinates '" << given
                  << "' is none of abs:E, rel:E and bits:N");
    return;
  }
  this->PointToleranceText = given;
  this->SetPointTolerance(
    bound ? static_cast<int>(bound->Kind) : int{ TOLERANCE_NONE }, bound ? bound->Bound : 0);
}

//------------------------------------------------------------------------------
int vtkGatunPVWriter::Write()
{
  const bool hasName = this->FileName && *this->FileName;
  if (!hasName || this->GetNumberOfInputConnections(0) < 1)
  {
    return this->Superclass::Write(); // which reports the error
  }
  try
  {
    const std::string name = this->FileName;
    const bool isSeries = this->WriteTimeSteps && !this->WriteAllTimeSteps;
    const int written = isSeries ? this->WriteSeries(name) : this->WriteFile();
    this->SetFileName(name.c_str());
    return written;
  }
  catch (const std::exception& e)
  {
    this->SetErrorCode(vtkErrorCode::UnknownError);
    vtkErrorMacro(<< e.what());
    return 0;
  }
}

//------------------------------------------------------------------------------
int vtkGatunPVWriter::WriteFile()
{
  const bool needsWhole = this->Hierarchy || this->WriteBoundary || this->GetLayerArray();
  return needsWhole && this->Controller && this->Controller->GetNumberOfProcesses() > 1
    ? this->WriteWhole(this->FileName)
    : this->Superclass::Write();
}

//------------------------------------------------------------------------------
// All processes write a file without a hierarchy, a boundary and layers, from which the first one
// makes the file that is wanted.
int vtkGatunPVWriter::WriteWhole(const std::string& name)
{
  const std::string parts = name + ".parts";
  const std::string layers = this->LayerArray;
  const int hierarchy = this->Hierarchy;
  const bool hasBoundary = this->WriteBoundary;
  const int order = this->KeepOrder;
  this->SetKeepOrder(KEEP_ALL); // the order of merges is that of one process
  this->SetHierarchy(HIERARCHY_OFF);
  this->SetWriteBoundary(false);
  this->SetLayerArray(nullptr);
  this->SetFileName(parts.c_str());
  int succeeded = this->Superclass::Write();
  this->SetKeepOrder(order);
  this->SetHierarchy(hierarchy);
  this->SetWriteBoundary(hasBoundary);
  this->SetLayerArray(layers.c_str());
  if (!succeeded)
  {
    return 0; // in all processes
  }
  const bool isFirst = this->Controller->GetLocalProcessId() == 0;
  if (isFirst)
  {
    vtkNew<vtkGatunReader> ofGrids;
    vtkNew<vtkGatunSurfaceReader> ofSurfaces;
    vtkGatunMeshReader* reader = ofSurfaces;
    if (!reader->CanReadFile(parts.c_str()))
    {
      reader = ofGrids;
    }
    reader->SetFileName(parts.c_str());
    vtkNew<vtkGatunWriter> writer;
    writer->SetInputConnection(reader->GetOutputPort());
    writer->SetFileName(name.c_str());
    writer->SetKeepOrder(order);
    writer->SetChunkSize(this->ChunkSize);
    writer->SetKeyStepInterval(this->KeyStepInterval);
    writer->SetHierarchy(hierarchy);
    writer->SetProfile(this->Profile);
    writer->SetLevels(this->Levels);
    writer->SetWriteBoundary(hasBoundary);
    writer->SetLayers(
      layers.c_str(), this->LayerComponent, this->NumberOfLayers, this->LayerSpacing);
    writer->SetWriteAllTimeSteps(true); // those of the file
    succeeded = writer->Write();
    this->SetErrorCode(writer->GetErrorCode());
    std::error_code ignored;
    std::filesystem::remove(parts, ignored);
  }
  this->Controller->Broadcast(&succeeded, 1, 0);
  if (!succeeded && !isFirst)
  {
    this->SetErrorCode(vtkErrorCode::UnknownError);
    vtkErrorMacro(<< name << ": the first process cannot write the file");
  }
  return succeeded;
}

//------------------------------------------------------------------------------
int vtkGatunPVWriter::WriteSeries(const std::string& name)
{
  this->UpdateInformation();
  vtkInformation* const info = this->GetInputInformation(0, 0);
  auto* const key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  if (!info->Has(key))
  {
    return this->WriteFile();
  }
  const std::vector<double> times(info->Get(key), info->Get(key) + info->Length(key));
  const auto count = static_cast<int>(times.size());
  const int last =
    this->MaxTimeStep < this->MinTimeStep ? count - 1 : std::min(this->MaxTimeStep, count - 1);
  const std::filesystem::path path(name);
  for (std::int64_t step = this->MinTimeStep; step <= last; step += this->TimeStepStride)
  {
    auto file = path;
    file.replace_filename(
      path.stem().string() + "_" + std::to_string(step) + path.extension().string());
    this->SetFileName(file.string().c_str());
    info->Set(
      vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), times[static_cast<std::size_t>(step)]);
    if (!this->WriteFile())
    {
      return 0; // in all processes
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkGatunPVWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WriteTimeSteps: " << (this->WriteTimeSteps ? "On" : "Off") << "\n";
  os << indent << "MinTimeStep: " << this->MinTimeStep << "\n";
  os << indent << "MaxTimeStep: " << this->MaxTimeStep << "\n";
  os << indent << "TimeStepStride: " << this->TimeStepStride << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
