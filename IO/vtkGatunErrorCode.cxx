// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGatunErrorCode.h"

#include "gatunError.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

namespace
{

constexpr int CodeOf(gatun::ErrorCode code)
{
  return vtkErrorCode::UserError + static_cast<int>(code);
}

// gatun::DescribeFailure makes the codes by this rule.
static_assert(
  vtkGatunErrorCode::UnsupportedVersionError == CodeOf(gatun::ErrorCode::UnsupportedVersion));
static_assert(vtkGatunErrorCode::InvalidInputError == CodeOf(gatun::ErrorCode::InvalidInput));
static_assert(vtkGatunErrorCode::AbortedError == CodeOf(gatun::ErrorCode::Aborted));

} // anonymous namespace

//------------------------------------------------------------------------------
const char* vtkGatunErrorCode::GetStringFromErrorCode(unsigned long error)
{
  switch (error)
  {
    case UnsupportedVersionError:
      return "UnsupportedVersionError";
    case InvalidInputError:
      return "InvalidInputError";
    case AbortedError:
      return "AbortedError";
    default:
      return vtkErrorCode::GetStringFromErrorCode(error);
  }
}

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
