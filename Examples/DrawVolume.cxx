// Draws a mesh as a volume, chunk by chunk from its file:  DrawVolume mesh.gtn [image.png]
// Without an image, opens a window that the mouse turns.
#include <vtkColorTransferFunction.h>
#include <vtkGatunReader.h>
#include <vtkGatunVolumeMapper.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>

int main(int argc, char* argv[])
{
  vtkNew<vtkGatunReader> reader;
  reader->SetFileName(argc > 1 ? argv[1] : "mesh.gtn");
  vtkNew<vtkGatunVolumeMapper> mapper; // draws the file, not the output of the reader
  mapper->SetInputConnection(reader->GetOutputPort());

  // Values from 0 to 1, the larger the redder and the more opaque.
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0, 0.2, 0.3, 0.9);
  colors->AddRGBPoint(1, 0.9, 0.2, 0.1);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0, 0);
  opacities->AddPoint(1, 0.9);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colors);
  volume->GetProperty()->SetScalarOpacity(opacities);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.2);

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->ResetCamera(); // the bounds come from the file
  vtkNew<vtkRenderWindow> window;
  window->SetSize(600, 600);
  window->AddRenderer(renderer);
  if (argc <= 2)
  {
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(window);
    window->Render();
    interactor->Start();
    return EXIT_SUCCESS;
  }
  window->SetOffScreenRendering(true);
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
