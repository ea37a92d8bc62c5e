// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Any stream as the values of cell arrays, of shared points and of coordinates outside a walk.

#include "fuzzMeshes.h"
#include "gatunArrayCodec.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace gatun;
  fuzz::Input in(data, size);
  auto array = fuzz::TakeCellArray(in);
  const auto stream = fuzz::Copy(in.TakeRest());
  if (fuzz::Accepts(
        [&] {
          DecodeCellValues(
            stream, { array.Parents, &fuzz::GetTupleFit() }, array.Domains, array.Keys);
        }))
  {
    fuzz::CheckKeys(array);
  }
  return 0;
}
