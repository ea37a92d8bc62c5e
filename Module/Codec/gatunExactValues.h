// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunExactValues_h
#define gatunExactValues_h

#include "gatunDomain.h"
#include "gatunGeometry.h"
#include "gatunGuess.h"
#include "gatunResidual.h"

#include <array>
#include <cstddef>

namespace gatun
{
/** Codes the values of a component that are exact. */
class ExactValues
{
public:
  static constexpr bool IsBounded = false;

  ExactValues(const Domain& domain, std::size_t)
    : Values(domain)
  {
  }

  double ToNumber(Key key) const { return this->Values.ToNumber(key); }

  /** The place is that of the value in the component. */
  template <typename Coder>
  Key Code(Coder& coder, const Guess& guess, std::size_t, Key truth)
  {
    const Key predicted = guess.GetKey(this->Values);
    const auto spread = guess.Spread != NoSpread ? guess.Spread : this->Running.Get();
    const auto residual = this->Models[guess.Group].Code(
      coder, spread, Coder::Encoding ? this->Values.Subtract(truth, predicted) : 0);
    const Key key = this->Values.Add(predicted, residual);
    if (!Coder::Encoding && !this->Values.IsValid(key))
    {
      ThrowCorrupt("a value is not in the palette");
    }
    this->Running.Add(residual);
    return key;
  }

private:
  const Domain& Values;
  std::array<ResidualModel, MaxRules + 1> Models; // of each group
  RunningSpread Running;
};
}

#endif
