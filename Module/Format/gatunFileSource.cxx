// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFileSource.h"

#include "gatunError.h"

#include <atomic>

namespace gatun
{
namespace
{
std::atomic<SourceOpener> Opener{ nullptr };
}

//------------------------------------------------------------------------------
FileSource::FileSource(const std::string& path)
{
  FileHandle::Kind kind{};
  if (const int error = this->Handle.OpenToRead(path, kind, this->Size))
  {
    throw Error(ErrorCode::CannotOpen,
      ErrorDetails{ .Path = path, .What = "cannot open", .SystemError = error });
  }
  if (kind != FileHandle::Kind::Regular)
  {
    throw Error(ErrorCode::CannotOpen,
      { .Path = path,
        .What = kind == FileHandle::Kind::Folder ? "cannot open: is a directory"
                                                 : "cannot open: is not a regular file" });
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<const ByteSource> OpenFile(const std::string& path)
{
  const auto opener = Opener.load();
  auto opened = opener ? opener(path) : nullptr;
  return opened ? opened : std::make_shared<const FileSource>(path);
}

//------------------------------------------------------------------------------
void SetSourceOpener(SourceOpener opener)
{
  Opener = opener;
}
}
