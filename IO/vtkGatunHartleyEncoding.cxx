// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunHartleyEncoding.h"

#include "gatunHartleyLayout.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

vtkStandardNewMacro(vtkGatunHartleyEncoding);

//------------------------------------------------------------------------------
void vtkGatunHartleyEncoding::SetBlockSize(int size)
{
  constexpr int smallest = gatun::HartleyLayout::SmallestBlock;
  constexpr int largest = gatun::HartleyLayout::LargestBlock;
  const int clamped = size <= 0 ? 0 : std::clamp(size, smallest, largest);
  if (clamped != this->BlockSize)
  {
    this->BlockSize = clamped;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGatunHartleyEncoding::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  constexpr std::array<const char*, 4> modes{ "Quality", "RMSError", "PSNR", "BitsPerVoxel" };
  os << indent << "BlockSize: " << this->BlockSize << "\n";
  os << indent << "RateControl: " << modes.at(static_cast<std::size_t>(this->RateControl)) << "\n";
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "RMSError: " << this->RMSError << "\n";
  os << indent << "PSNR: " << this->PSNR << "\n";
  os << indent << "BitsPerVoxel: " << this->BitsPerVoxel << "\n";
  os << indent << "FrequencyWeight: " << this->FrequencyWeight << "\n";
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
