// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFilePiece.h"

#include "vtkGatunFileHandle.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMetaReader.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <utility>

namespace gatun
{
namespace
{
constexpr const char* PathName = "GatunDrawnFile";
constexpr const char* TimeName = "GatunDrawnTime";
constexpr const char* MergesName = "GatunDrawnMerges";
constexpr const char* CellsName = "GatunDrawnCells";

void RemoveArrays(vtkFieldData* field)
{
  for (const char* const name : { PathName, TimeName, MergesName, CellsName })
  {
    while (field && field->HasArray(name))
    {
      field->RemoveArray(name);
    }
  }
}

/** The algorithm whose output the input is, unchanged, and the port of that output. */
std::pair<vtkAlgorithm*, int> FindInput(vtkAlgorithm* consumer)
{
  int port = 0;
  if (consumer->GetNumberOfInputConnections(0) != 1)
  {
    return { nullptr, port };
  }
  vtkAlgorithm* input = consumer->GetInputAlgorithm(0, 0, port);
  // ParaView puts it behind every source; it passes on what it gets.
  if (input && input->IsA("vtkPVPostFilter") && input->GetNumberOfInputConnections(0) == 1)
  {
    input = input->GetInputAlgorithm(0, 0, port);
  }
  return { input, port };
}
}

//------------------------------------------------------------------------------
vtkAlgorithm* FindProducer(vtkAlgorithm* consumer)
{
  vtkAlgorithm* const input = FindInput(consumer).first;
  auto* const series = vtkMetaReader::SafeDownCast(input);
  return series ? series->GetReader() : input;
}

//------------------------------------------------------------------------------
vtkInformation* FindSource(vtkAlgorithm* consumer)
{
  const auto [input, port] = FindInput(consumer);
  return input ? input->GetOutputInformation(port) : nullptr;
}

//------------------------------------------------------------------------------
vtkGatunFileHandle* FindHandle(vtkAlgorithm* consumer)
{
  vtkInformation* const source = FindSource(consumer);
  return source ? vtkGatunFileHandle::SafeDownCast(source->Get(vtkGatunFileHandle::FILE_HANDLE()))
                : nullptr;
}

//------------------------------------------------------------------------------
DrawnFile DescribeFile(vtkGatunFileHandle* handle, vtkDataObject* output)
{
  DrawnFile file;
  file.Path = handle->GetFileName();
  file.Merges = handle->GetNumberOfMerges();
  if (output)
  {
    file.Cells = output->GetNumberOfElements(vtkDataObject::CELL);
    if (output->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()))
    {
      file.Time = output->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
    }
  }
  return file;
}

//------------------------------------------------------------------------------
void UnmarkPiece(vtkDataObject* piece)
{
  if (piece)
  {
    RemoveArrays(piece->GetFieldData());
  }
  if (auto* const blocks = vtkCompositeDataSet::SafeDownCast(piece))
  {
    const auto each = vtk::TakeSmartPointer(blocks->NewIterator());
    for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
    {
      UnmarkPiece(each->GetCurrentDataObject());
    }
  }
}

//------------------------------------------------------------------------------
void MarkPiece(vtkDataObject* piece, const DrawnFile& file)
{
  UnmarkPiece(piece);
  vtkNew<vtkStringArray> path;
  path->SetName(PathName);
  path->InsertNextValue(file.Path);
  piece->GetFieldData()->AddArray(path);
  vtkNew<vtkDoubleArray> time;
  time->SetName(TimeName);
  time->InsertNextValue(file.Time);
  piece->GetFieldData()->AddArray(time);
  const auto addNumber = [piece](const char* name, vtkIdType number)
  {
    vtkNew<vtkIdTypeArray> array;
    array->SetName(name);
    array->InsertNextValue(number);
    piece->GetFieldData()->AddArray(array);
  };
  addNumber(MergesName, file.Merges);
  addNumber(CellsName, file.Cells);
}

//------------------------------------------------------------------------------
DrawnFile GetMark(vtkDataObject* piece)
{
  vtkFieldData* const field = piece->GetFieldData();
  auto* const path = vtkStringArray::SafeDownCast(field->GetAbstractArray(PathName));
  auto* const time = vtkDoubleArray::SafeDownCast(field->GetArray(TimeName));
  auto* const merges = vtkIdTypeArray::SafeDownCast(field->GetArray(MergesName));
  auto* const cells = vtkIdTypeArray::SafeDownCast(field->GetArray(CellsName));
  if (!path || path->GetNumberOfValues() < 1 || !time || time->GetNumberOfValues() < 1 || !merges ||
    merges->GetNumberOfValues() < 1 || !cells || cells->GetNumberOfValues() < 1)
  {
    return {};
  }
  return { path->GetValue(0), time->GetValue(0), merges->GetValue(0), cells->GetValue(0) };
}
}
