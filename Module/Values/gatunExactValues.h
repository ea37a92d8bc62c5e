// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunExactValues_h
#define gatunExactValues_h

#include "gatunDomain.h"
#include "gatunGeometry.h"
#include "gatunGuess.h"
#include "gatunResidual.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace gatun
{
/** The key that is a residual away from a predicted one. */
template <typename AnyDomain>
Key AddResidual(const AnyDomain& domain, Key predicted, std::int64_t residual)
{
  const Key key = domain.Add(predicted, residual);
  if (!domain.IsValid(key))
  {
    ThrowCorrupt("a value is not in the palette");
  }
  return key;
}

/** Codes the values of a component that are exact. AnyDomain: Domain, or one of its special cases.
 */
template <typename AnyDomain>
class ExactValues
{
public:
  static constexpr bool IsBounded = false;

  explicit ExactValues(const AnyDomain& domain)
    : Values(domain)
  {
  }

  const AnyDomain& GetDomain() const { return this->Values; }
  double ToNumber(Key key) const { return this->Values.ToNumber(key); }

  /** The place is that of the value in the component. */
  template <typename Coder>
  Key Code(Coder& coder, const Guess& guess, std::size_t, Key actual)
  {
    const Key predicted = guess.GetKey(this->Values);
    const auto [group, spread] = this->FindContext(guess, predicted);
    const auto residual = this->Models[group].Code(
      coder, spread, Coder::Encoding ? this->Values.Subtract(actual, predicted) : 0);
    this->Running.Add(residual);
    return AddResidual(this->Values, predicted, residual);
  }

private:
  struct Context
  {
    unsigned Group;
    unsigned Spread;
  };

  Context FindContext(const Guess& guess, Key predicted) const
  {
    if (guess.Error < 0)
    {
      return { guess.Group, guess.Spread != NoSpread ? guess.Spread : this->Running.Get() };
    }
    const auto width = guess.GetErrorInKeys(this->Values, predicted);
    const auto bits = static_cast<unsigned>(std::bit_width(width));
    const bool isUpper = bits >= 2 && ((width >> (bits - 2)) & 1) != 0; // from 1.5 times 2^n on
    return { isUpper ? 3u : 2u, bits + 2 };
  }

  const AnyDomain Values; // a copy: small, and so the compiler knows that it does not change
  std::array<ResidualModel, MaxRules + 1> Models; // of each group
  RunningSpread Running;
};
}

#endif
