// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunBytes_h
#define gatunBytes_h

#include "gatunError.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

static_assert(std::endian::native == std::endian::little,
  "Gatun's files are little-endian and are read and written without swapping bytes");

namespace gatun
{
using Bytes = std::vector<std::uint8_t>;

/** Appends little-endian values, variable-length integers and strings to a byte array. */
class ByteWriter
{
public:
  template <typename T>
  requires std::is_arithmetic_v<T>
  void Put(T value)
  {
    const auto at = this->Data.size();
    this->Data.resize(at + sizeof(T));
    std::memcpy(this->Data.data() + at, &value, sizeof(T));
  }

  /** LEB128: seven bits per byte, lowest first. The top bit is set if more bytes follow. */
  void PutVarint(std::uint64_t value)
  {
    for (; value >= 0x80; value >>= 7)
    {
      this->Data.push_back(static_cast<std::uint8_t>(value | 0x80));
    }
    this->Data.push_back(static_cast<std::uint8_t>(value));
  }

  void PutString(const std::string& text)
  {
    this->PutVarint(text.size());
    this->PutBytes({ reinterpret_cast<const std::uint8_t*>(text.data()), text.size() });
  }

  void PutBytes(std::span<const std::uint8_t> bytes)
  {
    this->Data.insert(this->Data.end(), bytes.begin(), bytes.end());
  }

  Bytes Data;
};

/** Reads the output of ByteWriter. Every read is checked against the end: safe on hostile input. */
class ByteReader
{
public:
  explicit ByteReader(std::span<const std::uint8_t> data)
    : Data(data)
  {
  }

  template <typename T>
  requires std::is_arithmetic_v<T> T Get()
  {
    T value;
    std::memcpy(&value, this->GetBytes(sizeof(T)).data(), sizeof(T));
    return value;
  }

  std::uint64_t GetVarint()
  {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7)
    {
      const auto byte = this->Get<std::uint8_t>();
      const std::uint64_t part = byte & 0x7f;
      if (shift == 63 && part > 1)
      {
        break;
      }
      value |= part << shift;
      if (byte < 0x80)
      {
        return value;
      }
    }
    ThrowCorrupt("an integer is longer than 64 bits");
  }

  /** A count of items. Throws if items of bytesEach bytes would not fit into the remaining data. */
  std::uint64_t GetCount(std::uint64_t bytesEach)
  {
    const auto count = this->GetVarint();
    if (bytesEach > 0 && count > this->GetRemaining() / bytesEach)
    {
      ThrowCorrupt("a count is larger than the data that follows");
    }
    return count;
  }

  std::string GetString()
  {
    const auto bytes = this->GetBytes(this->GetCount(1));
    return { reinterpret_cast<const char*>(bytes.data()), bytes.size() };
  }

  std::span<const std::uint8_t> GetBytes(std::uint64_t count)
  {
    if (count > this->GetRemaining())
    {
      ThrowCorrupt("the data ends too early");
    }
    const auto bytes = this->Data.subspan(this->Position, static_cast<std::size_t>(count));
    this->Position += static_cast<std::size_t>(count);
    return bytes;
  }

  std::size_t GetRemaining() const { return this->Data.size() - this->Position; }
  std::size_t GetPosition() const { return this->Position; }

private:
  std::span<const std::uint8_t> Data;
  std::size_t Position = 0;
};
}

#endif
