// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunSimplify
 * @brief Simplifies a tetrahedral mesh or a surface to any degree.
 *
 * The filter collapses edges: a point is merged into a neighbor, the cheapest merge first. The cost
 * of a merge is the squared change of the values and, on the boundary, of the shape. The order of
 * all merges is computed once for a mesh. After that, each target takes one pass over the mesh.
 * Tetrahedra keep their orientation, boundary points stay on the boundary, and the topology does
 * not change, which limits how coarse a mesh can become.
 *
 * *Surfaces.* Input: a vtkPolyData; the output is one, too. The cost of a merge is the quadric
 * error of the shape and of the values. No triangle is turned over, the topology does not change,
 * and borders and edges sharper than FeatureAngle stay where they are as far as possible. Points
 * with the same coordinates, such as those of a seam of texture coordinates, are merged together,
 * so that seams stay closed; the result can then have a few points more than the target. Polygons
 * and strips are divided into triangles. Vertices and lines are kept with their points. So are
 * points where the surface is not a manifold, points of degenerate triangles, points that are not
 * finite, and unused points. Ghost cells are left out. In several pieces, all points on the border
 * of a piece are kept, so that pieces fit together without communication.
 *
 * *Meshes.* Input: a vtkUnstructuredGrid. Other 3D cells are split into tetrahedra
 * (Documentation/cells.md), nonlinear ones without the points between their corners. Cells of a
 * lower dimension and ghost cells are left out. Output: the remaining points, unmoved and in their
 * order, with their point data; the remaining tetrahedra with their cell data; the field data.
 *
 * *From a file.* If the input is the output of a vtkGatunReader or a vtkGatunSurfaceReader without
 * a region of interest, and its file has a hierarchy (vtkGatunWriter::Hierarchy), the filter finds
 * a vtkGatunFileHandle in the information of its input and uses the order of merges in the file,
 * and its base meshes. The reader is then not asked for the mesh. The output is that of the reader
 * with the same number of merges: the same points and cells in the same order, with pieces that fit
 * together, ghost cells, time steps and the selected arrays. If the reader simplifies, too,
 * SimplificationRatio and SimplificationNumberOfPoints refer to its mesh. Metric, BoundaryWeight,
 * FeatureAngle and array weights have no influence, since they were chosen when the file was
 * written; see UseFileHierarchy.
 *
 * *Pieces of meshes.* Pieces fit together. Without a file that has a hierarchy, each piece is
 * simplified on its own, and the points that it has in common with others are kept. If each process
 * of Controller asks for its piece, they exchange the places of the points on the boundaries of
 * their pieces, and all of them must update the filter. Otherwise the input is asked for a level of
 * ghost cells, whose points are kept. Where it has none, all points on the boundary of a piece are
 * kept. The target is that of each piece.
 *
 * *Cost.* From a file, that of the reader. Otherwise the filter uses all threads. The computation
 * of the order takes about 150 bytes a tetrahedron and 250 a triangle, with one array. The order is
 * kept as long as the input does not change and takes 20 bytes a point.
 *
 * *Abort.* AbortExecute is checked while the order is computed. The output is then empty and
 * GetErrorCode is vtkGatunErrorCode::AbortedError.
 *
 * *Errors.* A target or a weight that is NaN, a weight for an array that does not exist, and cells
 * that cannot be converted to tetrahedra are reported by vtkErrorMacro. GetErrorCode is then
 * vtkGatunErrorCode::InvalidInputError, and the output is empty.
 *
 * @par Background
 * A. Van Gelder, V. Verma, J. Wilhelms: Volume decimation of irregular tetrahedral grids. Computer
 * Graphics International 1999 (cost of a merge by mass and by density).
 * C.-K. Yang: On-the-fly processing of compressed volume data. Dissertation proposal, State
 * University of New York at Stony Brook, 2001, section 5 (tree of merges).
 * M. Garland, P. Heckbert: Surface simplification using quadric error metrics. SIGGRAPH 1997.
 * H. Hoppe: New quadric metric for simplifying meshes with appearance attributes. Visualization
 * 1999.
 *
 * @sa vtkGatunReader vtkGatunFileHandle vtkUnstructuredGridQuadricDecimation vtkQuadricDecimation
 */

#ifndef vtkGatunSimplify_h
#define vtkGatunSimplify_h

#include "vtkGatunFiltersModule.h" // For export macro
#include "vtkPointSetAlgorithm.h"

#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkMultiProcessController;

class VTKGATUNFILTERS_EXPORT vtkGatunSimplify : public vtkPointSetAlgorithm
{
public:
  static vtkGatunSimplify* New();
  vtkTypeMacro(vtkGatunSimplify, vtkPointSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Fraction of points to remove, from 0 (none) to 1 (as many as possible). NaN is an error. No
   * effect if one of the other two targets is given. Default: 0.5.
   */
  vtkSetClampMacro(SimplificationRatio, double, 0.0, 1.0);
  vtkGetMacro(SimplificationRatio, double);
  ///@}

  ///@{
  /**
   * Number of points of the result, as far as possible, or somewhat fewer, as merges of a round are
   * done together; a larger number than that of the mesh keeps all. 0: SimplificationRatio is the
   * target. Default: 0.
   */
  vtkSetClampMacro(SimplificationNumberOfPoints, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(SimplificationNumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Largest root mean square error of the result: an estimate for the values, relative to their
   * range, and for the shape of the boundary. 0: one of the other two is the target. Default: 0.
   */
  vtkSetClampMacro(SimplificationRMSError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SimplificationRMSError, double);
  ///@}

  enum MetricType
  {
    METRIC_MASS = 0,   ///< by its volume
    METRIC_DENSITY = 1 ///< the same for all
  };

  ///@{
  /**
   * Weight of a change of values in a tetrahedron, one of MetricType. It has no influence on
   * surfaces. Default: METRIC_MASS.
   */
  vtkSetClampMacro(Metric, int, METRIC_MASS, METRIC_DENSITY);
  vtkGetMacro(Metric, int);
  ///@}

  ///@{
  /**
   * Share of the shape in the cost of a merge on the boundary, or anywhere on a surface, 0 to 1.
   * The values have the rest. Default: 0.5.
   */
  vtkSetClampMacro(BoundaryWeight, double, 0.0, 1.0);
  vtkGetMacro(BoundaryWeight, double);
  ///@}

  ///@{
  /**
   * For surfaces: angle between the normals of two triangles, in degrees, 0 to 180. Edges with a
   * larger angle are kept like the border. Default: 30.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Weight of a point array relative to that of other arrays, 0 or more. Values count relative to
   * the range of their component. If no weight is set, the active scalars count, or all point
   * arrays equally if there are no active scalars.
   */
  void SetArrayWeight(const char* name, double weight);
  double GetArrayWeight(const char* name);
  void ClearArrayWeights();
  ///@}

  ///@{
  /**
   * Whether the filter uses the hierarchy of the file behind its input, if there is one. Off: it
   * computes an order of merges for the input. Default: on.
   */
  vtkSetMacro(UseFileHierarchy, bool);
  vtkGetMacro(UseFileHierarchy, bool);
  vtkBooleanMacro(UseFileHierarchy, bool);
  ///@}

  ///@{
  /**
   * The processes that each simplify a piece. Default: the global controller
   * (vtkMultiProcessController::GetGlobalController). Null: no communication.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  /**
   * Largest number of points that can be removed from the input of the last update.
   */
  vtkIdType GetMostMerges();

  /**
   * Root mean square error of the output, defined as for SimplificationRMSError.
   */
  double GetOutputRMSError();

protected:
  vtkGatunSimplify();
  ~vtkGatunSimplify() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int ExecuteInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int ComputeInputUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * As vtkGatunContour::GetFileInformation.
   */
  virtual vtkInformation* GetFileInformation(vtkInformation* inInfo);

  double SimplificationRatio = 0.5;
  vtkIdType SimplificationNumberOfPoints = 0;
  double SimplificationRMSError = 0;
  int Metric = METRIC_MASS;
  double BoundaryWeight = 0.5;
  double FeatureAngle = 30;
  bool UseFileHierarchy = true;
  vtkMultiProcessController* Controller = nullptr;

private:
  vtkGatunSimplify(const vtkGatunSimplify&) = delete;
  void operator=(const vtkGatunSimplify&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
