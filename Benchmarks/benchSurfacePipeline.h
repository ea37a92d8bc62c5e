// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef benchSurfacePipeline_h
#define benchSurfacePipeline_h

// The reader and the mapper of a surface's file.

#include "vtkGatunSurfaceMapper.h"
#include "vtkGatunSurfaceReader.h"

#include "vtkAlgorithm.h"
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h"
#include "vtkXMLPolyDataReader.h"

#include <string>

namespace bench
{
struct SurfacePipeline
{
  vtkSmartPointer<vtkAlgorithm> Reader;
  vtkSmartPointer<vtkPolyDataMapper> Mapper;

  /** Gatun's mapper; null if VTK's is used. */
  vtkGatunSurfaceMapper* GetOwnMapper() const
  {
    return vtkGatunSurfaceMapper::SafeDownCast(this->Mapper);
  }

  bool HasFailed() const
  {
    return this->Reader->GetErrorCode() != 0 || this->Mapper->GetErrorCode() != 0;
  }
};

/** Gatun's for a .gtn file, on demand; VTK's for a .vtp file. Memory: of Gatun's buffers, in MiB.
 */
inline SurfacePipeline MakeSurfacePipeline(const std::string& file, int memory)
{
  SurfacePipeline made;
  if (file.ends_with(".gtn"))
  {
    auto reader = vtkSmartPointer<vtkGatunSurfaceReader>::New();
    reader->SetFileName(file.c_str());
    reader->SetOnDemand(vtkGatunSurfaceReader::ON_DEMAND_ALWAYS);
    auto mapper = vtkSmartPointer<vtkGatunSurfaceMapper>::New();
    mapper->SetMemoryBudget(memory);
    made = { reader, mapper };
  }
  else
  {
    auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
    reader->SetFileName(file.c_str());
    made = { reader, vtkSmartPointer<vtkPolyDataMapper>::New() };
  }
  made.Mapper->SetInputConnection(made.Reader->GetOutputPort());
  return made;
}
}

#endif
