// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellRows.h"

#include "gatunCellShapes.h"

#include <algorithm>
#include <utility>

namespace gatun
{
namespace
{
class RowFinder
{
public:
  RowFinder(const CellList& cells, const CellUsers& users)
    : Cells(cells)
    , Users(users)
    , States(cells.GetNumber())
  {
    for (std::size_t c = 0; c < this->States.size(); ++c)
    {
      this->States[c].Sides =
        static_cast<std::uint8_t>(std::max(1, GetCellKind(cells.Types[c]).Dimension));
    }
    this->Order.reserve(cells.GetNumber());
  }

  std::vector<std::uint32_t> Run()
  {
    std::uint32_t first = 0;
    std::vector<std::uint32_t> neighbors;
    for (std::size_t head = 0; this->Order.size() < this->States.size(); ++head)
    {
      if (head == this->Order.size())
      {
        while (this->States[first].IsDone)
        {
          ++first;
        }
        this->Add(first);
      }
      const auto cell = this->Order[head];
      neighbors.clear();
      this->EachNeighbor(cell, {},
        [&](std::uint32_t other)
        {
          neighbors.push_back(other);
          return true;
        });
      for (const auto other : neighbors)
      {
        this->AddRow(cell, other);
      }
    }
    return std::move(this->Order);
  }

private:
  static constexpr std::uint32_t None = 0xffffffffu;

  void Add(std::uint32_t cell)
  {
    this->States[cell].IsDone = true;
    this->Order.push_back(cell);
  }

  /** Adds the row of cells from one to another one and further on. */
  void AddRow(std::uint32_t cell, std::uint32_t other)
  {
    while (other != None && !this->States[other].IsDone)
    {
      this->Add(other);
      const auto next = this->FindOpposite(cell, other);
      cell = other;
      other = next;
    }
  }

  /** The neighbor of a cell that does not touch the one before. */
  std::uint32_t FindOpposite(std::uint32_t before, std::uint32_t cell)
  {
    std::uint32_t found = None;
    const auto touched = this->GetCorners(before);
    this->EachNeighbor(cell, touched,
      [&](std::uint32_t other)
      {
        const auto corners = this->GetCorners(other);
        const bool touches = std::find_first_of(corners.begin(), corners.end(), touched.begin(),
                               touched.end()) != corners.end();
        found = touches ? None : other;
        return touches;
      });
    return found;
  }

  std::span<const std::uint32_t> GetCorners(std::uint32_t cell) const
  {
    return CellUsers::GetFirst(this->Cells.GetCorners(cell));
  }

  /** Calls code(neighbor) for those that are not in the order yet, until it returns false. Those
   * that have some of the corners without may be left out. */
  template <typename Code>
  void EachNeighbor(std::uint32_t cell, std::span<const std::uint32_t> without, Code&& code)
  {
    this->Near.clear();
    for (const auto corner : this->GetCorners(cell))
    {
      if (std::find(without.begin(), without.end(), corner) != without.end())
      {
        continue;
      }
      for (const auto other : this->Users.Get(corner))
      {
        auto& state = this->States[other];
        if (!state.IsDone && state.Common++ == 0)
        {
          this->Near.push_back(other);
        }
      }
    }
    bool goesOn = true;
    for (const auto other : this->Near)
    {
      const auto common = std::exchange(this->States[other].Common, 0);
      goesOn = goesOn &&
        (other == cell || common < std::max(this->States[cell].Sides, this->States[other].Sides) ||
          code(other));
    }
  }

  const CellList& Cells;
  const CellUsers& Users;
  std::vector<std::uint32_t> Order;
  struct State
  {
    std::uint32_t Common = 0; // corners with the cell that is looked at
    std::uint8_t Sides = 0;   // the corners that neighbors must have in common
    bool IsDone = false;
  };
  std::vector<State> States; // of cells
  std::vector<std::uint32_t> Near;
};
}

//------------------------------------------------------------------------------
CellUsers::CellUsers(const CellList& cells, std::size_t vertices)
  : Starts(vertices + 1, 0)
{
  for (std::size_t c = 0; c < cells.GetNumber(); ++c)
  {
    for (const auto corner : GetFirst(cells.GetCorners(c)))
    {
      ++this->Starts[corner + 1];
    }
  }
  for (std::size_t v = 0; v < vertices; ++v)
  {
    this->Starts[v + 1] += this->Starts[v];
  }
  this->Users.resize(this->Starts.back());
  auto next = this->Starts;
  for (std::uint32_t c = 0; c < cells.GetNumber(); ++c)
  {
    for (const auto corner : GetFirst(cells.GetCorners(c)))
    {
      this->Users[next[corner]++] = c;
    }
  }
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> FindCellRows(const CellList& cells, const CellUsers& users)
{
  return RowFinder(cells, users).Run();
}
}
