// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// TetGen runs in a program of its own: this process is not forked, loads no TetGen, and has the
// open files of before. The program has none of them.

#include "vtkGatunTetrahedralize.h"

#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <pthread.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

namespace
{
bool WasForked = false;

void RememberFork()
{
  WasForked = true;
}

std::ptrdiff_t CountOpenFiles()
{
  return std::distance(
    std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator());
}

bool HasTetGen()
{
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);)
  {
    if (line.find("/libtet") != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

} // anonymous namespace

int TestTetrahedralizeProcess(int, char*[])
{
  pthread_atfork(RememberFork, nullptr, nullptr);
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkGatunTetrahedralize> mesher;
  mesher->SetInputConnection(cube->GetOutputPort());
  mesher->SetMaximumVolume(0.001);
  const std::ptrdiff_t before = CountOpenFiles();
  mesher->Update();
  if (mesher->GetOutput()->GetNumberOfCells() < 1000)
  {
    std::cerr << "there are " << mesher->GetOutput()->GetNumberOfCells() << " tetrahedra\n";
    return 1;
  }
  if (WasForked || HasTetGen())
  {
    std::cerr << (WasForked ? "the process was forked\n" : "TetGen is loaded\n");
    return 1;
  }
  if (CountOpenFiles() != before)
  {
    std::cerr << "files are left open\n";
    return 1;
  }
  return 0;
}
