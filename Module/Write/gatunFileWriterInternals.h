// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunFileWriterInternals_h
#define gatunFileWriterInternals_h

// The state of a FileWriter, and of the writers of the files that are embedded in its file.

#include "gatunBaseMesh.h"
#include "gatunBoundaryMesh.h"
#include "gatunCellMask.h"
#include "gatunFileWriter.h"
#include "gatunMeshSection.h"
#include "gatunSeriesTable.h"
#include "gatunStepSection.h"
#include "gatunTreeSection.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
class CellSubset;
class FileReader;

class FileWriter::Internals
{
public:
  Internals(const std::string& path, const MeshInput& mesh,
    const std::vector<ArrayDescription>& arrays, const WriterOptions& options)
    : State(path, arrays, options)
    , Part(mesh)
  {
  }

  /** The meshes and time steps of a file, to which others are added. */
  Internals(const FileReader& file, const WriterOptions& options);

  /** A base mesh or the boundary of another writer's file. */
  Internals(const WriterState& whole, const MeshInput& mesh, const WriterOptions& options)
    : Internals(whole, mesh, whole.Meta.Arrays, options)
  {
  }

  /** Another mesh of the series. */
  Internals(const WriterState& whole, const MeshInput& mesh,
    const std::vector<ArrayDescription>& arrays, const WriterOptions& options)
    : State(whole, arrays, options)
    , Part(mesh)
  {
  }

  /** Divides the mesh into chunks, and encodes them if they must not wait for the values. */
  void Begin(const Progress& progress);
  void WriteStep(std::span<const void* const> values, const FieldData& field, bool hasTime,
    double time, const Progress& progress, const std::vector<std::vector<Domain>>* rounded = {},
    const CellSubset* remaining = nullptr);
  std::uint32_t AddMesh(const MeshInput& mesh, const std::vector<ArrayDescription>& arrays,
    const WriterOptions& options, const Progress& progress);
  void UseMesh(std::uint32_t mesh);

  /** The options of a mesh that is added to a file, or as they are. */
  WriterOptions FitOptions(WriterOptions options) const;

  void WriteSeriesStep(std::span<const void* const> values, const FieldData& field, bool hasTime,
    double time, const Progress& progress, const void* coordinates,
    const RemainingCells* remaining);
  FileStatistics Finish();

  /** Writes all but the directory. */
  void Complete();
  OutputFile& GetFile() { return this->State.File; }

private:
  /** A mesh made of this one, which is written as a file of its own and embedded at the end. */
  template <typename MeshT>
  struct Embedded
  {
    MeshT Mesh;
    WriterOptions Options;
    std::unique_ptr<Internals> File;
    std::optional<MergeTree> Tree = {}; // of the boundary
  };
  using Level = Embedded<BaseMesh>;

  void BeginMesh(const Progress& progress);
  void WriteMesh(const Progress& progress);
  void FindDomains();
  void BeginLevels(const Progress& progress);
  std::unique_ptr<Level> MakeLevel(std::uint32_t merges, const Progress& progress) const;
  void OrderPoints();
  TreeSection& BeginTree(MergeTree tree);
  void WriteTrees(const Progress& progress);
  void WriteBoundary(const Progress& progress);
  template <typename MeshT>
  void WriteEmbeddedStep(const Embedded<MeshT>& embedded, std::span<const void* const> values,
    bool hasTime, double time, const std::vector<std::vector<Domain>>& domains) const;
  std::uint64_t AddEmbedded(FourCC section, Internals& embedded);
  void CheckLayers(const StepTable& step) const;
  void EndOther();
  std::uint32_t WriteMask(CellMask mask);
  void WriteRemaining(std::span<const void* const> values, const FieldData& field, double time,
    const Progress& progress, const RemainingCells& remaining, StoredStep& stored);
  void WriteTables();

  WriterState State;
  WriterPart Part; // all of the mesh
  MeshSection Mesh{ State };
  StepSection Steps{ State };
  bool IsMeshWritten = false;
  std::uint32_t Masks = 0; // that have been written
  CellMask LastMask;
  std::optional<TreeSection> Tree;
  std::vector<std::uint32_t> PointOrder; // for the tree: the point of each point of the file
  std::vector<std::uint32_t> Merges;     // of the levels
  std::vector<std::unique_ptr<Level>> Levels;
  std::unique_ptr<Embedded<BoundaryMesh>> Boundary;
  std::unique_ptr<Internals> Other; // the mesh that was added last
  std::uint32_t NumberOfMeshes = 1;
  std::uint32_t NextMesh = 0; // that the next step has
  std::vector<StoredStep> Series;
  bool IsAppending = false; // the first meshes are in the file
};
}

#endif
