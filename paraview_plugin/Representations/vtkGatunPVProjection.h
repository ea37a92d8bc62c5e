// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunPVProjection
 * @brief Pictures of Hartley volumes in ParaView, with colours that its panels can set.
 *
 * As vtkHartleyProjection, but it knows a reader of .ghv files also where ParaView puts something
 * in between, and has colour maps and opacities of its own.
 *
 * @sa vtkHartleyProjection vtkHartleyVolumeReader
 */

#ifndef vtkGatunPVProjection_h
#define vtkGatunPVProjection_h

#include "vtkGatunParaViewModule.h" // For export macro
#include "vtkHartleyProjection.h"

#include <array>  // For std::array
#include <vector> // For std::vector

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKGATUNPARAVIEW_EXPORT vtkGatunPVProjection : public vtkHartleyProjection
{
public:
  static vtkGatunPVProjection* New();
  vtkTypeMacro(vtkGatunPVProjection, vtkHartleyProjection);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ColorMapType
  {
    MAP_GREY = 0,
    MAP_BONE = 1, ///< of a scan: brown shadows, pale bones
    MAP_HEAT = 2,
    MAP_COOL_WARM = 3
  };

  ///@{
  /**
   * See ColorMapType. Default: MAP_BONE.
   */
  vtkSetClampMacro(ColorMap, int, MAP_GREY, MAP_COOL_WARM);
  vtkGetMacro(ColorMap, int);
  ///@}

  ///@{
  /**
   * The values that colours and opacities are spread over; if the second one is not larger, those
   * of the volume. Default: 0, 0.
   */
  vtkSetVector2Macro(ValueRange, double);
  vtkGetVector2Macro(ValueRange, double);
  ///@}

  ///@{
  /**
   * Opacities, by position: 0 is the first value of the range, 1 the last one. Without any, they
   * rise evenly from 0 to 1. Default: none.
   */
  void SetNumberOfOpacityPoints(int number);
  int GetNumberOfOpacityPoints();
  void SetOpacityPoint(int index, double position, double opacity);
  ///@}

  ///@{
  /**
   * Opacities are those of so many hundredths of the volume's diagonal. Default: 1.
   */
  vtkSetClampMacro(OpacityUnit, double, 1e-6, 1e6);
  vtkGetMacro(OpacityUnit, double);
  ///@}

protected:
  vtkGatunPVProjection();
  ~vtkGatunPVProjection() override;

  vtkAlgorithm* FindProducer() override;
  void FillDefaultProperty(
    vtkVolumeProperty* property, const double range[2], double diagonal) override;

  int ColorMap = MAP_BONE;
  double ValueRange[2] = { 0, 0 };
  double OpacityUnit = 1;
  std::vector<std::array<double, 2>> OpacityPoints;

private:
  vtkGatunPVProjection(const vtkGatunPVProjection&) = delete;
  void operator=(const vtkGatunPVProjection&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
