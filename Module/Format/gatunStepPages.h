// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunStepPages_h
#define gatunStepPages_h

// The STEP sections and the pages that they name. See Documentation/format.md, 3.4.

#include "gatunBytes.h"
#include "gatunMeshPages.h"
#include "gatunMetaTable.h"
#include "gatunTableParts.h"
#include "gatunTypes.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace gatun
{
/** One array at one time step of a file that is being written. */
struct ArrayStep
{
  std::vector<PaletteRef> Palettes; // one for each component
  ArrayRanges Ranges;
  std::vector<ArrayRanges> ChunkRanges;
  std::vector<StreamRef> Chunks; // one for each chunk
  std::vector<StreamRef>
    Blocks; // one for each block, and one for the unused points; point arrays only
};

/** A time step of a file that is being written. Readers have StepIndex and StepPage. */
struct StepTable
{
  double Time = 0;
  bool Key = true;         // whether it decodes without the previous step
  bool PointsMove = false; // whether the last array is the coordinates, and not of the step before
  StreamRef Field;         // length 0 if there are no field data
  std::vector<ArrayStep> Arrays;
};

/** A STEP section. */
struct StepIndex
{
  struct Array
  {
    /** Of the components whose keys are not plain, ascending. An array may have many components. */
    std::vector<std::pair<std::uint32_t, PaletteRef>> Palettes;
    std::uint32_t Components = 1;
    ArrayRanges Ranges;
    StreamRef Unused; // values of the unused points; point arrays only

    /** Whether all components are copies of those of another array, which has their streams. */
    bool IsCopy() const { return !this->Palettes.empty() && this->Palettes[0].second.IsCopy(); }

    /** Whether keys at the step before are of the same values, so that streams may refer to them.
     */
    bool CanFollow(const Array& before) const;
  };

  double Time = 0;
  bool Key = true;
  StreamRef Field;
  bool PointsMove = false; // as in StepTable
  std::vector<Array> Arrays;
  std::vector<StreamRef> Pages; // as many as the mesh has, but none without arrays

  /** The array that has the streams of an array: itself or that from which it is copied. */
  std::size_t GetSource(std::size_t array) const
  {
    const auto& entry = this->Arrays.at(array);
    return entry.IsCopy() ? entry.Palettes[0].second.SourceArray : array;
  }

  Bytes Write(const MetaTable& meta) const;

  /** A step without coordinates has those of the previous step. before: that step, null for the
   * first one. */
  static StepIndex Read(std::span<const std::uint8_t> bytes, const MetaTable& meta,
    const MeshIndex& mesh, const StepIndex* before);

private:
  void CheckCopies(const MetaTable& meta) const;
  void ReadArray(ByteReader& in, const ArrayDescription& description);
};

/** The chunks and blocks of a page of the mesh at one time step. */
struct StepPage
{
  struct Array
  {
    std::vector<Range> Ranges;     // of all chunks
    std::vector<StreamRef> Chunks; // one for each chunk
    std::vector<StreamRef> Blocks; // one for each block; point arrays only
  };
  std::vector<Array> Arrays;

  std::uint64_t GetBytes() const;

  static StepPage Read(std::span<const std::uint8_t> bytes, std::size_t page, const StepIndex& step,
    const MetaTable& meta, const MeshIndex& mesh);
};

/** Writes the pages of a step. mesh: the pages of the mesh. */
StepIndex WriteStepPages(
  const StepTable& step, const MetaTable& meta, const MeshIndex& mesh, const PutPage& put);

/** Throws unless a stream can contain the values of this number of points or cells. */
void CheckValues(const ArrayDescription& array, std::uint64_t tuples, const StreamRef& stream);
}

#endif
