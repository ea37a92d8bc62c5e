// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunComponentCoder_h
#define gatunComponentCoder_h

#include "gatunBoundedValues.h"
#include "gatunDomain.h"
#include "gatunExactValues.h"
#include "gatunPointContext.h"

namespace gatun
{
/** Codes whether a component has exact values: always, unless it has a bound of errors. */
template <typename Coder>
bool CodeIsExact(Coder& coder, const Domain& domain, const ComponentKeys& keys)
{
  if (!domain.GetQuantizer())
  {
    return true;
  }
  const bool isExact = Coder::Encoding && BoundedValues::AreTooFine(domain, keys.Now);
  return coder.Raw(isExact, 1) != 0;
}

/** The values of a component that are not exact. */
inline BoundedValues MakeBoundedValues(
  const Domain& domain, bool onLattice, const ComponentKeys& keys)
{
  return { domain, keys.Now.size(), onLattice || domain.GetQuantizer().OnLattice };
}

/** Codes a component with code(values). A bounded one begins with whether it has exact values all
 * the same. */
template <typename Coder, typename Code>
void CodeComponent(
  Coder& coder, const Domain& domain, bool onLattice, const ComponentKeys& keys, Code&& code)
{
  if (!CodeIsExact(coder, domain, keys))
  {
    code(MakeBoundedValues(domain, onLattice, keys));
  }
  else if (Float32Domain::Matches(domain))
  {
    code(ExactValues(Float32Domain()));
  }
  else
  {
    code(ExactValues(domain));
  }
}
}

#endif
