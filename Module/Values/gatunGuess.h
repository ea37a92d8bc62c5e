// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGuess_h
#define gatunGuess_h

#include "gatunCellRules.h"
#include "gatunDomain.h"

#include <cmath>
#include <cstdint>

namespace gatun
{
/** A prediction of a value before it is coded. */
struct Guess
{
  Key Predicted = 0; ///< unless there is a number
  double Number = 0; ///< of any size, perhaps not finite
  bool HasNumber = false;
  unsigned Spread = NoSpread; ///< of the keys around in bits
  unsigned Group = 0;         ///< of similar predictions
  double Error = -1;          ///< of the number, to expect; negative if that is not known

  void SetNumber(double number)
  {
    this->Number = number;
    this->HasNumber = true;
  }

  template <typename AnyDomain>
  Key GetKey(const AnyDomain& domain) const
  {
    return this->HasNumber ? domain.FromNumber(this->Number) : this->Predicted;
  }

  /** How far the key is that is off by the error, away from zero, where keys are further apart. */
  template <typename AnyDomain>
  std::uint64_t GetErrorInKeys(const AnyDomain& domain, Key predicted) const
  {
    const Key off =
      domain.FromNumber(this->Number < 0 ? this->Number - this->Error : this->Number + this->Error);
    return off > predicted ? off - predicted : predicted - off;
  }

  /** A finite number. */
  template <typename AnyDomain>
  double GetNumber(const AnyDomain& domain) const
  {
    const double number = this->HasNumber ? this->Number : domain.ToNumber(this->Predicted);
    return std::isfinite(number) ? number : 0;
  }
};
}

#endif
