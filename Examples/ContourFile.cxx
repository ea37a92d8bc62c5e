// Extracts an isosurface, reading only the chunks that it passes through:
//   ContourFile mesh.gtn array value surface.vtp
#include <vtkGatunContour.h>
#include <vtkGatunReader.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 5)
  {
    std::cerr << "usage: ContourFile mesh.gtn array value surface.vtp\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkGatunContour> contour;
  contour->SetInputConnection(reader->GetOutputPort());
  contour->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, argv[2]);
  contour->SetValue(0, std::atof(argv[3]));
  contour->ComputeNormalsOn();
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(contour->GetOutputPort());
  writer->SetFileName(argv[4]);
  if (!writer->Write() || contour->GetErrorCode() != 0)
  {
    return EXIT_FAILURE;
  }
  std::cout << contour->GetOutput()->GetNumberOfPolys() << " triangles\n";
  return EXIT_SUCCESS;
}
