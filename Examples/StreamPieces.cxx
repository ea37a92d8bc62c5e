// Extracts the surface of a compressed mesh piece by piece with VTK's own filters, so that only one
// piece of the mesh is in memory at a time: StreamPieces mesh.gtn 32
#include <vtkGatunReader.h>
#include <vtkGeometryFilter.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataStreamer.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "mesh.gtn");

  // With ghost cells, the filter leaves out the faces between two pieces.
  vtkNew<vtkGeometryFilter> surface;
  surface->SetInputConnection(reader->GetOutputPort());
  surface->SetPieceInvariant(1);

  // The streamer requests one piece after the other and appends the surfaces.
  vtkNew<vtkPolyDataStreamer> streamer;
  streamer->SetInputConnection(surface->GetOutputPort());
  streamer->SetNumberOfStreamDivisions(argc > 2 ? std::atoi(argv[2]) : 16);
  streamer->Update();

  auto* triangles = vtkPolyData::SafeDownCast(streamer->GetOutputDataObject(0));
  std::cout << triangles->GetNumberOfCells() << " triangles\n";
  return triangles->GetNumberOfCells() > 0 ? 0 : 1;
}
