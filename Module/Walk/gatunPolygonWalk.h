// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPolygonWalk_h
#define gatunPolygonWalk_h

// The breadth-first walk over cells that are closed surfaces of polygons. Encoder and decoder use
// the same code.

#include "gatunAttachedNodes.h"
#include "gatunCellBuilder.h"
#include "gatunCellForms.h"
#include "gatunCellShapes.h"
#include "gatunEncoderPolygons.h"
#include "gatunHexForm.h"
#include "gatunPolygonCell.h"
#include "gatunPolygonFront.h"
#include "gatunPolygonGate.h"
#include "gatunPolygonGrowth.h"
#include "gatunPolygonModels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace gatun
{
/**
 * Attaches a cell to the oldest open face, the gate, until there is none. A cell is coded by its
 * form seen from the gate, by the other open faces that are its faces, and by its other corners.
 * The cell's type and the order of its corners are coded relative to the cell behind the gate.
 *
 * Form: HexForm if all cells are hexahedra, otherwise CellForm.
 */
template <typename Coder, typename Side, typename Form>
class PolygonWalk
{
public:
  static constexpr bool OfHexahedra = std::is_same_v<Form, HexForm>;

  /** actual: of an encoder, otherwise null. */
  PolygonWalk(Coder& coder, CellBuilder<Side>& mesh, AttachedNodes<Coder, Side>& nodes,
    const FormTable& forms, EncoderPolygons* actual)
    : Symbols(coder)
    , Mesh(mesh)
    , Nodes(nodes)
    , Forms(forms)
    , Actual(actual)
    , Open(mesh.GetAllVertices())
    , Models(forms.GetSize())
    , Cell(Open, mesh)
    , Gate(Open, mesh, Cell)
    , Growth(Open, mesh)
  {
    if constexpr (OfHexahedra)
    {
      this->HexNumber = forms.FindHexahedron();
      if (this->HexNumber == FormTable::None)
      {
        ThrowCorrupt("a walk over hexahedra is in a file without them");
      }
      this->Hexahedron.Shape = forms.Get(this->HexNumber).Shape;
    }
  }

  /** Returns the faces at the border in the order in which they were closed. */
  ClosedFaces Run()
  {
    while (!this->Mesh.IsFull())
    {
      const auto gate = this->Open.NextGate();
      if (gate != PolygonFront::None)
      {
        this->GrowOnGate(gate);
      }
      else if (this->Symbols.Bit(this->Models.MoreSeeds, Coder::Encoding && this->FindSeed()))
      {
        this->GrowSeed();
      }
      else
      {
        break;
      }
    }
    return std::move(this->Borders);
  }

private:
  //----------------------------------------------------------------------------
  // The encoder's input

  bool FindSeed() { return this->Actual && this->Actual->FindSeed(); }

  bool FindCell(const PolygonFront::Face& gate)
  {
    this->GateInput.clear();
    if constexpr (Coder::Encoding)
    {
      for (unsigned i = 0; i < gate.Degree; ++i)
      {
        this->GateInput.push_back(
          this->Mesh.Actual.InputOf[this->Open.GetSide(gate.First + i).Corner]);
      }
      return this->Actual->FindCell(this->GateInput);
    }
    return false;
  }

  /** The input's vertex at a corner of the form. */
  std::uint32_t GetTarget(unsigned corner) const
  {
    return Coder::Encoding ? this->Actual->Corners[corner] : 0;
  }

  Vertex GetKnown(unsigned corner) const
  {
    return Coder::Encoding ? this->Mesh.Actual.GetMet(this->GetTarget(corner)) : NoVertex;
  }

  //----------------------------------------------------------------------------
  // Steps

  void GrowSeed()
  {
    const GateGrades none;
    const auto parent = static_cast<std::uint32_t>(this->Forms.GetSize());
    this->BeginForm(parent, 0, none);
    for (unsigned i = 0; i < this->Cell.GetForm().Corners; ++i)
    {
      this->Cell.SetCorner(i, this->CodeSeedCorner(i));
    }
    this->IsUsual = false;
    this->FinishCell(Topology::NoTet, 0, 0);
  }

  Vertex CodeSeedCorner(unsigned corner)
  {
    const auto known = this->GetKnown(corner);
    if (!this->Symbols.Bit(this->Models.SeedNew, known == NoVertex))
    {
      return CodeIndex(this->Symbols, known, this->Mesh.GetVertices());
    }
    const auto target = this->GetTarget(corner);
    if (this->Symbols.Bit(this->Models.SeedShared, this->IsShared(target)))
    {
      return this->Mesh.MeetShared(
        target, CodeIndex(this->Symbols, target, this->Mesh.GetSharedSearch().GetSize()));
    }
    return this->Mesh.MeetOwn(target, this->Cell.MakeRecord(corner));
  }

  void GrowOnGate(std::uint32_t id)
  {
    const auto gate = this->Open.GetFace(id);
    const bool border = Coder::Encoding && !this->FindCell(gate);
    this->Gate.Grade(gate);
    const auto& grades = this->Gate.Grades;
    const bool isInterface = this->Gate.GetUsers(gate) != 0;
    auto& model = isInterface ? this->Models.Interface(grades) : this->Models.Border(grades);
    if (this->Symbols.Bit(model, border))
    {
      this->Open.CloseAtBorder(id);
      this->Borders.Add(this->Open, gate);
      return;
    }
    auto& usual = this->Models.Usual(
      gate.Form, gate.FormFace, OfHexahedra ? 0 : grades.Pattern, gate.Type, gate.Frame);
    this->IsUsual = this->MayBe(usual.Way, gate) &&
      this->Symbols.Bit(usual.Model, Coder::Encoding && this->GetWay() == usual.Way);
    if (!this->IsUsual)
    {
      this->BeginForm(gate.Form, gate.FormFace, grades);
    }
    else
    {
      this->Way = usual.Way;
      this->BeginListed(usual.Way.Form);
    }
    this->Cell.GlueGate(id);
    this->GlueFaces();
    this->CodeCorners(gate);
    this->FinishCell(gate.Cell, gate.Type, gate.Frame);
    if (!this->IsUsual && this->Way.Form < this->Forms.GetSize())
    {
      usual.Add(this->Way);
    }
  }

  /** Whether a cell on a gate may be like one before. */
  bool MayBe(const CellWay& way, const PolygonFront::Face& gate) const
  {
    return way.Form != LastTwo::None &&
      (OfHexahedra || this->Forms.Get(way.Form).GetDegree(0) == gate.Degree);
  }

  CellWay GetWay() const
  {
    if constexpr (Coder::Encoding)
    {
      return { this->Actual->Form, this->Mesh.Actual.Input.Types[this->Actual->Cell],
        this->Actual->Frame };
    }
    return {};
  }

  void BeginListed(std::uint16_t number)
  {
    if constexpr (OfHexahedra)
    {
      this->Cell.Begin(this->Hexahedron, number);
    }
    else
    {
      this->Cell.Begin(this->Forms.Get(number), number);
    }
  }

  /** Codes the form of a cell. Forms that are not listed all have the number behind the last one.
   */
  void BeginForm(std::uint32_t parent, std::uint32_t face, const GateGrades& grades)
  {
    if constexpr (OfHexahedra)
    {
      this->BeginListed(this->HexNumber);
    }
    else
    {
      const auto unlisted = static_cast<std::uint16_t>(this->Forms.GetSize());
      const auto actual = Coder::Encoding ? this->Actual->Form : std::uint16_t{ 0 };
      if (unlisted > 0 &&
        this->Symbols.Bit(this->Models.IsListed[(parent == unlisted) + 2 * (grades.Degree == 0)],
          actual != FormTable::None))
      {
        this->BeginListed(
          this->Models.CodeForm(this->Symbols, this->Forms, parent, face, grades, actual));
      }
      else
      {
        this->BeginInlined(grades);
      }
    }
  }

  void BeginInlined(const GateGrades& grades)
  {
    static const FormCode none;
    const auto& code = Coder::Encoding ? this->Actual->GetCode() : none;
    if (grades.Degree == 0)
    {
      const auto degree = CodeIndex(this->Symbols, Coder::Encoding ? code[0] : 0, 256);
      this->Gate.Degrees.assign(degree, 0);
    }
    this->Models.Inline.Code(this->Symbols, this->Builder, this->Gate.Degrees, code);
    this->Inlined = CellForm(this->Builder);
    this->Inlined->Shape = ~0u;
    this->Cell.Begin(*this->Inlined, static_cast<std::uint16_t>(this->Forms.GetSize()));
  }

  //----------------------------------------------------------------------------
  // Other open faces that are faces of the cell

  void GlueFaces()
  {
    const auto& form = this->Cell.GetForm();
    // Faces that are glued are appended to the list.
    for (unsigned number = 0; number < this->Cell.Glued.size(); ++number)
    {
      const auto face = this->Cell.Glued[number];
      const auto first = form.GetFirstSide(face);
      for (unsigned side = first; side < first + form.GetDegree(face); ++side)
      {
        const unsigned twin = form.Twin[side];
        if (this->Cell.IsGlued(form.Face[twin]))
        {
          continue;
        }
        const auto from = this->Cell.FrontSides[side];
        const auto over = this->Open.GetOpen(from);
        unsigned agree = 0;
        if (over == PolygonFront::None || !this->Cell.CanGlue(twin, over, agree))
        {
          continue;
        }
        auto& model = this->Models.Glue(form.Family, form.GetDegree(form.Face[twin]),
          number == 0 ? this->Gate.Angles[side] : this->Cell.GradeAngle(from, over),
          this->Open.GetSide(over).Over.GetCells(), agree,
          (number > 0) + 2 * (this->Cell.Glued.size() > 1));
        if (this->Symbols.Bit(model, Coder::Encoding && this->IsGlued(twin, over)))
        {
          this->Cell.Glue(twin, over);
        }
      }
    }
  }

  /** Encoder: whether an open face is a face of the cell that was begun. */
  bool IsGlued(unsigned formSide, std::uint32_t over) const
  {
    bool same = true;
    this->Cell.ForEachCorner(formSide, over,
      [&](unsigned corner, Vertex vertex) { same = same && this->GetKnown(corner) == vertex; });
    return same;
  }

  //----------------------------------------------------------------------------
  // Other corners

  void CodeCorners(const PolygonFront::Face& gate)
  {
    for (unsigned corner = gate.Degree; corner < this->Cell.GetForm().Corners; ++corner)
    {
      if (this->Cell.GetCorner(corner) == NoVertex)
      {
        this->Cell.SetCorner(corner, this->CodeCorner(corner));
      }
    }
  }

  Vertex CodeCorner(unsigned corner)
  {
    const auto record = this->Cell.MakeRecord(corner);
    const auto known = this->GetKnown(corner);
    const auto glued = static_cast<unsigned>(this->Cell.Glued.size()) - 1;
    // Behind two more faces a corner is nearly always new, so that nothing is searched for.
    const bool isLikelyNew = glued >= 2;
    if (!isLikelyNew)
    {
      this->Cell.FindCandidates(corner, record);
    }
    const auto nearest = isLikelyNew ? 7 : this->Cell.GradeNearest();
    auto& isNew = this->Models.New(this->Cell.FormNumber, corner, glued, nearest);
    if (!this->Symbols.Bit(isNew, known == NoVertex))
    {
      if (isLikelyNew)
      {
        this->Cell.FindCandidates(corner, record);
      }
      return this->CodeKnown(known, nearest);
    }
    const auto target = this->GetTarget(corner);
    unsigned near = 0;
    for (unsigned k = 0; k < 3; ++k)
    {
      const auto v = record.Known[k];
      near += v != NoVertex && this->Mesh.GetPlace(v).Users != 0;
    }
    unsigned gate = 0;
    for (unsigned i = 0; i < this->Cell.GetForm().GetDegree(0); ++i)
    {
      gate += this->Mesh.GetPlace(this->Cell.GetCorner(i)).Users != 0;
    }
    if (this->Symbols.Bit(
          this->Models.IsShared[near * 5 + std::min(gate, 4u)], this->IsShared(target)))
    {
      this->Cell.Predict(record);
      return this->Mesh.MeetShared(target,
        this->Models.Shared.Code(this->Symbols, this->Mesh.GetSharedSearch(), this->Cell.Predicted,
          4.0F * this->Cell.EdgeSquared, target));
    }
    return this->Mesh.MeetOwn(target, record);
  }

  bool IsShared(std::uint32_t target) const
  {
    return Coder::Encoding && this->Mesh.Actual.IsShared(target);
  }

  Vertex CodeKnown(Vertex known, unsigned nearest)
  {
    const auto& candidates = this->Cell.SortCandidates();
    const auto count = static_cast<unsigned>(std::min<std::size_t>(candidates.size(), 15));
    unsigned place = 0;
    while (Coder::Encoding && place < count && candidates[place].Id != known)
    {
      ++place;
    }
    Vertex vertex = NoVertex;
    if (this->Symbols.Bit(this->Models.Listed, place < count))
    {
      for (unsigned i = 0; i < count && vertex == NoVertex; ++i)
      {
        if (this->Symbols.Bit(this->Models.Ranks[std::min(i, 5u) * 8 + nearest], i == place))
        {
          vertex = candidates[i].Id;
        }
      }
      if (vertex == NoVertex)
      {
        ThrowCorrupt("a walk names no vertex of a list");
      }
    }
    else
    {
      vertex = CodeIndex(this->Symbols, known, this->Mesh.GetVertices());
    }
    return vertex;
  }

  //----------------------------------------------------------------------------
  // Types and the order of corners

  void FinishCell(std::uint32_t parent, std::uint8_t parentType, std::uint32_t parentFrame)
  {
    const auto number = this->Mesh.GetCells();
    const auto& form = this->Cell.GetForm();
    std::uint8_t type = 0;
    std::uint8_t frame = 0;
    if constexpr (Coder::Encoding)
    {
      type = this->Mesh.Actual.Input.Types[this->Actual->Cell];
      frame = this->Actual->Frame;
      this->Mesh.Actual.CellOrder.push_back(this->Actual->Cell);
    }
    if (this->IsUsual)
    {
      type = this->Way.Type;
      frame = this->Way.Frame;
    }
    else
    {
      type = this->Models.CodeType(this->Symbols, form.Shape, parentType, type);
      frame = this->Models.CodeFrame(this->Symbols,
        type + (std::uint32_t{ this->Cell.FormNumber } << 8), parentType, parentFrame, frame);
      this->Way = { this->Cell.FormNumber, type, frame };
    }
    const FormTable::Frame* typeFrame = nullptr;
    this->Corners.resize(form.Corners);
    this->Faces.clear();
    if (type == PolyhedronType && frame < 2)
    {
      for (unsigned i = 0; i < form.Corners; ++i)
      {
        this->Corners[i] = this->Cell.GetCorner(i);
      }
      this->Cell.AppendFaces(this->Faces, frame != 0);
    }
    else
    {
      typeFrame = &this->GetTypeFrame(type, frame);
      for (unsigned i = 0; i < form.Corners; ++i)
      {
        this->Corners[typeFrame->Order[i]] = this->Cell.GetCorner(i);
      }
      this->Nodes.CodeOfType(type, this->Corners, this->GetInputCorners());
    }
    this->Mesh.AddCell(type, this->Corners, this->Faces, parent);
    this->Growth.Attach(this->Cell, number, type,
      [&](unsigned face)
      {
        if (!typeFrame || type == TetraType)
        {
          return std::uint32_t{ frame };
        }
        const auto& place = typeFrame->Faces[face];
        return std::uint32_t{ FormTable::MakeFrame(place.Face, place.Start, frame & 1) };
      });
  }

  std::span<const std::uint32_t> GetInputCorners() const
  {
    if constexpr (Coder::Encoding)
    {
      return this->Mesh.Actual.Input.GetCorners(this->Actual->Cell);
    }
    return {};
  }

  const FormTable::Frame& GetTypeFrame(std::uint8_t type, std::uint8_t number)
  {
    auto& frames = this->FramesOf[type];
    if (frames.empty())
    {
      const auto kind = GetCellKind(type);
      if (kind.Shape && (kind.IsLinear() || HasNodes(type)))
      {
        frames = this->Forms.GetFrames(kind.Shape);
      }
    }
    if (number >= frames.size() || frames[number].Form != this->Cell.FormNumber)
    {
      ThrowCorrupt("a cell has a type that its form does not allow");
    }
    return frames[number];
  }

  Coder& Symbols;
  CellBuilder<Side>& Mesh;
  AttachedNodes<Coder, Side>& Nodes;
  const FormTable& Forms;
  EncoderPolygons* const Actual;
  PolygonFront Open;
  PolygonModels Models;
  PolygonCell<CellBuilder<Side>, Form> Cell;
  PolygonGate<CellBuilder<Side>, Form> Gate;
  PolygonGrowth<CellBuilder<Side>, Form> Growth;
  FormBuilder Builder;
  std::optional<CellForm> Inlined; // the cell's, if it is in no table
  bool IsUsual = false;            // whether the cell is as expected at its gate
  CellWay Way;                     // of the cell
  HexForm Hexahedron;
  std::uint16_t HexNumber = FormTable::None;

  std::array<std::span<const FormTable::Frame>, 256> FramesOf; // types
  std::vector<std::uint32_t> GateInput;
  ClosedFaces Borders;
  std::vector<Vertex> Corners, Faces; // of the cell that is finished
};
}

#endif
