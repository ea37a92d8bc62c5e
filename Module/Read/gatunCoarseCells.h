// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCoarseCells_h
#define gatunCoarseCells_h

#include "gatunPieceRequest.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gatun
{
/** Replaces the corners of a cell by their ancestors. Returns false if it is a triangle or a
 * tetrahedron that vanishes; cells of other types never do. */
bool SimplifyCell(
  std::uint8_t type, std::span<std::uint32_t> corners, std::span<const std::uint32_t> ancestors);

/** Cells after merges, with any numbers of corners, or tetrahedra alone. */
class CoarseCells
{
public:
  CoarseCells() = default;
  explicit CoarseCells(PieceForm form)
    : Form(form)
  {
  }

  bool IsTetrahedral() const { return this->Form == PieceForm::Tetrahedra; }
  std::size_t GetCount() const
  {
    return this->IsTetrahedral() ? this->Corners.size() / 4 : this->Types.size();
  }
  std::uint8_t GetType(std::size_t cell) const;
  std::span<const std::uint32_t> GetCorners(std::size_t cell) const
  {
    const auto begin = this->IsTetrahedral() ? 4 * cell : this->Begins[cell];
    return std::span(this->Corners).subspan(begin, this->GetEnd(cell) - begin);
  }

  /** All corners of all cells. */
  std::span<std::uint32_t> GetAllCorners() { return this->Corners; }
  std::span<const std::uint32_t> GetAllCorners() const { return this->Corners; }

  void Add(std::uint8_t type, std::span<const std::uint32_t> corners);

  /** Adds a cell with the ancestors of its corners, and returns true, unless it vanishes. */
  bool AddSimplified(std::uint8_t type, std::span<const std::uint32_t> corners,
    std::span<const std::uint32_t> ancestors);

  /** The cells in another order. places: the new place of each. */
  CoarseCells Permute(std::span<const std::uint32_t> places) const;

  /** Copies the cells to a target. */
  void Store(const PieceTarget& target) const;

private:
  std::size_t GetEnd(std::size_t cell) const
  {
    return this->IsTetrahedral()       ? 4 * cell + 4
      : cell + 1 < this->Begins.size() ? this->Begins[cell + 1]
                                       : this->Corners.size();
  }

  PieceForm Form = PieceForm::Tetrahedra;
  std::vector<std::uint32_t> Corners;
  std::vector<std::size_t> Begins; // in Corners, and
  std::vector<std::uint8_t> Types; // of each cell, unless all are tetrahedra
};
}

#endif
