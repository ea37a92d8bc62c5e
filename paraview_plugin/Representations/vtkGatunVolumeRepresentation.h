// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @class vtkGatunVolumeRepresentation
 * @brief ParaView's "Gatun Volume": unstructured grids as volumes, by vtkGatunVolumeMapper.
 *
 * *A mesh in memory* is drawn as it is, with any 3D cells. Surfaces and lines among them are
 * left out, and a mesh that consists only of those is shown as a surface.
 *
 * *A file on demand*: if the input is a vtkGatunReader on demand, the representation draws the
 * file. Only visible chunks are read and decoded, and the pipeline is asked for the outline alone.
 * A process that reads the file draws it by the vtkGatunFileHandle of the reader, and shares the
 * open file, decoded chunks and memory budget with it. A process that only draws opens the file by
 * its name, so it must find it there.
 *
 * *Several processes.* Cells stay in the process that has them; processes exchange segments of
 * rays, see vtkGatunVolumeMapper. Of a file on demand each process draws every n-th chunk. The
 * image is that of one process in all modes, with any other representations in the view.
 *
 * Colors are those of the array, and of its component or length, as chosen for coloring. A separate
 * array for opacities, several components mapped at once and colors taken directly from the array
 * have no influence. During an interaction the volume is drawn with fewer rays or as a coarser
 * mesh, never as a surface.
 *
 * @sa vtkGatunVolumeMapper vtkGatunReader
 */

#ifndef vtkGatunVolumeRepresentation_h
#define vtkGatunVolumeRepresentation_h

#include "vtkGatunParaViewModule.h" // For export macro
#include "vtkNew.h"                 // For ivars
#include "vtkSmartPointer.h"        // For ivars
#include "vtkUnstructuredGridVolumeRepresentation.h"

#include <memory> // For std::unique_ptr

namespace gatun
{
struct DrawnFile;
class PieceSource;
}

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkDataSet;
class vtkGatunDetailPolicy;
class vtkGatunFileHandle;
class vtkGatunVolumeMapper;
class vtkMultiProcessController;
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
   * Blend mode of vtkGatunVolumeMapper: COMPOSITE_BLEND (0, the default), MAXIMUM_INTENSITY_BLEND
   * (1) or XRAY_BLEND (101).
   */
  void SetBlendMode(int mode);
  int GetBlendMode();
  ///@}

  ///@{
  /**
   * Memory for the parts of the mesh that are kept for the next image in each process, in MiB. For
   * a file on demand the budget is that of its reader, unless another process draws it than the one
   * that reads it. Default: 512.
   */
  void SetMemoryBudget(int mebibytes);
  int GetMemoryBudget();
  ///@}

  ///@{
  /**
   * Whether fewer rays are cast during an interaction, to meet the frame time. Default: on.
   */
  void SetAutoAdjustSampleDistances(bool on);
  bool GetAutoAdjustSampleDistances();
  vtkBooleanMacro(AutoAdjustSampleDistances, bool);
  ///@}

  ///@{
  /**
   * How far the mesh is simplified; see vtkGatunVolumeMapper. Several processes simplify files
   * only, as parts of a mesh in memory that are simplified separately do not fit together. Of
   * these, and of a file without a hierarchy, fewer rays are drawn during an interaction. Null sets
   * a new policy, which draws the whole mesh.
   */
  void SetDetailPolicy(vtkGatunDetailPolicy* policy);
  vtkGatunDetailPolicy* GetDetailPolicy();
  ///@}

  /**
   * How many points the mesh of the last image had; 0 where nothing is simplified.
   */
  vtkIdType GetDrawnPoints();

  /**
   * The length over which the opacities are meant, in world units. Where a file is drawn, the value
   * that ParaView derives from the number of cells of the outline or boundary stands for that of
   * the mesh. Default: 1.
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

  /**
   * Bytes that the processes have sent to each other for the last image; 0 for one process.
   */
  vtkIdType GetBytesSent();

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

  vtkIdType GetStatistic(const char* name);
  void MakePiece(vtkDataObject* input);
  void DeliverPiece(vtkInformation* inInfo, vtkInformation* outInfo);
  void DeliverOutline(vtkInformation* inInfo);
  void PrepareToDraw(vtkInformation* inInfo);
  bool ConnectFile(vtkUnstructuredGrid* piece, const gatun::DrawnFile& file);
  vtkMultiProcessController* FindController(vtkInformation* inInfo, vtkUnstructuredGrid* piece);
  int FindImageProcess();
  double ChooseUnitDistance();

  vtkSmartPointer<vtkGatunDetailPolicy> DetailPolicy; // that of the mapper follows it
  vtkNew<vtkGatunVolumeMapper> VolumeMapper;
  std::unique_ptr<gatun::PieceSource> File;
  vtkSmartPointer<vtkGatunFileHandle> Drawn; // of the file that the mapper draws, while it does
  vtkSmartPointer<vtkUnstructuredGrid> Piece;
  vtkDataSet* Shown = nullptr; // what tells which arrays there are
  double UnitDistance = 1;
  vtkIdType OwnCells = 0;     // of the outline or boundary that stands for a file, in this process
  vtkIdType CellsInPlace = 0; // the same of all processes
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
