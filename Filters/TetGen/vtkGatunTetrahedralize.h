// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunTetrahedralize
 * @brief Generates a tetrahedral mesh inside a closed surface by TetGen.
 *
 * Input: a vtkPolyData with polygons or triangle strips, which are triangulated. Lines and vertices
 * are ignored. Coincident points are merged, and triangles that become degenerate by that are
 * dropped. The surface must be closed, that is, each edge belongs to exactly two triangles, and
 * free of self-intersections. The orientation of the triangles does not matter. Components may be
 * nested: a surface inside another one bounds a cavity, a surface inside that cavity bounds a
 * solid, and so on.
 *
 * Output: a vtkUnstructuredGrid of tetrahedra with positive volume and 64-bit ids. The points of
 * the cleaned input come first, in their order and with unchanged coordinates. They are followed by
 * the points that TetGen adds on the surface (see PreserveSurface) and inside. The coordinate type
 * is that of the input unless OutputPointsPrecision asks for another. Arrays of the surface are not
 * carried over.
 *
 * Errors: the filter sets an error code, reports a message and leaves the output empty if the
 * surface is empty, open, non-manifold, self-intersecting or has coordinates that are not finite,
 * and if TetGen fails.
 *
 * Cost: one thread, about 400 bytes and 3 to 10 microseconds per tetrahedron.
 *
 * TetGen runs in a program of its own, `gatun-tetgen` in the folder `gatun` next to this library,
 * so that a crash does not affect the caller and an abort takes effect at once. If that program
 * cannot be started, the filter fails.
 *
 * @warning That program links TetGen, so that the GNU Affero General Public License, version 3 or
 * later, covers it as a whole. This library does not link TetGen, nor does any other part of Gatun.
 *
 * @warning With very strict quality bounds TetGen may run until memory is exhausted. See Quality
 * and MinDihedral for bounds that are known to terminate.
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
   * Largest allowed ratio of circumradius to shortest edge, from 1 to 100, or 0 to add no points
   * for quality. Smaller values give better and more tetrahedra. TetGen may not terminate
   * below 1.2. Sharp corners of the surface limit the quality that can be reached. Default: 1.414.
   */
  vtkSetClampMacro(Quality, double, 0.0, 100.0);
  vtkGetMacro(Quality, double);
  ///@}

  ///@{
  /**
   * Smallest dihedral angle to aim at, in degrees, from 0 (no bound) to 30. TetGen may not
   * terminate above 18. Default: 0.
   */
  vtkSetClampMacro(MinDihedral, double, 0.0, 30.0);
  vtkGetMacro(MinDihedral, double);
  ///@}

  ///@{
  /**
   * Largest volume of a tetrahedron, in cubic units of the surface; 0 for no limit. Default: 0.
   * Some become larger when TetGen moves points in the end, with TetGen 1.6 up to a half.
   */
  vtkSetClampMacro(MaximumVolume, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumVolume, double);
  ///@}

  ///@{
  /**
   * Keep the triangles of the surface as faces of the mesh, so that points are added inside only.
   * This costs quality where the surface is coarse. If off, TetGen may split triangles; the shape
   * of the surface does not change. Default: off.
   */
  vtkSetMacro(PreserveSurface, bool);
  vtkGetMacro(PreserveSurface, bool);
  vtkBooleanMacro(PreserveSurface, bool);
  ///@}

  ///@{
  /**
   * Additional TetGen switches, such as "O4" or "S100000": letters, digits and any of "./-+". They
   * take precedence over the properties. Switches that change the kind of output, such as "o2" for
   * quadratic tetrahedra, are an error. Default: none.
   */
  vtkSetStringMacro(Switches);
  vtkGetStringMacro(Switches);
  ///@}

  ///@{
  /**
   * Suppress the messages that TetGen prints to standard output. Default: on.
   */
  vtkSetMacro(Quiet, bool);
  vtkGetMacro(Quiet, bool);
  vtkBooleanMacro(Quiet, bool);
  ///@}

  ///@{
  /**
   * Precision of the output points: vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION, or
   * DEFAULT_PRECISION for that of the input. TetGen computes in double precision; rounding to
   * single precision may flatten the smallest tetrahedra of a very fine mesh. Default:
   * DEFAULT_PRECISION.
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
