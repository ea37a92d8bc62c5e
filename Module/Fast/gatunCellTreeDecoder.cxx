// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// As in the decoder of TetTree, what the loops must not meet is counted before, or noted by them
// and looked at once in the end.

#include "gatunCellShapes.h"
#include "gatunCellTemplates.h"
#include "gatunCellTree.h"
#include "gatunInline.h"
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
  static constexpr auto Escape = CellTemplate::Escape;

  /** Where the walk is. */
  struct Position
  {
    const std::uint8_t* Difference = nullptr;
    const std::uint32_t* Distance = nullptr;
    const std::uint16_t* Far = nullptr;
    std::array<std::uint32_t, CellTemplate::MaxSources> From{ TetTree::NoTet, TetTree::NoTet,
      TetTree::NoTet };
    std::uint32_t Next = 0;   // vertices so far
    std::uint32_t Corner = 0; // corners so far
    std::uint32_t Bad = 0;
  };

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
    this->At.Difference = this->Differences.data();
    this->At.Distance = this->Distances.data();
    this->At.Far = this->Fars.data();
    this->RestSize = this->Sizes.data();
    this->Symbol = this->Symbols.data();
    this->RestFar = this->RestFars.data();
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
      cells.Faces.resize(this->Size.FaceValues);
    }
    for (std::uint32_t i = 0; i < count;)
    {
      const auto end = this->MakePlain(i);
      if (this->All.HasFaces)
      {
        std::fill(
          cells.FaceStarts.begin() + i + 1, cells.FaceStarts.begin() + end + 1, this->FaceValue);
      }
      i = end;
      if (i < count)
      {
        this->MakeListed(i++);
      }
    }
    if (this->At.Bad != 0)
    {
      ThrowCorrupt("a chunk names a cell or a vertex that it does not have");
    }
    cells.Corners.resize(this->Size.Corners);
    this->Tree.Gates.resize(this->Size.Vertices);
  }

  /** Makes the cells from one on that have nothing but a head. Returns the next one. */
  std::uint32_t MakePlain(std::uint32_t first)
  {
    const auto* const items = this->Templates.Items.data();
    const auto* const ids = this->Ids.data();
    auto at = this->At; // compilers keep it in registers
    auto i = first;
    for (; i < this->Size.Cells && items[ids[i]].IsPlain; ++i)
    {
      this->MakeHead(at, items[ids[i]], i);
    }
    this->At = at;
    return i;
  }

  /** Makes a cell with more. */
  void MakeListed(std::uint32_t i)
  {
    const auto& item = this->Templates.Items[this->Ids[i]];
    this->MakeHead(this->At, item, i);
    this->MakeRest(item, i);
    this->Tree.Cells.Starts[i + 1] = this->At.Corner;
    if (this->All.HasFaces)
    {
      this->MakeFaces(item, i);
    }
  }

  /** Finds the earlier cells from which corners are copied. */
  GATUN_INLINE static void FindSources(Position& at, const CellTemplate& item, std::uint32_t i)
  {
    for (auto& from : at.From)
    {
      ++from;
    }
    if (!item.KnowsSources)
    {
      for (unsigned s = 0; s < item.Sources; ++s)
      {
        const auto code = *at.Difference++;
        at.From[s] = code == Escape ? i - 1 - *at.Distance++
                                    : at.From[s] + static_cast<std::uint32_t>(ToSigned(code));
      }
    }
    for (unsigned s = 0; s < CellTemplate::MaxSources; ++s)
    {
      at.Bad |=
        static_cast<std::uint32_t>(s < item.Sources) & static_cast<std::uint32_t>(at.From[s] >= i);
    }
  }

  using PlaceList = std::array<std::uint16_t, CellTemplate::Places>;

  /** Collects the vertices that the head and the gates of a cell may name. */
  GATUN_INLINE void FindPlaces(
    Position& at, const CellTemplate& item, std::uint32_t i, PlaceList& places) const
  {
    const auto* const rows = this->Rows.data();
    for (unsigned s = 0; s < CellTemplate::MaxSources; ++s)
    {
      // The row of this cell itself is empty.
      const auto& row = rows[std::min(at.From[s], i)];
      std::memcpy(places.data() + s * CellTemplate::MaxHead, row.data(), sizeof(row));
    }
    for (unsigned k = 0; k < CellTemplate::MaxHead; ++k)
    {
      places[CellTemplate::New + k] = static_cast<std::uint16_t>(at.Next + k);
    }
    places[CellTemplate::Nothing] = 0;
    for (unsigned k = 0; k < item.Fars; ++k)
    {
      const std::uint32_t distance = *at.Far++;
      at.Bad |= static_cast<std::uint32_t>(distance >= at.Next);
      places[CellTemplate::Far + k] = static_cast<std::uint16_t>(at.Next - 1 - distance);
    }
  }

  /** Makes a cell with the corners of its head, and the gates of new vertices among them. */
  GATUN_INLINE void MakeHead(Position& at, const CellTemplate& item, std::uint32_t i)
  {
    PlaceList places;
    FindSources(at, item, i);
    this->FindPlaces(at, item, i, places);
    auto& cells = this->Tree.Cells;
    std::array<std::uint32_t, CellTemplate::MaxHead> head;
    std::transform(item.From.begin(), item.From.end(), head.begin(),
      [&places](std::uint8_t from) { return places[from]; });
    // Rows are written in whole words, as they are read soon: processors wait for smaller parts.
    const std::array<PackedTet, 2> halves{ TreeSymbols::Pack(head[0], head[1], head[2], head[3]),
      TreeSymbols::Pack(head[4], head[5], head[6], head[7]) };
    std::memcpy(this->Rows[i].data(), halves.data(), sizeof(halves));
    std::copy(head.begin(), head.end(), cells.Corners.data() + at.Corner);
    const auto makeGate = [&](unsigned w)
    {
      const auto& from = item.Gates[w];
      this->Tree.Gates[at.Next + w] =
        TreeSymbols::Pack(places[from[0]], places[from[1]], places[from[2]], places[from[3]]);
    };
    makeGate(0); // without a condition, which is unpredictable; the next one may replace it
    for (unsigned w = 1; w < item.News; ++w)
    {
      makeGate(w);
    }
    at.Next += item.News;
    at.Corner += item.Head;
    cells.Types[i] = item.Type;
    cells.Starts[i + 1] = at.Corner;
    this->Tree.Parents[i] = item.Sources > 0 ? at.From[0] : TetTree::NoTet;
  }

  /** Makes the corners behind the head. */
  void MakeRest(const CellTemplate& item, std::uint32_t i)
  {
    auto& cells = this->Tree.Cells;
    const auto first = this->At.Corner - item.Head;
    const auto rest = item.IsSized ? *this->RestSize++ : item.Rest;
    const auto near = this->FindNearCorners(item, i);
    std::uint32_t k = 0;
    for (; k < rest - item.Hidden; ++k)
    {
      cells.Corners[this->At.Corner] = this->MakeCorner(item, near, first, k);
      ++this->At.Corner;
    }
    this->Hidden.clear();
    for (; k < rest; ++k)
    {
      this->Hidden.push_back(this->MakeCorner(item, near, first, k));
    }
    const auto known = std::min<std::size_t>(CellTemplate::MaxHead, this->At.Corner - first);
    std::copy_n(cells.Corners.begin() + first, known, this->Rows[i].begin());
  }

  using NearCorners = std::array<std::span<const std::uint32_t>, 4>;

  /** The corners of the sources of a cell. */
  NearCorners FindNearCorners(const CellTemplate& item, std::uint32_t i) const
  {
    const auto& cells = this->Tree.Cells;
    NearCorners near;
    for (unsigned s = 0; s < item.Sources; ++s)
    {
      const auto from = this->At.From[s];
      if (from < i)
      {
        near[s] = cells.GetCorners(from);
      }
    }
    return near;
  }

  /** Makes a corner by its symbol. */
  std::uint32_t MakeCorner(
    const CellTemplate& item, const NearCorners& near, std::uint32_t first, std::uint32_t k)
  {
    const auto symbol = *this->Symbol++;
    if (symbol == CellTemplate::NewSymbol)
    {
      this->Tree.Gates[this->At.Next] = this->FindRestGate(item, first, k);
      return this->At.Next++;
    }
    std::uint32_t vertex = this->At.Next; // which is rejected
    if (symbol == CellTemplate::FarSymbol)
    {
      vertex = this->At.Next - 1 - *this->RestFar++;
    }
    else
    {
      const unsigned number = symbol - CellTemplate::NearSymbol;
      const auto& corners = near[number / CellTemplate::NearCorners];
      const auto corner = number % CellTemplate::NearCorners;
      vertex = corner < corners.size() ? corners[corner] : vertex;
    }
    const bool isBad = vertex >= this->At.Next;
    this->At.Bad |= static_cast<std::uint32_t>(isBad);
    return isBad ? 0 : vertex;
  }

  PackedTet FindRestGate(const CellTemplate& item, std::uint32_t first, std::uint32_t k) const
  {
    const auto* const corners = this->Tree.Cells.Corners.data();
    const auto before = this->At.Next > 0 ? this->At.Next - 1 : 0;
    const auto known = this->At.Corner - first; // corners
    if (k >= item.RestGateCount)
    {
      const auto last = known > 0 ? corners[this->At.Corner - 1] : before;
      const auto other = known > 1 ? corners[this->At.Corner - 2] : last;
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
      const auto points = this->At.Corner - cells.Starts[i];
      auto* const faces = cells.Faces.data() + this->FaceValue;
      for (std::size_t k = 0; k < pattern.Values.size(); ++k)
      {
        const auto value = pattern.Values[k];
        faces[k] = pattern.IsSize[k] != 0 ? value
          : value < points                ? corners[value]
                                          : this->Hidden[value - points];
      }
      this->FaceValue += static_cast<std::uint32_t>(pattern.Values.size());
    }
    cells.FaceStarts[i + 1] = this->FaceValue;
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

  Position At;
  std::uint32_t FaceValue = 0; // values of faces so far
  const std::uint32_t* RestSize = nullptr;
  const std::uint8_t* Symbol = nullptr;
  const std::uint16_t* RestFar = nullptr;
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
