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

#include <fmt/core.h>

#include <cstddef>

namespace gtn
{
namespace
{

void WriteXMLGrid(
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

void WriteLegacyGrid(vtkUnstructuredGrid* grid, const std::string& file, Progress& progress)
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

std::string EscapeXML(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  }
  return escaped;
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
void WriteCollection(
  const std::string& file, const std::vector<std::string>& parts, const std::vector<double>& times)
{
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n"
                     "  <Collection>\n";
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    text += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n",
      DescribeNumber(times[i]), EscapeXML(FileOf(parts[i])));
  }
  text += "  </Collection>\n</VTKFile>\n";
  TemporaryFile temporary(file);
  WriteBytes(temporary.GetName(), text);
  temporary.Commit();
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
      WriteLegacyGrid(grid, temporary.GetName(), progress);
    }
    else
    {
      WriteXMLGrid(grid, temporary.GetName(), compressor, progress);
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
