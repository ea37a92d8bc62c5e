// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnScratch_h
#define gtnScratch_h

// The names of half-written files, for a handler of signals.

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
}

#endif
