// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunDomainWriter_h
#define gatunDomainWriter_h

// Storing the values of many keys of a domain.

#include "gatunDomain.h"

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace gatun
{
/** WithWriter for the scale Binary, which has numbers of its type only. */
template <typename Use>
void WithWriterOf(const BinaryDomain& domain, Use&& use)
{
  const auto store = [&domain, &use]<typename T>(std::type_identity<T>)
  {
    use(
      [&domain](Key key, std::uint8_t* to)
      {
        const auto value = static_cast<T>(domain.ToNumber(key));
        std::memcpy(to, &value, sizeof(T));
      });
  };
  if (domain.GetType() == ScalarType::Float32)
  {
    store(std::type_identity<float>());
  }
  else
  {
    store(std::type_identity<double>());
  }
}

/** Calls use(write), where write(key, to) stores the value of a key. The type is dispatched once.
 */
template <typename Use>
void WithWriter(const Domain& domain, Use&& use)
{
  const auto type = domain.GetType();
  if (domain.GetPalette())
  {
    const Key* const palette = domain.GetPalette()->data();
    if (type == ScalarType::Float32)
    {
      use([palette](Key key, std::uint8_t* to)
        { Domain::WritePlain(ScalarType::Float32, palette[key], to); });
    }
    else
    {
      use(
        [type, palette](Key key, std::uint8_t* to) { Domain::WritePlain(type, palette[key], to); });
    }
  }
  else if (BinaryDomain::Matches(domain))
  {
    WithWriterOf(BinaryDomain(domain), use);
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
