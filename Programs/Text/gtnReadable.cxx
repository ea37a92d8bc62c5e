// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnReadable.h"

#include "gtnFailure.h"
#include "gtnText.h"

#include "gatunByteSource.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

namespace gtn
{
namespace
{
constexpr std::string_view LFSStart = "version https://git-lfs.github.com/spec/";

/** The first or last bytes of a file. */
std::string ReadEnd(const std::string& file, std::streamoff most, bool last)
{
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream ? static_cast<std::streamoff>(stream.tellg()) : 0;
  std::string bytes(static_cast<std::size_t>(std::clamp<std::streamoff>(size, 0, most)), '\0');
  stream.seekg(last ? size - static_cast<std::streamoff>(bytes.size()) : 0);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

/** Whether a file of XML lacks its end. */
bool IsTruncatedXML(const std::string& file)
{
  constexpr std::streamoff some = 4096;
  const std::string start = ReadEnd(file, some, false);
  return start.find("<VTKFile") != start.npos &&
    ReadEnd(file, some, true).find("</VTKFile") == std::string::npos;
}

/** The first number of a legacy file of text that is none, such as nan; empty without one. */
std::string FindNonNumber(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  for (int i = 0; i < 3; ++i)
  {
    std::getline(stream, line);
  }
  if (!line.starts_with("ASCII"))
  {
    return {};
  }
  for (std::string word; stream >> word;)
  {
    std::string plain;
    for (const char c : word)
    {
      plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    plain.erase(0, plain.find_first_not_of("+-"));
    if (plain == "nan" || plain == "inf" || plain == "infinity" || plain.starts_with("nan("))
    {
      return word;
    }
  }
  return {};
}

void CheckAddress(const std::string& address)
{
  const std::string extension = ExtensionOf(address);
  if (extension != ".gtn" && extension != ".ghv")
  {
    throw Failure(address,
      "only files whose names end in .gtn or .ghv are read from web servers; download it first");
  }
  gatun::OpenFile(address);
}
}

//------------------------------------------------------------------------------
void CheckReadable(const std::string& file)
{
  if (IsAddress(file))
  {
    CheckAddress(file);
    return;
  }
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
  if (!std::filesystem::is_regular_file(status))
  {
    throw Failure(
      file, "is not a regular file; write what a pipe or a device gives to a file, and name that");
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
  std::string start(LFSStart.size(), '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  if (start == LFSStart)
  {
    throw Failure(
      file, "is a pointer of Git LFS and not the file itself, which git lfs pull brings");
  }
}

//------------------------------------------------------------------------------
std::string ExplainRefusal(const std::string& file, const std::string& message)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
  {
    return message;
  }
  if (IsTruncatedXML(file))
  {
    return "is truncated: it does not end in </VTKFile> (" + message + ")";
  }
  const std::string extension = ExtensionOf(file);
  if (extension == ".stl" && ReadEnd(file, 256, true).find("end solid") != std::string::npos)
  {
    return "has 'end solid' where 'endsolid' must be (" + message + ")";
  }
  if ((extension == ".nrrd" || extension == ".nhdr") &&
    (message.find("skip") != message.npos || message.find("encoding") != message.npos))
  {
    return message +
      "; write it with the encoding raw or gzip, and all values in one file without "
      "skips";
  }
  const std::string word = extension == ".vtk" ? FindNonNumber(file) : std::string();
  if (!word.empty())
  {
    return "has " + word + " in text, which VTK does not read; write the file in binary (" +
      message + ")";
  }
  return message;
}
}
