// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunFileSignature.h"

#include <sys/stat.h>

namespace gatun
{

//------------------------------------------------------------------------------
FileSignature SignatureOf(const std::string& path)
{
  FileSignature signature;
  struct stat status;
  if (stat(path.c_str(), &status) == 0)
  {
    signature.Device = static_cast<std::uint64_t>(status.st_dev);
    signature.Inode = static_cast<std::uint64_t>(status.st_ino);
    signature.Size = static_cast<std::int64_t>(status.st_size);
#if defined(__linux__)
    signature.Seconds = static_cast<std::int64_t>(status.st_mtim.tv_sec);
    signature.Nanoseconds = static_cast<std::int64_t>(status.st_mtim.tv_nsec);
#else
    signature.Seconds = static_cast<std::int64_t>(status.st_mtime);
#endif
  }
  return signature;
}

}
