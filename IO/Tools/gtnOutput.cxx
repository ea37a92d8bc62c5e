// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnOutput.h"

#include "gtnFailure.h"
#include "gtnText.h"

#include <fmt/core.h>

#include <filesystem>
#include <random>
#include <system_error>

namespace gtn
{
//------------------------------------------------------------------------------
void CheckWritable(const std::string& file, bool overwrite)
{
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
  {
    throw Failure(file, "is a folder");
  }
  if (!overwrite && std::filesystem::exists(file, error))
  {
    throw Failure(file, "exists; give -f to replace it");
  }
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, error))
  {
    throw Failure(file, "there is no folder " + folder.string());
  }
}

//------------------------------------------------------------------------------
TemporaryFile::TemporaryFile(const std::string& file)
  : File(file)
{
  std::random_device random;
  const std::filesystem::path path(file);
  this->Name = (path.parent_path() /
    fmt::format("{}.{:08x}{}", path.stem().string(), random(), path.extension().string()))
                 .string();
}

//------------------------------------------------------------------------------
TemporaryFile::~TemporaryFile()
{
  if (!this->Name.empty())
  {
    std::error_code ignored;
    std::filesystem::remove(this->Name, ignored);
  }
}

//------------------------------------------------------------------------------
void TemporaryFile::Commit()
{
  std::error_code error;
  std::filesystem::rename(this->Name, this->File, error);
  if (error)
  {
    throw Failure(this->File, error.message());
  }
  this->Name.clear();
}
}
