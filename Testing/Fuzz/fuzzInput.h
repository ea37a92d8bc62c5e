// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef fuzzInput_h
#define fuzzInput_h

#include "gatunBytes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace gatun::fuzz
{
/** Takes values from a fuzzer's bytes, which are followed by zeros without end. */
class Input
{
public:
  Input(const std::uint8_t* data, std::size_t size)
    : Data(data, size)
  {
  }

  template <typename T>
  requires std::is_arithmetic_v<T> T Take()
  {
    T value{};
    const auto bytes = this->TakeBytes(sizeof(T));
    std::memcpy(&value, bytes.data(), bytes.size());
    return value;
  }

  bool TakeBool() { return (this->Take<std::uint8_t>() & 1) != 0; }

  /** From 0 to most. */
  std::uint32_t TakeUpTo(std::uint32_t most)
  {
    const std::uint32_t value =
      most < 256 ? this->Take<std::uint8_t>() : this->Take<std::uint16_t>();
    return value % (most + 1);
  }

  /** As many bytes as there are, up to count. */
  std::span<const std::uint8_t> TakeBytes(std::size_t count)
  {
    const auto bytes = this->Data.first(std::min(count, this->Data.size()));
    this->Data = this->Data.subspan(bytes.size());
    return bytes;
  }

  /** Bytes in front of which their number stands in two bytes. */
  std::span<const std::uint8_t> TakePart() { return this->TakeBytes(this->Take<std::uint16_t>()); }

  std::span<const std::uint8_t> TakeRest() { return this->TakeBytes(this->Data.size()); }

  std::size_t GetRemaining() const { return this->Data.size(); }

private:
  std::span<const std::uint8_t> Data;
};

/** Memory of the exact size, so that AddressSanitizer sees every read beyond the end. */
inline Bytes Copy(std::span<const std::uint8_t> bytes)
{
  Bytes copy(bytes.begin(), bytes.end());
  copy.shrink_to_fit();
  return copy;
}

/** Runs a parser; damage that it reports is what it should report. */
template <typename Parse>
bool Accepts(Parse&& parse)
{
  try
  {
    parse();
    return true;
  }
  catch (const Error& error)
  {
    if (error.Code != ErrorCode::Corrupt)
    {
      throw;
    }
    return false;
  }
}
}

#endif
