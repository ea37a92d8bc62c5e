// SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gatunPieceRaySource.h"

#include "gatunError.h"
#include "gatunRayCaster.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>

namespace gatun
{
namespace
{
/** How far the middle of a box is from the eye, in any unit. */
double GetDepth(const RayView& view, const Bounds& box)
{
  const auto middle = [&](std::size_t axis) { return (box[axis].Min + box[axis].Max) / 2; };
  return view.Transform({ middle(0), middle(1), middle(2) })[2];
}

void GoOn(const RaySource::Progress& progress, double fraction)
{
  if (progress && !progress(fraction))
  {
    throw Error(ErrorCode::Aborted, "aborted");
  }
}
}

//------------------------------------------------------------------------------
RayProducer GetProducer(vtkAlgorithm* consumer)
{
  RayProducer producer;
  if (consumer->GetNumberOfInputConnections(0) > 0)
  {
    producer.Algorithm = consumer->GetInputAlgorithm(0, 0, producer.Port);
  }
  return producer;
}

//------------------------------------------------------------------------------
double GetRequestedTime(const RayProducer& producer)
{
  const auto key = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
  vtkInformation* const info = producer.Algorithm->GetOutputInformation(producer.Port);
  return info->Has(key) ? info->Get(key) : 0;
}

//------------------------------------------------------------------------------
void PullPiece(const RayProducer& producer, int piece, int pieces)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkNew<vtkInformationVector> requests;
  requests->SetNumberOfInformationObjects(producer.Port + 1);
  vtkInformation* const request = requests->GetInformationObject(producer.Port);
  request->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
  request->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  request->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  if (!producer.Algorithm->Update(producer.Port, requests))
  {
    throw Error(ErrorCode::InvalidInput, "the input could not be made");
  }
}

//------------------------------------------------------------------------------
PieceRaySource::PieceRaySource(const RayProducer& producer, const PieceShare& share,
  const RayArray& array, std::uint64_t budget, const Progress& progress)
  : Owner(producer.Algorithm)
  , Producer(producer)
  , Share(share)
  , Array(array)
  , Cache(budget)
  , IsFull(budget == 0)
  , Pieces(static_cast<std::size_t>(share.Pieces))
{
  for (std::size_t piece = 0; piece < this->Pieces.size(); ++piece)
  {
    GoOn(progress, static_cast<double>(piece) / share.Pieces);
    this->Select(piece);
    this->Measure();
    this->KeepBlocks();
  }
  this->Select(0);
}

PieceRaySource::~PieceRaySource() = default;

//------------------------------------------------------------------------------
void PieceRaySource::Select(std::size_t piece)
{
  this->Grid.reset();
  this->Selected = piece;
}

//------------------------------------------------------------------------------
void PieceRaySource::Pull()
{
  const PieceShare& share = this->Share;
  PullPiece(this->Producer, share.Process * share.Pieces + static_cast<int>(this->Selected),
    share.Processes * share.Pieces);
  auto* const output = vtkUnstructuredGrid::SafeDownCast(
    this->Producer.Algorithm->GetOutputDataObject(this->Producer.Port));
  if (!output)
  {
    throw Error(ErrorCode::InvalidInput, "the input is not a vtkUnstructuredGrid");
  }
  if (output->GetNumberOfCells() > 0) // an empty piece need not have any arrays
  {
    // The output is for all consumers: while this piece is drawn, another may be made for one.
    vtkNew<vtkUnstructuredGrid> grid;
    grid->ShallowCopy(output);
    this->Grid = std::make_unique<GridRaySource>(grid, this->Array, 0);
  }
}

//------------------------------------------------------------------------------
void PieceRaySource::Measure()
{
  this->Pull();
  Piece& piece = this->Pieces[this->Selected];
  if (this->Selected > 0)
  {
    const Piece& before = this->Pieces[this->Selected - 1];
    piece.FirstBlock = before.FirstBlock + before.Boxes.size();
  }
  for (std::size_t block = 0; this->Grid && block < this->Grid->GetNumberOfBlocks(); ++block)
  {
    piece.Boxes.push_back(this->Grid->GetBounds(block));
    piece.Ranges.push_back(this->Grid->GetRange(block));
    piece.Box.Include(piece.Boxes.back());
    this->Values.Include(piece.Ranges.back());
  }
  this->Box.Include(piece.Box);
}

//------------------------------------------------------------------------------
void PieceRaySource::KeepBlocks()
{
  // Once the cache is full, another block would only drive out one that is as likely to be seen.
  if (!this->Grid || this->IsFull)
  {
    return;
  }
  std::vector<std::size_t> all(this->GetNumberOfBlocks());
  std::iota(all.begin(), all.end(), std::size_t{ 0 });
  const auto before = this->Cache.GetStatistics().Entries;
  this->GetBlocks(all, {});
  this->IsFull = this->Cache.GetStatistics().Entries < before + all.size();
}

//------------------------------------------------------------------------------
void PieceRaySource::Draw(RayCaster& caster, const RayView& view, const Progress& progress)
{
  std::vector<std::size_t> order(this->Pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return GetDepth(view, this->Pieces[a].Box) < GetDepth(view, this->Pieces[b].Box); });
  const auto pieces = static_cast<double>(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const auto before = static_cast<double>(i);
    // Only if one of its blocks is seen and is not kept, it is pulled.
    this->Select(order[i]);
    caster.Draw(
      *this, [&](double fraction) { return !progress || progress((before + fraction) / pieces); });
  }
  this->Select(0);
}

//------------------------------------------------------------------------------
std::size_t PieceRaySource::GetNumberOfBlocks() const
{
  return this->Pieces[this->Selected].Boxes.size();
}

//------------------------------------------------------------------------------
const Bounds& PieceRaySource::GetBounds(std::size_t block) const
{
  return this->Pieces[this->Selected].Boxes[block];
}

//------------------------------------------------------------------------------
Range PieceRaySource::GetRange(std::size_t block) const
{
  return this->Pieces[this->Selected].Ranges[block];
}

//------------------------------------------------------------------------------
RaySource::Blocks PieceRaySource::GetBlocks(
  std::span<const std::size_t> blocks, const Progress& progress)
{
  const auto first = this->Pieces[this->Selected].FirstBlock;
  Blocks result(blocks.size());
  std::vector<std::size_t> places;
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    result[i] = this->Cache.Find(first + blocks[i]);
    if (!result[i])
    {
      places.push_back(i);
      missing.push_back(blocks[i]);
    }
  }
  if (missing.empty())
  {
    return result;
  }
  if (!this->Grid)
  {
    this->Pull();
  }
  if (!this->Grid || this->Grid->GetNumberOfBlocks() != this->GetNumberOfBlocks())
  {
    throw Error(ErrorCode::InvalidInput, "the input's pieces are not the same as before");
  }
  const Blocks made = this->Grid->GetBlocks(missing, progress);
  for (std::size_t i = 0; i < made.size(); ++i)
  {
    result[places[i]] = made[i];
    this->Cache.Add(first + missing[i], made[i]);
  }
  return result;
}
}
