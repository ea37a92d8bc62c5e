// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPalette.h"

#include "gatunArrayCodec.h"

#include <algorithm>
#include <unordered_set>

namespace gatun
{
std::shared_ptr<const Palette> FindPalette(ScalarType type, const void* values, std::size_t count,
  std::size_t components, std::size_t component)
{
  const auto most = std::min(count / 16, MaxPalette);
  if (!IsFloating(type) || most < 1)
  {
    return nullptr;
  }
  const auto size = SizeOf(type);
  const auto* next = static_cast<const std::uint8_t*>(values) + component * size;
  std::unordered_set<Key> distinct;
  Key last = 0;
  for (std::size_t i = 0; i < count; ++i, next += components * size)
  {
    const Key key = Domain::ReadPlain(type, next);
    if (i > 0 && key == last)
    {
      continue;
    }
    last = key;
    if (distinct.insert(key).second && distinct.size() > most)
    {
      return nullptr;
    }
  }
  auto palette = std::make_shared<Palette>(distinct.begin(), distinct.end());
  std::sort(palette->begin(), palette->end());
  return palette;
}

Bytes EncodePalette(ScalarType type, const Palette& palette)
{
  const Domain domain(type);
  ComponentKeys keys;
  keys.Now = palette;
  auto stream = EncodeCellValues({}, { &domain, 1 }, { &keys, 1 });
  return stream;
}

std::shared_ptr<const Palette> DecodePalette(
  ScalarType type, std::span<const std::uint8_t> stream, std::uint64_t count)
{
  if (count < 1 || count > MaxPalette)
  {
    ThrowCorrupt("a palette has an impossible size");
  }
  const Domain domain(type);
  ComponentKeys keys;
  keys.Now.resize(static_cast<std::size_t>(count));
  DecodeCellValues(stream, {}, { &domain, 1 }, { &keys, 1 });
  if (std::adjacent_find(keys.Now.begin(), keys.Now.end(), std::greater_equal<>()) !=
    keys.Now.end())
  {
    ThrowCorrupt("the values of a palette do not ascend");
  }
  return std::make_shared<Palette>(std::move(keys.Now));
}
}
