// Reads the compressed mesh named on the command line and says how large it is.
#include <vtkGatunReader.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <iostream>

int main(int argc, char* argv[])
{
  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "mesh.gtn");
  reader->Update();
  vtkUnstructuredGrid* mesh = reader->GetOutput();
  std::cout << mesh->GetNumberOfPoints() << " points, " << mesh->GetNumberOfCells() << " cells\n";
  return mesh->GetNumberOfCells() > 0 ? 0 : 1;
}
