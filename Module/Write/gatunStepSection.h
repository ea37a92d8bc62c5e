// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunStepSection_h
#define gatunStepSection_h

#include "gatunArrayCopies.h"
#include "gatunArrayInput.h"
#include "gatunCellSubset.h"
#include "gatunFieldData.h"
#include "gatunMeshSection.h"
#include "gatunRoundedArrays.h"
#include "gatunScale.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gatun
{
/** The values of a time step as the caller has them. */
struct StepValues
{
  std::span<const void* const>
    Arrays;                         // the values of each array for the points and cells of a part
  const FieldData* Field = nullptr; // that of the first part counts
  bool HasTime = false;
  double Time = 0;

  /** For values that are on the lattices of another file: its domains. Otherwise null. */
  const std::vector<std::vector<Domain>>* Rounded = nullptr;

  /** The remaining cells, whose values count for ranges. Null: all cells. */
  const CellSubset* Remaining = nullptr;
};

/** How the arrays have keys at a time step. */
struct StepDomains
{
  std::vector<std::vector<Domain>> Components; // of each array; empty if nothing is known
  ArrayCopies Copies;                          // arrays without keys of their own
};

/** The scales of the arrays at a time step, one for each component. Those of no array with a
 * palette, and of no copy: nothing is predicted from their keys at the next step. */
using StepScales = std::vector<std::optional<std::vector<Scale>>>;

StepScales GetScales(const StepDomains& domains);

/** The scale of a component at the step before, or null if there is none to be kept. before may be
 * null. */
const Scale* FindScale(const StepScales* before, std::size_t array, std::size_t component);

/** A time step that is being written. */
struct StepInput
{
  StepTable Table;     // of all parts
  StepDomains Domains; // until the step is finished
  StepScales Scales;
  std::vector<ArrayInput> Arrays; // of the current part

  /** Whether there are values of points or cells to encode. */
  bool HasValues(Association where) const
  {
    return std::any_of(this->Arrays.begin(), this->Arrays.end(),
      [where](const ArrayInput& input)
      { return input.Description->Where == where && !input.IsCopy; });
  }

  /** The domains with the errors that all parts so far have reached, as StepValues::Rounded. */
  std::vector<std::vector<Domain>> GetRounded() const;
};

/**
 * Writes the values of the arrays at each time step, part by part: VALS sections with palettes,
 * field data, blocks and chunks, and the STEP section that locates them.
 *
 * Each part may write all its steps at once. The tables of the steps are kept until the last part
 * has written them.
 */
class StepSection
{
public:
  explicit StepSection(WriterState& state)
    : State(state)
  {
  }

  /** Sets the domains of a step. If they are not set, they are those of the first part. */
  void SetDomains(std::size_t step, StepDomains domains);

  /** Whether a step decodes without the one before. */
  bool IsKey(std::size_t step) const { return step % this->State.Options.KeyStepInterval == 0; }

  /** Leaves the STEP sections to one of the processes that write the file. */
  void KeepTables() { this->KeepsTables = true; }

  /** The tables of the steps, if they are kept. */
  std::vector<StepInput>& GetSteps() { return this->Steps; }

  /** Writes the next step of a part except the STEP section. Times must ascend, and be those of
   * the first part. The result is valid until the next call. */
  StepInput& WriteValues(
    WriterPart& part, const StepValues& values, const std::function<bool(double)>& progress);

  /** The same for the only step of a part, together with the mesh of the part: nothing of a chunk
   * stays in memory but the streams of its values. */
  StepInput& WriteWithMesh(MeshSection& mesh, WriterPart& part, const StepValues& values,
    const std::function<bool(double)>& progress);

  /** Writes the STEP section, if this is the last part, and keeps the values of the part for the
   * prediction of the next step. */
  void Finish(WriterPart& part, const StepValues& values);

  /** To be called behind the last step of a part. Throws Error(InvalidInput) if it has fewer than
   * the first part. */
  void EndPart();

  /** The values of the previous step of the current part, as readers have them. */
  const std::vector<Bytes>& GetBefore() const { return this->Before; }

  /** The number of finished steps of the current part. */
  std::size_t GetCount() const { return this->Count; }

private:
  StepDomains FindDomains(const WriterPart& part, const StepValues& values) const;
  bool IsPoints(std::size_t a) const { return this->State.Meta.IsPoints(a); }
  bool StandsStill(const WriterPart& part, const StepValues& values) const;
  std::optional<std::size_t> FindReference(std::size_t a) const;
  std::vector<Domain> FindPointDomains(const WriterPart& part, const void* coordinates) const;
  bool HasBefore(std::size_t a) const;
  void Prepare(const WriterPart& part, const StepValues& values);
  StepInput& WritePrepared(WriterPart& part, const std::function<bool(double)>& progress);
  void Check(const WriterPart& part, const StepValues& values) const;
  void Begin(const WriterPart& part, const StepValues& values);
  void AddArray(std::size_t a, const WriterPart& part, const void* values);
  void RoundArrays(const WriterPart& part, const StepValues& values);
  void TakeErrors();
  void CopyRounded(std::span<const std::uint32_t> tuples, std::size_t array) const;
  void WritePalettes(std::size_t a, bool isFirst, StreamBatch& batch);
  void AddFieldData(const FieldData& field, StepTable& step, StreamBatch& batch);
  void TakeUnused(const WriterPart& part);
  std::vector<Bytes> EncodeBlock(const WriterPart& part, std::size_t block) const;
  std::vector<Bytes> EncodeUnused();
  void WriteBlockValues(const WriterPart& part);
  void WriteChunkValues(WriterPart& part, const std::function<bool(double)>& progress);
  std::vector<Bytes> EncodeChunk(WriterPart& part, std::size_t chunk);
  StepInput& GetStep() { return this->Steps[this->Count]; }
  const StepInput& GetStep() const { return this->Steps[this->Count]; }

  WriterState& State;
  std::vector<StepInput> Steps;
  std::size_t Count = 0;
  std::size_t PointStep = 0; // the last step with coordinates of its own, if the points move
  bool KeepsTables = false;
  Bytes LastField;
  StreamRef LastFieldRef;
  std::vector<std::unique_ptr<RoundedArray>> Rounded; // of the current step; null: exact values
  std::vector<Bytes> Before;                          // values of the previous step of this part
  StreamBatch Opening; // palettes and field data of the step that is being written
  std::vector<std::vector<Bytes>> Ahead; // values of chunks that were encoded ahead
};
}

#endif
