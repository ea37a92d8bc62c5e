// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunEntropy.h"

#include <algorithm>
#include <cmath>

namespace gatun
{
std::uint64_t EntropyEncoder::Raw(std::uint64_t value, unsigned count)
{
  for (unsigned done = 0; done < count;)
  {
    const unsigned take = std::min(count - done, 32u);
    const std::uint64_t part = (value >> done) & ((std::uint64_t{ 1 } << take) - 1);
    this->Pending |= part << this->PendingBits;
    this->PendingBits += take;
    done += take;
    for (; this->PendingBits >= 8; this->PendingBits -= 8, this->Pending >>= 8)
    {
      this->RawBytes.push_back(static_cast<std::uint8_t>(this->Pending));
    }
  }
  return value;
}

double EntropyEncoder::EstimateBits() const
{
  double bits = 8.0 * static_cast<double>(this->RawBytes.size());
  for (const auto& part : this->Parts)
  {
    bits += part.Bits - std::log2(static_cast<double>(part.Width));
  }
  return bits;
}

Bytes EntropyEncoder::Finish()
{
  constexpr std::uint64_t low = std::uint64_t{ 1 } << 32;
  std::vector<std::uint32_t> words; // last first
  std::uint64_t state = low;
  for (auto it = this->Parts.rbegin(); it != this->Parts.rend(); ++it)
  {
    const std::uint64_t width = it->Width;
    if (state >= (width << (64 - it->Bits)))
    {
      words.push_back(static_cast<std::uint32_t>(state));
      state >>= 32;
    }
    state = ((state / width) << it->Bits) + state % width + it->Start;
  }
  ByteWriter out;
  if (this->Parts.empty())
  {
    out.PutVarint(0);
  }
  else
  {
    out.PutVarint(8 + 4 * words.size());
    out.Put(state);
    for (auto it = words.rbegin(); it != words.rend(); ++it)
    {
      out.Put(*it);
    }
  }
  out.PutBytes(this->RawBytes);
  if (this->PendingBits > 0)
  {
    out.Put(static_cast<std::uint8_t>(this->Pending));
  }
  return std::move(out.Data);
}

EntropyDecoder::EntropyDecoder(std::span<const std::uint8_t> stream)
{
  ByteReader in(stream);
  const auto words = in.GetBytes(in.GetCount(1));
  if (!words.empty())
  {
    if (words.size() < 8)
    {
      ThrowCorrupt("an entropy-coded stream is shorter than its state");
    }
    std::memcpy(&this->State, words.data(), 8);
    this->Word = words.data() + 8;
    this->WordEnd = words.data() + words.size();
  }
  const auto raw = in.GetBytes(in.GetRemaining());
  this->RawNext = raw.data();
  this->RawEnd = raw.data() + raw.size();
}

void EntropyDecoder::FillAtEnd(unsigned count)
{
  for (; this->PendingBits < count; this->PendingBits += 8)
  {
    if (this->RawNext == this->RawEnd)
    {
      ThrowEnd();
    }
    this->Pending |= static_cast<std::uint64_t>(*this->RawNext++) << this->PendingBits;
  }
}

void EntropyDecoder::ThrowEnd()
{
  ThrowCorrupt("an entropy-coded stream ends too early");
}
}
