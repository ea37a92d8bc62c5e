// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkGatunSurfaceRepresentation
 * @brief ParaView's "Gatun Surface": surfaces, by vtkGatunSurfaceMapper if they are left in a file.
 *
 * *A file on demand*: if the input is a vtkGatunSurfaceReader on demand, the representation draws
 * the file. Only visible chunks are read and decoded, and the pipeline is asked for the outline
 * alone. A process that reads the file draws it by the vtkGatunFileHandle of the reader, and shares
 * the open file with it. A process that only draws opens the file by its name, so it must find it
 * there.
 *
 * *Any other input* is drawn as ParaView's "Surface" does.
 *
 * All properties of "Surface" are here: colors, lighting, opacity, textures, faces,
 * transformations, and the styles Points, Wireframe, Surface and Surface With Edges. For files, the
 * normals and texture coordinates are those that the file marks as such.
 *
 * *Several processes.* Cells stay in the process that has them. Of a file on demand each process
 * draws its part of the chunks; opaque images are those of one process. Translucent parts of
 * different processes are blended in the order of the processes.
 *
 * @sa vtkGatunSurfaceMapper vtkGatunSurfaceReader
 */

#ifndef vtkGatunSurfaceRepresentation_h
#define vtkGatunSurfaceRepresentation_h

#include "vtkGatunParaViewModule.h" // For export macro
#include "vtkGeometryRepresentationWithFaces.h"
#include "vtkNew.h" // For ivars

#include <memory> // For std::unique_ptr

namespace gatun
{
class PieceSource;
}

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkDataSet;
class vtkGatunDetailPolicy;
class vtkGatunSurfaceMapper;
class vtkMultiProcessController;

class VTKGATUNPARAVIEW_EXPORT vtkGatunSurfaceRepresentation
  : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkGatunSurfaceRepresentation* New();
  vtkTypeMacro(vtkGatunSurfaceRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How cells are drawn, one of RepresentationTypes of the superclass: as points (0), wires (1),
   * a surface (2), or a surface with edges (3). Takes the place of the superclass's Representation,
   * which ParaView uses for the choice between representations. Default: 2.
   */
  vtkSetClampMacro(Style, int, POINTS, SURFACE_WITH_EDGES);
  vtkGetMacro(Style, int);
  ///@}

  ///@{
  /**
   * Memory for the buffers of a file's chunks in each process, in MiB, 0 or more. Default: 512.
   */
  void SetMemoryBudget(int mebibytes);
  int GetMemoryBudget();
  ///@}

  ///@{
  /**
   * How far the surface of a file with a hierarchy is simplified; see vtkGatunSurfaceMapper.
   * Several processes agree on one level for each image in motion, so that their parts fit
   * together. Null sets a new policy, which draws the whole surface.
   */
  void SetDetailPolicy(vtkGatunDetailPolicy* policy);
  vtkGatunDetailPolicy* GetDetailPolicy();
  ///@}

  /**
   * Number of points of the file's surface in the last image; 0 if it was not simplified.
   */
  vtkIdType GetDrawnPoints();

  /**
   * Number of chunks of the file that this process drew in the last image; 0 while it draws none.
   */
  vtkIdType GetDrawnChunks();

  /**
   * Number of chunks that this process has decoded for images.
   */
  vtkIdType GetDecodedChunks();

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkGatunSurfaceRepresentation();
  ~vtkGatunSurfaceRepresentation() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  void UpdateColoringParameters() override;

  int Style = SURFACE;

private:
  vtkGatunSurfaceRepresentation(const vtkGatunSurfaceRepresentation&) = delete;
  void operator=(const vtkGatunSurfaceRepresentation&) = delete;

  void PrepareToDraw(vtkInformation* inInfo);
  vtkMultiProcessController* FindController(vtkInformation* inInfo);
  void ConnectMappers(vtkInformation* inInfo, vtkMultiProcessController* controller);
  void ChooseLevels(vtkMultiProcessController* controller);
  void CopySettings(vtkMapper* from, vtkGatunSurfaceMapper* to, vtkTimeStamp& time);

  std::unique_ptr<gatun::PieceSource> File;
  vtkNew<vtkGatunSurfaceMapper> FrontMapper; // of files
  vtkNew<vtkGatunSurfaceMapper> BackMapper;  // of the faces that are turned away, if those differ
  vtkTimeStamp FrontTime;                    // of the settings of these
  vtkTimeStamp BackTime;
  double FileBounds[6];
  bool ReadsFile = false; // whether this process has the handle of a file on demand
  bool DrawsFile = false;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
