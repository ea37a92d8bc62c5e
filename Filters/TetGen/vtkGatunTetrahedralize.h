// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunTetrahedralize
 * @brief Fills a closed surface (vtkPolyData) with tetrahedra (vtkUnstructuredGrid) by TetGen.
 *
 * Input: polygons and strips, of which triangles are made; lines and vertices are ignored, and so
 * are points that lie exactly on each other (they are merged) and triangles that thereby lose a
 * corner. The surface must be closed: each edge in exactly two triangles, and must not cut itself.
 * The sense of the triangles does not matter. A surface inside another one bounds a cavity, a
 * third one in that cavity a solid again, and so on.
 *
 * Output: tetrahedra of positive volume with 64-bit ids. The points of the surface come first, in
 * the order in which the cleaned input has them, with the very same coordinates; then those that
 * TetGen adds, on the surface (see PreserveSurface) and inside. Coordinates are of the type of the
 * input's, or as OutputPointsPrecision says. Arrays of the surface are not carried over.
 *
 * An error (no output, an error code, a message) is reported for an empty surface, one that is
 * open, non-manifold or not finite, one that cuts itself, and when TetGen gives up.
 *
 * Cost: one thread; some 400 bytes and 3 to 10 microseconds a tetrahedron.
 *
 * @warning A program that ships with this library is subject to the GNU Affero General Public
 * License, version 3, because TetGen is. No other part of Gatun uses TetGen.
 *
 * TetGen runs in a process of its own (where the system has fork), so that whatever happens to it
 * does not happen to the caller, and abort works at once. Elsewhere its failures may be fatal.
 *
 * @warning A very high quality may make TetGen run until the memory is full. See Quality and
 * MinDihedral for what is known to end.
 *
 * @par Background
 * Hang Si: "TetGen, a Delaunay-Based Quality Tetrahedral Mesh Generator". ACM Transactions on
 * Mathematical Software 41(2), article 11, 2015.
 *
 * @sa vtkDelaunay3D, vtkGatunWriter
 */

#ifndef vtkGatunTetrahedralize_h
#define vtkGatunTetrahedralize_h

#include "vtkGatunTetGenModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

class VTKGATUNTETGEN_EXPORT vtkGatunTetrahedralize : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkGatunTetrahedralize* New();
  vtkTypeMacro(vtkGatunTetrahedralize, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Largest ratio of circumradius to shortest edge that a tetrahedron may have; smaller is better
   * and makes more tetrahedra. 0: no points are added for quality. Otherwise 1 to 100, below 1.2
   * TetGen may not end. Sharp corners of the surface limit what can be reached. Default: 1.414.
   */
  vtkSetClampMacro(Quality, double, 0.0, 100.0);
  vtkGetMacro(Quality, double);
  ///@}

  ///@{
  /**
   * Smallest dihedral angle to aim at, in degrees, 0 (do not) to 30; above 18 TetGen may not end.
   * Default: 0.
   */
  vtkSetClampMacro(MinDihedral, double, 0.0, 30.0);
  vtkGetMacro(MinDihedral, double);
  ///@}

  ///@{
  /**
   * Largest volume of a tetrahedron, in cubic units of the surface, 0 for no limit. Default: 0.
   */
  vtkSetClampMacro(MaximumVolume, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumVolume, double);
  ///@}

  ///@{
  /**
   * Whether the triangles of the surface must be faces of the mesh as they are, so that points are
   * only added inside. Quality then suffers where the surface is coarse. Default: off, which lets
   * TetGen split triangles; the surface keeps its shape either way.
   */
  vtkSetMacro(PreserveSurface, bool);
  vtkGetMacro(PreserveSurface, bool);
  vtkBooleanMacro(PreserveSurface, bool);
  ///@}

  ///@{
  /**
   * Switches for TetGen besides those made of the properties, such as "O4" or "S100000": letters,
   * digits and any of "./-+". They come last, so they win. Switches that change what is put out
   * (such as "o2" for quadratic tetrahedra) are an error. Default: none.
   */
  vtkSetStringMacro(Switches);
  vtkGetStringMacro(Switches);
  ///@}

  ///@{
  /**
   * Whether TetGen is to keep silent, rather than to print what it does on the standard output.
   * Default: on.
   */
  vtkSetMacro(Quiet, bool);
  vtkGetMacro(Quiet, bool);
  vtkBooleanMacro(Quiet, bool);
  ///@}

  ///@{
  /**
   * vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION, or DEFAULT_PRECISION: as the input's.
   * TetGen computes in double; rounding to single may flatten the smallest tetrahedra of a very
   * fine mesh. Default: DEFAULT_PRECISION.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

protected:
  vtkGatunTetrahedralize();
  ~vtkGatunTetrahedralize() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Quality = 1.414;
  double MinDihedral = 0;
  double MaximumVolume = 0;
  bool PreserveSurface = false;
  char* Switches = nullptr;
  bool Quiet = true;
  int OutputPointsPrecision = DEFAULT_PRECISION;

private:
  vtkGatunTetrahedralize(const vtkGatunTetrahedralize&) = delete;
  void operator=(const vtkGatunTetrahedralize&) = delete;
};

#endif
