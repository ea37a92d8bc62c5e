// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFloatEnvironment_h
#define gatunFloatEnvironment_h

#include <cfenv>

namespace gatun
{
/**
 * Sets this thread to round to nearest and to keep subnormal numbers until destruction. The codec's
 * predictions depend on it. Programs built with -ffast-math leave threads in another state.
 */
class FloatEnvironment
{
public:
  FloatEnvironment()
  {
    std::fegetenv(&this->Saved);
    std::fesetenv(FE_DFL_ENV);
  }
  ~FloatEnvironment() { std::fesetenv(&this->Saved); }
  FloatEnvironment(const FloatEnvironment&) = delete;
  FloatEnvironment& operator=(const FloatEnvironment&) = delete;

private:
  std::fenv_t Saved;
};
}

#endif
