// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunSimplify
 * @brief Simplifies a tetrahedral mesh to any degree.
 *
 * The filter merges points into neighbors by edge collapses, the cheapest one first. The cost is
 * the square of the change of the values and, on the boundary, of the shape. The order of all
 * merges is found once for a mesh, which takes a while. Afterwards, another target takes one pass.
 * Tetrahedra keep their orientation, points of the boundary stay on it, and the topology does not
 * change. A mesh can only become as coarse as that allows.
 *
 * Input: a vtkUnstructuredGrid. Other linear cells are split into tetrahedra, as in vtkGatunWriter.
 * Ghost cells are left out. Output: the remaining points at their places and in their order, with
 * their point data; the remaining tetrahedra with their cell data; field data.
 *
 * *From a file.* If the input is the output of a vtkGatunReader without a region of interest, and
 * its file has a hierarchy (vtkGatunWriter::Hierarchy), the filter finds a vtkGatunFileHandle in
 * the information of its input and uses the order of merges in the file, and its base meshes. The
 * reader is then not asked for the mesh. The output is what the reader gives with the same number
 * of merges: the same points and cells in the same order, with pieces that fit together, ghost
 * cells, time steps and the selected arrays. If the reader simplifies, too, Ratio, Percent and
 * NumberOfPoints refer to its mesh. Metric, BoundaryWeight and array weights have no influence, as
 * they were chosen when the file was written; see UseFileHierarchy.
 *
 * *Pieces.* Without a file that has a hierarchy, each piece is simplified on its own. Pieces do not
 * fit together then, which a warning says once.
 *
 * *Cost.* One thread; about 150 bytes a tetrahedron, with one array, while the order of merges is
 * found, and 20 bytes a point as long as the input does not change. From a file: that of the
 * reader.
 *
 * *Errors.* A target or a weight that makes no sense, cells that cannot be converted to tetrahedra
 * and damaged files are reported by vtkErrorMacro and GetErrorCode. The output is then empty.
 *
 * @par Background
 * A. Van Gelder, V. Verma, J. Wilhelms: Volume decimation of irregular tetrahedral grids. Computer
 * Graphics International 1999. C. Yang: On-the-fly processing of compressed volume data, 2001.
 *
 * @sa vtkGatunReader vtkGatunFileHandle vtkUnstructuredGridQuadricDecimation
 */

#ifndef vtkGatunSimplify_h
#define vtkGatunSimplify_h

#include "vtkGatunFiltersModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory> // For std::unique_ptr

class VTKGATUNFILTERS_EXPORT vtkGatunSimplify : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkGatunSimplify* New();
  vtkTypeMacro(vtkGatunSimplify, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What tells how far to go.
   */
  enum TargetType
  {
    TARGET_RATIO = 0,            ///< Ratio
    TARGET_PERCENT = 1,          ///< Percent
    TARGET_NUMBER_OF_POINTS = 2, ///< NumberOfPoints
    TARGET_ERROR = 3             ///< MaximumError
  };

  ///@{
  /**
   * See TargetType. Default: TARGET_RATIO.
   */
  vtkSetClampMacro(Target, int, TARGET_RATIO, TARGET_ERROR);
  vtkGetMacro(Target, int);
  ///@}

  ///@{
  /**
   * The part of the points that is merged away: 0 (nothing) to 1 (as many as can be). Default: 0.5.
   */
  vtkSetMacro(Ratio, double);
  vtkGetMacro(Ratio, double);
  ///@}

  ///@{
  /**
   * How many points in a hundred are left, 0 to 100. Default: 50.
   */
  vtkSetMacro(Percent, double);
  vtkGetMacro(Percent, double);
  ///@}

  ///@{
  /**
   * How many points are left, if that is possible; all if the mesh has fewer. Default: 10000.
   */
  vtkSetMacro(NumberOfPoints, vtkIdType);
  vtkGetMacro(NumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Merges end before the error becomes larger: an estimate of the root mean square error of the
   * values, as a part of their range, and of the shape. Default: 0.001.
   */
  vtkSetMacro(MaximumError, double);
  vtkGetMacro(MaximumError, double);
  ///@}

  enum MetricType
  {
    METRIC_MASS = 0,   ///< tetrahedra count by their volume
    METRIC_DENSITY = 1 ///< all alike
  };

  ///@{
  /**
   * How much a change of values counts in each tetrahedron; see MetricType. Default: METRIC_MASS.
   */
  vtkSetClampMacro(Metric, int, METRIC_MASS, METRIC_DENSITY);
  vtkGetMacro(Metric, int);
  ///@}

  ///@{
  /**
   * How much of the cost of merges on the boundary is that of shape, 0 to 1; the rest is that of
   * values. Default: 0.5.
   */
  vtkSetMacro(BoundaryWeight, double);
  vtkGetMacro(BoundaryWeight, double);
  ///@}

  ///@{
  /**
   * How much a point array counts, relative to others, 0 or more; each value relative to the range
   * of its component. Without any weight set, the active scalars count, or, if there are none, all
   * point arrays alike.
   */
  void SetArrayWeight(const char* name, double weight);
  double GetArrayWeight(const char* name);
  void ClearArrayWeights();
  ///@}

  ///@{
  /**
   * Whether the hierarchy of the file is used if the input comes from a file that has one. Off: the
   * filter finds an order of merges of its own for the input. Default: on.
   */
  vtkSetMacro(UseFileHierarchy, bool);
  vtkGetMacro(UseFileHierarchy, bool);
  vtkBooleanMacro(UseFileHierarchy, bool);
  ///@}

  /**
   * Number of merges that are possible for the input of the last update, which is the number of
   * points that can be removed at most.
   */
  vtkIdType GetMostMerges();

  /**
   * The error of the merges that led to the output, see MaximumError.
   */
  double GetOutputError();

protected:
  vtkGatunSimplify();
  ~vtkGatunSimplify() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * As vtkGatunContour::GetFileInformation.
   */
  virtual vtkInformation* GetFileInformation(vtkInformation* inInfo);

  int Target = TARGET_RATIO;
  double Ratio = 0.5;
  double Percent = 50;
  vtkIdType NumberOfPoints = 10000;
  double MaximumError = 1e-3;
  int Metric = METRIC_MASS;
  double BoundaryWeight = 0.5;
  bool UseFileHierarchy = true;

private:
  vtkGatunSimplify(const vtkGatunSimplify&) = delete;
  void operator=(const vtkGatunSimplify&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
