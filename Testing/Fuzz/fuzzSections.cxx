// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

// Files that are wrong inside of right checksums: libFuzzer's mutations are applied to tables and
// streams, and the file is put together again.

#include "fuzzFiles.h"
#include "fuzzInput.h"
#include "gatunExtents.h"
#include "gatunTreeSample.h"

#include <array>
#include <memory>
#include <random>

// Only libFuzzer's programs have it.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most)
  __attribute__((weak));
extern "C" std::size_t LLVMFuzzerCustomMutator(
  std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed);

namespace
{
using namespace gatun;
using Image = gatun::test::FileImage;

void Mutate(Bytes& bytes, std::size_t room)
{
  const auto size = bytes.size();
  bytes.resize(size + room);
  bytes.resize(LLVMFuzzerMutate(bytes.data(), size, bytes.size()));
}

std::vector<StreamRef*> GetStreams(Image& image)
{
  std::vector<StreamRef*> all;
  image.EachStream(
    [&](StreamRef& stream)
    {
      if (stream.Length > 0)
      {
        all.push_back(&stream);
      }
    });
  return all;
}

/** Changes counts in such a way that the sums which the reader checks still hold. */
void ChangeCounts(Image& image, std::minstd_rand& random)
{
  auto& chunks = image.Mesh.Chunks;
  if (chunks.empty())
  {
    return;
  }
  auto& info = chunks[random() % chunks.size()].Info;
  const auto change = [&](std::uint64_t& count, std::uint64_t& sum)
  {
    const auto now = random() % 2 ? count + random() % 3 - 1 : random() % 300;
    sum += now - count;
    count = now;
  };
  switch (random() % 5)
  {
    case 0:
      change(info.Tets, image.Meta.Tets);
      break;
    case 1:
      change(info.OwnPoints, image.Meta.Points);
      break;
    case 2:
      if (!image.Mesh.Blocks.empty())
      {
        auto& block = image.Mesh.Blocks[random() % image.Mesh.Blocks.size()];
        auto& group = block.Groups[random() % block.Groups.size()];
        std::uint64_t points = group.Points;
        change(points, image.Meta.Points);
        group.Points = static_cast<std::uint32_t>(points);
      }
      break;
    case 3:
      change(image.Meta.UnusedPoints, image.Meta.Points);
      break;
    default:
    {
      // NaN is refused by the table; all else is not.
      const std::array<double, 6> bounds{ 0, -1e308, 1e308, HUGE_VAL, -HUGE_VAL, 1e-310 };
      auto& range = info.Box[random() % 3];
      (random() % 2 ? range.Min : range.Max) = bounds[random() % bounds.size()];
      break;
    }
  }
}

/** Changes the description of an array or of the mesh. */
void ChangeMeta(Image& image, std::minstd_rand& random)
{
  auto& meta = image.Meta;
  if (random() % 3 == 0 || meta.Arrays.empty())
  {
    meta.Keep = static_cast<std::uint8_t>(random() % 8);
    meta.CoordinateType = random() % 2 ? ScalarType::Float32 : ScalarType::Float64;
    meta.HasTime = random() % 2;
    return;
  }
  auto& array = meta.Arrays[random() % meta.Arrays.size()];
  array.Type = static_cast<ScalarType>(1 + random() % 10);
}

void ChangeSteps(Image& image, std::minstd_rand& random)
{
  if (image.Steps.empty())
  {
    return;
  }
  auto& step = image.Steps[random() % image.Steps.size()];
  if (random() % 2 || step.Arrays.empty())
  {
    step.Key = !step.Key;
    return;
  }
  auto& array = step.Arrays[random() % step.Arrays.size()];
  auto& palette = array.Palettes[random() % array.Palettes.size()];
  palette.Count = palette.Count == 0 ? 1 + random() % 8 : random() % 2 ? 0 : palette.Count - 1;
  if (palette.Count > 0 && palette.Stream.Length == 0)
  {
    palette.Stream = *GetStreams(image).front();
  }
}

/** What a file tells of its merges, as it stands there. */
class TreeParts
{
public:
  explicit TreeParts(const InputFile& file)
  {
    const auto read = [&](FourCC name)
    {
      std::vector<Bytes> payloads;
      for (const auto& section : file.FindSections(name))
      {
        payloads.push_back(file.Read(section, "a section"));
      }
      return payloads;
    };
    this->Trees = read(SectionTree);
    for (const auto name : { SectionMerges, SectionDependencies })
    {
      for (const auto& section : file.FindSections(name))
      {
        this->Places.push_back(section);
        this->Streams.push_back(file.Read(section, "a section"));
      }
    }
    this->Steps = read(SectionTreeStep);
    this->Levels = read(SectionLevel);
  }

  bool IsEmpty() const { return this->Trees.empty(); }

  void Change(const Image& image, std::minstd_rand& random);

  /** Makes them sections of the image, behind all others. */
  void AddTo(Image& image) const
  {
    if (this->IsEmpty())
    {
      return;
    }
    // The first of them begins where the directory would.
    const auto before = image.Build();
    std::uint64_t offset = 0;
    std::memcpy(&offset, before.data() + before.size() - TrailerSize, sizeof(offset));
    auto trees = this->Trees;
    Bytes streams;
    try
    {
      auto tree = TreeTable::Read(trees[0], image.Meta, image.Mesh.Chunks.size());
      for (TreePart& part : tree.Parts)
      {
        for (StreamRef* where : { &part.Merges, &part.Map, &part.Dependencies })
        {
          const auto stream = this->FindStream(*where);
          *where = { offset + streams.size(), stream.size(), Checksum(stream) };
          streams.insert(streams.end(), stream.begin(), stream.end());
        }
      }
      trees[0] = tree.Write();
    }
    catch (const Error&)
    {
      // Then it stays as it is.
    }
    const auto add = [&](FourCC name, const std::vector<Bytes>& payloads)
    {
      for (const Bytes& payload : payloads)
      {
        image.MoreSections.push_back({ name, payload, SectionVersion, 0 });
      }
    };
    add(SectionMerges, { streams });
    add(SectionTree, trees);
    add(SectionTreeStep, this->Steps);
    add(SectionLevel, this->Levels);
  }

private:
  /** A stream of the file with the changes of its section. Empty if it is in none. */
  Bytes FindStream(const StreamRef& where) const
  {
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      const auto first = where.Offset - this->Places[i].Offset;
      if (where.Offset >= this->Places[i].Offset && first < this->Streams[i].size())
      {
        const auto begin = this->Streams[i].begin() + static_cast<std::ptrdiff_t>(first);
        const auto length = std::min<std::uint64_t>(where.Length, this->Streams[i].size() - first);
        return { begin, begin + static_cast<std::ptrdiff_t>(length) };
      }
    }
    return {};
  }

  std::vector<Bytes> Trees, Streams, Steps, Levels;
  std::vector<StreamRef> Places; // of the streams' sections
};

/** A file with a change. Throws Error if its tables cannot be read. */
Bytes ChangeFile(std::span<const std::uint8_t> bytes, std::minstd_rand& random);

void ChangeEmbedded(Bytes& file, std::minstd_rand& random)
{
  try
  {
    file = ChangeFile(file, random);
  }
  catch (const Error&)
  {
    Mutate(file, 4);
  }
}

void MutatePacked(Bytes& packed)
{
  try
  {
    auto content = Decompress(packed, 1 << 20);
    Mutate(content, 16);
    packed = test::Store(content);
  }
  catch (const Error&)
  {
    Mutate(packed, 4);
  }
}

void TreeParts::Change(const Image& image, std::minstd_rand& random)
{
  const auto pick = [&](std::vector<Bytes>& list) -> Bytes&
  { return list[random() % list.size()]; };
  switch (random() % 8)
  {
    case 0:
      MutatePacked(this->Trees[0]);
      break;
    case 1:
      if (!this->Steps.empty())
      {
        MutatePacked(pick(this->Steps));
      }
      break;
    case 2:
      try
      {
        auto tree = TreeTable::Read(this->Trees[0], image.Meta, image.Mesh.Chunks.size());
        const auto add = static_cast<std::uint32_t>(random() % 3) - 1;
        tree.Merges += add;
        if (!tree.MergeCounts.empty())
        {
          tree.MergeCounts.back() += add;
        }
        if (!tree.Levels.empty() && random() % 2)
        {
          tree.Levels[random() % tree.Levels.size()] +=
            static_cast<std::uint32_t>(random() % 3) - 1;
        }
        this->Trees[0] = tree.Write();
      }
      catch (const Error&)
      {
        MutatePacked(this->Trees[0]);
      }
      break;
    case 3:
    case 4:
      if (!this->Levels.empty())
      {
        auto& level = pick(this->Levels);
        ChangeEmbedded(level, random);
      }
      break;
    case 5:
      if (!this->Levels.empty())
      {
        pick(this->Levels) = pick(this->Levels);
      }
      break;
    default:
      if (!this->Streams.empty())
      {
        Mutate(pick(this->Streams), 4);
      }
      break;
  }
}

/** Changes the bytes of a table that Image::ChangeTable gets. */
void MutateTable(Image& image, FourCC name, std::size_t number)
{
  image.ChangeTable = [=](FourCC which, std::size_t place, Bytes& table)
  {
    if (which == name && place == number)
    {
      Mutate(table, 16);
    }
  };
}

void Change(Image& image, std::minstd_rand& random)
{
  const auto streams = GetStreams(image);
  switch (random() % 12)
  {
    case 0:
      MutateTable(image, SectionMeta, 0);
      break;
    case 1:
      MutateTable(image, random() % 4 == 0 ? SectionTable : SectionPages, random() % 2);
      break;
    case 2:
      if (!image.Steps.empty())
      {
        const auto step = random() % image.Steps.size();
        MutateTable(image, random() % 2 == 0 ? SectionStep : SectionPages, step);
      }
      break;
    case 3:
      ChangeCounts(image, random);
      break;
    case 4:
      ChangeMeta(image, random);
      break;
    case 5:
      ChangeSteps(image, random);
      break;
    case 6:
      if (!streams.empty())
      {
        *streams[random() % streams.size()] = *streams[random() % streams.size()];
      }
      break;
    default:
      if (!streams.empty())
      {
        auto& stream = *streams[random() % streams.size()];
        auto bytes = image.Of(stream);
        Mutate(bytes, random() % 4 == 0 ? 64 : 4);
        image.Of(stream) = bytes;
        stream.Length = bytes.size();
      }
      break;
  }
}

/** The file of a mesh of a series, which may have bytes in common with the file that it is in. */
Bytes PutTogether(std::span<const std::uint8_t> whole, const StreamRef& section)
{
  const auto list = ExtentMap::FindList(whole.subspan(section.Offset, section.Length), section);
  if (list.Length == 0)
  {
    const auto end = section.Offset + section.Length;
    const auto all = whole.subspan(list.Offset, end - list.Offset);
    return { all.begin(), all.end() };
  }
  const ExtentMap map(whole.subspan(list.Offset, list.Length), list, section);
  Bytes file;
  while (file.size() < map.GetSize())
  {
    const auto place = map.Find(file.size());
    const auto run = whole.subspan(place.Offset, place.Length);
    file.insert(file.end(), run.begin(), run.end());
  }
  return file;
}

/** Sections that an image leaves out: layers, marks of surfaces, boundaries, meshes and times of a
 * series, and cells that die. */
class OtherParts
{
public:
  OtherParts(const InputFile& file, std::span<const std::uint8_t> whole)
  {
    constexpr std::array names{ SectionLayers, SectionSurface, SectionBoundary, SectionGrid,
      SectionTime, SectionLive };
    for (const auto& section : file.GetSections())
    {
      if (section.Name == SectionGrid)
      {
        // What is before the section moves, and fuzzSeries.cxx has the list of runs.
        file.Read(section.Payload, "a section");
        this->Sections.push_back(
          { SectionGrid, PutTogether(whole, section.Payload), SectionVersion, FlagMandatory });
      }
      else if (std::find(names.begin(), names.end(), section.Name) != names.end())
      {
        this->Sections.push_back({ section.Name, file.Read(section.Payload, "a section"),
          section.Version, section.Flags });
      }
    }
  }

  bool IsEmpty() const { return this->Sections.empty(); }

  void Change(std::minstd_rand& random)
  {
    const auto at = random() % this->Sections.size();
    auto& section = this->Sections[at];
    if (random() % 16 == 0)
    {
      section.Payload = this->Sections[random() % this->Sections.size()].Payload;
    }
    else if (section.Name == SectionBoundary || section.Name == SectionGrid)
    {
      ChangeEmbedded(section.Payload, random);
    }
    else
    {
      MutatePacked(section.Payload);
    }
  }

  /** Makes them sections of the image, behind all others. */
  void AddTo(Image& image) const
  {
    for (auto section : this->Sections)
    {
      if (section.Name == SectionGrid)
      {
        const Bytes noList = WriteExtents({});
        section.Payload.insert(section.Payload.begin(), noList.begin(), noList.end());
      }
      image.MoreSections.push_back(std::move(section));
    }
  }

private:
  std::vector<Image::Section> Sections;
};

Bytes ChangeFile(std::span<const std::uint8_t> bytes, std::minstd_rand& random)
{
  const InputFile file(std::make_shared<const MemorySource>(bytes), fuzz::FileName);
  Image image(file);
  TreeParts tree(file);
  OtherParts others(file, bytes);
  if (!others.IsEmpty() && random() % 2)
  {
    others.Change(random);
  }
  else if (!tree.IsEmpty() && random() % 2)
  {
    tree.Change(image, random);
  }
  else
  {
    Change(image, random);
  }
  tree.AddTo(image);
  others.AddTo(image);
  return image.Build();
}
}

std::size_t LLVMFuzzerCustomMutator(
  std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed)
{
  std::minstd_rand random(seed + 1);
  try
  {
    const auto changed = ChangeFile({ data, size }, random);
    if (changed.size() <= most)
    {
      std::copy(changed.begin(), changed.end(), data);
      return changed.size();
    }
    return size;
  }
  catch (const Error&)
  {
    // Its tables cannot be read, so there is nothing to put together again.
    return LLVMFuzzerMutate(data, size, most);
  }
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::UseOneThread();
  fuzz::DecodeFile({ data, size });
  return 0;
}
