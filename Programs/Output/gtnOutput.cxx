// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gtnOutput.h"

#include "gtnFailure.h"
#include "gtnMessages.h"
#include "gtnText.h"

#include "vtkAlgorithm.h"
#include "vtkErrorCode.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <random>
#include <system_error>

#include <unistd.h>

namespace gtn
{
namespace
{
/** Whether a file is marked so, which root could ignore, or of somebody else. */
bool IsReadOnly(const std::string& file)
{
  using std::filesystem::perms;
  std::error_code error;
  const auto mode = std::filesystem::status(file, error).permissions();
  constexpr auto writable = perms::owner_write | perms::group_write | perms::others_write;
  return (mode & writable) == perms::none || ::access(file.c_str(), W_OK) != 0;
}
}

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
    throw Failure(file, "exists; use -f to overwrite it");
  }
  if (std::filesystem::exists(file, error) && IsReadOnly(file))
  {
    throw Failure(file, "is read-only; remove it, or allow to write it");
  }
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, error))
  {
    throw Failure(file, "there is no folder " + folder.string());
  }
}

//------------------------------------------------------------------------------
void CheckWritten(vtkAlgorithm* writer, bool good, const std::string& file)
{
  const std::vector<std::string> errors = TakeErrors();
  if (good && errors.empty() && writer->GetErrorCode() == vtkErrorCode::NoError)
  {
    return;
  }
  // VTK's writers do not tell a full disk from other failures.
  std::error_code error;
  const auto space = std::filesystem::space(std::filesystem::absolute(file).parent_path(), error);
  constexpr std::uintmax_t little = 1 << 16;
  if (!error && space.available < little)
  {
    throw Failure("no space left on the disk");
  }
  throw Failure("cannot be written");
}

//------------------------------------------------------------------------------
void WriteBytes(const std::string& file, std::string_view bytes)
{
  const auto close = [](std::FILE* stream) { std::fclose(stream); };
  std::unique_ptr<std::FILE, decltype(close)> stream(std::fopen(file.c_str(), "wb"), close);
  // What is still in the buffer may be what does not fit.
  if (!stream || std::fwrite(bytes.data(), 1, bytes.size(), stream.get()) != bytes.size() ||
    std::fclose(stream.release()) != 0)
  {
    throw Failure(errno == ENOSPC ? "no space left on the disk"
                                  : std::string("cannot be written: ") + std::strerror(errno));
  }
}

//------------------------------------------------------------------------------
TemporaryFile::TemporaryFile(const std::string& file)
  : File(file)
{
  std::random_device random;
  const std::filesystem::path path(file);
  std::filesystem::path stem = path.stem();
  std::string extension = path.extension().string();
  if (ExtensionOf(file) == ".gz")
  {
    // What is in it counts, too: .nii.gz.
    extension = stem.extension().string() + extension;
    stem = stem.stem();
  }
  this->Name =
    (path.parent_path() / fmt::format("{}.{:08x}{}", stem.string(), random(), extension)).string();
  this->Scratch.emplace(this->Name);
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
  this->Scratch.reset();
  this->Name.clear();
}
}
