// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunDetailSettings_h
#define gatunDetailSettings_h

#include "gatunDetailView.h"

#include "vtkIOStream.h"
#include "vtkIndent.h"

#include <array>
#include <memory>

namespace gatun
{
/** The properties of vtkGatunVolumeMapper and vtkGatunRayCaster that say where detail is needed. */
struct DetailSettings
{
  double PixelError = 0;
  const double* Bounds = nullptr; ///< 6
  const double* Center = nullptr; ///< 3
  double Radius = 0;
  const double* Range = nullptr; ///< 2

  /** Whether an image at rest depends on the view. */
  bool IsForRest() const;

  /** Prints the properties, for PrintSelf. */
  void Print(ostream& os, vtkIndent indent) const;
};

/** The region of the settings. Throws InvalidInput if a number is NaN. */
DetailRegion MakeDetailRegion(const DetailSettings& settings);

/** What an image needs of a mesh. View: with a ray for each pixel. */
std::shared_ptr<const DetailView> MakeDetailView(
  const DetailSettings& settings, const RayView& view, RayTable table);
}

#endif
