// Draws a mesh as a volume, chunk by chunk from its file:  DrawVolume mesh.gtn [image.png]
// Without an image, opens a window that the mouse turns.
#include <vtkCamera.h>
#include <vtkGatunDefaults.h>
#include <vtkGatunReader.h>
#include <vtkGatunVolumeMapper.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
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

  // Frequent values are transparent, rare ones are not; see the class for how to choose.
  vtkNew<vtkGatunDefaults> defaults;
  defaults->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  if (!defaults->MakeProperty(volume->GetProperty()) ||
    !defaults->FitCamera(renderer->GetActiveCamera(), 1))
  {
    return EXIT_FAILURE; // VTK has told the reason
  }
  renderer->ResetCameraClippingRange(); // the bounds come from the file
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
