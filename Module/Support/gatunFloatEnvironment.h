// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFloatEnvironment_h
#define gatunFloatEnvironment_h

#include <cfenv>

namespace gatun
{
/**
 * While it lives, this thread rounds to nearest and keeps subnormal numbers, as the codec's
 * predictions demand. Programs built with -ffast-math leave threads in another state.
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
