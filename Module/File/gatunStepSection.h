// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunStepSection_h
#define gatunStepSection_h

#include "gatunArrayInput.h"
#include "gatunFieldData.h"
#include "gatunWriterState.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace gatun
{
/** A time step that is being written. */
struct StepInput
{
  StepTable Table;
  std::vector<ArrayInput> Arrays;
  std::vector<bool> IsPlain; // whether the array has no palette
};

/**
 * Writes the values of the arrays at each time step: VALS sections with palettes, field data,
 * blocks and chunks, and the STEP section that locates them.
 */
class StepSection
{
public:
  explicit StepSection(WriterState& state)
    : State(state)
  {
  }

  /** Writes everything except the STEP section. Times must ascend. */
  StepInput WriteValues(std::span<const void* const> values, const FieldData& field, bool hasTime,
    double time, const std::function<bool(double)>& progress);

  /** Writes the STEP section and keeps the values for the prediction of the next step. */
  void Finish(std::span<const void* const> values, const StepInput& step);

  /** The number of finished steps. */
  std::size_t GetCount() const { return this->Count; }

private:
  void Check(std::span<const void* const> values, bool hasTime, double time) const;
  void AddArray(std::size_t a, const void* values, StepInput& step, StreamBatch& batch);
  void AddFieldData(const FieldData& field, StepTable& step, StreamBatch& batch);
  void WriteBlockValues(StepInput& step);
  void WriteChunkValues(StepInput& step, const std::function<bool(double)>& progress);
  std::vector<Bytes> EncodeChunk(StepInput& step, std::size_t chunk);
  void KeepForNextStep(std::span<const void* const> values);

  WriterState& State;
  std::size_t Count = 0;
  double LastTime = 0;
  Bytes LastField;
  StreamRef LastFieldRef;
  std::vector<Bytes> Before;       // values of the previous step
  std::vector<bool> BeforeIsPlain; // whether that step had no palette
};
}

#endif
