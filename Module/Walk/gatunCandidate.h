// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCandidate_h
#define gatunCandidate_h

#include "gatunFront.h"

namespace gatun
{
/** A vertex that may be a corner of a cell. Nearer ones come first, then smaller numbers. */
struct Candidate
{
  Vertex Id;
  float Distance; // squared, to the predicted place
  bool operator<(const Candidate& other) const
  {
    return this->Distance != other.Distance ? this->Distance < other.Distance : this->Id < other.Id;
  }
};
}

#endif
