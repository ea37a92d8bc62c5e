// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellGates.h"
#include "gatunCellRows.h"
#include "gatunCellShapes.h"
#include "gatunCellTemplates.h"
#include "gatunCellTree.h"
#include "gatunFaceOrder.h"
#include "gatunNumberStream.h"
#include "gatunVertexNames.h"

#include <algorithm>
#include <map>
#include <utility>

namespace gatun
{
namespace
{
using Ids = std::vector<std::uint32_t>;
using SourceCells = std::array<std::uint32_t, CellTemplate::MaxSources>;

constexpr std::uint32_t Unmet = 0xffffffffu;

/** What distinguishes templates before they have gates. */
struct TemplateKey
{
  std::array<std::uint8_t, CellTemplate::MaxHead> From;
  std::uint8_t Type, Head, Sources;
  bool KnowsSources, IsSized;
  std::uint32_t Rest, Hidden, Pattern;

  auto operator<=>(const TemplateKey&) const = default;
};

/** A cell as it is coded. */
struct CodedCell
{
  std::uint32_t First = 0; // of its points
  std::uint32_t Points = 0;
  std::uint32_t Hidden = 0;
  std::uint32_t Next = 0; // the vertices before it
  SourceCells From{};
  std::uint32_t Key = 0; // with the head, and without
  std::uint32_t ListKey = 0;
  bool HasHead = false;
};

class CellTreeEncoder
{
public:
  CellTreeEncoder(
    const CellList& cells, std::uint32_t shared, std::span<const TreePlace> places)
    : Cells(cells)
    , Shared(shared)
    , Places(places)
    , Users(cells, places.size())
    , Ranks(cells.GetNumber(), Unmet)
    , Common(cells.GetNumber(), 0)
    , Numbers(places.size(), Unmet)
  {
  }

  EncodedCellTree Encode()
  {
    auto& order = this->Result.CellOrder;
    order = FindCellRows(this->Cells, this->Users);
    this->Coded.reserve(order.size());
    for (const auto cell : order)
    {
      this->Add(cell);
    }
    this->ChooseTemplates();
    this->FindGates();
    this->Write();
    return std::move(this->Result);
  }

private:
  /** A template must be used so often to have a head or gates of its own. */
  static constexpr std::size_t LeastUses = 4;

  //----------------------------------------------------------------------------
  // Cells, one by one

  void Add(std::uint32_t cell)
  {
    CodedCell coded;
    coded.First = static_cast<std::uint32_t>(this->Points.size());
    coded.Next = this->GetNext();
    std::uint32_t pattern = CellTemplate::NoPattern;
    const auto type = this->Cells.Types[cell];
    const auto corners = this->Cells.GetCorners(cell);
    std::span<const std::uint32_t> points = corners;
    OrderedFaces faces;
    if (type == PolyhedronType)
    {
      faces = OrderFaces(corners, this->Cells.GetFaces(cell),
        [this](std::uint32_t point) { return this->Numbers[point] == Unmet; });
      points = faces.Points;
      coded.Hidden = faces.Hidden;
      pattern = this->FindPattern(faces.Pattern);
    }
    coded.Points = static_cast<std::uint32_t>(points.size());
    const auto head = FindHead(type, points.size());
    const auto sources =
      this->FindSources(cell, points, head > 0 ? CellTemplate::MaxHead : CellTemplate::NearCorners);
    TemplateKey key{};
    key.Type = type;
    key.Sources = static_cast<std::uint8_t>(sources);
    key.KnowsSources = this->AreKnown(sources);
    key.Hidden = coded.Hidden;
    key.Pattern = pattern;
    coded.From = this->From;
    this->Ranks[cell] = static_cast<std::uint32_t>(this->Coded.size());
    this->SetList(key, points.size(), 0);
    coded.ListKey = this->FindKey(key);
    this->SetHead(key, points.first(head), sources);
    this->SetList(key, points.size(), head);
    coded.Key = this->FindKey(key);
    coded.HasHead = head > 0;
    for (const auto point : points)
    {
      this->Points.push_back(this->Meet(point));
    }
    this->Coded.push_back(coded);
    this->LastFrom = coded.From;
  }

  /** The number of corners that a template may copy. */
  static std::size_t FindHead(std::uint8_t type, std::size_t points)
  {
    const auto kind = GetCellKind(type);
    if (type == PolyhedronType)
    {
      return 0;
    }
    if (points <= CellTemplate::MaxHead)
    {
      return points;
    }
    return kind.Shape && kind.Points == points && kind.Shape->Corners <= CellTemplate::MaxHead
      ? kind.Shape->Corners
      : 0;
  }

  /** Sets what is behind the head. */
  static void SetList(TemplateKey& key, std::size_t points, std::size_t head)
  {
    key.IsSized = key.Type != PolyhedronType && points > CellTemplate::MaxHead &&
      GetCellKind(key.Type).Points != points;
    key.Rest = key.IsSized ? 0 : static_cast<std::uint32_t>(points - head);
    key.Head = static_cast<std::uint8_t>(head);
    if (head == 0)
    {
      key.From.fill(CellTemplate::Nothing);
    }
  }

  void SetHead(TemplateKey& key, std::span<const std::uint32_t> head, unsigned sources)
  {
    unsigned news = 0;
    unsigned fars = 0;
    key.From.fill(CellTemplate::Nothing);
    for (unsigned k = 0; k < head.size(); ++k)
    {
      const auto same =
        static_cast<std::size_t>(std::find(head.begin(), head.end(), head[k]) - head.begin());
      if (same < k)
      {
        key.From[k] = key.From[same];
        continue;
      }
      const auto number = this->Numbers[head[k]];
      const auto near = number != Unmet
        ? this->FindNear(number, this->From, sources, CellTemplate::MaxHead)
        : Unmet;
      key.From[k] = static_cast<std::uint8_t>(near != Unmet
          ? near
          : number == Unmet ? CellTemplate::New + news++
                            : CellTemplate::Far + fars++);
    }
  }

  std::uint32_t GetNext() const
  {
    return static_cast<std::uint32_t>(this->Result.InputOf.size());
  }

  std::uint32_t Meet(std::uint32_t input)
  {
    auto& number = this->Numbers[input];
    if (number == Unmet)
    {
      number = this->GetNext();
      this->Result.InputOf.push_back(input);
    }
    return number;
  }

  /** The corners of a coded cell, by the numbers of its vertices. */
  std::span<const std::uint32_t> GetCorners(std::uint32_t rank) const
  {
    const auto& cell = this->Coded[rank];
    return std::span(this->Points).subspan(cell.First, cell.Points - cell.Hidden);
  }

  /** Where a vertex is among the first corners of sources, reach each. */
  std::uint32_t FindNear(
    std::uint32_t number, const SourceCells& from, unsigned sources, std::size_t reach) const
  {
    for (unsigned s = 0; s < sources; ++s)
    {
      const auto corners = this->GetCorners(from[s]);
      const auto first = corners.first(std::min(corners.size(), reach));
      const auto found = std::find(first.begin(), first.end(), number);
      if (found != first.end())
      {
        return static_cast<std::uint32_t>(s * reach + static_cast<std::size_t>(found - first.begin()));
      }
    }
    return Unmet;
  }

  std::uint32_t FindPattern(const Ids& values)
  {
    const auto [found, isNew] =
      this->PatternOf.emplace(values, static_cast<std::uint32_t>(this->Templates.Patterns.size()));
    if (isNew)
    {
      this->Templates.Patterns.emplace_back(values);
    }
    return found->second;
  }

  std::uint32_t FindKey(const TemplateKey& key)
  {
    const auto [found, isNew] =
      this->KeyOf.emplace(key, static_cast<std::uint32_t>(this->Keys.size()));
    if (isNew)
    {
      this->Keys.push_back(key);
    }
    return found->second;
  }

  //----------------------------------------------------------------------------
  // Sources

  /** Finds the sources of a cell. Sets From, and returns their number. */
  unsigned FindSources(
    std::uint32_t cell, std::span<const std::uint32_t> points, std::size_t reach)
  {
    for (unsigned s = 0; s < this->From.size(); ++s)
    {
      this->From[s] = this->LastFrom[s] + 1;
    }
    this->Known.clear();
    for (const auto point : CellUsers::GetFirst(points))
    {
      const auto number = this->Numbers[point];
      if (number != Unmet &&
        std::find(this->Known.begin(), this->Known.end(), number) == this->Known.end())
      {
        this->Known.push_back(number);
      }
    }
    const auto expected = this->From;
    auto open = this->Known;
    unsigned used = 0; // of the expected ones
    for (unsigned s = 0; s < expected.size() && !open.empty(); ++s)
    {
      used = this->Cover(open, expected[s], reach) > 0 ? s + 1 : used;
    }
    const auto openOfExpected = open.size();
    this->FindNearCells(cell, points);
    open = this->Known;
    unsigned count = 0;
    SourceCells best{};
    while (count < best.size() && !open.empty())
    {
      const auto source = this->FindBest(open, expected[count], reach);
      if (source == Unmet)
      {
        break;
      }
      this->Cover(open, source, reach);
      best[count++] = source;
    }
    if (openOfExpected <= open.size())
    {
      return used;
    }
    std::copy_n(best.begin(), count, this->From.begin());
    return count;
  }

  bool AreKnown(unsigned sources) const
  {
    bool areKnown = true;
    for (unsigned s = 0; s < sources; ++s)
    {
      areKnown = areKnown && this->From[s] == this->LastFrom[s] + 1;
    }
    return areKnown;
  }

  /** Collects coded cells around a cell: those with the most corners in common first, of these the
   * last ones. */
  void FindNearCells(std::uint32_t cell, std::span<const std::uint32_t> points)
  {
    this->Near.clear();
    Ids cells;
    for (const auto point : CellUsers::GetFirst(points))
    {
      for (const auto other : this->Users.Get(point))
      {
        if (other != cell && this->Ranks[other] != Unmet && this->Common[other]++ == 0)
        {
          cells.push_back(other);
        }
      }
    }
    for (const auto other : cells)
    {
      this->Near.emplace_back(std::exchange(this->Common[other], 0), this->Ranks[other]);
    }
    std::sort(this->Near.rbegin(), this->Near.rend());
  }

  /** The cell that has most of the open vertices. */
  std::uint32_t FindBest(const Ids& open, std::uint32_t expected, std::size_t reach) const
  {
    std::uint32_t best = Unmet;
    std::size_t most = 0;
    for (const auto& [common, rank] : this->Near)
    {
      if (common < most || most == open.size())
      {
        break;
      }
      const auto count = this->CountCovered(open, rank, reach);
      if (count > most || (count == most && count > 0 && rank == expected))
      {
        most = count;
        best = rank;
      }
    }
    return best;
  }

  bool IsCovered(std::uint32_t number, std::uint32_t rank, std::size_t reach) const
  {
    const auto corners = this->GetCorners(rank);
    const auto end = corners.begin() + static_cast<std::ptrdiff_t>(std::min(corners.size(), reach));
    return std::find(corners.begin(), end, number) != end;
  }

  std::size_t CountCovered(const Ids& open, std::uint32_t rank, std::size_t reach) const
  {
    return static_cast<std::size_t>(std::count_if(open.begin(), open.end(),
      [&](std::uint32_t number) { return this->IsCovered(number, rank, reach); }));
  }

  /** Removes the vertices of a cell. Returns how many there were. */
  std::size_t Cover(Ids& open, std::uint32_t rank, std::size_t reach) const
  {
    return rank < this->Coded.size() ? std::erase_if(open,
      [&](std::uint32_t number) { return this->IsCovered(number, rank, reach); }) : 0;
  }

  //----------------------------------------------------------------------------
  // Templates

  /** Keeps templates that are used often, the most frequent first. */
  void ChooseTemplates()
  {
    std::vector<std::size_t> uses(this->Keys.size(), 0);
    for (const auto& cell : this->Coded)
    {
      ++uses[cell.Key];
    }
    for (auto& cell : this->Coded)
    {
      if (cell.HasHead && uses[cell.Key] < LeastUses)
      {
        --uses[cell.Key];
        cell.Key = cell.ListKey;
        ++uses[cell.Key];
      }
    }
    Ids order;
    for (std::uint32_t key = 0; key < uses.size(); ++key)
    {
      if (uses[key] > 0)
      {
        order.push_back(key);
      }
    }
    std::stable_sort(order.begin(), order.end(),
      [&](std::uint32_t a, std::uint32_t b) { return uses[a] > uses[b]; });
    this->IdOf.assign(uses.size(), Unmet);
    this->Samples.resize(order.size());
    for (const auto key : order)
    {
      this->IdOf[key] = static_cast<std::uint32_t>(this->Templates.Items.size());
      this->AddTemplate(this->Keys[key]);
    }
    for (std::uint32_t rank = 0; rank < this->Coded.size(); ++rank)
    {
      this->Samples[this->GetId(rank)].push_back(rank);
    }
  }

  std::uint32_t GetId(std::uint32_t rank) const { return this->IdOf[this->Coded[rank].Key]; }

  void AddTemplate(const TemplateKey& key)
  {
    CellTemplate item;
    item.From = key.From;
    item.Type = key.Type;
    item.Head = key.Head;
    item.Sources = key.Sources;
    item.KnowsSources = key.KnowsSources;
    item.IsSized = key.IsSized;
    item.Rest = key.Rest;
    item.Hidden = key.Hidden;
    item.Pattern = key.Pattern;
    item.Count();
    this->Templates.Items.push_back(item);
  }

  //----------------------------------------------------------------------------
  // Gates

  void FindGates()
  {
    for (std::size_t id = 0; id < this->Samples.size(); ++id)
    {
      auto& item = this->Templates.Items[id];
      if (this->Samples[id].size() < LeastUses)
      {
        continue;
      }
      const auto samples = Thin(this->Samples[id]);
      unsigned news = 0;
      for (unsigned k = 0; k < item.Head; ++k)
      {
        if (item.From[k] == CellTemplate::New + news)
        {
          this->FindHeadGate(item, samples, k, news++);
        }
      }
      this->FindRestGates(item, this->Samples[id]);
    }
  }

  /** Some of many, from everywhere. */
  static Ids Thin(const Ids& all)
  {
    const auto count = std::min(all.size(), GateFinder::MaxSamples);
    Ids some(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      some[i] = all[i * all.size() / count];
    }
    return some;
  }

  const TreePlace& GetPlace(std::uint32_t vertex) const
  {
    return this->Places[this->Result.InputOf[vertex]];
  }

  /** The vertex in a place before new vertex w of the head of a cell, or Unmet. */
  std::uint32_t GetVertex(
    const CellTemplate& item, std::uint32_t rank, unsigned place, unsigned w) const
  {
    const auto& cell = this->Coded[rank];
    if (place < CellTemplate::New)
    {
      const auto from = cell.From[place / CellTemplate::MaxHead];
      const auto corner = place % CellTemplate::MaxHead;
      return from < rank && corner < this->GetCorners(from).size()
        ? this->GetCorners(from)[corner]
        : Unmet;
    }
    if (place < CellTemplate::New + w)
    {
      return cell.Next + place - CellTemplate::New;
    }
    const auto found = std::find(item.From.begin(), item.From.end(), place);
    return place >= CellTemplate::Far && found != item.From.end()
      ? this->Points[cell.First + static_cast<std::uint32_t>(found - item.From.begin())]
      : Unmet;
  }

  /** Adds a candidate unless it is missing in a sample. getVertex(rank) gives it. */
  template <typename GetVertexOf>
  void AddCandidate(std::vector<GateFinder::Candidate>& candidates, std::uint8_t name,
    const Ids& samples, GetVertexOf&& getVertex) const
  {
    GateFinder::Candidate candidate{ name, {} };
    for (const auto rank : samples)
    {
      const auto vertex = getVertex(rank);
      if (vertex == Unmet)
      {
        return;
      }
      candidate.Places.push_back(this->GetPlace(vertex));
    }
    candidates.push_back(std::move(candidate));
  }

  void FindHeadGate(CellTemplate& item, const Ids& samples, unsigned corner, unsigned w)
  {
    std::vector<TreePlace> places;
    for (const auto rank : samples)
    {
      places.push_back(this->GetPlace(this->Points[this->Coded[rank].First + corner]));
    }
    std::vector<GateFinder::Candidate> candidates;
    for (unsigned place = 0; place < CellTemplate::Nothing; ++place)
    {
      this->AddCandidate(candidates, static_cast<std::uint8_t>(place), samples,
        [&](std::uint32_t rank) { return this->GetVertex(item, rank, place, w); });
    }
    item.Gates[w] = GateFinder::Find(places, candidates).value_or(CellTemplate::Gate{});
  }

  /** Whether a cell is the first one with one of its points. */
  bool IsNew(std::uint32_t rank, std::uint32_t point) const
  {
    const auto& cell = this->Coded[rank];
    const auto first = this->Points.begin() + cell.First;
    const auto number = first[point];
    return number >= cell.Next && std::find(first, first + point, number) == first + point;
  }

  void FindRestGates(CellTemplate& item, const Ids& uses)
  {
    item.FirstRestGate = static_cast<std::uint32_t>(this->Templates.RestGates.size());
    const auto rest =
      item.IsSized ? CellTemplate::MaxRestGates : std::min(item.Rest, CellTemplate::MaxRestGates);
    std::vector<CellTemplate::Gate> gates;
    std::size_t kept = 0;
    for (std::uint32_t k = 0; k < rest; ++k)
    {
      Ids samples;
      for (const auto rank : uses)
      {
        if (item.Head + k < this->Coded[rank].Points && this->IsNew(rank, item.Head + k))
        {
          samples.push_back(rank);
        }
      }
      auto& gate = gates.emplace_back();
      gate.fill(CellTemplate::Before);
      if (samples.size() >= LeastUses)
      {
        gate = this->FindRestGate(Thin(samples), item.Head + k).value_or(gate);
        kept = gates.size();
      }
    }
    gates.resize(kept);
    item.RestGateCount = static_cast<std::uint8_t>(kept);
    auto& all = this->Templates.RestGates;
    all.insert(all.end(), gates.begin(), gates.end());
  }

  std::optional<CellTemplate::Gate> FindRestGate(const Ids& samples, std::uint32_t point) const
  {
    std::vector<TreePlace> places;
    for (const auto rank : samples)
    {
      places.push_back(this->GetPlace(this->Points[this->Coded[rank].First + point]));
    }
    std::vector<GateFinder::Candidate> candidates;
    for (std::uint32_t other = 0; other < point; ++other)
    {
      this->AddCandidate(candidates, static_cast<std::uint8_t>(other), samples,
        [&](std::uint32_t rank)
        {
          const auto& cell = this->Coded[rank];
          return other < cell.Points - cell.Hidden ? this->Points[cell.First + other] : Unmet;
        });
    }
    this->AddCandidate(candidates, CellTemplate::Before, samples,
      [&](std::uint32_t rank)
      {
        const auto vertex = this->Points[this->Coded[rank].First + point];
        return vertex > 0 ? vertex - 1 : Unmet;
      });
    return GateFinder::Find(places, candidates);
  }

  //----------------------------------------------------------------------------
  // Streams

  void Write()
  {
    ByteWriter out;
    this->Templates.Write(out);
    this->WriteIds(out);
    this->WriteSources(out);
    this->WriteFars(out);
    this->WriteRests(out);
    this->Result.OwnOrder = PutVertexNames(out, this->Result.InputOf, this->Shared);
    this->Result.Stream = std::move(out.Data);
  }

  void WriteIds(ByteWriter& out) const
  {
    constexpr std::uint32_t escape = 255;
    Bytes symbols;
    NumberWriter more;
    for (std::uint32_t rank = 0; rank < this->Coded.size(); ++rank)
    {
      const auto id = this->GetId(rank);
      symbols.push_back(static_cast<std::uint8_t>(std::min(id, escape)));
      if (id >= escape)
      {
        more.Put(id - escape);
      }
    }
    PutPacked(out, symbols);
    if (this->Templates.Items.size() > escape)
    {
      more.Finish(out);
    }
  }

  void WriteSources(ByteWriter& out) const
  {
    constexpr std::uint8_t escape = 255;
    Bytes symbols;
    NumberWriter distances;
    bool hasDistances = false;
    SourceCells last{ Unmet, Unmet, Unmet };
    for (std::uint32_t rank = 0; rank < this->Coded.size(); ++rank)
    {
      const auto& from = this->Coded[rank].From;
      const auto& item = this->Templates.Items[this->GetId(rank)];
      for (unsigned s = 0; s < (item.KnowsSources ? 0 : item.Sources); ++s)
      {
        const auto difference = FromSigned(std::int64_t{ from[s] } - (last[s] + 1));
        symbols.push_back(static_cast<std::uint8_t>(std::min<std::uint64_t>(difference, escape)));
        if (difference >= escape)
        {
          distances.Put(rank - 1 - from[s]);
          hasDistances = true;
        }
      }
      last = from;
    }
    PutPacked(out, symbols);
    if (hasDistances)
    {
      distances.Finish(out);
    }
  }

  void WriteFars(ByteWriter& out) const
  {
    NumberWriter fars;
    bool hasFars = false;
    for (std::uint32_t rank = 0; rank < this->Coded.size(); ++rank)
    {
      const auto& cell = this->Coded[rank];
      const auto& item = this->Templates.Items[this->GetId(rank)];
      unsigned met = 0;
      for (unsigned k = 0; k < item.Head; ++k)
      {
        if (item.From[k] == CellTemplate::Far + met)
        {
          fars.Put(cell.Next - 1 - this->Points[cell.First + k]);
          hasFars = true;
          ++met;
        }
      }
    }
    if (hasFars)
    {
      fars.Finish(out);
    }
  }

  void WriteRests(ByteWriter& out) const
  {
    NumberWriter sizes;
    Bytes symbols;
    NumberWriter fars;
    bool hasSizes = false;
    bool hasFars = false;
    for (std::uint32_t rank = 0; rank < this->Coded.size(); ++rank)
    {
      const auto& cell = this->Coded[rank];
      const auto& item = this->Templates.Items[this->GetId(rank)];
      if (item.IsSized)
      {
        sizes.Put(cell.Points - item.Head);
        hasSizes = true;
      }
      auto next = cell.Next + item.News;
      for (auto k = std::uint32_t{ item.Head }; k < cell.Points; ++k)
      {
        const auto vertex = this->Points[cell.First + k];
        const auto near = vertex < cell.Next
          ? this->FindNear(vertex, cell.From, item.Sources, CellTemplate::NearCorners)
          : Unmet;
        if (near != Unmet)
        {
          symbols.push_back(static_cast<std::uint8_t>(CellTemplate::NearSymbol + near));
        }
        else if (vertex == next)
        {
          symbols.push_back(CellTemplate::NewSymbol);
          ++next;
        }
        else
        {
          symbols.push_back(CellTemplate::FarSymbol);
          fars.Put(next - 1 - vertex);
          hasFars = true;
        }
      }
    }
    if (hasSizes)
    {
      sizes.Finish(out);
    }
    PutPacked(out, symbols);
    if (hasFars)
    {
      fars.Finish(out);
    }
  }

  const CellList& Cells;
  const std::uint32_t Shared;
  const std::span<const TreePlace> Places; // of the input's vertices
  const CellUsers Users;
  std::vector<std::uint32_t> Ranks;  // of the input's cells
  std::vector<std::uint32_t> Common; // corners with the cell that is looked at
  std::vector<std::uint32_t> Numbers; // of the input's vertices

  std::vector<CodedCell> Coded;
  Ids Points; // of all coded cells
  SourceCells From{};
  SourceCells LastFrom{ Unmet, Unmet, Unmet };
  Ids Known;                                                  // vertices of the cell
  std::vector<std::pair<std::uint32_t, std::uint32_t>> Near;  // common corners and ranks

  std::map<TemplateKey, std::uint32_t> KeyOf;
  std::vector<TemplateKey> Keys;
  std::map<Ids, std::uint32_t> PatternOf;
  Ids IdOf;                 // the template of each key
  std::vector<Ids> Samples; // the cells of each template
  CellTemplates Templates;
  EncodedCellTree Result;
};
}

//------------------------------------------------------------------------------
EncodedCellTree EncodeCellTree(
  const CellList& cells, std::uint32_t shared, std::span<const TreePlace> places)
{
  return CellTreeEncoder(cells, shared, places).Encode();
}
}
