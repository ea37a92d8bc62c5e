// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunCellGeometry_h
#define gatunCellGeometry_h

// Encoding of the coordinates of own vertices of cells that are not all tetrahedra.

#include "gatunBytes.h"
#include "gatunCellRules.h"
#include "gatunChunkCodec.h"
#include "gatunGeometry.h"
#include "gatunNumberModel.h"
#include "gatunPlaneCoder.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
/** How the rule for a vertex is found. */
enum class CellRuleMode : std::uint8_t
{
  First = 0, ///< the first one of GetCellRules that can be applied
  Named = 1, ///< one of them is named for each vertex
  Fitted = 2 ///< one that is fitted to the chunk's vertices with the same known ones, or the first
};

/** How the coordinates of the vertices of surfaces are coded. */
enum class PlaneMode : std::uint8_t
{
  None = 0,   ///< like others
  Planes = 1, ///< by PlaneCoder
  Repeats = 3 ///< by PlaneCoder with repeats
};

/** The rules of a chunk: those of GetCellRules, then fitted ones. */
struct CellRuleTable
{
  static constexpr std::size_t MaxFitted = 64;

  CellRuleMode Mode = CellRuleMode::First;
  PlaneMode Planes = PlaneMode::None;
  std::vector<CellRule> Rules;
  std::vector<std::uint16_t> FittedMasks; // the vertices of records that each fitted rule is for

  CellRuleTable();

  void Write(ByteWriter& out) const;
  static CellRuleTable Read(ByteReader& in);
};

/** Predicts from the records of cells: a scheme of GeometryCoder. */
template <typename Coder>
class CellScheme
{
public:
  using Record = CellRecord;
  static constexpr unsigned Groups = 33; // the last is of seeds
  static constexpr bool HasLocalRule = false;

  explicit CellScheme(const CellRuleTable& table)
    : Table(table)
    , Named(table.Mode == CellRuleMode::Named ? Masks : 0)
    , Best(GetFirstRules())
  {
    if (table.Planes != PlaneMode::None)
    {
      this->Local.emplace(table.Planes == PlaneMode::Repeats);
    }
    for (const auto& rule : GetCellRules())
    {
      this->RuleMasks.push_back(GetMask(rule));
    }
    for (std::size_t i = 0; i < table.FittedMasks.size(); ++i)
    {
      this->Best[table.FittedMasks[i]] = static_cast<std::uint8_t>(this->RuleMasks.size() + i);
    }
  }

  const CellRule& GetRule(unsigned rule) const { return this->Table.Rules[rule]; }

  /** Of those that can be named. */
  std::size_t GetNumberOfRules() const { return this->RuleMasks.size(); }

  bool CanApply(unsigned rule, const CellRecord& record) const
  {
    return (this->RuleMasks[rule] & ~record.GetMask()) == 0;
  }

  static unsigned GetGroup(const CellRecord&, unsigned rule) { return std::min(rule, Groups - 2); }

  template <typename FindBest>
  unsigned CodeRule(Coder& coder, const CellRecord& record, FindBest&& findBest)
  {
    const unsigned mask = record.GetMask();
    if (this->Table.Mode != CellRuleMode::Named)
    {
      return this->Best[mask];
    }
    const auto rule = this->Named[mask].Code(coder, Coder::Encoding ? findBest() : 0);
    if (rule >= this->RuleMasks.size() || (this->RuleMasks[rule] & ~mask) != 0)
    {
      ThrowCorrupt("a vertex names a prediction rule that is not there");
    }
    return rule;
  }

  std::array<unsigned, 3> GetSpreads(const CellRecord& record, std::span<const PointKeys> keys)
  {
    KeyRange range;
    if (ForEachInRange(record, [&](Vertex v) { range.Add(keys[v]); }) >= 2)
    {
      this->Spreads = range.GetBits();
    }
    return this->Spreads;
  }

  /** Whether Local codes a vertex. */
  bool IsLocal(const CellRecord& record, unsigned) const
  {
    return this->Local && PlaneCoder<Coder>::CanCode(record);
  }

  std::optional<PlaneCoder<Coder>> Local; // if surfaces are on planes

private:
  static constexpr unsigned Masks = 1u << CellRecord::Size;

  const CellRuleTable& Table;
  std::vector<unsigned> RuleMasks;               // of GetCellRules
  std::vector<BitTree<4>> Named;                 // for each mask of a record
  std::array<std::uint8_t, Masks> Best;          // the rule for each mask, unless rules are named
  std::array<unsigned, 3> Spreads{ 20, 20, 20 }; // the last ones
};

template <typename Coder>
using CellGeometryCoder = GeometryCoder<Coder, CellScheme<Coder>>;

/** Encodes the own vertices of a mesh that has everything else, with the best rules. Sets
 * UsedRules and CellRules. */
Bytes EncodeCellGeometry(ChunkMesh& mesh);
}

#endif
