// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPackedBytes.h"

#include <zstd.h>

#include <algorithm>
#include <memory>
#include <new>
#include <string>
#include <type_traits>

namespace gatun
{
namespace
{
/** A context of zstd for this thread, because making one takes as long as a small stream. */
template <auto Create, auto Free>
auto* GetContext()
{
  using Context = std::remove_pointer_t<decltype(Create())>;
  thread_local const std::unique_ptr<Context, decltype(Free)> context(Create(), Free);
  if (!context)
  {
    throw std::bad_alloc();
  }
  return context.get();
}
}

//------------------------------------------------------------------------------
void PutPacked(ByteWriter& out, std::span<const std::uint8_t> symbols)
{
  // Matches hardly occur, and are slower to decode than what they save.
  constexpr int shortestMatch = 7;
  auto* const packer = GetContext<&ZSTD_createCCtx, &ZSTD_freeCCtx>();
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
  auto* const unpacker = GetContext<&ZSTD_createDCtx, &ZSTD_freeDCtx>();
  const auto size =
    ZSTD_decompressDCtx(unpacker, symbols.data(), symbols.size(), bytes.data(), bytes.size());
  if (size != symbols.size()) // an error is larger than any size
  {
    ThrowCorrupt("packed symbols are damaged");
  }
}
}
