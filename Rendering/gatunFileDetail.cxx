// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFileDetail.h"

#include "gatunFileLevelsOfDetail.h"
#include "gatunFileReader.h"

namespace gatun
{
//------------------------------------------------------------------------------
bool HasDetail(const FileReader& file)
{
  return file.HasMergeTree();
}

//------------------------------------------------------------------------------
std::shared_ptr<LevelsOfDetail> MakeFileDetail(
  std::shared_ptr<const FileReader> file, const RayValues& values, const RaySource::Progress&)
{
  return std::make_shared<FileLevelsOfDetail>(std::move(file), values);
}
}
