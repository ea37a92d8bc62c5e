// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunVolumeFrame_h
#define gatunVolumeFrame_h

#include "gatunDetailSettings.h"
#include "gatunDetailView.h"
#include "gatunRayCaster.h"
#include "gatunRayRendering.h"

#include "vtkNew.h"

#include <memory>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkFloatArray;
class vtkMatrix4x4;
class vtkPlaneCollection;
class vtkRenderer;
class vtkVolume;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
/** The properties of a volume mapper that determine its images. */
struct VolumeSettings
{
  RayMode Mode = RayMode::Composite;
  double OpacityLimit = 0;
  bool Intermixes = true;                       ///< with opaque geometry
  vtkPlaneCollection* ClippingPlanes = nullptr; ///< null for none
  DetailSettings Detail;

  // Of rays, in pixels.
  bool AdjustsDistance = true;
  float Distance = 1; ///< if it is not adjusted
  float LeastDistance = 1;
  float LargestDistance = 1;
};

/** The part of a window that a renderer draws into, in pixels. */
struct Viewport
{
  int Width = 0;
  int Height = 0;
  int X = 0;
  int Y = 0;

  explicit Viewport(vtkRenderer* renderer);

  bool IsEmpty() const { return this->Width <= 0 || this->Height <= 0; }
};

/** All that an image depends on except the number of points. */
struct ImageSetup
{
  const void* Mesh;
  const void* Renderer;
  const void* Volume;
  RayView View;
  RayTable Table;
  RayLimits Limits;
  RaySettings Settings;

  bool operator==(const ImageSetup&) const = default;
};

/** One image of a volume. Methods throw gatun::Error. */
class VolumeFrame
{
public:
  VolumeFrame(vtkRenderer* renderer, vtkVolume* volume, const VolumeSettings& settings);
  ~VolumeFrame();
  VolumeFrame(const VolumeFrame&) = delete;
  VolumeFrame& operator=(const VolumeFrame&) = delete;

  vtkRenderer* GetRenderer() const { return this->Renderer; }
  vtkVolume* GetVolume() const { return this->Volume; }
  const VolumeSettings& GetSettings() const { return this->Settings; }
  const Viewport& GetViewport() const { return this->Port; }

  /** The rays with a distance between them, in pixels. */
  RayGrid MakeGrid(float distance) const;
  RayView MakeView(const RayGrid& grid) const;

  /** What the image needs of a mesh with values in a range. */
  std::shared_ptr<const DetailView> MakeDetailView(const Range& values) const;

  /** All but the limits that geometry sets. Mesh: compared only. */
  ImageSetup MakeSetup(const void* mesh, const RayView& view, const Range& values) const;

  /** The depths in the viewport of what was drawn before. */
  void ReadDepths(vtkFloatArray* depths) const;

private:
  vtkRenderer* Renderer;
  vtkVolume* Volume;
  VolumeSettings Settings;
  Viewport Port;
  vtkNew<vtkMatrix4x4> Matrix;
};
}

#endif
