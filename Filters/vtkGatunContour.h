// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunContour
 * @brief Isosurfaces of a tetrahedral mesh, from memory or directly from a compressed file.
 *
 * Input: a vtkUnstructuredGrid with point scalars of any numeric type. Tetrahedra are used as they
 * are. Other 3D cells are split into tetrahedra (Documentation/cells.md), nonlinear ones without
 * the points between their corners. Cells of a lower dimension and ghost cells are left out.
 * SetInputArrayToProcess selects the array; the default is the active point scalars. For arrays
 * with several components see ArrayComponent.
 *
 * *From a file.* If the input is the output of a vtkGatunReader without a region of interest, the
 * filter finds a vtkGatunFileHandle in the information of its input and makes the surface from the
 * file. It reads only the chunks whose range of values contains an isovalue, and decodes them one
 * after the other on each thread. The reader is not asked for the mesh: unless it already has one,
 * its output is an empty piece afterwards, until another piece is requested
 * (vtkAlgorithm::UpdatePiece). Files with layers of the array (vtkGatunWriter::LayerArray) have the
 * fewest such chunks. If the reader simplifies, the surface is that of the simplified mesh. Time
 * steps and the selection of arrays are those of the reader, too.
 *
 * Output: a vtkPolyData of triangles or of triangle strips, with ids of 32 bits where they suffice.
 * All point arrays are interpolated, and cell arrays are passed to the triangles. Global ids are
 * left out, and so are pedigree ids and arrays of vtkIdType on the points. Points with the same
 * coordinates are merged.
 *
 * The triangles are those of vtkContourGrid, except that the front of every triangle faces lower
 * values, as the normals do. Triangles of vtkContourGrid face higher values in left-handed
 * tetrahedra. A corner whose value is the isovalue counts as above it. Triangles with two corners
 * in one point are left out. Where a field is constant at the isovalue there is no surface, nor in
 * tetrahedra with a value that is NaN or infinite. The triangles have the order of the tetrahedra,
 * whatever the number of threads.
 *
 * *Pieces.* Of a file, each piece takes its share of the chunks that the surface passes through.
 * Other inputs are asked for the same piece and, with normals, for a level of ghost cells, so that
 * normals have no seams between pieces.
 *
 * *Cost.* From a file: time in proportion to the chunks that are read; memory for about twice the
 * surface and a chunk for each thread. Decoded chunks are kept within the memory budget of the
 * reader, so that other isovalues need not decode them again. If that budget is small, shared
 * points take up to 32 MiB more (64 MiB for simplified meshes) while the surface is made. All
 * threads are used.
 *
 * *Errors.* A missing array, a component that does not exist, isovalues that are not finite, cells
 * that cannot be converted to tetrahedra and damaged files are reported by vtkErrorMacro and
 * GetErrorCode (with the codes of vtkGatunReader). The output is then empty.
 *
 * @par Background
 * C. Yang: On-the-fly processing of compressed volume data, 2001 (layers of values). P. Cignoni, P.
 * Marino, C. Montani, E. Puppo, R. Scopigno: Speeding up isosurface extraction using interval
 * trees. IEEE Transactions on Visualization and Computer Graphics 3(2), 1997.
 *
 * @warning With OutputStrips there are no cell arrays, since a strip passes through many cells.
 *
 * @sa vtkGatunReader vtkGatunFileHandle vtkContourGrid vtkContour3DLinearGrid
 */

#ifndef vtkGatunContour_h
#define vtkGatunContour_h

#include "vtkGatunFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For std::unique_ptr

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkTable;

class VTKGATUNFILTERS_EXPORT vtkGatunContour : public vtkPolyDataAlgorithm
{
public:
  static vtkGatunContour* New();
  vtkTypeMacro(vtkGatunContour, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Isovalues, in the units of the array, by index from 0; in any order. Equal ones count once. NaN
   * and infinite values are an error. Default: none.
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
   * Component of the array, from 0. -1 is the length of the tuple, or the value of an array of one
   * component. The number of components is the length, too, as in ParaView. Default: -1.
   */
  vtkSetClampMacro(ArrayComponent, int, -1, VTK_INT_MAX);
  vtkGetMacro(ArrayComponent, int);
  ///@}

  ///@{
  /**
   * Whether to make a point array "Normals" (float), of unit vectors towards lower values: the mean
   * of the gradients of the tetrahedra around the edge that the point is on, weighted by their
   * volumes; at a mesh point with exactly the isovalue, the mean over the tetrahedra that the
   * surface cuts, once per edge. Default: off.
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

  /**
   * Statistics of the last update from a file, in the columns of a table of one row; zeros without
   * a file.
   *
   *  - Chunks: chunks in the file.
   *  - UsedChunks: of these, those that the surfaces pass through.
   *  - UsedTetrahedra: tetrahedra in the chunks used.
   *  - BytesRead: bytes that the reader and all its consumers have read since the file was opened.
   *
   * The next call returns another table.
   */
  vtkTable* GetStatistics();

  /**
   * Includes the time of the isovalues.
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
   * The information that may have a vtkGatunFileHandle: that of the input. Subclasses that know of
   * algorithms in between that pass on the mesh unchanged may return another one.
   */
  virtual vtkInformation* GetFileInformation(vtkInformation* inInfo);

  int ArrayComponent = -1;
  bool ComputeNormals = false;
  bool ComputeScalars = true;
  bool OutputStrips = false;
  int OutputPointsPrecision = DEFAULT_PRECISION;

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
