// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFileInput_h
#define gatunFileInput_h

#include "gatunFileSignature.h"

#include <memory>
#include <string>

namespace gatun
{
/** A file that is opened anew when it has changed. FileT: FileReader, or what else is made of a
 * path and throws gatun::Error. */
template <typename FileT>
class CurrentFileOf
{
public:
  /** Whether another file would be opened: Get has not been called, or it has changed since. */
  bool IsNew(const std::string& path) const
  {
    return !this->File || path != this->Path || SignatureOf(path) != this->Signature;
  }

  /** Whether it is another one on disk than when Get was called for it, be it that Get threw. */
  bool HasChanged(const std::string& path) const
  {
    return path == this->Path && SignatureOf(path) != this->Signature;
  }

  /** The file, opened if need be. Throws gatun::Error. */
  const std::shared_ptr<const FileT>& Get(const std::string& path)
  {
    const FileSignature signature = SignatureOf(path);
    if (!this->File || path != this->Path || signature != this->Signature)
    {
      this->File.reset();
      this->Path = path;
      this->Signature = signature;
      this->File = std::make_shared<const FileT>(path);
    }
    return this->File;
  }

  /** The file that was opened last; null if there is none. */
  const std::shared_ptr<const FileT>& GetLast() const { return this->File; }

  void Close() { this->File.reset(); }

private:
  std::shared_ptr<const FileT> File;
  std::string Path;
  FileSignature Signature;
};
}

#endif
