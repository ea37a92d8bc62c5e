// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPieceDecoder.h"

#include "gatunBytePlan.h"
#include "gatunChunkCache.h"
#include "gatunChunkSetDecoder.h"
#include "gatunCoarsePiece.h"
#include "gatunFileReaderInternals.h"
#include "gatunPieceSelection.h"
#include "gatunRegion.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

namespace gatun
{
//------------------------------------------------------------------------------
/**
 * A piece with ghosts is extracted from a larger set of chunks. The set is decoded as a whole, and
 * the cells that touch the piece are copied with their points. A piece of a mesh of which only some
 * cells are alive is extracted from all of its cells in the same way.
 */
class PieceDecoder::Internals
{
public:
  explicit Internals(std::shared_ptr<ChunkCache> cache)
    : Cache(std::move(cache))
    , File(Cache->GetFile())
    , Mask(MaskOf(*File))
  {
  }

  void SetRequest(const PieceRequest& request, const Progress& progress);
  void Fill(const PieceTarget& target, const Progress& progress);

  const std::shared_ptr<ChunkCache> Cache;
  const std::shared_ptr<const FileReader> File;
  const std::shared_ptr<const CellMask> Mask; // null if all cells are alive
  PieceRequest Request;
  std::shared_ptr<const CoarseLayout> Layout;  // of the last merges
  std::shared_ptr<const MergeTree> LayoutTree; // of these
  std::unique_ptr<CoarsePiece> Coarse;         // replaces the members below if there are merges
  std::unique_ptr<ChunkSetDecoder> Piece;
  std::unique_ptr<ChunkSetDecoder> Around; // null without ghosts, if all cells are alive
  std::optional<PieceSelection> Cut;       // out of Around
  bool IsRestored = false;                 // whether Around has the original order

private:
  void CheckRequest(const PieceRequest& request) const;
  void CheckValues(const PieceRequest& request) const;
  void MarkPoints(unsigned char* ghosts, const Progress& progress) const;
};

void PieceDecoder::Internals::CheckRequest(const PieceRequest& request) const
{
  const auto ascend = [](const std::vector<std::uint32_t>& list, std::size_t end)
  {
    return std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) == list.end() &&
      (list.empty() || list.back() < end);
  };
  const bool hasStep = request.Step < this->File->GetNumberOfSteps();
  if (!ascend(request.Chunks, this->File->GetChunks().size()) ||
    !ascend(request.Universe, this->File->GetChunks().size()) ||
    !ascend(request.Arrays, this->File->GetArrays().size()) ||
    (!hasStep && !request.Arrays.empty()))
  {
    ThrowInvalid("the file has no such chunk, array or time step", this->File->GetPath());
  }
  if (request.Merges > 0 &&
    (!request.Tree || request.Merges > request.Tree->GetMerges().size() ||
      request.Tree->GetNumberOfPoints() != this->File->GetNumberOfPoints() ||
      (request.Cut && request.Cut->GetFile() != this->File)))
  {
    ThrowInvalid("the file has fewer merges than the piece asks for", this->File->GetPath());
  }
  if (!request.Universe.empty() &&
    !std::includes(request.Universe.begin(), request.Universe.end(), request.Chunks.begin(),
      request.Chunks.end()))
  {
    ThrowInvalid("a piece must be inside the requested universe", this->File->GetPath());
  }
}

/** Throws unless the streams of the arrays can contain their values, before memory is taken for
 * them. */
void PieceDecoder::Internals::CheckValues(const PieceRequest& request) const
{
  const auto& tables = InternalsOf(*this->File).GetTables();
  for (const auto array : request.Arrays)
  {
    const bool ofPoints = this->File->GetArrays()[array].Where == Association::Point;
    for (const auto chunk : request.Chunks)
    {
      tables.GetChunkValues(chunk, array, request.Step);
      if (!ofPoints)
      {
        continue;
      }
      std::optional<std::uint32_t> last; // the parts of a block follow each other
      const auto entry = tables.GetChunk(chunk);
      for (const auto& part : entry->Shared)
      {
        if (part.Block != last)
        {
          tables.GetBlockValues(part.Block, array, request.Step);
          last = part.Block;
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void PieceDecoder::Internals::SetRequest(const PieceRequest& request, const Progress& progress)
{
  this->CheckRequest(request);
  this->CheckValues(request);
  FetchPiece(*this->File, request);
  const bool same = (this->Piece || this->Coarse) && request.Merges == this->Request.Merges &&
    request.Tree == this->Request.Tree && request.Cut == this->Request.Cut &&
    request.RestoreOrder == this->Request.RestoreOrder && request.Chunks == this->Request.Chunks &&
    request.Universe == this->Request.Universe &&
    request.GhostLevels == this->Request.GhostLevels && request.Form == this->Request.Form &&
    request.WithUnusedPoints == this->Request.WithUnusedPoints;
  this->Request = request;
  if (same)
  {
    return;
  }
  this->Around.reset();
  this->Piece.reset();
  this->Coarse.reset();
  if (request.Merges > 0)
  {
    if (request.Cut)
    {
      this->Layout = request.Cut;
      this->LayoutTree = nullptr;
    }
    else if (!this->Layout || this->LayoutTree != request.Tree ||
      this->Layout->GetCut().GetLast() != request.Merges)
    {
      this->Layout = std::make_shared<const CoarseLayout>(
        this->File, *request.Tree, MergeCut(*request.Tree, request.Merges));
      this->LayoutTree = request.Tree;
    }
    this->Coarse = std::make_unique<CoarsePiece>(this->Cache, this->Layout, request, progress);
    return;
  }
  auto piece = std::make_unique<ChunkSetDecoder>(
    this->Cache, request.Chunks, request.Universe, request.WithUnusedPoints, request.Form);
  if (request.GhostLevels > 0)
  {
    auto chunks = Surround(*this->File, request.Chunks, request.Universe, request.GhostLevels);
    if (chunks != request.Chunks || this->Mask)
    {
      this->Around = std::make_unique<ChunkSetDecoder>(
        this->Cache, std::move(chunks), request.Universe, request.WithUnusedPoints, request.Form);
    }
  }
  else if (this->Mask)
  {
    this->Around = std::make_unique<ChunkSetDecoder>(
      this->Cache, request.Chunks, request.Universe, request.WithUnusedPoints, request.Form);
  }
  this->Piece = std::move(piece);
  if (this->Around)
  {
    this->IsRestored = request.GhostLevels == 0 && request.RestoreOrder &&
      this->Around->GetSet().IsWhole() &&
      (this->File->GetKeptOrder() & (KeepPoints | KeepCells)) != 0;
    try
    {
      this->Cut.emplace(*this->Around, this->Piece->GetSet(),
        PieceCut{ this->Mask.get(), request.GhostLevels, this->IsRestored }, progress);
    }
    catch (...)
    {
      this->Piece.reset();
      throw;
    }
  }
}

/** Marks the points that other pieces own. */
void PieceDecoder::Internals::MarkPoints(unsigned char* ghosts, const Progress& progress) const
{
  const auto& points = this->Cut->GetPoints();
  const auto own = this->Cut->GetNumberOfOwnPoints();
  // Points that belong only to ghost cells are duplicates.
  std::memset(ghosts + own, 1, points.size() - own);
  if (!this->Mask || !this->Mask->DropsPoints)
  {
    this->Piece->GetSet().MarkOwners(ghosts);
    return;
  }
  if (this->IsRestored)
  {
    std::memset(ghosts, 0, own);
    return;
  }
  // The lowest chunk that uses a point may have no remaining cell that does.
  std::unique_ptr<ChunkSetDecoder> larger;
  std::vector<std::uint64_t> places;
  if (this->Request.GhostLevels == 0)
  {
    larger = std::make_unique<ChunkSetDecoder>(this->Cache,
      Surround(*this->File, this->Request.Chunks, this->Request.Universe, 1),
      this->Request.Universe, this->Request.WithUnusedPoints, this->Request.Form);
    places = larger->GetSet().Locate(this->Around->GetSet());
  }
  const auto owners =
    PieceSelection::FindOwners(larger ? *larger : *this->Around, *this->Mask, progress);
  for (std::size_t i = 0; i < own; ++i)
  {
    const auto at = static_cast<std::size_t>(points[i]);
    ghosts[i] = !std::binary_search(this->Request.Chunks.begin(), this->Request.Chunks.end(),
      owners[larger ? static_cast<std::size_t>(places[at]) : at]);
  }
}

void PieceDecoder::Internals::Fill(const PieceTarget& target, const Progress& progress)
{
  if (!this->Piece && !this->Coarse)
  {
    throw Error(ErrorCode::InvalidInput, "no piece has been asked for");
  }
  if (!target.Arrays.empty() && target.Arrays.size() != this->Request.Arrays.size())
  {
    throw Error(ErrorCode::InvalidInput, "the target must have room for each array asked for");
  }
  if (this->Coarse)
  {
    this->Coarse->Fill(target, this->Request.Arrays, this->Request.Step, progress);
    return;
  }
  if (!this->Around)
  {
    this->Piece->Fill(
      target, this->Request.Arrays, this->Request.Step, this->Request.RestoreOrder, progress);
    return;
  }

  // Decodes the larger set and copies the piece and its ghosts.
  const auto& pointFrom = this->Cut->GetPoints();
  const auto& cellFrom = this->Cut->GetCells();
  const auto points = static_cast<std::size_t>(this->Around->GetNumberOfPoints());
  const auto cells = static_cast<std::size_t>(this->Around->GetNumberOfCells());
  struct Copy
  {
    const std::vector<std::uint64_t>& From;
    std::size_t Size; // bytes of a tuple
    void* To;
    std::vector<std::uint8_t> Buffer;
  };
  std::vector<Copy> copies;
  copies.reserve(this->Request.Arrays.size() + 4);
  const auto divert = [&](const std::vector<std::uint64_t>& from, std::size_t count,
                        std::size_t size, void* to) -> void*
  {
    if (!to)
    {
      return nullptr;
    }
    copies.push_back({ from, size, to, std::vector<std::uint8_t>(count * size) });
    return copies.back().Buffer.data();
  };
  PieceTarget larger;
  larger.Points =
    divert(pointFrom, points, 3 * SizeOf(this->File->GetCoordinateType()), target.Points);
  larger.GlobalPointIds = static_cast<std::int64_t*>(
    divert(pointFrom, points, sizeof(std::int64_t), target.GlobalPointIds));
  larger.GlobalCellIds =
    static_cast<std::int64_t*>(divert(cellFrom, cells, sizeof(std::int64_t), target.GlobalCellIds));
  for (std::size_t a = 0; a < target.Arrays.size(); ++a)
  {
    const auto& array = this->File->GetArrays()[this->Request.Arrays[a]];
    const bool ofPoints = array.Where == Association::Point;
    larger.Arrays.push_back(divert(ofPoints ? pointFrom : cellFrom, ofPoints ? points : cells,
      array.Components * SizeOf(array.Type), target.Arrays[a]));
  }
  this->Around->Fill(larger, this->Request.Arrays, this->Request.Step, this->IsRestored, progress);
  for (const auto& copy : copies)
  {
    auto* to = static_cast<std::uint8_t*>(copy.To);
    for (const auto from : copy.From)
    {
      std::memcpy(to, copy.Buffer.data() + from * copy.Size, copy.Size);
      to += copy.Size;
    }
  }

  if (target.PointGhosts)
  {
    this->MarkPoints(target.PointGhosts, progress);
  }
  if (target.CellGhosts)
  {
    const auto owned = this->Cut->GetNumberOfOwnCells();
    std::memset(target.CellGhosts, 0, owned);
    std::memset(target.CellGhosts + owned, 1, this->Cut->GetCells().size() - owned);
  }
  if (target.CellParents)
  {
    std::fill_n(target.CellParents, this->Cut->GetCells().size(), PieceTarget::NoParent);
  }
  this->Cut->GetMemory().Store(target);
}

//------------------------------------------------------------------------------
PieceDecoder::PieceDecoder(std::shared_ptr<const FileReader> file)
  : PieceDecoder(std::make_shared<ChunkCache>(std::move(file)))
{
}

PieceDecoder::PieceDecoder(std::shared_ptr<ChunkCache> cache)
  : Self(std::make_unique<Internals>(std::move(cache)))
{
}

PieceDecoder::~PieceDecoder() = default;

void PieceDecoder::Forget()
{
  this->Self->Around.reset();
  this->Self->Piece.reset();
  this->Self->Coarse.reset();
  this->Self->Cut.reset();
}

void PieceDecoder::SetRequest(const PieceRequest& request, const Progress& progress)
{
  this->Self->SetRequest(request, progress);
}

std::uint64_t PieceDecoder::GetNumberOfPoints() const
{
  return this->Self->Coarse ? this->Self->Coarse->GetNumberOfPoints()
    : this->Self->Around    ? this->Self->Cut->GetPoints().size()
    : this->Self->Piece     ? this->Self->Piece->GetNumberOfPoints()
                            : 0;
}

std::uint64_t PieceDecoder::GetNumberOfCells() const
{
  return this->Self->Coarse ? this->Self->Coarse->GetCells().GetCount()
    : this->Self->Around    ? this->Self->Cut->GetCells().size()
    : this->Self->Piece     ? this->Self->Piece->GetNumberOfCells()
                            : 0;
}

bool PieceDecoder::IsTetrahedral() const
{
  return this->Self->Coarse
    ? this->Self->Coarse->GetCells().IsTetrahedral()
    : !this->Self->Piece || this->Self->Piece->GetSet().GetForm() == PieceForm::Tetrahedra;
}

std::uint64_t PieceDecoder::GetConnectivitySize() const
{
  return this->Self->Coarse ? this->Self->Coarse->GetCells().GetAllCorners().size()
    : this->IsTetrahedral() ? 4 * this->GetNumberOfCells()
    : this->Self->Around    ? this->Self->Cut->GetMemory().GetConnectivitySize()
                            : this->Self->Piece->GetSet().GetConnectivitySize();
}

std::uint64_t PieceDecoder::GetFacesSize() const
{
  return this->IsTetrahedral() || this->Self->Coarse ? 0
    : this->Self->Around                             ? this->Self->Cut->GetMemory().GetFacesSize()
                                                     : this->Self->Piece->GetSet().GetFacesSize();
}

void PieceDecoder::Fill(const PieceTarget& target, const Progress& progress)
{
  this->Self->Fill(target, progress);
}

const std::shared_ptr<const FileReader>& PieceDecoder::GetFile() const
{
  return this->Self->File;
}
}
