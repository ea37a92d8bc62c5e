// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnOutput_h
#define gtnOutput_h

#include <string>

namespace gtn
{
/** Throws Failure if the file exists and may not be replaced, or if its folder is missing. */
void CheckWritable(const std::string& file, bool overwrite);

/** A name to write to first; the file gets its own name when it is complete. */
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
};
}

#endif
