// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnGridWriter.h"

#include "gtnFailure.h"
#include "gtnMessages.h"
#include "gtnOutput.h"
#include "gtnProgress.h"
#include "gtnText.h"

#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"
#include "vtkXMLWriterBase.h"

namespace gtn
{
namespace
{

void WriteXML(
  vtkUnstructuredGrid* grid, const std::string& file, Compressor compressor, Progress& progress)
{
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  writer->SetFileName(file.c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetHeaderTypeToUInt64();
  SetCompressor(writer, compressor);
  progress.Watch(writer);
  const bool good = writer->Write() != 0;
  CheckInterrupt();
  CheckWritten(writer, good, file);
}

void WriteLegacy(vtkUnstructuredGrid* grid, const std::string& file, Progress& progress)
{
  vtkNew<vtkUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  writer->SetFileName(file.c_str());
  writer->SetFileTypeToBinary();
  progress.Watch(writer);
  const bool good = writer->Write() != 0;
  CheckInterrupt();
  CheckWritten(writer, good, file);
}

} // anonymous namespace

//------------------------------------------------------------------------------
void SetCompressor(vtkXMLWriterBase* writer, Compressor compressor)
{
  switch (compressor)
  {
    case Compressor::None:
      writer->SetCompressorTypeToNone();
      break;
    case Compressor::ZLib:
      writer->SetCompressorTypeToZLib();
      break;
    case Compressor::LZ4:
      writer->SetCompressorTypeToLZ4();
      break;
    case Compressor::LZMA:
      writer->SetCompressorTypeToLZMA();
      break;
  }
}

//------------------------------------------------------------------------------
void WriteGrid(
  vtkUnstructuredGrid* grid, const std::string& file, Compressor compressor, Progress& progress)
{
  TemporaryFile temporary(file);
  try
  {
    if (ExtensionOf(file) == ".vtk")
    {
      WriteLegacy(grid, temporary.GetName(), progress);
    }
    else
    {
      WriteXML(grid, temporary.GetName(), compressor, progress);
    }
  }
  catch (const Failure& failure)
  {
    TakeErrors();
    throw Failure(file, failure.what());
  }
  CheckMessages(file, true);
  temporary.Commit();
}
}
