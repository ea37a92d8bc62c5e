// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunStepPrefetcher.h"

#include "gatunBytes.h"
#include "gatunChunkCache.h"
#include "gatunPieceDecoder.h"

#include <system_error>
#include <utility>
#include <vector>

namespace gatun
{
namespace
{
// What the cache needs for a tetrahedron and for a value of an array, as far as it is known before.
constexpr std::uint64_t BytesOfTet = 60;
constexpr std::uint64_t BytesOfValue = 8;
// The step that is shown, the one before and the one that is decoded.
constexpr std::uint64_t StepsToKeep = 3;

/** Whether there is room for the mesh and some steps of its arrays. */
bool HasRoom(const ChunkCache& cache, const PieceRequest& request)
{
  const FileReader& file = *cache.GetFile();
  std::uint64_t mesh = 0;
  std::uint64_t step = 0;
  for (const std::uint32_t chunk : request.Chunks)
  {
    const ChunkInfo& info = file.GetChunks()[chunk];
    mesh += BytesOfTet * info.Tets;
    for (const std::uint32_t a : request.Arrays)
    {
      const ArrayDescription& array = file.GetArrays()[a];
      step += BytesOfValue * array.Components *
        (array.Where == Association::Point ? info.OwnPoints + info.SharedPoints : info.Cells);
    }
  }
  return mesh + StepsToKeep * step <= cache.GetBudget();
}

/** Decodes the arrays of a chunk. Their values are needed by nobody yet. */
void DecodeChunk(PieceDecoder& decoder, const PieceRequest& request,
  const std::vector<ArrayDescription>& arrays, const PieceDecoder::Progress& progress)
{
  decoder.SetRequest(request, progress);
  std::vector<Bytes> values;
  PieceTarget target;
  for (const std::uint32_t a : request.Arrays)
  {
    const auto tuples = arrays[a].Where == Association::Point ? decoder.GetNumberOfPoints()
                                                              : decoder.GetNumberOfCells();
    values.emplace_back(
      static_cast<std::size_t>(tuples) * arrays[a].Components * SizeOf(arrays[a].Type));
    target.Arrays.push_back(values.back().data());
  }
  decoder.Fill(target, progress);
}
}

//------------------------------------------------------------------------------
std::optional<std::size_t> StepPrefetcher::FindNext(
  const ChunkCache& cache, const PieceRequest& filled)
{
  const bool goesBack = this->LastStep && *this->LastStep == filled.Step + 1;
  this->LastStep = filled.Step;
  const std::size_t next = goesBack ? filled.Step - 1 : filled.Step + 1; // may wrap around
  if (filled.Arrays.empty() || next >= cache.GetFile()->GetNumberOfSteps() ||
    !HasRoom(cache, filled))
  {
    return {};
  }
  return next;
}

//------------------------------------------------------------------------------
void StepPrefetcher::Start(const std::shared_ptr<ChunkCache>& cache, const PieceRequest& filled)
{
  this->Stop();
  const auto next = this->FindNext(*cache, filled);
  if (!next)
  {
    return;
  }
  PieceRequest request;
  request.Arrays = filled.Arrays;
  request.Universe = filled.Universe;
  request.Step = *next;
  request.Form = PieceForm::Original;
  request.RestoreOrder = false;
  auto decode = [this, chunks = filled.Chunks, request,
                  view = std::make_shared<ChunkCache>(cache, true)]() mutable
  {
    PieceDecoder decoder(view);
    const std::vector<ArrayDescription>& arrays = view->GetFile()->GetArrays();
    for (std::size_t i = 0; i < chunks.size() && !this->Worker.MustStop(); ++i)
    {
      request.Chunks = { chunks[i] };
      DecodeChunk(decoder, request, arrays, [this](double) { return !this->Worker.MustStop(); });
    }
  };
  try
  {
    // Nobody asks why it fails: whoever reads the step finds out.
    this->Worker.Request(std::move(decode));
  }
  catch (const std::system_error&)
  {
    // Without another thread nothing is decoded ahead.
  }
}
}
