// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFileSizeLimit_h
#define gatunFileSizeLimit_h

#include <gtest/gtest.h>

#include <csignal>

#include <sys/resource.h>

namespace gatun::test
{
/** Limits the size of files that this process writes. */
class FileSizeLimit
{
public:
  explicit FileSizeLimit(::rlim_t size)
    : OldHandler(std::signal(SIGXFSZ, SIG_IGN))
  {
    ::getrlimit(RLIMIT_FSIZE, &this->Old);
    const ::rlimit limit{ size, this->Old.rlim_max };
    EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  }
  ~FileSizeLimit()
  {
    ::setrlimit(RLIMIT_FSIZE, &this->Old);
    std::signal(SIGXFSZ, this->OldHandler);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
  ::rlimit Old{};
  void (*OldHandler)(int);
};
}

#endif
