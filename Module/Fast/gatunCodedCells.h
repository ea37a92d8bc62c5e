// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCodedCells_h
#define gatunCodedCells_h

// The cells of a CellTree while it is encoded.

#include "gatunCellTemplates.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
using SourceCells = std::array<std::uint32_t, CellTemplate::MaxSources>;

/** A cell as it is coded. */
struct CodedCell
{
  std::uint32_t First = 0; // of its points
  std::uint32_t Points = 0;
  std::uint32_t Hidden = 0; // of them, those that are no corners, the last ones
  std::uint32_t Next = 0;   // the vertices before it
  SourceCells From{};
  std::uint32_t Template = 0;
};

/** Cells in their order, with the numbers of vertices. */
struct CodedCells
{
  static constexpr std::uint32_t None = 0xffffffffu;

  std::vector<CodedCell> Items;
  std::vector<std::uint32_t> Points; // of all

  std::span<const std::uint32_t> GetPoints(std::uint32_t cell) const
  {
    return std::span(this->Points).subspan(this->Items[cell].First, this->Items[cell].Points);
  }

  std::span<const std::uint32_t> GetCorners(std::uint32_t cell) const
  {
    return this->GetPoints(cell).first(this->Items[cell].Points - this->Items[cell].Hidden);
  }

  /** Where a vertex is among the first corners of sources, reach each; or None. */
  std::uint32_t FindNear(
    std::uint32_t vertex, const SourceCells& from, unsigned sources, std::size_t reach) const
  {
    for (unsigned s = 0; s < sources; ++s)
    {
      const auto corners = this->GetCorners(from[s]);
      const auto first = corners.first(std::min(corners.size(), reach));
      const auto found = std::find(first.begin(), first.end(), vertex);
      if (found != first.end())
      {
        return static_cast<std::uint32_t>(
          s * reach + static_cast<std::size_t>(found - first.begin()));
      }
    }
    return None;
  }
};
}

#endif
