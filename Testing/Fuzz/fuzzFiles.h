// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef fuzzFiles_h
#define fuzzFiles_h

#include <cstdint>
#include <span>
#include <string>

namespace gatun::fuzz
{
/** One thread for all of gatun, so that a run can be repeated. Call it before anything else. */
void UseOneThread();

/** The name of a file in memory. */
inline const std::string FileName = "fuzz.gtn";

/**
 * Decodes a file in all ways: with its order, by pieces with ghosts, steps, field data, after
 * merges, base meshes; and verifies it. Aborts if an error does not say which file is wrong, or if
 * a file that is accepted decodes to ids that are out of range. Returns whether the file was
 * accepted.
 */
bool DecodeFile(std::span<const std::uint8_t> bytes);
}

#endif
