// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCompress.h"

#include <zstd.h>
#include <zstd_errors.h>

#include <algorithm>
#include <memory>
#include <new>
#include <string>

namespace gatun
{
//------------------------------------------------------------------------------
Bytes Compress(std::span<const std::uint8_t> bytes)
{
  ByteWriter out;
  out.PutVarint(bytes.size());
  const auto start = out.Data.size();
  out.Data.resize(start + ZSTD_compressBound(bytes.size()));
  const auto size =
    ZSTD_compress(out.Data.data() + start, out.Data.size() - start, bytes.data(), bytes.size(), 12);
  if (ZSTD_isError(size))
  {
    throw Error(ErrorCode::CannotWrite, std::string("zstd: ") + ZSTD_getErrorName(size));
  }
  out.Data.resize(start + size);
  return std::move(out.Data);
}

//------------------------------------------------------------------------------
Bytes Decompress(std::span<const std::uint8_t> bytes, std::uint64_t limit)
{
  ByteReader in(bytes);
  const auto size = in.GetVarint();
  const auto packed = in.GetBytes(in.GetRemaining());
  if (size > limit)
  {
    ThrowCorrupt("a compressed part claims to hold " + std::to_string(size) + " bytes");
  }
  // The output grows with the data, because the length may be wrong.
  const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(
    ZSTD_createDCtx(), &ZSTD_freeDCtx);
  if (!context)
  {
    throw std::bad_alloc();
  }
  Bytes out;
  ZSTD_inBuffer source{ packed.data(), packed.size(), 0 };
  for (std::size_t state = 1; state != 0;)
  {
    const auto old = out.size();
    out.resize(std::min<std::uint64_t>(size, std::max<std::size_t>(2 * old, 1 << 16)));
    ZSTD_outBuffer target{ out.data(), out.size(), old };
    const auto before = source.pos;
    state = ZSTD_decompressStream(context.get(), &target, &source);
    if (ZSTD_getErrorCode(state) == ZSTD_error_memory_allocation)
    {
      throw std::bad_alloc();
    }
    if (ZSTD_isError(state) || (state != 0 && target.pos == old && source.pos == before))
    {
      ThrowCorrupt("a compressed part is damaged");
    }
    out.resize(target.pos);
  }
  if (out.size() != size || source.pos != source.size)
  {
    ThrowCorrupt("a compressed part has the wrong length");
  }
  return out;
}
}
