// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPolygonGrowth_h
#define gatunPolygonGrowth_h

#include "gatunPolygonCell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace gatun
{
/** Attaches cells to the front. Form: as of PolygonCell. */
template <typename Builder, typename Form>
class PolygonGrowth
{
public:
  using Cell = PolygonCell<Builder, Form>;

  PolygonGrowth(PolygonFront& front, Builder& mesh)
    : Open(front)
    , Mesh(mesh)
  {
  }

  /** Closes the glued faces of a cell and opens the others. getFrame(face) is stored with each one.
   */
  template <typename GetFrame>
  void Attach(const Cell& cell, std::uint32_t number, std::uint8_t type, GetFrame&& getFrame)
  {
    this->FindTouched(cell);
    for (const auto face : cell.Glued)
    {
      this->Open.Close(this->Open.GetSide(cell.GetFirstFrontSide(face)).Face);
    }
    if constexpr (!Cell::IsHexahedron)
    {
      this->NewSides.resize(cell.GetForm().Corner.size());
    }
    PolygonFront::Face opened{};
    opened.Form = cell.FormNumber;
    opened.Cell = number;
    opened.Type = type;
    opened.Open = true;
    for (unsigned f = 0; f < cell.GetForm().GetNumberOfFaces(); ++f)
    {
      if (!cell.IsGlued(f))
      {
        opened.Frame = static_cast<std::uint16_t>(getFrame(f));
        opened.FormFace = static_cast<std::uint8_t>(f);
        this->OpenFace(cell, opened);
      }
    }
    this->JoinEdges(cell);
    for (const auto& touch : this->Touched)
    {
      this->JoinTouched(cell, touch);
    }
  }

private:
  /** An edge of the cell where the front is already. */
  struct Touch
  {
    unsigned FormSide;
    std::uint32_t Side;
  };

  /** Finds open sides along edges of the cell that are on none of the glued faces. */
  void FindTouched(const Cell& cell)
  {
    const auto& form = cell.GetForm();
    this->Touched.clear();
    if (cell.Glued.empty())
    {
      return;
    }
    for (const auto& [side, twin] : form.Edges)
    {
      if (cell.IsGlued(form.Face[side]) || cell.IsGlued(form.Face[twin]))
      {
        continue;
      }
      const auto one = cell.GetCorner(form.Corner[side]);
      const auto other = cell.GetCorner(form.Corner[twin]);
      if (!cell.IsOld(one) || !cell.IsOld(other))
      {
        continue;
      }
      auto found = PolygonFront::None;
      this->Open.ForEachAround(one,
        [&](std::uint32_t begin)
        {
          const auto before = cell.GetLast(begin);
          const bool ends = this->Open.GetSide(cell.GetNext(begin)).Corner == other;
          if ((ends || this->Open.GetSide(before).Corner == other) &&
            !this->IsFaceGlued(cell, this->Open.GetSide(begin).Face))
          {
            found = ends ? begin : before;
          }
        });
      if (found != PolygonFront::None)
      {
        this->Touched.push_back({ side, found });
      }
    }
  }

  bool IsFaceGlued(const Cell& cell, std::uint32_t id) const
  {
    return std::any_of(cell.Glued.begin(), cell.Glued.end(),
      [&](std::uint8_t face)
      { return this->Open.GetSide(cell.GetFirstFrontSide(face)).Face == id; });
  }

  /** face: without its sides, degree and normal. */
  void OpenFace(const Cell& cell, PolygonFront::Face& face)
  {
    const auto& form = cell.GetForm();
    const unsigned degree = form.GetDegree(face.FormFace);
    auto* const news = &this->NewSides[form.GetFirstSide(face.FormFace)];
    if (face.FormFace != 0)
    {
      const auto begin = this->OpenSides(cell, face, [](unsigned i) { return i; });
      for (unsigned i = 0; i < degree; ++i)
      {
        news[i] = begin + i;
      }
    }
    else
    {
      // The gate of a seed is opened, too, in the direction of the other faces.
      const auto begin =
        this->OpenSides(cell, face, [degree](unsigned i) { return degree - 1 - i; });
      for (unsigned i = 0; i < degree; ++i)
      {
        news[(2 * degree - 2 - i) % degree] = begin + i;
      }
    }
  }

  /** Opens a face whose corner i is that of its side getPlace(i). Returns its first side. */
  template <typename GetPlace>
  GATUN_INLINE std::uint32_t OpenSides(
    const Cell& cell, PolygonFront::Face& face, GetPlace&& getPlace)
  {
    const auto& form = cell.GetForm();
    const unsigned first = form.GetFirstSide(face.FormFace);
    const unsigned degree = form.GetDegree(face.FormFace);
    std::array<Vertex, Form::MostCorners> corners;
    std::array<Vertex, Form::MostCorners> belows;
    for (unsigned i = 0; i < degree; ++i)
    {
      const unsigned side = first + getPlace(i);
      const auto below = form.Below[side];
      corners[i] = cell.GetCorner(form.Corner[side]);
      belows[i] = below != Form::None ? cell.GetCorner(below) : NoVertex;
    }
    const auto begin = ToVector(this->Mesh.GetPlace(corners[0]));
    auto last = ToVector(this->Mesh.GetPlace(corners[1])) - begin;
    Vec3 sum{};
    for (unsigned i = 2; i < degree; ++i)
    {
      const auto next = ToVector(this->Mesh.GetPlace(corners[i])) - begin;
      sum.Lanes = sum.Lanes + Cross(last, next).Lanes;
      last = next;
    }
    const float length = std::sqrt(Dot(sum, sum));
    face.Normal = { length > 0 ? sum.Lanes / Splat(length) : Splat(0.0F) };
    face.HasNormal = Dot(face.Normal, face.Normal) > 0.5F;
    return this->Open.AddFace(face, degree, corners.data(), belows.data());
  }

  /** Links the faces on the two sides of the edges of the cell. */
  void JoinEdges(const Cell& cell)
  {
    const auto& form = cell.GetForm();
    for (const auto& [one, other] : form.Edges)
    {
      const bool isGlued = cell.IsGlued(form.Face[one]);
      if (isGlued && cell.IsGlued(form.Face[other]))
      {
        this->JoinGlued(cell.FrontSides[one], cell.FrontSides[other]);
      }
      else if (isGlued)
      {
        this->JoinToGlued(this->NewSides[other], cell.FrontSides[one]);
      }
      else if (cell.IsGlued(form.Face[other]))
      {
        this->JoinToGlued(this->NewSides[one], cell.FrontSides[other]);
      }
      else
      {
        this->JoinOpened(cell, one, other);
      }
    }
  }

  void JoinOpened(const Cell& cell, unsigned one, unsigned other)
  {
    this->Open.Join(this->NewSides[one], this->NewSides[other], 1);
    if (std::none_of(this->Touched.begin(), this->Touched.end(),
          [&](const Touch& touch) { return touch.FormSide == one; }))
    {
      this->Mesh.LogEdge(cell.GetCorner(cell.GetForm().Corner[one]), cell.GetEnd(one));
    }
  }

  /** Links an opened side to the link over the side of a glued face. */
  void JoinToGlued(std::uint32_t side, std::uint32_t glued)
  {
    const auto link = this->Open.GetSide(glued).Over;
    const auto over = this->Open.GetOpen(glued);
    if (over != PolygonFront::None)
    {
      this->Open.Join(side, over, link.GetCells() + 1);
    }
    else
    {
      this->End(side, link, link.GetCells() + 1);
    }
  }

  /** Joins the links over the sides of two glued faces. */
  void JoinGlued(std::uint32_t one, std::uint32_t other)
  {
    const auto link = this->Open.GetSide(one).Over;
    const auto otherLink = this->Open.GetSide(other).Over;
    const auto over = this->Open.GetOpen(one);
    const auto otherOver = this->Open.GetOpen(other);
    const auto cells = link.GetCells() + otherLink.GetCells() + 1;
    if (over != PolygonFront::None && otherOver != PolygonFront::None)
    {
      this->Open.Join(over, otherOver, cells);
    }
    else if (over != PolygonFront::None)
    {
      this->End(over, otherLink, cells);
    }
    else if (otherOver != PolygonFront::None)
    {
      this->End(otherOver, link, cells);
    }
  }

  /** Links a side to the border that another one had a link to. */
  void End(std::uint32_t side, SideLink border, unsigned cells)
  {
    this->Open.GetSide(side).Over =
      SideLink::ToBorder(border.IsBorder() ? border.GetFar() : NoVertex, cells);
  }

  /** Where the front touches itself in an edge, its faces are linked in pairs. */
  void JoinTouched(const Cell& cell, const Touch& touch)
  {
    const auto side = touch.Side;
    const auto link = this->Open.GetSide(side).Over;
    const auto over = this->Open.GetOpen(side);
    const auto a = this->NewSides[touch.FormSide];
    const auto b = this->NewSides[cell.GetForm().Twin[touch.FormSide]];
    const bool against = this->Open.GetSide(a).Corner != this->Open.GetSide(side).Corner;
    const auto cells = link.GetCells() + 1;
    this->Open.Join(side, against ? a : b, cells);
    const auto rest = against ? b : a;
    if (over != PolygonFront::None)
    {
      this->Open.Join(over, rest, cells);
    }
    else
    {
      this->End(rest, link, cells);
    }
  }

  PolygonFront& Open;
  Builder& Mesh;
  typename Form::template OfSides<std::uint32_t> NewSides; // the sides of the front
  std::vector<Touch> Touched;
};
}

#endif
