// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunVolumeProp.h"

#include "vtkGatunHartleyMapper.h"
#include "vtkGatunVolumeMapper.h"

#include "vtkLODProp3D.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"

namespace gatun
{
namespace
{
class VolumeProp final : public vtkPVLODVolume
{
public:
  static VolumeProp* New();
  vtkTypeMacro(VolumeProp, vtkPVLODVolume);
  VolumeProp(const VolumeProp&) = delete;
  VolumeProp& operator=(const VolumeProp&) = delete;

  int RenderVolumetricGeometry(vtkViewport* viewport) override
  {
    auto* const mapper = vtkGatunVolumeMapper::SafeDownCast(this->GetMapper());
    const bool needsNoScalars =
      vtkGatunHartleyMapper::SafeDownCast(this->GetMapper()) || (mapper && mapper->GetController());
    if (!needsNoScalars || this->EnableLOD)
    {
      return this->Superclass::RenderVolumetricGeometry(viewport);
    }
    const int drawn = this->LODProp->RenderVolumetricGeometry(viewport);
    this->EstimatedRenderTime = this->LODProp->GetEstimatedRenderTime();
    return drawn;
  }

protected:
  VolumeProp() = default;
  ~VolumeProp() override = default;
};

vtkStandardNewMacro(VolumeProp);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPVLODVolume> MakeVolumeProp()
{
  return vtk::TakeSmartPointer(VolumeProp::New());
}
}
