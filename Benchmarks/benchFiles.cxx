// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchFiles.h"

#include "benchZstd.h"

#include "gatunCellArrays.h"
#include "gatunFaceStream.h"
#include "vtkGatunReader.h"
#include "vtkGatunWriter.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridWriter.h"

namespace bench
{
namespace
{

/** The same grid with 32-bit ids. */
Grid MakeNarrow(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkCellArray> cells;
  cells->DeepCopy(grid->GetCells());
  if (!cells->ConvertTo32BitStorage())
  {
    throw Failure("the ids do not fit 32 bits");
  }
  auto result = Grid::New();
  result->ShallowCopy(grid);
  gatun::SetCells(result, gatun::GetCellTypes(grid), cells, gatun::GetFaceStream(grid));
  return result;
}

void WriteVtu(const Format& format, vtkUnstructuredGrid* grid, const std::string& file)
{
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  if (format.Name.starts_with("vtu-zlib"))
  {
    writer->SetCompressorTypeToZLib();
  }
  else if (format.Name == "vtu-lz4")
  {
    writer->SetCompressorTypeToLZ4();
  }
  else if (format.Name.starts_with("vtu-lzma"))
  {
    writer->SetCompressorTypeToLZMA();
  }
  else
  {
    writer->SetCompressorTypeToNone();
  }
  if (format.Name.ends_with("-best"))
  {
    writer->SetInputData(MakeNarrow(grid));
    writer->SetIdTypeToInt32();
    writer->SetBlockSize(std::size_t{ 1 } << 25);
    writer->SetCompressionLevel(9);
  }
  else
  {
    writer->SetInputData(grid);
  }
  if (!writer->Write())
  {
    throw Failure(file, "cannot be written");
  }
}

template <typename Reader>
Grid LoadWith(const std::string& file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0 || reader->GetOutput()->GetNumberOfCells() == 0)
  {
    throw Failure(file, "cannot be read, or is empty");
  }
  return reader->GetOutput();
}

} // anonymous namespace

//------------------------------------------------------------------------------
const std::vector<Format>& GetFormats()
{
  static const std::vector<Format> formats{ { "gtn" }, { "gtn-small" }, { "vtu-raw" },
    { "vtu-lz4" }, { "vtu-zlib" }, { "vtu-lzma-best" }, { "zstd" }, { "zstd-shuffle" } };
  return formats;
}

//------------------------------------------------------------------------------
void Write(const Format& format, vtkUnstructuredGrid* grid, const std::string& file)
{
  if (format.Name.starts_with("zstd"))
  {
    WriteZstd(grid, file, format.Name == "zstd-shuffle");
    return;
  }
  if (!format.IsGatun())
  {
    WriteVtu(format, grid, file);
    return;
  }
  vtkNew<vtkGatunWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(grid);
  writer->SetProfile(
    format.Name == "gtn-small" ? vtkGatunWriter::PROFILE_SMALL : vtkGatunWriter::PROFILE_FAST);
  if (!writer->Write())
  {
    throw Failure(file, "cannot be written");
  }
}

//------------------------------------------------------------------------------
Grid Load(const std::string& file)
{
  if (file.ends_with(".zst"))
  {
    return LoadZstd(file);
  }
  return file.ends_with(".gtn") ? LoadWith<vtkGatunReader>(file)
                                : LoadWith<vtkXMLUnstructuredGridReader>(file);
}
}
