// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunWriter.h"

#include "gatunArrayBridge.h"
#include "gatunBridgedMesh.h"
#include "gatunError.h"
#include "gatunErrorBound.h"
#include "gatunErrorCodes.h"
#include "gatunProcessExchange.h"
#include "gatunReport.h"
#include "gatunWriterArrays.h"
#include "vtkGatunCompat.h"
#include "vtkGatunErrorCode.h"
#include "vtkGatunWriterInternals.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArraySelection.h"
#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

//------------------------------------------------------------------------------
vtkStandardNewMacro(vtkGatunWriter);

//------------------------------------------------------------------------------
vtkInformationKeyMacro(vtkGatunWriter, JOIN_POINTS, Integer);

//------------------------------------------------------------------------------
vtkGatunWriter::vtkGatunWriter()
  : Internals(std::make_unique<vtkInternals>(this))
{
}

//------------------------------------------------------------------------------
vtkGatunWriter::~vtkGatunWriter()
{
  this->SetFileName(nullptr);
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
void vtkGatunWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "KeepOrder: " << this->KeepOrder << "\n";
  os << indent << "ChunkSize: " << this->ChunkSize << "\n";
  os << indent << "KeyStepInterval: " << this->KeyStepInterval << "\n";
  os << indent << "ArrayTolerances:";
  for (const gatun::ArrayError& error : this->Internals->Tolerances)
  {
    os << " " << error.Array << "=" << gatun::ToString(error.Bound);
  }
  os << "\n" << indent << "Profile: " << (this->Profile == PROFILE_FAST ? "Fast" : "Small") << "\n";
  os << indent << "Hierarchy: " << this->Hierarchy << "\n";
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "WriteBoundary: " << (this->WriteBoundary ? "On" : "Off") << "\n";
  this->Internals->Weights.Print(os, indent);
  os << indent << "LayerArray: " << (this->LayerArray.empty() ? "(none)" : this->LayerArray)
     << "\n";
  os << indent << "LayerComponent: " << this->LayerComponent << "\n";
  os << indent << "NumberOfLayers: " << this->NumberOfLayers << "\n";
  os << indent << "LayerSpacing: " << this->LayerSpacing << "\n";
  os << indent << "WriteAllTimeSteps: " << (this->WriteAllTimeSteps ? "On" : "Off") << "\n";
  os << indent << "Append: " << (this->Append ? "On" : "Off") << "\n";
  os << indent << "FillMissingArrays: " << (this->FillMissingArrays ? "On" : "Off") << "\n";
  os << indent << "SplitCells: " << (this->SplitCells ? "On" : "Off") << "\n";
  os << indent << "PointToleranceKind: " << this->PointToleranceKind << "\n";
  os << indent << "PointTolerance: " << this->PointTolerance << "\n";
  os << indent << "NumberOfPieces: " << this->NumberOfPieces << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "Statistics:\n";
  this->GetStatistics()->PrintSelf(os, indent.GetNextIndent());
  os << indent << "PointDataArraySelection:\n";
  this->GetPointDataArraySelection()->PrintSelf(os, indent.GetNextIndent());
  os << indent << "CellDataArraySelection:\n";
  this->GetCellDataArraySelection()->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkGatunWriter::GetPointDataArraySelection()
{
  return this->Internals->PointSelection;
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkGatunWriter::GetCellDataArraySelection()
{
  return this->Internals->CellSelection;
}

//------------------------------------------------------------------------------
void vtkGatunWriter::SetChunkSize(int cells)
{
  const int clamped = cells <= 0 ? 0 : std::clamp(cells, 64, 1048576);
  if (this->ChunkSize != clamped)
  {
    this->ChunkSize = clamped;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGatunWriter::SetArrayTolerance(const char* name, int kind, double value, bool keepZeros)
{
  if (!name)
  {
    vtkErrorMacro("A tolerance needs the name of an array, or \"*\".");
    return;
  }
  auto& all = this->Internals->Tolerances;
  std::erase_if(all, [name](const gatun::ArrayError& error) { return error.Array == name; });
  if (kind != TOLERANCE_NONE)
  {
    all.push_back({ name, { vtkInternals::ToErrorKind(kind), value, keepZeros } });
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkGatunWriter::ClearArrayTolerances()
{
  if (!this->Internals->Tolerances.empty())
  {
    this->Internals->Tolerances.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGatunWriter::SetPointTolerance(int kind, double value)
{
  if (this->PointToleranceKind != kind || this->PointTolerance != value)
  {
    this->PointToleranceKind = kind;
    this->PointTolerance = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGatunWriter::SetLayers(const char* array, int component, int number, int spacing)
{
  constexpr int mostComponents = 65535;
  constexpr int mostLayers = 4096;
  const std::string name = array ? array : "";
  component = std::clamp(component, -1, mostComponents);
  number = std::clamp(number, 0, mostLayers);
  spacing = std::clamp<int>(spacing, LAYERS_UNIFORM, LAYERS_HISTOGRAM);
  if (std::tie(name, component, number, spacing) !=
    std::tie(this->LayerArray, this->LayerComponent, this->NumberOfLayers, this->LayerSpacing))
  {
    this->LayerArray = name;
    this->LayerComponent = component;
    this->NumberOfLayers = number;
    this->LayerSpacing = spacing;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTable* vtkGatunWriter::GetStatistics()
{
  return this->Internals->Statistics.Get();
}

//------------------------------------------------------------------------------
vtkCxxSetObjectMacro(vtkGatunWriter, Controller, vtkMultiProcessController);

//------------------------------------------------------------------------------
void vtkGatunWriter::SetArrayWeight(const char* name, double weight)
{
  if (this->Internals->Weights.Set(name, weight))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkGatunWriter::GetArrayWeight(const char* name)
{
  return this->Internals->Weights.Get(name);
}

//------------------------------------------------------------------------------
void vtkGatunWriter::ClearArrayWeights()
{
  if (this->Internals->Weights.Clear())
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkGatunWriter::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkGatunWriter::Write()
{
  vtkInternals& self = *this->Internals;
  if (this->GetNumberOfInputConnections(0) < 1)
  {
    this->SetErrorCode(vtkGatunErrorCode::InvalidInputError);
    vtkErrorMacro("No input was set.");
    return 0;
  }
  self.Discard();
  self.BytesSent = 0;
  self.JoinedPoints = 0;
  self.PointError = 0;
  self.Writing = true;
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    if (this->Controller && this->Controller->GetNumberOfProcesses() > 1)
    {
      this->WriteTogether();
    }
    else if (!(this->NumberOfPieces > 1 ? this->WritePieces() : this->WriteSteps()) &&
      this->GetErrorCode() == vtkErrorCode::NoError)
    {
      throw std::runtime_error("not written, as the input could not be updated");
    }
  }
  catch (...)
  {
    // This includes exceptions of VTK and of upstream algorithms.
    this->HandleFailure();
  }
  self.Discard();
  self.Times.clear();
  self.Writing = false;
  return this->GetErrorCode() == vtkErrorCode::NoError ? 1 : 0;
}

//------------------------------------------------------------------------------
// Updates the input for each time step. The pipeline could continue by itself (CONTINUE_EXECUTING),
// but would never stop if the input fails. Returns whether the file is complete.
bool vtkGatunWriter::WriteSteps()
{
  vtkInternals& self = *this->Internals;
  for (;;)
  {
    const std::size_t step = self.Step;
    this->Modified();
    this->UpdateWholeExtent();
    const bool isRestarted = std::exchange(self.IsRestarted, false); // once only
    if (self.Step <= step && !isRestarted)
    {
      return false; // after a failure it is 0 again
    }
    if (self.Step >= self.Times.size())
    {
      return true;
    }
  }
}

//------------------------------------------------------------------------------
// Updates the input for each piece and time step, twice. Returns whether the file is complete.
bool vtkGatunWriter::WritePieces()
{
  vtkInternals& self = *this->Internals;
  self.BeginPieces(this->NumberOfPieces);
  for (const bool surveying : { true, false })
  {
    self.Surveying = surveying;
    for (int piece = 0; piece < this->NumberOfPieces; ++piece)
    {
      self.Piece = piece;
      self.Step = 0;
      for (std::size_t step = 0; step < self.GetNumberOfSteps(); ++step)
      {
        this->Modified();
        this->UpdateWholeExtent();
        if (!self.Pieces || self.Step != step + 1)
        {
          return false; // after a failure
        }
      }
    }
  }
  self.FinishPieces(nullptr);
  this->WriteTime.Modified();
  this->UpdateProgress(1);
  return true;
}

//------------------------------------------------------------------------------
// Writes the piece of this process together with those of the others. What may fail in one process
// runs in PartExchange::Together, so that all fail.
void vtkGatunWriter::WriteTogether()
{
  vtkInternals& self = *this->Internals;
  gatun::ProcessExchange exchange(this->Controller);
  exchange.Together(
    [&]
    {
      if (!this->FileName || !*this->FileName)
      {
        gatun::ThrowInvalid("no FileName was set");
      }
      self.IsTogether = true;
      self.BeginPieces(exchange.GetProcesses());
      self.Piece = exchange.GetProcess();
    });
  for (const bool surveying : { true, false })
  {
    self.Surveying = surveying;
    self.Step = 0;
    for (std::size_t step = 0; step < self.GetNumberOfSteps(); ++step)
    {
      exchange.Together(
        [&]
        {
          self.Input = nullptr;
          this->Modified();
          this->UpdateWholeExtent();
          if (!self.Input)
          {
            gatun::ThrowInvalid("the input could not be updated");
          }
        });
      vtkSmartPointer<vtkDataObject> input = self.Input;
      if (surveying && step == 0)
      {
        vtkSmartPointer<vtkUnstructuredGrid> grid;
        exchange.Together([&] { grid = self.MakeGrid(input); });
        const bool isSurface = *self.IsSurface;
        const bool isAnySurface = exchange.IsAny(isSurface);
        if (exchange.IsAny(isSurface != isAnySurface))
        {
          gatun::ThrowInvalid("some processes have a surface, and some have not");
        }
        self.Pieces->SetIsSurface(isSurface);
        self.Pieces->OpenTogether(exchange, grid, self.GetNumberOfSteps());
      }
      exchange.Together([&] { this->WritePiece(input); });
    }
    if (surveying)
    {
      self.Pieces->EndSurvey();
    }
  }
  self.FinishPieces(&exchange);
  this->WriteTime.Modified();
  this->UpdateProgress(1);
}

//------------------------------------------------------------------------------
// To be called in a catch block. Reports the error and discards the file. Returns whether the error
// is an abort.
bool vtkGatunWriter::HandleFailure() noexcept
{
  this->Internals->Discard();
  this->SetErrorCode(vtkErrorCode::UnknownError);
  try
  {
    const gatun::VTKFailure failure =
      gatun::DescribeFailure(this->FileName ? this->FileName : "(no file)");
    this->SetErrorCode(failure.Code);
    gatun::ReportFailure(this, failure, nullptr);
    return failure.Aborted;
  }
  catch (...)
  {
    return false; // there is no memory for the message
  }
}

//------------------------------------------------------------------------------
VTK_GATUN_UPDATE_RESULT vtkGatunWriter::Update()
{
  return static_cast<VTK_GATUN_UPDATE_RESULT>(this->Write());
}

//------------------------------------------------------------------------------
VTK_GATUN_UPDATE_RESULT vtkGatunWriter::Update(int vtkNotUsed(port))
{
  return static_cast<VTK_GATUN_UPDATE_RESULT>(this->Write());
}

//------------------------------------------------------------------------------
vtkTypeBool vtkGatunWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInternals& self = *this->Internals;
  vtkInformation* inInfo = inputVector[0]->GetInformationObject(0);
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    if (self.File || self.AreTimesKnown)
    {
      // Between two steps.
      return 1;
    }
    self.Times.clear();
    if (self.Writing && this->WriteAllTimeSteps &&
      inInfo->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()))
    {
      const double* times = inInfo->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
      self.Times.assign(
        times, times + inInfo->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
    }
    return 1;
  }
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_TIME()) ||
    request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    if (self.Step < self.Times.size())
    {
      inInfo->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), self.Times[self.Step]);
    }
    if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
    {
      inInfo->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), self.Piece);
      inInfo->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(),
        self.Pieces ? self.PieceCount : 1);
      inInfo->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkGatunWriter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* vtkNotUsed(outputVector))
{
  vtkInternals& self = *this->Internals;
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->FileName || !*this->FileName)
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("No FileName was set.");
    return 0;
  }
  try
  {
    vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
    if (self.IsTogether)
    {
      self.Input = input;
      self.AreTimesKnown = true;
      return 1;
    }
    if (self.Pieces)
    {
      this->WritePiece(input);
      return 1;
    }
    this->WriteStep(input);
  }
  catch (...)
  {
    return this->HandleFailure() ? 1 : 0;
  }
  if (self.Step >= self.Times.size())
  {
    this->WriteTime.Modified();
    this->UpdateProgress(1);
    if (!self.Writing)
    {
      self.Discard();
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
// Writes the current time step. The first step with a mesh also writes that, the last one completes
// the file.
void vtkGatunWriter::WriteStep(vtkDataObject* input)
{
  vtkInternals& self = *this->Internals;
  const vtkSmartPointer<vtkUnstructuredGrid> grid = self.MakeGrid(input);
  auto mesh = std::make_unique<gatun::BridgedMesh>(grid);
  if (mesh->PointsConverted)
  {
    self.Warn("integer coordinates are written as double");
  }
  std::vector<gatun::BridgedArray> arrays = self.SelectArrays(grid);
  self.BeginAppending();
  if (!self.ArrangeArrays(grid, input, arrays))
  {
    this->UpdateProgress(this->GetProgress());
    if (gatun::IsAborted(this))
    {
      throw gatun::Error(gatun::ErrorCode::Aborted, "aborted");
    }
    if (++self.Step >= self.GetNumberOfSteps())
    {
      self.Restart();
    }
    return;
  }
  std::vector<const void*> values;
  for (const gatun::BridgedArray& array : arrays)
  {
    values.push_back(array.Values);
  }
  if (!self.UseMesh(grid, mesh, arrays))
  {
    self.Restart();
    return;
  }

  const auto step = self.DescribeStep(input, grid->GetFieldData());
  const auto remaining = self.Remaining ? self.Remaining->GetRemaining() : gatun::RemainingCells();
  self.File->WriteStep(values, step.Field, step.HasTime, step.Time,
    self.MakeProgress(self.Step + 1), mesh ? mesh->Mesh.Coordinates : nullptr,
    self.Remaining ? &remaining : nullptr);
  ++self.Step;
  if (self.Step >= self.GetNumberOfSteps())
  {
    const auto statistics = self.File->Finish();
    self.PublishStatistics(statistics, self.Points, self.Cells);
  }
}

//------------------------------------------------------------------------------
// Surveys or writes the current time step of the current piece.
void vtkGatunWriter::WritePiece(vtkDataObject* input)
{
  vtkInternals& self = *this->Internals;
  self.AreTimesKnown = true;
  const vtkSmartPointer<vtkUnstructuredGrid> grid = self.MakeGrid(input);
  const double steps = static_cast<double>(self.GetNumberOfSteps());
  const int pieces = self.IsTogether ? 1 : self.PieceCount; // of this process
  const double all = 2 * steps * pieces;
  const double done = static_cast<double>(self.Step) + (self.IsTogether ? 0 : steps * self.Piece);
  const bool isFirst = self.Step == 0;
  const auto report = [&](double stepsDone)
  {
    this->UpdateProgress(
      self.GetPartOfPieces() * ((self.Surveying ? 0 : 0.5) + (done + stepsDone) / all));
  };
  report(0);
  if (self.Surveying)
  {
    self.Pieces->SetIsSurface(*self.IsSurface);
    self.Pieces->Survey(grid, isFirst);
    report(1);
  }
  else
  {
    self.Pieces->Write(grid, isFirst, self.DescribeStep(input, grid->GetFieldData()),
      [&](double fraction)
      {
        report(fraction);
        return !gatun::IsAborted(this);
      });
    report(1);
  }
  if (gatun::IsAborted(this))
  {
    throw gatun::Error(gatun::ErrorCode::Aborted, "aborted");
  }
  ++self.Step;
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
