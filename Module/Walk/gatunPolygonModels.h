// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPolygonModels_h
#define gatunPolygonModels_h

// The adaptive probabilities of a walk over cells of any shape, and their contexts.

#include "gatunCellForms.h"
#include "gatunEntropy.h"
#include "gatunInlineForm.h"
#include "gatunNumberModel.h"
#include "gatunSharedNames.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace gatun
{
/** Mixes the parts of a context to a place in a table of 2^Bits. */
template <unsigned Bits>
std::uint32_t MixContext(std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
  return (a * 0x9e3779b1u + b * 0x85ebca6bu + c * 0xc2b2ae35u) >> (32 - Bits);
}

/** The two symbols that came last in a context. */
class LastTwo
{
public:
  static constexpr std::uint16_t None = 0xffff;

  /** Codes whether a symbol is one of the two. Symbols with skip(symbol) do not count. Returns None
   * if it is neither. */
  template <typename Coder, typename Skip>
  std::uint16_t Code(Coder& coder, std::uint16_t symbol, Skip&& skip)
  {
    for (unsigned i = 0; i < 2; ++i)
    {
      const auto candidate = this->Symbols[i];
      if (candidate != None && !skip(candidate) && coder.Bit(this->Hit[i], symbol == candidate))
      {
        return candidate;
      }
    }
    return None;
  }

  void Add(std::uint16_t symbol)
  {
    if (symbol == this->Symbols[1] && this->Symbols[0] != None)
    {
      std::swap(this->Symbols[0], this->Symbols[1]);
    }
    else if (this->Symbols[0] == None)
    {
      this->Symbols[0] = symbol;
    }
    else if (symbol != this->Symbols[0])
    {
      this->Symbols[1] = symbol;
    }
  }

private:
  std::array<std::uint16_t, 2> Symbols{ None, None };
  std::array<BitModel, 2> Hit;
};

/** Codes a type or a frame of up to eight bits by the last ones in a context. */
template <typename Coder>
std::uint8_t CodeLast(Coder& coder, LastTwo& last, BitTree<8>& tree, std::uint8_t symbol)
{
  auto coded = last.Code(coder, symbol, [](std::uint16_t) { return false; });
  if (coded == LastTwo::None)
  {
    coded = static_cast<std::uint16_t>(tree.Code(coder, symbol));
  }
  last.Add(coded);
  return static_cast<std::uint8_t>(coded);
}

/** The form, the type and the frame of a cell. */
struct CellWay
{
  std::uint16_t Form = LastTwo::None;
  std::uint8_t Type = 0;
  std::uint8_t Frame = 0;
  bool operator==(const CellWay&) const = default;
};

/** Context of a gate before its cell is known. */
struct GateGrades
{
  unsigned Degree = 0;   // 0 for a seed, which may have any
  unsigned Borders = 0;  // sides at the border
  unsigned Coplanar = 0; // of those, with a far corner in the gate's plane
  unsigned LeastAngle = 16;
  unsigned MostCells = 0;    // around a side
  std::uint32_t Pattern = 0; // the degrees of the faces that will probably be glued
};

class PolygonModels
{
public:
  explicit PolygonModels(std::size_t forms)
    : FormBits(static_cast<unsigned>(std::bit_width(forms > 0 ? forms - 1 : 0)))
    , Interfaces(5 * 17 * 5)
    , Borders(4 * 5 * 4 * 17 * 5)
    , Glues(5 * 4 * 17 * 4 * 4 * 4)
    , News(std::size_t{ 64 } * 16 * 8 * 8)
    , FormsNear(1u << 12)
    , FormsFar(1u << 10)
    , FormTrees(std::size_t{ 4 } << this->FormBits)
    , Types(1u << 10)
    , Frames(1u << 12)
    , Usuals(1u << 12)
  {
  }

  BitModel& Interface(const GateGrades& gate)
  {
    return this->Interfaces[(std::min(gate.Borders, 4u) * 17 + gate.LeastAngle) * 5 +
      std::min(gate.MostCells, 4u)];
  }

  BitModel& Border(const GateGrades& gate)
  {
    return this->Borders[(((GradeDegree(gate.Degree) * 5 + std::min(gate.Borders, 4u)) * 4 +
                            std::min(gate.Coplanar, 3u)) *
                             17 +
                           gate.LeastAngle) *
        5 +
      std::min(gate.MostCells, 4u)];
  }

  /** family: of the form. agree: known corners in common besides the edge. order: 0 over the gate,
   * 1 over another face; 2 more if a face was glued. */
  BitModel& Glue(unsigned family, unsigned degree, unsigned angle, unsigned cells, unsigned agree,
    unsigned order)
  {
    return this
      ->Glues[((((family * 4 + GradeDegree(degree)) * 17 + angle) * 4 + std::min(cells, 4u) - 1) *
                  4 +
                std::min(agree, 3u)) *
          4 +
        order];
  }

  BitModel& New(unsigned form, unsigned corner, unsigned glued, unsigned nearest)
  {
    return this
      ->News[((std::min(form, 63u) * 16 + std::min(corner, 15u)) * 8 + std::min(glued, 7u)) * 8 +
        nearest];
  }

  /** The way of the last cell on such a gate, and whether the next one has it. */
  struct UsualWay
  {
    CellWay Way, Second;
    BitModel Model;

    void Add(const CellWay& way)
    {
      if (way == this->Second || this->Way.Form == LastTwo::None)
      {
        this->Second = this->Way;
        this->Way = way;
      }
      else
      {
        this->Second = way;
      }
    }
  };

  UsualWay& Usual(std::uint32_t parent, std::uint32_t face, std::uint32_t pattern,
    std::uint8_t parentType, std::uint32_t parentFrame)
  {
    return this
      ->Usuals[MixContext<12>(parent + (face << 16), pattern, parentType + (parentFrame << 8))];
  }

  /** parent: the form behind the gate. face: of that form. */
  template <typename Coder>
  std::uint16_t CodeForm(Coder& coder, const FormTable& forms, std::uint32_t parent,
    std::uint32_t face, const GateGrades& gate, std::uint16_t form)
  {
    auto& near = this->FormsNear[MixContext<12>(parent, face, gate.Pattern)];
    auto& far = this->FormsFar[MixContext<10>(gate.Degree, gate.Pattern, 0)];
    const auto isWrong = [&](std::uint16_t candidate)
    { return gate.Degree != 0 && forms.Get(candidate).GetDegree(0) != gate.Degree; };
    auto coded = near.Code(coder, form, isWrong);
    if (coded == LastTwo::None)
    {
      coded = far.Code(coder, form, isWrong);
    }
    if (coded == LastTwo::None)
    {
      const auto first = GradeDegree(gate.Degree) << this->FormBits;
      unsigned node = 1;
      for (unsigned bit = this->FormBits; bit-- > 0;)
      {
        node = 2 * node + coder.Bit(this->FormTrees[first + node], (form >> bit) & 1);
      }
      coded = static_cast<std::uint16_t>(node - (1u << this->FormBits));
      if (coded >= forms.GetSize() || isWrong(coded))
      {
        ThrowCorrupt("a cell has a form that is not there");
      }
    }
    near.Add(coded);
    far.Add(coded);
    return coded;
  }

  template <typename Coder>
  std::uint8_t CodeType(
    Coder& coder, std::uint32_t shape, std::uint8_t parentType, std::uint8_t type)
  {
    return CodeLast(coder, this->Types[MixContext<10>(shape, parentType, 1)], this->TypeTree, type);
  }

  /** parentFrame: of the gate. */
  template <typename Coder>
  std::uint8_t CodeFrame(Coder& coder, std::uint32_t typeAndForm, std::uint8_t parentType,
    std::uint32_t parentFrame, std::uint8_t frame)
  {
    return CodeLast(coder, this->Frames[MixContext<12>(typeAndForm, parentType, parentFrame)],
      this->FrameTree, frame);
  }

  std::array<BitModel, 4> IsListed; // of forms, by whether that behind the gate is
  InlineForm Inline;
  std::array<BitModel, 20> IsShared;
  SharedNames Shared;
  BitModel Listed;
  std::array<BitModel, std::size_t{ 6 } * 8> Ranks;
  BitModel MoreSeeds, SeedNew, SeedShared;

private:
  static unsigned GradeDegree(unsigned degree) { return std::clamp(degree, 3u, 6u) - 3; }

  const unsigned FormBits;
  std::vector<BitModel> Interfaces, Borders, Glues, News;
  std::vector<LastTwo> FormsNear, FormsFar;
  std::vector<BitModel> FormTrees; // by degree
  std::vector<LastTwo> Types, Frames;
  std::vector<UsualWay> Usuals;
  BitTree<8> TypeTree, FrameTree;
};
}

#endif
