// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPieceSelection.h"

#include <algorithm>
#include <numeric>

namespace gatun
{
namespace
{
/** The cells of a set of chunks, and which of them are alive. */
struct SetCells
{
  SetCells(const ChunkSetDecoder& set, const CellMask* mask, bool isRestored,
    const PieceSelection::Progress& progress)
    : Memory(set.GetSet().GetForm() == PieceForm::Tetrahedra,
        static_cast<std::size_t>(set.GetNumberOfCells()),
        static_cast<std::size_t>(set.GetSet().GetConnectivitySize()),
        static_cast<std::size_t>(set.GetSet().GetFacesSize()))
    , IsAlive(static_cast<std::size_t>(set.GetNumberOfCells()), 1)
  {
    std::vector<std::uint64_t> numbers(mask ? this->IsAlive.size() : 0);
    PieceTarget target = this->Memory.GetTarget();
    target.FileCells = mask ? numbers.data() : nullptr;
    set.Fill(target, {}, 0, isRestored, progress);
    for (std::size_t c = 0; c < numbers.size(); ++c)
    {
      this->IsAlive[c] = mask->IsAlive[static_cast<std::size_t>(numbers[c])];
    }
  }

  PieceCells Memory;
  std::vector<char> IsAlive;
};
}

//------------------------------------------------------------------------------
PieceSelection::PieceSelection(const ChunkSetDecoder& decoder, const ChunkSet& piece,
  const PieceCut& cut, const Progress& progress)
  : Memory(true, 0, 0, 0)
{
  const ChunkSet& around = decoder.GetSet();
  const SetCells all(decoder, cut.Mask, cut.IsRestored, progress);
  const auto cells = all.IsAlive.size();
  std::vector<char> chosen(cells, 0);
  const auto choose = [&](std::size_t c)
  {
    this->Cells.push_back(c);
    chosen[c] = 1;
  };
  const auto& owned = piece.GetChunks();
  for (std::size_t i = 0; i < around.GetChunks().size(); ++i)
  {
    // In the original order the cells of chunks are mixed, but all of them are of the piece.
    if (std::binary_search(owned.begin(), owned.end(), around.GetChunks()[i]))
    {
      const auto first = static_cast<std::size_t>(around.GetFirstCell(i));
      for (auto c = first; c < first + around.GetNumberOfCells(i); ++c)
      {
        if (all.IsAlive[c])
        {
          choose(c);
        }
      }
    }
  }
  this->OwnCells = this->Cells.size();

  const auto count = static_cast<std::size_t>(around.GetNumberOfPoints());
  std::vector<char> reached(count, 0);
  const auto reach = [&](std::size_t begin)
  {
    for (auto i = begin; i < this->Cells.size(); ++i)
    {
      all.Memory.ForEachPoint(
        static_cast<std::size_t>(this->Cells[i]), [&](std::size_t point) { reached[point] = 1; });
    }
  };
  reach(0);
  if (cut.IsRestored)
  {
    this->Points.resize(count);
    std::iota(this->Points.begin(), this->Points.end(), std::uint64_t{ 0 });
  }
  else
  {
    this->Points = around.Locate(piece);
  }
  if (cut.Mask && cut.Mask->DropsPoints)
  {
    std::erase_if(
      this->Points, [&](std::uint64_t p) { return !reached[static_cast<std::size_t>(p)]; });
  }
  this->OwnPoints = this->Points.size();
  std::vector<char> isOfPiece(count, 0);
  for (const auto p : this->Points)
  {
    isOfPiece[static_cast<std::size_t>(p)] = 1;
  }
  // Unused points belong to the piece but have no ghosts.
  for (unsigned level = 0; level < cut.GhostLevels; ++level)
  {
    const auto begin = this->Cells.size();
    for (std::size_t c = 0; c < cells; ++c)
    {
      char touches = 0;
      all.Memory.ForEachPoint(c, [&](std::size_t point) { touches |= reached[point]; });
      if (!chosen[c] && touches && all.IsAlive[c])
      {
        choose(c);
      }
    }
    if (this->Cells.size() == begin)
    {
      break; // nothing more can be reached
    }
    reach(begin);
  }
  for (std::size_t p = 0; p < count; ++p)
  {
    if (reached[p] && !isOfPiece[p])
    {
      this->Points.push_back(p);
    }
  }
  std::vector<std::int64_t> placeOf(count, -1);
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    placeOf[static_cast<std::size_t>(this->Points[i])] = static_cast<std::int64_t>(i);
  }
  this->Memory = all.Memory.Select(this->Cells, placeOf);
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> PieceSelection::FindOwners(
  const ChunkSetDecoder& decoder, const CellMask& mask, const Progress& progress)
{
  const ChunkSet& around = decoder.GetSet();
  const SetCells all(decoder, &mask, false, progress);
  std::vector<std::uint32_t> owners(static_cast<std::size_t>(around.GetNumberOfPoints()), NoChunk);
  for (std::size_t i = 0; i < around.GetChunks().size(); ++i)
  {
    const auto first = static_cast<std::size_t>(around.GetFirstCell(i));
    for (auto c = first; c < first + around.GetNumberOfCells(i); ++c)
    {
      if (all.IsAlive[c])
      {
        all.Memory.ForEachPoint(
          c, [&](std::size_t p) { owners[p] = std::min(owners[p], around.GetChunks()[i]); });
      }
    }
  }
  return owners;
}
}
