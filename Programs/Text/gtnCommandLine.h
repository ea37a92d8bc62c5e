// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gtnCommandLine_h
#define gtnCommandLine_h

// The classes of CLI11 that headers name. Its own header is for sources that define options: with
// it, a source takes twice as long to compile.

namespace CLI
{
class App;
class Option;
class Validator;
}

#endif
