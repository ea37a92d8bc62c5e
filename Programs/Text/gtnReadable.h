// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnReadable_h
#define gtnReadable_h

#include <string>

namespace gtn
{
/** Throws Failure unless the file is a regular one that is there, not empty and may be read, or if
 * it is a pointer of Git LFS. Only a .foam file may be empty: it marks the folder of a case. An
 * address must be that of a .gtn or .ghv file that a web server has. */
void CheckReadable(const std::string& file);

/** What is wrong with a file that a reader of VTK refused with a message: the message, with the
 * cause before it where the file shows it. */
std::string ExplainRefusal(const std::string& file, const std::string& message);
}

#endif
