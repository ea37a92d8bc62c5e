// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPartLevels_h
#define gatunPartLevels_h

#include "gatunFieldData.h"
#include "gatunMergeTree.h"
#include "gatunMeshInput.h"
#include "gatunPartMerges.h"
#include "gatunPartValues.h"
#include "gatunTreeParts.h"
#include "gatunWriterOptions.h"
#include "gatunWriterState.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace gatun
{
/** A base mesh that is written in parts, in a file of its own; see PartWriter. */
class PartLevelFile
{
public:
  using Progress = std::function<bool(double)>;

  PartLevelFile() = default;
  virtual ~PartLevelFile() = default;
  PartLevelFile(const PartLevelFile&) = delete;
  PartLevelFile& operator=(const PartLevelFile&) = delete;

  virtual void Survey(
    const MeshInput& mesh, const std::int64_t* globalIds, const Progress& progress) = 0;
  virtual void SurveyStep(std::span<const void* const> values) = 0;
  virtual void Write(
    const MeshInput& mesh, const std::int64_t* globalIds, const Progress& progress) = 0;
  virtual void WriteStep(std::span<const void* const> values, const FieldData& field, bool hasTime,
    double time, const Progress& progress) = 0;

  /** To be called when all parts have been written. */
  virtual void EndParts() = 0;

  /** Begins the section of a hierarchy in the numbers of the file. */
  virtual TreeSection& BeginTree(MergeTree tree) = 0;

  /** Writes the tables. levels: the numbers of merges of the base meshes in the file. */
  virtual void Complete(std::vector<std::uint32_t> levels) = 0;

  virtual WriterState& GetState() = 0;

  /** The numbers in the file of the points of the part that is being written. */
  virtual std::span<const std::uint32_t> GetNumbers() const = 0;
};

/**
 * The base meshes of a mesh that is written in parts. Each one is what is left at the end of a
 * level of PartMerges, and is itself written in parts, which are the groups of the level. When all
 * that is left is one group, further ones have half of the points, a quarter and so on.
 */
class PartLevels
{
public:
  using Progress = PartLevelFile::Progress;

  /** Makes the file of a base mesh, whose points are joined by their ids only. */
  using MakeFile = std::function<std::unique_ptr<PartLevelFile>(const WriterOptions&)>;

  /** State, values and merges must exist as long as this object. */
  PartLevels(WriterState& whole, const PartValues& values, const PartMerges& merges, MakeFile make);

  /** Writes the mesh at the end of a level into a file of its own, if it is to be a base mesh. */
  void Add(std::uint32_t merges, const Progress& progress);

  /** Writes those behind the last level. */
  void AddRest(const MergeTree& tree, const Progress& progress);

  /** Adds the base meshes to a list. */
  void List(std::vector<MeshOfTree>& meshes) const;

  /** Completes the base meshes and adds them to the file. Returns the numbers of merges that lead
   * to them. */
  std::vector<std::uint32_t> Embed();

private:
  struct Level
  {
    std::uint32_t Merges = 0;
    std::unique_ptr<PartLevelFile> File;
    std::vector<std::uint32_t> Points; // their numbers in the whole mesh
  };

  bool IsComplete() const;
  std::uint64_t CountCells() const;
  void Write(std::uint32_t merges, std::size_t parts,
    const std::function<MergedPart(std::size_t)>& read,
    const std::function<bool(std::uint32_t)>& isLeft, const Progress& progress);

  WriterState& Whole;
  const PartValues& Values;
  const PartMerges& Merges;
  const MakeFile Make;
  std::vector<Level> Levels;
};
}

#endif
