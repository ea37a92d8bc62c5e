// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFileDetail.h"

namespace gatun
{
//------------------------------------------------------------------------------
bool HasDetail(const FileReader&)
{
  return false;
}

//------------------------------------------------------------------------------
std::shared_ptr<RayDetail> MakeFileDetail(
  std::shared_ptr<const FileReader>, const RayValues&, const RaySource::Progress&)
{
  return nullptr;
}
}
