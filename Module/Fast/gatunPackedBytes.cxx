// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPackedBytes.h"

#include <zstd.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <new>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
/** A context of zstd, because making one takes as long as a small stream. Contexts that are not in
 * use are kept, but not by threads: programs of MinGW destroy the objects of a thread when their
 * memory is gone. */
template <auto Create, auto Free>
class Borrowed
{
public:
  Borrowed()
  {
    auto& kept = GetKept();
    const std::lock_guard lock(kept.Guard);
    if (kept.Idle.empty())
    {
      kept.Idle.reserve(++kept.Made); // so that returning it never fails
      this->Context = Pointer(Create(), Free);
    }
    else
    {
      this->Context = std::move(kept.Idle.back());
      kept.Idle.pop_back();
    }
    if (!this->Context)
    {
      throw std::bad_alloc();
    }
  }

  ~Borrowed()
  {
    auto& kept = GetKept();
    const std::lock_guard lock(kept.Guard);
    kept.Idle.push_back(std::move(this->Context));
  }

  Borrowed(const Borrowed&) = delete;
  Borrowed& operator=(const Borrowed&) = delete;

  auto* Get() const { return this->Context.get(); }

private:
  using Pointer = std::unique_ptr<std::remove_pointer_t<decltype(Create())>, decltype(Free)>;

  struct Kept
  {
    std::mutex Guard;
    std::vector<Pointer> Idle;
    std::size_t Made = 0;
  };

  /** Never destroyed, because other threads may still decode when a program ends. */
  static Kept& GetKept()
  {
    static Kept& kept = *new Kept;
    return kept;
  }

  Pointer Context{ nullptr, Free };
};
}

//------------------------------------------------------------------------------
void PutPacked(ByteWriter& out, std::span<const std::uint8_t> symbols)
{
  // Matches hardly occur, and are slower to decode than what they save.
  constexpr int shortestMatch = 7;
  const Borrowed<&ZSTD_createCCtx, &ZSTD_freeCCtx> context;
  auto* const packer = context.Get();
  ZSTD_CCtx_setParameter(packer, ZSTD_c_compressionLevel, 1);
  ZSTD_CCtx_setParameter(packer, ZSTD_c_minMatch, shortestMatch);
  ZSTD_CCtx_setParameter(packer, ZSTD_c_contentSizeFlag, 0);
  Bytes packed(ZSTD_compressBound(symbols.size()));
  const auto size =
    ZSTD_compress2(packer, packed.data(), packed.size(), symbols.data(), symbols.size());
  if (ZSTD_isError(size))
  {
    throw Error(ErrorCode::CannotWrite, std::string("zstd: ") + ZSTD_getErrorName(size));
  }
  const auto shortest =
    size < symbols.size() ? std::span<const std::uint8_t>(packed.data(), size) : symbols;
  out.PutVarint(shortest.size());
  out.PutBytes(shortest);
}

//------------------------------------------------------------------------------
void GetPacked(ByteReader& in, std::span<std::uint8_t> symbols)
{
  const auto bytes = in.GetBytes(in.GetVarint());
  if (bytes.size() == symbols.size())
  {
    std::copy(bytes.begin(), bytes.end(), symbols.begin());
    return;
  }
  const Borrowed<&ZSTD_createDCtx, &ZSTD_freeDCtx> context;
  const auto size =
    ZSTD_decompressDCtx(context.Get(), symbols.data(), symbols.size(), bytes.data(), bytes.size());
  if (size != symbols.size()) // an error is larger than any size
  {
    ThrowCorrupt("packed symbols are damaged");
  }
}
}
