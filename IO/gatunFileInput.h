// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFileInput_h
#define gatunFileInput_h

// Filters that go to the file of a reader instead of its output.

#include "gatunFileSignature.h"
#include "vtkGatunIOModule.h" // For export macro

#include <cstddef>
#include <memory>
#include <string>

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif
class vtkAlgorithm;
class vtkGatunReader;
class vtkInformation;
#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif

namespace gatun
{
class FileReader;

/** The reader whose file can be used instead of its output; null if that is not the same. */
VTKGATUNIO_EXPORT vtkGatunReader* GetFileReader(vtkAlgorithm* input);

/** Makes a consumer of a reader's file ask for nothing that the reader would have to decode: for
 * what its output has already, or for a piece without any cells. Info: of the consumer's input. */
VTKGATUNIO_EXPORT void RequestNothing(vtkGatunReader* reader, vtkInformation* info);

/** The last step not later than a time, or the first. */
VTKGATUNIO_EXPORT std::size_t FindStep(const FileReader& file, double time);

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

using CurrentFile = CurrentFileOf<FileReader>;
}

#endif
