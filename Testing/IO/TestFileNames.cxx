// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A file name set on the reader or the writer is kept, changes it, and can be taken back.

#include "vtkGatunReader.h"
#include "vtkGatunWriter.h"
#include "vtkNew.h"

#include <iostream>
#include <string>

namespace
{

template <typename Algorithm>
bool KeepsFileName()
{
  vtkNew<Algorithm> algorithm;
  if (algorithm->GetFileName())
  {
    std::cerr << algorithm->GetClassName() << " starts with a file name\n";
    return false;
  }
  const vtkMTimeType before = algorithm->GetMTime();
  algorithm->SetFileName("some.gtn");
  if (std::string("some.gtn") != algorithm->GetFileName() || algorithm->GetMTime() <= before)
  {
    std::cerr << algorithm->GetClassName() << " does not take a file name\n";
    return false;
  }
  algorithm->SetFileName(nullptr);
  return !algorithm->GetFileName();
}

} // anonymous namespace

int TestFileNames(int, char*[])
{
  return KeepsFileName<vtkGatunReader>() && KeepsFileName<vtkGatunWriter>() ? EXIT_SUCCESS
                                                                            : EXIT_FAILURE;
}
