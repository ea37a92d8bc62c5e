// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunSimplify
 * @brief Makes a tetrahedral mesh coarser, to any degree, at once.
 *
 * Points are merged into neighbours, the cheapest merge first: by the squares of what it changes
 * of the values and, on the boundary, of the shape. The order of all
 * merges is found once for a mesh, which takes a while; after that, another target is a matter of
 * one pass. Tetrahedra keep their orientation, points of the boundary stay on it, and the topology
 * does not change; so a mesh can only become as coarse as that allows.
 *
 * Input: a vtkUnstructuredGrid. Other linear cells become tetrahedra, as in vtkGatunWriter; ghost
 * cells are left out. Output: the points that are left, where they were and in their order, with
 * their point data; the tetrahedra that are left, with their cell data; field data.
 *
 * Cost: one thread; about 150 bytes a tetrahedron, with one array, while the order of merges is
 * found, and 20 bytes a point for as long as the input does not change.
 *
 * *Errors.* A target or a weight that makes no sense, and cells that cannot be made tetrahedra, are
 * reported by vtkErrorMacro and GetErrorCode; the output is empty then.
 *
 * Based on: Van Gelder, Verma, Wilhelms: Volume decimation of irregular tetrahedral grids. Computer
 * Graphics International 1999; Yang: On-the-fly processing of compressed volume data, 2001.
 *
 * @warning Pieces are simplified each by itself, and do not fit together afterwards.
 *
 * @sa vtkUnstructuredGridQuadricDecimation
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
   * Kinds of simplification targets.
   */
  enum SimplificationTargetType
  {
    TARGET_RATIO = 0,            ///< SimplificationRatio
    TARGET_NUMBER_OF_POINTS = 1, ///< SimplificationNumberOfPoints
    TARGET_RMS_ERROR = 2         ///< SimplificationRMSError
  };

  ///@{
  /**
   * Property that gives the target, one of SimplificationTargetType. Default: TARGET_RATIO.
   */
  vtkSetClampMacro(SimplificationTarget, int, TARGET_RATIO, TARGET_RMS_ERROR);
  vtkGetMacro(SimplificationTarget, int);
  void SetSimplificationTargetToRatio() { this->SetSimplificationTarget(TARGET_RATIO); }
  void SetSimplificationTargetToNumberOfPoints()
  {
    this->SetSimplificationTarget(TARGET_NUMBER_OF_POINTS);
  }
  void SetSimplificationTargetToRMSError() { this->SetSimplificationTarget(TARGET_RMS_ERROR); }
  ///@}

  ///@{
  /**
   * Fraction of points removed, from 0 (none) to 1 (as many as possible). NaN is an error. Default:
   * 0.5.
   */
  vtkSetClampMacro(SimplificationRatio, double, 0.0, 1.0);
  vtkGetMacro(SimplificationRatio, double);
  ///@}

  ///@{
  /**
   * Number of points of the result, 0 or more, as far as possible; a larger number than that of the
   * mesh keeps all. Default: 10000.
   */
  vtkSetClampMacro(SimplificationNumberOfPoints, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(SimplificationNumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Largest root mean square error of the result, 0 or more: an estimate for the
   * values, relative to their range, and for the shape of the boundary.
   * Default: 0.001.
   */
  vtkSetClampMacro(SimplificationRMSError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SimplificationRMSError, double);
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
  vtkSetClampMacro(BoundaryWeight, double, 0.0, 1.0);
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

  /**
   * How many merges there are for the input of the last update, all of them: so many points can be
   * taken away at most.
   */
  vtkIdType GetMostMerges();

  /**
   * Root mean square error of the output, as SimplificationRMSError has it.
   */
  double GetOutputRMSError();

protected:
  vtkGatunSimplify();
  ~vtkGatunSimplify() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int SimplificationTarget = TARGET_RATIO;
  double SimplificationRatio = 0.5;
  vtkIdType SimplificationNumberOfPoints = 10000;
  double SimplificationRMSError = 1e-3;
  int Metric = METRIC_MASS;
  double BoundaryWeight = 0.5;

private:
  vtkGatunSimplify(const vtkGatunSimplify&) = delete;
  void operator=(const vtkGatunSimplify&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
