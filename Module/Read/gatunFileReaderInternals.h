// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFileReaderInternals_h
#define gatunFileReaderInternals_h

#include "gatunCache.h"
#include "gatunCellMask.h"
#include "gatunFileReader.h"
#include "gatunGeometry.h"
#include "gatunInputFile.h"
#include "gatunLayers.h"
#include "gatunMergeDependencies.h"
#include "gatunSeriesTable.h"
#include "gatunTablePages.h"
#include "gatunTreeTable.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
/** The tables of a file. Decoders find their streams here. */
class FileReader::Internals
{
public:
  Internals(std::shared_ptr<const ByteSource> source, const std::string& name);

  /** A base mesh of a file. */
  Internals(std::shared_ptr<const Internals> whole, std::size_t level);

  /** The boundary in a file. */
  Internals(const Internals& whole, const StreamRef& boundary);

  /** What one of these consists of. */
  static MeshCounts Count(
    const Internals& whole, const StreamRef& embedded, const std::string& name);

  /** A mesh of a series other than the first. */
  static std::unique_ptr<Internals> MakeMesh(const Internals& whole, std::size_t mesh);

  /** The domains of the components of an array at a step. Those of a copy are plain: its keys are
   * those of its source. */
  std::vector<Domain> MakeDomains(std::size_t array, std::size_t step) const;

  /** The array with the keys of an array at a step, and their components there. */
  struct ArraySource
  {
    std::uint32_t Array;
    std::vector<std::uint32_t> Components;
  };
  ArraySource FindSource(std::uint32_t array, std::size_t step) const;

  /** Whether an array has no streams at a step. */
  bool IsCopy(std::size_t array, std::size_t step) const
  {
    return this->GetSteps()[step].Arrays[array].IsCopy();
  }

  /** The key step from which a step is decoded. */
  std::size_t FindKeyStep(std::size_t step) const
  {
    while (step > 0 && !this->GetSteps()[step].Key)
    {
      --step;
    }
    return step;
  }

  /** The step from which an array at a step that has it is decoded. */
  std::size_t FindKeyStep(std::size_t array, std::size_t step) const
  {
    if (!this->Meta.IsPoints(array))
    {
      return this->FindKeyStep(step);
    }
    while (this->GetTables().GetPointReference(step) > 0)
    {
      step = this->GetTables().GetPointReference(step);
    }
    return step;
  }

  /** The number of the array of coordinates. Only if the points move. */
  std::uint32_t GetPointArray() const
  {
    return static_cast<std::uint32_t>(this->Meta.GetListedArrays());
  }

  /** Whether streams of an array at a step may refer to the previous step, or those of coordinates
   * to another one. */
  bool HasBefore(std::size_t array, std::size_t step) const
  {
    const auto& steps = this->GetSteps();
    if (this->Meta.IsPoints(array))
    {
      return step > 0; // those of another scale are converted
    }
    return step > 0 && !steps[step].Key &&
      steps[step].Arrays[array].CanFollow(steps[step - 1].Arrays[array]);
  }

  const TablePages& GetTables() const { return *this->Tables; }
  const std::vector<StepIndex>& GetSteps() const { return this->Tables->GetSteps(); }

  /** Throws unless the values of the chunks at the first step are within their layers. */
  void CheckLayers() const;

  /** A mask of the cells, from 1. The last ones used are kept. */
  std::shared_ptr<const CellMask> GetMask(std::size_t mask) const;

  /** The name of a base mesh in messages. */
  static std::string GetLevelName(std::size_t level)
  {
    return "base mesh " + std::to_string(level + 1);
  }
  static constexpr const char* BoundaryName = "the boundary";

  /** The mesh that has the merges, and which it has of a part on. */
  const Internals& GetOwnerOfMerges() const { return this->Whole ? *this->Whole : *this; }
  MergeTree ReadMerges(std::size_t part) const;
  MergeDependencies ReadDependencies(std::size_t part, const MergeTree& tree) const;

  InputFile File;
  MetaTable Meta;
  std::optional<CellTable> Cells; // if not all cells are tetrahedra
  std::vector<CellTypeCount> CellTypes;
  bool IsSurface = false;
  std::vector<double> Times;
  std::vector<ArrayDescription> ListedArrays; // without coordinates of points that move
  PointDomain Domains;
  bool LayersAreKnown = false;
  Layers LayersOfChunks;
  std::optional<TreeTable> Tree;
  std::vector<TreeStepTable> TreeSteps;
  std::vector<StreamRef> Levels;
  std::shared_ptr<const Internals> Whole; // of a base mesh: the file with the merges
  std::size_t Part = 0;                   // of these merges, where those of this mesh begin
  std::optional<StreamRef> Boundary;
  std::vector<StreamRef> Meshes; // all but the first
  std::vector<StreamRef> Masks;  // of the cells of this mesh
  std::vector<StoredStep> Stored;
  std::vector<SeriesStep> Series;
  std::vector<StoredStep> Kinds; // the first step of each mesh and mask, numbered as in Series

private:
  Internals(const Internals& whole, const StreamRef& embedded, const std::string& name);

  Domain MakeDomain(ScalarType type, const PaletteRef& palette, const std::string& what) const;

  std::optional<TablePages> Tables;
  std::uint64_t StepBytes = 0; // unpacked size of the tables of all steps
  static constexpr std::uint64_t KeptMaskBytes = 32u << 20;
  mutable Cache<std::size_t, CellMask> KeptMasks{ std::make_shared<CacheBudget>(KeptMaskBytes),
    CachePolicy::KeepLast };

  void Read();
  void ReadTables();
  static MetaTable ReadMeta(const InputFile& file);
  static std::optional<CellTable> ReadCells(const InputFile& file);
  void CountCells();
  void ReadSurface();
  void ReadLayers();
  void ReadTree();
  void RequireMerges() const;
  void ReadBoundary();
  void CheckBoundary(const Internals& whole) const;
  void ReadSeries();
  CellMask ReadMask(std::size_t mask) const;
  bool HasStepsOf(const std::vector<StoredStep>& series, std::size_t mesh) const;
  void CheckLevel(const Internals& whole, std::size_t level) const;
  void AddStepBytes(std::span<const std::uint8_t> packed);
  void CheckLastStep() const;
};

inline const FileReader::Internals& InternalsOf(const FileReader& file)
{
  return *file.Self;
}

/** The cells that a mesh of a series has, or null if it has all. Throws Error as GetMask does. */
inline std::shared_ptr<const CellMask> MaskOf(const FileReader& file)
{
  return file.Mask > 0 ? file.Self->GetMask(file.Mask) : nullptr;
}
}

#endif
