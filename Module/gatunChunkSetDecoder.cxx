// SPDX-License-Identifier: BSD-3-Clause
#include "gatunChunkSetDecoder.h"

#include "gatunFloatEnvironment.h"
#include "gatunParallel.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <numeric>
#include <string>

namespace gatun
{
namespace
{
/** Calls use with a function that writes a key as a value of a type, chosen once for many values.
 */
template <typename Use>
void WithWriter(const Domain& domain, Use&& use)
{
  const auto type = domain.GetType();
  if (domain.GetPalette())
  {
    const auto& palette = *domain.GetPalette();
    use(
      [type, &palette](Key key, std::uint8_t* to) { Domain::WritePlain(type, palette[key], to); });
  }
  else if (type == ScalarType::Float32)
  {
    use([](Key key, std::uint8_t* to) { Domain::WritePlain(ScalarType::Float32, key, to); });
  }
  else if (type == ScalarType::Float64)
  {
    use([](Key key, std::uint8_t* to) { Domain::WritePlain(ScalarType::Float64, key, to); });
  }
  else
  {
    use([type](Key key, std::uint8_t* to) { Domain::WritePlain(type, key, to); });
  }
}

std::string Name(const char* what, std::size_t index)
{
  return std::string(what) + " " + std::to_string(index);
}

void CheckBelow(const std::vector<Key>& ids, Key end)
{
  if (std::any_of(ids.begin(), ids.end(), [&](Key id) { return id >= end; }))
  {
    ThrowCorrupt("it names a place that is not there");
  }
}

std::vector<std::uint64_t> Count(std::uint64_t first, std::size_t count)
{
  std::vector<std::uint64_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

/** Room for the values of a step; those of the step before move in where they may be referred to.
 */
std::vector<ComponentKeys> MakeKeys(const ArrayDescription& array, std::size_t count,
  bool hasBefore, std::vector<ComponentKeys>& before)
{
  std::vector<ComponentKeys> keys(array.Components);
  for (std::size_t c = 0; c < keys.size(); ++c)
  {
    if (hasBefore && c < before.size())
    {
      keys[c].Before = std::move(before[c].Now);
    }
    keys[c].Now.resize(count);
  }
  return keys;
}
}

//--------------------------------------------------------------------------------------------------
struct ChunkSetDecoder::Job
{
  const InputFile& File;
  const PieceTarget& Target;
  const std::vector<std::uint32_t>& Arrays;
  std::vector<std::size_t> FirstSteps; // of each array; it is decoded from there on
  const bool RestorePoints;
  const bool RestoreCells;
  const bool RestoreCorners;
  std::size_t Step = 0;
  bool IsLast = false;                      // this step is the one to store
  std::vector<std::vector<Domain>> Domains; // of each array wanted, at this step

  // Places filled so far, where an order is restored: a damaged file might name one twice and
  // leave another one as it was.
  mutable std::vector<std::atomic<bool>> PointTaken;
  mutable std::vector<std::atomic<bool>> CellTaken;

  void TakePoint(std::uint64_t place) const { this->Take(this->PointTaken, place, "point "); }
  void TakeCell(std::uint64_t place) const { this->Take(this->CellTaken, place, "cell "); }

  void Take(std::vector<std::atomic<bool>>& taken, std::uint64_t place, const char* what) const
  {
    if (!taken.empty() && taken[static_cast<std::size_t>(place)].exchange(true))
    {
      this->File.Fail(ErrorCode::Corrupt,
        "the original order is damaged: it names " + (what + std::to_string(place)) + " twice");
    }
  }

  /** Calls use(index into the request's arrays) for those to decode at this step. */
  template <typename Use>
  void EachToDecode(Use&& use) const
  {
    for (std::size_t a = 0; a < this->Target.Arrays.size(); ++a)
    {
      if (this->FirstSteps[a] <= this->Step)
      {
        use(a);
      }
    }
  }

  void StoreTuples(std::size_t a, const ArrayDescription& array,
    const std::vector<ComponentKeys>& keys, std::size_t count, auto&& keyOf, auto&& placeOf) const
  {
    auto* values = static_cast<std::uint8_t*>(this->Target.Arrays[a]);
    if (!values)
    {
      return;
    }
    const auto size = SizeOf(array.Type);
    const auto stride = size * array.Components;
    for (std::size_t c = 0; c < keys.size(); ++c)
    {
      WithWriter(this->Domains[a][c],
        [&](auto&& write)
        {
          const auto& now = keys[c].Now;
          auto* component = values + c * size;
          for (std::size_t i = 0; i < count; ++i)
          {
            write(now[keyOf(i)], component + placeOf(i) * stride);
          }
        });
    }
  }

  void StorePoint(const PointDomain& domains, const PointKeys& keys, std::uint64_t place) const
  {
    const auto size = SizeOf(domains[0].GetType());
    auto* to = static_cast<std::uint8_t*>(this->Target.Points) + 3 * size * place;
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      domains[axis].Write(keys[axis], to + axis * size);
    }
  }
};

//--------------------------------------------------------------------------------------------------
ChunkSetDecoder::ChunkSetDecoder(std::shared_ptr<const FileReader> file,
  std::vector<std::uint32_t> chunks, std::vector<std::uint32_t> universe, bool withUnusedPoints)
  : File(std::move(file))
  , Chunks(std::move(chunks))
  , Universe(std::move(universe))
  , WithUnused(withUnusedPoints)
  , KeepsState(File->GetNumberOfSteps() > 1)
  , DecodedStep(File->GetArrays().size(), NoStep)
  , Blocks(GetBlockCount())
  , States(Chunks.size())
{
  const auto& mesh = this->Content().Mesh;
  this->GroupStart.resize(mesh.Blocks.size());
  for (std::size_t b = 0; b < mesh.Blocks.size(); ++b)
  {
    this->GroupStart[b].assign(mesh.Blocks[b].Groups.size(), Absent);
  }
  for (const auto c : this->Chunks)
  {
    for (const auto& part : mesh.Chunks[c].Shared)
    {
      this->GroupStart[part.Block][part.Group] = 0;
      this->Blocks[part.Block].Needed = true;
    }
  }
  for (std::size_t b = 0; b < mesh.Blocks.size(); ++b)
  {
    for (std::size_t g = 0; g < mesh.Blocks[b].Groups.size(); ++g)
    {
      if (this->GroupStart[b][g] != Absent)
      {
        this->GroupStart[b][g] = this->Points;
        this->Points += mesh.Blocks[b].Groups[g].Points;
      }
    }
  }
  for (const auto c : this->Chunks)
  {
    this->FirstOwn.push_back(this->Points);
    this->FirstTet.push_back(this->Tets);
    this->Points += mesh.Chunks[c].Info.OwnPoints;
    this->Tets += mesh.Chunks[c].Info.Tets;
  }
  this->FirstUnused = this->Points;
  if (this->WithUnused)
  {
    this->Points += mesh.Unused.Points;
    this->Blocks.back().Needed = mesh.Unused.Points > 0;
  }
}

bool ChunkSetDecoder::IsWhole() const
{
  const auto& content = this->Content();
  return this->Chunks.size() == content.Mesh.Chunks.size() &&
    (this->WithUnused || content.Meta.UnusedPoints == 0);
}

void ChunkSetDecoder::MarkOwners(unsigned char* ghosts) const
{
  const auto& mesh = this->Content().Mesh;
  std::memset(ghosts, 0, static_cast<std::size_t>(this->Points));
  for (std::size_t b = 0; b < mesh.Blocks.size(); ++b)
  {
    for (std::size_t g = 0; g < mesh.Blocks[b].Groups.size(); ++g)
    {
      const auto& group = mesh.Blocks[b].Groups[g];
      if (this->GroupStart[b][g] != Absent && !this->Owns(group))
      {
        std::memset(ghosts + this->GroupStart[b][g], 1, group.Points);
      }
    }
  }
}

bool ChunkSetDecoder::Owns(const SharedGroup& group) const
{
  const auto has = [](const std::vector<std::uint32_t>& set, std::uint32_t chunk)
  { return std::binary_search(set.begin(), set.end(), chunk); };
  const auto owner = this->Universe.empty()
    ? group.Chunks.begin()
    : std::find_if(group.Chunks.begin(), group.Chunks.end(),
        [&](std::uint32_t chunk) { return has(this->Universe, chunk); });
  return owner != group.Chunks.end() && has(this->Chunks, *owner);
}

const BlockEntry& ChunkSetDecoder::GetBlock(std::size_t block) const
{
  const auto& mesh = this->Content().Mesh;
  return block < mesh.Blocks.size() ? mesh.Blocks[block] : mesh.Unused;
}

std::vector<std::uint64_t> ChunkSetDecoder::Locate(const ChunkSetDecoder& part) const
{
  const auto& mesh = this->Content().Mesh;
  std::vector<std::uint64_t> places(static_cast<std::size_t>(part.Points));
  const auto copy = [&](std::uint64_t from, std::uint64_t to, std::uint64_t count)
  {
    for (std::uint64_t i = 0; i < count; ++i)
    {
      places[static_cast<std::size_t>(from + i)] = to + i;
    }
  };
  for (std::size_t b = 0; b < mesh.Blocks.size(); ++b)
  {
    for (std::size_t g = 0; g < mesh.Blocks[b].Groups.size(); ++g)
    {
      if (part.GroupStart[b][g] != Absent)
      {
        copy(part.GroupStart[b][g], this->GroupStart[b][g], mesh.Blocks[b].Groups[g].Points);
      }
    }
  }
  for (std::size_t i = 0, j = 0; j < part.Chunks.size(); ++i)
  {
    if (this->Chunks[i] == part.Chunks[j])
    {
      copy(part.FirstOwn[j], this->FirstOwn[i], mesh.Chunks[part.Chunks[j]].Info.OwnPoints);
      ++j;
    }
  }
  if (part.WithUnused)
  {
    copy(part.FirstUnused, this->FirstUnused, mesh.Unused.Points);
  }
  return places;
}

//--------------------------------------------------------------------------------------------------
std::vector<std::size_t> ChunkSetDecoder::FindFirstSteps(
  const std::vector<std::uint32_t>& arrays, std::size_t step) const
{
  std::vector<std::size_t> first;
  const auto key = this->KeepsState ? this->Content().FindKeyStep(step) : step;
  for (const auto array : arrays)
  {
    const auto decoded = this->DecodedStep[array];
    first.push_back(decoded != NoStep && decoded >= key && decoded <= step ? decoded + 1 : key);
  }
  return first;
}

void ChunkSetDecoder::Fill(const PieceTarget& target, const std::vector<std::uint32_t>& arrays,
  std::size_t step, bool restoreOrder, const Progress& progress)
{
  const auto& content = this->Content();
  const auto keep = restoreOrder && this->IsWhole() ? content.Meta.Keep : 0;
  const auto& wanted = target.Arrays.empty() ? std::vector<std::uint32_t>{} : arrays;
  Job job{ content.File, target, wanted, this->FindFirstSteps(wanted, step),
    (keep & KeepPoints) != 0, (keep & KeepCells) != 0, (keep & KeepCorners) != 0, 0, false, {}, {},
    {} };
  if (job.RestorePoints)
  {
    job.PointTaken = std::vector<std::atomic<bool>>(static_cast<std::size_t>(this->Points));
  }
  if (job.RestoreCells)
  {
    job.CellTaken = std::vector<std::atomic<bool>>(static_cast<std::size_t>(this->Tets));
  }
  const auto first = job.FirstSteps.empty()
    ? step
    : std::min(step, *std::min_element(job.FirstSteps.begin(), job.FirstSteps.end()));
  for (const auto array : wanted)
  {
    this->DecodedStep[array] = NoStep; // until all of it has been decoded
  }
  // Step by step for the whole set: chunks see the shared points' values of the same step.
  for (job.Step = first; job.Step <= step; ++job.Step)
  {
    job.IsLast = job.Step == step;
    job.Domains.clear();
    for (const auto array : wanted)
    {
      job.Domains.push_back(content.MakeDomains(array, job.Step));
    }
    ParallelFor(this->Blocks.size(),
      [&](std::size_t b)
      {
        const FloatEnvironment guard;
        if (this->Blocks[b].Needed)
        {
          this->DecodeBlock(job, b);
        }
      });
    const auto steps = static_cast<double>(step - first + 1);
    const auto done = static_cast<double>(job.Step - first) / steps;
    ParallelFor(
      this->Chunks.size(),
      [&](std::size_t i)
      {
        const FloatEnvironment guard;
        this->DecodeChunkInto(job, i);
      },
      [&](double part) { return !progress || progress(done + part / steps); });
  }
  if (this->KeepsState)
  {
    for (const auto array : wanted)
    {
      this->DecodedStep[array] = step;
    }
    return;
  }
  for (auto& block : this->Blocks)
  {
    block.Arrays.clear();
  }
}

//--------------------------------------------------------------------------------------------------
void ChunkSetDecoder::DecodeBlock(const Job& job, std::size_t index)
{
  const auto& content = this->Content();
  const auto& entry = this->GetBlock(index);
  auto& state = this->Blocks[index];
  const auto count = static_cast<std::size_t>(entry.Points);
  if (state.Points.empty())
  {
    const auto what = Name("the points of block", index);
    const auto stream = content.File.Read(entry.Geometry, what);
    std::vector<ComponentKeys> keys(3);
    for (auto& component : keys)
    {
      component.Now.resize(count);
    }
    content.Guarded(
      what, entry.Geometry, [&] { DecodeCellValues(stream, {}, content.Domains, keys); });
    std::vector<PointKeys> points(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      points[i] = { keys[0].Now[i], keys[1].Now[i], keys[2].Now[i] };
    }
    state.Points = std::move(points);
  }
  if (state.Order.empty() && (content.Meta.Keep & KeepPoints) &&
    (job.RestorePoints || job.Target.GlobalPointIds))
  {
    const auto what = Name("the order of the points of block", index);
    const auto stream = content.File.Read(entry.Order, what);
    ComponentKeys keys;
    keys.Now.resize(count);
    const Domain ids(ScalarType::UInt32);
    content.Guarded(what, entry.Order,
      [&]
      {
        DecodeCellValues(stream, {}, { &ids, 1 }, { &keys, 1 });
        CheckBelow(keys.Now, content.Meta.Points);
      });
    state.Order.assign(keys.Now.begin(), keys.Now.end());
  }
  state.Arrays.resize(content.Meta.Arrays.size());
  job.EachToDecode(
    [&](std::size_t a)
    {
      if (content.Meta.Arrays[job.Arrays[a]].Where == Association::Point)
      {
        this->DecodeBlockArray(job, index, a);
      }
    });
  if (job.IsLast)
  {
    this->StoreBlock(job, index);
  }
}

void ChunkSetDecoder::DecodeBlockArray(const Job& job, std::size_t index, std::size_t a)
{
  const auto& content = this->Content();
  const auto array = job.Arrays[a];
  const auto& description = content.Meta.Arrays[array];
  auto& state = this->Blocks[index].Arrays[array];
  const auto what = Name(("array '" + description.Name + "' of block").c_str(), index);
  const auto& where = content.Steps[job.Step].Arrays[array].Blocks[index];
  const auto count = static_cast<std::size_t>(this->GetBlock(index).Points);
  auto keys = MakeKeys(description, count, content.HasBefore(array, job.Step), state);
  const auto stream = content.File.Read(where, what);
  content.Guarded(what, where, [&] { DecodeCellValues(stream, {}, job.Domains[a], keys); });
  state = std::move(keys);
}

void ChunkSetDecoder::StoreBlock(const Job& job, std::size_t index) const
{
  const auto& content = this->Content();
  const auto& entry = this->GetBlock(index);
  const auto& state = this->Blocks[index];
  const auto store = [&](std::size_t first, std::size_t count, std::uint64_t start, bool owned)
  {
    const auto place = [&](std::size_t i)
    { return job.RestorePoints ? state.Order[first + i] : start + i; };
    for (std::size_t i = 0; i < count; ++i)
    {
      job.TakePoint(place(i));
      if (job.Target.Points)
      {
        job.StorePoint(content.Domains, state.Points[first + i], place(i));
      }
      if (job.Target.GlobalPointIds)
      {
        job.Target.GlobalPointIds[place(i)] = static_cast<std::int64_t>(
          state.Order.empty() ? entry.FirstPoint + first + i : state.Order[first + i]);
      }
      if (job.Target.PointGhosts)
      {
        job.Target.PointGhosts[place(i)] = !owned;
      }
    }
    for (std::size_t a = 0; a < job.Target.Arrays.size(); ++a)
    {
      const auto& array = content.Meta.Arrays[job.Arrays[a]];
      if (array.Where == Association::Point)
      {
        job.StoreTuples(
          a, array, state.Arrays[job.Arrays[a]], count, [&](std::size_t i) { return first + i; },
          place);
      }
    }
  };
  if (index + 1 == this->Blocks.size())
  {
    store(0, static_cast<std::size_t>(entry.Points), this->FirstUnused, true);
    return;
  }
  std::size_t first = 0;
  for (std::size_t g = 0; g < entry.Groups.size(); ++g)
  {
    const auto& group = entry.Groups[g];
    if (this->GroupStart[index][g] != Absent)
    {
      store(first, group.Points, this->GroupStart[index][g], this->Owns(group));
    }
    first += group.Points;
  }
}

//--------------------------------------------------------------------------------------------------
template <typename Use>
void ChunkSetDecoder::EachShared(std::size_t chunk, const ChunkMesh& mesh, Use&& use) const
{
  const auto& table = this->Content().Mesh;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> places; // block, place in it
  for (const auto& part : table.Chunks[chunk].Shared)
  {
    const auto count = table.Blocks[part.Block].Groups[part.Group].Points;
    for (std::uint32_t i = 0; i < count; ++i)
    {
      places.emplace_back(part.Block, static_cast<std::uint32_t>(part.FirstInBlock) + i);
    }
  }
  for (Vertex v = 0; v < mesh.Walk.Sources.size(); ++v)
  {
    const auto source = mesh.Walk.Sources[v];
    if (source & Topology::SharedFlag)
    {
      const auto& place = places[source & ~Topology::SharedFlag];
      use(v, place.first, place.second);
    }
  }
}

std::unique_ptr<ChunkMesh> ChunkSetDecoder::DecodeMesh(std::size_t chunk) const
{
  const auto& content = this->Content();
  const auto& entry = content.Mesh.Chunks[chunk];
  ChunkFrame frame;
  frame.Tets = static_cast<std::uint32_t>(entry.Info.Tets);
  frame.OwnPoints = static_cast<std::uint32_t>(entry.Info.OwnPoints);
  frame.Box = entry.Info.Box;
  frame.Domains = content.Domains;
  frame.SharedUsers = content.Mesh.GetSharedUsers(chunk);
  frame.SharedKeys.reserve(frame.SharedUsers.size());
  for (const auto& part : entry.Shared)
  {
    const auto& points = this->Blocks[part.Block].Points;
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(part.FirstInBlock);
    frame.SharedKeys.insert(frame.SharedKeys.end(), begin,
      begin + content.Mesh.Blocks[part.Block].Groups[part.Group].Points);
  }
  const auto what = Name("the mesh of chunk", chunk);
  const auto connectivity = content.File.Read(entry.Connectivity, what);
  const auto geometry = content.File.Read(entry.Geometry, what);
  return content.Guarded(what, entry.Connectivity,
    [&] { return std::make_unique<ChunkMesh>(DecodeChunk(frame, connectivity, geometry)); });
}

std::vector<Key> ChunkSetDecoder::DecodeCellIntegers(const StreamRef& where,
  const std::string& what, const ChunkMesh& mesh, ScalarType type, Key end) const
{
  const auto& content = this->Content();
  const auto stream = content.File.Read(where, what);
  const Domain domain(type);
  ComponentKeys keys;
  keys.Now.resize(mesh.Walk.Parents.size());
  content.Guarded(what, where,
    [&]
    {
      DecodeCellValues(stream, mesh.Walk.Parents, { &domain, 1 }, { &keys, 1 });
      CheckBelow(keys.Now, end);
    });
  return std::move(keys.Now);
}

std::vector<std::uint64_t> ChunkSetDecoder::DecodeCellOrder(
  const ChunkMesh& mesh, std::size_t chunk) const
{
  const auto& content = this->Content();
  return this->DecodeCellIntegers(content.Mesh.Chunks[chunk].CellOrder,
    Name("the original order of the cells of chunk", chunk), mesh, ScalarType::UInt32,
    content.Meta.Tets);
}

std::vector<std::uint64_t> ChunkSetDecoder::DecodePointOrder(
  ChunkMesh& mesh, std::size_t chunk) const
{
  const auto& content = this->Content();
  const auto& where = content.Mesh.Chunks[chunk].PointOrder;
  const auto what = Name("the original order of the points of chunk", chunk);
  const auto stream = content.File.Read(where, what);
  const Domain ids(ScalarType::UInt32);
  ComponentKeys keys;
  keys.Now.resize(mesh.Keys.size());
  this->EachShared(chunk, mesh,
    [&](Vertex v, std::uint32_t block, std::uint32_t place)
    { keys.Now[v] = this->Blocks[block].Order[place]; });
  content.Guarded(what, where,
    [&]
    {
      mesh.MakeContext(ArrayModes::Read(stream).Spatial == SpatialMode::Fit);
      DecodePointValues(stream, mesh.Context, { &ids, 1 }, { &keys, 1 });
      CheckBelow(keys.Now, content.Meta.Points);
    });
  std::vector<std::uint64_t> order(mesh.Context.OwnIds.size());
  for (std::size_t own = 0; own < order.size(); ++own)
  {
    order[own] = keys.Now[mesh.Context.OwnIds[own]];
  }
  return order;
}

void ChunkSetDecoder::DecodeChunkArray(
  const Job& job, std::size_t chunk, ChunkMesh& mesh, std::size_t a, ArrayState& state)
{
  const auto& content = this->Content();
  const auto array = job.Arrays[a];
  const auto& description = content.Meta.Arrays[array];
  const bool ofPoints = description.Where == Association::Point;
  const auto what = Name(("array '" + description.Name + "' of chunk").c_str(), chunk);
  const auto& where = content.Steps[job.Step].Arrays[array].Chunks[chunk];
  const auto count = ofPoints ? mesh.Keys.size() : mesh.Walk.Parents.size();
  auto keys = MakeKeys(description, count, content.HasBefore(array, job.Step), state);
  const auto stream = content.File.Read(where, what);
  const auto& domains = job.Domains[a];
  content.Guarded(what, where,
    [&]
    {
      if (!ofPoints)
      {
        DecodeCellValues(stream, mesh.Walk.Parents, domains, keys);
        return;
      }
      for (std::size_t c = 0; c < keys.size(); ++c)
      {
        this->EachShared(chunk, mesh,
          [&](Vertex v, std::uint32_t block, std::uint32_t place)
          { keys[c].Now[v] = this->Blocks[block].Arrays[array][c].Now[place]; });
      }
      mesh.MakeContext(ArrayModes::Read(stream).Spatial == SpatialMode::Fit);
      DecodePointValues(stream, mesh.Context, domains, keys);
    });
  state = std::move(keys);
}

void ChunkSetDecoder::DecodeChunkInto(const Job& job, std::size_t index)
{
  const auto chunk = this->Chunks[index];
  auto& state = this->States[index];
  if (!state.Mesh)
  {
    state.Mesh = this->DecodeMesh(chunk);
  }
  state.Arrays.resize(this->Content().Meta.Arrays.size());
  job.EachToDecode([&](std::size_t a)
    { this->DecodeChunkArray(job, chunk, *state.Mesh, a, state.Arrays[job.Arrays[a]]); });
  if (job.IsLast)
  {
    this->StoreChunk(job, index, *state.Mesh);
  }
  if (!this->KeepsState)
  {
    state = {};
  }
}

void ChunkSetDecoder::StoreChunk(const Job& job, std::size_t index, ChunkMesh& mesh) const
{
  const auto& content = this->Content();
  const auto chunk = this->Chunks[index];
  const auto& info = content.Mesh.Chunks[chunk].Info;
  const auto& target = job.Target;
  const bool keepsPoints = (content.Meta.Keep & KeepPoints) != 0;
  const bool keepsCells = (content.Meta.Keep & KeepCells) != 0;

  mesh.MakeContext(false);
  const auto& ownIds = mesh.Context.OwnIds;
  const auto tets = mesh.Walk.Parents.size();
  std::vector<std::uint64_t> pointIds = keepsPoints && (job.RestorePoints || target.GlobalPointIds)
    ? this->DecodePointOrder(mesh, chunk)
    : Count(info.FirstPoint, ownIds.size());
  std::vector<std::uint64_t> cellIds = keepsCells && (job.RestoreCells || target.GlobalCellIds)
    ? this->DecodeCellOrder(mesh, chunk)
    : Count(info.FirstTet, tets);
  const auto pointPlaces =
    job.RestorePoints ? pointIds : Count(this->FirstOwn[index], ownIds.size());
  const auto cellPlaces = job.RestoreCells ? cellIds : Count(this->FirstTet[index], tets);

  for (std::size_t own = 0; own < ownIds.size(); ++own)
  {
    const auto place = pointPlaces[own];
    job.TakePoint(place);
    if (target.Points)
    {
      job.StorePoint(content.Domains, mesh.Keys[ownIds[own]], place);
    }
    if (target.GlobalPointIds)
    {
      target.GlobalPointIds[place] = static_cast<std::int64_t>(pointIds[own]);
    }
    if (target.PointGhosts)
    {
      target.PointGhosts[place] = 0;
    }
  }
  for (std::size_t t = 0; t < tets; ++t)
  {
    job.TakeCell(cellPlaces[t]);
    if (target.GlobalCellIds)
    {
      target.GlobalCellIds[cellPlaces[t]] = static_cast<std::int64_t>(cellIds[t]);
    }
    if (target.CellGhosts)
    {
      target.CellGhosts[cellPlaces[t]] = 0;
    }
  }
  if (target.Connectivity)
  {
    this->StoreConnectivity(job, index, mesh, pointPlaces, cellPlaces);
  }
  for (std::size_t a = 0; a < target.Arrays.size(); ++a)
  {
    const auto array = job.Arrays[a];
    const auto& description = content.Meta.Arrays[array];
    const auto& keys = this->States[index].Arrays[array];
    if (description.Where == Association::Point)
    {
      job.StoreTuples(
        a, description, keys, ownIds.size(), [&](std::size_t own) { return ownIds[own]; },
        [&](std::size_t own) { return pointPlaces[own]; });
    }
    else
    {
      job.StoreTuples(
        a, description, keys, tets, [](std::size_t t) { return t; },
        [&](std::size_t t) { return cellPlaces[t]; });
    }
  }
}

void ChunkSetDecoder::StoreConnectivity(const Job& job, std::size_t index, const ChunkMesh& mesh,
  const std::vector<std::uint64_t>& pointPlaces, const std::vector<std::uint64_t>& cellPlaces) const
{
  const auto& content = this->Content();
  const auto chunk = this->Chunks[index];
  std::vector<std::uint64_t> ids(mesh.Keys.size());
  for (std::size_t own = 0; own < pointPlaces.size(); ++own)
  {
    ids[mesh.Context.OwnIds[own]] = pointPlaces[own];
  }
  std::vector<std::uint64_t> sharedPlaces;
  for (const auto& part : content.Mesh.Chunks[chunk].Shared)
  {
    const auto count = content.Mesh.Blocks[part.Block].Groups[part.Group].Points;
    const auto start = this->GroupStart[part.Block][part.Group];
    for (std::uint64_t i = 0; i < count; ++i)
    {
      sharedPlaces.push_back(
        job.RestorePoints ? this->Blocks[part.Block].Order[part.FirstInBlock + i] : start + i);
    }
  }
  for (std::size_t v = 0; v < ids.size(); ++v)
  {
    const auto source = mesh.Walk.Sources[v];
    if (source & Topology::SharedFlag)
    {
      ids[v] = sharedPlaces[source & ~Topology::SharedFlag];
    }
  }
  std::vector<Key> rotations;
  if (job.RestoreCorners)
  {
    rotations = this->DecodeCellIntegers(content.Mesh.Chunks[chunk].Corners,
      Name("the corners of chunk", chunk), mesh, ScalarType::UInt8, 12);
  }
  const auto store = [&](auto* connectivity)
  {
    using Id = std::remove_pointer_t<decltype(connectivity)>;
    for (std::size_t t = 0; t < mesh.Walk.Tets.size(); ++t)
    {
      const auto tet = rotations.empty()
        ? mesh.Walk.Tets[t]
        : RotateCorners(mesh.Walk.Tets[t], static_cast<unsigned>(rotations[t]));
      for (unsigned i = 0; i < 4; ++i)
      {
        connectivity[4 * cellPlaces[t] + i] = static_cast<Id>(ids[tet[i]]);
      }
    }
  };
  if (job.Target.WideIds)
  {
    store(static_cast<std::int64_t*>(job.Target.Connectivity));
  }
  else
  {
    store(static_cast<std::int32_t*>(job.Target.Connectivity));
  }
}
}
