// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// A chunk from any counts, box, shared points and streams.

#include "fuzzMeshes.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace gatun;
  fuzz::Input in(data, size);
  const auto frame = fuzz::TakeFrame(in, 400);
  const auto connectivity = fuzz::Copy(in.TakePart());
  const auto geometry = fuzz::Copy(in.TakeRest());
  fuzz::Accepts(
    [&]
    {
      const auto mesh = DecodeChunk(frame, connectivity, geometry);
      fuzz::CheckChunk(frame, mesh);
      ArrayContext(mesh, fuzz::GetFits(mesh));
    });
  return 0;
}
