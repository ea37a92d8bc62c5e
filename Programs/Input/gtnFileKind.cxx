// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnFileKind.h"

#include <fstream>
#include <string_view>

namespace gtn
{
namespace
{
std::string ReadStart(const std::string& file, std::size_t most)
{
  std::string bytes(most, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(most));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

bool IsNetCDFStart(std::string_view bytes)
{
  return bytes.starts_with("CDF") || bytes.starts_with("\x89HDF");
}
}

//------------------------------------------------------------------------------
bool IsNetCDF(const std::string& file)
{
  return IsNetCDFStart(ReadStart(file, 4));
}

//------------------------------------------------------------------------------
bool HasExodusContent(const std::string& file)
{
  // Dimensions come first; the tables of HDF5 are farther from the beginning.
  constexpr std::size_t enough = std::size_t{ 1 } << 20;
  if (!IsNetCDF(file))
  {
    return false;
  }
  const std::string bytes = ReadStart(file, enough);
  return bytes.find("num_dim") != bytes.npos && bytes.find("num_nodes") != bytes.npos;
}

//------------------------------------------------------------------------------
bool HasCGNSContent(const std::string& file)
{
  const std::string bytes = ReadStart(file, 8);
  // ADF has the first four characters of its name also with the highest bit set.
  return bytes.starts_with("\x89HDF") || bytes.starts_with("@(#)ADF") ||
    bytes.starts_with("\xc0\xa8\xa3\xa9"
                      "ADF");
}
}
