// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnThreads_h
#define gtnThreads_h

#include <functional>
#include <string>

namespace gtn
{
/** How many threads to use from now on, 0: one a processor. To be called once, before all work. */
void SetThreads(int count);

/** Does some work with a number of threads. */
void WithThreads(int count, const std::function<void()>& work);

/** Which of VTK's ways to run threads is in use. */
std::string ThreadBackend();
}

#endif
