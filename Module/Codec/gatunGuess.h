// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunGuess_h
#define gatunGuess_h

#include "gatunCellRules.h"
#include "gatunDomain.h"

#include <cmath>

namespace gatun
{
/** What is known of a value before it is coded. */
struct Guess
{
  Key Predicted = 0; ///< unless there is a number
  double Number = 0; ///< of any size, perhaps not finite
  bool HasNumber = false;
  unsigned Spread = NoSpread; ///< of the keys around in bits
  unsigned Group = 0;         ///< of similar predictions

  void SetNumber(double number)
  {
    this->Number = number;
    this->HasNumber = true;
  }

  Key GetKey(const Domain& domain) const
  {
    return this->HasNumber ? domain.FromNumber(this->Number) : this->Predicted;
  }

  /** A finite number. */
  double GetNumber(const Domain& domain) const
  {
    const double number = this->HasNumber ? this->Number : domain.ToNumber(this->Predicted);
    return std::isfinite(number) ? number : 0;
  }
};
}

#endif
