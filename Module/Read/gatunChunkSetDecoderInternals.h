// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef gatunChunkSetDecoderInternals_h
#define gatunChunkSetDecoderInternals_h

// The state of ChunkSetDecoder while it decodes and stores.

#include "gatunCellStore.h"
#include "gatunChunkSetDecoder.h"
#include "gatunDomainWriter.h"
#include "gatunFileReaderInternals.h"
#include "gatunPieceRequest.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gatun
{
/** The position of the i-th item: its original id if there is an order, otherwise consecutive. */
struct ChunkSetDecoder::Places
{
  const OrderPart* Order;
  std::uint64_t First;

  std::uint64_t operator()(std::size_t i) const
  {
    return this->Order ? (*this->Order)[i] : this->First + i;
  }
};

//------------------------------------------------------------------------------
struct ChunkSetDecoder::Job
{
  /** Where the values of an array of the request go, and which components they are. */
  struct Output
  {
    std::uint8_t* Values;
    std::vector<std::uint32_t> Components;
  };

  /** An array to decode. Others of the request may be copies of it. */
  struct Wanted
  {
    std::uint32_t Index;
    std::vector<Output> Outputs;
    bool OfPoints;
    std::size_t KeyStep; // from which Last is decoded
    std::size_t Last;    // the step whose values are wanted
    std::size_t First;   // the earliest step that any chunk needs to decode, or the job's step
    std::vector<std::shared_ptr<const DomainsPart>> Domains; // from Begin on
    std::shared_ptr<const DomainsPart> LastDomains;          // in the last round
  };

  /** The decoded parts of a block. */
  struct BlockWork
  {
    std::shared_ptr<const PointsPart> Points;
    std::shared_ptr<const OrderPart> Order;
    std::vector<ArrayAtStep> Reached;                                 // for each array
    std::vector<std::vector<std::shared_ptr<const ArrayPart>>> Steps; // for each, from Begin on
    bool NeedsPoints = false;
  };

  /** The decoded parts of a chunk, until it is finished. */
  struct ChunkWork
  {
    std::shared_ptr<const ChunkMesh> Mesh;
    std::vector<ArrayAtStep> Reached; // for each array
  };

  const InputFile& File;
  const PieceTarget& Target;
  const bool RestorePoints;
  const bool RestoreCells;
  const bool RestoreCorners;
  const bool NeedsPointOrder;
  const bool NeedsCellOrder;
  const bool HasMeshPoints; // whether the points that are wanted are those of the mesh
  std::vector<Wanted> Arrays;
  std::vector<BlockWork> Blocks;
  std::vector<ChunkWork> Chunks;
  std::vector<PlacedCells> Placed; // of all chunks, to store original cells in the original order
  std::size_t Begin = 0;           // the steps to decode now
  std::size_t End = 0;
  bool IsFirst = true; // round
  bool IsLast = false;

  /** Adds an array of the request. values: where its values go. */
  void Add(const FileReader::Internals& content, FileReader::Internals::ArraySource source,
    std::size_t step, std::uint8_t* values, bool ofPoints)
  {
    auto found = std::find_if(this->Arrays.begin(), this->Arrays.end(),
      [&](const Wanted& array) { return array.Index == source.Array; });
    if (found == this->Arrays.end())
    {
      found = this->Arrays.insert(found,
        { source.Array, {}, ofPoints, content.FindKeyStep(source.Array, step), step, step, {},
          {} });
    }
    found->Outputs.push_back({ values, std::move(source.Components) });
  }

  /** The most steps to decode. */
  std::size_t CountSteps() const;

  /** Sets the next steps to decode, up to a number, with their domains. */
  void BeginRound(const PartDecoder& parts, std::size_t most);

  // The positions filled so far if an order is restored. A damaged file could contain one twice and
  // leave another one uninitialized.
  mutable std::vector<std::atomic<bool>> PointTaken;
  mutable std::vector<std::atomic<bool>> CellTaken;

  /** Whether anything is wanted of each point but its coordinates and values. */
  bool NeedsPointPlaces() const
  {
    return !this->PointTaken.empty() || this->Target.GlobalPointIds || this->Target.PointGhosts;
  }

  /** Whether anything is wanted of each cell but its corners and values. A step of a mesh that is
   * there already needs nothing. */
  bool NeedsCellPlaces() const
  {
    return !this->CellTaken.empty() || this->Target.GlobalCellIds || this->Target.FileCells ||
      this->Target.CellGhosts || this->Target.CellParents;
  }

  void TakePoint(std::uint64_t place) const { this->Take(this->PointTaken, place, "point "); }
  void TakeCell(std::uint64_t place) const { this->Take(this->CellTaken, place, "cell "); }

  void Take(std::vector<std::atomic<bool>>& taken, std::uint64_t place, const char* what) const
  {
    if (!taken.empty() && taken[static_cast<std::size_t>(place)].exchange(true))
    {
      this->File.Fail(ErrorCode::Corrupt,
        "the original order is damaged: it names " + (what + std::to_string(place)) + " twice");
    }
  }

  // Functions are taken by value, and should hold what they need likewise, not by reference: as far
  // as the compiler knows, what is stored could change it.

  void StoreTuples(
    const Wanted& array, const ArrayPart& values, std::size_t count, auto keyOf, auto placeOf) const
  {
    const auto& domains = *array.LastDomains;
    const auto size = SizeOf(domains.front().GetType());
    for (const auto& output : array.Outputs)
    {
      const auto stride = size * output.Components.size();
      auto* component = output.Values;
      for (const auto c : output.Components)
      {
        WithWriter(domains[c],
          [keys = values[c].data(), component, count, stride, keyOf, placeOf](auto write)
          {
            for (std::size_t i = 0; i < count; ++i)
            {
              write(keys[keyOf(i)], component + placeOf(i) * stride);
            }
          });
        component += size;
      }
    }
  }

  void StorePoints(const PointDomain& domains, std::size_t count, auto keysOf, auto placeOf) const
  {
    const auto size = SizeOf(domains[0].GetType());
    auto* const to = static_cast<std::uint8_t*>(this->Target.Points);
    const auto store = [&]<unsigned First, unsigned End>(
                         std::integer_sequence<unsigned, First, End>)
    {
      WithWriter(domains[First],
        [=](auto write)
        {
          for (std::size_t i = 0; i < count; ++i)
          {
            const auto& keys = keysOf(i);
            auto* const point = to + 3 * size * placeOf(i);
            for (unsigned axis = First; axis < End; ++axis)
            {
              write(keys[axis], point + size * axis);
            }
          }
        });
    };
    if (std::all_of(domains.begin(), domains.end(), [](const Domain& d) { return d.IsPlain(); }))
    {
      store(std::integer_sequence<unsigned, 0, 3>()); // the axes have one type
      return;
    }
    store(std::integer_sequence<unsigned, 0, 1>());
    store(std::integer_sequence<unsigned, 1, 2>());
    store(std::integer_sequence<unsigned, 2, 3>());
  }
};
}

#endif
