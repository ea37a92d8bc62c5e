// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunFormBuilder.h"

#include "gatunError.h"

namespace gatun
{
void FormBuilder::ThrowOpen()
{
  ThrowCorrupt("a shape of a cell is not a closed surface");
}

//------------------------------------------------------------------------------
void FormBuilder::Begin(unsigned degree)
{
  if (degree < 3 || degree > MaxSurfaceCorners)
  {
    ThrowOpen();
  }
  for (unsigned i = 0; i < this->Corners; ++i)
  {
    this->Edges[i].reset();
    this->FacesAt[i] = 0;
  }
  this->Queue.clear();
  this->Head = 0;
  this->Sides.clear();
  this->FirstSides = { 0, static_cast<std::uint16_t>(degree) };
  this->Corners = degree;
  for (unsigned i = 0; i < degree; ++i)
  {
    const auto next = (i + 1) % degree;
    this->Sides.push_back(static_cast<std::uint8_t>(i));
    this->Queue.push_back({ static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(next) });
    this->Edges[next].set(i);
    ++this->FacesAt[i];
  }
}

bool FormBuilder::FindEdge()
{
  while (this->Head < this->Queue.size() &&
    this->Edges[this->Queue[this->Head][0]][this->Queue[this->Head][1]])
  {
    ++this->Head;
  }
  if (this->Head == this->Queue.size())
  {
    return false;
  }
  this->Edge = this->Queue[this->Head];
  return true;
}

void FormBuilder::BeginFace(unsigned size)
{
  if (size < 3 || size > MaxSurfaceCorners || this->FirstSides.size() > MaxSurfaceFaces)
  {
    ThrowOpen();
  }
  this->Sides.push_back(this->Edge[0]);
  this->Sides.push_back(this->Edge[1]);
  this->Left = size - 2;
}

void FormBuilder::AddCorner(unsigned corner)
{
  if (corner > this->Corners || corner >= MaxSurfaceCorners)
  {
    ThrowOpen();
  }
  this->Corners += corner == this->Corners;
  this->Sides.push_back(static_cast<std::uint8_t>(corner));
  if (--this->Left > 0)
  {
    return;
  }
  const auto first = this->FirstSides.back();
  const auto size = this->Sides.size() - first;
  for (std::size_t i = 0; i < size; ++i)
  {
    const auto from = this->Sides[first + i];
    const auto to = this->Sides[first + (i + 1) % size];
    if (from == to || this->Edges[from][to])
    {
      ThrowOpen();
    }
    this->Edges[from].set(to);
    this->Queue.push_back({ to, from });
    ++this->FacesAt[from];
  }
  this->FirstSides.push_back(static_cast<std::uint16_t>(this->Sides.size()));
}
}
