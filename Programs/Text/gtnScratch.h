// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnScratch_h
#define gtnScratch_h

// What is left to do when the program is ended by a signal or a library: the names of half-written
// files.

#include <string>

namespace gtn
{
/** A file that must not be left behind, until this object goes. */
class ScratchName
{
public:
  explicit ScratchName(const std::string& file);
  ~ScratchName();
  ScratchName(const ScratchName&) = delete;
  ScratchName& operator=(const ScratchName&) = delete;

private:
  int Place; // -1: there are too many, or the name is too long
};

/** Removes them all. May be called by a handler of signals. */
void RemoveScratchFiles() noexcept;

/** For a file whose library may end the program: then the message and the exit code are those of
 * other failures, and no half-written file is left. Until ReleaseExit. */
void GuardExit(const std::string& file);
void ReleaseExit();
}

#endif
