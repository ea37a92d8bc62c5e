// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunContour
 * @brief Isosurfaces of a tetrahedral mesh, from memory or straight from a compressed file.
 *
 * Input: a vtkUnstructuredGrid with point scalars of any numeric type. Tetrahedra are taken as they
 * are, other linear 3D cells are split, quadratic tetrahedra made linear, as in vtkGatunWriter;
 * ghost cells are left out. Which array: SetInputArrayToProcess, by default the active point
 * scalars; of several components see ArrayComponent.
 *
 * If the input is the output of a vtkGatunReader (without a region of interest or a value range),
 * the surface is made straight from its file: only the chunks that it passes through are read, as
 * the ranges of their values tell, each decoded when its turn comes, and the reader itself is never
 * asked for the mesh: unless it has one already, its output is an empty piece afterwards, until
 * somebody asks for another (vtkAlgorithm::UpdatePiece). Files written with layers of the array
 * (vtkGatunWriter::LayerArray) have the fewest such chunks. If the reader simplifies, the surface
 * is that of the simplified mesh; time steps and the selection of arrays are the reader's, too.
 *
 * Output: a vtkPolyData of triangles, or of triangle strips. All point arrays are interpolated, and
 * cell arrays passed to the triangles, but for global ids and, of points, pedigree ids and arrays
 * of vtkIdType. Points with the same coordinates are one.
 *
 * The triangles are those of vtkContourGrid: a corner whose value is the isovalue is one above it;
 * triangles with two corners in one point are left out. Where a field is constant at the isovalue
 * there is no surface. Tetrahedra with a value that is NaN or infinite have none either. The order
 * is that of the tetrahedra, and does not depend on the number of threads.
 *
 * *Pieces.* Of a file, each piece takes its share of the chunks that the surface passes through.
 * Other inputs are asked for the same piece.
 *
 * *Cost.* From a file: time in proportion to the chunks that are read; memory for about twice the
 * surface, a chunk for each thread, MemoryBudget, and points that chunks share. All threads of
 * vtkSMPTools are used.
 *
 * *Errors.* A missing array, a component that is not there, isovalues that are not finite, cells
 * that cannot be made tetrahedra and damaged files are reported by vtkErrorMacro and GetErrorCode
 * (as vtkGatunReader has them); the output is then empty.
 *
 * @par Background
 * C. Yang: On-the-fly processing of compressed volume data, 2001 (layers of values). P. Cignoni, P.
 * Marino, C. Montani, E. Puppo, R. Scopigno: Speeding up isosurface extraction using interval
 * trees. IEEE Transactions on Visualization and Computer Graphics 3(2), 1997.
 *
 * @warning With OutputStrips there are no cell arrays, as a strip goes through many cells.
 *
 * @sa vtkGatunReader vtkContourGrid vtkContour3DLinearGrid
 */

#ifndef vtkGatunContour_h
#define vtkGatunContour_h

#include "vtkGatunFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKGATUNFILTERS_EXPORT vtkGatunContour : public vtkPolyDataAlgorithm
{
public:
  static vtkGatunContour* New();
  vtkTypeMacro(vtkGatunContour, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Isovalues, in the units of the array, by index from 0; in any order. Those that are equal count
   * once. NaN and infinite values are an error. Default: none.
   */
  void SetValue(int i, double value);
  double GetValue(int i);
  double* GetValues();
  void GetValues(double* values);
  void SetNumberOfContours(int number);
  vtkIdType GetNumberOfContours();
  ///@}

  ///@{
  /**
   * Makes a given number of isovalues, spread evenly over a range.
   */
  void GenerateValues(int number, double range[2]);
  void GenerateValues(int number, double first, double last);
  ///@}

  ///@{
  /**
   * Component of the array, from 0; -1, or the number of components, is the Euclidean length of the
   * tuple, or the value itself if there is only one component. Default: -1.
   */
  vtkSetClampMacro(ArrayComponent, int, -1, VTK_INT_MAX);
  vtkGetMacro(ArrayComponent, int);
  ///@}

  ///@{
  /**
   * Whether to make a point array "Normals" (float), of unit vectors towards lower values: the mean
   * of the gradients of the tetrahedra around the edge that the point is on, weighted by their
   * volumes; where the value is met exactly at a point of the mesh, of those that the surface goes
   * through there, once for each edge. Default: off.
   */
  vtkSetMacro(ComputeNormals, bool);
  vtkGetMacro(ComputeNormals, bool);
  vtkBooleanMacro(ComputeNormals, bool);
  ///@}

  ///@{
  /**
   * Whether the output has the array of the isovalues, as the active scalars. Default: on.
   */
  vtkSetMacro(ComputeScalars, bool);
  vtkGetMacro(ComputeScalars, bool);
  vtkBooleanMacro(ComputeScalars, bool);
  ///@}

  ///@{
  /**
   * Whether neighboring triangles are joined to triangle strips, in the order of the tetrahedra.
   * Default: off.
   */
  vtkSetMacro(OutputStrips, bool);
  vtkGetMacro(OutputStrips, bool);
  vtkBooleanMacro(OutputStrips, bool);
  ///@}

  ///@{
  /**
   * Precision of the points: vtkAlgorithm::DesiredOutputPrecision. Default: DEFAULT_PRECISION, that
   * of the input.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * Memory for decoded chunks of a file, in MiB, 0 or more, so that other isovalues need not decode
   * them again. Shared points take up to 32 MiB in addition. The output does not depend on the
   * budget. Default: 512.
   */
  vtkSetClampMacro(MemoryBudget, int, 0, VTK_INT_MAX);
  vtkGetMacro(MemoryBudget, int);
  ///@}

  ///@{
  /**
   * What the last update needed of a file: chunks in the file, those that the surfaces pass
   * through, and tetrahedra in these; 0 without a file.
   */
  vtkIdType GetNumberOfChunks();
  vtkIdType GetNumberOfChunksUsed();
  vtkIdType GetNumberOfTetrahedraUsed();
  ///@}

  /**
   * Bytes read from the file since it was opened; 0 without a file.
   */
  vtkTypeUInt64 GetBytesRead();

  /**
   * Modified, too, when an isovalue is.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkGatunContour();
  ~vtkGatunContour() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * Where the input comes from: what it is connected to, unless a subclass knows of algorithms in
   * between that pass it on as it is. Such a subclass gets the reader's output, too.
   */
  virtual vtkAlgorithm* FindProducer();

  int ArrayComponent = -1;
  bool ComputeNormals = false;
  bool ComputeScalars = true;
  bool OutputStrips = false;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  int MemoryBudget = 512;

private:
  vtkGatunContour(const vtkGatunContour&) = delete;
  void operator=(const vtkGatunContour&) = delete;

  class vtkInternals;
  const std::unique_ptr<vtkInternals> Internals;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
