// Reads a compressed mesh and prints its size:  ReadMesh mesh.gtn
#include <vtkGatunReader.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "mesh.gtn");
  reader->Update();
  if (reader->GetErrorCode() != 0)
  {
    return EXIT_FAILURE; // the reader has printed why
  }
  vtkUnstructuredGrid* mesh = reader->GetOutput();
  std::cout << mesh->GetNumberOfPoints() << " points, " << mesh->GetNumberOfCells() << " cells\n";
  return EXIT_SUCCESS;
}
