// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Any stream as the values of point arrays, with and without a time step before.

#include "fuzzMeshes.h"
#include "gatunArrayCodec.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace gatun;
  static const fuzz::SmallChunk small(Profile::Small);
  static const fuzz::SmallChunk fast(Profile::Fast);
  for (const auto* chunk : { &small, &fast })
  {
    fuzz::Input in(data, size);
    auto array = fuzz::TakePointArray(in, *chunk);
    const auto stream = fuzz::Copy(in.TakeRest());
    if (fuzz::Accepts(
          [&] { DecodePointValues(stream, chunk->GetContext(), array.Domains, array.Keys); }))
    {
      fuzz::CheckKeys(array);
    }
  }
  return 0;
}
