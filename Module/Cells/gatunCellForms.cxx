// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunCellForms.h"

#include "gatunBytes.h"
#include "gatunHexForm.h"

#include <algorithm>
#include <set>

namespace gatun
{
namespace
{
/** Gives the faces of a code to a builder. */
void ReadFaces(std::span<const std::uint8_t> code, FormBuilder& form)
{
  ByteReader in(code);
  form.Begin(in.Get<std::uint8_t>());
  while (form.FindEdge())
  {
    const unsigned size = in.Get<std::uint8_t>();
    form.BeginFace(size);
    for (unsigned i = 2; i < size; ++i)
    {
      form.AddCorner(in.Get<std::uint8_t>());
    }
  }
  if (in.GetRemaining() > 0)
  {
    FormBuilder::ThrowOpen();
  }
}

unsigned FindFamily(const CellForm& form)
{
  const auto faces = form.GetNumberOfFaces();
  unsigned triangles = 0;
  unsigned quads = 0;
  for (unsigned f = 0; f < faces; ++f)
  {
    triangles += form.GetDegree(f) == 3;
    quads += form.GetDegree(f) == 4;
  }
  return faces != triangles + quads ? 4
    : triangles == 4 && quads == 0  ? 0
    : triangles == 4 && quads == 1  ? 1
    : triangles == 2 && quads == 3  ? 2
    : triangles == 0 && quads == 6  ? 3
                                    : 4;
}
}

//------------------------------------------------------------------------------
CellForm::CellForm(std::span<const std::uint8_t> code)
{
  FormBuilder builder;
  ReadFaces(code, builder);
  *this = CellForm(builder);
}

CellForm::CellForm(const FormBuilder& builder)
  : Corners(builder.GetCorners())
  , FirstSides(builder.GetFirstSides())
  , Corner(builder.GetSides())
{
  if (!IsClosedSurface(this->GetSurface(), this->Corners))
  {
    FormBuilder::ThrowOpen();
  }
  this->Family = FindFamily(*this);
  std::vector<std::uint16_t> sides(std::size_t{ this->Corners } * this->Corners);
  std::vector<CellGraph::Local> faces;
  for (unsigned f = 0; f < this->GetNumberOfFaces(); ++f)
  {
    const unsigned first = this->FirstSides[f];
    const unsigned degree = this->GetDegree(f);
    faces.push_back(static_cast<CellGraph::Local>(degree));
    this->FaceMasks.push_back(0);
    for (unsigned i = 0; i < degree; ++i)
    {
      const auto from = this->Corner[first + i];
      const auto to = this->Corner[first + (i + 1) % degree];
      faces.push_back(from);
      this->Face.push_back(static_cast<std::uint8_t>(f));
      this->FaceMasks.back() |= std::uint64_t{ 1 } << (from % 64u);
      // The gate runs the other way.
      const auto place = f == 0 ? std::size_t{ to } * this->Corners + from
                                : std::size_t{ from } * this->Corners + to;
      sides[place] = static_cast<std::uint16_t>(first + i);
    }
  }
  this->Graph = CellGraph(this->Corners, faces);
  this->Twin.resize(this->Corner.size());
  for (unsigned from = 0; from < this->Corners; ++from)
  {
    for (const auto to : this->Graph.GetNeighbors(from))
    {
      this->Twin[sides[std::size_t{ from } * this->Corners + to]] =
        sides[std::size_t{ to } * this->Corners + from];
    }
  }
  const auto sideCount = static_cast<std::uint16_t>(this->Corner.size());
  for (std::uint16_t side = 0; side < sideCount; ++side)
  {
    if (side < this->Twin[side])
    {
      this->Edges.push_back({ side, this->Twin[side] });
    }
    const unsigned f = this->Face[side];
    const auto begin = this->Corner.begin() + this->FirstSides[f];
    const auto end = this->Corner.begin() + this->FirstSides[f + 1];
    unsigned count = 0;
    std::uint8_t below = None;
    for (const auto near : this->Graph.GetNeighbors(this->Corner[side]))
    {
      if (std::find(begin, end, near) == end)
      {
        below = static_cast<std::uint8_t>(near);
        ++count;
      }
    }
    this->Below.push_back(count == 1 ? below : None);
  }
}

std::vector<std::uint8_t> CellForm::GetSurface() const
{
  std::vector<std::uint8_t> surface;
  for (unsigned f = 0; f < this->GetNumberOfFaces(); ++f)
  {
    const auto begin = this->Corner.begin() + this->FirstSides[f];
    const auto end = this->Corner.begin() + this->FirstSides[f + 1];
    surface.push_back(static_cast<std::uint8_t>(end - begin));
    surface.insert(surface.end(), begin, end);
    if (f == 0)
    {
      std::reverse(surface.begin() + 1, surface.end());
    }
  }
  return surface;
}

//------------------------------------------------------------------------------
bool FormTable::AddShape(SurfaceView faces, unsigned corners)
{
  FormMaker maker;
  std::set<FormCode, FormOrder> codes;
  unsigned gate = 0;
  for (std::size_t at = 0; at < faces.size(); at += 1u + faces[at], ++gate)
  {
    for (unsigned start = 0; start < faces[at]; ++start)
    {
      maker.Make(faces, corners, gate, start, false);
      codes.insert(maker.GetCode());
    }
  }
  const auto sides = codes.size() * (faces.size() - gate);
  if (this->Codes.count(*codes.begin()) != 0 || this->Forms.size() + codes.size() > MaxForms ||
    this->Sides + sides > MaxSides)
  {
    return false;
  }
  this->Sides += sides;
  for (const auto& code : codes)
  {
    this->Codes[code] = static_cast<std::uint16_t>(this->Forms.size());
    this->Forms.emplace_back(code).Shape = this->Shapes;
  }
  ++this->Shapes;
  return true;
}

void FormTable::MakeFrames()
{
  FormMaker maker;
  for (const int type : { 10, 11, 12, 13, 14, 15, 16 })
  {
    const auto* shape = GetCellKind(type).Shape;
    std::vector<Frame> frames(Frames);
    bool any = false;
    unsigned gate = 0;
    for (std::size_t at = 0; at < shape->Faces.size(); at += 1u + shape->Faces[at], ++gate)
    {
      for (unsigned start = 0; start < shape->Faces[at]; ++start)
      {
        for (const bool mirrored : { false, true })
        {
          maker.Make(shape->Faces, shape->Corners, gate, start, mirrored);
          auto& frame = frames[MakeFrame(gate, start, mirrored)];
          frame = { this->Find(maker.GetCode()), maker.GetOrder(), maker.GetFaces() };
          any = any || frame.Form != None;
        }
      }
    }
    if (any)
    {
      this->FramesOf[shape] = std::move(frames);
    }
  }
}

std::uint16_t FormTable::Find(const FormCode& code) const
{
  const auto found = this->Codes.find(code);
  return found != this->Codes.end() ? found->second : None;
}

std::uint16_t FormTable::FindHexahedron() const
{
  FormCode code;
  code.push_back(4);
  for (unsigned face = 1; face < HexForm::GetNumberOfFaces(); ++face)
  {
    const auto side = HexForm::GetFirstSide(face);
    code.push_back(4);
    code.push_back(HexForm::Corner[side + 2]);
    code.push_back(HexForm::Corner[side + 3]);
  }
  return this->Find(code);
}

std::span<const FormTable::Frame> FormTable::GetFrames(const CellShape* shape) const
{
  const auto found = this->FramesOf.find(shape);
  return found != this->FramesOf.end() ? std::span<const Frame>(found->second)
                                       : std::span<const Frame>();
}
}
