// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gatunShapeTable.h"

#include <algorithm>
#include <array>

namespace gatun
{
namespace
{
std::shared_ptr<const FormTable> ReadForms(std::span<const std::uint8_t> bytes)
{
  ByteReader in(bytes);
  auto forms = std::make_shared<FormTable>();
  for (auto count = in.GetCount(2); count > 0; --count)
  {
    const CellForm form(in.GetBytes(in.GetCount(1)));
    if (!forms->AddShape(form.GetSurface(), form.Corners))
    {
      ThrowCorrupt("a table of shapes is too long or has a shape twice");
    }
  }
  if (in.GetRemaining() > 0)
  {
    ThrowCorrupt("there are bytes behind the last shape");
  }
  forms->MakeFrames();
  return forms;
}
}

//------------------------------------------------------------------------------
bool PolyhedronSurface::Set(
  std::span<const std::uint32_t> corners, std::span<const std::uint32_t> faces)
{
  this->Points.clear();
  this->Faces.clear();
  if (corners.size() > MaxSurfaceCorners)
  {
    return false;
  }
  for (std::size_t at = 0; at < faces.size(); at += 1u + faces[at])
  {
    if (faces[at] > MaxSurfaceCorners)
    {
      return false;
    }
    this->Faces.push_back(static_cast<std::uint8_t>(faces[at]));
    for (const auto point : faces.subspan(at + 1, faces[at]))
    {
      const auto found = std::find(this->Points.begin(), this->Points.end(), point);
      this->Faces.push_back(static_cast<std::uint8_t>(found - this->Points.begin()));
      if (found == this->Points.end())
      {
        if (this->Points.size() == corners.size())
        {
          return false;
        }
        this->Points.push_back(point);
      }
    }
  }
  this->Sorted.assign(corners.begin(), corners.end());
  std::sort(this->Sorted.begin(), this->Sorted.end());
  auto points = this->Points;
  std::sort(points.begin(), points.end());
  return points == this->Sorted &&
    IsClosedSurface(this->Faces, static_cast<unsigned>(this->Points.size()));
}

//------------------------------------------------------------------------------
void ShapeTable::Add(const CellList& cells)
{
  std::array<std::uint64_t, 256> counts{};
  PolyhedronSurface surface;
  for (std::size_t c = 0; c < cells.GetNumber(); ++c)
  {
    ++counts[cells.Types[c]];
    if (cells.Types[c] == PolyhedronType && surface.Set(cells.GetCorners(c), cells.GetFaces(c)))
    {
      this->Add(surface.GetFaces(), static_cast<unsigned>(surface.GetPoints().size()), 1);
    }
  }
  for (int type = 0; type < 256; ++type)
  {
    const auto kind = GetCellKind(type);
    if (kind.Shape && counts[static_cast<std::size_t>(type)] > 0)
    {
      this->Add(kind.Shape->Faces, kind.Shape->Corners, counts[static_cast<std::size_t>(type)]);
    }
  }
}

void ShapeTable::Add(SurfaceView faces, unsigned corners, std::uint64_t uses)
{
  FormMaker maker;
  maker.Make(faces, corners, 0, 0, false);
  this->Uses[maker.GetCode()] += uses;
}

void ShapeTable::Merge(const ShapeTable& other)
{
  for (const auto& [code, uses] : other.Uses)
  {
    this->Uses[code] += uses;
  }
}

void ShapeTable::PutUses(ByteWriter& out) const
{
  out.PutVarint(this->Uses.size());
  for (const auto& [code, uses] : this->Uses)
  {
    out.PutVarint(code.size());
    out.PutBytes(code);
    out.PutVarint(uses);
  }
}

void ShapeTable::AddUses(ByteReader& in)
{
  for (auto count = in.GetCount(2); count > 0; --count)
  {
    const auto code = in.GetBytes(in.GetCount(1));
    this->Uses[FormCode(code.begin(), code.end())] += in.GetVarint();
  }
}

std::vector<FormCode> ShapeTable::Select() const
{
  // Shapes with many faces have many forms. The most frequent forms are enough to find them.
  constexpr std::size_t most = FormTable::MaxForms / 2;
  std::vector<std::pair<FormCode, std::uint64_t>> candidates(this->Uses.begin(), this->Uses.end());
  const auto byUses = [](const auto& a, const auto& b)
  { return a.second != b.second ? a.second > b.second : FormOrder()(a.first, b.first); };
  std::sort(candidates.begin(), candidates.end(), byUses);
  candidates.resize(std::min(candidates.size(), most));

  std::map<FormCode, std::uint64_t, FormOrder> shapes; // by their least form
  FormMaker maker;
  for (const auto& [code, uses] : candidates)
  {
    const auto surface = CellForm(code).GetSurface();
    const auto corners = CellForm(code).Corners;
    FormCode least = code;
    unsigned gate = 0;
    for (std::size_t at = 0; at < surface.size(); at += 1u + surface[at], ++gate)
    {
      for (unsigned start = 0; start < surface[at]; ++start)
      {
        maker.Make(surface, corners, gate, start, false);
        least = std::min(least, maker.GetCode(), FormOrder());
      }
    }
    shapes[least] += uses;
  }
  candidates.assign(shapes.begin(), shapes.end());
  std::sort(candidates.begin(), candidates.end(), byUses);
  std::vector<FormCode> selected;
  FormTable forms;
  for (const auto& [code, uses] : candidates)
  {
    const CellForm form(code);
    if (IsWorthwhile(code, uses) && forms.AddShape(form.GetSurface(), form.Corners))
    {
      selected.push_back(code);
    }
  }
  return selected;
}

Bytes ShapeTable::Write() const
{
  const auto shapes = this->Select();
  ByteWriter out;
  out.PutVarint(shapes.size());
  for (const auto& code : shapes)
  {
    out.PutVarint(code.size());
    out.PutBytes(code);
  }
  return std::move(out.Data);
}

ShapeTable ShapeTable::Read(std::span<const std::uint8_t> bytes)
{
  // Many files have no shapes of their own. The forms of all files are made once, as that takes
  // time.
  static constexpr std::array<std::uint8_t, 1> none{ 0 };
  static const auto formsOfNone = ReadForms(none);
  ShapeTable table;
  table.Forms = std::equal(bytes.begin(), bytes.end(), none.begin(), none.end()) ? formsOfNone
                                                                                 : ReadForms(bytes);
  return table;
}

std::shared_ptr<const FormTable> ShapeTable::GetForms() const
{
  return this->Forms ? this->Forms : Read(this->Write()).Forms;
}
}
