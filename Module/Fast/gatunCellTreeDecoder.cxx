// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// As in the decoder of TetTree, what the loops must not meet is counted before, or noted by them
// and looked at once in the end.

#include "gatunCellShapes.h"
#include "gatunCellTemplates.h"
#include "gatunCellTree.h"
#include "gatunNumberStream.h"
#include "gatunTreeSymbols.h"
#include "gatunVertexNames.h"

#include <algorithm>

namespace gatun
{
namespace
{
using Row = std::array<std::uint16_t, CellTemplate::MaxHead>;

/** The numbers of all cells of a kind of template. */
struct Totals
{
  std::uint64_t News = 0;
  std::uint64_t Fars = 0;
  std::uint64_t Heads = 0;
  std::uint64_t Rests = 0;
  std::uint64_t Hidden = 0;
  std::uint64_t Differences = 0;
  std::uint64_t Sizes = 0;
  std::uint64_t FaceValues = 0;
  bool HasFaces = false;
};

class CellTreeDecoder
{
public:
  CellTreeDecoder(ByteReader& in, const CellTreeSize& size, CellTree& tree)
    : In(in)
    , Size(size)
    , Tree(tree)
  {
  }

  void Decode()
  {
    this->ReadTemplates();
    this->CountAll();
    this->ReadNumbers();
    this->Walk();
    this->Tree.Sources = GetVertexNames(this->In, this->Size.Vertices, this->Size.Shared);
  }

private:
  static constexpr unsigned NumberBits = 17; // of vertices
  static constexpr unsigned CellBits = 21;
  static constexpr unsigned CornerBits = 25;
  static constexpr std::uint8_t Escape = 255;

  void ReadTemplates()
  {
    const auto most =
      4096 + 64 * std::uint64_t{ this->Size.Cells } + 4 * std::uint64_t{ this->Size.FaceValues };
    this->Templates = CellTemplates::Read(this->In, most, this->Size.Cells);
    Bytes symbols(this->Size.Cells);
    GetPacked(this->In, symbols);
    this->Ids.assign(symbols.begin(), symbols.end());
    const auto escapes =
      static_cast<std::size_t>(std::count(symbols.begin(), symbols.end(), Escape));
    if (escapes > 0)
    {
      NumberReader more(this->In, escapes, CellBits);
      for (auto& id : this->Ids)
      {
        id += id == Escape ? static_cast<std::uint32_t>(more.Get()) : 0;
      }
    }
  }

  void CountAll()
  {
    const auto& items = this->Templates.Items;
    std::vector<std::uint32_t> uses(items.size(), 0);
    for (const auto id : this->Ids)
    {
      if (id >= uses.size())
      {
        ThrowCorrupt("a chunk names a template that it does not have");
      }
      ++uses[id];
    }
    auto& all = this->All;
    for (std::size_t id = 0; id < items.size(); ++id)
    {
      const auto& item = items[id];
      const std::uint64_t count = uses[id];
      all.News += count * item.News;
      all.Fars += count * item.Fars;
      all.Heads += count * item.Head;
      all.Rests += count * item.Rest;
      all.Hidden += count * item.Hidden;
      all.Sizes += item.IsSized ? count : 0;
      all.Differences += item.KnowsSources ? 0 : count * item.Sources;
      if (item.Pattern != CellTemplate::NoPattern)
      {
        all.HasFaces = all.HasFaces || count > 0;
        all.FaceValues += count * this->Templates.Patterns[item.Pattern].Values.size();
      }
    }
    // So that no number below is larger than what the chunk has.
    const std::uint64_t limit = std::uint64_t{ this->Size.Corners } + this->Size.FaceValues;
    if (all.Heads + all.Rests > limit || all.FaceValues != this->Size.FaceValues)
    {
      ThrowCorrupt("the cells of a chunk have another size than its directory entry says");
    }
  }

  void ReadNumbers()
  {
    auto& all = this->All;
    this->Differences.resize(static_cast<std::size_t>(all.Differences));
    GetPacked(this->In, this->Differences);
    const auto escapes = static_cast<std::size_t>(
      std::count(this->Differences.begin(), this->Differences.end(), Escape));
    this->Distances = this->ReadList<std::uint32_t>(escapes, CellBits);
    this->Fars = this->ReadList<std::uint16_t>(static_cast<std::size_t>(all.Fars), 16);
    this->Sizes = this->ReadList<std::uint32_t>(static_cast<std::size_t>(all.Sizes), CornerBits);
    for (const auto size : this->Sizes)
    {
      all.Rests += size;
    }
    if (all.Heads + all.Rests - all.Hidden != this->Size.Corners)
    {
      ThrowCorrupt("the cells of a chunk have another size than its directory entry says");
    }
    this->Symbols.resize(static_cast<std::size_t>(all.Rests));
    GetPacked(this->In, this->Symbols);
    std::size_t fars = 0;
    std::uint8_t largest = 0;
    for (const auto symbol : this->Symbols)
    {
      fars += symbol == CellTemplate::FarSymbol ? 1 : 0;
      all.News += symbol == CellTemplate::NewSymbol ? 1 : 0;
      largest = std::max(largest, symbol);
    }
    if (all.News != this->Size.Vertices || largest >= CellTemplate::Symbols)
    {
      ThrowCorrupt("a chunk has another number of vertices than its cells");
    }
    this->RestFars = this->ReadList<std::uint16_t>(fars, 16);
  }

  /** Reads numbers, with one of 0 behind them that may be looked at. */
  template <typename Number>
  std::vector<Number> ReadList(std::size_t count, unsigned bits)
  {
    std::vector<Number> list(count + 1, 0);
    if (count > 0)
    {
      NumberReader numbers(this->In, count, bits);
      std::generate_n(
        list.begin(), count, [&numbers] { return static_cast<Number>(numbers.Get()); });
    }
    list.resize(count + CellTemplate::MaxHead, 0);
    return list;
  }

  void Walk()
  {
    auto& cells = this->Tree.Cells;
    const auto count = this->Size.Cells;
    cells.Types.resize(count);
    cells.Starts.resize(std::size_t{ count } + 1);
    cells.Corners.resize(std::size_t{ this->Size.Corners } + CellTemplate::MaxHead);
    this->Tree.Parents.resize(count);
    this->Tree.Gates.resize(std::size_t{ this->Size.Vertices } + 1);
    this->Rows.resize(std::size_t{ count } + 1);
    if (this->All.HasFaces)
    {
      cells.FaceStarts.resize(std::size_t{ count } + 1);
      cells.Faces.reserve(this->Size.FaceValues);
    }
    this->Difference = this->Differences.data();
    this->Distance = this->Distances.data();
    this->Far = this->Fars.data();
    this->RestSize = this->Sizes.data();
    this->Symbol = this->Symbols.data();
    this->RestFar = this->RestFars.data();
    const auto* const items = this->Templates.Items.data();
    const auto* const ids = this->Ids.data();
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const auto& item = items[ids[i]];
      this->FindSources(item, i);
      this->MakeHead(item, i);
      if (!item.IsPlain())
      {
        this->MakeRest(item, i);
      }
      cells.Types[i] = item.Type;
      cells.Starts[i + 1] = this->Corner;
      this->Tree.Parents[i] = item.Sources > 0 ? this->From[0] : TetTree::NoTet;
      if (this->All.HasFaces)
      {
        this->MakeFaces(item, i);
      }
    }
    if (this->Bad != 0)
    {
      ThrowCorrupt("a chunk names a cell or a vertex that it does not have");
    }
    cells.Corners.resize(this->Size.Corners);
    this->Tree.Gates.resize(this->Size.Vertices);
  }

  /** Finds the earlier cells from which corners are copied. */
  void FindSources(const CellTemplate& item, std::uint32_t i)
  {
    for (auto& from : this->From)
    {
      ++from;
    }
    if (!item.KnowsSources)
    {
      for (unsigned s = 0; s < item.Sources; ++s)
      {
        const auto code = *this->Difference++;
        this->From[s] = code == Escape
          ? i - 1 - *this->Distance++
          : this->From[s] + static_cast<std::uint32_t>(ToSigned(code));
      }
    }
    for (unsigned s = 0; s < CellTemplate::MaxSources; ++s)
    {
      this->Bad |= static_cast<std::uint32_t>(s < item.Sources) &
        static_cast<std::uint32_t>(this->From[s] >= i);
    }
  }

  /** Makes the head, and the gates of its new vertices. */
  void MakeHead(const CellTemplate& item, std::uint32_t i)
  {
    std::array<std::uint16_t, CellTemplate::Places> places;
    static_assert(sizeof(Row) == 2 * sizeof(PackedTet));
    for (unsigned s = 0; s < CellTemplate::MaxSources; ++s)
    {
      // The row of this cell itself is empty.
      const auto& row = this->Rows[std::min(this->From[s], i)];
      std::copy(row.begin(), row.end(), places.begin() + s * CellTemplate::MaxHead);
    }
    for (unsigned k = 0; k < CellTemplate::MaxHead; ++k)
    {
      places[CellTemplate::New + k] = static_cast<std::uint16_t>(this->Next + k);
      places[CellTemplate::Far + k] = 0;
    }
    places[CellTemplate::Nothing] = 0;
    for (unsigned k = 0; k < item.Fars; ++k)
    {
      const std::uint32_t distance = *this->Far++;
      this->Bad |= static_cast<std::uint32_t>(distance >= this->Next);
      places[CellTemplate::Far + k] = static_cast<std::uint16_t>(this->Next - 1 - distance);
    }
    const auto at = [&](unsigned k) { return PackedTet{ places[item.From[k]] }; };
    const std::array<PackedTet, 2> halves{ at(0) | at(1) << 16 | at(2) << 32 | at(3) << 48,
      at(4) | at(5) << 16 | at(6) << 32 | at(7) << 48 };
    std::memcpy(this->Rows[i].data(), halves.data(), sizeof(halves));
    auto* const corners = this->Tree.Cells.Corners.data() + this->Corner;
    for (unsigned k = 0; k < 2; ++k)
    {
      corners[4 * k] = GetCorner(halves[k], 0);
      corners[4 * k + 1] = GetCorner(halves[k], 1);
      corners[4 * k + 2] = GetCorner(halves[k], 2);
      corners[4 * k + 3] = GetCorner(halves[k], 3);
    }
    this->Corner += item.Head;
    auto* gate = this->Tree.Gates.data() + this->Next;
    for (unsigned w = 0; w < item.News; ++w)
    {
      const auto& from = item.Gates[w];
      *gate++ =
        TreeSymbols::Pack(places[from[0]], places[from[1]], places[from[2]], places[from[3]]);
    }
    this->Next += item.News;
  }

  /** Makes the corners behind the head. */
  void MakeRest(const CellTemplate& item, std::uint32_t i)
  {
    auto& cells = this->Tree.Cells;
    const auto first = this->Corner - item.Head;
    const auto rest = item.IsSized ? *this->RestSize++ : item.Rest;
    this->Hidden.clear();
    for (std::uint32_t k = 0; k < rest; ++k)
    {
      const auto symbol = *this->Symbol++;
      auto vertex = this->Next;
      if (symbol == CellTemplate::NewSymbol)
      {
        this->Tree.Gates[this->Next++] = this->FindRestGate(item, first, k);
      }
      else if (symbol == CellTemplate::FarSymbol)
      {
        vertex = this->Next - 1 - *this->RestFar++;
      }
      else
      {
        vertex = this->FindNear(item, symbol - CellTemplate::NearSymbol, i);
      }
      const bool isBad = vertex >= this->Next;
      this->Bad |= static_cast<std::uint32_t>(isBad);
      vertex = isBad ? 0 : vertex;
      if (k < rest - item.Hidden)
      {
        cells.Corners[this->Corner++] = vertex;
      }
      else
      {
        this->Hidden.push_back(vertex);
      }
    }
    const auto known = std::min<std::size_t>(CellTemplate::MaxHead, this->Corner - first);
    std::copy_n(cells.Corners.begin() + first, known, this->Rows[i].begin());
  }

  /** A corner of a source, by its number behind NearSymbol. */
  std::uint32_t FindNear(const CellTemplate& item, unsigned number, std::uint32_t i)
  {
    const auto& cells = this->Tree.Cells;
    const auto source = number / CellTemplate::NearCorners;
    const auto from = std::min(this->From[source], i);
    const auto corner = cells.Starts[from] + number % CellTemplate::NearCorners;
    const bool isThere = source < item.Sources && from < i && corner < cells.Starts[from + 1];
    return isThere ? cells.Corners[corner] : this->Size.Vertices; // which is rejected
  }

  PackedTet FindRestGate(const CellTemplate& item, std::uint32_t first, std::uint32_t k) const
  {
    const auto* const corners = this->Tree.Cells.Corners.data();
    const auto before = this->Next > 0 ? this->Next - 1 : 0;
    const auto known = this->Corner - first; // corners
    if (k >= item.RestGateCount)
    {
      const auto last = known > 0 ? corners[this->Corner - 1] : before;
      const auto other = known > 1 ? corners[this->Corner - 2] : last;
      return TreeSymbols::Pack(last, last, other, other);
    }
    const auto at = [&](std::uint8_t place)
    { return place < known ? corners[first + place] : before; };
    const auto& gate = this->Templates.RestGates[item.FirstRestGate + k];
    return TreeSymbols::Pack(at(gate[0]), at(gate[1]), at(gate[2]), at(gate[3]));
  }

  void MakeFaces(const CellTemplate& item, std::uint32_t i)
  {
    auto& cells = this->Tree.Cells;
    if (item.Pattern != CellTemplate::NoPattern)
    {
      const auto& pattern = this->Templates.Patterns[item.Pattern];
      const auto* const corners = cells.Corners.data() + cells.Starts[i];
      const auto points = this->Corner - cells.Starts[i];
      for (std::size_t k = 0; k < pattern.Values.size(); ++k)
      {
        const auto value = pattern.Values[k];
        cells.Faces.push_back(pattern.IsSize[k] != 0 ? value
            : value < points                         ? corners[value]
                                                     : this->Hidden[value - points]);
      }
    }
    cells.FaceStarts[i + 1] = static_cast<std::uint32_t>(cells.Faces.size());
  }

  ByteReader& In;
  const CellTreeSize Size;
  CellTree& Tree;

  CellTemplates Templates;
  std::vector<std::uint32_t> Ids; // the template of each cell
  Totals All;
  Bytes Differences;
  std::vector<std::uint32_t> Distances;
  std::vector<std::uint16_t> Fars;
  std::vector<std::uint32_t> Sizes;
  Bytes Symbols;
  std::vector<std::uint16_t> RestFars;
  std::vector<Row> Rows; // the first corners of each cell
  std::vector<std::uint32_t> Hidden;

  // Where the walk is.
  const std::uint8_t* Difference = nullptr;
  const std::uint32_t* Distance = nullptr;
  const std::uint16_t* Far = nullptr;
  const std::uint32_t* RestSize = nullptr;
  const std::uint8_t* Symbol = nullptr;
  const std::uint16_t* RestFar = nullptr;
  std::array<std::uint32_t, CellTemplate::MaxSources> From{ TetTree::NoTet, TetTree::NoTet,
    TetTree::NoTet };
  std::uint32_t Next = 0;   // vertices so far
  std::uint32_t Corner = 0; // corners so far
  std::uint32_t Bad = 0;
};
}

//------------------------------------------------------------------------------
CellTree DecodeCellTree(std::span<const std::uint8_t> stream, const CellTreeSize& size)
{
  if (!FitsCellTree(size.Cells, size.Vertices) || size.Shared > size.Vertices)
  {
    ThrowCorrupt("a chunk has too many vertices for its coder");
  }
  ByteReader in(stream);
  CellTree tree;
  CellTreeDecoder(in, size, tree).Decode();
  return tree;
}
}
