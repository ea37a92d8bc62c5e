// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFileSource_h
#define gatunFileSource_h

#include "gatunByteSource.h"
#include "gatunFileHandle.h"

#include <cstdint>
#include <span>
#include <string>

namespace gatun
{
/** A file on disk, as OpenFile returns it. */
class FileSource final : public ByteSource
{
public:
  explicit FileSource(const std::string& path);

  std::uint64_t GetSize() const override { return this->Size; }
  int ReadAt(std::uint64_t offset, std::span<std::uint8_t>& bytes) const override
  {
    return this->Handle.ReadAt(offset, bytes);
  }

  const FileHandle& GetHandle() const { return this->Handle; }

private:
  FileHandle Handle;
  std::uint64_t Size = 0;
};
}

#endif
