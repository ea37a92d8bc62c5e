// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunWindowsNames_h
#define gatunWindowsNames_h

// Names and errors of Windows, for FileHandle and AtomicFile.

#include <string>

#ifndef NOMINMAX
#define NOMINMAX
#endif
#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#include <windows.h>

namespace gatun
{
/** Converts UTF-8 into an absolute name that may be longer than 260 characters. Returns a value of
 * errno. */
int WidenName(const std::string& name, std::wstring& wide);

/** The reverse, for names that the system returns. */
std::string NarrowName(const std::wstring& wide);

/** The value of errno for GetLastError. */
int GetSystemError();
}

#endif
