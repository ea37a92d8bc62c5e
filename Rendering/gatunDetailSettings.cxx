// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunDetailSettings.h"

#include "gatunRayRendering.h"

namespace gatun
{
//------------------------------------------------------------------------------
bool DetailSettings::IsForRest() const
{
  return this->PixelError > 0 || MakeDetailRegion(*this) != DetailRegion{};
}

//------------------------------------------------------------------------------
void DetailSettings::Print(ostream& os, vtkIndent indent) const
{
  const auto list = [&](const char* name, const double* numbers, int count)
  {
    os << indent << name << ":";
    for (int i = 0; i < count; ++i)
    {
      os << " " << numbers[i];
    }
    os << "\n";
  };
  os << indent << "PixelError: " << this->PixelError << "\n";
  list("DetailBounds", this->Bounds, 6);
  list("DetailCenter", this->Center, 3);
  os << indent << "DetailRadius: " << this->Radius << "\n";
  list("DetailRange", this->Range, 2);
}

//------------------------------------------------------------------------------
DetailRegion MakeDetailRegion(const DetailSettings& settings)
{
  DetailRegion region;
  gatun::Bounds box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    RequireNumber("DetailBounds", settings.Bounds[2 * axis]);
    RequireNumber("DetailBounds", settings.Bounds[2 * axis + 1]);
    RequireNumber("DetailCenter", settings.Center[axis]);
    box[axis] = { settings.Bounds[2 * axis], settings.Bounds[2 * axis + 1] };
  }
  RequireNumber("DetailRadius", settings.Radius);
  RequireNumber("DetailRange", settings.Range[0]);
  RequireNumber("DetailRange", settings.Range[1]);
  if (!box.IsEmpty())
  {
    region.Box = box;
  }
  if (settings.Radius > 0)
  {
    region.Sphere = DetailSphere{ { settings.Center[0], settings.Center[1], settings.Center[2] },
      settings.Radius };
  }
  const gatun::Range values{ settings.Range[0], settings.Range[1] };
  if (!values.IsEmpty())
  {
    region.Values = values;
  }
  return region;
}

//------------------------------------------------------------------------------
std::shared_ptr<const DetailView> MakeDetailView(
  const DetailSettings& settings, const RayView& view, RayTable table)
{
  return std::make_shared<const DetailView>(DetailView{ view, settings.PixelError,
    MakeDetailRegion(settings), std::make_shared<const RayTable>(std::move(table)) });
}
}
