// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGatunPVProjection
 * @brief Renders volumes from Hartley coefficients in ParaView, with plain properties for its
 * panel.
 *
 * Differs from vtkGatunHartleyProjection in two ways. It finds the coefficients of its input
 * although ParaView puts a filter behind each source. And it has a view, color maps and opacities
 * of its own, which replace Camera and Property.
 *
 * @sa vtkGatunHartleyProjection vtkGatunHartleyEncoder vtkGatunHartleyReader
 */

#ifndef vtkGatunPVProjection_h
#define vtkGatunPVProjection_h

#include "vtkGatunHartleyProjection.h"
#include "vtkGatunParaViewModule.h" // For export macro

#include <array>  // For std::array
#include <vector> // For std::vector

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class VTKGATUNPARAVIEW_EXPORT vtkGatunPVProjection : public vtkGatunHartleyProjection
{
public:
  static vtkGatunPVProjection* New();
  vtkTypeMacro(vtkGatunPVProjection, vtkGatunHartleyProjection);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Direction of the rays in world coordinates. Any length above 0. Default: 0, 0, -1.
   */
  vtkSetVector3Macro(ViewDirection, double);
  vtkGetVector3Macro(ViewDirection, double);
  ///@}

  ///@{
  /**
   * A direction that points up in the image. Not collinear with ViewDirection. Default: 0, 1, 0.
   */
  vtkSetVector3Macro(ViewUp, double);
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * Magnification, 1e-6 to 1e6. With 1, the image shows all of the volume. Default: 1.
   */
  vtkSetClampMacro(Zoom, double, 1e-6, 1e6);
  vtkGetMacro(Zoom, double);
  ///@}

  ///@{
  /**
   * Zero of vtkGatunHartleyProjection: a value, or the smallest value of the volume if UseZero is
   * off. Defaults: 0 and off.
   */
  void SetUseZero(bool on);
  vtkGetMacro(UseZero, bool);
  vtkBooleanMacro(UseZero, bool);
  void SetZeroValue(double value);
  vtkGetMacro(ZeroValue, double);
  ///@}

  ///@{
  /**
   * Background of vtkGatunHartleyProjection: red, green and blue, 0 to 1 each, or none if
   * UseBackground is off. Defaults: 0, 0, 0 and off.
   */
  void SetUseBackground(bool on);
  vtkGetMacro(UseBackground, bool);
  vtkBooleanMacro(UseBackground, bool);
  void SetBackgroundColor(double red, double green, double blue);
  vtkGetVector3Macro(BackgroundColor, double);
  ///@}

  enum ColorMapType
  {
    MAP_GRAY = 0,
    MAP_BONE = 1, ///< for scans: brown for low values, pale for bones
    MAP_HEAT = 2,
    MAP_COOL_WARM = 3
  };

  ///@{
  /**
   * See ColorMapType. Default: MAP_BONE.
   */
  vtkSetClampMacro(ColorMap, int, MAP_GRAY, MAP_COOL_WARM);
  vtkGetMacro(ColorMap, int);
  ///@}

  ///@{
  /**
   * The range of values that colors and opacities are mapped to. If the second value is not larger
   * than the first, the range of the volume. Default: 0, 0.
   */
  vtkSetVector2Macro(ValueRange, double);
  vtkGetVector2Macro(ValueRange, double);
  ///@}

  ///@{
  /**
   * Opacities by position: 0 is the first value of the range, 1 the last. Without points, the
   * opacity rises linearly from 0 to 1. Default: none.
   */
  void SetNumberOfOpacityPoints(int number);
  int GetNumberOfOpacityPoints();
  void SetOpacityPoint(int index, double position, double opacity);
  ///@}

  ///@{
  /**
   * The length of a ray that opacities refer to, in hundredths of the volume's diagonal: 1e-6 to
   * 1e6. Default: 1.
   */
  vtkSetClampMacro(OpacityUnit, double, 1e-6, 1e6);
  vtkGetMacro(OpacityUnit, double);
  ///@}

protected:
  vtkGatunPVProjection();
  ~vtkGatunPVProjection() override;

  vtkInformation* GetCoefficientsInformation() override;
  vtkSmartPointer<vtkCamera> MakeCamera(const double center[3], double parallelScale) override;
  vtkSmartPointer<vtkVolumeProperty> MakeProperty(const double range[2], double diagonal) override;

  double ViewDirection[3] = { 0, 0, -1 };
  double ViewUp[3] = { 0, 1, 0 };
  double Zoom = 1;
  bool UseZero = false;
  double ZeroValue = 0;
  bool UseBackground = false;
  double BackgroundColor[3] = { 0, 0, 0 };

  int ColorMap = MAP_BONE;
  double ValueRange[2] = { 0, 0 };
  double OpacityUnit = 1;
  std::vector<std::array<double, 2>> OpacityPoints;

private:
  vtkGatunPVProjection(const vtkGatunPVProjection&) = delete;
  void operator=(const vtkGatunPVProjection&) = delete;

  void UpdateZero();
  void UpdateBackground();
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

#endif
