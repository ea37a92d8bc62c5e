// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "benchZfp.h"

#include "benchHarness.h"

#if BENCH_HAS_ZFP
#include <zfp.h>

#include <memory>
#endif

namespace bench
{
//------------------------------------------------------------------------------
bool HasZfp()
{
  return BENCH_HAS_ZFP;
}

#if BENCH_HAS_ZFP
namespace
{
struct Close
{
  void operator()(zfp_stream* stream) const { zfp_stream_close(stream); }
  void operator()(zfp_field* field) const { zfp_field_free(field); }
  void operator()(bitstream* stream) const { stream_close(stream); }
};

void SetMode(zfp_stream* stream, ZfpMode mode, double value)
{
  switch (mode)
  {
    case ZfpMode::Accuracy:
      zfp_stream_set_accuracy(stream, value);
      return;
    case ZfpMode::Reversible:
      zfp_stream_set_reversible(stream);
      return;
    default:
      zfp_stream_set_precision(stream, static_cast<unsigned>(value));
  }
}

/** Compresses values and puts in their place what comes back; returns the bytes in between. */
template <typename Value>
std::uint64_t ThereAndBack(std::vector<Value>& values, zfp_type type,
  const std::array<std::uint32_t, 3>& size, ZfpMode mode, double value)
{
  const std::unique_ptr<zfp_field, Close> field(
    zfp_field_3d(values.data(), type, size[0], size[1], size[2]));
  const std::unique_ptr<zfp_stream, Close> stream(zfp_stream_open(nullptr));
  SetMode(stream.get(), mode, value);
  std::vector<unsigned char> bytes(zfp_stream_maximum_size(stream.get(), field.get()));
  const std::unique_ptr<bitstream, Close> bits(stream_open(bytes.data(), bytes.size()));
  zfp_stream_set_bit_stream(stream.get(), bits.get());
  zfp_stream_rewind(stream.get());
  const std::size_t written = zfp_compress(stream.get(), field.get());
  zfp_stream_rewind(stream.get());
  if (written == 0 || zfp_decompress(stream.get(), field.get()) == 0)
  {
    throw Failure("zfp fails");
  }
  return written;
}
}

//------------------------------------------------------------------------------
ZfpResult RunZfp(const std::vector<float>& voxels, const std::array<std::uint32_t, 3>& size,
  ZfpMode mode, double value)
{
  ZfpResult result;
  result.Voxels = voxels;
  if (mode == ZfpMode::Accuracy || mode == ZfpMode::Precision)
  {
    result.Bytes = ThereAndBack(result.Voxels, zfp_type_float, size, mode, value);
    return result;
  }
  std::vector<std::int32_t> integers(voxels.begin(), voxels.end());
  result.Bytes = ThereAndBack(integers, zfp_type_int32, size, mode, value);
  result.Voxels.assign(integers.begin(), integers.end());
  return result;
}
#else
//------------------------------------------------------------------------------
ZfpResult RunZfp(const std::vector<float>&, const std::array<std::uint32_t, 3>&, ZfpMode, double)
{
  throw Failure("zfp (libzfp-dev) was not there when this was built");
}
#endif
}
