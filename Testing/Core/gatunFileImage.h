// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunFileImage_h
#define gatunFileImage_h

// A .gtn file taken apart, to be changed and put together again with right checksums.

#include "gatunCompress.h"
#include "gatunInputFile.h"
#include "gatunTables.h"

#include <algorithm>
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
  {
    const InputFile file(path);
    this->Major = file.GetMajor();
    this->Minor = file.GetMinor();
    const auto read = [&](FourCC name, const char* what)
    { return file.Read(file.FindSection(name, what), what); };
    this->Meta = MetaTable::Read(read(SectionMeta, "META"));
    if (!file.FindSections(SectionCells).empty())
    {
      this->Cells = CellTable::Read(read(SectionCells, "CELL"));
    }
    this->Mesh = MeshTable::Read(
      read(SectionTable, "TABL"), this->Meta, this->Cells ? &*this->Cells : nullptr);
    for (const auto& section : file.GetSections())
    {
      if (section.Name == SectionStep)
      {
        this->Steps.push_back(
          StepTable::Read(file.Read(section.Payload, "STEP"), this->Meta, this->Mesh));
      }
    }
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
    std::vector<Section> sections{ std::move(mesh) };
    for (std::size_t i = 0; i < std::max(placed.Steps.size(), this->StoredSteps.size()); ++i)
    {
      const bool stored = i < this->StoredSteps.size() && this->StoredSteps[i];
      sections.push_back(
        { SectionStep, stored ? Store(*this->StoredSteps[i]) : placed.Steps[i].Write() });
    }
    if (this->Cells)
    {
      sections.push_back({ SectionCells, this->Cells->Write() });
    }
    sections.push_back({ SectionTable,
      this->StoredMesh ? Store(*this->StoredMesh) : placed.Mesh.Write(this->Meta.Keep) });
    sections.push_back(
      { SectionMeta, this->StoredMeta ? Store(*this->StoredMeta) : this->Meta.Write() });
    sections.insert(sections.end(), this->MoreSections.begin(), this->MoreSections.end());
    return this->Assemble(sections);
  }

  /** A file of these sections, with directory and trailer. */
  Bytes Assemble(const std::vector<Section>& sections) const
  {
    ByteWriter header, file, directory;
    header.PutBytes(this->Kind->FileMagic);
    header.Put(this->Major);
    header.Put(this->Minor);
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
  std::uint16_t Major = 1;
  std::uint16_t Minor = 0;
  std::uint32_t Reserved = 0;
  MetaTable Meta;
  std::optional<CellTable> Cells; // if not all cells are tetrahedra
  MeshTable Mesh;
  std::vector<StepTable> Steps;
  std::vector<Bytes> Streams;

  /** Written in place of the tables above, if there. */
  std::optional<Bytes> StoredMeta, StoredMesh;
  std::vector<std::optional<Bytes>> StoredSteps;

  std::vector<Section> MoreSections; // behind the others
};
}

#endif
