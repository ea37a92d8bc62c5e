// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnReadable.h"

#include "gtnFailure.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace gtn
{
void CheckReadable(const std::string& file)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found)
  {
    throw Failure(file, "no such file");
  }
  if (error)
  {
    throw Failure(file, error.message());
  }
  if (std::filesystem::is_directory(status))
  {
    throw Failure(file, "is a folder");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
  {
    throw Failure(file, std::strerror(errno));
  }
  const bool isMark = std::filesystem::path(file).extension() == ".foam";
  if (!isMark && stream.peek() == std::ifstream::traits_type::eof())
  {
    throw Failure(file, "is empty");
  }
}
}
