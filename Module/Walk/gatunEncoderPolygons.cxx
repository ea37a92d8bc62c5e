// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunEncoderPolygons.h"

#include "gatunCellNodes.h"
#include "gatunCellShapes.h"
#include "gatunVertexHash.h"

#include <algorithm>
#include <bit>

namespace gatun
{
//------------------------------------------------------------------------------
EncoderPolygons::EncoderPolygons(const CellList& cells, const FormTable& forms)
  : Forms(forms)
{
  for (std::uint32_t c = 0; c < cells.GetNumber(); ++c)
  {
    const auto kind = GetCellKind(cells.Types[c]);
    const auto corners = cells.GetCorners(c);
    if (cells.Types[c] == PolyhedronType)
    {
      if (this->Polyhedron.Set(corners, cells.GetFaces(c)))
      {
        this->AddSurface(cells, c, nullptr);
        continue;
      }
    }
    else if (kind.Shape &&
      (kind.IsLinear() ? corners.size() == kind.Points
                       : CanFindCellNodes(cells.Types[c], corners.size())) &&
      !forms.GetFrames(kind.Shape).empty() && !HasTwice(corners.first(kind.Shape->Corners)))
    {
      this->AddSurface(cells, c, kind.Shape);
      continue;
    }
    this->Others.push_back(c);
  }
  const auto places = std::bit_ceil(this->Faces.size() + 1);
  this->Heads.assign(places, None);
  for (std::size_t f = this->Faces.size(); f-- > 0;)
  {
    auto& head = this->Heads[this->Faces[f].Hash & (places - 1)];
    this->Faces[f].Next = head;
    head = static_cast<std::uint32_t>(f);
  }
}

void EncoderPolygons::AddSurface(const CellList& cells, std::uint32_t cell, const CellShape* shape)
{
  Surface surface{ cell, cells.Types[cell], shape, static_cast<std::uint32_t>(this->Faces.size()),
    static_cast<std::uint32_t>(this->Locals.size()), 0,
    static_cast<std::uint32_t>(this->Points.size()), 0, false };
  if (shape)
  {
    const auto corners = cells.GetCorners(cell).first(shape->Corners);
    this->Points.insert(this->Points.end(), corners.begin(), corners.end());
  }
  else
  {
    const auto faces = this->Polyhedron.GetFaces();
    const auto& points = this->Polyhedron.GetPoints();
    this->Locals.insert(this->Locals.end(), faces.begin(), faces.end());
    this->Points.insert(this->Points.end(), points.begin(), points.end());
    surface.LocalSize = static_cast<std::uint32_t>(faces.size());
  }
  surface.PointNumber = static_cast<std::uint32_t>(this->Points.size()) - surface.FirstPoint;
  const auto faces = this->GetFaces(surface);
  for (std::size_t at = 0; at < faces.size(); at += 1u + faces[at])
  {
    this->Key.clear();
    for (const auto local : faces.subspan(at + 1, faces[at]))
    {
      this->Key.push_back(this->Points[surface.FirstPoint + local]);
    }
    const Face face{ HashVertices(this->Key), static_cast<std::uint32_t>(this->Surfaces.size()),
      None };
    this->Faces.push_back(face);
  }
  this->Surfaces.push_back(surface);
}

SurfaceView EncoderPolygons::GetFaces(const Surface& surface) const
{
  return surface.Shape ? surface.Shape->Faces
                       : SurfaceView(this->Locals).subspan(surface.FirstLocal, surface.LocalSize);
}

bool EncoderPolygons::FindCell(std::span<const std::uint32_t> gate)
{
  const auto hash = HashVertices(gate);
  auto* next = &this->Heads[hash & (this->Heads.size() - 1)];
  while (*next != None)
  {
    auto& face = this->Faces[*next];
    if (this->Surfaces[face.Surface].Visited)
    {
      *next = face.Next; // never looked at again
      continue;
    }
    if (face.Hash == hash &&
      this->Begin(face.Surface, *next - this->Surfaces[face.Surface].FirstFace, gate))
    {
      return true;
    }
    next = &face.Next;
  }
  return false;
}

bool EncoderPolygons::FindSeed()
{
  while (this->Next < this->Surfaces.size() && this->Surfaces[this->Next].Visited)
  {
    ++this->Next;
  }
  if (this->Next == this->Surfaces.size())
  {
    return false;
  }
  this->BeginAt(static_cast<std::uint32_t>(this->Next), 0, 0, false);
  return true;
}

bool EncoderPolygons::Begin(
  std::uint32_t number, unsigned faceNumber, std::span<const std::uint32_t> gate)
{
  const auto& surface = this->Surfaces[number];
  const auto faces = this->GetFaces(surface);
  std::size_t at = 0;
  for (unsigned f = 0; f < faceNumber; ++f)
  {
    at += 1u + faces[at];
  }
  const auto face = faces.subspan(at + 1, faces[at]);
  const auto getPoint = [&](std::size_t i)
  { return this->Points[surface.FirstPoint + face[i % face.size()]]; };
  if (face.size() != gate.size())
  {
    return false;
  }
  unsigned start = 0;
  while (start < face.size() && getPoint(start) != gate[0])
  {
    ++start;
  }
  const bool mirrored = getPoint(start + 1u) == gate[1];
  for (std::size_t i = 0; i < gate.size(); ++i)
  {
    if (getPoint(mirrored ? start + i : start + face.size() - i) != gate[i])
    {
      return false;
    }
  }
  this->BeginAt(number, faceNumber, start, mirrored);
  return true;
}

void EncoderPolygons::BeginAt(std::uint32_t number, unsigned face, unsigned start, bool mirrored)
{
  auto& surface = this->Surfaces[number];
  const std::uint8_t* order = nullptr;
  std::size_t corners = 0;
  if (surface.Shape)
  {
    const auto frame = FormTable::MakeFrame(face, start, mirrored);
    const auto& found = this->Forms.GetFrames(surface.Shape)[frame];
    // All ways to see a tetrahedron are equal up to even permutations of its corners.
    this->Form = found.Form;
    this->Frame =
      static_cast<std::uint8_t>(surface.Type == TetraType ? unsigned{ mirrored } : frame);
    order = found.Order.data();
    corners = found.Order.size();
  }
  else
  {
    this->Maker.Make(this->GetFaces(surface), surface.PointNumber, face, start, mirrored);
    this->Form = this->Forms.Find(this->Maker.GetCode());
    this->Frame = mirrored;
    order = this->Maker.GetOrder().data();
    corners = this->Maker.GetOrder().size();
  }
  surface.Visited = true;
  this->Cell = surface.Cell;
  this->Corners.resize(corners);
  for (std::size_t i = 0; i < corners; ++i)
  {
    this->Corners[i] = this->Points[surface.FirstPoint + order[i]];
  }
}

bool EncoderPolygons::IsOfHexahedra() const
{
  return !this->Surfaces.empty() &&
    std::all_of(this->Surfaces.begin(), this->Surfaces.end(),
      [](const Surface& surface) { return surface.Shape && surface.Shape->Corners == 8; });
}

std::vector<std::uint32_t> EncoderPolygons::GetOthers() const
{
  return this->Others;
}
}
