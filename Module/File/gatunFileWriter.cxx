// SPDX-License-Identifier: BSD-3-Clause
#include "gatunFileWriter.h"

#include "gatunArrayCodec.h"
#include "gatunBaseMesh.h"
#include "gatunChunkCodec.h"
#include "gatunFloatEnvironment.h"
#include "gatunLayerPartition.h"
#include "gatunLayerTable.h"
#include "gatunMergeCodec.h"
#include "gatunPalette.h"
#include "gatunParallel.h"
#include "gatunPartition.h"
#include "gatunTables.h"
#include "gatunTreeLayout.h"
#include "gatunTreeTable.h"
#include "gatunVersion.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace gatun
{
namespace
{
// Chunks encoded before their streams are written; bounds memory and keeps threads busy.
constexpr std::size_t ChunksPerBatch = 32;

constexpr std::uint64_t LargeMesh = 10'000'000;

// Base meshes that are smaller gain nothing.
constexpr std::uint64_t SmallLevel = 20'000;

/** What later steps need of a chunk: everything that its arrays are predicted from. */
struct ChunkState
{
  ChunkMesh Mesh;                     // without its tetrahedra
  std::vector<std::uint32_t> PointOf; // of each vertex of the walk, the input's point
  std::vector<std::uint32_t> TetOf;   // of each tetrahedron of the walk, the input's
};

/** The streams of one batch, appended one after the other. */
class StreamBatch
{
public:
  /** Where the stream is; its offset is made absolute by Resolve. */
  void Add(const Bytes& bytes, StreamRef& where)
  {
    where = { this->Payload.Data.size(), bytes.size(), Checksum(bytes) };
    this->Payload.PutBytes(bytes);
    this->Added.push_back(&where);
  }

  void Write(OutputFile& file, FourCC name, std::uint16_t flags = FlagMandatory)
  {
    if (this->Added.empty())
    {
      return;
    }
    const auto offset = file.AddSection(name, this->Payload.Data, flags);
    for (auto* where : this->Added)
    {
      where->Offset += offset;
    }
    this->Added.clear();
    this->Payload.Data.clear();
  }

private:
  ByteWriter Payload;
  std::vector<StreamRef*> Added;
};

/** One array of one step: its values and how they become keys. */
struct ArrayInput
{
  const ArrayDescription* Description = nullptr;
  const std::uint8_t* Now = nullptr;
  const std::uint8_t* Before = nullptr;
  std::vector<Domain> Domains;

  const std::uint8_t* At(const std::uint8_t* values, std::size_t tuple, std::size_t component) const
  {
    return values +
      (tuple * this->Description->Components + component) * SizeOf(this->Description->Type);
  }

  /** Keys of the tuples that tupleOf lists. */
  std::vector<ComponentKeys> GetKeys(std::span<const std::uint32_t> tupleOf) const
  {
    std::vector<ComponentKeys> keys(this->Domains.size());
    for (std::size_t c = 0; c < keys.size(); ++c)
    {
      keys[c].Now.resize(tupleOf.size());
      for (std::size_t i = 0; i < tupleOf.size(); ++i)
      {
        keys[c].Now[i] = this->Domains[c].Read(this->At(this->Now, tupleOf[i], c));
      }
      if (this->Before)
      {
        keys[c].Before.resize(tupleOf.size());
        for (std::size_t i = 0; i < tupleOf.size(); ++i)
        {
          keys[c].Before[i] = this->Domains[c].Read(this->At(this->Before, tupleOf[i], c));
        }
      }
    }
    return keys;
  }

  double GetNumber(std::size_t tuple, std::size_t component) const
  {
    const auto type = this->Description->Type;
    return Domain::PlainToNumber(
      type, Domain::ReadPlain(type, this->At(this->Now, tuple, component)));
  }

  double GetLength(std::size_t tuple) const
  {
    double square = 0;
    for (std::size_t c = 0; c < this->Description->Components; ++c)
    {
      const double value = this->GetNumber(tuple, c);
      square += value * value;
    }
    return std::sqrt(square);
  }

  void Extend(ArrayRanges& ranges, std::span<const std::uint32_t> tupleOf) const
  {
    const auto extend = [](Range& range, double value)
    {
      // The comparisons leave out what is not a number.
      range.Min = value < range.Min ? value : range.Min;
      range.Max = value > range.Max ? value : range.Max;
    };
    const auto components = this->Description->Components;
    for (const auto tuple : tupleOf)
    {
      for (std::uint32_t c = 0; c < components; ++c)
      {
        extend(ranges[c], this->GetNumber(tuple, c));
      }
      if (components > 1)
      {
        extend(ranges[components], this->GetLength(tuple));
      }
    }
  }
};

void Extend(ArrayRanges& all, const ArrayRanges& part)
{
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i].Min = std::min(all[i].Min, part[i].Min);
    all[i].Max = std::max(all[i].Max, part[i].Max);
  }
}

void CheckLayers(
  const MeshInput& mesh, const std::vector<ArrayDescription>& arrays, const LayerRequest& layers)
{
  const auto refuse = [](const std::string& what) { throw Error(ErrorCode::InvalidInput, what); };
  if (layers.Array >= arrays.size())
  {
    refuse("the array that layers are to be made of is not there");
  }
  const auto& array = arrays[layers.Array];
  if (array.Where != Association::Point)
  {
    refuse("layers need a point array, and '" + array.Name + "' is one of cells");
  }
  if (layers.Component >= GetRangeCount(array.Components))
  {
    refuse("array '" + array.Name + "' has no component " + std::to_string(layers.Component) +
      " to make layers of");
  }
  if (layers.Count > MaxLayers)
  {
    refuse("there must be from 1 to " + std::to_string(MaxLayers) + " layers, not " +
      std::to_string(layers.Count));
  }
  if (layers.Spacing < LayerSpacing::Uniform || layers.Spacing > LayerSpacing::Histogram)
  {
    refuse("the spacing of the layers is unknown");
  }
  if (mesh.Points > 0 && !layers.Values)
  {
    refuse("layers need the values of array '" + array.Name + "'");
  }
}

void CheckInput(
  const MeshInput& mesh, const std::vector<ArrayDescription>& arrays, const WriterOptions& options)
{
  const auto refuse = [](const std::string& what) { throw Error(ErrorCode::InvalidInput, what); };
  if (!IsFloating(mesh.CoordinateType))
  {
    refuse("coordinates must be float or double");
  }
  if ((mesh.Points > 0 && !mesh.Coordinates) || (mesh.Tets > 0 && !mesh.Connectivity))
  {
    refuse("the mesh has no coordinates or no connectivity");
  }
  if (options.ChunkTets != 0 && (options.ChunkTets < 64 || options.ChunkTets > MaxChunkTets))
  {
    refuse("a chunk must have from 64 to " + std::to_string(MaxChunkTets) + " tetrahedra, not " +
      std::to_string(options.ChunkTets));
  }
  if (options.KeyStepInterval < 1)
  {
    refuse("the interval of key steps must be at least 1");
  }
  if (options.Keep > KeepAll)
  {
    refuse("the order to keep is unknown");
  }
  if (options.Tree && options.Tree->GetNumberOfPoints() != mesh.Points)
  {
    refuse("the tree of merges is not that of the mesh");
  }
  if (options.Levels > 0 && !options.Tree)
  {
    refuse("base meshes need a tree of merges");
  }
  if (options.Layers)
  {
    CheckLayers(mesh, arrays, *options.Layers);
  }
  for (const auto& array : arrays)
  {
    if (array.Components < 1 || array.Components > 65536)
    {
      refuse("array '" + array.Name + "' must have from 1 to 65536 components");
    }
  }
}
}

//--------------------------------------------------------------------------------------------------
class FileWriter::Internals
{
public:
  Internals(const std::string& path, const MeshInput& mesh,
    const std::vector<ArrayDescription>& arrays, const WriterOptions& options)
    : Mesh(mesh)
    , Options(options)
    , File(path, options.ReplaceReadOnly, GetMinorVersion(options))
  {
    this->Describe(arrays);
  }

  /** A base mesh of another writer's file. */
  Internals(const Internals& whole, const MeshInput& mesh, const WriterOptions& options)
    : Mesh(mesh)
    , Options(options)
    , File(whole.File, GetMinorVersion(options))
  {
    this->Describe(whole.Meta.Arrays);
  }

  void WriteMesh(const Progress& progress);
  void WriteStep(std::span<const void* const> values, const FieldData& field, bool hasTime,
    double time, const Progress& progress);
  FileStatistics Finish();

private:
  static std::uint16_t GetMinorVersion(const WriterOptions& options)
  {
    return options.Layers ? MinorVersionWithLayers
      : options.Tree      ? MinorVersionWithTree
                          : MinorVersionPlain;
  }

  void Describe(const std::vector<ArrayDescription>& arrays)
  {
    const MeshInput& mesh = this->Mesh.GetMesh();
    const WriterOptions& options = this->Options;
    this->Meta.WriterVersion = PackageVersion();
    this->Meta.Points = mesh.Points;
    this->Meta.Tets = mesh.Tets;
    this->Meta.CoordinateType = mesh.CoordinateType;
    this->Meta.WideIds = mesh.WideIds;
    this->Meta.Keep = options.Keep;
    // With layers, an isosurface is in few chunks: smaller ones share out better among threads.
    this->Meta.ChunkTets = options.ChunkTets != 0
      ? options.ChunkTets
      : (mesh.Tets > LargeMesh ? 262144u : 65536u) / (options.Layers ? 2 : 1);
    this->Meta.KeyStepInterval = options.KeyStepInterval;
    this->Meta.Arrays = arrays;
    this->Statistics.ArrayBytes.resize(arrays.size());
  }

  std::vector<PointKeys> GetPointKeys(std::span<const std::uint32_t> points) const;
  std::vector<std::uint32_t> GetSharedPoints(std::size_t chunk) const;
  ChunkFrame MakeFrame(std::size_t chunk, std::span<const std::uint32_t> shared) const;

  struct ChunkStreams
  {
    Bytes Connectivity, Geometry, PointOrder, CellOrder, Corners;
  };
  ChunkStreams EncodeMeshChunk(std::size_t chunk);
  void WriteBlock(BlockEntry& block, std::span<const std::uint32_t> points, StreamBatch& batch);

  void WriteBlockValues(const std::vector<ArrayInput>& inputs, StepTable& step);
  void WriteChunkValues(
    const std::vector<ArrayInput>& inputs, StepTable& step, const Progress& progress);
  void KeepForNextStep(std::span<const void* const> values);

  // How the mesh becomes simpler, and what it becomes.
  struct Level
  {
    BaseMesh Mesh;
    WriterOptions Options;
    std::unique_ptr<Internals> File;
  };
  void WriteTree();
  void WriteTreeStep(const std::vector<ArrayInput>& inputs);
  void BeginLevels(const Progress& progress);
  void WriteLevelSteps(std::span<const void* const> values, bool hasTime, double time);
  std::vector<std::uint32_t> GetPointOrder() const;
  void CheckLayers(const StepTable& step) const;
  void WriteTables();

  std::span<const std::uint32_t> GetBlockPoints(std::size_t block) const
  {
    const auto& entry = this->Table.Blocks[block];
    return std::span(this->Parts.SharedPoints)
      .subspan(static_cast<std::size_t>(entry.FirstPoint), static_cast<std::size_t>(entry.Points));
  }

  std::size_t GetTupleCount(const ArrayDescription& array) const
  {
    return static_cast<std::size_t>(
      array.Where == Association::Point ? this->Meta.Points : this->Meta.Tets);
  }

  const MeshAccess Mesh;
  const WriterOptions Options;
  OutputFile File;
  MetaTable Meta;
  MeshTable Table;
  Partition Parts;
  PointDomain Domains;
  std::vector<ChunkState> Chunks;
  std::optional<LayerPartition> Layers;
  std::optional<TreeLayout> Layout;
  TreeTable Tree;
  std::vector<std::unique_ptr<Level>> Levels;
  FileStatistics Statistics;

  std::size_t Steps = 0;
  double LastTime = 0;
  Bytes LastField;
  StreamRef LastFieldRef;
  std::vector<Bytes> Before;       // values of the step before
  std::vector<bool> BeforeIsPlain; // whether that step had no palette
};

std::vector<PointKeys> FileWriter::Internals::GetPointKeys(
  std::span<const std::uint32_t> points) const
{
  const auto& input = this->Mesh.GetMesh();
  const auto size = SizeOf(input.CoordinateType);
  const auto* values = static_cast<const std::uint8_t*>(input.Coordinates);
  std::vector<PointKeys> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      keys[i][axis] =
        this->Domains[axis].Read(values + (std::size_t{ 3 } * points[i] + axis) * size);
    }
  }
  return keys;
}

std::vector<std::uint32_t> FileWriter::Internals::GetSharedPoints(std::size_t chunk) const
{
  std::vector<std::uint32_t> points;
  for (const auto& part : this->Table.Chunks[chunk].Shared)
  {
    const auto& group = this->Table.Blocks[part.Block].Groups[part.Group];
    const auto block = this->GetBlockPoints(part.Block);
    const auto begin = block.begin() + static_cast<std::ptrdiff_t>(part.FirstInBlock);
    points.insert(points.end(), begin, begin + group.Points);
  }
  return points;
}

ChunkFrame FileWriter::Internals::MakeFrame(
  std::size_t chunk, std::span<const std::uint32_t> shared) const
{
  const auto& entry = this->Table.Chunks[chunk];
  ChunkFrame frame;
  frame.Tets = static_cast<std::uint32_t>(entry.Info.Tets);
  frame.OwnPoints = static_cast<std::uint32_t>(entry.Info.OwnPoints);
  frame.Box = entry.Info.Box;
  frame.Domains = this->Domains;
  frame.SharedKeys = this->GetPointKeys(shared);
  frame.SharedUsers = this->Table.GetSharedUsers(chunk);
  return frame;
}

FileWriter::Internals::ChunkStreams FileWriter::Internals::EncodeMeshChunk(std::size_t chunk)
{
  const FloatEnvironment guard;
  const auto shared = this->GetSharedPoints(chunk);
  const auto begin = this->Parts.ChunkStart[chunk];
  const auto end = this->Parts.ChunkStart[chunk + 1];

  // Local ids: shared points as the frame lists them, then own ones in the input's order.
  std::vector<std::uint32_t> own;
  for (auto t = begin; t < end; ++t)
  {
    for (unsigned i = 0; i < 4; ++i)
    {
      const auto p = static_cast<std::uint32_t>(this->Mesh.GetId(this->Parts.Tets[t], i));
      if (this->Parts.SharedIndex[p] == Partition::OwnPoint)
      {
        own.push_back(p);
      }
    }
  }
  std::sort(own.begin(), own.end());
  own.erase(std::unique(own.begin(), own.end()), own.end());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sharedIds(shared.size());
  for (std::uint32_t i = 0; i < shared.size(); ++i)
  {
    sharedIds[i] = { shared[i], i };
  }
  std::sort(sharedIds.begin(), sharedIds.end());
  const auto toLocal = [&](std::uint32_t p)
  {
    if (this->Parts.SharedIndex[p] == Partition::OwnPoint)
    {
      return static_cast<std::uint32_t>(std::lower_bound(own.begin(), own.end(), p) - own.begin() +
        static_cast<std::ptrdiff_t>(shared.size()));
    }
    return std::lower_bound(
      sharedIds.begin(), sharedIds.end(), std::pair<std::uint32_t, std::uint32_t>{ p, 0 })
      ->second;
  };
  std::vector<std::array<std::uint32_t, 4>> tets(end - begin);
  for (auto t = begin; t < end; ++t)
  {
    for (unsigned i = 0; i < 4; ++i)
    {
      tets[t - begin][i] =
        toLocal(static_cast<std::uint32_t>(this->Mesh.GetId(this->Parts.Tets[t], i)));
    }
  }

  auto& info = this->Table.Chunks[chunk].Info;
  info.OwnPoints = own.size();
  for (const auto* list : { static_cast<const std::vector<std::uint32_t>*>(&shared),
         static_cast<const std::vector<std::uint32_t>*>(&own) })
  {
    for (const auto p : *list)
    {
      this->Mesh.Extend(info.Box, p);
    }
  }
  auto encoded = EncodeChunk(this->MakeFrame(chunk, shared), tets, this->GetPointKeys(own));

  auto& state = this->Chunks[chunk];
  state.Mesh = std::move(encoded.Mesh);
  const auto& walk = state.Mesh.Walk;
  state.PointOf.resize(walk.Sources.size());
  for (std::size_t v = 0; v < walk.Sources.size(); ++v)
  {
    const auto source = walk.Sources[v];
    state.PointOf[v] = (source & Topology::SharedFlag) ? shared[source & ~Topology::SharedFlag]
                                                       : own[encoded.OwnOrder[source]];
  }
  state.TetOf.resize(encoded.TetOrder.size());
  for (std::size_t t = 0; t < state.TetOf.size(); ++t)
  {
    state.TetOf[t] = this->Parts.Tets[begin + encoded.TetOrder[t]];
  }

  ChunkStreams streams;
  streams.Connectivity = std::move(encoded.Connectivity);
  streams.Geometry = std::move(encoded.Geometry);
  const Domain ids(ScalarType::UInt32);
  if (this->Options.Keep & KeepPoints)
  {
    state.Mesh.MakeContext(false);
    ComponentKeys keys;
    keys.Now.assign(state.PointOf.begin(), state.PointOf.end());
    streams.PointOrder = EncodePointValues(state.Mesh.Context, { &ids, 1 }, { &keys, 1 });
  }
  if (this->Options.Keep & KeepCells)
  {
    ComponentKeys keys;
    keys.Now.assign(state.TetOf.begin(), state.TetOf.end());
    streams.CellOrder = EncodeCellValues(walk.Parents, { &ids, 1 }, { &keys, 1 });
  }
  if (this->Options.Keep & KeepCorners)
  {
    const Domain rotations(ScalarType::UInt8);
    ComponentKeys keys;
    keys.Now.assign(encoded.Corners.begin(), encoded.Corners.end());
    streams.Corners = EncodeCellValues(walk.Parents, { &rotations, 1 }, { &keys, 1 });
  }
  state.Mesh.Walk.Tets = {};
  return streams;
}

void FileWriter::Internals::WriteBlock(
  BlockEntry& block, std::span<const std::uint32_t> points, StreamBatch& batch)
{
  if (points.empty())
  {
    return;
  }
  const FloatEnvironment guard;
  const auto pointKeys = this->GetPointKeys(points);
  std::vector<ComponentKeys> keys(3);
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    keys[axis].Now.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      keys[axis].Now[i] = pointKeys[i][axis];
    }
  }
  auto geometry = EncodeCellValues({}, this->Domains, keys);
  geometry.resize(std::max<std::size_t>(geometry.size(), points.size() / MaxItemsPerByte + 1), 0);
  batch.Add(geometry, block.Geometry);
  this->Statistics.SharedGeometryBytes += geometry.size();
  if (this->Options.Keep & KeepPoints)
  {
    const Domain ids(ScalarType::UInt32);
    ComponentKeys order;
    order.Now.assign(points.begin(), points.end());
    const auto stream = EncodeCellValues({}, { &ids, 1 }, { &order, 1 });
    batch.Add(stream, block.Order);
    this->Statistics.OrderBytes += stream.size();
  }
}

void FileWriter::Internals::WriteMesh(const Progress& progress)
{
  const auto& input = this->Mesh.GetMesh();
  if (this->Options.Layers)
  {
    this->Layers.emplace();
    this->Layers->Request = *this->Options.Layers;
    this->Layers->Array = this->Meta.Arrays[this->Layers->Request.Array];
  }
  this->Parts = MakePartition(
    this->Mesh, this->Meta.ChunkTets, progress, this->Layers ? &*this->Layers : nullptr);
  this->Meta.UnusedPoints = this->Parts.UnusedPoints.size();
  this->Table.Blocks = std::move(this->Parts.Blocks);
  this->Table.Unused.Points = this->Meta.UnusedPoints;
  this->Table.Chunks.resize(this->Parts.GetChunkCount());
  for (std::size_t c = 0; c < this->Table.Chunks.size(); ++c)
  {
    this->Table.Chunks[c].Info.Tets = this->Parts.ChunkStart[c + 1] - this->Parts.ChunkStart[c];
  }
  try
  {
    this->Table.LinkGroups();
  }
  catch (const Error& error)
  {
    throw Error(ErrorCode::InvalidInput, error.what() + std::string("; make chunks larger"));
  }
  this->Chunks.resize(this->Table.Chunks.size());

  StreamBatch batch;
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    auto palette = FindPalette(
      input.CoordinateType, input.Coordinates, static_cast<std::size_t>(input.Points), 3, axis);
    this->Domains[axis] = Domain(input.CoordinateType, palette);
    if (palette)
    {
      auto& where = this->Table.Palettes[axis];
      where.Count = palette->size();
      const auto stream = EncodePalette(input.CoordinateType, *palette);
      batch.Add(stream, where.Stream);
      this->Statistics.SharedGeometryBytes += stream.size();
    }
  }
  for (std::size_t b = 0; b < this->Table.Blocks.size(); ++b)
  {
    this->WriteBlock(this->Table.Blocks[b], this->GetBlockPoints(b), batch);
  }
  this->WriteBlock(this->Table.Unused, this->Parts.UnusedPoints, batch);
  batch.Write(this->File, SectionMesh);

  const auto chunks = this->Chunks.size();
  for (std::size_t first = 0; first < chunks; first += ChunksPerBatch)
  {
    const auto count = std::min(ChunksPerBatch, chunks - first);
    std::vector<ChunkStreams> streams(count);
    ParallelFor(
      count, [&](std::size_t i) { streams[i] = this->EncodeMeshChunk(first + i); },
      [&](double done)
      {
        return !progress ||
          progress((static_cast<double>(first) + done * static_cast<double>(count)) /
            static_cast<double>(chunks));
      });
    for (std::size_t i = 0; i < count; ++i)
    {
      auto& entry = this->Table.Chunks[first + i];
      const auto& s = streams[i];
      batch.Add(s.Connectivity, entry.Connectivity);
      batch.Add(s.Geometry, entry.Geometry);
      this->Statistics.ConnectivityBytes += s.Connectivity.size();
      this->Statistics.GeometryBytes += s.Geometry.size();
      for (const auto& [bytes, where] : { std::pair(&s.PointOrder, &entry.PointOrder),
             std::pair(&s.CellOrder, &entry.CellOrder), std::pair(&s.Corners, &entry.Corners) })
      {
        if (!bytes->empty())
        {
          batch.Add(*bytes, *where);
          this->Statistics.OrderBytes += bytes->size();
        }
      }
    }
    batch.Write(this->File, SectionMesh);
  }
  for (const auto& chunk : this->Table.Chunks)
  {
    for (unsigned axis = 0; axis < 3; ++axis)
    {
      this->Meta.Box[axis].Min = std::min(this->Meta.Box[axis].Min, chunk.Info.Box[axis].Min);
      this->Meta.Box[axis].Max = std::max(this->Meta.Box[axis].Max, chunk.Info.Box[axis].Max);
    }
  }
  for (const auto p : this->Parts.UnusedPoints)
  {
    this->Mesh.Extend(this->Meta.Box, p);
  }
  this->Parts.Tets = {};
  this->Parts.SharedIndex = {};
  if (this->Options.Tree)
  {
    this->WriteTree();
    this->BeginLevels(progress);
  }
}

//--------------------------------------------------------------------------------------------------
/** Of each point of the file, which one of the input it is. */
std::vector<std::uint32_t> FileWriter::Internals::GetPointOrder() const
{
  auto points = this->Parts.SharedPoints;
  for (std::size_t c = 0; c < this->Chunks.size(); ++c)
  {
    const auto first = points.size();
    points.resize(first + static_cast<std::size_t>(this->Table.Chunks[c].Info.OwnPoints));
    const auto& sources = this->Chunks[c].Mesh.Walk.Sources;
    for (std::size_t v = 0; v < sources.size(); ++v)
    {
      if ((sources[v] & Topology::SharedFlag) == 0)
      {
        points[first + sources[v]] = this->Chunks[c].PointOf[v];
      }
    }
  }
  points.insert(points.end(), this->Parts.UnusedPoints.begin(), this->Parts.UnusedPoints.end());
  return points;
}

void FileWriter::Internals::WriteTree()
{
  this->Layout.emplace(*this->Options.Tree, this->GetPointOrder(), this->Table);
  this->Tree.Merges = static_cast<std::uint32_t>(this->Layout->GetTree().GetMerges().size());
  this->Tree.Rungs = this->Layout->GetRungs();
  this->Tree.Boxes.assign(this->Chunks.size(), std::vector<Bounds>(this->Tree.Rungs.size()));
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const auto ranges = this->Layout->FindRanges(
      [&](std::uint32_t point)
      {
        const double x = this->Mesh.GetCoordinate(point, axis);
        return std::isfinite(x) ? x : std::nan("");
      });
    for (std::size_t c = 0; c < ranges.size(); ++c)
    {
      for (std::size_t rung = 0; rung < ranges[c].size(); ++rung)
      {
        this->Tree.Boxes[c][rung][axis] = ranges[c][rung];
      }
    }
  }
  if (this->Tree.Merges > 0)
  {
    StreamBatch batch;
    const auto used = static_cast<std::uint32_t>(this->Meta.Points - this->Meta.UnusedPoints);
    const auto& merges = this->Layout->GetTree().GetMerges();
    if (std::any_of(merges.begin(), merges.end(),
          [=](const auto& merge) { return merge.Point >= used || merge.Into >= used; }))
    {
      throw Error(ErrorCode::InvalidInput, "the tree merges points that no tetrahedron has");
    }
    const auto stream = EncodeMerges(this->Layout->GetTree(), used);
    batch.Add(stream, this->Tree.Stream);
    this->Statistics.TreeBytes += stream.size();
    batch.Write(this->File, SectionMerges, 0);
  }
}

void FileWriter::Internals::WriteTreeStep(const std::vector<ArrayInput>& inputs)
{
  TreeStepTable step;
  for (const ArrayInput& input : inputs)
  {
    auto& chunks = step.Ranges.emplace_back();
    if (input.Description->Where != Association::Point)
    {
      continue;
    }
    const auto components = input.Description->Components;
    const auto count = GetRangeCount(components);
    chunks.assign(
      this->Chunks.size(), std::vector<ArrayRanges>(this->Tree.Rungs.size(), ArrayRanges(count)));
    for (std::size_t r = 0; r < count; ++r)
    {
      const auto ranges = this->Layout->FindRanges([&](std::uint32_t point)
        { return r < components ? input.GetNumber(point, r) : input.GetLength(point); });
      for (std::size_t c = 0; c < ranges.size(); ++c)
      {
        for (std::size_t rung = 0; rung < ranges[c].size(); ++rung)
        {
          chunks[c][rung][r] = ranges[c][rung];
        }
      }
    }
  }
  const auto bytes = step.Write();
  this->Statistics.TreeBytes += bytes.size();
  this->File.AddSection(SectionTreeStep, bytes, 0);
}

void FileWriter::Internals::BeginLevels(const Progress& progress)
{
  const auto& tree = *this->Options.Tree;
  std::uint64_t tets = this->Meta.Tets;
  std::uint64_t left = this->Meta.Points;
  for (unsigned i = 0; i < this->Options.Levels && tets > SmallLevel; ++i)
  {
    left = (left + 1) / 2;
    const auto merges = static_cast<std::uint32_t>(tree.CountMergesForPoints(left));
    if (merges == 0 || (!this->Tree.Levels.empty() && merges == this->Tree.Levels.back()))
    {
      return;
    }
    auto level =
      std::make_unique<Level>(Level{ BaseMesh(this->Mesh, tree, merges), this->Options, nullptr });
    level->Options.Keep = KeepNone;
    level->Options.Levels = 0;
    level->Options.Tree = &level->Mesh.GetTree();
    Bytes layerValues; // only while the level is made
    if (level->Options.Layers)
    {
      const auto& array = this->Meta.Arrays[level->Options.Layers->Array];
      layerValues = level->Mesh.Gather(
        level->Options.Layers->Values, Association::Point, array.Components * SizeOf(array.Type));
      level->Options.Layers->Values = layerValues.data();
    }
    level->File = std::make_unique<Internals>(*this, level->Mesh.GetInput(), level->Options);
    level->File->WriteMesh([&](double) { return !progress || progress(1); });
    tets = level->File->Meta.Tets;
    this->Tree.Levels.push_back(merges);
    this->Levels.push_back(std::move(level));
  }
}

void FileWriter::Internals::WriteLevelSteps(
  std::span<const void* const> values, bool hasTime, double time)
{
  for (const auto& level : this->Levels)
  {
    std::vector<Bytes> gathered;
    std::vector<const void*> pointers;
    for (std::size_t a = 0; a < values.size(); ++a)
    {
      const auto& array = this->Meta.Arrays[a];
      gathered.push_back(
        level->Mesh.Gather(values[a], array.Where, array.Components * SizeOf(array.Type)));
      pointers.push_back(gathered.back().data());
    }
    level->File->WriteStep(pointers, {}, hasTime, time, {});
  }
}

//--------------------------------------------------------------------------------------------------
void FileWriter::Internals::WriteBlockValues(const std::vector<ArrayInput>& inputs, StepTable& step)
{
  const auto blocks = this->Table.Blocks.size() + 1;
  const auto getPoints = [&](std::size_t b)
  {
    return b + 1 < blocks ? this->GetBlockPoints(b)
                          : std::span<const std::uint32_t>(this->Parts.UnusedPoints);
  };
  std::vector<std::vector<Bytes>> streams(inputs.size(), std::vector<Bytes>(blocks));
  ParallelFor(blocks,
    [&](std::size_t b)
    {
      const FloatEnvironment guard;
      const auto points = getPoints(b);
      for (std::size_t a = 0; a < inputs.size(); ++a)
      {
        if (inputs[a].Description->Where == Association::Point && !points.empty())
        {
          auto keys = inputs[a].GetKeys(points);
          streams[a][b] = EncodeCellValues({}, inputs[a].Domains, keys);
        }
      }
    });
  StreamBatch batch;
  for (std::size_t a = 0; a < inputs.size(); ++a)
  {
    if (inputs[a].Description->Where != Association::Point)
    {
      continue;
    }
    step.Arrays[a].Blocks.resize(blocks);
    for (std::size_t b = 0; b < blocks; ++b)
    {
      if (!streams[a][b].empty())
      {
        batch.Add(streams[a][b], step.Arrays[a].Blocks[b]);
        this->Statistics.ArrayBytes[a] += streams[a][b].size();
      }
    }
    inputs[a].Extend(step.Arrays[a].Ranges, this->Parts.UnusedPoints);
  }
  batch.Write(this->File, SectionValues);
}

void FileWriter::Internals::WriteChunkValues(
  const std::vector<ArrayInput>& inputs, StepTable& step, const Progress& progress)
{
  const auto chunks = this->Chunks.size();
  StreamBatch batch;
  for (std::size_t first = 0; first < chunks; first += ChunksPerBatch)
  {
    const auto count = std::min(ChunksPerBatch, chunks - first);
    std::vector<std::vector<Bytes>> streams(count, std::vector<Bytes>(inputs.size()));
    ParallelFor(
      count,
      [&](std::size_t i)
      {
        const FloatEnvironment guard;
        auto& state = this->Chunks[first + i];
        state.Mesh.MakeContext(true);
        for (std::size_t a = 0; a < inputs.size(); ++a)
        {
          const auto& input = inputs[a];
          const bool ofPoints = input.Description->Where == Association::Point;
          const auto& tuples = ofPoints ? state.PointOf : state.TetOf;
          auto keys = input.GetKeys(tuples);
          streams[i][a] = ofPoints ? EncodePointValues(state.Mesh.Context, input.Domains, keys)
                                   : EncodeCellValues(state.Mesh.Walk.Parents, input.Domains, keys);
          auto& ranges = step.Arrays[a].ChunkRanges[first + i];
          ranges.resize(GetRangeCount(input.Description->Components));
          input.Extend(ranges, tuples);
        }
        state.Mesh.Fit.reset();
        state.Mesh.Context.Fit = nullptr;
      },
      [&](double done)
      {
        return !progress ||
          progress((static_cast<double>(first) + done * static_cast<double>(count)) /
            static_cast<double>(chunks));
      });
    // Array by array, so that a reader of one array reads the batch in one go.
    for (std::size_t a = 0; a < inputs.size(); ++a)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        batch.Add(streams[i][a], step.Arrays[a].Chunks[first + i]);
        this->Statistics.ArrayBytes[a] += streams[i][a].size();
        Extend(step.Arrays[a].Ranges, step.Arrays[a].ChunkRanges[first + i]);
      }
    }
    batch.Write(this->File, SectionValues);
  }
}

void FileWriter::Internals::KeepForNextStep(std::span<const void* const> values)
{
  this->Before.resize(values.size());
  for (std::size_t a = 0; a < values.size(); ++a)
  {
    const auto& array = this->Meta.Arrays[a];
    const auto size = this->GetTupleCount(array) * array.Components * SizeOf(array.Type);
    const auto* begin = static_cast<const std::uint8_t*>(values[a]);
    this->Before[a].assign(begin, begin + size);
  }
}

void FileWriter::Internals::WriteStep(std::span<const void* const> values, const FieldData& field,
  bool hasTime, double time, const Progress& progress)
{
  if (values.size() != this->Meta.Arrays.size())
  {
    throw Error(ErrorCode::InvalidInput, "a step needs the values of every array");
  }
  if (this->Steps > 0 && (!hasTime || !this->Meta.HasTime || !(time > this->LastTime)))
  {
    throw Error(ErrorCode::InvalidInput,
      "the times of the steps must ascend: " + std::to_string(time) + " follows " +
        std::to_string(this->LastTime));
  }
  if (std::isnan(time))
  {
    throw Error(ErrorCode::InvalidInput, "the time of a step is not a number");
  }
  this->Meta.HasTime = hasTime;
  const bool key = this->Steps % this->Options.KeyStepInterval == 0;

  StepTable step;
  step.Time = time;
  step.Key = key;
  step.Arrays.resize(values.size());
  std::vector<ArrayInput> inputs(values.size());
  StreamBatch batch;
  std::vector<bool> isPlain(values.size(), true);
  for (std::size_t a = 0; a < values.size(); ++a)
  {
    const auto& array = this->Meta.Arrays[a];
    auto& input = inputs[a];
    auto& entry = step.Arrays[a];
    const auto tuples = this->GetTupleCount(array);
    if (!values[a] && tuples > 0)
    {
      throw Error(ErrorCode::InvalidInput, "array '" + array.Name + "' has no values");
    }
    input.Description = &array;
    input.Now = static_cast<const std::uint8_t*>(values[a]);
    entry.Ranges.resize(GetRangeCount(array.Components));
    entry.Palettes.resize(array.Components);
    entry.Chunks.resize(this->Chunks.size());
    entry.ChunkRanges.resize(this->Chunks.size());
    for (std::uint32_t c = 0; c < array.Components; ++c)
    {
      auto palette = FindPalette(array.Type, values[a], tuples, array.Components, c);
      input.Domains.emplace_back(array.Type, palette);
      if (palette)
      {
        isPlain[a] = false;
        entry.Palettes[c].Count = palette->size();
        const auto stream = EncodePalette(array.Type, *palette);
        batch.Add(stream, entry.Palettes[c].Stream);
        this->Statistics.ArrayBytes[a] += stream.size();
      }
    }
    if (!key && isPlain[a] && this->BeforeIsPlain[a])
    {
      input.Before = this->Before[a].data();
    }
  }
  if (!field.empty())
  {
    // The same field data for many steps is stored once.
    auto stream = WriteFieldData(field);
    if (stream == this->LastField)
    {
      step.Field = this->LastFieldRef;
    }
    else
    {
      batch.Add(stream, step.Field);
      this->Statistics.FieldDataBytes += stream.size();
      this->LastField = std::move(stream);
    }
  }
  batch.Write(this->File, SectionValues);
  this->WriteBlockValues(inputs, step);
  this->WriteChunkValues(inputs, step, progress);
  if (this->Steps == 0 && this->Layers)
  {
    this->CheckLayers(step);
  }
  this->File.AddSection(SectionStep, step.Write());
  if (this->Layout)
  {
    this->WriteTreeStep(inputs);
    this->WriteLevelSteps(values, hasTime, time);
  }
  if (hasTime)
  {
    this->KeepForNextStep(values);
    this->BeforeIsPlain = isPlain;
  }
  if (!field.empty())
  {
    this->LastFieldRef = step.Field;
  }
  this->LastTime = time;
  ++this->Steps;
}

/** Throws unless the chunks' values at the first step are in the layers that they were made for. */
void FileWriter::Internals::CheckLayers(const StepTable& step) const
{
  const auto& layers = this->Layers->Result;
  const auto& ranges = step.Arrays[layers.Array].ChunkRanges;
  for (std::size_t c = 0; c < ranges.size(); ++c)
  {
    if (!IsInside(layers, layers.Chunks[c], ranges[c][layers.Component]))
    {
      throw Error(ErrorCode::InvalidInput,
        "array '" + this->Layers->Array.Name + "' has other values than the layers were made of");
    }
  }
}

void FileWriter::Internals::WriteTables()
{
  this->File.AddSection(SectionTable, this->Table.Write(this->Options.Keep));
  if (this->Layers)
  {
    this->File.AddSection(SectionLayers, WriteLayers(this->Layers->Result), 0);
  }
  if (this->Layout)
  {
    const auto bytes = this->Tree.Write();
    this->Statistics.TreeBytes += bytes.size();
    this->File.AddSection(SectionTree, bytes, 0);
  }
  this->File.AddSection(SectionMeta, this->Meta.Write());
}

FileStatistics FileWriter::Internals::Finish()
{
  auto& s = this->Statistics;
  for (const auto& level : this->Levels)
  {
    level->File->WriteTables();
    s.LevelBytes += this->File.AddSection(SectionLevel, level->File->File);
  }
  this->WriteTables();
  s.FileBytes = this->File.Commit();
  s.DirectoryBytes = s.FileBytes - s.ConnectivityBytes - s.GeometryBytes - s.SharedGeometryBytes -
    s.OrderBytes - s.FieldDataBytes - s.TreeBytes - s.LevelBytes;
  for (const auto bytes : s.ArrayBytes)
  {
    s.DirectoryBytes -= bytes;
  }
  return s;
}

//--------------------------------------------------------------------------------------------------
FileWriter::FileWriter(const std::string& path, const MeshInput& mesh,
  const std::vector<ArrayDescription>& arrays, const WriterOptions& options,
  const Progress& progress)
{
  CheckInput(mesh, arrays, options);
  this->Self = std::make_unique<Internals>(path, mesh, arrays, options);
  this->Self->WriteMesh(progress);
}

FileWriter::~FileWriter() = default;

void FileWriter::WriteStep(std::span<const void* const> values, const FieldData& field,
  bool hasTime, double time, const Progress& progress)
{
  this->Self->WriteStep(values, field, hasTime, time, progress);
}

FileStatistics FileWriter::Finish()
{
  return this->Self->Finish();
}
}
