// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunDomainWriter_h
#define gatunDomainWriter_h

// Storing the values of many keys of a domain.

#include "gatunDomain.h"

#include <cstdint>

namespace gatun
{
/** Calls use(write), where write(key, to) stores the value of a key. The type is dispatched once.
 */
template <typename Use>
void WithWriter(const Domain& domain, Use&& use)
{
  const auto type = domain.GetType();
  if (domain.GetPalette())
  {
    const auto& palette = *domain.GetPalette();
    use(
      [type, &palette](Key key, std::uint8_t* to) { Domain::WritePlain(type, palette[key], to); });
  }
  else if (domain.GetScale())
  {
    use([&domain](Key key, std::uint8_t* to) { domain.Write(key, to); });
  }
  else if (type == ScalarType::Float32)
  {
    use([](Key key, std::uint8_t* to) { Domain::WritePlain(ScalarType::Float32, key, to); });
  }
  else if (type == ScalarType::Float64)
  {
    use([](Key key, std::uint8_t* to) { Domain::WritePlain(ScalarType::Float64, key, to); });
  }
  else
  {
    use([type](Key key, std::uint8_t* to) { Domain::WritePlain(type, key, to); });
  }
}
}

#endif
