// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunStatistics.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkTypeUInt64Array.h"

namespace
{
template <typename Array, typename Value>
void AddColumn(vtkTable* table, const char* name, Value value)
{
  vtkNew<Array> column;
  column->SetName(name);
  column->InsertNextValue(value);
  table->AddColumn(column);
}
}

namespace gatun
{
//------------------------------------------------------------------------------
Statistics::Statistics()
{
  this->Clear();
}

Statistics::~Statistics() = default;

//------------------------------------------------------------------------------
void Statistics::Clear()
{
  this->Table = vtkSmartPointer<vtkTable>::New();
}

//------------------------------------------------------------------------------
void Statistics::Add(const char* name, std::uint64_t value)
{
  AddColumn<vtkTypeUInt64Array>(this->Table, name, value);
}

//------------------------------------------------------------------------------
void Statistics::Add(const char* name, double value)
{
  AddColumn<vtkDoubleArray>(this->Table, name, value);
}

//------------------------------------------------------------------------------
vtkTable* Statistics::Get() const
{
  return this->Table;
}
}
