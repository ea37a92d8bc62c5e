// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunTetrahedralize
 * @brief Fills a closed surface (vtkPolyData) with tetrahedra (vtkUnstructuredGrid) by TetGen.
 *
 * Input: polygons and strips, which are split into triangles. Lines and vertices are ignored.
 * Coincident points are merged, and triangles that lose a corner by that are dropped. The surface
 * must be closed, with each edge in exactly two triangles, and must not intersect itself. The
 * orientation of the triangles does not matter. A surface inside another one bounds a cavity, a
 * third one in that cavity a solid again, and so on.
 *
 * Output: tetrahedra of positive volume with 64-bit ids. The points of the surface come first, in
 * the order of the cleaned input and with the same coordinates, followed by the points that TetGen
 * adds on the surface (see PreserveSurface) and inside. Coordinates have the type of the input, or
 * the type given by OutputPointsPrecision. Arrays of the surface are not passed on.
 *
 * *Errors.* A surface that is empty, open, non-manifold, not finite or intersects itself, and a
 * failure of TetGen are reported by vtkErrorMacro and GetErrorCode. The output is then empty.
 *
 * *Cost.* One thread; about 400 bytes and 3 to 10 microseconds a tetrahedron.
 *
 * TetGen runs in a process of its own. A crash of TetGen does not affect the caller, and an abort
 * takes effect at once.
 *
 * @warning A program that ships with this library is subject to the GNU Affero General Public
 * License, version 3, because TetGen is. No other part of Gatun uses TetGen.
 *
 * @warning A very high quality may make TetGen run until the memory is full. See Quality and
 * MinDihedral for safe values.
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

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKGATUNTETGEN_EXPORT vtkGatunTetrahedralize : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkGatunTetrahedralize* New();
  vtkTypeMacro(vtkGatunTetrahedralize, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Largest ratio of circumradius to shortest edge of a tetrahedron, 0 or 1 to 100. A smaller ratio
   * gives better and more tetrahedra. 0: no points are added for quality. Values between 0 and 1
   * are an error; below 1.2 TetGen may not end. Sharp corners of the surface limit the quality.
   * Default: 1.414.
   */
  vtkSetClampMacro(Quality, double, 0.0, 100.0);
  vtkGetMacro(Quality, double);
  ///@}

  ///@{
  /**
   * Target for the smallest dihedral angle, in degrees, 0 (none) to 30. Above 18 TetGen may not
   * end. Default: 0.
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
   * Whether the triangles of the surface are faces of the mesh, so that points are added inside
   * only. The quality is then lower where the surface is coarse. Off: TetGen may split triangles;
   * the shape of the surface does not change. Default: off.
   */
  vtkSetMacro(PreserveSurface, bool);
  vtkGetMacro(PreserveSurface, bool);
  vtkBooleanMacro(PreserveSurface, bool);
  ///@}

  ///@{
  /**
   * Switches for TetGen in addition to those of the properties, such as "O4" or "S100000": letters,
   * digits and any of "./-+". They come last and take precedence. Switches that change the output,
   * such as "o2" for quadratic tetrahedra, are an error. Default: none.
   */
  vtkSetStringMacro(Switches);
  vtkGetStringMacro(Switches);
  ///@}

  ///@{
  /**
   * Whether TetGen prints nothing on the standard output. Default: on.
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

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
