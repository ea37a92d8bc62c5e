// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFileImage_h
#define gatunFileImage_h

// A .gtn file taken apart, to be changed and put together again with right checksums.

#include "gatunCompress.h"
#include "gatunInputFile.h"
#include "gatunStepPages.h"
#include "gatunTablePages.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gatun::test
{
/** What Compress makes, but with the bytes as they are, in a frame of raw blocks. */
inline Bytes Store(const Bytes& bytes)
{
  constexpr std::size_t largestBlock = 1u << 17;
  ByteWriter out;
  out.PutVarint(bytes.size());
  out.Put(std::uint32_t{ 0xfd2fb528 });
  out.Put(std::uint8_t{ 0xa0 }); // one segment, its size in four bytes
  out.Put(static_cast<std::uint32_t>(bytes.size()));
  for (std::size_t at = 0;;)
  {
    const auto size = std::min(largestBlock, bytes.size() - at);
    const bool last = at + size == bytes.size();
    const auto header = static_cast<std::uint32_t>((size << 3) | (last ? 1 : 0));
    out.Put(static_cast<std::uint16_t>(header));
    out.Put(static_cast<std::uint8_t>(header >> 16));
    out.PutBytes(std::span(bytes).subspan(at, size));
    at += size;
    if (last)
    {
      return std::move(out.Data);
    }
  }
}

/**
 * The tables of a file and the bytes of its streams. A StreamRef of a table, unless its length is
 * 0, holds in Offset the place of its bytes in Streams; Build makes it what a file has.
 */
class FileImage
{
public:
  struct Section
  {
    FourCC Name = 0;
    Bytes Payload;
    std::uint16_t Version = SectionVersion;
    std::uint16_t Flags = FlagMandatory;
  };

  FileImage() = default;

  /** Throws gatun::Error if the file is damaged. */
  explicit FileImage(const std::string& path)
    : FileImage(InputFile(path))
  {
  }

  explicit FileImage(const InputFile& file)
  {
    const auto read = [&](FourCC name, const char* what)
    { return file.Read(file.FindSection(name, what), what); };
    this->Meta = MetaTable::Read(read(SectionMeta, "META"));
    if (!file.FindSections(SectionCells).empty())
    {
      this->Cells = CellTable::Read(read(SectionCells, "CELL"));
    }
    TablePages tables(file, this->Meta, this->Cells ? &*this->Cells : nullptr);
    for (const auto& section : file.GetSections())
    {
      if (section.Name == SectionStep)
      {
        tables.AddStep(section.Payload, file.Read(section.Payload, "STEP"));
      }
    }
    this->Take(tables);
    this->EachStream(
      [&](StreamRef& stream)
      {
        if (stream.Length > 0)
        {
          this->Streams.push_back(file.Read(stream, "a stream"));
          stream.Offset = this->Streams.size() - 1;
        }
      });
  }

  /** Calls use for every stream that the tables name. */
  template <typename Use>
  void EachStream(Use&& use)
  {
    const auto useBlock = [&](BlockEntry& block)
    {
      use(block.Geometry);
      use(block.Order);
    };
    for (auto& palette : this->Mesh.Palettes)
    {
      use(palette.Stream);
    }
    for (auto& block : this->Mesh.Blocks)
    {
      useBlock(block);
    }
    useBlock(this->Mesh.Unused);
    for (auto& chunk : this->Mesh.Chunks)
    {
      for (auto* stream : { &chunk.Connectivity, &chunk.Geometry, &chunk.PointOrder,
             &chunk.CellOrder, &chunk.Corners })
      {
        use(*stream);
      }
    }
    for (auto& step : this->Steps)
    {
      use(step.Field);
      for (auto& array : step.Arrays)
      {
        for (auto& palette : array.Palettes)
        {
          use(palette.Stream);
        }
        std::for_each(array.Chunks.begin(), array.Chunks.end(), use);
        std::for_each(array.Blocks.begin(), array.Blocks.end(), use);
      }
    }
  }

  /** The bytes of a stream of the tables. */
  Bytes& Of(const StreamRef& stream) { return this->Streams.at(stream.Offset); }

  /** Gives a stream bytes of its own. */
  void Set(StreamRef& stream, Bytes bytes)
  {
    stream.Length = bytes.size();
    stream.Offset = this->Streams.size();
    this->Streams.push_back(std::move(bytes));
  }

  /** The whole file. */
  Bytes Build() const
  {
    auto placed = *this;
    std::vector<std::uint64_t> offsets;
    Section mesh{ SectionMesh, {} };
    for (const auto& bytes : this->Streams)
    {
      offsets.push_back(HeaderSize + SectionHeaderSize + mesh.Payload.size());
      mesh.Payload.insert(mesh.Payload.end(), bytes.begin(), bytes.end());
    }
    placed.EachStream(
      [&](StreamRef& stream)
      {
        if (stream.Length > 0 && stream.Offset < this->Streams.size())
        {
          const auto& bytes = this->Streams[stream.Offset];
          stream = { offsets[stream.Offset], bytes.size(), Checksum(bytes) };
        }
      });
    placed.Link();
    Section pages{ SectionPages, {} };
    const auto firstPage = HeaderSize + SectionHeaderSize + mesh.Payload.size() + SectionHeaderSize;
    std::size_t pageCount = 0;
    const auto put = [&](const Bytes& table)
    {
      const auto page = this->Changed(SectionPages, pageCount++, table);
      const StreamRef where{ firstPage + pages.Payload.size(), page.size(), Checksum(page) };
      pages.Payload.insert(pages.Payload.end(), page.begin(), page.end());
      return where;
    };
    auto index = MakeMeshIndex(placed.Mesh);
    WriteMeshPages(index, placed.Mesh, this->Meta.Keep, put);
    std::vector<Section> steps;
    for (const auto& step : placed.Steps)
    {
      const auto table = WriteStepPages(step, this->Meta, index, put).Write(this->Meta);
      steps.push_back({ SectionStep, this->Changed(SectionStep, steps.size(), table) });
    }
    std::vector<Section> sections{ std::move(mesh), std::move(pages) };
    sections.insert(sections.end(), steps.begin(), steps.end());
    if (this->Cells)
    {
      sections.push_back({ SectionCells, this->Cells->Write() });
    }
    if (this->ChangeIndex)
    {
      this->ChangeIndex(index);
    }
    sections.push_back(
      { SectionTable, this->Changed(SectionTable, 0, index.Write(this->Meta.Keep)) });
    sections.push_back({ SectionMeta, this->Changed(SectionMeta, 0, this->Meta.Write()) });
    sections.insert(sections.end(), this->MoreSections.begin(), this->MoreSections.end());
    return this->Assemble(sections);
  }

  /** A file of these sections, with directory and trailer. */
  Bytes Assemble(const std::vector<Section>& sections) const
  {
    ByteWriter header, file, directory;
    header.PutBytes(this->Kind->FileMagic);
    header.Put(this->Version);
    header.Put(this->Reserved);
    file.PutBytes(header.Data);
    directory.PutVarint(sections.size());
    const auto putSection = [](ByteWriter& out, const Section& section)
    {
      out.Put(section.Name);
      out.Put(section.Version);
      out.Put(section.Flags);
      out.Put(static_cast<std::uint64_t>(section.Payload.size()));
      out.Put(Checksum(section.Payload));
    };
    for (const auto& section : sections)
    {
      putSection(file, section);
      putSection(directory, section);
      directory.Put(static_cast<std::uint64_t>(file.Data.size()));
      file.PutBytes(section.Payload);
    }
    putSection(file, { SectionDirectory, directory.Data });
    const auto offset = file.Data.size();
    file.PutBytes(directory.Data);
    file.Put(static_cast<std::uint64_t>(offset));
    file.Put(static_cast<std::uint64_t>(directory.Data.size()));
    header.PutBytes(directory.Data);
    file.Put(Checksum(header.Data));
    file.PutBytes(this->Kind->TrailerMagic);
    return std::move(file.Data);
  }

  const ContainerKind* Kind = &MeshContainer;
  std::uint32_t Version = 1;
  std::uint32_t Reserved = 0;
  MetaTable Meta;
  std::optional<CellTable> Cells; // if not all cells are tetrahedra
  MeshTable Mesh;
  std::vector<StepTable> Steps;
  std::vector<Bytes> Streams;

  /** Changes META (number 0), TABL (0), STEP (each step) or a page (mesh first, two for each page,
   * then each step) before it is stored. Gets and returns unpacked bytes. Null: no changes. */
  std::function<void(FourCC name, std::size_t number, Bytes& table)> ChangeTable;

  /** Changes TABL before it is written, if not null. */
  std::function<void(MeshIndex&)> ChangeIndex;

  /** Changes the parts of chunks before they are written, if not null. */
  std::function<void(MeshTable&)> ChangeLinks;

  std::vector<Section> MoreSections; // behind the others

private:
  /** Takes all tables of a file. */
  void Take(const TablePages& tables)
  {
    this->Mesh.Palettes = tables.GetIndex().Palettes;
    this->Mesh.Unused = tables.GetIndex().Unused;
    for (std::size_t block = 0; block < tables.GetNumberOfBlocks(); ++block)
    {
      this->Mesh.Blocks.push_back(*tables.GetBlock(block));
    }
    const auto chunks = tables.GetChunks().size();
    for (std::size_t chunk = 0; chunk < chunks; ++chunk)
    {
      this->Mesh.Chunks.push_back(*tables.GetChunk(chunk));
    }
    for (std::size_t s = 0; s < tables.GetSteps().size(); ++s)
    {
      const auto& index = tables.GetSteps()[s];
      auto& step = this->Steps.emplace_back(
        StepTable{ index.Time, index.Key, index.PointsMove, index.Field, {} });
      for (std::size_t a = 0; a < index.Arrays.size(); ++a)
      {
        auto& array = step.Arrays.emplace_back();
        array.Palettes.resize(index.Arrays[a].Components);
        for (const auto& [component, palette] : index.Arrays[a].Palettes)
        {
          array.Palettes[component] = palette;
        }
        array.Ranges = index.Arrays[a].Ranges;
        for (std::size_t chunk = 0; chunk < chunks; ++chunk)
        {
          array.Chunks.push_back(tables.GetChunkValues(chunk, a, s));
          array.ChunkRanges.push_back(tables.GetChunkRanges(chunk, a, s));
        }
        const auto blocks = tables.GetNumberOfBlocks() + 1;
        for (std::size_t block = 0;
             this->Meta.Arrays[a].Where == Association::Point && block < blocks; ++block)
        {
          array.Blocks.push_back(tables.GetBlockValues(block, a, s));
        }
      }
    }
  }

  /** What MeshTable::LinkGroups does, for groups that may be wrong. */
  void Link()
  {
    for (auto& chunk : this->Mesh.Chunks)
    {
      chunk.Shared.clear();
      chunk.Info.SharedPoints = 0;
    }
    std::uint64_t point = 0;
    for (std::uint32_t b = 0; b < this->Mesh.Blocks.size(); ++b)
    {
      auto& block = this->Mesh.Blocks[b];
      block.FirstPoint = point;
      for (std::uint32_t g = 0; g < block.Groups.size(); ++g)
      {
        const auto& group = block.Groups[g];
        for (const auto c : group.Chunks)
        {
          if (c < this->Mesh.Chunks.size())
          {
            auto& chunk = this->Mesh.Chunks[c];
            chunk.Shared.push_back({ b, g, group.Points, point - block.FirstPoint, point });
            chunk.Info.SharedPoints += group.Points;
          }
        }
        point += group.Points;
      }
      block.Points = point - block.FirstPoint;
    }
    if (this->ChangeLinks)
    {
      this->ChangeLinks(this->Mesh);
    }
  }

  Bytes Changed(FourCC name, std::size_t number, const Bytes& table) const
  {
    if (!this->ChangeTable)
    {
      return table;
    }
    auto bytes = Decompress(table, std::uint64_t{ 1 } << 30);
    const auto before = bytes;
    this->ChangeTable(name, number, bytes);
    return bytes == before ? table : Store(bytes);
  }
};
}

#endif
