// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkGatunVolumeRepresentation
 * @brief ParaView's "Gatun Volume": unstructured grids as volumes, by vtkGatunVolumeMapper.
 *
 * *A mesh in memory* is drawn as it is, whatever linear 3D cells it has; surfaces and lines among
 * them are left out, and a mesh of nothing else is shown as a surface. Among several processes the
 * cells are redistributed as for ParaView's own volumes.
 *
 * *A vtkGatunReader that reads on demand*, as the input itself: its file is drawn, from which only
 * what is seen is read and decoded, and nothing but the outline is asked of the pipeline. Each of
 * several processes that draw has a part of the bounds: it reads and draws the file, cut to its
 * part. The pictures of the parts together are, pixel by pixel, that of one process, but for
 * rounding. Maximum and X-ray pictures cannot be put together so; the first process draws them. The
 * file must be found by its name where it is drawn.
 *
 * Colours are those of the array, and of its component or length, as chosen for colouring. A
 * separate array for opacities, several components mapped at once and colours taken from the array
 * directly have no influence. While somebody interacts, the volume is drawn with fewer rays, or as
 * a simpler mesh, never as a surface.
 *
 * @sa vtkGatunVolumeMapper vtkGatunReader
 */

#ifndef vtkGatunVolumeRepresentation_h
#define vtkGatunVolumeRepresentation_h

#include "vtkGatunParaViewModule.h" // For export macro
#include "vtkNew.h"                 // For ivars
#include "vtkSmartPointer.h"        // For ivars
#include "vtkUnstructuredGridVolumeRepresentation.h"

namespace gatun
{
struct DrawnFile;
}

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkBoundingBox;
class vtkDataSet;
class vtkGatunReader;
class vtkGatunVolumeMapper;
class vtkUnstructuredGrid;

class VTKGATUNPARAVIEW_EXPORT vtkGatunVolumeRepresentation
  : public vtkUnstructuredGridVolumeRepresentation
{
public:
  static vtkGatunVolumeRepresentation* New();
  vtkTypeMacro(vtkGatunVolumeRepresentation, vtkUnstructuredGridVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Distance of the samples along a ray in world units; 0: that of the rays at the camera's focal
   * point. Default: 0.
   */
  void SetSampleDistance(double distance);
  double GetSampleDistance();
  ///@}

  ///@{
  /**
   * Blend mode of vtkGatunVolumeMapper: COMPOSITE_BLEND (0, the default), MAXIMUM_INTENSITY_BLEND
   * (1), AREA_BLEND (100) or XRAY_BLEND (101).
   */
  void SetBlendMode(int mode);
  int GetBlendMode();
  ///@}

  ///@{
  /**
   * How much of the mesh is kept ready for the next picture in each process, in MiB. Default: 512.
   */
  void SetMemoryBudget(int mebibytes);
  int GetMemoryBudget();
  ///@}

  ///@{
  /**
   * Whether fewer rays are drawn while somebody interacts, so that a picture takes the time that
   * there is. Default: on.
   */
  void SetAutoAdjustSampleDistances(bool on);
  bool GetAutoAdjustSampleDistances();
  vtkBooleanMacro(AutoAdjustSampleDistances, bool);
  ///@}

  ///@{
  /**
   * Whether the mesh is simplified while somebody interacts, so that a picture takes the time that
   * there is, before rays get fewer; see vtkGatunVolumeMapper. Several processes would simplify
   * their parts each by itself, so that these do not fit together: there, it has no influence.
   * Default: off.
   */
  void SetJustInTime(bool on);
  bool GetJustInTime();
  vtkBooleanMacro(JustInTime, bool);
  ///@}

  ///@{
  /**
   * Seconds that a picture may take then; 0: what VTK allocates to it. Default: 0.1.
   */
  void SetTimeBudget(double seconds);
  double GetTimeBudget();
  ///@}

  ///@{
  /**
   * Part of the points that is merged away in all pictures, 0 to 1. With several processes it only
   * has influence on meshes that are drawn from their file. Default: 0.
   */
  void SetSimplificationRatio(double ratio);
  double GetSimplificationRatio();
  ///@}

  /**
   * How many points the mesh of the last picture had; 0 where nothing is simplified.
   */
  vtkIdType GetDrawnPoints();

  /**
   * The length over which the opacities are meant, in world units. Where a file is drawn, the value
   * that ParaView derives from the number of cells of the outline stands for that of the mesh.
   * Default: 1.
   */
  void SetScalarOpacityUnitDistance(double distance);

  /**
   * There is only one mapper: no influence.
   */
  void SetActiveVolumeMapper(const char* name) override;

  /**
   * Bytes that were read from the file to draw it, by this process; 0 while none is drawn.
   */
  vtkIdType GetBytesRead();

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkGatunVolumeRepresentation();
  ~vtkGatunVolumeRepresentation() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  void UpdateMapperParameters() override;

private:
  vtkGatunVolumeRepresentation(const vtkGatunVolumeRepresentation&) = delete;
  void operator=(const vtkGatunVolumeRepresentation&) = delete;

  vtkBoundingBox GetWorldBox();
  void MakePiece(vtkDataObject* input);
  void DeliverPiece(vtkInformation* inInfo, vtkInformation* outInfo);
  void DeliverOutline(vtkInformation* inInfo);
  void PrepareToDraw(vtkInformation* inInfo);
  bool PrepareFile(const gatun::DrawnFile& file);
  bool CutToPart();
  double ChooseUnitDistance();

  vtkNew<vtkGatunVolumeMapper> VolumeMapper;
  vtkNew<vtkGatunReader> File;
  vtkSmartPointer<vtkUnstructuredGrid> Piece;
  vtkDataSet* Shown = nullptr; // what tells which arrays there are
  bool DrawsFile = false;
  bool JustInTime = false;
  double SimplificationRatio = 0;
  double UnitDistance = 1;
  double LastBox[6] = { 1, -1, 1, -1, 1, -1 };
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
