// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFilePiece.h"

#include "vtkGatunReader.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkMetaReader.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace gatun
{
namespace
{
constexpr const char* PathName = "GatunDrawnFile";
constexpr const char* NumbersName = "GatunDrawnTimeAndSimplification";
}

//------------------------------------------------------------------------------
vtkAlgorithm* FindProducer(vtkAlgorithm* consumer)
{
  if (consumer->GetNumberOfInputConnections(0) != 1)
  {
    return nullptr;
  }
  vtkAlgorithm* input = consumer->GetInputAlgorithm(0, 0);
  // ParaView puts it behind every source; it passes on what it gets.
  if (input && input->IsA("vtkPVPostFilter") && input->GetNumberOfInputConnections(0) == 1)
  {
    input = input->GetInputAlgorithm(0, 0);
  }
  if (auto* const series = vtkMetaReader::SafeDownCast(input))
  {
    input = series->GetReader();
  }
  return input;
}

//------------------------------------------------------------------------------
vtkGatunReader* FindReader(vtkAlgorithm* consumer)
{
  return vtkGatunReader::SafeDownCast(FindProducer(consumer));
}

//------------------------------------------------------------------------------
DrawnFile DescribeFile(vtkGatunReader* reader, vtkDataObject* made)
{
  DrawnFile file;
  file.Path = reader->GetFileName() ? reader->GetFileName() : "";
  if (made && made->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
  {
    file.Time = made->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
  }
  file.Simplification = std::max(0.0, reader->GetSimplification());
  return file;
}

//------------------------------------------------------------------------------
void MarkPiece(vtkUnstructuredGrid* piece, const DrawnFile& file)
{
  vtkNew<vtkStringArray> path;
  path->SetName(PathName);
  path->InsertNextValue(file.Path);
  piece->GetFieldData()->AddArray(path);
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName(NumbersName);
  numbers->InsertNextValue(file.Time);
  numbers->InsertNextValue(file.Simplification);
  piece->GetFieldData()->AddArray(numbers);
}

//------------------------------------------------------------------------------
DrawnFile GetMark(vtkUnstructuredGrid* piece)
{
  vtkFieldData* const field = piece->GetFieldData();
  auto* const path = vtkStringArray::SafeDownCast(field->GetAbstractArray(PathName));
  auto* const numbers = vtkDoubleArray::SafeDownCast(field->GetArray(NumbersName));
  if (!path || !numbers || path->GetNumberOfValues() < 1 || numbers->GetNumberOfValues() < 2)
  {
    return {};
  }
  return { path->GetValue(0), numbers->GetValue(0), numbers->GetValue(1) };
}
}
