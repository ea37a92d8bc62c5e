// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunPartValues_h
#define gatunPartValues_h

#include "gatunArrayInput.h"
#include "gatunAtomicFile.h"
#include "gatunBytes.h"
#include "gatunStepSection.h"
#include "gatunTreeLayout.h"
#include "gatunWriterPart.h"
#include "gatunWriterState.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace gatun
{
/** A time step of a mesh, for the meshes that are made of it. */
struct PartStep
{
  bool HasTime = false;
  double Time = 0;
  std::vector<std::vector<Domain>> Domains; ///< see StepValues::Rounded
};

/** Where the values of arrays are. */
std::vector<const void*> ListPointers(const std::vector<Bytes>& values);

/** Whether some array is one of cells. */
bool HasCellArrays(const MetaTable& meta);

/**
 * The points and values of a mesh that is written in parts, as readers will have them, in a
 * temporary file. Points have their numbers in the file, of which those that no cell uses are the
 * last ones; cells those of the parts, one part after the other. Methods throw Error(CannotWrite).
 */
class PartValues
{
public:
  static constexpr std::uint32_t None = 0xffffffffu;

  /** state: its tables must be those of all parts. steps: of all parts. keepsCells: whether the
   * values of cells are kept, too. Throws InvalidInput for too many points or cells. */
  PartValues(const WriterState& state, std::size_t steps, bool keepsCells, std::string folder);

  /** Adds the points of a part whose mesh has been written. */
  void AddPart(const WriterPart& part);

  /** Adds the values of a step of that part, the last one of which has the domains that count. */
  void AddStep(std::size_t step, const StepInput& input, const StepValues& values);

  /** The numbers of the points of the last part; None for those that another part has. */
  std::span<const std::uint32_t> GetNumbers() const { return this->Numbers; }

  /** Its points in the order of their numbers. */
  std::span<const std::uint32_t> GetOrder() const { return this->Order; }

  const std::vector<PartStep>& GetSteps() const { return this->Steps; }

  /** Where temporary files are made. */
  const std::string& GetFolder() const { return this->Folder; }

  /** Coordinates along an axis; NaN unless they are finite. */
  TreeLayout::GetValue ReadCoordinates(unsigned axis) const;

  /** The values of a point array that a range of ArrayRanges is for. */
  TreeLayout::GetValue ReadRange(std::size_t step, std::size_t array, std::size_t range) const;

  /** Tuples of some points. */
  Bytes GetCoordinates(std::span<const std::uint32_t> points) const;

  /** Tuples of all arrays for some points and cells. */
  std::vector<Bytes> GetValues(std::size_t step, std::span<const std::uint32_t> points,
    std::span<const std::uint32_t> cells) const;

private:
  /** Tuples in the file. */
  struct Column
  {
    std::uint64_t Offset = 0;
    ScalarType Type = ScalarType::Float64;
    std::uint32_t Components = 0;

    std::size_t GetBytes() const { return this->Components * SizeOf(this->Type); }
  };

  Column GetColumn(std::size_t step, std::size_t array) const;
  void WritePoints(const Column& column, const void* values);
  TreeLayout::GetValue Read(const Column& column, int component, bool isPlace) const;
  Bytes Gather(const Column& column, std::span<const std::uint32_t> tuples) const;

  const WriterState& State;
  const bool KeepsCells;
  const std::string Folder;
  AtomicFile File;
  Column Coordinates;
  std::vector<Column> Columns; // of a step; without components if it is not kept
  std::uint64_t StepBytes = 0;
  std::vector<PartStep> Steps;
  std::uint64_t FirstOwn;   // the number of the first own point of the next part
  std::uint64_t NextUnused; // that of the next point that no cell uses

  // Of the last part.
  std::uint64_t FirstCell = 0;
  std::uint64_t Cells = 0;
  std::vector<std::uint32_t> Numbers;
  std::vector<std::uint32_t> Order;
};
}

#endif
