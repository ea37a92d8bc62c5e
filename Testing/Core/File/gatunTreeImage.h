// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef gatunTreeImage_h
#define gatunTreeImage_h

// Takes a .gtn file with a merge tree apart, so that tests can change and reassemble it.

#include "gatunMergeCodec.h"
#include "gatunTreeSample.h"

#include <optional>

namespace gatun::test
{
/**
 * The mesh and the arrays of a file, which stay as they are, and what the file tells of its
 * merges. Build writes the latter behind all else, so that no stream moves.
 */
class TreeImage
{
public:
  TreeImage() = default;

  explicit TreeImage(const std::string& path)
    : Rest(ReadSections(path))
    , Meta(MetaTable::Read(FindPayload(Rest, SectionMeta)))
    , Chunks(MeshIndex::Read(FindPayload(Rest, SectionTable), Meta).Chunks)
    , Tree(ReadTreeTable(Rest))
  {
    if (!this->Tree.Parts.empty()) // it is not a base mesh
    {
      this->AllMerges = FileReader(path).GetMergeTree();
    }
    const InputFile file(path);
    for (const TreePart& part : this->Tree.Parts)
    {
      const auto read = [&](const StreamRef& where)
      { return where.Length > 0 ? file.Read(where, "a stream") : Bytes(); };
      this->Parts.push_back({ read(part.Merges), read(part.Map), read(part.Dependencies) });
    }
    for (auto& section : this->Rest)
    {
      const auto name = section.Name;
      if (name == SectionTreeStep)
      {
        this->TreeSteps.push_back(
          TreeStepTable::Read(section.Payload, this->Meta, this->Chunks, this->Tree));
      }
      if (name == SectionLevel)
      {
        this->Levels.push_back(section.Payload);
      }
      if (name == SectionTree || name == SectionTreeStep || name == SectionMerges ||
        name == SectionDependencies || name == SectionLevel)
      {
        section.Name = MakeFourCC("ROOM"); // as long as before, and skipped by readers
      }
    }
  }

  /** Another tree of the same mesh; bounds and ranges stay, and may be wrong then. */
  void SetMerges(const MergeTree& tree)
  {
    this->Levels.clear();
    this->Tree.Levels.clear();
    this->Tree.Parts.resize(1);
    this->Parts.assign(1,
      { EncodeMerges(tree, CountMergeablePoints(this->Meta, this->IsSurface()),
          tree.GetMerges().size(), this->IsSurface() ? MergeKind::Surface : MergeKind::Tetrahedra),
        {}, {} });
    this->Tree.Merges = static_cast<std::uint32_t>(tree.GetMerges().size());
    this->Tree.MergeCounts.back() = this->Tree.Merges;
  }

  /** The same merges without base meshes. */
  void RemoveLevels() { this->SetMerges(this->AllMerges); }

  bool IsSurface() const
  {
    return std::any_of(this->Rest.begin(), this->Rest.end(),
      [](const auto& section) { return section.Name == SectionSurface; });
  }

  Bytes Build() const
  {
    auto sections = this->Rest;
    std::uint64_t size = HeaderSize;
    for (const auto& section : sections)
    {
      size += SectionHeaderSize + section.Payload.size();
    }
    auto tree = this->Tree;
    Bytes streams;
    const auto put = [&](const Bytes& stream, StreamRef& where)
    {
      where = {};
      if (!stream.empty())
      {
        where = { size + SectionHeaderSize + streams.size(), stream.size(), Checksum(stream) };
        streams.insert(streams.end(), stream.begin(), stream.end());
      }
    };
    for (std::size_t i = 0; !this->KeepStream && i < tree.Parts.size(); ++i)
    {
      put(this->Parts.at(i).Merges, tree.Parts[i].Merges);
      put(this->Parts.at(i).Map, tree.Parts[i].Map);
      put(this->Parts.at(i).Dependencies, tree.Parts[i].Dependencies);
    }
    sections.push_back({ SectionMerges, streams, SectionVersion, 0 });
    sections.push_back({ this->TreeName, this->StoredTree ? Store(*this->StoredTree) : tree.Write(),
      SectionVersion, 0 });
    for (const auto& step : this->TreeSteps)
    {
      sections.push_back({ SectionTreeStep, step.Write(), SectionVersion, 0 });
    }
    for (const auto& step : this->StoredSteps)
    {
      sections.push_back({ SectionTreeStep, Store(step), SectionVersion, 0 });
    }
    for (const auto& level : this->Levels)
    {
      sections.push_back({ SectionLevel, level, SectionVersion, 0 });
    }
    sections.insert(sections.end(), this->MoreSections.begin(), this->MoreSections.end());
    return FileImage().Assemble(sections);
  }

  std::vector<FileImage::Section> Rest;
  MetaTable Meta; // what Rest has of it
  std::size_t Chunks = 0;
  TreeTable Tree;
  MergeTree AllMerges; // of the unchanged file
  std::vector<TreeStepTable> TreeSteps;
  std::vector<Bytes> Levels;

  struct PartStreams
  {
    Bytes Merges, Map, Dependencies;
  };
  std::vector<PartStreams> Parts;

  bool KeepStream = false; // write Tree.Parts as they are
  FourCC TreeName = SectionTree;
  std::optional<Bytes> StoredTree; // written in place of the table
  std::vector<Bytes> StoredSteps;  // written behind the tables
  std::vector<FileImage::Section> MoreSections;
};
}

#endif
