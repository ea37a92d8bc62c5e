// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunCellGates.h"
#include "gatunCellRows.h"
#include "gatunCellShapes.h"
#include "gatunCellSources.h"
#include "gatunCellTemplates.h"
#include "gatunCellTree.h"
#include "gatunCellTreeWriter.h"
#include "gatunCodedCells.h"
#include "gatunFaceOrder.h"
#include "gatunVertexNames.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace gatun
{
namespace
{
using Ids = std::vector<std::uint32_t>;

constexpr auto Unmet = CodedCells::None;

/** What distinguishes templates before they have gates. */
struct TemplateKey
{
  std::array<std::uint8_t, CellTemplate::MaxHead> From;
  std::uint8_t Type, Head, Sources;
  bool KnowsSources, IsSized;
  std::uint32_t Rest, Hidden, Pattern;

  auto Tie() const
  {
    return std::tie(this->From, this->Type, this->Head, this->Sources, this->KnowsSources,
      this->IsSized, this->Rest, this->Hidden, this->Pattern);
  }

  bool operator==(const TemplateKey&) const = default;
  bool operator<(const TemplateKey& other) const { return this->Tie() < other.Tie(); }
};

/** The template of a cell with a head and without. */
struct KeyChoice
{
  std::uint32_t WithHead = 0;
  std::uint32_t List = 0;
};

class CellTreeEncoder
{
public:
  CellTreeEncoder(const CellList& cells, std::uint32_t shared, std::span<const TreePlace> places,
    bool keepCorners)
    : Cells(cells)
    , Shared(shared)
    , KeepCorners(keepCorners)
    , Places(places)
    , Users(cells, places.size())
    , Numbers(places.size(), Unmet)
    , Finder(cells.GetNumber(), this->Coded, this->Users, this->Numbers)
  {
  }

  EncodedCellTree Encode()
  {
    auto& order = this->Result.CellOrder;
    order = FindCellRows(this->Cells, this->Users);
    this->Coded.Items.reserve(order.size());
    this->KeysOf.reserve(order.size());
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
    coded.First = static_cast<std::uint32_t>(this->Coded.Points.size());
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
      this->Finder.Find(cell, points, head > 0 ? CellTemplate::MaxHead : CellTemplate::NearCorners);
    TemplateKey key{};
    key.Type = type;
    key.Sources = static_cast<std::uint8_t>(sources);
    key.KnowsSources = this->Finder.AreKnown;
    key.Hidden = coded.Hidden;
    key.Pattern = pattern;
    coded.From = this->Finder.From;
    Triangle turned{};
    if (!this->KeepCorners && type == TriangleType && points.size() == turned.size())
    {
      turned = this->Turn(points, sources);
      points = turned;
    }
    KeyChoice keys;
    SetList(key, points.size(), 0);
    keys.List = this->FindKey(key, this->LastKeys.List);
    this->SetHead(key, points.first(head), sources);
    SetList(key, points.size(), head);
    keys.WithHead = this->FindKey(key, this->LastKeys.WithHead);
    this->KeysOf.push_back(keys);
    for (const auto point : points)
    {
      this->Coded.Points.push_back(this->Meet(point));
    }
    this->Coded.Items.push_back(coded);
  }

  using Triangle = std::array<std::uint32_t, 3>;

  /** Of the ways to turn a triangle, the one whose places are the least in lexicographic order, so
   * that templates are few. */
  Triangle Turn(std::span<const std::uint32_t> corners, unsigned sources) const
  {
    Triangle best{};
    std::copy(corners.begin(), corners.end(), best.begin());
    auto turned = best;
    const auto getPlaces = [&](const Triangle& triangle)
    {
      return std::array{ this->FindPlace(triangle[0], sources),
        this->FindPlace(triangle[1], sources), this->FindPlace(triangle[2], sources) };
    };
    for (int turn = 1; turn < 3; ++turn)
    {
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      best = getPlaces(turned) < getPlaces(best) ? turned : best;
    }
    return best;
  }

  /** The place of a corner in a head: of a new or far vertex, that of the first one. */
  std::uint8_t FindPlace(std::uint32_t corner, unsigned sources) const
  {
    const auto number = this->Numbers[corner];
    if (number == Unmet)
    {
      return CellTemplate::New;
    }
    const auto near =
      this->Coded.FindNear(number, this->Finder.From, sources, CellTemplate::MaxHead);
    return near != Unmet ? static_cast<std::uint8_t>(near) : CellTemplate::Far;
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
    std::uint8_t news = 0;
    std::uint8_t fars = 0;
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
      const auto place = this->FindPlace(head[k], sources);
      const auto others = place == CellTemplate::New ? news++
        : place == CellTemplate::Far                 ? fars++
                                                     : std::uint8_t{ 0 };
      key.From[k] = static_cast<std::uint8_t>(place + others);
    }
  }

  std::uint32_t GetNext() const { return static_cast<std::uint32_t>(this->Result.InputOf.size()); }

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

  std::uint32_t FindPattern(const Ids& values)
  {
    const auto [found, isNew] = this->PatternOf.try_emplace(
      values, static_cast<std::uint32_t>(this->Templates.Patterns.size()));
    if (isNew)
    {
      this->Templates.Patterns.emplace_back(values);
    }
    return found->second;
  }

  /** last: the one found before, which is often the same. */
  std::uint32_t FindKey(const TemplateKey& key, std::uint32_t& last)
  {
    if (last < this->Keys.size() && this->Keys[last] == key)
    {
      return last;
    }
    const auto [found, isNew] =
      this->KeyOf.try_emplace(key, static_cast<std::uint32_t>(this->Keys.size()));
    if (isNew)
    {
      this->Keys.push_back(key);
    }
    last = found->second;
    return last;
  }

  //----------------------------------------------------------------------------
  // Templates

  /** Keeps templates that are used often, the most frequent first. */
  void ChooseTemplates()
  {
    std::vector<std::size_t> uses(this->Keys.size(), 0);
    for (const auto& keys : this->KeysOf)
    {
      ++uses[keys.WithHead];
    }
    for (auto& keys : this->KeysOf)
    {
      if (keys.WithHead != keys.List && uses[keys.WithHead] < LeastUses)
      {
        --uses[keys.WithHead];
        keys.WithHead = keys.List;
        ++uses[keys.List];
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
    Ids idOf(uses.size(), Unmet);
    this->Samples.resize(order.size());
    for (const auto key : order)
    {
      idOf[key] = static_cast<std::uint32_t>(this->Templates.Items.size());
      this->AddTemplate(this->Keys[key]);
    }
    for (std::uint32_t rank = 0; rank < this->KeysOf.size(); ++rank)
    {
      const auto id = idOf[this->KeysOf[rank].WithHead];
      this->Coded.Items[rank].Template = id;
      this->Samples[id].push_back(rank);
    }
  }

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
    const auto& cell = this->Coded.Items[rank];
    if (place < CellTemplate::New)
    {
      const auto from = cell.From[place / CellTemplate::MaxHead];
      const auto corner = place % CellTemplate::MaxHead;
      return from < rank && corner < this->Coded.GetCorners(from).size()
        ? this->Coded.GetCorners(from)[corner]
        : Unmet;
    }
    if (place < CellTemplate::New + w)
    {
      return cell.Next + place - CellTemplate::New;
    }
    const auto found = std::find(item.From.begin(), item.From.end(), place);
    return place >= CellTemplate::Far && found != item.From.end()
      ? this->Coded.Points[cell.First + static_cast<std::uint32_t>(found - item.From.begin())]
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
      places.push_back(this->GetPlace(this->Coded.Points[this->Coded.Items[rank].First + corner]));
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
    const auto& cell = this->Coded.Items[rank];
    const auto first = this->Coded.Points.begin() + cell.First;
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
        if (item.Head + k < this->Coded.Items[rank].Points && this->IsNew(rank, item.Head + k))
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
      places.push_back(this->GetPlace(this->Coded.Points[this->Coded.Items[rank].First + point]));
    }
    std::vector<GateFinder::Candidate> candidates;
    for (std::uint32_t other = 0; other < point; ++other)
    {
      this->AddCandidate(candidates, static_cast<std::uint8_t>(other), samples,
        [&](std::uint32_t rank)
        {
          const auto& cell = this->Coded.Items[rank];
          return other < cell.Points - cell.Hidden ? this->Coded.Points[cell.First + other] : Unmet;
        });
    }
    this->AddCandidate(candidates, CellTemplate::Before, samples,
      [&](std::uint32_t rank)
      {
        const auto vertex = this->Coded.Points[this->Coded.Items[rank].First + point];
        return vertex > 0 ? vertex - 1 : Unmet;
      });
    return GateFinder::Find(places, candidates);
  }

  //----------------------------------------------------------------------------
  // Streams

  void Write()
  {
    ByteWriter out;
    CellTreeWriter(this->Templates, this->Coded).Write(out);
    this->Result.OwnOrder = PutVertexNames(out, this->Result.InputOf, this->Shared);
    this->Result.Stream = std::move(out.Data);
  }

  const CellList& Cells;
  const std::uint32_t Shared;
  const bool KeepCorners;
  const std::span<const TreePlace> Places; // of the input's vertices
  const CellUsers Users;
  Ids Numbers; // of the input's vertices
  CodedCells Coded;
  SourceFinder Finder;

  std::map<TemplateKey, std::uint32_t> KeyOf;
  std::vector<TemplateKey> Keys;
  KeyChoice LastKeys;
  std::vector<KeyChoice> KeysOf; // of cells
  std::map<Ids, std::uint32_t> PatternOf;
  std::vector<Ids> Samples; // the cells of each template
  CellTemplates Templates;
  EncodedCellTree Result;
};
}

//------------------------------------------------------------------------------
EncodedCellTree EncodeCellTree(
  const CellList& cells, std::uint32_t shared, std::span<const TreePlace> places, bool keepCorners)
{
  return CellTreeEncoder(cells, shared, places, keepCorners).Encode();
}
}
