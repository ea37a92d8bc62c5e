// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnOutput_h
#define gtnOutput_h

#include "gtnScratch.h"

#include <optional>
#include <string>
#include <string_view>

class vtkAlgorithm;

namespace gtn
{
/** Throws Failure if the file exists and may not be replaced, or if its folder is missing. */
void CheckWritable(const std::string& file, bool overwrite);

/** Throws Failure, without the file's name, if a writer of VTK failed or
 * reported errors. Takes the errors that CatchMessages kept. */
void CheckWritten(vtkAlgorithm* writer, bool good, const std::string& file);

/** Writes these bytes to a file. Throws Failure, without the file's name. */
void WriteBytes(const std::string& file, std::string_view bytes);

/** A temporary name for a file, which gets its own name when it is complete. */
class TemporaryFile
{
public:
  /** Named after the file, in the same folder, with the same extension. */
  explicit TemporaryFile(const std::string& file);

  /** Deletes what was not committed. */
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& GetName() const { return this->Name; }

  /** Replaces the file. Throws Failure. */
  void Commit();

private:
  std::string File;
  std::string Name;
  std::optional<ScratchName> Scratch;
};
}

#endif
