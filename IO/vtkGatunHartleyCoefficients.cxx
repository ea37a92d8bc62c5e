// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunHartleyCoefficients.h"

#include "gatunHartleyInput.h"
#include "gatunHartleySource.h"

#include "vtkInformationObjectBaseKey.h"
#include "vtkObjectFactory.h"

#include <utility>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunHartleyCoefficients);
vtkInformationKeyRestrictedMacro(
  vtkGatunHartleyCoefficients, COEFFICIENTS, ObjectBase, "vtkGatunHartleyCoefficients");

//------------------------------------------------------------------------------
class vtkGatunHartleyCoefficients::vtkInternals
{
public:
  std::shared_ptr<const gatun::HartleySource> Source;
  gatun::VolumeInput Volume;
};

//------------------------------------------------------------------------------
vtkGatunHartleyCoefficients::vtkGatunHartleyCoefficients()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkGatunHartleyCoefficients::~vtkGatunHartleyCoefficients() = default;

//------------------------------------------------------------------------------
const char* vtkGatunHartleyCoefficients::GetArrayName()
{
  return this->Internals->Volume.Name.c_str();
}

//------------------------------------------------------------------------------
int vtkGatunHartleyCoefficients::GetBlockSize()
{
  const auto& source = this->Internals->Source;
  return source && !source->GetLayout().IsWhole() ? static_cast<int>(source->GetLayout().Block[0])
                                                  : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunHartleyCoefficients::GetNumberOfBlocks()
{
  const auto& source = this->Internals->Source;
  return source ? static_cast<vtkIdType>(source->GetLayout().GetNumberOfBlocks()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkGatunHartleyCoefficients::GetNumberOfChunks()
{
  const auto& source = this->Internals->Source;
  return source ? static_cast<vtkIdType>(source->GetLayout().GetNumberOfChunks()) : 0;
}

//------------------------------------------------------------------------------
void vtkGatunHartleyCoefficients::GetRange(double range[2])
{
  const auto& source = this->Internals->Source;
  range[0] = source ? source->GetRange().Min : 0;
  range[1] = source ? source->GetRange().Max : 0;
}

//------------------------------------------------------------------------------
void vtkGatunHartleyCoefficients::SetSource(
  std::shared_ptr<const gatun::HartleySource> source, const gatun::VolumeInput& volume)
{
  this->Internals->Source = std::move(source);
  this->Internals->Volume = volume;
  this->Internals->Volume.Values = nullptr;
  this->Modified();
}

//------------------------------------------------------------------------------
const std::shared_ptr<const gatun::HartleySource>& vtkGatunHartleyCoefficients::GetSource() const
{
  return this->Internals->Source;
}

//------------------------------------------------------------------------------
const gatun::VolumeInput& vtkGatunHartleyCoefficients::GetVolume() const
{
  return this->Internals->Volume;
}

//------------------------------------------------------------------------------
void vtkGatunHartleyCoefficients::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->GetArrayName() << "\n";
  os << indent << "BlockSize: " << this->GetBlockSize() << "\n";
  os << indent << "NumberOfBlocks: " << this->GetNumberOfBlocks() << "\n";
  os << indent << "NumberOfChunks: " << this->GetNumberOfChunks() << "\n";
}
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
