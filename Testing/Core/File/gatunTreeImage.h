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
    for (auto& section : this->Rest)
    {
      const auto name = section.Name;
      if (name == SectionTreeStep)
      {
        this->TreeSteps.push_back(
          TreeStepTable::Read(section.Payload, this->Meta, this->Chunks, this->Tree));
      }
      if (name == SectionMerges)
      {
        this->Merges = section.Payload;
      }
      if (name == SectionLevel)
      {
        this->Levels.push_back(section.Payload);
      }
      if (name == SectionTree || name == SectionTreeStep || name == SectionMerges ||
        name == SectionLevel)
      {
        section.Name = MakeFourCC("ROOM"); // as long as before, and skipped by readers
      }
    }
  }

  /** Another tree of the same mesh; bounds and ranges stay, and may be wrong then. */
  void SetMerges(const MergeTree& tree)
  {
    this->Merges = EncodeMerges(tree, CountMergeablePoints(this->Meta, this->IsSurface()),
      this->IsSurface() ? MergeKind::Surface : MergeKind::Tetrahedra);
    this->Tree.Merges = static_cast<std::uint32_t>(tree.GetMerges().size());
    this->Tree.MergeCounts.back() = this->Tree.Merges;
  }

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
    if (this->KeepStream)
    {
      tree.Stream = this->Tree.Stream;
    }
    else
    {
      tree.Stream = { size + SectionHeaderSize, this->Merges.size(), Checksum(this->Merges) };
    }
    sections.push_back({ SectionMerges, this->Merges, SectionVersion, 0 });
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
  std::vector<TreeStepTable> TreeSteps;
  Bytes Merges;
  std::vector<Bytes> Levels;

  bool KeepStream = false; // write Tree.Stream as it is
  FourCC TreeName = SectionTree;
  std::optional<Bytes> StoredTree; // written in place of the table
  std::vector<Bytes> StoredSteps;  // written behind the tables
  std::vector<FileImage::Section> MoreSections;
};
}

#endif
