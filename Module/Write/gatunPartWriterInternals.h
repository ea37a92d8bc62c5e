// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPartWriterInternals_h
#define gatunPartWriterInternals_h

// The state of a PartWriter, and of the writers of the base meshes that are embedded in its file.

#include "gatunBoundaryMerge.h"
#include "gatunMeshSection.h"
#include "gatunPartAgreement.h"
#include "gatunPartLevels.h"
#include "gatunPartSurface.h"
#include "gatunPartSurvey.h"
#include "gatunPartTree.h"
#include "gatunPartValues.h"
#include "gatunPartWriter.h"
#include "gatunPointNumbers.h"
#include "gatunStepSection.h"
#include "gatunTreeSection.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
class PartWriter::Internals : public PartLevelFile
{
public:
  Internals(const std::string& path, const std::vector<ArrayDescription>& arrays,
    const PartWriterOptions& options);

  /** One of several processes. */
  Internals(const std::string& path, const std::vector<ArrayDescription>& arrays,
    const PartWriterOptions& options, PartExchange& exchange);

  /** A base mesh of a file, with the values of its mesh. */
  Internals(const WriterState& whole, const PartWriterOptions& options, const PartValues& values);

  void Survey(
    const MeshInput& mesh, const std::int64_t* globalIds, const Progress& progress) override;
  void SurveyStep(std::span<const void* const> values) override;
  void EndSurvey();
  void Write(
    const MeshInput& mesh, const std::int64_t* globalIds, const Progress& progress) override;
  void WriteStep(std::span<const void* const> values, const FieldData& field, bool hasTime,
    double time, const Progress& progress) override;
  PartStatistics Finish(const Progress& progress);

  // Of a base mesh.
  void EndParts() override;
  TreeSection& BeginTree(MergeTree tree) override;
  void Complete(std::vector<std::uint32_t> levels) override;
  WriterState& GetState() override { return this->State; }
  std::span<const std::uint32_t> GetNumbers() const override { return this->Values->GetNumbers(); }

private:
  void WriteHierarchy(const Progress& progress);
  void WriteBoundary(const Progress& progress);
  void EndPartSurvey();
  void JoinAlone();
  void JoinTogether();
  void SendPoints();
  void PlaceParts();
  void EndPart();
  std::vector<std::uint8_t> ApplyJoins(const PartJoins& joins);
  void CheckInput(const MeshInput& mesh) const;
  PartStatistics CountAll(const FileStatistics& file) const;
  bool HasNumbers() const
  {
    return this->Parts.size() > 1 && (this->Options.File.Keep & KeepPoints);
  }

  /** The number of a part of this process in the file. */
  std::size_t GetNumber(std::size_t part) const
  {
    return part + (this->Agreement ? this->Agreement->GetOwn().FirstPart : 0);
  }
  std::size_t GetNumberOfOwnParts() const
  {
    return this->Agreement ? this->Agreement->GetOwn().Parts : this->Parts.size();
  }
  std::size_t GetNumberOfSteps() const
  {
    return this->Parts.empty() ? 0 : this->Parts.front().StepHashes.size();
  }

  const PartWriterOptions Options;
  const std::string Folder;                       // of temporary files
  const std::vector<PartStep>* Rounded = nullptr; // the steps of the whole, of a base mesh
  WriterState State;
  MeshSection Mesh{ State };
  StepSection Steps{ State };
  BoundaryMerge Boundaries;
  std::vector<SurveyedPart> Parts;
  std::optional<PartSurvey> Current; // the part that is being surveyed
  PartDomains Domains;
  std::optional<bool> HasIds; // whether the parts with points have global ids
  bool IsJoined = false;

  // While parts are written.
  std::vector<PartPlace> Places;
  std::size_t Written = 0; // parts of this process that were begun
  std::optional<WriterPart> Part;
  std::vector<std::uint8_t> IsJoinedPoint; // whether other parts have a point of the part, too
  bool IsDeferred = false;                 // whether the mesh of the part is not written yet
  PointNumbers Numbers{ Boundaries };
  std::optional<PartValues> Values; // if the file has a hierarchy or a boundary
  std::optional<PartTree> Tree;     // if its merges have to be found
  std::optional<PartSurface> Surface;
  std::optional<TreeSection> Merges;

  // If several processes write the file.
  PartExchange* const Exchange = nullptr;
  std::optional<OutputFile> Common; // in the first process
  std::optional<PartAgreement> Agreement;
  std::vector<PartJoins> Joins; // of the parts of this process
};
}

#endif
