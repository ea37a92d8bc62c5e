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
  for (const auto decision : this->Decisions)
  {
    const auto p = static_cast<double>(decision >> 1);
    bits -= std::log2((decision & 1 ? p : 65536.0 - p) / 65536.0);
  }
  return bits;
}

Bytes EntropyEncoder::Finish()
{
  constexpr std::uint64_t low = std::uint64_t{ 1 } << 32;
  std::vector<std::uint32_t> words; // last first
  std::uint64_t state = low;
  for (auto it = this->Decisions.rbegin(); it != this->Decisions.rend(); ++it)
  {
    const std::uint64_t p = *it >> 1;
    const bool bit = *it & 1;
    const std::uint64_t frequency = bit ? p : 65536 - p;
    const std::uint64_t start = bit ? 0 : p;
    if (state >= (frequency << 48))
    {
      words.push_back(static_cast<std::uint32_t>(state));
      state >>= 32;
    }
    state = ((state / frequency) << 16) + state % frequency + start;
  }
  ByteWriter out;
  if (this->Decisions.empty())
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

void EntropyDecoder::ThrowEnd()
{
  ThrowCorrupt("an entropy-coded stream ends too early");
}
}
