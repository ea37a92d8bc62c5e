// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Any bytes as a stream of blocks of coefficients, or of a segment, and as corrections of voxels.
// Three bytes choose the block, three the grid, and one the part to decode.

#include "fuzzInput.h"
#include "gatunHartleyCodec.h"
#include "gatunHartleyCorrections.h"

#include <cmath>
#include <cstdlib>
#include <vector>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace gatun;
  fuzz::Input in(data, size);
  HartleyLayout::Triple block{};
  HartleyLayout::Triple grid{};
  for (auto& length : block)
  {
    length = 1 + in.TakeUpTo(8);
  }
  for (auto& length : grid)
  {
    length = 1 + in.TakeUpTo(3);
  }
  const auto kind = in.TakeUpTo(2);
  const auto stream = fuzz::Copy(in.TakeRest());
  fuzz::Accepts(
    [&]
    {
      if (kind == 2)
      {
        HartleyLayout layout;
        layout.Size = block;
        layout.Block = block;
        layout.Chunk = { 1, 1, 1 };
        HartleyCorrector corrector(stream, layout, { -3, 1e9 });
        std::vector<double> values(layout.GetVoxelsPerBlock(), 1e6 + 0.3);
        corrector.Correct({ 0, 0, 0 }, values);
        for (const double value : values)
        {
          if (!(value >= 0 && value <= 1e9 + 3 && value == std::floor(value)))
          {
            std::abort();
          }
        }
        return;
      }
      const HartleyOrder order(block);
      const auto blocks = kind == 1 ? 1 : std::size_t{ grid[0] } * grid[1] * grid[2];
      std::vector<std::int64_t> integers(order.GetPositions().size() * blocks);
      if (kind == 1)
      {
        DecodeHartleySegment(order, 0, stream, integers);
      }
      else
      {
        DecodeHartleyBlocks(order, grid, stream, integers);
      }
      // What is accepted can be written again.
      const auto again = kind == 1 ? EncodeHartleySegment(order, 0, integers)
                                   : EncodeHartleyBlocks(order, grid, integers);
      std::vector<std::int64_t> same(integers.size());
      if (kind == 1)
      {
        DecodeHartleySegment(order, 0, again, same);
      }
      else
      {
        DecodeHartleyBlocks(order, grid, again, same);
      }
      if (same != integers)
      {
        std::abort();
      }
    });
  return 0;
}
